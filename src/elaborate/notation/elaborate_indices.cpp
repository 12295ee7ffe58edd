// SPDX-License-Identifier: GPL-3.0-or-later
// The summation convention: which letters of a product are summed, which are free.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/elaborator.h"

namespace rigor {

/// The summation convention: a letter twice in a product is summed, once is free, more often is a mistake.
bool Elaborator::sum_repeated(const std::vector<Typed>& factors, std::vector<FreeIndex>& to_sum,
                              std::vector<FreeIndex>& free, std::vector<FreeIndex>& bound) {
  std::map<std::string, std::vector<FreeIndex>> places;
  std::vector<std::string> order;
  for (const Typed& factor : factors) {
    for (const FreeIndex& entry : factor.free) {
      if (places[entry.letter].empty()) order.push_back(entry.letter);
      places[entry.letter].push_back(entry);
    }
    for (const FreeIndex& entry : factor.bound) bound.push_back(entry);
  }
  for (const std::string& letter : order) {
    const std::vector<FreeIndex>& where = places[letter];
    if (reading_.no_sum || reading_.unsummed.contains(letter)) {
      free.push_back(where[0]);
      continue;
    }
    const auto riding = static_cast<std::size_t>(
        std::count_if(where.begin(), where.end(), [](const FreeIndex& entry) { return entry.rides; }));
    if (riding > 0 && where.size() - riding >= 1 && where.size() - riding <= 2) {
      note_riding(letter, where, riding);
      const auto own =
          std::find_if(where.begin(), where.end(), [](const FreeIndex& entry) { return !entry.rides; });
      (where.size() - riding == 2 ? to_sum : free).push_back(*own);
      continue;
    }
    if (where.size() > 2) {
      const bool sure = letters_.is_sure(letter);
      Diagnostic diagnostic{sure ? DiagnosticKind::index_repeats : DiagnosticKind::ambiguous_reading,
                            where[2].span,
                            fmt::format("index `{}` occurs {} times in one term", letter, where.size())};
      diagnostic.labels = {{where[0].span, ""}, {where[1].span, ""}};
      if (!sure) diagnostic.message += "; it can be a label";
      diagnostic.help = {
          "the summation convention allows a letter at most twice in a term; rename a pair, or write the sum "
          "out"};
      diagnostics_.push_back(std::move(diagnostic));
      return false;
    }
    const auto clash = std::find_if(bound.begin(), bound.end(),
                                    [&](const FreeIndex& entry) { return entry.letter == letter; });
    if (clash != bound.end()) {
      diagnostics_.push_back(
          {letters_.is_sure(letter) ? DiagnosticKind::index_clash : DiagnosticKind::ambiguous_reading,
           where[0].span,
           fmt::format("index `{}` is summed inside a factor of the same term", letter),
           {{clash->span, "summed here"}},
           {"rename one of the two"}});
      return false;
    }
    if (where.size() == 2) summed_letters_.insert(letter);
    (where.size() == 2 ? to_sum : free).push_back(where[0]);
  }
  return true;
}

/// `I_i\omega_i` with the principal value I_i is the i-th component of something; `I_k\omega_k\omega_k` is
/// a sum.
void Elaborator::note_riding(const std::string& letter, const std::vector<FreeIndex>& where,
                             std::size_t riding) {
  const bool summed = where.size() - riding == 2;
  const auto rider =
      std::find_if(where.begin(), where.end(), [](const FreeIndex& entry) { return entry.rides; });
  diagnostics_.push_back(
      {summed ? DiagnosticKind::index_rides : DiagnosticKind::unsummed_index,
       rider->span,
       summed
           ? fmt::format(
                 "index `{}` occurs {} times in one term; it is summed, and the principal value goes along",
                 letter, where.size())
           : fmt::format("index `{}` occurs twice in one term, once on a principal value, and is not summed",
                         letter),
       {},
       {summed ? "write the sum out: `\\sum_k`" : "say `(\\text{no sum})` beside the equation"}});
}

Typed Elaborator::sum_over(Typed body, const std::vector<FreeIndex>& letters) {
  for (auto letter = letters.rbegin(); letter != letters.rend(); ++letter) {
    const Span span = tree_[body.id].span;
    body.id = tree_.add({.op = Op::index_sum,
                         .rank = static_cast<std::uint8_t>(body.rank),
                         .span = span,
                         .index = letter->id},
                        std::span(&body.id, 1));
    body.bound.push_back(*letter);
  }
  return body;
}

void Elaborator::warn_of_bold_index(const WrittenName& name, const std::string& whole, Span span) {
  std::string list;
  for (const WrittenIndex& axis : name.axes) list += axis.text + std::string(axis.primes, '\'');
  const bool one = name.axes.size() == 1;
  diagnostics_.push_back({DiagnosticKind::bold_index,
                          span,
                          fmt::format("`{}` is a {}, yet it carries the {} `{}`; read as the component",
                                      whole, one ? "vector" : "tensor", one ? "index" : "indices", list),
                          {},
                          {one ? fmt::format("write `{}_{}`", name.base, list)
                               : fmt::format("write `{}_{{{}}}`", name.base, list)}});
}

}  // namespace rigor
