// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/said_around.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "check/prose/restrictions.h"

namespace rigor {
namespace {

bool is_greek(std::string_view name) {
  static constexpr std::array<std::string_view, 40> names{
      "alpha",   "beta",     "gamma", "delta", "epsilon", "varepsilon", "zeta",     "eta",
      "theta",   "vartheta", "iota",  "kappa", "lambda",  "mu",         "nu",       "xi",
      "rho",     "varrho",   "sigma", "tau",   "upsilon", "phi",        "varphi",   "chi",
      "psi",     "omega",    "Gamma", "Delta", "Theta",   "Lambda",     "Xi",       "Sigma",
      "Upsilon", "Phi",      "Psi",   "Omega", "ell",     "hbar",       "varsigma", "varpi"};
  return is_one_of(name, names);
}

/// The letters that are written there, without their faces and accents.
std::set<std::string> letters_written(std::string_view text) {
  std::set<std::string> letters;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\') {
      std::size_t end = at + 1;
      while (end < text.size() && is_letter(text[end])) ++end;
      const std::string_view name = text.substr(at + 1, end - at - 1);
      if (is_greek(name)) letters.emplace(name);
      at = std::max(end, at + 2) - 1;
    } else if (is_letter(text[at])) {
      letters.emplace(text.substr(at, 1));
    }
  }
  return letters;
}

bool speaks_of_all_notes(std::string_view sentence) {
  static constexpr auto ways =
      std::to_array<std::string_view>({"in these notes", "in this course", "in these lectures",
                                       "in this lecture", "in this chapter", "throughout"});
  const std::string text = lowered(sentence);
  return std::ranges::any_of(ways, [&](std::string_view way) { return text.find(way) != std::string::npos; });
}

}  // namespace

std::optional<SaidAround> said_around(const Prose& prose, std::size_t event, const SourceMap& sources,
                                      Span row, const std::string& tag) {
  if (auto word = restriction_in_sentence(lowered(tag))) return SaidAround{*std::move(word), "its tag"};
  const ProseBeside& beside = prose.beside[event];
  const std::set<std::string> letters = letters_written(sources.text(row));
  const auto shares = [&](const ProseSentence& sentence) {
    return std::ranges::any_of(sentence.maths, [&](Span maths) {
      return std::ranges::any_of(letters_written(sources.text(maths)),
                                 [&](const auto& each) { return letters.contains(each); });
    });
  };
  std::optional<SaidAround> of_notes;
  bool next = true;  // the first sentence after it
  for (const ProseSentence& sentence : prose.sentences) {
    if (!prose.sections.reaches(sentence.place, beside.place) || sentence.number == beside.sentence) continue;
    const bool has_letters = !sentence.maths.empty();
    if (sentence.number < beside.sentence) {
      if (auto word = restriction_above(sentence.text, has_letters, has_letters && shares(sentence))) {
        SaidAround said{*std::move(word), "a sentence above it", speaks_of_all_notes(sentence.text)};
        if (!said.of_notes) return said;
        of_notes = std::move(said);
      }
      if (sentence.asks && !sentence.has_display && sentence.displays + 1 == beside.displays &&
          sentence.number + 1 == beside.sentence)
        return SaidAround{"?", "the sentence above it"};
      continue;
    }
    const bool here = sentence.paragraph == beside.paragraph || next;
    if (!here || sentence.displays != beside.displays || sentence.has_display) break;
    next = false;
    if (auto word = restriction_behind(sentence.text, has_letters, has_letters && shares(sentence)))
      return SaidAround{*std::move(word), "a sentence behind it"};
  }
  return of_notes;
}

}  // namespace rigor
