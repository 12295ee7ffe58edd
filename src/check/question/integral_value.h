// SPDX-License-Identifier: GPL-3.0-or-later
// What an integral between limits is, as an expression. Term by term it is the difference of an
// antiderivative at the limits, which is differentiated and compared exactly. A term without one keeps an
// unknown primitive function of its own: K_f(b) − K_f(a), where K_f' = f. So integrals are linear in what is
// integrated, change their sign with their limits and add up over intervals, whether or not they are known;
// and K_f(b) differentiates by Leibniz's rule. An integral is taken to exist: where a divisor could vanish
// between the limits, that it does not is a condition.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/calculus/differentiate.h"
#include "expr/calculus/integrate.h"
#include "expr/statement/statement.h"

namespace rigor {

struct IntegralValue {
  ExprId value{};
  std::vector<Equation> conditions = {};      // without which it does not exist
  std::vector<std::string> said = {};         // that it rests on
  std::vector<SymbolId> taken_constant = {};  // though nothing says so, and no variable stands beside them
  std::optional<std::string> open = {};       // why not all of its value is known: then nothing is refuted
};

/// The integrals of one question.
class IntegralValues {
 public:
  using MayRun = std::function<bool(SymbolId)>;  // can it change, as far as the section shows?

  IntegralValues(ExprTree& tree, const Names& names, MayRun may_run)
      : tree_(tree), names_(names), may_run_(std::move(may_run)) {}

  /// The integrand and the limits have their definitions put in. Nothing where it cannot be read so.
  [[nodiscard]] std::optional<IntegralValue> value(const Integral& integral, Span span);

  /// The same of a sum over whole numbers.
  [[nodiscard]] std::optional<IntegralValue> sum(const Integral& sum, Span span);

  /// The derivative of an unknown primitive at its upper limit: f(b)·b' + ∫ f'.
  using Derivative = std::function<std::optional<ExprId>(ExprId)>;
  [[nodiscard]] std::optional<ExprId> derivative(SymbolId primitive, const Derivative& by);

  /// The assumptions that values so far rest on: `a > 0` of `\int_0^\infty e^{-ax}\,dx`.
  [[nodiscard]] const std::vector<const NamedAssumption*>& relied_on() const { return relied_on_; }

  /// The variable of all unknown primitives, and values there of functions of nothing else: they never
  /// change.
  [[nodiscard]] bool is_bound(SymbolId symbol) const;

 private:
  [[nodiscard]] bool is_end_of(const Integral& integral, SymbolId symbol) const;
  [[nodiscard]] Running running_over(const Integral& integral) const;
  [[nodiscard]] bool changes_with(SymbolId variable, SymbolId symbol, bool shown) const;
  [[nodiscard]] ExprId bare(const Integral& integral) const;
  [[nodiscard]] std::optional<ExprId> function_of_rate(const Integral& integral, ExprId rate) const;
  [[nodiscard]] std::optional<ExprId> at(ExprId id, const Running& running, ExprId value);
  std::optional<ExprId> symbol_at(ExprId id, const Running& running, ExprId value);
  SymbolId value_named(const std::string& name, ExprId node, const Running& running, ExprId argument,
                       ExprId value);
  [[nodiscard]] std::pair<std::vector<ExprId>, bool> without_minus(ExprId rate) const;
  std::optional<ExprId> at_limit(const Primitive& primitive, const Running& running, const Limit& limit,
                                 Span span);
  bool goes_on(const IntegrandTerm& term, const Running& running, const Integral& integral, Span span,
               IntegralValue& result);
  bool keeps_its_sign(ExprId linear, const Running& running, const Integral& integral, Span span,
                      IntegralValue& result);
  std::optional<std::pair<ExprId, ExprId>> known_term(const IntegrandTerm& term, const Running& running,
                                                      const Integral& integral, Span span);
  std::optional<ExprId> unknown_at(ExprId integrand, const Running& running, const Limit& limit, Span span);
  std::optional<ExprId> unknown(ExprId integrand, const Running& running, const Integral& integral,
                                Span span);
  struct Parts {
    ExprId primitive{};
    ExprId difference{};  // of it, between the limits
    std::vector<IntegrandTerm> rest = {};
  };
  std::optional<Parts> by_parts(const IntegrandTerm& term, const Running& running, const Integral& integral,
                                Span span);
  Differentiator differentiator(const Integral& integral, const Running& running, DerivativeBudget& budget);
  bool is_primitive(const Integral& integral, const Running& running, ExprId primitive, ExprId rest);
  [[nodiscard]] Decision ask(Equation claim);
  [[nodiscard]] bool holds(const Equation& claim) { return ask(claim).outcome == Outcome::proved; }
  [[nodiscard]] bool are_equal(ExprId a, ExprId b) const;
  ExprId difference(ExprId upper, ExprId lower, Span span);
  ExprId negative(ExprId id, Span span);

  // of Gaussians
  std::optional<ExprId> gaussian(const IntegrandTerm& term, const Running& running, const Integral& integral,
                                 Span span, IntegralValue& result);
  std::optional<std::array<ExprId, 3>> quadratic(ExprId argument, const Running& running, Span span);
  [[nodiscard]] std::optional<int> power_of_variable(const std::vector<ExprId>& factors,
                                                     const Running& running) const;
  ExprId circle_number(Span span);
  bool is_positive(ExprId id, Span span, IntegralValue& result);

  // of sums
  [[nodiscard]] Running counting_over(const Integral& sum) const;
  ExprId plus(ExprId id, int number, Span span);
  ExprId total(const std::vector<ExprId>& parts, Span span);
  std::optional<ExprId> written_out(ExprId summand, const Running& running, ExprId first, int count,
                                    Span span);
  std::optional<int> shift_between(ExprId a, ExprId b, Span span);
  std::optional<ExprId> unknown_sum_before(ExprId summand, const Running& running, const Limit& limit,
                                           Span span);
  bool is_antidifference(const Integral& sum, const Running& running, ExprId found, ExprId rest, Span span);
  void require(const Equation& condition, IntegralValue& result);
  bool differs_from_one(ExprId ratio, Span span, IntegralValue& result);
  bool falls(ExprId ratio, Span span, IntegralValue& result);

  ExprTree& tree_;
  const Names& names_;
  MayRun may_run_;
  std::optional<SymbolId> bound_;
  std::map<std::string, SymbolId> values_;
  struct Source {
    ExprId node{};
    SymbolId variable{};
  };
  std::map<SymbolId, Source> sources_;  // of values at the bound variable: what has them, and for which
  std::vector<SymbolId> unknown_;
  std::vector<const NamedAssumption*> relied_on_;
  std::optional<std::string> sign_ = {};  // that would have to be known
  bool knows_values_ = true;              // no value of a function was needed that the notes do not write
};

}  // namespace rigor
