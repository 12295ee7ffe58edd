// SPDX-License-Identifier: GPL-3.0-or-later
#include "rewrite.h"

#include <algorithm>

namespace fuzz {
namespace {

constexpr std::size_t most_nodes = 60;

const std::vector<Rule>& all_rules() {
  static const std::vector<Rule> all = [] {
    std::vector<Rule> rules;
    for (const auto* some : {&scalar_rules(), &vector_rules(), &index_rules(), &derivative_rules()})
      rules.insert(rules.end(), some->begin(), some->end());
    return rules;
  }();
  return all;
}

/// Is `next` as well formed as `term` was, with the same free indices?
bool fits(const Term& next, const Term& term, const std::vector<Letter>& letters) {
  std::string before;
  std::string after;
  return size(next) <= most_nodes && next->rank == term->rank && well_formed(term, letters, before) &&
         well_formed(next, letters, after) && before == after;
}

// --- slips: each gives a term like its own, or nothing ---

Term other_sign(const Term& term, Scene& scene) {
  if (term->op == Op::negative) return term->parts[0];
  if (term->op != Op::sum) return nullptr;
  std::vector<Term> parts = term->parts;
  Term& part = parts[scene.random.below(parts.size())];
  part = negative(part);
  return sum(parts);
}

Term part_dropped(const Term& term, Scene& scene) {
  if (term->op != Op::sum && term->op != Op::product) return nullptr;
  std::vector<Term> parts = term->parts;
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(scene.random.below(parts.size())));
  return term->op == Op::sum ? sum(parts) : product(parts);
}

Term other_number(const Term& term, Scene& scene) {
  if (term->op == Op::number) return number(term->p + (scene.random.one_in(2) ? 1 : 2), term->q);
  if (term->op == Op::power) return power(term->parts[0], term->p == 2 ? 3 : 2);
  return nullptr;
}

Term factor_added(const Term& term, Scene& scene) {
  if (term->op == Op::number) return nullptr;
  return product({scene.random.one_in(2) ? number(2) : number(1, 2), term});
}

Term other_letter(const Term& term, Scene& scene) {
  if (term->op != Op::symbol) return nullptr;
  const std::size_t other = scene.random.below(scene.letters.size());
  if (other == term->letter || scene.letters[other].rank != scene.letters[term->letter].rank) return nullptr;
  Node node = *term;
  node.letter = other;
  if (!scene.letters[other].of_particles) node.particle = 0;
  return std::make_shared<const Node>(node);
}

Term exchanged(const Term& term, Scene&) {
  if (term->op == Op::cross || term->op == Op::quotient) {
    if (term->op == Op::quotient && term->parts[0]->rank > 0) return nullptr;
    return make(term->op, {term->parts[1], term->parts[0]});
  }
  if (term->slots.size() < 2 || term->op == Op::contract) return nullptr;
  Node node = *term;
  std::swap(node.slots[0], node.slots[1]);
  return std::make_shared<const Node>(node);
}

Term other_function(const Term& term, Scene& scene) {
  if (term->op == Op::absolute || term->op == Op::rate || term->op == Op::partial) return term->parts[0];
  if (term->op == Op::rate_in || term->op == Op::rate_rot)
    return make(term->op == Op::rate_in ? Op::rate_rot : Op::rate_in, term->parts);
  if (term->op != Op::function) return nullptr;
  return function_of(static_cast<Function>(scene.random.below(8)), term->parts[0]);
}

const std::vector<Rule>& slips() {
  static const std::vector<Rule> all{other_sign,   part_dropped, other_number,  factor_added,
                                     other_letter, exchanged,    other_function};
  return all;
}

Term changed(const Term& term, const std::vector<Letter>& letters, const std::vector<Rule>& rules,
             Random& random) {
  Scene scene{letters, random, unused_indices(term)};
  for (int tries = 0; tries < 40; ++tries) {
    const std::size_t position = random.below(size(term));
    const Term next = random.of(rules)(node_at(term, position), scene);
    if (next == nullptr) continue;
    const Term whole = replaced(term, position, next);
    if (fits(whole, term, letters)) return whole;
  }
  return term;
}

}  // namespace

std::string unused_indices(const Term& term) {
  std::string fresh = "ijklmn";
  visit(term, [&](const Node& node) {
    for (const char slot : node.slots)
      fresh.erase(std::remove(fresh.begin(), fresh.end(), slot), fresh.end());
  });
  return fresh;
}

Term rewritten(Term term, const std::vector<Letter>& letters, int count, Random& random) {
  for (int k = 0; k < count; ++k) term = changed(term, letters, all_rules(), random);
  return term;
}

Term mistaken(const Term& term, const std::vector<Letter>& letters, Random& random) {
  return changed(term, letters, slips(), random);
}

}  // namespace fuzz
