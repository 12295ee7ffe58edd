// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "base/among.h"
#include "check/average/average_value.h"
#include "check/question/at_all_times.h"
#include "check/question/base_letters.h"
#include "check/question/integral_value.h"
#include "check/question/running_letters.h"
#include "elaborate/name/function_value.h"
#include "elaborate/name/known_value.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// Of a derivative for which a definition is made: no smaller than what `Differentiator` makes.
constexpr int largest_order = 2 * most_rates + most_axes;

/// This many derivatives compare the coefficients of an assumption at all times or places.
constexpr int most_compared = 3;

class Preparation {
 public:
  Preparation(ExprTree& tree, const Names& names, int slack, Precision precision, int order)
      : tree_(tree),
        names_(names),
        slack_(slack),
        precision_(precision),
        order_(order),
        integrals_(tree, names, [this](SymbolId symbol) { return may_run(symbol); }) {}

  Prepared prepare(Equation claim, std::span<const ExprId> also) {
    for (int k = 0; k < order_; ++k) claim = derived(claim, By::small);
    prepared_.question.tree = &tree_;
    prepared_.question.claim = claim;
    row_ = tree_[claim.left].span;
    follow(claim);
    for (const ExprId each : also) follow(Equation{.left = each, .right = each});
    letter_ = only_letter_differentiated_by(tree_, reached_);
    for (const SymbolId symbol : reached_) {
      highest_reached_[base_of(symbol)].raise_to(orders_of(symbol));
      highest_order_ = std::max(highest_order_, orders_of(symbol).total());
    }
    if (precision_ == Precision::small_order) add_small();
    for (const int beyond : {0, slack_}) {
      beyond_ = beyond;
      for (bool grew = true; grew;) {
        grew = beyond > 0 && follow_rules();
        grew = add_assumptions() || grew;
      }
      if (beyond == 0) prepared_.without_slack = prepared_.question.assumptions.size();
    }
    average_laws_of_operators();
    add_lengths();
    add_conditions();
    prepared_.too_large = budget_.exceeded;
    prepared_.made = DerivativeBudget().nodes - budget_.nodes;
    prepared_.has_rates_or_times =
        has_rates(tree_, prepared_.question.assumptions, letter_) || has_rule() || speaks_of_time_or_place();
    if (slack_ > 0) prepared_.unmatched = unmatched_assumption(tree_, names_, prepared_);
    return std::move(prepared_);
  }

  std::optional<FoundDefinition> value_of(SymbolId symbol, const Equation& claim) {
    prepared_.question.claim = claim;
    return definition_of(symbol, 0);
  }

 private:
  void follow(const Equation& equation) { follow(std::vector{equation.left, equation.right}); }

