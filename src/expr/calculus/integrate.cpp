// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/integrate.h"

#include <algorithm>
#include <string>
#include <utility>

#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

constexpr std::size_t most_integrand_terms = 200;
constexpr int most_exponent = 64;
constexpr int highest_power = 12;  // that is multiplied out, or integrated by parts

/// slope · x + shift; a slope of none is 0.
struct Linear {
  std::optional<ExprId> slope = {};
  std::optional<ExprId> shift = {};
};

/// u^{twice/2} of a linear u.
struct LinearPower {
  ExprId base{};
  Linear linear;
  int twice = 0;
};

struct Wave {
  bool sine = false;
  Linear argument;
};

/// A term's factors with the variable, by their kind.
/// 1/(c + s x²), or 1/√(c + s x²).
struct Quadratic {
  ExprId constant{};
  ExprId slope{};
  bool under_root = false;
};

struct Factors {
  int power = 0;  // of the variable
  std::vector<LinearPower> powers = {};
  std::optional<Linear> exponent = {};
  std::vector<Wave> waves = {};
  std::optional<Quadratic> quadratic = {};
  std::optional<Linear> logarithm = {};  // of it
  std::vector<ExprId> others = {};
  int count = 0;  // of all factors
};

class Integrator {
 public:
  Integrator(ExprTree& tree, const Running& running, Span span)
      : tree_(tree), running_(running), span_(span) {}

  using Terms = std::optional<std::vector<IntegrandTerm>>;

  Terms terms(ExprId id) {
    if (tree_[id].rank != 0) return std::nullopt;
    if (!runs(id)) return std::vector{IntegrandTerm{.constant = {id}}};
    const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
    switch (tree_[id].op) {
      case Op::add:
        return of_sum(children);
      case Op::negate:
        return times(std::vector{IntegrandTerm{.constant = {negative(number(1))}}}, terms(children[0]));
      case Op::multiply: {
        Terms product = std::vector{IntegrandTerm{}};
        for (const ExprId child : children) product = times(std::move(product), terms(child));
        return product;
      }
      case Op::divide:
        return times(terms(children[0]), terms(power(children[1], -1)));
      case Op::power:
        return of_power(id, children[0]);
      case Op::symbol:
      case Op::function:
      case Op::root:
        return std::vector{IntegrandTerm{.running = {id}}};
      default:
        return std::nullopt;
    }
  }

  std::optional<Primitive> primitive(const IntegrandTerm& term) {
    const auto factors = factors_of(term);
    if (!factors) return std::nullopt;
    const bool waves = !factors->waves.empty();
    const bool algebraic = !waves && !factors->exponent;
    if (factors->quadratic)
      return factors->count == 1 ? std::optional(of_quadratic(*factors->quadratic)) : std::nullopt;
    if (factors->logarithm) return factors->count == 1 ? of_logarithm(*factors->logarithm) : std::nullopt;
    if (!factors->others.empty()) return of_function(term, *factors);
    if (algebraic && factors->powers.empty()) return of_variable(factors->power);
    if (algebraic && factors->powers.size() == 1) return of_linear_power(factors->power, factors->powers[0]);
    if (!factors->powers.empty() || factors->power < 0 || factors->power > highest_power) return std::nullopt;
    if (!waves) return of_exponential(factors->power, *factors->exponent);
    return of_waves(*factors);
  }

  std::vector<ExprId> divisors(const IntegrandTerm& term) {
    std::vector<ExprId> found;
    for (const ExprId factor : term.running) {
      Factors alone;
      if (!add_factor(factor, alone)) continue;
      if (alone.power < 0) found.push_back(variable());
      for (const LinearPower& each : alone.powers) {
        if (each.twice < -1) found.push_back(each.base);
      }
    }
    return found;
  }

  ExprId product(std::vector<ExprId> factors) {
    std::erase_if(factors, [&](ExprId each) { return is_one(each); });
    if (factors.empty()) return number(1);
    if (factors.size() == 1) return factors[0];
    return tree_.add({.op = Op::multiply, .span = span_}, factors);
  }

