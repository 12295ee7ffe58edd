// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/form/rational_form.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "algebra/engine/term_estimate.h"
#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/form/rational_terms.h"
#include "base/among.h"

namespace rigor {
namespace {

constexpr std::size_t most_terms_of_form = 300;
constexpr double most_terms_on_the_way = 4'000;  // before equal ones are gathered

struct Quotient {
  GiNaC::ex numerator;    // expanded
  GiNaC::ex denominator;  // expanded, its first term positive
};

class RationalWriter {
 public:
  explicit RationalWriter(ExprTree& tree) : atoms_(tree) {}

  RationalAtoms& atoms() { return atoms_; }

  Quotient quotient_of(const GiNaC::ex& value) {
    if (most_terms_over_one_denominator(value) > most_terms_on_the_way)
      throw Undecidable("it has too many terms");
    const GiNaC::ex parts = value.numer_denom();
    Quotient quotient{parts.op(0).expand(), parts.op(1).expand()};
    if (quotient.denominator.is_zero()) throw Undecidable("it divides by zero");
    for (const GiNaC::ex& part : {quotient.numerator, quotient.denominator}) {
      if (terms_of(part).size() > most_terms_of_form) throw Undecidable("it has too many terms");
    }
    if (atoms_.terms_of_polynomial(quotient.denominator)[0].coefficient.is_negative()) {
      quotient.numerator = (-quotient.numerator).expand();
      quotient.denominator = (-quotient.denominator).expand();
    }
    return quotient;
  }

  ExprId expanded(const Quotient& quotient, int rank) {
    if (is_number(quotient.denominator)) {
      const ExprId id = polynomial((quotient.numerator / quotient.denominator).expand());
      return quotient.numerator.is_zero() && rank > 0 ? zero(rank) : id;
    }
    return atoms_.make(Op::divide, {polynomial(quotient.numerator), polynomial(quotient.denominator)});
  }

  ExprId factored(const Quotient& quotient) {
    if (quotient.numerator.is_zero()) return polynomial(0);
    if (is_number(quotient.denominator)) return factors((quotient.numerator / quotient.denominator).expand());
    Factored above = factors_of_polynomial(quotient.numerator);
    const Factored below = factors_of_polynomial(quotient.denominator);
    const GiNaC::numeric number =
        above.number / below.number;  // in lowest terms: whole numbers above and below
    const bool negative = number.is_negative() && !take_sign(above);
    const ExprId top = joined({GiNaC::abs(number).numer(), above.factors});
    const bool whole = number.denom().is_equal(1);
    const ExprId bottom = joined({number.denom(), below.factors});
    const bool divides = !whole || !below.factors.empty();
    const ExprId result = divides ? atoms_.make(Op::divide, {top, bottom}) : top;
    return negative ? atoms_.make(Op::negate, {result}) : result;
  }

  ExprId factors(const GiNaC::ex& value) {
    Factored parts = factors_of_polynomial(value);
    const bool negative = parts.number.is_negative() && !take_sign(parts);
    parts.number = GiNaC::abs(parts.number);
    const ExprId result = joined(parts);
    return negative ? atoms_.make(Op::negate, {result}) : result;
  }

  ExprId polynomial(const GiNaC::ex& expanded) {
    return atoms_.expression_of(atoms_.terms_of_polynomial(expanded));
  }

 private:
  struct Factor {
    std::vector<RationalTerm> base;
    int exponent = 1;
  };
  struct Factored {
    GiNaC::numeric number = 1;
    std::vector<Factor> factors = {};
  };

  ExprId zero(int rank) {
    ExprTree& tree = atoms_.tree();
    ExprId id = tree.add_number({}, "0");
    for (int axes = 1; axes <= rank; ++axes) {
      const ExprId entries[] = {id, id, id};
      id = tree.add({.op = Op::tuple, .rank = static_cast<std::uint8_t>(axes)}, entries);
    }
    return id;
  }

  /// −(a − b) is b − a: a factor takes the sign if it is a difference.
  static bool take_sign(Factored& parts) {
    for (Factor& factor : parts.factors) {
      const bool difference =
          factor.exponent % 2 != 0 && std::ranges::any_of(factor.base, [](const RationalTerm& term) {
            return term.coefficient.is_negative();
          });
      if (!difference) continue;
      for (RationalTerm& term : factor.base) term.coefficient = -term.coefficient;
      return true;
    }
    return false;
  }

