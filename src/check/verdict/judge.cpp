// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "algebra/decide/decide.h"
#include "algebra/rough/rough_screen.h"
#include "base/among.h"
#include "check/meaning/divisors.h"
#include "check/meaning/function_values.h"
#include "check/meaning/identity_reading.h"
#include "check/meaning/negative_squares.h"
#include "check/meaning/sign_doubt.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/question/question_names.h"
#include "check/question/unread.h"
#include "check/verdict/component_declared_alone.h"
#include "check/verdict/counted_letter.h"
#include "check/verdict/counterexample.h"
#include "check/verdict/decide_by_record.h"
#include "check/verdict/law_diagnostic.h"
#include "check/verdict/other_reading.h"
#include "check/verdict/rational_expression.h"
#include "check/verdict/two_outcomes.h"
#include "elaborate/name/known_value.h"

namespace rigor {
namespace {

class Judging {
 public:
  Judging(ExprTree& tree, const Names& names, const Claim& claim, const Limits& limits, DecisionCache* cache)
      : tree_(tree), names_(names), claim_(claim), limits_(limits), cache_(cache) {}

  Judgement judge() {
    Decision decision = decide_orders();
    if (limits_.only_proofs && decision.outcome != Outcome::proved) return unproved(decision);
    if (decision.outcome == Outcome::refuted) decision = where_squares_are_squares(std::move(decision));
    judgement_.route = decision.route;
    switch (decision.outcome) {
      case Outcome::proved:
        proved(decision);
        break;
      case Outcome::refuted:
        refuted(decision);
        break;
      case Outcome::undecided:
        mark_all_assumptions();
        if (!assumes_the_impossible() && doubts_change()) break;  // else its constants were withdrawn
        if (decision.no_real_value) {
          judgement_.verdict = Verdict::not_understood;
          add(DiagnosticKind::no_real_value,
              "under the assumptions this takes the root of a negative number, so it says nothing",
              {"a symbol that is defined by its square is the root that is not negative"});
          break;
        }
        if (is_law_of_operators()) break;
        if (!own_guess() && !claim_.for_all && relates_different_averages(tree_, prepared_, cache_)) {
          state_law_of(averages_of(prepared_.question));
          break;
        }
        judgement_.verdict = Verdict::undecided;
        add(DiagnosticKind::undecided,
            decision.reason.empty() ? "no proof and no counterexample was found" : decision.reason);
        break;
    }
    heed_other_reading();
    note_uses(decision);
    if (claim_.explains) name_what_it_rests_on();
    judgement_.question = std::move(prepared_.question);
    if (judgement_.verdict != Verdict::refuted)
      judgement_.sample.reset();
    else if (!judgement_.sample)
      judgement_.sample = std::move(decision.sample);
    return std::move(judgement_);
  }

 private:
  void add(DiagnosticKind kind, std::string message, std::vector<std::string> help = {}) {
    judgement_.diagnostics.push_back({kind, claim_.relation, std::move(message), {}, std::move(help)});
  }

  void mark_used(const Origin& origin) {
    if (origin.directive) judgement_.used.insert(*origin.directive);
  }

  [[nodiscard]] Prepared prepare(int slack, Precision precision, int order) {
    Prepared prepared = rigor::prepare(tree_, names_, claim_.equation, slack, precision, order);
    judgement_.used.insert(prepared.used.begin(), prepared.used.end());
    for (const NamedAssumption* each : prepared.integrals_rest_on) {
      if (each->origin.directive) judgement_.used.insert(*each->origin.directive);
    }
    return prepared;
  }

  /// Where only a proof counts.
  Judgement unproved(const Decision& decision) {
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided, "no proof was found");
    prove_with_unit_matrix();
    note_uses(decision);
    return std::move(judgement_);
  }

  /// First-order parts differ more often; they are asked first where nobody asks which part differs.
  Decision decide_orders() {
    if (!claim_.nearly) return decide_without_zero_divisors(0);
    first_order_ = limits_.only_proofs;
    Decision decision = decide_without_zero_divisors(first_order_ ? 1 : 0);
    if (decision.outcome != Outcome::proved) return decision;
    Prepared of_first_order = std::exchange(prepared_, {});
    first_order_ = !first_order_;
    Decision other = decide_without_zero_divisors(first_order_ ? 1 : 0);
    if (first_order_ || other.outcome != Outcome::proved) {
      decision = std::move(other);
    } else {
      prepared_ = std::move(of_first_order);
    }
    first_order_ = true;
    decision.vanishes = false;
    return decision;
  }

