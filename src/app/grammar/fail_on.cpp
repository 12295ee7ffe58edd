// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/fail_on.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "source/suggest.h"

namespace rigor {
namespace {

struct FailOnWord {
  std::string_view name;
  std::vector<Severity> severities;
};

const std::vector<FailOnWord>& fail_on_words() {
  static const std::vector<FailOnWord> words{{"refuted", {Severity::refuted}},
                                             {"suspect", {Severity::suspect}},
                                             {"undecided", {Severity::undecided}},
                                             {"not-understood", {Severity::not_understood}},
                                             {"error", {Severity::error}},
                                             {"warning", {Severity::warning}},
                                             {"open", {Severity::undecided, Severity::not_understood}}};
  return words;
}

}  // namespace

Result<std::set<Severity>> read_fail_on(std::string_view list) {
  std::set<Severity> severities;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string_view word = without_blanks_around(list.substr(begin, end - begin));
    begin = end + 1;
    const auto found = std::ranges::find(fail_on_words(), word, &FailOnWord::name);
    if (found != fail_on_words().end()) {
      severities.insert(found->severities.begin(), found->severities.end());
      continue;
    }
    std::vector<std::string> names;
    for (const FailOnWord& known : fail_on_words()) names.emplace_back(known.name);
    const auto near = suggest(word, names);
    return refuse(near ? fmt::format("`{}` is not known; did you mean `{}`?", word, *near)
                       : fmt::format("`{}` is not known; known: {}", word, fmt::join(names, ", ")));
  }
  return severities;
}

}  // namespace rigor
