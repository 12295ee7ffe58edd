// SPDX-License-Identifier: GPL-3.0-or-later
// What else a refuted step may mean: a condition that its words say, an equation for its letters, another
// constant of integration, terms that an average drops.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ascii.h"
#include "check/doubt/equation_of_letters.h"
#include "check/place/place.h"
#include "check/prose/open_words.h"
#include "check/repair/free_constant.h"
#include "check/repair/missing_condition.h"

namespace rigor {
namespace {

bool has_slip(const std::vector<Repair>& repairs) {
  return std::ranges::any_of(repairs, [](const Repair& repair) { return !repair.adds_a_term; });
}

/// An integral sign up to here, or a word of what is integrated or solved.
bool speaks_of_integration(const RowPlace& place) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  for (std::size_t k = 0; k <= place.event; ++k) {
    if (!place.notes.prose.sections.reaches(place.notes.prose.beside[k].place, beside.place)) continue;
    const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (place.sources.text(chain.written.span).find("\\int") != std::string_view::npos) return true;
    }
  }
  const auto says = [](std::string_view text) {
    return text.find("integrat") != std::string_view::npos ||
           text.find("antiderivative") != std::string_view::npos ||
           text.find("primitive") != std::string_view::npos ||
           text.find("general solution") != std::string_view::npos ||
           text.find("differential equation") != std::string_view::npos ||
           text.find("integral") != std::string_view::npos;
  };
  if (says(beside.lead) || says(beside.tail)) return true;
  return std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& each) {
    return each.number < beside.sentence && place.notes.prose.sections.reaches(each.place, beside.place) &&
           says(each.text);
  });
}

/// `+ 3Ek_0`: nobody forgets a term with such a number.
bool adds_an_unusual_term(const Repair& repair) {
  if (!repair.adds_a_term || !repair.replacement.starts_with(repair.replaced)) return false;
  const std::string_view added = std::string_view(repair.replacement).substr(repair.replaced.size());
  const auto first = added.find_first_not_of("+- ");
  if (first == std::string_view::npos || !is_digit(added[first])) return false;
  const auto end = added.find_first_not_of("0123456789", first);
  const std::string_view number = added.substr(first, end - first);
  return number.size() > 1 || number[0] >= '3';
}

/// A single sign, number, letter or index: of an exchange or another function there are so many that one of
/// them explains nearly everything.
std::vector<Repair> likely_repairs(RowPlace& place, const WrongStep& wrong) {
  const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim,
                                   Slip slip) -> std::optional<std::vector<std::string>> {
    if (slip >= Slip::indices_exchanged) return std::nullopt;
    Judgement judgement = judge(tree, names, claim, limits_of_candidates, place.options.cache);
    if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
    return std::move(judgement.uses);
  };
  std::vector<Repair> repairs;
  for (TrueNeighbour& each : true_neighbours(place.tree, place.names, wrong, proof, place.options.cache))
    if (!adds_an_unusual_term(each.repair)) repairs.push_back(std::move(each.repair));
  return repairs;
}

}  // namespace

std::optional<std::pair<std::string, std::string>> doubt_left(RowPlace& place, const StepReading& row,
                                                              const Claim& claim) {
  using Doubt = std::pair<std::string, std::string>;
  const WrongStep wrong{.parsed = row.parsed, .which = row.which, .first_order = row.first_order};
  const std::string_view lead = place.notes.prose.beside[place.event].lead;
  std::optional<std::vector<Repair>> known;
  const auto repairs = [&]() -> const std::vector<Repair>& {
    if (!known) known = likely_repairs(place, wrong);
    return *known;
  };
  const auto word = open_word(place.notes.prose, place.event);
  const std::vector<std::string> conditions =
      missing_conditions(place.tree, place.names, wrong, place.options.cache);
  const auto weights = std::ranges::find_if(conditions, is_sum_of_weights);
  if (!conditions.empty() && (word || weights != conditions.end()) && !has_slip(repairs())) {
    if (word)
      return Doubt(
          fmt::format("it does not hold for all values; it holds if `{}`, and `{}` next to it may say so",
                      conditions.front(), *word),
          "`rigor: given …` states this condition; `rigor: claim …` asks whether the step holds without it");
    return Doubt(
        fmt::format("it does not hold for all values; it holds if `{}`", *weights),
        "`rigor: given …` states this condition; `rigor: claim …` asks whether the step holds without it");
  }
  if (const auto dropped = word_of_dropped_terms(place.notes.prose, place.event);
      dropped && !has_slip(repairs()))
    return Doubt(
        fmt::format("it does not hold for all values, and `{}` next to it may say which terms vanish",
                    *dropped),
        "`rigor: claim …` asks whether it holds for all values");
  if (speaks_of_integration(place)) {
    if (const auto letter = absorbing_constant(place.tree, place.names, wrong, place.options.cache))
      return Doubt(
          fmt::format("it holds with another constant `{}` on the right, and a constant of integration may "
                      "absorb factors",
                      *letter),
          "use another letter for the second constant; `rigor: claim …` asks whether it holds as written");
  }
  if (row.which == 0 && row.parsed.written.relations.size() == 1 &&
      may_be_an_equation_of_letters(place.tree, claim.equation) && !announces_an_identity(lead) &&
      (names_an_equation_of_letters(lead) ||
       (!reads_as_identity(place.tree, claim.equation) && repairs().empty())))
    return Doubt(
        "it does not hold for all values, and no small slip explains that: it may say which values are meant",
        "`rigor: claim …` asks whether it holds for all values; so does `hence` or `identity` in its "
        "sentence");
  return std::nullopt;
}

}  // namespace rigor