  void follow(std::vector<ExprId> pending) {
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      for (const SymbolId symbol : symbols_in(tree_, id)) reach(symbol, pending);
    }
  }

  void reach(SymbolId symbol, std::vector<ExprId>& pending) {
    if (!reached_.insert(symbol).second) return;
    highest_reached_[base_of(symbol)].raise_to(orders_of(symbol));
    if (const auto& integral = tree_.symbols[symbol].integral) {
      for (const ExprId part : parts_of(*integral)) pending.push_back(part);
    }
    const auto found = definition_of(symbol, 0);
    if (found) {
      prepared_.question.definitions.push_back(found->definition);
      prepared_.definitions.push_back(found->origin);
      prepared_.put_in.push_back(found->put_in);
      pending.push_back(found->definition.body);
    } else if (is_constant(symbol) || vanishes_to_zeroth_order(symbol)) {
      prepared_.question.zeroed.push_back(symbol);
    }
  }

  // --- rates that are given

  /// A rate that is given stands for what it is, wherever it is met. It is also an assumption on what it is
  /// the rate of, as soon as another one speaks of that.
  bool follow_rules() {
    bool grew = false;
    for (const NamedDefinition& rule : names_.scope.definitions) {
      const SymbolId rate = rule.definition.symbol;
      if (reached_.contains(rate) || !bears(rule)) continue;
      highest_law_ = std::max(highest_law_, orders_of(rate).total());
      std::vector<ExprId> pending;
      reach(rate, pending);
      follow(std::move(pending));
      grew = true;
    }
    return grew;
  }

  [[nodiscard]] bool has_rule() {
    return std::ranges::any_of(names_.scope.definitions,
                               [this](const NamedDefinition& rule) { return bears(rule); });
  }

  /// Does an assumption speak of what the rate is of, and the question of either?
  bool bears(const NamedDefinition& rule) {
    const SymbolId rate = rule.definition.symbol;
    if (orders_of(rate).total() == 0 || !is_assumed_of(tree_, names_.scope, base_of(rate))) return false;
    return is_reached(base_of(rate)) ||
           std::ranges::any_of(symbols_in(tree_, rule.definition.body),
                               [this](SymbolId each) { return is_reached(base_of(each)); });
  }

  [[nodiscard]] bool is_reached(SymbolId base) const { return highest_reached_.contains(base); }

  // --- times and places

  [[nodiscard]] bool speaks_of_time_or_place() {
    return std::ranges::any_of(prepared_.assumptions, [this](const NamedAssumption* named) {
      return named != nullptr &&
             (runs_with_time(tree_, names_, named->equation) || speaks_of_place(named->equation));
    });
  }

  bool speaks_of_place(const Equation& equation) {
    if (equation.relation != Relation::equal) return false;
    return std::ranges::any_of(symbols_of(equation), [&](SymbolId each) {
      return is_free_variable(names_, tree_, each, By::space);
    });
  }

  /// What speaks of the time itself says something of each moment: how often it is differentiated, so that
  /// as many constants as it has can be found, or what it shares with another assumption.
  int orders_to_compare(const NamedAssumption& assumption) {
    const Equation& equation = assumption.equation;
    if (!runs_with_time(tree_, names_, equation)) return 0;
    int constants = 0;
    for (const SymbolId symbol : symbols_of(equation)) {
      const auto kind = dependence(symbol, By::time).kind;
      if (kind == Dependence::Kind::varies && !definition_of(symbol, 0))
        return is_assumed_of(tree_, names_.scope, base_of(symbol), &assumption) ? beyond_ : 0;
      constants += kind == Dependence::Kind::constant ? 1 : 0;
    }
    return std::clamp(constants - 1, beyond_, most_compared);
  }

  /// An assumption about constants at all places is differentiated by coordinates as often.
  int places_to_compare(const NamedAssumption& assumption) {
    constexpr int most_by_place = 2;
    if (!speaks_of_place(assumption.equation)) return 0;
    for (const SymbolId symbol : symbols_of(assumption.equation)) {
      if (definition_of(symbol, 0)) continue;
      const bool place = is_free_variable(names_, tree_, symbol, By::space);
      const bool constant = dependence(symbol, By::space).kind == Dependence::Kind::constant;
      if (place ? !is_for_all(names_.scope, symbol) : !constant) return 0;
    }
    return most_by_place;
  }

  // --- definitions

  std::optional<FoundDefinition> definition_of(SymbolId symbol, int depth) {
    if (const NamedDefinition* named = rigor::definition_of(names_.scope, symbol))
      return FoundDefinition{named->definition, &named->origin, named->at_instant, {}, named->along};
    if (depth > largest_order) return std::nullopt;
    if (const auto known = derived_.find(symbol); known != derived_.end()) return known->second;
    std::optional<FoundDefinition> result;
    const auto* value = names_.symbols.function_values.find(symbol);
    const auto member = value == nullptr ? membership_of(names_, symbol) : std::nullopt;
    if (const auto& integral = tree_.symbols[symbol].integral; value != nullptr || member || integral) {
      derived_[symbol] =
          std::nullopt;  // y(0) of `y = y(0)e^{kx}` says nothing of itself, nor E_1 of `n^2E_1`
      std::vector<const Origin*> around = std::exchange(put_in_, {});
      if (value != nullptr) {
        const auto of = definition_of(value->second.of, depth + 1);
        if (of) result = value_of_function(tree_, names_, symbol, value->second, *of, known_values());
      } else {
        result = member              ? value_of_member(tree_, names_, symbol, *member, known_values())
                 : integral->average ? of_average(symbol)
                                     : of_integral(symbol);
      }
      std::swap(around, put_in_);
      if (result) result->put_in = std::move(around);
      return derived_[symbol] = result;
    }
    const auto& derivation = tree_.symbols[symbol].derivation;
    if (!derivation || derivation->by.size() > largest_order) return std::nullopt;
    if (derivation->by.size() == 1 && is_unknown_primitive(derivation->base))
      return derived_[symbol] = of_unknown_primitive(symbol, *derivation);
    for (auto by = derivation->by.rbegin(); by != derivation->by.rend() && !result; ++by) {
      const auto of = definition_of(parent_of(*derivation, *by), depth + 1);
      if (of && of->at_instant && *by == By::time) {
        note_unknown(derivation->base);
      } else if (of) {
        result = of;
        result->definition = differentiated(*of, symbol, *by);
      }
    }
    derived_[symbol] = result;
    return result;
  }

  // --- integrals

  [[nodiscard]] bool is_unknown_primitive(SymbolId symbol) const {
    const auto& integral = tree_.symbols[symbol].integral;
    return integral && !integral->lower && integral->upper && !integral->sum;
  }

  std::optional<FoundDefinition> of_integral(SymbolId symbol) {
    static const Origin by_primitives{"antiderivatives, which were differentiated", ""};
    static const Origin by_differences{"sums, written out or checked by their differences", ""};
    Integral integral = *tree_.symbols[symbol].integral;
    if (!integral.lower) return std::nullopt;
    const auto inside = opened(integral.integrand, integral.variable);
    const bool is_defined = definition_of(integral.variable, 0).has_value();
    const bool nests = std::ranges::any_of(letters_in(tree_, integral.integrand), [&](SymbolId each) {
      return tree_.symbols[each].integral.has_value();
    });
    bool plain =
        inside.has_value() && !(is_defined && nests) && !hides_variable(names_, tree_, integral, *inside);
    for (Limit* limit : {&*integral.lower, &*integral.upper}) {
      if (!limit->at) continue;
      const auto end = opened(*limit->at);
      plain = plain && end.has_value();
      if (end) limit->at = *end;
    }
    if (plain) integral.integrand = *inside;
    const Span span = tree_.symbols[symbol].first_seen;
    auto value = !plain         ? std::nullopt
                 : integral.sum ? integrals_.sum(integral, span)
                                : integrals_.value(integral, span);
    prepared_.open_sum = prepared_.open_sum || integral.sum;
    if (!value || is_one_of(symbol, symbols_in(tree_, value->value))) {
      prepared_.open_integral = "its value is not known, or there may be none";
      return std::nullopt;
    }
    for (const SymbolId constant : value->taken_constant) {
      note_unknown(constant);
      note_held(constant, integral.variable);
    }
    for (Equation& condition : value->conditions) {
      conditions_.push_back(std::move(condition));
      if (!integral.sum) value->said.push_back(fmt::format("`{}` exists", tree_.symbols[symbol].name));
    }
    std::ranges::move(value->said, std::back_inserter(prepared_.conventions));
    if (value->open) prepared_.open_integral = std::move(value->open);
    return FoundDefinition{
        {symbol, {}, no_particle, value->value}, integral.sum ? &by_differences : &by_primitives, false};
  }

  std::optional<FoundDefinition> of_average(SymbolId symbol) {
    static const Origin by_linearity{"averages are linear", ""};
    prepared_.open_average = true;
    const auto found =
        value_of_average(tree_, names_, symbol, [this](ExprId inside) { return opened(inside); });
    if (!found) return std::nullopt;
    std::ranges::copy_if(found->conventions, std::back_inserter(prepared_.conventions),
                         [this](const auto& each) { return !is_one_of(each, prepared_.conventions); });
    return FoundDefinition{{symbol, {}, no_particle, found->value}, &by_linearity, false};
  }

  /// To averages, laws of operators say what their own averages are.
  void average_laws_of_operators() {
    const auto speaks = [this](const Equation& each) {
      return has_operators(tree_, each.left) || has_operators(tree_, each.right);
    };
    if (!prepared_.open_average || speaks(prepared_.question.claim)) return;
    const std::vector<Equation> laws = std::exchange(prepared_.question.assumptions, {});
    const std::vector<const NamedAssumption*> origins = std::exchange(prepared_.assumptions, {});
    for (std::size_t k = 0; k < laws.size(); ++k) {
      std::optional<Equation> law = laws[k];
      if (speaks(*law)) {
        prepared_.has_laws_of_operators = true;
        const bool always = origins[k] == nullptr || !origins[k]->at_instant;
        const auto open = [this](ExprId inside) { return opened(inside); };
        law = always ? averaged_law(tree_, names_, *law, open) : std::nullopt;
      }
      if (law) push(*law, origins[k]);
    }
    prepared_.without_slack = std::min(prepared_.without_slack, prepared_.assumptions.size());
  }

  /// Leibniz's rule, with which nothing else need be known of it.
  std::optional<FoundDefinition> of_unknown_primitive(SymbolId symbol, const Derivation& derivation) {
    static const Origin by_leibniz{"the derivative of an integral by its limit", ""};
    const Variable by = *derivation.by.begin();
    Definition definition{.symbol = symbol};
    Slot axis;
    if (by == By::space) {
      definition.indices.push_back(tree_.add_index("s"));
      axis = {0, definition.indices.back()};
    }
    Differentiator differentiate = differentiator(by, axis);
    const auto body =
        integrals_.derivative(derivation.base, [&](ExprId id) { return differentiate.derivative(id); });
    if (!body) return std::nullopt;
    definition.body = *body;
    return FoundDefinition{definition, &by_leibniz, false};
  }

  /// Where an integral has no value, the claim says nothing.
  void add_conditions() {
    prepared_.integrals_rest_on = integrals_.relied_on();
    prepared_.exists_under = prepared_.question.assumptions.size();
    for (const Equation& condition : conditions_) push(condition, nullptr);
    if (conditions_.empty()) prepared_.exists_under.reset();
  }

  KnownValues known_values() {
    return {.open = [this](ExprId body, const IsHeld& held) { return opened(body, {}, held); },
            .may_run = [this](SymbolId each, bool in_time) { return may_run(each, in_time); },
            .is_held =
                [this](const FoundDefinition& of, SymbolId each, const Variable& by) {
                  return is_parameter(names_, tree_, each, by, along_which(names_, of.along, by), row_);
                },
            .claim = prepared_.question.claim};
  }

  /// With its definitions put in, but of what is `held`; nothing where they go too deep, or are of
  /// components. What an integral runs over is `bound`, whatever else its letter means.
  std::optional<ExprId> opened(ExprId body, std::optional<SymbolId> bound = {}, const IsHeld& held = {}) {
    constexpr int deepest = 8;                // definitions of definitions; a circle is none
    constexpr std::uint32_t largest = 4'000;  // nodes
    for (int k = 0; k < deepest && tree_[body].weight < largest; ++k) {
      bool plain = true;
      const ExprId next = replaced(tree_, body, [&](ExprId id) -> std::optional<ExprId> {
        const SymbolId symbol = tree_[id].symbol;
        if (bound == symbol || (held && held(symbol))) return std::nullopt;
        const auto of = definition_of(symbol, 1);
        if (!of) return std::nullopt;
        const bool whole = of->definition.indices.empty() && of->definition.particle == no_particle &&
                           !of->definition.by_square && tree_[id].slot_count == 0;
        plain = plain && whole;
        if (whole) put_in_.push_back(of->origin);
        if (whole) put_in_.insert(put_in_.end(), of->put_in.begin(), of->put_in.end());
        return whole ? std::optional(of->definition.body) : std::nullopt;
      });
      if (!plain) return std::nullopt;
      if (next == body) return body;
      body = next;
    }
    return std::nullopt;
  }

  /// Can it change where the variable does? A quantity whose rate the page writes does.
  bool may_run(SymbolId symbol, bool in_time = false) const {
    if (tree_.symbols[symbol].derivation) return true;
    if (names_.symbols.function_values.contains(symbol)) return false;
    const NameKey* key = key_of(names_.symbols, symbol);
    const auto may_change = in_time ? may_be_changing_in_time : may_be_changing;
    return key != nullptr && may_change(*names_.symbols.evidence, key->base);
  }

  /// The derivative of one order less.
  SymbolId parent_of(Derivation derivation, const Variable& by) {
    derivation.by.erase(by);
    return tree_.symbols.derivative(derivation);
  }

  Definition differentiated(const FoundDefinition& of, SymbolId symbol, const Variable& by) {
    Definition result = of.definition;
    result.symbol = symbol;
    result.by_square = false;
    const std::vector<SymbolId> along = along_which(names_, of.along, by);
    if (by != By::space) {
      result.body = differentiator(by, {}, along).derivative_or_zero(of.definition.body);
      return result;
    }
    std::vector<Slot> slots;
    if (result.indices.empty()) {
      for (int axis = 0; axis < tree_[result.body].rank; ++axis) {
        result.indices.push_back(tree_.add_index("i", tree_[result.body].axes[axis]));
        slots.push_back({0, result.indices.back()});
      }
    }
    result.indices.push_back(tree_.add_index("s"));
    const ExprId body =
        differentiator(by, {0, result.indices.back()}, along).derivative_or_zero(of.definition.body);
    result.body = component_of(tree_, body, slots);
    return result;
  }

  /// `along`: what the quantity that is differentiated is written with, so that its parameters are held.
  Differentiator differentiator(const Variable& by, Slot axis = {}, const std::vector<SymbolId>& along = {}) {
    const auto dependence_of = [this, by, along](SymbolId symbol) {
      if (integrals_.is_bound(symbol)) return Dependence{Dependence::Kind::constant};
      const Dependence dependence = this->dependence(symbol, by);
      const bool varies = dependence.kind == Dependence::Kind::varies;
      if (varies && is_parameter(names_, tree_, symbol, by, along, row_)) {
        note_parameter(symbol, along[0]);
        note_unknown(symbol);  // nothing is refuted by a convention
        return Dependence{Dependence::Kind::constant};
      }
      const bool guessed = varies && !knows_change(names_, tree_, symbol, by);
      if (guessed) note_unknown(symbol);
      return dependence;
    };
    return {tree_, by, dependence_of, budget_, axis};
  }

  Dependence dependence(SymbolId symbol, const Variable& by) {
    const KnownChange known = change(names_, tree_, symbol, by);
    if (known.directive) prepared_.used.insert(*known.directive);
    return known.dependence;
  }

  void note_unknown(SymbolId symbol) {
    if (!is_one_of(symbol, prepared_.unknown_changes)) prepared_.unknown_changes.push_back(symbol);
  }

  void note_parameter(SymbolId symbol, SymbolId along) {
    note_held(symbol, along);
    prepared_.parameters.push_back(symbol);
  }

  void note_held(SymbolId symbol, SymbolId along) {
    auto held =
        fmt::format("`{}` does not change with `{}`", tree_.symbols[symbol].name, tree_.symbols[along].name);
    if (!is_one_of(held, prepared_.conventions)) prepared_.conventions.push_back(std::move(held));
  }

  /// A derivative of something that does not change.
  bool is_constant(SymbolId symbol) {
    const auto& derivation = tree_.symbols[symbol].derivation;
    if (!derivation) return false;
    return std::any_of(derivation->by.begin(), derivation->by.end(), [&](const Variable& by) {
      return dependence(derivation->base, by).kind == Dependence::Kind::constant;
    });
  }

  /// A small quantity, or its rate, where that is a symbol of its own.
  bool vanishes_to_zeroth_order(SymbolId symbol) const {
    if (precision_ != Precision::small_order) return false;
    if (tree_.symbols[symbol].order(By::small) > 0) return false;
    return std::ranges::any_of(names_.scope.small, [&](const SmallQuantity& small) {
      const ExprNode& node = tree_[small.quantity];
      return node.slot_count == 0 && node.symbol == base_of(symbol);
    });
  }

  // --- assumptions

  SymbolId base_of(SymbolId symbol) const { return rigor::base_of(tree_.symbols, symbol); }

  Orders orders_of(SymbolId symbol) const { return rigor::orders_of(tree_.symbols[symbol], letter_); }

  /// An equation with a derivative by x is one for all x, and so is `y^2 = ax` beside `dy/dx`.
  [[nodiscard]] bool runs_with_letter(const std::vector<SymbolId>& symbols) const {
    return std::ranges::any_of(symbols, [&](SymbolId own) { return orders_of(own).letter > 0; }) ||
           (letter_ && is_one_of(letter_->letter, symbols));
  }

  /// What an equation is about, definitions unfolded.
  const std::vector<SymbolId>& symbols_of(const Equation& equation) {
    std::vector<SymbolId>& symbols = symbols_of_[{equation.left, equation.right}];
    if (!symbols.empty()) return symbols;
    return symbols = symbols_reached(tree_, {equation.left, equation.right}, [this](SymbolId symbol) {
             const auto found = definition_of(symbol, 0);
             return found ? std::optional(found->definition.body) : std::nullopt;
           });
  }

  /// One round over the assumptions; true if something was added.
  bool add_assumptions() {
    bool grew = false;
    for (const NamedAssumption& assumption : names_.scope.assumptions) {
      if (!is_joined(tree_, names_.scope, assumption.equation))
        grew = add(assumption.equation, &assumption) || grew;
    }
    for (const SmallQuantity& small : names_.scope.small) {
      const ExprNode node = tree_[small.quantity];
      const bool constrained = node.slot_count > 0 || definition_of(node.symbol, 0).has_value();
      if (precision_ == Precision::small_order && constrained) grew = add(vanishing(small), nullptr) || grew;
    }
    return grew;
  }

  Equation vanishing(const SmallQuantity& small) {
    const auto [entry, fresh] = vanishing_.try_emplace(small.quantity);
    Equation& known = entry->second;
    if (fresh) {
      const ExprNode node = tree_[small.quantity];
      known.left = small.quantity;
      known.right = zero_of_rank(tree_, node.span, node.rank, node.axes);
      known.particles = small.particles;
    }
    return known;
  }

  /// The assumption and those of its derivatives that speak of what was reached; one without symbols always.
  bool add(const Equation& equation, const NamedAssumption* named) {
    const std::vector<SymbolId>& symbols = symbols_of(equation);
    Orders wanted{-1, -1, -1};
    Orders highest;
    int own_order = 0;
    for (const SymbolId own : symbols) {
      const Orders its = orders_of(own);
      own_order = std::max(own_order, its.total());
      const auto found = highest_reached_.find(base_of(own));
      if (found == highest_reached_.end()) continue;
      const Orders& reached = found->second;
      wanted.raise_to({reached.time - its.time, reached.space - its.space, reached.letter - its.letter});
      highest.raise_to({reached.time, reached.space, 0});
    }
    if (!symbols.empty() && wanted.time < 0 && wanted.space < 0 && wanted.letter < 0) return false;
    if (!runs_with_letter(symbols)) wanted.letter = 0;
    const bool of_a_rate = named != nullptr && named->rate_of;
    if (of_a_rate && !is_reached(*named->rate_of) &&
        !is_assumed_of(tree_, names_.scope, *named->rate_of, named))
      return false;
    // Derivatives beyond what was reached can speak of it, as the second one of x² = 0 does of ẋ.
    if (wanted.time >= 0 && highest.time > 0) wanted.time += beyond_;
    if (wanted.space >= 0 && highest.space > 0) wanted.space += beyond_;
    int compared = 0;
    if (beyond_ > 0 && named != nullptr) compared = orders_to_compare(*named);
    wanted.time = std::max(wanted.time, compared);
    const int by_place = beyond_ > 0 && named != nullptr ? places_to_compare(*named) : 0;
    wanted.space = std::max(wanted.space, by_place);
    compared = std::max(compared, by_place);
    if (equation.relation != Relation::equal) wanted = {};
    if (named != nullptr && named->at_instant) {
      wanted = {};
      if (highest_order_ + beyond_ > 0 && !symbols.empty()) note_unknown(symbols[0]);
    }
    bool grew = false;
    // Laws of different orders in the same quantities meet at the highest of them.
    highest_law_ = std::max(highest_law_, own_order);
    const int highest_wanted =
        beyond_ > 0 ? std::max(highest_order_ + beyond_, highest_law_) : highest_order_;
    const int more = std::max({highest_wanted - own_order, compared, 0});
    for (int time = 0; time <= std::clamp(wanted.time, 0, more); ++time) {
      for (int space = 0; space <= std::clamp(wanted.space, 0, more - time); ++space)
        grew = take(equation, named, {time, space}, own_order) || grew;
    }
    for (int letter = 1; letter <= std::clamp(wanted.letter, 0, more); ++letter)
      grew = take(equation, named, {0, 0, letter}, own_order) || grew;
    return grew;
  }

  bool take(const Equation& equation, const NamedAssumption* named, Orders orders, int own_order) {
    const std::tuple key(equation.left, equation.right, orders.time, orders.space, orders.letter);
    const bool compares = beyond_ > 0 && named != nullptr && !named->at_instant && !at_zero_.contains(key);
    if (taken_.contains(key) && !compares) return false;
    const bool fresh = taken_.insert(key).second;
    const std::size_t unknown_before = prepared_.unknown_changes.size();
    Equation changed = equation;
    for (int k = 0; k < orders.time; ++k) changed = derived(changed, By::time);
    for (int k = 0; k < orders.space; ++k) changed = derived(changed, By::space);
    for (int k = 0; k < orders.letter; ++k) changed = derived(changed, *letter_);
    if (compares) at_zero_.insert(key);
    if (compares) push_at_zero(changed, named);
    if (!fresh) {
      prepared_.unknown_changes.resize(unknown_before);
      return true;
    }
    push(changed, named);
    const bool at_zero_only = named == nullptr;  // what is small vanishes to zeroth order only
    for (int k = 0; k < order_ && !at_zero_only && changed.relation == Relation::equal; ++k) {
      changed = derived(changed, By::small);
      push(changed, named);
    }
    // beyond the claim's own orders it is not the notes that differentiate
    if (orders.total() + own_order > highest_order_) prepared_.unknown_changes.resize(unknown_before);
    return true;
  }

  void push(const Equation& equation, const NamedAssumption* named) {
    if (tree_.is_zero_literal(equation.left) && tree_.is_zero_literal(equation.right)) return;
    prepared_.question.assumptions.push_back(equation);
    prepared_.assumptions.push_back(named);
    follow(equation);
  }

  /// What holds at all times holds at t = 0, too.
  void push_at_zero(const Equation& equation, const NamedAssumption* named) {
    if (auto at_zero = at_time_zero(tree_, names_, equation)) push(*at_zero, named);
  }

  Equation derived(const Equation& equation, const Variable& by) {
    Equation result = equation;
    Slot axis;
    if (by == By::space) {
      result.indices.insert(result.indices.begin(), tree_.add_index("s"));
      axis = {0, result.indices.front()};
    }
    const bool by_letter = by.by == By::letter;
    Differentiator differentiate = differentiator(by, axis, std::vector(by_letter ? 1 : 0, by.letter));
    result.left = differentiate.derivative_or_zero(equation.left);
    result.right = differentiate.derivative_or_zero(equation.right);
    return result;
  }

  /// Small quantities concern the claim through the question's definitions, too.
  void add_small() {
    for (const SmallQuantity& small : names_.scope.small) prepared_.used.insert(small.directive);
  }

  /// n·n = 1 for all times makes n·ṅ = 0. A rotation's rate is not reasoned about.
  void add_lengths() {
    std::map<SymbolId, Derivation::Variables> highest;
    for (const SymbolId symbol : reached_) {
      const auto& derivation = tree_.symbols[symbol].derivation;
      if (!derivation || definition_of(symbol, 0) || is_constant(symbol)) continue;
      const Symbol& base = tree_.symbols[derivation->base];
      if (base.rotation) note_unknown(derivation->base);
      if (!base.unit || rigor::definition_of(names_.scope, derivation->base) != nullptr) continue;
      Derivation::Variables& known = highest[derivation->base];
      for (const Variable& each : derivation->by) {
        if (known.count(each) < derivation->by.count(each)) known.insert(each);
      }
    }
    for (const auto& [base, variables] : highest) add_length(base, variables);
  }

  void add_length(SymbolId base, const Derivation::Variables& variables) {
    const Equation equation = length_is_one(tree_, base);
    const std::size_t unknown_before = prepared_.unknown_changes.size();
    Equation changed;
    for (auto by = variables.begin(); by != variables.end(); ++by) {
      const bool first = by == variables.begin() || *by != *std::prev(by);
      changed = derived(first ? equation : changed, *by);
      push(changed, nullptr);
    }
    prepared_.unknown_changes.resize(unknown_before);
  }

  ExprTree& tree_;
  const Names& names_;
  int slack_;
  Precision precision_;
  int order_;
  Prepared prepared_;
  Span row_;  // of the claim
  DerivativeBudget budget_;
  std::set<SymbolId> reached_;
  std::map<SymbolId, Orders> highest_reached_;  // of each letter and its derivatives
  std::optional<Variable> letter_;
  int highest_order_ = 0;  // of a derivative in the claim, definitions unfolded
  int highest_law_ = 0;    // of a derivative in an assumption as it stands
  int beyond_ = 0;         // how far above it derivatives of assumptions are taken: 0, then `slack_`
  std::map<SymbolId, std::optional<FoundDefinition>> derived_;
  std::vector<const Origin*> put_in_;  // by `opened`, into what is made
  IntegralValues integrals_;
  std::vector<Equation> conditions_;  // without which they do not exist
  std::map<ExprId, Equation> vanishing_;
  std::set<std::tuple<ExprId, ExprId, int, int, int>> taken_;
  std::set<std::tuple<ExprId, ExprId, int, int, int>> at_zero_;
  std::map<std::pair<ExprId, ExprId>, std::vector<SymbolId>> symbols_of_;
};

}  // namespace

Prepared prepare(ExprTree& tree, const Names& names, const Equation& claim, int slack, Precision precision,
                 int order, std::span<const ExprId> also) {
  return Preparation(tree, names, slack, precision, order).prepare(claim, also);
}

void define_members(ExprTree& tree, Names& names, const Equation& equation) {
  for (const SymbolId each : symbols_reached(tree, names.scope, {equation.left, equation.right})) {
    const SymbolId base = base_of(tree.symbols, each);
    if (definition_of(names.scope, base) != nullptr || !membership_of(names, base)) continue;
    const auto found = Preparation(tree, names, 0, Precision::exact, 0).value_of(base, equation);
    if (found) define(names.scope, {found->definition, *found->origin, 0, found->at_instant});
  }
}

bool speaks_of_derivatives(const Prepared& prepared) { return prepared.has_rates_or_times; }

}  // namespace rigor
