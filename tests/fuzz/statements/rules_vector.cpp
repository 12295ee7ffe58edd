// SPDX-License-Identifier: GPL-3.0-or-later
// Products of vectors, index notation, sums over particles.
#include <algorithm>

#include "rewrite.h"

namespace fuzz {
namespace {

Term dot(const Term& a, const Term& b) { return make(Op::dot, {a, b}); }
Term cross(const Term& a, const Term& b) { return make(Op::cross, {a, b}); }

Term turned(const Term& term, Scene&) {
  if (term->op == Op::dot) return dot(term->parts[1], term->parts[0]);
  if (term->op == Op::cross) return negative(cross(term->parts[1], term->parts[0]));
  return nullptr;
}

Term triple(const Term& term, Scene& scene) {
  if (term->op == Op::dot) {
    const Term& a = term->parts[0];
    const Term& b = term->parts[1];
    if (b->op == Op::cross && scene.random.one_in(2)) return dot(cross(a, b->parts[0]), b->parts[1]);
    if (b->op == Op::cross) return dot(b->parts[0], cross(b->parts[1], a));
    if (a->op == Op::cross) return dot(a->parts[0], cross(a->parts[1], b));
  }
  if (term->op != Op::cross || term->parts[1]->op != Op::cross) return nullptr;
  const Term& a = term->parts[0];
  const Term& b = term->parts[1]->parts[0];
  const Term& c = term->parts[1]->parts[1];
  return sum({product({dot(a, c), b}), negative(product({dot(a, b), c}))});
}

Term without_scalars(const Term& vector, std::vector<Term>& scalars) {
  if (vector->op == Op::negative) {
    scalars.push_back(number(-1));
    return without_scalars(vector->parts[0], scalars);
  }
  if (vector->op != Op::product) return vector;
  Term rest;
  for (const Term& part : vector->parts)
    (part->rank == 0 ? (void)scalars.push_back(part) : (void)(rest = part));
  return rest;
}

/// (aA)·B = a A·B, (A + B)·C = A·C + B·C
Term bilinear(const Term& term, Scene& scene) {
  if (term->op != Op::dot && term->op != Op::cross && term->op != Op::act) return nullptr;
  const std::size_t side = term->op == Op::act ? 1 : scene.random.below(2);
  std::vector<Term> parts = term->parts;
  if (parts[side]->op == Op::sum) {
    std::vector<Term> terms;
    for (const Term& part : term->parts[side]->parts) {
      const bool minus = part->op == Op::negative;
      parts[side] = minus ? part->parts[0] : part;
      const Term next = make(term->op, parts);
      terms.push_back(minus ? negative(next) : next);
    }
    return sum(terms);
  }
  std::vector<Term> scalars;
  parts[side] = without_scalars(parts[side], scalars);
  if (scalars.empty()) return nullptr;
  const bool minus = std::count_if(scalars.begin(), scalars.end(),
                                   [](const Term& s) { return s->op == Op::number && s->p == -1; }) %
                         2 ==
                     1;
  scalars.erase(std::remove_if(scalars.begin(), scalars.end(),
                               [](const Term& s) { return s->op == Op::number && s->p == -1; }),
                scalars.end());
  scalars.push_back(make(term->op, parts));
  return minus ? negative(product(scalars)) : product(scalars);
}

Term squares(const Term& term, Scene&) {
  if (term->op == Op::dot && same(term->parts[0], term->parts[1]))
    return power(make(Op::length, {term->parts[0]}), 2);
  if (term->op != Op::power || term->p != 2 || term->parts[0]->op != Op::length) return nullptr;
  const Term& of = term->parts[0]->parts[0];
  const auto square = [](const Term& v) { return power(make(Op::length, {v}), 2); };
  if (of->op == Op::cross)
    return sum({product({square(of->parts[0]), square(of->parts[1])}),
                negative(power(dot(of->parts[0], of->parts[1]), 2))});
  return dot(of, of);
}

Term any_vector(Scene& scene, Nature nature) {
  for (int tries = 0; tries < 6; ++tries) {
    const std::size_t letter = scene.random.below(scene.letters.size());
    const Letter& taken = scene.letters[letter];
    if (taken.rank == 1 && !taken.of_particles && taken.nature == nature)
      return symbol(scene.letters, letter);
  }
  return nullptr;
}

Term along_and_across(const Term& term, Scene& scene) {
  const Term n = any_vector(scene, Nature::unit);
  if (term->op != Op::symbol || term->rank != 1 || n == nullptr || term->dots > 0) return nullptr;
  return sum({product({dot(term, n), n}), cross(cross(n, term), n)});
}

Term nothing_added(const Term& term, Scene& scene) {
  const Term v = any_vector(scene, Nature::free);
  if (term->op != Op::symbol || term->rank != 1 || v == nullptr) return nullptr;
  return sum({term, cross(v, v)});
}

// --- indices ---

std::string take(Scene& scene, std::size_t count) {
  if (scene.fresh.size() < count) return {};
  const std::string taken = scene.fresh.substr(0, count);
  scene.fresh.erase(0, count);
  return taken;
}

/// The component of a vector that has been built of letters; nothing: it stays in brackets.
Term component_of(const Term& vector, char slot, Scene& scene) {
  if (vector->op == Op::symbol) {
    Node node = *vector;
    node.slots = slot;
    node.rank = 0;
    return std::make_shared<const Node>(node);
  }
  if (vector->op == Op::product) {
    std::vector<Term> parts = vector->parts;
    for (Term& part : parts)
      if (part->rank > 0) part = component_of(part, slot, scene);
    return product(parts);
  }
  if (vector->op == Op::sum || vector->op == Op::negative) {
    std::vector<Term> parts;
    for (const Term& part : vector->parts) parts.push_back(component_of(part, slot, scene));
    return vector->op == Op::sum ? sum(parts) : negative(parts[0]);
  }
  return with_slots(Op::component, vector, std::string(1, slot));
}

Term in_components(const Term& term, Scene& scene) {
  if (term->op == Op::dot) {
    const std::string i = take(scene, 1);
    if (i.empty()) return nullptr;
    return contract(
        i, product({component_of(term->parts[0], i[0], scene), component_of(term->parts[1], i[0], scene)}));
  }
  if (term->op != Op::component) return nullptr;
  const Term& vector = term->parts[0];
  if (vector->op == Op::cross) {
    const std::string jk = take(scene, 2);
    if (jk.empty()) return nullptr;
    return contract(jk, product({epsilon(term->slots + jk), component_of(vector->parts[0], jk[0], scene),
                                 component_of(vector->parts[1], jk[1], scene)}));
  }
  if (vector->op == Op::act) {
    const std::string j = take(scene, 1);
    if (j.empty() || vector->parts[0]->op != Op::symbol) return nullptr;
    const Term tensor = symbol(scene.letters, vector->parts[0]->letter, term->slots + j);
    return contract(j, product({tensor, component_of(vector->parts[1], j[0], scene)}));
  }
  return component_of(vector, term->slots[0], scene);
}

/// A_i = δ_ij A_j
Term with_delta(const Term& term, Scene& scene) {
  if (term->op != Op::symbol || term->slots.empty() || term->slots[0] < 'i') return nullptr;
  const std::string j = take(scene, 1);
  if (j.empty()) return nullptr;
  Node node = *term;
  node.slots[0] = j[0];
  const std::string pair{term->slots[0], j[0]};
  return contract(j, product({delta(pair), std::make_shared<const Node>(node)}));
}

Term with_slots_turned(const Term& term, Scene& scene) {
  if (term->op == Op::delta) return delta({term->slots[1], term->slots[0]});
  if (term->op == Op::epsilon) {
    const std::string& s = term->slots;
    return scene.random.one_in(2) ? epsilon({s[1], s[2], s[0]}) : negative(epsilon({s[1], s[0], s[2]}));
  }
  if (term->op != Op::symbol || term->slots.size() != 2 || !scene.letters[term->letter].symmetric)
    return nullptr;
  return symbol(scene.letters, term->letter, {term->slots[1], term->slots[0]});
}

std::string renamed(std::string slots, char from, char to) {
  std::replace(slots.begin(), slots.end(), from, to);
  return slots;
}

Term renamed(const Term& term, char from, char to) {
  std::vector<Term> parts;
  for (const Term& part : term->parts) parts.push_back(renamed(part, from, to));
  Node node = *term;
  node.parts = parts;
  node.slots = renamed(node.slots, from, to);
  return std::make_shared<const Node>(node);
}

Term dummy_renamed(const Term& term, Scene& scene) {
  if (term->op != Op::contract) return nullptr;
  const std::string fresh = take(scene, 1);
  if (fresh.empty()) return nullptr;
  return renamed(term, term->slots[scene.random.below(term->slots.size())], fresh[0]);
}

/// ε_iab ε_icd = δ_ac δ_bd − δ_ad δ_bc, where both begin with the same summed index.
Term epsilons_contracted(const Term& term, Scene&) {
  if (term->op != Op::contract || term->parts[0]->op != Op::product) return nullptr;
  std::vector<Term> rest;
  std::vector<std::string> found;
  for (const Term& part : term->parts[0]->parts) {
    if (part->op == Op::epsilon && found.size() < 2) {
      found.push_back(part->slots);
    } else {
      rest.push_back(part);
    }
  }
  if (found.size() != 2 || found[0][0] != found[1][0]) return nullptr;
  const std::string slots = std::string(term->slots).erase(term->slots.find(found[0][0]), 1);
  if (term->slots.find(found[0][0]) == std::string::npos) return nullptr;
  const auto pair = [&](std::size_t a, std::size_t b) { return delta({found[0][a], found[1][b]}); };
  rest.push_back(sum({product({pair(1, 1), pair(2, 2)}), negative(product({pair(1, 2), pair(2, 1)}))}));
  return slots.empty() ? product(rest) : contract(slots, product(rest));
}

Term contracted_out(const Term& term, Scene&) {
  if (term->op == Op::product) {
    std::vector<Term> parts = term->parts;
    std::string slots;
    for (Term& part : parts) {
      if (part->op != Op::contract) continue;
      slots += part->slots;
      part = part->parts[0];
    }
    return slots.empty() ? nullptr : contract(slots, product(parts));
  }
  if (term->op == Op::contract && term->parts[0]->op == Op::contract)
    return contract(term->slots + term->parts[0]->slots, term->parts[0]->parts[0]);
  if (term->op != Op::contract || term->parts[0]->op != Op::sum) return nullptr;
  std::vector<Term> parts;
  for (const Term& part : term->parts[0]->parts) {
    const bool minus = part->op == Op::negative;
    const Term inner = contract(term->slots, minus ? part->parts[0] : part);
    parts.push_back(minus ? negative(inner) : inner);
  }
  return sum(parts);
}

// --- particles ---

Term particles_apart(const Term& term, Scene&) {
  if (term->op != Op::particle_sum || term->parts[0]->op != Op::sum) return nullptr;
  std::vector<Term> parts;
  for (const Term& part : term->parts[0]->parts) {
    const bool minus = part->op == Op::negative;
    const Term inner = particle_sum(term->particle, minus ? part->parts[0] : part);
    parts.push_back(minus ? negative(inner) : inner);
  }
  return sum(parts);
}

bool mentions(const Term& term, char particle) {
  bool found = false;
  visit(term, [&](const Node& node) { found = found || node.particle == particle; });
  return found;
}

Term out_of_sum(const Term& term, Scene&) {
  if (term->op != Op::particle_sum || term->parts[0]->op != Op::product) return nullptr;
  std::vector<Term> outside;
  std::vector<Term> inside;
  for (const Term& part : term->parts[0]->parts) {
    const bool labelled = mentions(part, term->particle) || part->rank > 0;
    (labelled ? inside : outside).push_back(part);
  }
  if (outside.empty() || inside.empty()) return nullptr;
  outside.push_back(particle_sum(term->particle, product(inside)));
  return product(outside);
}

Term with_particle(const Term& term, char from, char to) {
  std::vector<Term> parts;
  for (const Term& part : term->parts) parts.push_back(with_particle(part, from, to));
  Node node = *term;
  node.parts = parts;
  if (node.particle == from) node.particle = to;
  return std::make_shared<const Node>(node);
}

Term particle_renamed(const Term& term, Scene&) {
  if (term->op != Op::particle_sum) return nullptr;
  const char other = term->particle == 'a' ? 'b' : 'a';
  return mentions(term->parts[0], other) ? nullptr : with_particle(term, term->particle, other);
}

/// A·Σ m r = Σ m A·r
Term into_sum(const Term& term, Scene&) {
  if (term->op != Op::dot && term->op != Op::cross) return nullptr;
  const Term& summed = term->parts[1];
  if (summed->op != Op::particle_sum || mentions(term->parts[0], summed->particle)) return nullptr;
  return particle_sum(summed->particle, make(term->op, {term->parts[0], summed->parts[0]}));
}

}  // namespace

const std::vector<Rule>& vector_rules() {
  static const std::vector<Rule> rules{turned,   triple,  triple,           bilinear,
                                       bilinear, squares, along_and_across, nothing_added};
  return rules;
}

const std::vector<Rule>& index_rules() {
  static const std::vector<Rule> rules{in_components,       with_delta,     with_slots_turned, dummy_renamed,
                                       epsilons_contracted, contracted_out, particles_apart,   out_of_sum,
                                       particle_renamed,    into_sum,       in_components};
  return rules;
}

}  // namespace fuzz