  Decision decide_without_zero_divisors(int order) {
    Decision decision = decide_order(order);
    return decision.outcome == Outcome::refuted ? where_nothing_is_divided_by_zero(std::move(decision))
                                                : decision;
  }

  /// What only a derivative of an assumption shows is looked for as well, before a claim is given up or
  /// refuted.
  Decision decide_order(int order) {
    const Precision precision = claim_.nearly ? Precision::small_order : Precision::exact;
    prepared_ = prepare(0, precision, order);
    const bool asks_again = speaks_of_derivatives(prepared_);
    Decision decision = decide_prepared(!asks_again);
    if (decision.outcome == Outcome::proved || !asks_again) return decision;
    const Question asked = std::exchange(prepared_, prepare(1, precision, order)).question;
    return limits_.only_proofs && has_as_many_parts(asked) ? decision : decide_prepared(true);
  }

  /// Derivatives only add to a question.
  [[nodiscard]] bool has_as_many_parts(const Question& asked) const {
    const Question& now = prepared_.question;
    return asked.assumptions.size() == now.assumptions.size() &&
           asked.definitions.size() == now.definitions.size() && asked.zeroed.size() == now.zeroed.size();
  }

  /// Unless it is the last word, nobody asks what refutes it.
  Decision decide_prepared(bool last) {
    for (const Origin* definition : prepared_.definitions) mark_used(*definition);
    for (const auto& put_in : prepared_.put_in)
      for (const Origin* definition : put_in) mark_used(*definition);
    if (prepared_.too_large) {
      Decision open;
      open.reason = *prepared_.too_large;
      return open;
    }
    Limits limits = limits_;
    limits.only_proofs = limits.only_proofs || !last;
    Decision decision = answers_by_record() ? decide_by_record(prepared_, claim_.swapped, *claim_.recorded)
                                            : decide(cache_, prepared_.question, limits);
    for (const std::size_t which : decision.assumptions) {
      if (prepared_.assumptions[which] != nullptr) mark_used(prepared_.assumptions[which]->origin);
    }
    return decision;
  }

  /// The notes do not speak of a sample on which a divisor of their definitions or assumptions is 0: then it
  /// is looked for with those numbers not 0.
  Decision where_nothing_is_divided_by_zero(Decision refuted) {
    if (claim_.recorded != nullptr) return refuted;
    const std::vector<SymbolId> divisors = divisors_of_sample(tree_, names_, *refuted.sample);
    if (divisors.empty()) return refuted;
    const std::size_t first = prepared_.question.assumptions.size();
    for (const SymbolId divisor : divisors) {
      Equation nonzero;
      nonzero.left = tree_.add({.op = Op::symbol, .span = claim_.relation, .symbol = divisor});
      nonzero.right = tree_.add_number(claim_.relation, "0");
      nonzero.relation = Relation::unequal;
      prepared_.question.assumptions.push_back(std::move(nonzero));
      prepared_.assumptions.push_back(nullptr);
    }
    prepared_.question.tree = &tree_;
    Decision decision = decide_prepared(true);
    for (const std::size_t which : decision.assumptions) {
      if (which < first) continue;
      const std::string& name = tree_.symbols[divisors[which - first]].name;
      add_use(fmt::format("convention: `{}` is not 0, since the notes divide by it", name));
    }
    if (decision.outcome == Outcome::undecided)
      decision.reason =
          fmt::format("it was found to fail only where one of {} is 0, and the notes divide by them",
                      quoted_names(tree_, divisors));
    return decision;
  }

  /// `(\Omega)^2 = k`: where k is negative, the notes need not mean that number Ω. Such a sample refutes an
  /// order only if the order fails without such samples, too, or if the square is negative in any case.
  Decision where_squares_are_squares(Decision refuted) {
    if (claim_.recorded != nullptr || claim_.equation.relation == Relation::equal) return refuted;
    const std::vector<NegativeSquare> negative =
        negative_squares_of_sample(tree_, names_, prepared_.question, *refuted.sample);
    if (negative.empty()) return refuted;
    const Prepared before = prepared_;
    for (const NegativeSquare& each : negative) {
      prepared_.question.assumptions.push_back(each.not_negative);
      prepared_.assumptions.push_back(nullptr);
    }
    prepared_.question.tree = &tree_;
    Decision decision = decide_prepared(true);
    if (decision.outcome == Outcome::refuted) return decision;
    prepared_ = before;
    const bool in_any_case = std::ranges::all_of(negative, [&](const NegativeSquare& each) {
      Question question = prepared_.question;
      question.tree = &tree_;
      question.claim = each.negative;
      return decide(cache_, question, {.simplest_sample = false}).outcome == Outcome::proved;
    });
    if (in_any_case) return refuted;
    decision = Decision{};
    decision.reason = fmt::format(
        "it was found to fail only where `({})^2` is negative, and nothing says whether it can be",
        tree_.symbols[negative.front().name].name);
    return decision;
  }