 private:
  // --- trees

  ExprId number(int value) { return tree_.add_number(span_, std::to_string(value)); }
  ExprId negative(ExprId id) { return tree_.add({.op = Op::negate, .span = span_}, std::span(&id, 1)); }
  ExprId variable() { return tree_.add({.op = Op::symbol, .span = span_, .symbol = running_.variable}); }
  bool is_one(ExprId id) const { return tree_[id].op == Op::number && tree_.digits(id) == "1"; }

  ExprId over(ExprId above, ExprId below) {
    if (is_one(below)) return above;
    const ExprId parts[] = {above, below};
    return tree_.add({.op = Op::divide, .span = span_}, parts);
  }
  ExprId sum(std::vector<ExprId> terms) {
    if (terms.empty()) return number(0);
    return terms.size() == 1 ? terms[0] : tree_.add({.op = Op::add, .span = span_}, terms);
  }
  ExprId power(ExprId base, int exponent) {
    if (exponent == 0) return number(1);
    if (exponent == 1 || is_one(base)) return base;
    return tree_.add({.op = Op::power, .span = span_, .exponent = exponent}, std::span(&base, 1));
  }
  ExprId half_power(ExprId base, int twice) {
    if (twice % 2 == 0) return power(base, twice / 2);
    const ExprId root = tree_.add({.op = Op::root, .span = span_}, std::span(&base, 1));
    return product({power(base, (twice - 1) / 2), root});
  }
  ExprId apply(Function function, ExprId argument) {
    return tree_.add({.op = Op::function, .span = span_, .function = function}, std::span(&argument, 1));
  }
  ExprId value_of(const Linear& linear) {
    std::vector<ExprId> parts;
    if (linear.slope) parts.push_back(product({*linear.slope, variable()}));
    if (linear.shift) parts.push_back(*linear.shift);
    return sum(std::move(parts));
  }

  // --- terms