  Factored factors_of_polynomial(const GiNaC::ex& expanded) {
    Factored result;
    for (const GiNaC::ex& each : factors_of(GiNaC::factor(expanded))) {
      const bool power = GiNaC::is_a<GiNaC::power>(each);
      const GiNaC::ex base = (power ? each.op(0) : each).expand();
      const int exponent = power ? GiNaC::ex_to<GiNaC::numeric>(each.op(1)).to_int() : 1;
      add(result, base, exponent);
    }
    std::ranges::sort(result.factors, comes_before);
    return result;
  }

  /// With whole coefficients without a common divisor, the first one positive.
  void add(Factored& result, const GiNaC::ex& base, int exponent) {
    if (is_number(base)) {
      result.number *= GiNaC::pow(GiNaC::ex_to<GiNaC::numeric>(base), GiNaC::numeric(exponent));
      return;
    }
    Factor factor{atoms_.terms_of_polynomial(base), exponent};
    GiNaC::numeric content = 0;
    GiNaC::numeric common = 1;
    for (const RationalTerm& term : factor.base) {
      content = GiNaC::gcd(content, term.coefficient.numer());
      common = GiNaC::lcm(common, term.coefficient.denom());
    }
    content = content / common;
    if (factor.base[0].coefficient.is_negative()) content = -content;
    for (RationalTerm& term : factor.base) term.coefficient = term.coefficient / content;
    result.number *= GiNaC::pow(content, GiNaC::numeric(exponent));
    result.factors.push_back(std::move(factor));
  }

  /// Single indeterminates first, in their order; then by their terms.
  static bool comes_before(const Factor& a, const Factor& b) {
    if ((a.base.size() == 1) != (b.base.size() == 1)) return a.base.size() == 1;
    for (std::size_t k = 0; k < std::min(a.base.size(), b.base.size()); ++k) {
      if (a.base[k].exponents != b.base[k].exponents) return a.base[k].exponents > b.base[k].exponents;
      if (!a.base[k].coefficient.is_equal(b.base[k].coefficient))
        return a.base[k].coefficient > b.base[k].coefficient;
    }
    return a.base.size() < b.base.size();
  }

  /// The number is positive.
  ExprId joined(const Factored& parts) {
    std::vector<ExprId> factors;
    if (!parts.number.is_equal(1) || parts.factors.empty()) factors.push_back(atoms_.number(parts.number));
    for (const Factor& factor : parts.factors) {
      const ExprId base = atoms_.expression_of(factor.base);
      factors.push_back(factor.exponent == 1 ? base : atoms_.make(Op::power, {base}, factor.exponent));
    }
    return atoms_.product(std::move(factors));
  }

  RationalAtoms atoms_;
};

bool speaks_of(const ExprTree& tree, ExprId root, SymbolId symbol) {
  const std::vector<SymbolId> symbols = symbols_in(tree, root);
  return is_one_of(symbol, symbols);
}

/// A polynomial's parts by the powers of some indeterminates, the highest first.
using Parts = std::map<std::vector<int>, std::vector<RationalTerm>, std::greater<>>;

Parts parts_of(const std::vector<RationalTerm>& terms, const std::vector<std::size_t>& chosen) {
  Parts parts;
  for (RationalTerm term : terms) {
    std::vector<int> powers;
    for (const std::size_t position : chosen) powers.push_back(std::exchange(term.exponents[position], 0));
    parts[powers].push_back(std::move(term));
  }
  return parts;
}

GiNaC::ex value_of(RationalAtoms& atoms, const std::vector<RationalTerm>& terms) {
  GiNaC::ex sum = 0;
  for (const RationalTerm& term : terms) {
    GiNaC::ex product = term.coefficient;
    for (std::size_t k = 0; k < term.exponents.size(); ++k)
      product *= GiNaC::pow(atoms.at(k), term.exponents[k]);
    sum += product;
  }
  return sum;
}

/// Does a symbol occur in an indeterminate of some terms, other than those in `own`?
bool is_hidden(RationalAtoms& atoms, const std::vector<RationalTerm>& terms, SymbolId symbol,
               const std::vector<std::size_t>& own) {
  const ExprTree& tree = atoms.tree();
  for (const RationalTerm& term : terms) {
    for (std::size_t k = 0; k < term.exponents.size(); ++k) {
      const bool mine = is_one_of(k, own);
      if (mine || term.exponents[k] == 0) continue;
      const ExprId other = atoms.expression_at(k);
      if (tree[other].op != Op::symbol && speaks_of(tree, other, symbol)) return true;
    }
  }
  return false;
}

class Solving {
 public:
  explicit Solving(ExprTree& tree) : tree_(tree), writer_(tree) {}

