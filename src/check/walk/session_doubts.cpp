// SPDX-License-Identifier: GPL-3.0-or-later
// What else a refuted step may mean: a condition that its words say, an equation for its letters, another
// constant of integration, terms that an average drops.
#include <fmt/format.h>

#include <algorithm>

#include "check/doubt/equation_of_letters.h"
#include "check/prose/open_words.h"
#include "check/repair/free_constant.h"
#include "check/repair/missing_condition.h"
#include "check/walk/session.h"

namespace rigor {
namespace {

bool has_slip(const std::vector<Repair>& repairs) {
  return std::any_of(repairs.begin(), repairs.end(),
                     [](const Repair& repair) { return !repair.adds_a_term; });
}

}  // namespace

/// An integral sign up to here, or a word of what is integrated or solved.
bool Session::speaks_of_integration() const {
  const ProseBeside& beside = notes_.prose.beside[event_];
  for (std::size_t k = 0; k <= event_; ++k) {
    if (!notes_.prose.sections.reaches(notes_.prose.beside[k].place, beside.place)) continue;
    const auto* display = std::get_if<ParsedDisplay>(&notes_.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (sources_.text(chain.written.span).find("\\int") != std::string_view::npos) return true;
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
  return std::any_of(notes_.prose.sentences.begin(), notes_.prose.sentences.end(),
                     [&](const ProseSentence& each) {
                       return each.number < beside.sentence &&
                              notes_.prose.sections.reaches(each.place, beside.place) && says(each.text);
                     });
}

/// A message and its help, where the step may not be meant for all values. Where it is also true with another
/// sign, factor or letter, that is likelier.
std::optional<std::pair<std::string, std::string>> Session::doubt_left(const ParsedChain& parsed,
                                                                       std::size_t which, const Claim& claim,
                                                                       const Context& context) {
  using Doubt = std::pair<std::string, std::string>;
  const WrongStep wrong{.parsed = parsed, .which = which, .first_order = context.first_order};
  const std::string_view lead = notes_.prose.beside[event_].lead;
  std::optional<std::vector<Repair>> known;
  const auto repairs = [&]() -> const std::vector<Repair>& {
    if (!known) known = nearest_true_statements(tree_, names_, wrong, options_.cache);
    return *known;
  };
  const auto word = open_word(notes_.prose, event_);
  const std::vector<std::string> conditions = missing_conditions(tree_, names_, wrong, options_.cache);
  const auto weights = std::find_if(conditions.begin(), conditions.end(), is_sum_of_weights);
  if (!conditions.empty() && (word || weights != conditions.end()) && !has_slip(repairs())) {
    if (word)
      return Doubt(
          fmt::format("it does not hold for all values; it holds if `{}`, and `{}` beside it may say so",
                      conditions.front(), *word),
          "`rigor: given …` says so, `rigor: claim …` states it without");
    return Doubt(fmt::format("it does not hold for all values; it holds if `{}`", *weights),
                 "`rigor: given …` says so, `rigor: claim …` states it without");
  }
  if (const auto dropped = word_of_dropped_terms(notes_.prose, event_); dropped && !has_slip(repairs()))
    return Doubt(fmt::format("it does not hold for all values, and `{}` beside it may say which terms vanish",
                             *dropped),
                 "`rigor: claim …` states it for itself");
  if (speaks_of_integration()) {
    if (const auto letter = absorbing_constant(tree_, names_, wrong, options_.cache))
      return Doubt(
          fmt::format("it holds with another constant `{}` on the right, and constants of integration "
                      "absorb numbers and factors",
                      *letter),
          "another letter for the second constant says so, `rigor: claim …` states it as it stands");
  }
  if (which == 0 && parsed.written.relations.size() == 1 &&
      may_be_an_equation_of_letters(tree_, claim.equation) && !announces_an_identity(lead) &&
      (names_an_equation_of_letters(lead) ||
       (!reads_as_identity(tree_, claim.equation) && repairs().empty())))
    return Doubt(
        "it does not hold for all values, no slip of the pen explains it, and it may say which values are "
        "meant",
        "`rigor: claim …` states it for all, and so does `hence` or `identity` in its sentence");
  return std::nullopt;
}

}  // namespace rigor
