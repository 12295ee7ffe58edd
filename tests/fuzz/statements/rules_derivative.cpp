// SPDX-License-Identifier: GPL-3.0-or-later
// Rates, rates in turning frames, and ∇.
#include <algorithm>

#include "rewrite.h"

namespace fuzz {
namespace {

Term dot(const Term& a, const Term& b) { return make(Op::dot, {a, b}); }
Term cross(const Term& a, const Term& b) { return make(Op::cross, {a, b}); }
Term grad(const Term& f) { return make(Op::gradient, {f}); }
Term div(const Term& v) { return make(Op::divergence, {v}); }
Term curl(const Term& v) { return make(Op::curl, {v}); }
Term along(const Term& a, const Term& b) { return make(Op::along, {a, b}); }
Term laplacian(const Term& f) { return make(Op::laplacian, {f}); }

/// The derivative of a sum, or of a product of any kind, by the rule D itself names.
template <typename Derive>
Term by_parts(const Term& term, const Derive& derive) {
  if (term->op != Op::sum && term->op != Op::product && term->op != Op::dot && term->op != Op::cross &&
      term->op != Op::negative && term->op != Op::act) {
    return nullptr;
  }
  if (term->op == Op::negative) return negative(derive(term->parts[0]));
  std::vector<Term> terms;
  for (std::size_t k = 0; k < term->parts.size(); ++k) {
    const Term& part = term->parts[k];
    if (term->op == Op::sum && part->op == Op::negative) {
      terms.push_back(negative(derive(part->parts[0])));
    } else if (term->op == Op::sum) {
      terms.push_back(derive(part));
    } else {
      std::vector<Term> parts = term->parts;
      if (part->op == Op::number) continue;
      parts[k] = derive(part);
      terms.push_back(term->op == Op::product ? product(parts) : make(term->op, parts));
    }
  }
  return terms.empty() ? nullptr : sum(terms);
}

Term rate_of(const Term& term) { return make(Op::rate, {term}); }

Term rate_taken(const Term& term, Scene& scene) {
  if (term->op != Op::rate) return nullptr;
  const Term& of = term->parts[0];
  if (of->op == Op::symbol) {
    const Nature nature = scene.letters[of->letter].nature;
    if (nature == Nature::constant) return of->rank == 0 ? number(0) : nullptr;
    return of->dots >= 2 ? nullptr : symbol(scene.letters, of->letter, of->slots, of->particle, of->dots + 1);
  }
  if (of->op == Op::power)
    return product(
        {number(of->p), of->p == 2 ? of->parts[0] : power(of->parts[0], of->p - 1), rate_of(of->parts[0])});
  if (of->op == Op::root) return make(Op::quotient, {rate_of(of->parts[0]), product({number(2), of})});
  if (of->op == Op::particle_sum) return particle_sum(of->particle, rate_of(of->parts[0]));
  if (of->op == Op::length) return make(Op::quotient, {dot(of->parts[0], rate_of(of->parts[0])), of});
  if (of->op == Op::quotient) {
    const Term& a = of->parts[0];
    const Term& b = of->parts[1];
    if (a->rank > 0) return nullptr;
    return make(Op::quotient,
                {sum({product({rate_of(a), b}), negative(product({a, rate_of(b)}))}), power(b, 2)});
  }
  if (of->op == Op::function) {
    const Term& x = of->parts[0];
    using enum Function;
    switch (of->function) {
      case sin:
        return product({rate_of(x), function_of(cos, x)});
      case cos:
        return negative(product({rate_of(x), function_of(sin, x)}));
      case exp:
        return product({rate_of(x), of});
      case sinh:
        return product({rate_of(x), function_of(cosh, x)});
      case cosh:
        return product({rate_of(x), function_of(sinh, x)});
      case ln:
        return make(Op::quotient, {rate_of(x), x});
      default:
        return nullptr;
    }
  }
  return by_parts(of, rate_of);
}

/// dA/dt seen from the fixed axes = dA/dt seen from the turning ones + ω×A.
Term transported(const Term& term, Scene& scene) {
  const auto spin = std::find_if(scene.letters.begin(), scene.letters.end(),
                                 [](const Letter& letter) { return letter.nature == Nature::spin; });
  if (spin == scene.letters.end()) return nullptr;
  if (term->op == Op::rate && term->parts[0]->op == Op::dot)
    return by_parts(term->parts[0], [](const Term& part) { return make(Op::rate_in, {part}); });
  if (term->op != Op::rate_in && term->op != Op::rate_rot) return nullptr;
  const Term& of = term->parts[0];
  if (scene.random.one_in(2)) {
    const Term omega = symbol(scene.letters, static_cast<std::size_t>(spin - scene.letters.begin()));
    const Term turning = cross(omega, of);
    if (term->op == Op::rate_in) return sum({make(Op::rate_rot, {of}), turning});
    return sum({make(Op::rate_in, {of}), negative(turning)});
  }
  return by_parts(of, [&](const Term& part) { return make(part->rank == 0 ? Op::rate : term->op, {part}); });
}

Term field_of_product(const Term& term, Scene&) {
  if (term->op < Op::gradient || term->op > Op::laplacian) return nullptr;
  const Term& of = term->parts[0];
  if (of->op == Op::sum || of->op == Op::negative)
    return by_parts(of, [&](const Term& part) { return make(term->op, {part}); });
  if (of->op == Op::dot && term->op == Op::gradient) {
    const Term& a = of->parts[0];
    const Term& b = of->parts[1];
    return sum({along(a, b), along(b, a), cross(a, curl(b)), cross(b, curl(a))});
  }
  if (of->op == Op::cross && term->op == Op::divergence)
    return sum({dot(of->parts[1], curl(of->parts[0])), negative(dot(of->parts[0], curl(of->parts[1])))});
  if (of->op == Op::cross && term->op == Op::curl) {
    const Term& a = of->parts[0];
    const Term& b = of->parts[1];
    return sum({product({div(b), a}), negative(product({div(a), b})), along(b, a), negative(along(a, b))});
  }
  if (of->op != Op::product || of->parts.size() != 2) return nullptr;
  const Term& f = of->parts[0];
  const Term& g = of->parts[1];
  if (f->op == Op::number) return product({f, make(term->op, {g})});
  switch (term->op) {
    case Op::gradient:
      return sum({product({f, grad(g)}), product({g, grad(f)})});
    case Op::divergence:
      return sum({product({f, div(g)}), dot(grad(f), g)});
    case Op::curl:
      return sum({product({f, curl(g)}), cross(grad(f), g)});
    default:
      if (g->rank > 0) return nullptr;
      return sum({product({f, laplacian(g)}), product({number(2), dot(grad(f), grad(g))}),
                  product({g, laplacian(f)})});
  }
}

Term second_derivatives(const Term& term, Scene&) {
  if (term->op == Op::curl && term->parts[0]->op == Op::curl) {
    const Term& a = term->parts[0]->parts[0];
    return sum({grad(div(a)), negative(laplacian(a))});
  }
  if (term->op == Op::divergence && term->parts[0]->op == Op::gradient)
    return laplacian(term->parts[0]->parts[0]);
  if (term->op == Op::divergence && term->parts[0]->op == Op::curl) return number(0);
  if (term->op == Op::laplacian && term->parts[0]->rank == 0) return div(grad(term->parts[0]));
  return nullptr;
}

std::string take(Scene& scene, std::size_t count) {
  if (scene.fresh.size() < count) return {};
  const std::string taken = scene.fresh.substr(0, count);
  scene.fresh.erase(0, count);
  return taken;
}

Term component_of(const Term& vector, char slot) {
  if (vector->op != Op::symbol) return nullptr;
  Node node = *vector;
  node.slots = slot;
  node.rank = 0;
  return std::make_shared<const Node>(node);
}

/// ∇·A = ∂_i A_i, (∇×A)_i = ε_ijk ∂_j A_k, (∇f)_i = ∂_i f
Term by_coordinates(const Term& term, Scene& scene) {
  const auto d = [](char slot, const Term& of) { return with_slots(Op::partial, of, std::string(1, slot)); };
  if (term->op == Op::divergence && term->parts[0]->op == Op::symbol) {
    const std::string i = take(scene, 1);
    return i.empty() ? nullptr : contract(i, d(i[0], component_of(term->parts[0], i[0])));
  }
  if (term->op == Op::partial)
    return by_parts(term->parts[0], [&](const Term& part) { return d(term->slots[0], part); });
  if (term->op != Op::component) return nullptr;
  const Term& of = term->parts[0];
  if (of->op == Op::gradient) return d(term->slots[0], of->parts[0]);
  if (of->op != Op::curl || of->parts[0]->op != Op::symbol) return nullptr;
  const std::string jk = take(scene, 2);
  if (jk.empty()) return nullptr;
  return contract(jk, product({epsilon(term->slots + jk), d(jk[0], component_of(of->parts[0], jk[1]))}));
}

}  // namespace

const std::vector<Rule>& derivative_rules() {
  static const std::vector<Rule> rules{rate_taken,         rate_taken,       rate_taken,
                                       transported,        field_of_product, field_of_product,
                                       second_derivatives, by_coordinates};
  return rules;
}

}  // namespace fuzz