  Roots solve(ExprId difference, ExprId unknown) {
    const Quotient quotient = writer_.quotient_of(writer_.atoms().value_of(difference));
    const auto position = writer_.atoms().position_of(unknown);
    if (!position) return {.obstacle = "it does not occur as a quantity of its own"};
    for (const SymbolId symbol : symbols_in(tree_, unknown)) {
      if (is_hidden(writer_.atoms(), writer_.atoms().terms_of_polynomial(quotient.numerator), symbol,
                    {*position}))
        return {.obstacle = "it also occurs in a root, a function, a product of vectors or a sum"};
    }
    const Parts parts = parts_of(writer_.atoms().terms_of_polynomial(quotient.numerator), {*position});
    if (parts.empty()) return {.obstacle = "every value fits"};
    const int degree = parts.begin()->first[0];
    if (degree == 0) return {.obstacle = "it drops out of the equation"};
    if (degree > 2) return {.obstacle = "it occurs to a power higher than the second"};
    const auto part = [&](int power) -> GiNaC::ex {
      const auto found = parts.find({power});
      return found == parts.end() ? GiNaC::ex(0) : value_of(writer_.atoms(), found->second);
    };
    if (degree == 1) return {.values = {fraction(-part(0), part(1))}};
    return quadratic(part(2), part(1), part(0));
  }

 private:
  ExprId fraction(const GiNaC::ex& above, const GiNaC::ex& below) {
    return writer_.factored(writer_.quotient_of(above / below));
  }

  static bool is_negative(const GiNaC::ex& square) {
    return is_number(square) && GiNaC::ex_to<GiNaC::numeric>(square).is_negative();
  }

  static Roots no_real_root() { return {.obstacle = "it would be the root of a negative number"}; }

  /// Nothing where the square is no number, or its root not rational.
  static std::optional<GiNaC::numeric> rational_root(const GiNaC::ex& square) {
    if (!is_number(square) || is_negative(square)) return std::nullopt;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(square);
    const GiNaC::numeric root = GiNaC::isqrt(number.numer()) / GiNaC::isqrt(number.denom());
    return root * root == number ? std::optional(root) : std::nullopt;
  }

  /// a x² + b x + c = 0
  Roots quadratic(const GiNaC::ex& a, const GiNaC::ex& b, const GiNaC::ex& c) {
    RationalAtoms& atoms = writer_.atoms();
    if (b.is_zero()) {
      const GiNaC::ex square = -c / a;
      if (is_negative(square)) return no_real_root();
      if (const auto root = rational_root(square)) {
        const ExprId value = writer_.atoms().number(*root);
        if (root->is_zero()) return {.values = {value}};
        return {.values = {value, atoms.make(Op::negate, {value})}};
      }
      const ExprId root = atoms.make(Op::root, {fraction(-c, a)});
      return {.values = {root, atoms.make(Op::negate, {root})}};
    }
    const GiNaC::ex half = b / 2;
    const bool even = half.expand().integer_content().is_integer();
    const GiNaC::ex middle = even ? half : b;
    const GiNaC::ex below = even ? a : 2 * a;
    const GiNaC::ex under = (even ? half * half - a * c : b * b - 4 * a * c).expand();
    if (is_negative(under)) return no_real_root();
    const auto known_root = rational_root(under);
    Roots roots;
    for (const int sign : {1, -1}) {
      if (known_root && !known_root->is_zero()) {
        roots.values.push_back(fraction(-middle + sign * *known_root, below));
        continue;
      }
      if (under.is_zero()) {
        roots.values.push_back(fraction(-middle, below));
        continue;
      }
      ExprId root = atoms.make(Op::root, {writer_.factors(under)});
      if (sign < 0) root = atoms.make(Op::negate, {root});
      const ExprId above = atoms.make(Op::add, {writer_.polynomial((-middle).expand()), root});
      const bool one = below.is_equal(1);
      roots.values.push_back(one ? above : atoms.make(Op::divide, {above, writer_.factors(below.expand())}));
    }
    return roots;
  }

