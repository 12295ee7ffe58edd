// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/turning_axes.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

std::optional<std::string> word_in(std::string_view text) {
  static constexpr auto turning = std::to_array<std::string_view>(
      {"rotate", "rotates", "rotating", "co-rotating", "corotating", "turn", "turns", "turning", "spin",
       "spins", "spinning", "moving", "co-moving", "comoving", "body-fixed", "body", "carried"});
  static constexpr std::array<std::string_view, 8> axes{"axes",    "frame", "frames", "basis",
                                                        "vectors", "triad", "tripod", "trihedron"};
  const std::vector<std::string_view> words = words_of(text);
  const auto has = [&](const auto& list) {
    return std::ranges::find_if(words, [&](std::string_view word) { return is_one_of(word, list); });
  };
  const auto found = has(turning);
  return found != words.end() && has(axes) != words.end() ? std::optional<std::string>(*found) : std::nullopt;
}

}  // namespace

std::optional<std::string> word_of_turning_axes(const Prose& prose, std::size_t event,
                                                const std::string& heading) {
  if (auto word = word_in(lowered(heading))) return word;
  for (const ProseSentence& each : prose.sentences) {
    if (!prose.sections.reaches(each.place, prose.beside[event].place)) continue;
    if (auto word = word_in(each.text)) return word;
  }
  return std::nullopt;
}

}  // namespace rigor
