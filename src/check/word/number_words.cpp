// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/number_words.h"

#include <algorithm>
#include <array>

#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// The beginnings of words.
constexpr std::array<std::string_view, 35> stems_on_numbers{
    "approx",  "rough",   "about",     "nearly",  "almost", "around",    "estimat",   "guess",   "round",
    "truncat", "negl",    "ignor",     "omit",    "drop",   "magnitude", "quadratur", "decibel", "logarithm",
    "modulo",  "modular", "remainder", "integer", "binar",  "hexadec",   "octal",     "bits",    "byte",
    "base",    "boolean", "logic",     "xor",     "clock",  "hand",      "parallel",  "galois"};

}  // namespace

std::optional<std::string> word_on_numbers(std::string_view text) {
  for (const std::string_view word : words_of(text)) {
    const auto begins = [&](std::string_view beginning) { return word.starts_with(beginning); };
    if (std::ranges::any_of(stems_on_numbers, begins)) return std::string(word);
  }
  return std::nullopt;
}

}  // namespace rigor
