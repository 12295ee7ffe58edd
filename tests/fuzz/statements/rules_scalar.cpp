// SPDX-License-Identifier: GPL-3.0-or-later
// Sums, products, quotients, powers, roots and functions of numbers.
#include <algorithm>

#include "rewrite.h"

namespace fuzz {
namespace {

bool is_number(const Term& term, long p) { return term->op == Op::number && term->p == p && term->q == 1; }

Term commuted(const Term& term, Scene& scene) {
  if (term->op != Op::sum && term->op != Op::product) return nullptr;
  std::vector<Term> parts = term->parts;
  std::swap(parts[scene.random.below(parts.size())], parts[scene.random.below(parts.size())]);
  // a tensor stays behind its factors, where somebody would write it
  std::stable_sort(parts.begin(), parts.end(), [&](const Term& a, const Term& b) {
    return term->op == Op::product && a->rank < b->rank;
  });
  return rebuilt(term, parts);
}

/// a(b + c) = ab + ac
Term multiplied_out(const Term& term, Scene&) {
  if (term->op == Op::negative && term->parts[0]->op == Op::sum) {
    std::vector<Term> parts;
    for (const Term& part : term->parts[0]->parts) parts.push_back(negative(part));
    return sum(parts);
  }
  if (term->op != Op::product) return nullptr;
  const auto found = std::find_if(term->parts.begin(), term->parts.end(),
                                  [](const Term& part) { return part->op == Op::sum; });
  if (found == term->parts.end()) return nullptr;
  std::vector<Term> terms;
  for (const Term& part : (*found)->parts) {
    std::vector<Term> factors = term->parts;
    factors[static_cast<std::size_t>(found - term->parts.begin())] =
        part->op == Op::negative ? part->parts[0] : part;
    terms.push_back(part->op == Op::negative ? negative(product(factors)) : product(factors));
  }
  return sum(terms);
}

Term power_opened(const Term& term, Scene&) {
  if (term->op != Op::power || term->p != 2) return nullptr;
  const Term& base = term->parts[0];
  if (base->op == Op::sum && base->parts.size() == 2) {
    const Term& a = base->parts[0];
    const Term& b = base->parts[1];
    return sum({power(a, 2), product({number(2), a, b}), power(b, 2)});
  }
  if (base->op == Op::root || base->op == Op::absolute)
    return base->op == Op::root ? base->parts[0] : power(base->parts[0], 2);
  if (base->op == Op::product) {
    std::vector<Term> factors;
    for (const Term& factor : base->parts) factors.push_back(power(factor, 2));
    return product(factors);
  }
  return product({base, base});
}

Term root_of_square(const Term& term, Scene&) {
  if (term->op == Op::root && term->parts[0]->op == Op::power && term->parts[0]->p == 2)
    return make(Op::absolute, term->parts[0]->parts);
  if (term->op == Op::absolute && term->parts[0]->op == Op::product) {
    std::vector<Term> factors;
    for (const Term& factor : term->parts[0]->parts) factors.push_back(make(Op::absolute, {factor}));
    return product(factors);
  }
  if (term->op == Op::absolute) return make(Op::root, {power(term->parts[0], 2)});
  return nullptr;
}

Term one_denominator(const Term& term, Scene&) {
  if (term->op == Op::sum && term->parts.size() == 2) {
    const Term& a = term->parts[0];
    const Term& b = term->parts[1];
    if (a->op == Op::quotient)
      return make(Op::quotient, {sum({a->parts[0], product({a->parts[1], b})}), a->parts[1]});
  }
  if (term->op == Op::quotient && term->parts[0]->op == Op::sum) {
    std::vector<Term> parts;
    for (const Term& part : term->parts[0]->parts)
      parts.push_back(make(Op::quotient, {part, term->parts[1]}));
    return sum(parts);
  }
  if (term->op == Op::quotient)
    return product({make(Op::quotient, {number(1), term->parts[1]}), term->parts[0]});
  return nullptr;
}

Term any_scalar(Scene& scene) {
  for (int tries = 0; tries < 4; ++tries) {
    const std::size_t letter = scene.random.below(scene.letters.size());
    const Letter& taken = scene.letters[letter];
    if (taken.rank == 0 && !taken.of_particles && taken.nature != Nature::small)
      return symbol(scene.letters, letter);
  }
  return nullptr;
}

/// x = x + a - a, x = ax/a
Term with_nothing_added(const Term& term, Scene& scene) {
  const Term extra = scene.random.one_in(6) ? any_scalar(scene) : nullptr;
  if (extra == nullptr || term->op == Op::number) return nullptr;
  if (term->rank == 0 && scene.random.one_in(2)) return sum({term, extra, negative(extra)});
  return make(Op::quotient, {product({extra, term}), extra});
}

Term doubled(const Term& term, Scene& scene) {
  if (!scene.random.one_in(6)) return nullptr;
  if (term->op == Op::number) {
    if (term->q == 1 && term->p > 1) return sum({number(term->p - 1), number(1)});
    return nullptr;
  }
  if (scene.random.one_in(2)) return sum({product({number(2), term}), negative(term)});
  return product({number(1, 2), sum({term, term})});
}

Term collected(const Term& term, Scene&) {
  if (term->op != Op::sum || term->parts.size() != 2) return nullptr;
  const Term& a = term->parts[0];
  const Term& b = term->parts[1];
  if (same(a, b)) return product({number(2), a});
  if (a->op == Op::power && b->op == Op::negative && b->parts[0]->op == Op::power && a->p == 2 &&
      b->parts[0]->p == 2) {
    const Term& x = a->parts[0];
    const Term& y = b->parts[0]->parts[0];
    return product({sum({x, y}), sum({x, negative(y)})});
  }
  return nullptr;
}

Term f(Function function, const Term& x) { return function_of(function, x); }

/// Addition theorems.
Term function_of_sum(const Term& term, Scene&) {
  if (term->op != Op::function) return nullptr;
  const Term& argument = term->parts[0];
  if (argument->op == Op::negative) {
    const bool even = term->function == Function::cos || term->function == Function::cosh;
    if (even) return f(term->function, argument->parts[0]);
    if (term->function == Function::exp)
      return make(Op::quotient, {number(1), f(Function::exp, argument->parts[0])});
    return term->function == Function::ln ? nullptr : negative(f(term->function, argument->parts[0]));
  }
  if (argument->op != Op::sum || argument->parts.size() != 2) return nullptr;
  const Term& x = argument->parts[0];
  const Term& y = argument->parts[1];
  using enum Function;
  switch (term->function) {
    case sin:
      return sum({product({f(sin, x), f(cos, y)}), product({f(cos, x), f(sin, y)})});
    case cos:
      return sum({product({f(cos, x), f(cos, y)}), negative(product({f(sin, x), f(sin, y)}))});
    case exp:
      return product({f(exp, x), f(exp, y)});
    case sinh:
      return sum({product({f(sinh, x), f(cosh, y)}), product({f(cosh, x), f(sinh, y)})});
    case cosh:
      return sum({product({f(cosh, x), f(cosh, y)}), product({f(sinh, x), f(sinh, y)})});
    default:
      return nullptr;
  }
}

Term function_by_others(const Term& term, Scene&) {
  using enum Function;
  if (term->op == Op::power && term->p == 2 && term->parts[0]->op == Op::function) {
    const Term& x = term->parts[0]->parts[0];
    const Function function = term->parts[0]->function;
    if (function == sin) return sum({number(1), negative(power(f(cos, x), 2))});
    if (function == cos) return product({number(1, 2), sum({number(1), f(cos, product({number(2), x}))})});
    if (function == cosh) return sum({number(1), power(f(sinh, x), 2)});
    return nullptr;
  }
  if (term->op != Op::function) return nullptr;
  const Term& x = term->parts[0];
  const Term inverse = f(exp, negative(x));
  if (term->function == tan) return make(Op::quotient, {f(sin, x), f(cos, x)});
  if (term->function == tanh) return make(Op::quotient, {f(sinh, x), f(cosh, x)});
  if (term->function == cosh) return product({number(1, 2), sum({f(exp, x), inverse})});
  if (term->function == sinh) return make(Op::quotient, {sum({f(exp, x), negative(inverse)}), number(2)});
  return nullptr;
}

Term one_as_squares(const Term& term, Scene& scene) {
  const Term angle = any_scalar(scene);
  if (!is_number(term, 1) || angle == nullptr) return nullptr;
  return sum({power(f(Function::sin, angle), 2), power(f(Function::cos, angle), 2)});
}

/// (1 + s)^n, sin s, cos s, √(1 + s) to first order in s.
Term to_first_order(const Term& term, Scene& scene) {
  const auto is_small = [&](const Term& s) {
    return s->op == Op::symbol && scene.letters[s->letter].nature == Nature::small;
  };
  if (term->op == Op::function && is_small(term->parts[0])) {
    const Term& s = term->parts[0];
    if (term->function == Function::cos || term->function == Function::cosh) return number(1);
    if (term->function == Function::exp) return sum({number(1), s});
    return term->function == Function::ln ? nullptr : s;
  }
  if (term->op == Op::power && is_small(term->parts[0]) && term->p >= 2) return number(0);
  const bool near_one = !term->parts.empty() && term->parts.back()->op == Op::sum &&
                        term->parts.back()->parts.size() == 2 && is_number(term->parts.back()->parts[0], 1) &&
                        is_small(term->parts.back()->parts[1]);
  if (!near_one) return nullptr;
  const Term& s = term->parts.back()->parts[1];
  if (term->op == Op::power) return sum({number(1), product({number(term->p), s})});
  if (term->op == Op::root) return sum({number(1), product({number(1, 2), s})});
  if (term->op == Op::quotient) return product({term->parts[0], sum({number(1), negative(s)})});
  return nullptr;
}

/// What is assumed of a letter, put in its place.
Term substituted(const Term& term, Scene& scene) {
  if (term->op != Op::symbol || !term->slots.empty() || term->dots > 0) return nullptr;
  const Term& value = scene.letters[term->letter].value;
  if (value == nullptr) return nullptr;
  bool own = false;
  visit(value,
        [&](const Node& node) { own = own || (node.op == Op::symbol && node.letter == term->letter); });
  return own ? nullptr : value;
}

}  // namespace

const std::vector<Rule>& scalar_rules() {
  static const std::vector<Rule> rules{
      substituted,     substituted,  commuted,        multiplied_out,     power_opened,   root_of_square,
      one_denominator, collected,    function_of_sum, function_by_others, one_as_squares, to_first_order,
      multiplied_out,  power_opened, function_of_sum, with_nothing_added, doubled};
  return rules;
}

}  // namespace fuzz
