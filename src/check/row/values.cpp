// SPDX-License-Identifier: GPL-3.0-or-later
// "For $h = 2.0\,\mathrm m$ we have `u \approx 6.3\,\mathrm{m/s}`": the numbers that the page gives for
// letters are put into what it says of them, and the result is compared to the digits that are shown.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/approximate_value.h"
#include "check/doubt/digits.h"
#include "check/meaning/measured.h"
#include "check/place/place.h"
#include "check/question/granted.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// The page gives this number for a letter.
struct GivenValue {
  SymbolId letter{};
  ExprId number{};
  std::string text;          // as a verdict names it
  std::size_t sentence = 0;  // 0: in a display
};

/// u of `u \approx 6.3\,\mathrm{m/s}`
std::optional<SymbolId> bare_letter(const ExprTree& tree, ExprId side) {
  const ExprNode& node = tree[side];
  const bool bare = node.op == Op::symbol && node.rank == 0 && node.slot_count == 0 &&
                    node.particle == no_particle && !tree.symbols[node.symbol].derivation &&
                    !tree.symbols[node.symbol].is_fixed();
  return bare ? std::optional(node.symbol) : std::nullopt;
}

bool gives(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::nearly || kind == RelationKind::defines;
}

/// "If the temperature were $T = 600\,\mathrm K$, …" gives no value to other sentences.
bool is_supposed(const RowPlace& place, const SaidInLine& said) {
  const std::vector<ProseSentence>& sentences = place.notes.prose.sentences;
  const auto sentence = std::ranges::find(sentences, said.sentence, &ProseSentence::number);
  return sentence != sentences.end() && word_that_demands(lowered(sentence->text)).has_value();
}

void note_values_in_lines(RowPlace& place, std::vector<GivenValue>& values) {
  const ProseBeside& here = beside(place);
  for (const SaidInLine& said : place.notes.prose.said) {
    const bool above =
        said.before <= place.event && place.notes.prose.sections.reaches(said.place, here.place);
    const bool own = said.sentence == here.sentence;
    if (said.cue == Cue::apart || (!above && !own) || (!own && is_supposed(place, said))) continue;
    for (const ParsedChain& chain : said.chains) {
      if (chain.sides.size() != 2 || !gives(chain.written.relations[0].kind)) continue;
      const auto reading = read_here(place, chain);
      const auto& left = reading->sides[0].typed;
      const auto& right = reading->sides[1].typed;
      if (!left || !right || !is_measured(place.tree, right->id)) continue;
      if (const auto letter = bare_letter(place.tree, left->id))
        values.push_back({*letter, right->id,
                          fmt::format("{} (line {})", written_at(place, said.span),
                                      place.sources.line_column(said.span.file, said.span.begin).line),
                          said.sentence});
    }
  }
}

void note_values_in_displays(const RowPlace& place, std::vector<GivenValue>& values) {
  for (const StatedLaw& stated : place.above.stated) {
    const PageLaw& law = stated.law;
    if (!place.notes.prose.sections.reaches(law.place, beside(place).place)) continue;
    const auto letter = bare_letter(place.tree, law.equation.left);
    if (letter && is_measured(place.tree, law.equation.right))
      values.push_back({*letter, law.equation.right, law.name});
  }
}

/// The last one of each letter. Where its section gives several, only that of the same sentence counts, and
/// none where one sentence gives several: "In air $n = 1.00$. In glass $n = 1.50$."
std::vector<GivenValue> values_above(RowPlace& place) {
  std::vector<GivenValue> all;
  note_values_in_displays(place, all);
  note_values_in_lines(place, all);
  std::vector<GivenValue> last;
  for (auto value = all.rbegin(); value != all.rend(); ++value) {
    const auto is_other = [&](const GivenValue& other) {
      return &other != &*value && other.letter == value->letter && other.sentence == value->sentence &&
             dump(place.tree, other.number) != dump(place.tree, value->number);
    };
    const auto is_same = [&](const GivenValue& other) { return other.letter == value->letter; };
    const auto is_another = [&](const GivenValue& other) {
      return is_same(other) && dump(place.tree, other.number) != dump(place.tree, value->number);
    };
    if (std::ranges::any_of(last, is_same)) continue;
    if (value->sentence > 0 && std::ranges::any_of(all, is_other)) continue;
    if (value->sentence != beside(place).sentence && std::ranges::any_of(all, is_another)) continue;
    last.push_back(*value);
  }
  return last;
}