  bool runs(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id), [&](SymbolId symbol) {
      return symbol == running_.variable || running_.changes(symbol);
    });
  }
  bool is_variable(ExprId id) const {
    return tree_[id].op == Op::symbol && tree_[id].symbol == running_.variable;
  }

  Terms of_sum(const std::vector<ExprId>& children) {
    std::vector<IntegrandTerm> all;
    for (const ExprId child : children) {
      const Terms more = terms(child);
      if (!more || all.size() + more->size() > most_integrand_terms) return std::nullopt;
      all.insert(all.end(), more->begin(), more->end());
    }
    return all;
  }

  static Terms times(const Terms& a, const Terms& b) {
    if (!a || !b || a->size() * b->size() > most_integrand_terms) return std::nullopt;
    std::vector<IntegrandTerm> all;
    for (const IntegrandTerm& left : *a) {
      for (const IntegrandTerm& right : *b) {
        IntegrandTerm both = left;
        both.constant.insert(both.constant.end(), right.constant.begin(), right.constant.end());
        both.running.insert(both.running.end(), right.running.begin(), right.running.end());
        all.push_back(std::move(both));
      }
    }
    return all;
  }

  /// A power of a product, a quotient or a power is one of its parts; that of a sum is multiplied out.
  Terms of_power(ExprId id, ExprId base) {
    const int exponent = tree_[id].exponent;
    const ExprNode node = tree_[base];
    const std::vector<ExprId> parts(tree_.children(base).begin(), tree_.children(base).end());
    if (std::abs(exponent) > most_exponent || exponent == 0) return std::nullopt;
    Terms result = std::vector{IntegrandTerm{}};
    switch (node.op) {
      case Op::multiply:
        for (const ExprId part : parts) result = times(result, terms(power(part, exponent)));
        return result;
      case Op::divide:
        return times(terms(power(parts[0], exponent)), terms(power(parts[1], -exponent)));
      case Op::negate:
        if (exponent % 2 != 0) result->front().constant.push_back(negative(number(1)));
        return times(result, terms(power(parts[0], exponent)));
      case Op::power:
        return terms(power(parts[0], exponent * node.exponent));
      case Op::absolute:  // `|\psi|^2`
        if (exponent % 2 != 0 || has_complex_numbers(tree_, parts[0])) break;
        return terms(power(parts[0], exponent));
      case Op::function:
        if (node.function != Function::exp) break;
        return terms(
            apply(Function::exp,
                  product({exponent < 0 ? negative(number(-exponent)) : number(exponent), parts[0]})));
      case Op::add: {
        if (exponent < 2 || exponent > highest_power || linear(base)) break;
        const Terms once = terms(base);
        for (int k = 0; k < exponent; ++k) result = times(result, once);
        return result;
      }
      default:
        break;
    }
    return std::vector{IntegrandTerm{.running = {id}}};
  }

  /// αx + β, if it is so.
  std::optional<Linear> linear(ExprId id) {
    const Terms parts = terms(id);
    if (!parts) return std::nullopt;
    std::vector<ExprId> slopes;
    std::vector<ExprId> shifts;
    for (const IntegrandTerm& part : *parts) {
      if (part.running.size() > 1 || (part.running.size() == 1 && !is_variable(part.running[0])))
        return std::nullopt;
      (part.running.empty() ? shifts : slopes).push_back(product(part.constant));
    }
    Linear result;
    if (!slopes.empty()) result.slope = sum(std::move(slopes));
    if (!shifts.empty()) result.shift = sum(std::move(shifts));
    return result;
  }

  // --- kinds of factors

  std::optional<Factors> factors_of(const IntegrandTerm& term) {
    Factors all;
    for (const ExprId factor : term.running) {
      if (!add_factor(factor, all)) return std::nullopt;
    }
    if (all.powers.size() == 1 && is_variable(all.powers[0].base))
      all.powers[0].twice += 2 * std::exchange(all.power, 0);
    return all;
  }

  bool add_factor(ExprId factor, Factors& all) {
    ++all.count;
    int exponent = 1;
    ExprId base = factor;
    if (tree_[factor].op == Op::power) {
      exponent = tree_[factor].exponent;
      base = tree_.children(factor)[0];
    }
    const ExprNode node = tree_[base];
    if (is_variable(base)) {
      all.power += exponent;
      return true;
    }
    if (node.op == Op::root) {
      const ExprId inside = tree_.children(base)[0];
      return add_power(inside, exponent, all) || (exponent == -1 && add_quadratic(inside, true, all));
    }
    if (node.op == Op::function) {
      const auto argument = linear(tree_.children(base)[0]);
      if (!argument || exponent < 1 || exponent > highest_power) return false;
      for (int k = 0; k < exponent; ++k) {
        if (node.function == Function::exp) {
          all.exponent = all.exponent ? added(*all.exponent, *argument, false) : *argument;
        } else if (node.function == Function::sin || node.function == Function::cos) {
          all.waves.push_back({node.function == Function::sin, *argument});
        } else if (node.function == Function::log && exponent == 1) {
          all.logarithm = *argument;
        } else {
          return false;
        }
      }
      return true;
    }
    if (node.op == Op::symbol) {
      all.others.push_back(factor);
      return true;
    }
    return add_power(base, 2 * exponent, all) || (exponent == -1 && add_quadratic(base, false, all));
  }

  bool add_quadratic(ExprId base, bool under_root, Factors& all) {
    const Terms parts = terms(base);
    if (!parts || all.quadratic) return false;
    std::vector<ExprId> constants;
    std::vector<ExprId> slopes;
    for (const IntegrandTerm& part : *parts) {
      const bool square = part.running.size() == 1 && tree_[part.running[0]].op == Op::power &&
                          tree_[part.running[0]].exponent == 2 &&
                          is_variable(tree_.children(part.running[0])[0]);
      if (!part.running.empty() && !square) return false;
      (square ? slopes : constants).push_back(product(part.constant));
    }
    if (constants.empty() || slopes.empty()) return false;
    all.quadratic = Quadratic{sum(std::move(constants)), sum(std::move(slopes)), under_root};
    return true;
  }

  bool add_power(ExprId base, int twice, Factors& all) {
    const auto argument = linear(base);
    if (!argument || !argument->slope) return false;
    for (LinearPower& known : all.powers) {
      if (!same_expression(tree_, known.base, tree_, base)) continue;
      known.twice += twice;
      return true;
    }
    all.powers.push_back({base, *argument, twice});
    return true;
  }

  /// The parts of a sum, each with its sign.
  void add_parts(ExprId id, bool negative, std::vector<std::pair<ExprId, bool>>& parts) {
    if (tree_[id].op != Op::add && tree_[id].op != Op::negate) {
      const auto opposite = std::ranges::find_if(parts, [&](const auto& each) {
        return each.second != negative && same_expression(tree_, each.first, tree_, id);
      });
      if (opposite != parts.end()) {
        parts.erase(opposite);
      } else {
        parts.emplace_back(id, negative);
      }
      return;
    }
    for (const ExprId child : tree_.children(id))
      add_parts(child, negative != (tree_[id].op == Op::negate), parts);
  }

  /// a ± b; equal parts cancel.
  Linear added(const Linear& a, const Linear& b, bool minus) {
    const auto both = [&](const std::optional<ExprId>& x,
                          const std::optional<ExprId>& y) -> std::optional<ExprId> {
      std::vector<std::pair<ExprId, bool>> parts;
      if (x) add_parts(*x, false, parts);
      if (y) add_parts(*y, minus, parts);
      if (parts.empty()) return std::nullopt;
      std::vector<ExprId> terms;
      for (const auto& [part, is_negative] : parts) terms.push_back(is_negative ? negative(part) : part);
      return sum(std::move(terms));
    };
    return {both(a.slope, b.slope), both(a.shift, b.shift)};
  }

  // --- their antiderivatives

  std::optional<Primitive> of_variable(int n) {
    if (n == -1) return Primitive{.value = logarithm_of(variable())};
    if (n > highest_power || n < -highest_power) return std::nullopt;
    const ExprId raised = over(power(variable(), n + 1), number(std::abs(n + 1)));
    Primitive result{.value = n < -1 ? negative(raised) : raised, .falls = n < -1};
    return result;
  }

  /// x^n u^k: with x = (u − β)/α it is a sum of powers of u.
  std::optional<Primitive> of_linear_power(int n, const LinearPower& factor) {
    if (n < 0 || n > highest_power || std::abs(factor.twice) > 2 * highest_power) return std::nullopt;
    const ExprId slope = *factor.linear.slope;
    const ExprId shift = negative(factor.linear.shift.value_or(number(0)));
    Primitive result{.falls = true};
    std::vector<ExprId> terms;
    int binomial = 1;  // n over j
    for (int j = 0; j <= n; ++j) {
      const int twice = factor.twice + 2 * j + 2;
      const ExprId raised =
          twice == 0 ? logarithm_of(factor.base)
                     : over(product({number(2), half_power(factor.base, twice)}), number(std::abs(twice)));
      const ExprId term = product({number(binomial), power(shift, n - j), raised});
      terms.push_back(over(twice < 0 ? negative(term) : term, power(slope, n + 1)));
      result.falls = result.falls && twice < 0;
      binomial = binomial * (n - j) / (j + 1);
      if (!factor.linear.shift && j < n) {  // only the highest power is there
        terms.clear();
        result.falls = true;
        binomial = 1;
        j = n - 1;
      }
    }
    result.value = sum(std::move(terms));
    return result;
  }

  /// ln|u|, whatever the sign of u.
  ExprId logarithm_of(ExprId base) { return over(apply(Function::log, power(base, 2)), number(2)); }

  /// A square root that is seen at once.
  ExprId root_of(ExprId id) {
    if (is_one(id)) return id;
    const ExprNode node = tree_[id];
    if (node.op == Op::power && node.exponent % 2 == 0)
      return power(tree_.children(id)[0], node.exponent / 2);
    return tree_.add({.op = Op::root, .span = span_}, std::span(&id, 1));
  }

  /// ∫ du/(c + s u²) = arctan(u√s/√c)/√(cs), and ∫ du/√(c − s u²) = arcsin(u√s/√c)/√s.
  Primitive of_quadratic(const Quadratic& of) {
    if (of.under_root) {
      const ExprId falls = negative(of.slope);
      const ExprId slope = tree_.add({.op = Op::root, .span = span_}, std::span(&falls, 1));
      const ExprId scale = tree_.add({.op = Op::root, .span = span_}, std::span(&of.constant, 1));
      const ExprId argument = over(product({variable(), slope}), scale);
      return {.value = over(apply(Function::arcsin, argument), slope)};
    }
    const ExprId slope = root_of(of.slope);
    const ExprId scale = root_of(of.constant);
    const ExprId argument = over(product({variable(), slope}), scale);
    return {.value = over(apply(Function::arctan, argument), product({slope, scale}))};
  }

  /// ∫ ln u dx = (u ln u − u)/α for u = αx + β.
  std::optional<Primitive> of_logarithm(const Linear& argument) {
    if (!argument.slope) return std::nullopt;
    const ExprId u = value_of(argument);
    const ExprId value = sum({product({u, apply(Function::log, u)}), negative(u)});
    return Primitive{.value = over(value, *argument.slope)};
  }

  /// Σ_j (−1)^j (x^n)^{(j)} G_{j+1}(u)/α^{j+1}, where G_{j+1} is G_j integrated.
  template <class Integrated>
  ExprId by_parts(int n, ExprId slope, const Integrated& integrated) {
    std::vector<ExprId> terms;
    int falling = 1;  // n(n−1)…
    for (int j = 0; j <= n; ++j) {
      const ExprId term =
          over(product({number(falling), power(variable(), n - j), integrated(j + 1)}), power(slope, j + 1));
      terms.push_back(j % 2 == 0 ? term : negative(term));
      falling *= n - j;
    }
    return sum(std::move(terms));
  }

  std::optional<Primitive> of_exponential(int n, const Linear& exponent) {
    if (!exponent.slope) return std::nullopt;
    const ExprId value = apply(Function::exp, value_of(exponent));
    return Primitive{.value = by_parts(n, *exponent.slope, [&](int) { return value; }),
                     .rate = exponent.slope};
  }

  /// Sine or cosine, integrated some times by its argument.
  ExprId wave(bool sine, int times, ExprId argument) {
    const int turns = ((sine ? 0 : 1) - times + 16) % 4;  // sin, cos, −sin, −cos: the derivatives of a sine
    const ExprId value = apply(turns % 2 == 0 ? Function::sin : Function::cos, argument);
    return turns < 2 ? value : negative(value);
  }

  /// A product of sines and cosines is a sum of them.
  std::optional<Primitive> of_waves(const Factors& factors) {
    struct Part {
      ExprId coefficient;
      std::optional<Wave> wave;  // none: 1
    };
    std::vector<Part> parts{{number(1), factors.waves[0]}};
    for (std::size_t k = 1; k < factors.waves.size(); ++k) {
      const Wave& b = factors.waves[k];
      std::vector<Part> next;
      for (const Part& part : parts) {
        if (!part.wave) {
          next.push_back({part.coefficient, b});
          continue;
        }
        const Wave& a = *part.wave;
        const ExprId half = over(part.coefficient, number(2));
        const Linear difference = added(a.argument, b.argument, true);
        const Linear total = added(a.argument, b.argument, false);
        // sin a sin b and cos a cos b give cosines; sin a cos b and cos a sin b give sines.
        const bool sine = a.sine != b.sine;
        const bool first_negative = sine && !a.sine;
        const bool second_negative = a.sine && b.sine;
        add_part(next, first_negative ? negative(half) : half, {sine, difference});
        add_part(next, second_negative ? negative(half) : half, {sine, total});
      }
      parts = std::move(next);
      if (parts.size() > most_integrand_terms) return std::nullopt;
    }
    std::vector<ExprId> terms;
    for (const Part& part : parts) {
      const auto integrated = of_wave(factors, part.wave);
      if (!integrated) return std::nullopt;
      terms.push_back(product({part.coefficient, *integrated}));
    }
    Primitive result{.value = sum(std::move(terms))};
    if (factors.exponent) result.rate = factors.exponent->slope;
    return result;
  }

  template <class Parts>
  void add_part(Parts& parts, ExprId coefficient, Wave wave) {
    if (wave.argument.slope) {
      parts.push_back({coefficient, wave});
      return;
    }
    if (!wave.argument.shift) {  // of 0
      if (!wave.sine) parts.push_back({coefficient, std::nullopt});
      return;
    }
    const ExprId value = apply(wave.sine ? Function::sin : Function::cos, *wave.argument.shift);
    parts.push_back({product({coefficient, value}), std::nullopt});
  }

  std::optional<ExprId> of_wave(const Factors& factors, const std::optional<Wave>& of) {
    if (!of) {
      const auto rest =
          factors.exponent ? of_exponential(factors.power, *factors.exponent) : of_variable(factors.power);
      return rest ? std::optional(rest->value) : std::nullopt;
    }
    if (!of->argument.slope) return std::nullopt;
    const ExprId slope = *of->argument.slope;
    const ExprId argument = value_of(of->argument);
    if (!factors.exponent)
      return by_parts(factors.power, slope, [&](int times) { return wave(of->sine, times, argument); });
    if (factors.power != 0 || !factors.exponent->slope) return std::nullopt;
    // e^{ax} w(bx): (a w − b ∫w)·e^{ax}/(a² + b²) with ∫w turned back twice
    const ExprId rate = *factors.exponent->slope;
    const ExprId turned = negative(wave(of->sine, -1, argument));
    const ExprId above = sum({product({rate, wave(of->sine, 0, argument)}), product({slope, turned})});
    const ExprId below = sum({power(rate, 2), power(slope, 2)});
    return over(product({apply(Function::exp, value_of(*factors.exponent)), above}), below);
  }

  /// f' and f^k f'.
  std::optional<Primitive> of_function(const IntegrandTerm& term, const Factors& factors) {
    if (factors.others.size() != term.running.size()) return std::nullopt;
    for (std::size_t k = 0; k < term.running.size(); ++k) {
      if (tree_[term.running[k]].op != Op::symbol) continue;
      const auto function = running_.antiderivative(term.running[k]);
      if (!function) continue;
      int exponent = 0;
      bool alike = true;
      for (std::size_t other = 0; other < term.running.size(); ++other) {
        if (other == k) continue;
        const bool raised = tree_[term.running[other]].op == Op::power;
        const ExprId base = raised ? tree_.children(term.running[other])[0] : term.running[other];
        alike = alike && same_expression(tree_, base, tree_, *function);
        exponent += raised ? tree_[term.running[other]].exponent : 1;
      }
      if (!alike || exponent < 0 || exponent > highest_power) continue;
      return Primitive{.value = over(power(*function, exponent + 1), number(exponent + 1))};
    }
    return std::nullopt;
  }

  ExprTree& tree_;
  const Running& running_;
  Span span_;
};

}  // namespace

std::optional<std::vector<IntegrandTerm>> integrand_terms(ExprTree& tree, ExprId integrand,
                                                          const Running& running) {
  return Integrator(tree, running, tree[integrand].span).terms(integrand);
}

std::optional<Primitive> primitive(ExprTree& tree, const IntegrandTerm& term, const Running& running,
                                   Span span) {
  return Integrator(tree, running, span).primitive(term);
}

std::vector<ExprId> linear_divisors(ExprTree& tree, const IntegrandTerm& term, const Running& running,
                                    Span span) {
  return Integrator(tree, running, span).divisors(term);
}

ExprId product_of(ExprTree& tree, std::vector<ExprId> factors, Span span) {
  const Running none{};
  return Integrator(tree, none, span).product(std::move(factors));
}

}  // namespace rigor
