// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace scree::detail {

/// Returns the lookup tables of the checksum: table k advances it over a byte that is followed by k more bytes.
constexpr std::array<std::array<std::uint64_t, 256>, 8> crc64_tables() {
  constexpr std::uint64_t polynomial = 0xC96C5795D7870F42;  // ECMA-182, reflected
  std::array<std::array<std::uint64_t, 256>, 8> tables{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    std::uint64_t value = byte;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) * polynomial);
    tables[0][byte] = value;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte)
      tables[k][byte] = (tables[k - 1][byte] >> 8) ^ tables[0][tables[k - 1][byte] & 255];
  return tables;
}

/// The CRC-64/XZ checksum of bytes that are added in pieces. It detects every burst error of up to 64 bits.
class Checksum {
 public:
  void add(std::span<std::byte const> bytes) {
    // Eight bytes at a time, because a checkpoint can be gigabytes large.
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
      for (unsigned k = 0; k < 8; ++k) state_ ^= std::uint64_t(bytes[k]) << (8 * k);
      std::uint64_t next = 0;
      for (unsigned k = 0; k < 8; ++k) next ^= tables[7 - k][(state_ >> (8 * k)) & 255];
      state_ = next;
    }
    for (std::byte const byte : bytes) state_ = (state_ >> 8) ^ tables[0][(state_ ^ std::uint64_t(byte)) & 255];
  }
  std::uint64_t value() const { return ~state_; }

 private:
  static constexpr auto tables = crc64_tables();
  std::uint64_t state_ = ~std::uint64_t{0};
};

}  // namespace scree::detail