  ExprTree& tree_;
  RationalWriter writer_;
};

}  // namespace

std::optional<ExprId> rational_form(ExprTree& tree, ExprId id, RationalForm form) {
  const int rank = tree[id].rank;
  if (rank > 0 && form != RationalForm::expanded) return std::nullopt;
  try {
    RationalWriter writer(tree);
    const Quotient quotient = writer.quotient_of(writer.atoms().value_of(id));
    return form == RationalForm::expanded ? writer.expanded(quotient, rank) : writer.factored(quotient);
  } catch (const std::exception&) {  // too large, or what GiNaC cannot do
    return std::nullopt;
  }
}

std::optional<ExprId> collected_by(ExprTree& tree, ExprId id, std::span<const ExprId> by) {
  if (tree[id].rank > 0) return std::nullopt;
  try {
    RationalWriter writer(tree);
    RationalAtoms& atoms = writer.atoms();
    const Quotient quotient = writer.quotient_of(atoms.value_of(id));
    std::vector<std::size_t> chosen;
    for (const ExprId each : by) {
      if (const auto position = atoms.position_of(each)) chosen.push_back(*position);
    }
    for (const std::size_t position : chosen) {
      if (quotient.denominator.degree(atoms.at(position)) > 0) return std::nullopt;
    }
    std::vector<ExprId> addends;
    for (const auto& [powers, terms] : parts_of(atoms.terms_of_polynomial(quotient.numerator), chosen)) {
      RationalTerm monomial{std::vector<int>(atoms.count(), 0), 1};
      for (std::size_t k = 0; k < chosen.size(); ++k) monomial.exponents[chosen[k]] = powers[k];
      const bool bare = std::ranges::all_of(powers, [](int power) { return power == 0; });
      const ExprId coefficient =
          writer.factored(writer.quotient_of(value_of(atoms, terms) / quotient.denominator));
      const bool one = tree[coefficient].op == Op::number && tree.digits(coefficient) == "1";
      addends.push_back(bare  ? coefficient
                        : one ? atoms.monomial(monomial)
                              : atoms.product({coefficient, atoms.monomial(monomial)}));
    }
    if (addends.empty()) return writer.polynomial(0);
    return addends.size() == 1 ? addends[0] : atoms.make(Op::add, addends);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<ExprId> to_first_order(ExprTree& tree, ExprId id, std::span<const ExprId> in) {
  if (tree[id].rank > 0) return std::nullopt;
  try {
    RationalWriter writer(tree);
    RationalAtoms& atoms = writer.atoms();
    const GiNaC::ex value = atoms.value_of(id);
    std::vector<std::size_t> small;
    for (const ExprId each : in) {
      if (const auto position = atoms.position_of(each)) small.push_back(*position);
    }
    const Quotient whole = writer.quotient_of(value);
    for (const ExprId each : in) {
      for (const SymbolId symbol : symbols_in(tree, each)) {
        for (const GiNaC::ex& part : {whole.numerator, whole.denominator}) {
          if (is_hidden(atoms, atoms.terms_of_polynomial(part), symbol, small)) return std::nullopt;
        }
      }
    }
    const GiNaC::symbol scale;
    GiNaC::exmap scaled;
    for (const std::size_t position : small) scaled[atoms.at(position)] = atoms.at(position) * scale;
    const GiNaC::ex changed = (whole.numerator / whole.denominator).subs(scaled);
    const GiNaC::ex at_zero = changed.subs(scale == 0);
    const GiNaC::ex slope = changed.diff(scale).subs(scale == 0);
    const Quotient constant = writer.quotient_of(at_zero);
    const Quotient linear = writer.quotient_of(slope);
    if (constant.numerator.is_zero()) return writer.expanded(linear, 0);
    if (linear.numerator.is_zero()) return writer.expanded(constant, 0);
    return atoms.make(Op::add, {writer.expanded(constant, 0), writer.expanded(linear, 0)});
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Roots solved_for(ExprTree& tree, ExprId difference, ExprId unknown) {
  try {
    return Solving(tree).solve(difference, unknown);
  } catch (const Undecidable& reason) {
    return {.obstacle = reason.what()};
  } catch (const std::exception&) {
    return {.obstacle = "the equation is too large"};
  }
}

}  // namespace rigor