  /// For a step with ≈, only the order that the recorded sample is about.
  bool answers_by_record() const {
    if (claim_.recorded == nullptr) return false;
    return !claim_.nearly || first_order_ == is_of_first_order(claim_.recorded->example);
  }

  void mark_all_assumptions() {
    for (const NamedAssumption* assumption : prepared_.assumptions) {
      if (assumption != nullptr) mark_used(assumption->origin);
    }
  }

  void add_use(const std::string& use) {
    if (!is_one_of(use, judgement_.uses)) judgement_.uses.push_back(use);
  }

  void name_what_it_rests_on() {
    judgement_.names = names_of(prepared_);
    if (!claim_.nearly || judgement_.verdict != Verdict::proved) return;
    Prepared exact = prepare(0, Precision::exact, 0);
    if (exact.too_large) return;
    NearlyQuestion nearly{.exact = {}, .names = names_of(exact), .small = {}};
    nearly.exact = std::move(exact.question);
    for (const SmallQuantity& small : names_.scope.small) nearly.small.push_back(small.quantity);
    judgement_.nearly_question = std::move(nearly);
  }

  void note_uses(const Decision& decision) {
    for (const Origin* each : origins_of(prepared_, decision.unfolded)) add_use(each->text);
    for (const std::size_t which : decision.assumptions) {
      if (prepared_.assumptions[which] != nullptr) add_use(prepared_.assumptions[which]->origin.text);
    }
    for (const std::string& convention : claim_.reading->found.conventions)
      add_use("convention: " + convention);
    for (const std::string& convention : prepared_.conventions) add_use("convention: " + convention);
    for (const NamedAssumption* each : prepared_.integrals_rest_on) add_use(each->origin.text);
    if (!claim_.derived_by.empty())
      add_use(
          fmt::format("convention: an integral without limits is one up to a constant, so that both sides "
                      "are differentiated by `{}`",
                      claim_.derived_by));
  }

  bool assumes_the_impossible() const {
    return std::ranges::any_of(prepared_.assumptions, [](const NamedAssumption* each) {
      return each != nullptr && each->without_sample;
    });
  }

  /// Under assumptions that no sample was found to satisfy, nothing is proved or refuted. They are all those
  /// that bear on the claim: which of them is wrong is not known.
  bool rests_on_the_impossible(const Decision& decision, const char* consequence) {
    const bool alone = decision.outcome == Outcome::proved && decision.assumptions.empty() &&
                       prepared_.question.definitions.empty();
    if (!assumes_the_impossible() || alone) return false;
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided, consequence);
    return true;
  }

  void proved(const Decision& decision) {
    if (rests_on_the_impossible(decision,
                                "it follows from assumptions that no sample was found to satisfy, and "
                                "contradictory assumptions prove anything"))
      return;
    if (takes_another_order() || exists_nowhere()) return;
    judgement_.verdict = Verdict::proved;
    if (prepared_.exists_under) {
      const auto& assumptions = prepared_.question.assumptions;
      judgement_.exists_under.assign(
          assumptions.begin() + static_cast<std::ptrdiff_t>(*prepared_.exists_under), assumptions.end());
    }
    if (first_order_ && !limits_.only_proofs) note_neglected();
    const bool zero_written =
        tree_.is_zero_literal(claim_.equation.left) || tree_.is_zero_literal(claim_.equation.right);
    if (!decision.vanishes || zero_written) return;
    judgement_.route += ", 0 = 0";
    add(DiagnosticKind::zero_equals_zero,
        "both sides are zero for all values, so the step says less than it seems to");
  }

