// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/summation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rigor {
namespace {

/// `I_i\omega_i` with the principal value I_i is the i-th component of something; `I_k\omega_k\omega_k` is
/// a sum.
void note_riding(Reading& reading, const std::string& letter, const std::vector<FreeIndex>& where,
                 std::size_t riding) {
  const bool summed = where.size() - riding == 2;
  const auto rider = std::ranges::find_if(where, &FreeIndex::rides);
  reading.diagnostics.push_back(
      {summed ? DiagnosticKind::index_rides : DiagnosticKind::unsummed_index,
       rider->span,
       summed
           ? fmt::format("index `{}` occurs {} times in one term; it is summed, also on the principal value",
                         letter, where.size())
           : fmt::format("index `{}` occurs twice in one term, once on a principal value, and is not summed",
                         letter),
       {},
       {summed ? "write the sum out: `\\sum_k`" : "write `(\\text{no sum})` next to the equation"}});
}

}  // namespace

std::optional<Contraction> contraction_of(Reading& reading, const std::vector<Typed>& factors) {
  Contraction letters;
  std::map<std::string, std::vector<FreeIndex>> places;
  std::vector<std::string> order;
  for (const Typed& factor : factors) {
    for (const FreeIndex& entry : factor.free) {
      if (places[entry.letter].empty()) order.push_back(entry.letter);
      places[entry.letter].push_back(entry);
    }
    letters.bound.insert(letters.bound.end(), factor.bound.begin(), factor.bound.end());
  }
  for (const std::string& letter : order) {
    const std::vector<FreeIndex>& where = places[letter];
    if (reading.rules.no_sum || reading.rules.unsummed.contains(letter)) {
      letters.free.push_back(where[0]);
      continue;
    }
    const auto riding = static_cast<std::size_t>(std::ranges::count_if(where, &FreeIndex::rides));
    if (riding > 0 && where.size() - riding >= 1 && where.size() - riding <= 2) {
      note_riding(reading, letter, where, riding);
      const auto own = std::ranges::find_if(where, [](const FreeIndex& entry) { return !entry.rides; });
      (where.size() - riding == 2 ? letters.summed : letters.free).push_back(*own);
      continue;
    }
    const bool sure = reading.letters.is_sure(letter);
    if (where.size() > 2) {
      Diagnostic diagnostic{sure ? DiagnosticKind::index_repeats : DiagnosticKind::ambiguous_reading,
                            where[2].span,
                            fmt::format("index `{}` occurs {} times in one term", letter, where.size())};
      diagnostic.labels = {{where[0].span, ""}, {where[1].span, ""}};
      if (!sure) diagnostic.message += "; it can be a label";
      diagnostic.help = {
          "the summation convention allows a letter at most twice in a term; rename a pair, or write the sum "
          "out"};
      reading.diagnostics.push_back(std::move(diagnostic));
      return std::nullopt;
    }
    const auto clash = std::ranges::find(letters.bound, letter, &FreeIndex::letter);
    if (clash != letters.bound.end()) {
      reading.diagnostics.push_back(
          {sure ? DiagnosticKind::index_clash : DiagnosticKind::ambiguous_reading,
           where[0].span,
           fmt::format("index `{}` is summed inside a factor of the same term", letter),
           {{clash->span, "summed here"}},
           {"rename one of the two"}});
      return std::nullopt;
    }
    if (where.size() == 2 && where[0].height != Height::none && where[0].height == where[1].height) {
      const char* place = where[0].height == Height::above ? "above" : "below";
      reading.diagnostics.push_back(
          {DiagnosticKind::unsupported,
           where[1].span,
           fmt::format("`{}` stands {} twice in one term; a sum takes one index above and one below", letter,
                       place),
           {{where[0].span, ""}},
           {"lower or raise one of the two"}});
      return std::nullopt;
    }
    if (where.size() == 2) reading.found.summed_letters.insert(letter);
    (where.size() == 2 ? letters.summed : letters.free).push_back(where[0]);
  }
  return letters;
}

Typed summed(ExprTree& tree, Typed product, Contraction letters) {
  product.free = std::move(letters.free);
  product.bound = std::move(letters.bound);
  for (auto letter = letters.summed.rbegin(); letter != letters.summed.rend(); ++letter) {
    const auto rank = static_cast<std::uint8_t>(product.rank);
    const Span span = tree[product.id].span;
    product.id = tree.add({.op = Op::index_sum, .rank = rank, .span = span, .index = letter->id},
                          std::span(&product.id, 1));
    product.bound.push_back(*letter);
  }
  return product;
}

MaybeTyped contract(Reading& reading, Typed typed) {
  auto letters = contraction_of(reading, {typed});
  return letters ? std::optional(summed(reading.tree, std::move(typed), *std::move(letters))) : std::nullopt;
}

}  // namespace rigor