/// What holds here, with the laws that say what a letter is, and with the values. `again`: also for letters
/// that are defined: the period of a pendulum is measured, and what plates have for `C = Q/V` is a law.
Names with_values(const RowPlace& place, const ParsedChain& parsed, const Claim& claim,
                  const std::vector<GivenValue>& values, bool again) {
  Names names = place.names;
  const auto own = bare_letter(place.tree, claim.equation.left);
  for (const GivenValue& value : values) {
    if (own == value.letter || (!again && definition_of(names.scope, value.letter) != nullptr)) continue;
    forget_definition(names.scope, value.letter);
    define(names.scope,
           {{value.letter, {}, no_particle, value.number}, Origin{value.text, {}, std::nullopt}, 0});
  }
  const Laws laws =
      available_to(place, parsed, true);  // that the digits agree shows that it is the same thing
  for (auto law = laws.rbegin(); law != laws.rend(); ++law) {
    const auto letter = bare_letter(place.tree, (*law)->equation.left);
    if (!letter || (*law)->standing == Standing::conclusion ||
        is_measured(place.tree, (*law)->equation.right))
      continue;
    const bool defined = definition_of(names.scope, *letter) != nullptr;
    if (defined && (!again || approximate_value(place.tree, names, (*law)->equation.left))) continue;
    forget_definition(names.scope, *letter);
    take_for_granted(place.tree, names, (*law)->equation, Origin{(*law)->name, {}, std::nullopt}, false);
  }
  return names;
}

/// What the sides lead to.
std::vector<std::string> uses_of(const ExprTree& tree, const Names& names, const Claim& claim) {
  std::vector<std::string> uses;
  for (const SymbolId letter :
       symbols_reached(tree, names.scope, {claim.equation.left, claim.equation.right})) {
    const NamedDefinition* named = definition_of(names.scope, letter);
    if (named != nullptr && !is_one_of(named->origin.text, uses)) uses.push_back(named->origin.text);
  }
  return uses;
}

/// "The largest current is" may say another one. A link of a chain, a conclusion, and a row without words of
/// its own go on with what stands above; a letter that has a number already has it for another case.
bool may_be_suspected(const RowPlace& place, const StepReading& row, const Claim& claim) {
  const std::string& lead = beside(place).lead;
  const std::string clause = lowered(lead.substr(lead.rfind('\n') + 1));
  const bool in_numbers =
      clause.find("in numbers") != std::string::npos || clause.find("numerical") != std::string::npos;
  const bool goes_on = row.which > 0 || in_numbers || says_that_it_follows(lead) || !has_own_words(clause);
  if (!goes_on || place.is_stated || may_be_of_a_case(place, row.parsed) || is_alternative(place, row.parsed))
    return false;
  const auto own = bare_letter(place.tree, claim.equation.left);
  return std::ranges::none_of(place.above.stated, [&](const StatedLaw& stated) {
    return own && bare_letter(place.tree, stated.law.equation.left) == own &&
           is_measured(place.tree, stated.law.equation.right);
  });
}

/// More than roundings on the way from the numbers to the result: 3 %, and ten of the last digit.
bool is_far(double ratio, int digits) {
  return std::abs(ratio - 1) > std::max(0.03, 10 * std::pow(10.0, 1 - digits));
}

/// The numbers of the page give another one, which is shown instead.
bool suspects_number(RowPlace& place, const Claim& claim, const Names& names, Judgement& judgement) {
  const auto shown = number_shown(place.tree, claim);
  if (!shown) return false;
  const ExprId value = shown->side == claim.equation.left ? claim.equation.right : claim.equation.left;
  const auto computed = approximate_value(place.tree, names, value);
  const auto written = approximate_value(place.tree, names, shown->side);
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
      !number_shown(place.tree, claim))
    return false;
  if (approximate_value(place.tree, place.names, number_shown(place.tree, claim)->side) == 0.0) return false;
  const auto is_number = [&](ExprId side) {
    const std::vector<SymbolId> letters = symbols_in(place.tree, side);
    return is_measured(place.tree, side) ||
           std::ranges::all_of(letters, [&](SymbolId each) { return place.tree.symbols[each].is_fixed(); });
  };
  if (is_number(claim.equation.left) && is_number(claim.equation.right)) return false;
  const std::vector<GivenValue> values = values_above(place);
  for (const bool again : {false, true}) {
    const Names names = with_values(place, row.parsed, claim, values, again);
    const auto compared = agreement_of_digits(place.tree, names, claim, place.options.cache);
    const bool exactly = !compared && !claim.nearly &&
                         judge(place.tree, names, claim, {}, place.options.cache).verdict == Verdict::proved;
    if (!compared && !exactly) continue;
    if (exactly || compared->agreement == Agreement::rounds) {
      judgement.verdict = Verdict::proved;
      judgement.route = exactly ? "by the numbers of the page" : "to the digits shown";
      judgement.measures = true;
      judgement.of_another_question = true;
      judgement.counterexample.reset();
      judgement.sample.reset();
      judgement.diagnostics.clear();
      judgement.uses = uses_of(place.tree, names, claim);
      leave_to_rows_below(place, row.parsed, claim.equation, claim.relation, Standing::result);
      return true;
    }
    if (compared->agreement == Agreement::differs && !again && may_be_suspected(place, row, claim))
      return suspects_number(place, claim, names, judgement);
    return false;
  }
  return false;
}

}  // namespace rigor
