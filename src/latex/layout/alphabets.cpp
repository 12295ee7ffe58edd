// SPDX-License-Identifier: GPL-3.0-or-later
// Unicode's mathematical alphabets.
#include <array>
#include <optional>

#include "base/utf8.h"
#include "latex/layout/mathml.h"

namespace rigor {
namespace {

struct Alphabet {
  char32_t capitals = 0;
  char32_t small = 0;
  char32_t digits = 0;
  char32_t greek_capitals = 0;
  char32_t greek_small = 0;
};

Alphabet alphabet_of(Typeface face) {
  static constexpr std::array<Alphabet, 9> alphabets{{// in the order of Typeface
                                                      {},
                                                      {},
                                                      {0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2},
                                                      {0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736},
                                                      {0x1D5A0, 0x1D5BA, 0x1D7E2},
                                                      {0x1D49C, 0x1D4B6},
                                                      {0x1D504, 0x1D51E},
                                                      {0x1D538, 0x1D552, 0x1D7D8},
                                                      {0x1D670, 0x1D68A, 0x1D7F6}}};
  return alphabets.at(static_cast<std::size_t>(face));
}

/// Letters that Unicode had before it got the alphabets: their places there are empty.
std::optional<char32_t> earlier_letter(char32_t letter, Typeface face) {
  struct Earlier {
    char32_t letter, script, fraktur, blackboard;
  };
  static constexpr auto table = std::to_array<Earlier>({{'B', 0x212C, 0, 0},
                                                        {'C', 0, 0x212D, 0x2102},
                                                        {'E', 0x2130, 0, 0},
                                                        {'F', 0x2131, 0, 0},
                                                        {'H', 0x210B, 0x210C, 0x210D},
                                                        {'I', 0x2110, 0x2111, 0},
                                                        {'L', 0x2112, 0, 0},
                                                        {'M', 0x2133, 0, 0},
                                                        {'N', 0, 0, 0x2115},
                                                        {'P', 0, 0, 0x2119},
                                                        {'Q', 0, 0, 0x211A},
                                                        {'R', 0x211B, 0x211C, 0x211D},
                                                        {'Z', 0, 0x2128, 0x2124},
                                                        {'e', 0x212F, 0, 0},
                                                        {'g', 0x210A, 0, 0},
                                                        {'o', 0x2134, 0, 0}});
  for (const Earlier& each : table) {
    if (each.letter != letter) continue;
    const char32_t found = face == Typeface::script       ? each.script
                           : face == Typeface::fraktur    ? each.fraktur
                           : face == Typeface::blackboard ? each.blackboard
                                                          : 0;
    if (found != 0) return found;
  }
  return std::nullopt;
}

/// ϵ, ϑ, ϰ, ϕ, ϱ, ϖ are after ω in the alphabets, ∂ before them.
char32_t greek_letter(char32_t letter, char32_t small) {
  if (letter >= U'α' && letter <= U'ω') return small + (letter - U'α');
  static constexpr std::array<char32_t, 7> behind{U'∂', U'ϵ', U'ϑ', U'ϰ', U'ϕ', U'ϱ', U'ϖ'};
  for (std::size_t k = 0; k < behind.size(); ++k) {
    if (behind[k] == letter) return small + 25 + static_cast<char32_t>(k);
  }
  return letter;
}

char32_t letter_in(char32_t letter, Typeface face) {
  if (const auto earlier = earlier_letter(letter, face)) return *earlier;
  const Alphabet alphabet = alphabet_of(face);
  const auto shifted = [&](char32_t first, char32_t start) {
    return start == 0 ? letter : start + (letter - first);
  };
  if (letter >= U'A' && letter <= U'Z') return shifted(U'A', alphabet.capitals);
  if (letter >= U'a' && letter <= U'z') return shifted(U'a', alphabet.small);
  if (letter >= U'0' && letter <= U'9') return shifted(U'0', alphabet.digits);
  if (letter >= U'Α' && letter <= U'Ω' && alphabet.greek_capitals != 0)
    return alphabet.greek_capitals + (letter - U'Α');
  if (letter == U'∇' && alphabet.greek_capitals != 0) return alphabet.greek_capitals + 25;
  return alphabet.greek_small == 0 ? letter : greek_letter(letter, alphabet.greek_small);
}

void append_utf8(std::string& to, char32_t c) {
  const auto byte = [&](char32_t value) { to += static_cast<char>(static_cast<unsigned char>(value)); };
  if (c < 0x80) return byte(c);
  if (c < 0x800) {
    byte(0xC0 | (c >> 6));
  } else if (c < 0x10000) {
    byte(0xE0 | (c >> 12));
    byte(0x80 | ((c >> 6) & 0x3F));
  } else {
    byte(0xF0 | (c >> 18));
    byte(0x80 | ((c >> 12) & 0x3F));
    byte(0x80 | ((c >> 6) & 0x3F));
  }
  byte(0x80 | (c & 0x3F));
}

}  // namespace

std::string in_typeface(std::string_view text, Typeface face) {
  if (face == Typeface::italic || face == Typeface::upright) return std::string(text);
  std::string result;
  for (std::size_t at = 0; at < text.size();) append_utf8(result, letter_in(next_code_point(text, at), face));
  return result;
}

}  // namespace rigor
