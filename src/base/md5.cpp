// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/md5.h"

#include <array>
#include <bit>
#include <cstdint>

namespace rigor {
namespace {

constexpr std::size_t block_size = 64;
constexpr std::size_t length_size = 8;

using State = std::array<std::uint32_t, 4>;

constexpr State initial{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};

/// T of RFC 1321, 3.4: ⌊2³² |sin(i + 1)|⌋.
constexpr std::array<std::uint32_t, block_size> sines{
    0xd76aa478, 0xe8c7b756, 0x242070db, 0xc1bdceee, 0xf57c0faf, 0x4787c62a, 0xa8304613, 0xfd469501,
    0x698098d8, 0x8b44f7af, 0xffff5bb1, 0x895cd7be, 0x6b901122, 0xfd987193, 0xa679438e, 0x49b40821,
    0xf61e2562, 0xc040b340, 0x265e5a51, 0xe9b6c7aa, 0xd62f105d, 0x02441453, 0xd8a1e681, 0xe7d3fbc8,
    0x21e1cde6, 0xc33707d6, 0xf4d50d87, 0x455a14ed, 0xa9e3e905, 0xfcefa3f8, 0x676f02d9, 0x8d2a4c8a,
    0xfffa3942, 0x8771f681, 0x6d9d6122, 0xfde5380c, 0xa4beea44, 0x4bdecfa9, 0xf6bb4b60, 0xbebfbc70,
    0x289b7ec6, 0xeaa127fa, 0xd4ef3085, 0x04881d05, 0xd9d4d039, 0xe6db99e5, 0x1fa27cf8, 0xc4ac5665,
    0xf4292244, 0x432aff97, 0xab9423a7, 0xfc93a039, 0x655b59c3, 0x8f0ccc92, 0xffeff47d, 0x85845dd1,
    0x6fa87e4f, 0xfe2ce6e0, 0xa3014314, 0x4e0811a1, 0xf7537e82, 0xbd3af235, 0x2ad7d2bb, 0xeb86d391};

/// By round and by step within four.
constexpr std::array<std::array<int, 4>, 4> rotations{
    {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}}};

std::uint32_t word_at(std::string_view block, std::size_t word) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(block[4 * word + k])) << (8 * k);
  return value;
}

/// The mixing function of a round, and which word of the block a step takes.
struct Mixed {
  std::uint32_t value;
  std::size_t word;
};

Mixed mix(std::size_t step, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  switch (step / 16) {
    case 0:
      return {(b & c) | (~b & d), step};
    case 1:
      return {(d & b) | (~d & c), (5 * step + 1) % 16};
    case 2:
      return {b ^ c ^ d, (3 * step + 5) % 16};
    default:
      return {c ^ (b | ~d), (7 * step) % 16};
  }
}

void add_block(State& state, std::string_view block) {
  auto [a, b, c, d] = state;
  for (std::size_t step = 0; step < block_size; ++step) {
    const Mixed mixed = mix(step, b, c, d);
    const std::uint32_t sum = a + mixed.value + sines[step] + word_at(block, mixed.word);
    a = d;
    d = c;
    c = b;
    b += std::rotl(sum, rotations[step / 16][step % 4]);
  }
  state = {state[0] + a, state[1] + b, state[2] + c, state[3] + d};
}

/// What is after the last whole block, a one, zeros, and the length in bits.
std::string last_blocks(std::string_view bytes) {
  std::string rest(bytes.substr(bytes.size() / block_size * block_size));
  rest += '\x80';
  while (rest.size() % block_size != block_size - length_size) rest += '\0';
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (std::size_t k = 0; k < length_size; ++k) rest += static_cast<char>((bits >> (8 * k)) & 0xFFU);
  return rest;
}

}  // namespace

std::string md5(std::string_view bytes) {
  State state = initial;
  const std::string rest = last_blocks(bytes);
  for (std::size_t at = 0; at + block_size <= bytes.size(); at += block_size)
    add_block(state, bytes.substr(at, block_size));
  for (std::size_t at = 0; at < rest.size(); at += block_size)
    add_block(state, std::string_view(rest).substr(at, block_size));
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint32_t word : state) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t byte = (word >> (8 * k)) & 0xFFU;
      text += digits[byte >> 4];
      text += digits[byte & 0xFU];
    }
  }
  return text;
}

}  // namespace rigor
