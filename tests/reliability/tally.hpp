// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <catch2/catch_message.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace scree::test {

// Not within the class: nvcc 13 does not come to an end where a class that checks stands before Kokkos's headers.
inline void check_attempt(std::string const& measure, std::string const& fault) {
  INFO(measure << ": " << fault);
  CHECK(fault.empty());
}

/// Counts attempts; at its end it prints "R9: 118 of 120, note", which reliability.py reads, and fails if some did not
/// survive.
class Tally {
 public:
  explicit Tally(std::string measure) : measure_(std::move(measure)) {}
  Tally(Tally const&) = delete;
  Tally& operator=(Tally const&) = delete;
  ~Tally() { std::printf("%s: %d of %d, %s\n", measure_.c_str(), survived_, tried_, note_.c_str()); }

  /// `fault` describes the failure; empty: none.
  void count(std::string const& fault) {
    ++tried_;
    survived_ += fault.empty();
    check_attempt(measure_, fault);
  }
  void note(std::string note) { note_ = std::move(note); }

 private:
  std::string measure_, note_;
  int tried_ = 0, survived_ = 0;
};

/// Number of attempts: `more` if the environment has SCREE_RELIABILITY=long.
inline int attempts(int few, int more) {
  char const* const wanted = std::getenv("SCREE_RELIABILITY");
  return wanted != nullptr && std::string(wanted) == "long" ? more : few;
}

/// The random numbers of a measure: those of the environment's SCREE_RELIABILITY_SEED, 1 where there is none.
inline std::mt19937 random_of(unsigned measure) {
  char const* const seed = std::getenv("SCREE_RELIABILITY_SEED");
  std::seed_seq words{seed != nullptr ? static_cast<unsigned>(std::strtoul(seed, nullptr, 10)) : 1u, measure};
  return std::mt19937(words);
}
/// A number from 0 to end - 1, the same for equal seeds.
inline int random_below(std::mt19937& generator, int end) {
  return static_cast<int>(generator() % static_cast<unsigned>(end));
}
inline double random_between(std::mt19937& generator, double low, double high) {
  return low + (high - low) * double(generator()) / 4294967296.0;
}

}  // namespace scree::test
