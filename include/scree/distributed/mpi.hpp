// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#if __has_include(<mpi.h>)  // programs that use this header need the headers and the library of MPI

#include "../core/writes_files.hpp"
#include "../fields/memory.hpp"
#include "team.hpp"

// MPI's C++ classes are not used.
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#endif
#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace scree {

/// The way in which MPI gets messages from device memory: `staged` through pinned host memory, or `direct`, which needs
/// a GPU-aware MPI.
enum class DeviceMessages { staged, direct };

/// A Transport between processes that uses MPI 3. Each rank of a communicator is a rank of the case. The caller owns
/// the communicator.
class Mpi {
 public:
  /// Uses the ranks of a communicator. Throws std::logic_error unless MPI has been initialised.
  explicit Mpi(MPI_Comm communicator = MPI_COMM_WORLD, DeviceMessages of_device = DeviceMessages::staged)
      : communicator_(communicator), of_device_(of_device) {
    int initialised = 0;
    MPI_Initialized(&initialised);
    if (initialised == 0) throw std::logic_error("scree: MPI_Init must be called before Mpi is made");
    MPI_Comm_rank(communicator, &rank_);
    MPI_Comm_size(communicator, &ranks_);
  }

  int rank() const { return rank_; }
  int ranks() const { return ranks_; }
  /// Returns a description for output, for example "processes of Open MPI v4.1.4".
  template <class Space>
  std::string name(Space const&) const {
    char version[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    MPI_Get_library_version(version, &length);
    std::string const text(version, std::size_t(length));
    return "processes of " + text.substr(0, text.find_first_of(",\n")) +
           (on_host<Space> ? ""
            : is_direct()  ? ", messages from GPU memory"
                           : ", messages through memory of the host");
  }

  /// Returns the communicator of the ranks of the case.
  MPI_Comm communicator() const { return communicator_; }
  /// Bytes to send to another rank, or room for bytes from it.
  struct Words {
    void* bytes = nullptr;  ///< the first byte
    std::size_t size = 0;   ///< the number of bytes
  };
  /// Sends words(rank) to each other rank and receives its bytes into room_for(rank); empty messages are skipped.
  template <class WordsFor, class RoomFor>
  void trade(WordsFor const& words, RoomFor const& room_for) {
    requests_.clear();
    for_each_chunk(room_for, [&](int q, std::byte* bytes, int count) {
      check(MPI_Irecv(bytes, count, MPI_BYTE, q, 0, communicator_, &requests_.emplace_back()));
    });
    for_each_chunk(words, [&](int q, std::byte* bytes, int count) {
      check(MPI_Isend(bytes, count, MPI_BYTE, q, 0, communicator_, &requests_.emplace_back()));
    });
    statuses_.resize(requests_.size());
    check(MPI_Waitall(int(requests_.size()), requests_.data(), statuses_.data()));
  }

  void gather(void const* mine, std::size_t bytes, void* all) {
    for (std::size_t first = 0; first < bytes; first += most) {
      std::size_t const count = std::min(most, bytes - first);
      chunks_.resize(count * std::size_t(ranks_));
      check(MPI_Allgather(static_cast<std::byte const*>(mine) + first, int(count), MPI_BYTE, chunks_.data(), int(count),
                          MPI_BYTE, communicator_));
      for (std::size_t q = 0; q < std::size_t(ranks_); ++q)
        std::memcpy(static_cast<std::byte*>(all) + q * bytes + first, chunks_.data() + q * count, count);
    }
  }
  template <class Space>
  void exchange(Space const& space, Messages const& sent, Messages const& received) {
    using InMemory = typename Space::memory_space;
    space.fence("scree::exchange");
    if (on_host<Space> || is_direct()) {
      exchange_in<InMemory>(space, sent, received);
    } else {
      Messages const out = staged(to_send_, sent), in = staged(received_, received);
      copy_bytes<Kokkos::SharedHostPinnedSpace, InMemory>(space, out.bytes, sent.bytes,
                                                          std::size_t(sent.starts.back()));
      exchange_in<Kokkos::SharedHostPinnedSpace>(space, out, in);
      copy_bytes<InMemory, Kokkos::SharedHostPinnedSpace>(space, received.bytes, in.bytes,
                                                          std::size_t(received.starts.back()));
    }
  }
  /// Prints a message to stderr and ends all processes.
  void fail(std::string const& message) {
    std::fprintf(stderr, "scree: rank %d failed: %s\n", rank_, message.c_str());
    std::fflush(stderr);
    MPI_Abort(communicator_, 1);
  }

 private:
  using Pinned = Memory<Kokkos::SharedHostPinnedSpace>;
  static constexpr std::size_t most = std::size_t(1) << 30;  // bytes in one call; MPI 3 uses an int for them

  static void check(int result) {
    if (result != MPI_SUCCESS) throw std::runtime_error("scree: MPI failed with error " + std::to_string(result));
  }
  static Messages staged(Pinned& memory, Messages const& on_device) {
    auto const size = static_cast<std::size_t>(on_device.starts.back());
    if (memory.size() < size) memory = {}, memory = Pinned("scree::messages", size + size / 8);
    return {memory.data(), on_device.starts};
  }
  bool is_direct() const { return of_device_ == DeviceMessages::direct; }
  template <class InMemory, class Space>
  void exchange_in(Space const& space, Messages const& sent, Messages const& received) {
    if (sent.size_for(rank_) != received.size_for(rank_))
      throw std::logic_error("scree: a rank sends itself a message of another size than it expects");
    copy_bytes<InMemory, InMemory>(space, received.begin_for(rank_), sent.begin_for(rank_),
                                   std::size_t(sent.size_for(rank_)));
    auto const words_of = [](Messages const& messages) {
      return [&messages](int q) { return Words{messages.begin_for(q), std::size_t(messages.size_for(q))}; };
    };
    trade(words_of(sent), words_of(received));
  }
  /// Calls visit(rank, bytes, count) for the bytes of all other ranks, in chunks that fit in one MPI call.
  template <class WordsOf, class Visit>
  void for_each_chunk(WordsOf const& words_of, Visit const& visit) const {
    for (int q = 0; q < ranks_; ++q) {
      if (q == rank_) continue;
      Words const all = words_of(q);
      for (std::size_t first = 0; first < all.size; first += most)
        visit(q, static_cast<std::byte*>(all.bytes) + first, static_cast<int>(std::min(most, all.size - first)));
    }
  }

  MPI_Comm communicator_;
  DeviceMessages of_device_;
  int rank_ = 0, ranks_ = 1;
  std::vector<std::byte> chunks_;
  std::vector<MPI_Request> requests_;
  std::vector<MPI_Status> statuses_;
  Pinned to_send_, received_;
};

/// MPI for the lifetime of a program in which only rank 0 writes files (core/writes_files.hpp). Construct this object
/// in main() before initialising Kokkos.
class MpiProgram {
 public:
  /// Calls MPI_Init with the arguments of main().
  MpiProgram(int& argc, char**& argv) : files_(is_first(argc, argv)) {}
  MpiProgram(MpiProgram const&) = delete;
  MpiProgram& operator=(MpiProgram const&) = delete;
  ~MpiProgram() { MPI_Finalize(); }
  /// Aborts all ranks if there are several and the exit code reports a failure, 1 to 127; otherwise returns the exit
  /// code.
  int end(int exit_code) const {
    if (exit_code > 0 && exit_code < 128 && ranks() > 1) MPI_Abort(MPI_COMM_WORLD, exit_code);
    return exit_code;
  }
  /// Returns the number of ranks, or 1 if MPI has not been initialised.
  static int ranks() {
    int initialised = 0;
    MPI_Initialized(&initialised);
    return initialised == 0 ? 1 : Mpi().ranks();
  }

 private:
  static bool is_first(int& argc, char**& argv) {
    MPI_Init(&argc, &argv);
    return Mpi().rank() == 0;
  }
  detail::LetWriteFiles files_;
};

}  // namespace scree

#endif