  /// A proof about integrals says something only if some numbers let all of them exist.
  bool exists_nowhere() {
    if (!prepared_.exists_under) return false;
    prepared_.question.tree = &tree_;
    if (satisfying_sample(cache_, prepared_.question, {}, {})) return false;
    if (is_met_at_rough_points(prepared_.question, cache_ ? &cache_->budget() : nullptr)) return false;
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided,
        "no sample was found for which its integrals exist: a divisor may vanish between their limits");
    return true;
  }

  /// What is not known of an integral may be anything to a sample, so that only a proof counts.
  bool speaks_of_open_integral() {
    if (!prepared_.open_integral) return false;
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided,
        fmt::format("it was found to fail only where {} is taken as any number: {}",
                    prepared_.open_sum ? "a sum" : "an integral", *prepared_.open_integral));
    return true;
  }

  bool may_be_rounded(const Sample& sample) {
    if (!rigor::may_be_rounded(tree_, claim_.equation, sample)) return false;
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided, "the decimals can be rounded");
    return true;
  }

  /// E is declared small, which means of first order, and E = v² makes it the square of a quantity.
  bool takes_another_order() {
    if (!claim_.nearly) return false;
    for (const SymbolId symbol : symbols_of(prepared_.question)) {
      if (!is_of_other_order(names_.scope, base_of(tree_.symbols, symbol))) continue;
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          fmt::format("`{}` is declared small, of first order, but its definition gives it another order",
                      tree_.symbols[base_of(tree_.symbols, symbol)].name));
      return true;
    }
    return false;
  }

  /// The order of the first term that "nearly equal" leaves out.
  void note_neglected() {
    constexpr int highest = 3;
    constexpr Limits brief{.expanded_terms = 1'500,
                           .steps = 100'000,
                           .quick_points = 5,
                           .quick_steps = 40'000,
                           .sample_attempts = 24,
                           .fewest_assumptions = false,
                           .simplest_sample = false};
    judgement_.route += ", to first order in what is small";
    for (int order = 2; order <= highest; ++order) {
      const Prepared higher = prepare(0, Precision::small_order, order);
      if (higher.too_large) return;
      const Decision decision = decide(cache_, higher.question, brief);
      if (decision.outcome == Outcome::proved) continue;
      if (order <= order_shown(tree_, names_.scope, claim_.equation)) {
        judgement_.verdict = Verdict::undecided;
        return add(DiagnosticKind::undecided,
                   fmt::format("it holds to first order, but not to order {}, which it shows", order));
      }
      if (decision.outcome == Outcome::refuted)
        judgement_.route += fmt::format("; the first term left out is of order {}", order);
      return;
    }
    judgement_.route += fmt::format("; nothing is left out up to order {}", highest);
  }

  /// A definition that the claim reaches has a rate of it, and says so wherever it is used.
  [[nodiscard]] bool changes_in_definitions(SymbolId symbol) const {
    const SymbolId base = base_of(tree_.symbols, symbol);
    const auto is_rate = [&](SymbolId each) {
      return tree_.symbols[each].order(By::time) > 0 && base_of(tree_.symbols, each) == base;
    };
    return std::ranges::any_of(prepared_.question.definitions, [&](const Definition& definition) {
      return !tree_.symbols[definition.symbol].derivation &&
             std::ranges::any_of(symbols_in(tree_, definition.body), is_rate);
    });
  }

  /// C of `\dot q = C\dot V` above "the plates are pulled apart" and `\dot q = C\dot V + \dot CV`: only rows
  /// below show that it changes, and they may speak of another case.
  void add_changes_said_below(std::vector<SymbolId>& unknown) const {
    std::set<SymbolId> shown;  // of which a rate is written in this row or above it
    const auto show = [&](SymbolId symbol) {
      if (tree_.symbols[symbol].order(By::time) > 0) shown.insert(base_of(tree_.symbols, symbol));
    };
    for (const auto& [symbol, depth] : names_.scope.seen) show(symbol);
    for (const ExprId side : {claim_.equation.left, claim_.equation.right}) {
      for (const SymbolId symbol : symbols_in(tree_, side)) show(symbol);
    }
    for (const SymbolId symbol : symbols_of(prepared_.question)) {
      const SymbolId base = base_of(tree_.symbols, symbol);
      const bool said = shown.contains(base) || definition_of(names_.scope, base) != nullptr ||
                        names_.scope.variables.contains(base) || !changes_by_evidence(base);
      if (tree_.symbols[symbol].order(By::time) > 0 && !said && !is_one_of(base, unknown))
        unknown.push_back(base);
    }
  }

  /// A letter, of which rows of its section show that it changes.
  [[nodiscard]] bool changes_by_evidence(SymbolId base) const {
    const NameKey* key = key_of(names_.symbols, base);
    return key != nullptr && tree_.symbols[base].rank == 0 &&
           is_changing(*names_.symbols.evidence, key->base);
  }

  /// If nothing says whether a differentiated quantity changes, only a proof counts.
  bool doubts_change() {
    std::vector<SymbolId> unknown = prepared_.unknown_changes;
    const std::vector<SymbolId>& written = claim_.reading->found.unknown_changes;
    unknown.insert(unknown.end(), written.begin(), written.end());
    std::erase_if(unknown, [this](SymbolId symbol) { return changes_in_definitions(symbol); });
    if (!claim_.for_all) add_changes_said_below(unknown);
    if (unknown.empty()) return false;
    unknown = bases_of(tree_, unknown);
    const bool one = unknown.size() == 1;
    const std::string& first = tree_.symbols[unknown.front()].name;
    judgement_.verdict = Verdict::not_understood;
    add(DiagnosticKind::unknown_change,
        fmt::format("nothing says whether {} {}", quoted_names(tree_, unknown), one ? "changes" : "change"),
        {fmt::format("`rigor: constant {0}` or `rigor: variable {0}` says so{1}; `rigor: given …` can say "
                     "how it changes",
                     first, one ? "" : " of the first")});
    return true;
  }

  [[nodiscard]] Question as_written() const {
    Question asked = prepared_.question;
    asked.tree = &tree_;
    asked.claim = claim_.equation;
    return asked;
  }

  bool prove_with_unit_matrix() {
    if (!holds_with_unit_matrix(as_written(), names_)) return false;
    judgement_.verdict = Verdict::proved;
    judgement_.route = "products in their order, with 1 for the unit matrix";
    judgement_.of_another_question = true;
    judgement_.counterexample.reset();
    judgement_.diagnostics.clear();
    return true;
  }

  /// The letters can be something else than real numbers.
  void heed_other_reading() {
    const bool proved = judgement_.verdict == Verdict::proved;
    if (!proved && prove_with_unit_matrix()) return;
    if (!proved && judgement_.verdict != Verdict::refuted) return;
    auto other = other_reading(as_written(), names_, proved);
    if (!other) return;
    judgement_.verdict = Verdict::not_understood;
    judgement_.route.clear();
    judgement_.counterexample.reset();
    judgement_.diagnostics.clear();
    add(DiagnosticKind::ambiguous_reading, std::move(other->message), std::move(other->help));
  }

  /// `A·(A×B) = 1`: where neither side depends on anything, no law can make it true.
  bool both_constant(const Sample& sample) {
    if (!sample.axes.empty() || !sample.free_particles.empty()) return false;
    const auto is_constant = [&](ExprId side, const std::string& value) {
      Question question = prepared_.question;
      question.claim.left = side;
      const auto number = add_rational(tree_, claim_.relation, value);
      if (!number) return false;
      question.claim.right = *number;
      return decide(cache_, question, {.simplest_sample = false}).outcome == Outcome::proved;
    };
    return is_constant(claim_.equation.left, sample.left) && is_constant(claim_.equation.right, sample.right);
  }

  /// The left side is a defined symbol alone, so that the step says again what it is; or it says what an
  /// integral is.
  bool restates_definition() const {
    const auto is_integral = [&](SymbolId symbol) {
      return tree_.symbols[base_of(tree_.symbols, symbol)].integral.has_value();
    };
    const ExprNode& left = tree_[claim_.equation.left];
    if (left.op == Op::symbol && definition_of(names_.scope, left.symbol) != nullptr) return true;
    return !claim_.derived_by.empty() ||
           std::ranges::any_of(symbols_in(tree_, claim_.equation.left), is_integral) ||
           std::ranges::any_of(symbols_in(tree_, claim_.equation.right), is_integral);
  }

  /// Why the way in which it was read is only a guess, if its other reading is not asked as well.
  [[nodiscard]] std::optional<Obstacle> own_guess() const {
    return claim_.in_both_readings ? lasting_guess_of(*claim_.reading) : guess_of(*claim_.reading);
  }

  /// It fails as it was read, and that is a guess, or holds in a case only.
  void doubted() {
    const std::optional<Obstacle> of_reading = own_guess();
    const Obstacle& guess = of_reading ? *of_reading : *claim_.doubt;
    const bool restricted = guess.kind == DiagnosticKind::restricted;
    judgement_.verdict = restricted ? Verdict::undecided : Verdict::not_understood;
    add(guess.kind, guess.message + "; the equation does not hold in the reading that was tried", guess.help);
  }

  void refuted(const Decision& decision) {
    mark_all_assumptions();
    if (doubts_change()) return law_of_unknown_rates();
    if (rests_on_the_impossible(
            decision, "no sample was found that satisfies all assumptions in force, so none can refute it"))
      return;
    if (may_be_excused()) return;
    if (own_guess() || claim_.alternative) return doubted();
    if (!claim_.for_all && relates_different_averages(tree_, prepared_, cache_))
      return state_law_of(averages_of(prepared_.question));
    // `\sqrt{x^2} = -x`: beside a condition this is an identity for a case, and no law.
    if (claim_.doubt != nullptr && relates_the_same_letters(as_written())) return doubted();
    if (const auto both = component_declared_alone(as_written())) {
      judgement_.verdict = Verdict::not_understood;
      add(DiagnosticKind::ambiguous_reading,
          fmt::format("`{}` is declared as a number of its own, and can be meant as a component of `{}`",
                      both->component, both->vector),
          {fmt::format("without a declaration of `{}` it is the component", both->component)});
      return;
    }
    if (claim_.recorded == nullptr && speaks_of_averages(tree_, prepared_))
      return refuted_about_averages(decision);
    weigh_as_identity(decision);
  }

  void state_law_of(const std::vector<SymbolId>& symbols) {
    judgement_.verdict = Verdict::law;
    judgement_.not_for_all = bases_of(tree_, symbols);
  }

  /// Numbers for averages refute only if there are outcomes that have them.
  void refuted_about_averages(const Decision& decision) {
    const bool asks = claim_.for_all || claim_.equation.relation == Relation::equal;
    const auto shown =
        asks ? refuted_by_two_outcomes(tree_, names_, prepared_, limits_, cache_) : std::nullopt;
    Decision with_outcomes = decision;
    if (shown) with_outcomes.sample = judgement_.sample = shown->sample;
    if (shown) return weigh_as_identity(with_outcomes, shown->outcomes);
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided,
        "it was found to fail only where averages are taken as any numbers, whatever is averaged");
  }

  /// `outcomes`: that show it, if it is about averages.
  void weigh_as_identity(const Decision& decision, const std::string& outcomes = {}) {
    const std::vector<SymbolId> members = members_in(prepared_.question, tree_, names_);
    if (!claim_.for_all && !members.empty()) return state_law_of(members);
    std::vector<SymbolId> law;
    if (!claim_.for_all) law = law_symbols(prepared_.question, names_.scope, restates_definition(), cache_);
    const bool order = claim_.equation.relation != Relation::equal;
    if (!law.empty() && (order || !both_constant(*decision.sample))) {
      state_law_of(law);
      judgement_.despite_given = std::ranges::any_of(prepared_.assumptions, [](const NamedAssumption* each) {
        return each != nullptr && each->origin.directive && each->equation.relation == Relation::equal;
      });
      return;
    }
    if (claim_.doubt != nullptr) return doubted();
    if (speaks_of_open_integral() || may_be_rounded(*decision.sample)) return;
    if (claim_.reading->found.differentiates_logarithm &&
        (order || asks_for_real_numbers(tree_, prepared_.question))) {
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          "it was found to fail only where the logarithm that is differentiated may have no value");
      return;
    }
    if (speaks_of_values(prepared_.question, names_)) {
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          "it was found to fail only where values of a function are taken as any numbers");
      return;
    }
    prepared_.question.tree = &tree_;
    std::optional<SignDoubt> doubt;
    if (!claim_.for_all)
      doubt = doubt_of_signs(tree_, prepared_.question, names_.scope, *decision.sample, cache_);
    if (doubt) {
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided, doubt->reason, std::move(doubt->help));
      return;
    }
    judgement_.verdict = Verdict::refuted;
    judgement_.counterexample = describe(prepared_, *decision.sample);
    Counterexample& example = *judgement_.counterexample;
    if (claim_.swapped) std::swap(example.left, example.right);
    example.squared_distance = claim_.as_a_whole;
    const std::string sides = fmt::format(": left is {}, right is {}", example.left, example.right);
    judgement_.diagnostics.push_back({DiagnosticKind::refuted,
                                      claim_.relation,
                                      difference() + (claim_.as_a_whole ? "" : sides),
                                      {{claim_.left, ""}, {claim_.right, ""}}});
    if (!outcomes.empty())
      judgement_.diagnostics.back().help = {fmt::format("for two outcomes with equal weights: {}", outcomes)};
  }

  /// Operators have no samples, so what is not proved of them is weighed as if it were refuted.
  bool is_law_of_operators() {
    const bool operators =
        has_operators(tree_, claim_.equation.left) || has_operators(tree_, claim_.equation.right);
    if (!operators || assumes_the_impossible() || claim_.equation.relation != Relation::equal) return false;
    law_of_unknown_rates();
    return judgement_.verdict == Verdict::law;
  }

  /// What relates quantities is a law, whether or not they change.
  void law_of_unknown_rates() {
    if (claim_.for_all || own_guess() || claim_.doubt != nullptr) return;
    std::vector<SymbolId> law = law_symbols(prepared_.question, names_.scope, restates_definition(), cache_);
    if (law.empty()) law = prepared_.parameters;
    if (law.empty()) return;
    state_law_of(law);
    judgement_.diagnostics.clear();
  }

  /// An assumption could not be read, or not all that it says was looked at: it may make the claim true.
  bool may_be_excused() {
    if (const UnreadAssumption* unread = unread_assumption(tree_, names_, prepared_.question)) {
      judgement_.used.insert(unread->directive);
      judgement_.verdict = Verdict::undecided;
      add(DiagnosticKind::undecided,
          fmt::format("it was found to fail, but `{}` could not be read and may make it true", unread->text));
      return true;
    }
    if (prepared_.unmatched == nullptr) return false;
    judgement_.verdict = Verdict::undecided;
    add(DiagnosticKind::undecided,
        fmt::format("`{}` holds at all times and places, but was used at a few only",
                    prepared_.unmatched->origin.text));
    return true;
  }

  std::string difference() const {
    if (claim_.as_a_whole) return "the sides are equal, component by component";
    if (claim_.equation.relation != Relation::equal) return "the order does not hold";
    if (!claim_.derived_by.empty()) return fmt::format("the derivatives by `{}` differ", claim_.derived_by);
    if (!claim_.nearly) return "the sides differ";
    return first_order_ ? "the first-order parts differ" : "the sides differ where everything small is 0";
  }

  ExprTree& tree_;
  const Names& names_;
  const Claim& claim_;
  Limits limits_;
  DecisionCache* cache_;
  Prepared prepared_;
  bool first_order_ = false;
  Judgement judgement_;
};

}  // namespace

