// SPDX-License-Identifier: GPL-3.0-or-later
// "For $h = 2.0\,\mathrm m$ we have `u \approx 6.3\,\mathrm{m/s}`": the numbers that the page gives for
// letters are put into what it says of them, and the result is compared to the digits that are shown.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "check/constant/measured_row.h"
#include "check/constant/natural_units.h"
#include "check/doubt/approximate_value.h"
#include "check/doubt/digits.h"
#include "check/meaning/measured.h"
#include "check/row/given_values.h"
#include "check/row/row.h"

namespace rigor {
namespace {

/// The numbers of the page give another one, which is shown instead.
bool suspects_number(RowPlace& place, const Claim& claim, const Names& names, Judgement& judgement) {
  const auto shown = number_shown(place.tree, place.names, claim);
  if (!shown) return false;
  const ExprId value = shown->side == claim.equation.left ? claim.equation.right : claim.equation.left;
  const auto computed = approximate_value(place.tree, names, value);
  const auto written = approximate_value(place.tree, names, shown->side);
  if (may_have_natural_units(place.tree, names, claim.equation)) return false;
  if (!computed || !written || *written == 0 || !is_far(*computed / *written, shown->digits)) return false;
  const std::string digits(place.tree.digits(shown->number));
  const double number = std::strtod(digits.c_str(), nullptr) * *computed / *written;
  const std::string instead = fmt::format("{:.{}g}", number, std::max(shown->digits, 2));
  judgement.verdict = Verdict::suspect;
  judgement.route = "the numbers of the page give another one";
  judgement.of_another_question = true;
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.uses = uses_of(place.tree, names, claim);
  judgement.diagnostics = {
      {DiagnosticKind::suspect,
       claim.relation,
       fmt::format("with {}, `{}` comes to {} where {} is written", fmt::join(judgement.uses, ", "),
                   written_at(place, value == claim.equation.left ? claim.left : claim.right), instead,
                   digits),
       {},
       {"`rigor: law next` says that it is meant as it stands"}}};
  return true;
}

}  // namespace

bool agrees_with_values(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::law || judgement.verdict == Verdict::refuted ||
                    judgement.verdict == Verdict::undecided;
  if (!open || claim.recorded != nullptr || claim.equation.relation != Relation::equal || row.unsettled ||
      !number_shown(place.tree, place.names, claim) || has_operators(place.tree, claim.equation.left) ||
      has_operators(place.tree, claim.equation.right))
    return false;
  if (approximate_value(place.tree, place.names, number_shown(place.tree, place.names, claim)->side) == 0.0)
    return false;
  const auto is_number = [&](ExprId side) {
    const std::vector<SymbolId> letters = symbols_in(place.tree, side);
    return is_measured(place.tree, side) ||
           std::ranges::all_of(letters, [&](SymbolId each) { return place.tree.symbols[each].is_fixed(); });
  };
  if (is_number(claim.equation.left) && is_number(claim.equation.right)) return false;
  const std::vector<GivenValue> values = values_above(place);
  for (const bool again : {false, true}) {
    const Names names = with_values(place, row.parsed, claim, values, again);
    auto compared = agreement_of_digits(place.tree, names, claim, place.options.cache);
    if (!compared) {  // `2\pi\sqrt{m/k}`: of π, a root and units only the numbers in base units have bounds
      const auto numbers = claim_in_base_units(place.tree, names, claim);
      if (numbers) compared = agreement_of_digits(place.tree, names, *numbers, place.options.cache, true);
    }
    const bool exactly = !compared && !claim.nearly &&
                         judge(place.tree, names, claim, {}, place.options.cache).verdict == Verdict::proved;
    if (!compared && !exactly) continue;
    if (exactly || compared->agreement == Agreement::rounds) {
      prove_by_numbers(place, row, claim, uses_of(place.tree, names, claim),
                       exactly ? "by the numbers of the page" : "to the digits shown", judgement);
      return true;
    }
    if (compared->agreement == Agreement::differs && !again && number_may_be_suspected(place, row, claim))
      return suspects_number(place, claim, names, judgement);
    return false;
  }
  return false;
}

}  // namespace rigor