Judgement judge(ExprTree& tree, const Names& names, const Claim& claim, const Limits& limits,
                DecisionCache* cache) {
  if (claim.derived_by.empty() && counts_to_letters(tree, names, claim.equation))
    return judge_counted(tree, names, claim, limits, cache);
  return judge_at_once(tree, names, claim, limits, cache);
}

Judgement judge_at_once(ExprTree& tree, const Names& names, const Claim& claim, const Limits& limits,
                        DecisionCache* cache) {
  if (claim.derived_by.empty()) {
    Judgement judgement = Judging(tree, names, claim, limits, cache).judge();
    if (judgement.verdict != Verdict::law || names.scope.families.empty() || limits.only_proofs)
      return judgement;
    // What fails whatever the members of families are is refuted without them.
    Judgement without = Judging(tree, without_members(names), claim, limits, cache).judge();
    return without.verdict == Verdict::refuted ? without : judgement;
  }
  // The derivatives are meant for every value of the variable, whatever it is elsewhere: `t = 5`.
  Names free = names;
  if (const auto variable = find_symbol(names.symbols, {claim.derived_by, 0, false}))
    forget_definition(free.scope, *variable);
  return Judging(tree, free, claim, limits, cache).judge();
}

std::optional<Sample> sample_of_assumptions(ExprTree& tree, const Names& names, const Sample& known,
                                            const Limits& limits, DecisionCache* cache) {
  if (names.scope.assumptions.empty()) return Sample{};
  const Equation last = names.scope.assumptions.back().equation;
  Question question = prepare(tree, names, last).question;
  question.assumptions.push_back(last);  // also where it speaks of no symbol: 0 = 1
  return satisfying_sample(cache, question, known, limits);
}

}  // namespace rigor
