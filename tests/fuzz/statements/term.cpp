// SPDX-License-Identifier: GPL-3.0-or-later
#include "term.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace fuzz {
namespace {

int rank_of(Op op, const std::vector<Term>& parts) {
  switch (op) {
    case Op::sum:
    case Op::negative:
    case Op::quotient:
    case Op::contract:
    case Op::particle_sum:
    case Op::rate:
    case Op::rate_in:
    case Op::rate_rot:
    case Op::partial:
    case Op::laplacian:
      return parts[0]->rank;
    case Op::product: {
      int rank = 0;
      for (const Term& part : parts) rank = std::max(rank, part->rank);
      return rank;
    }
    case Op::cross:
    case Op::act:
    case Op::gradient:
    case Op::curl:
      return 1;
    case Op::along:
      return parts[1]->rank;
    default:
      return 0;
  }
}

bool all_rank(const Node& node, std::initializer_list<int> ranks) {
  return std::equal(node.parts.begin(), node.parts.end(), ranks.begin(), ranks.end(),
                    [](const Term& part, int rank) { return part->rank == rank; });
}

bool ranks_fit(const Node& node) {
  const auto& parts = node.parts;
  switch (node.op) {
    case Op::sum:
      return std::all_of(parts.begin(), parts.end(),
                         [&](const Term& part) { return part->rank == parts[0]->rank; });
    case Op::product:
      return std::count_if(parts.begin(), parts.end(), [](const Term& part) { return part->rank > 0; }) <= 1;
    case Op::quotient:
      return parts[1]->rank == 0;
    case Op::power:
    case Op::root:
    case Op::absolute:
    case Op::function:
    case Op::gradient:
      return all_rank(node, {0});
    case Op::length:
    case Op::component:
    case Op::rate_in:
    case Op::rate_rot:
    case Op::divergence:
    case Op::curl:
      return all_rank(node, {1});
    case Op::dot:
    case Op::cross:
      return all_rank(node, {1, 1});
    case Op::act:
      return all_rank(node, {2, 1});
    case Op::trace:
      return all_rank(node, {2});
    case Op::along:
      return parts[0]->rank == 1;
    default:
      return true;
  }
}

using Occurrences = std::map<char, int>;

bool is_index(char slot) { return slot >= 'i' && slot <= 'n'; }

/// Counts of the indices in a term as it is written; nothing: it is not well formed.
class Balance {
 public:
  explicit Balance(const std::vector<Letter>& letters) : letters_(letters) {}

  std::optional<Occurrences> of(const Term& term) {
    if (!ranks_fit(*term) || !slots_fit(*term)) return std::nullopt;
    if (term->op == Op::sum) return of_sum(*term);
    if (term->op == Op::particle_sum) {
      if (bound_.find(term->particle) != std::string::npos) return std::nullopt;
      bound_.push_back(term->particle);
      auto inner = of_parts(*term);
      bound_.pop_back();
      return inner;
    }
    auto found = of_parts(*term);
    if (!found) return std::nullopt;
    for (const char slot : term->op == Op::contract ? std::string() : term->slots)
      if (is_index(slot)) ++(*found)[slot];
    return fits(*term, *found) ? found : std::nullopt;
  }

 private:
  bool slots_fit(const Node& node) const {
    if (node.op == Op::symbol) {
      const Letter& letter = letters_[node.letter];
      const bool labelled = node.particle != 0;
      if (labelled != letter.of_particles) return false;
      if (labelled && bound_.find(node.particle) == std::string::npos) return false;
      return node.slots.empty() || node.slots.size() == static_cast<std::size_t>(letter.rank);
    }
    return true;
  }

  std::optional<Occurrences> of_parts(const Node& node) {
    Occurrences all;
    for (const Term& part : node.parts) {
      const auto inner = of(part);
      if (!inner) return std::nullopt;
      for (const auto& [index, count] : *inner) all[index] += count;
    }
    return all;
  }

  std::optional<Occurrences> of_sum(const Node& node) {
    Occurrences all;
    std::optional<std::string> free;
    for (const Term& part : node.parts) {
      const auto inner = of(part);
      if (!inner) return std::nullopt;
      const std::string its = free_of(*inner);
      if (free && *free != its) return std::nullopt;
      free = its;
      for (const auto& [index, count] : *inner) all[index] = std::max(all[index], count);
    }
    return all;
  }

  static bool fits(const Node& node, const Occurrences& found) {
    for (const auto& [index, count] : found) {
      if (count > 2) return false;
      const bool bound = node.op == Op::contract && node.slots.find(index) != std::string::npos;
      if (bound && count != 2) return false;
    }
    if (node.op == Op::contract)
      return std::all_of(node.slots.begin(), node.slots.end(),
                         [&](char slot) { return found.count(slot) == 1; });
    const bool scalar_only = node.op == Op::power || node.op == Op::root || node.op == Op::function ||
                             node.op == Op::absolute || node.op == Op::particle_sum;
    return !scalar_only || free_of(found).empty();
  }

  static std::string free_of(const Occurrences& found) {
    std::string free;
    for (const auto& [index, count] : found)
      if (count == 1) free += index;
    return free;
  }

  const std::vector<Letter>& letters_;
  std::string bound_;
};

/// Each index that stands twice in its term is summed by a `contract` around it, and is so only once.
bool bound_once(const Term& term, std::string bound) {
  if (term->op == Op::contract) {
    for (const char slot : term->slots) {
      if (bound.find(slot) != std::string::npos) return false;
      bound += slot;
    }
  }
  return std::all_of(term->parts.begin(), term->parts.end(),
                     [&](const Term& part) { return bound_once(part, bound); });
}

void collect_free(const Term& term, std::string bound, Occurrences& free) {
  if (term->op == Op::contract) {
    bound += term->slots;
  } else {
    for (const char slot : term->slots)
      if (is_index(slot) && bound.find(slot) == std::string::npos) ++free[slot];
  }
  if (term->op != Op::sum) {
    for (const Term& part : term->parts) collect_free(part, bound, free);
    return;
  }
  for (const Term& part : term->parts) {
    Occurrences inner;
    collect_free(part, bound, inner);
    for (const auto& [index, count] : inner) free[index] = std::max(free[index], count);
  }
}

Term rebuilt_at(const Term& term, std::size_t& position, const Term& replacement) {
  if (position-- == 0) return replacement;
  std::vector<Term> parts = term->parts;
  for (Term& part : parts) {
    const std::size_t inside = size(part);
    if (position < inside) {
      part = rebuilt_at(part, position, replacement);
      return rebuilt(term, std::move(parts));
    }
    position -= inside;
  }
  return term;
}

}  // namespace

Term make(Op op, std::vector<Term> parts) {
  Node node;
  node.op = op;
  node.rank = rank_of(op, parts);
  node.parts = std::move(parts);
  return std::make_shared<const Node>(std::move(node));
}

Term rebuilt(const Term& term, std::vector<Term> parts) {
  if (term->op == Op::sum) return sum(std::move(parts));
  if (term->op == Op::product) return product(std::move(parts));
  if (term->op == Op::negative) return negative(parts[0]);
  Node node = *term;
  node.bare = node.bare && parts[0]->op == Op::product && parts[0]->parts.size() == 2 &&
              parts[0]->parts[0]->op == Op::symbol && parts[0]->parts[1]->op == Op::sum;
  if (!parts.empty()) node.rank = rank_of(node.op, parts);
  node.parts = std::move(parts);
  return std::make_shared<const Node>(std::move(node));
}

Term number(long p, long q) {
  Node node;
  node.p = p;
  node.q = q;
  return std::make_shared<const Node>(std::move(node));
}

Term decimal(double value, int decimals) {
  Node node;
  node.decimals = decimals;
  for (int k = 0; k < decimals; ++k) node.q *= 10;
  node.p = std::lround(value * static_cast<double>(node.q));
  return std::make_shared<const Node>(std::move(node));
}

Term zero(int rank) {
  Node node;
  node.rank = rank;
  return std::make_shared<const Node>(std::move(node));
}

Term symbol(const std::vector<Letter>& letters, std::size_t letter, std::string slots, char particle,
            int dots) {
  Node node;
  node.op = Op::symbol;
  node.letter = letter;
  node.rank = slots.empty() ? letters[letter].rank : 0;
  node.slots = std::move(slots);
  node.particle = particle;
  node.dots = dots;
  return std::make_shared<const Node>(std::move(node));
}

Term delta(std::string slots) { return with_slots(Op::delta, nullptr, std::move(slots)); }
Term epsilon(std::string slots) { return with_slots(Op::epsilon, nullptr, std::move(slots)); }

Term sum(std::vector<Term> parts) {
  std::vector<Term> flat;
  for (const Term& part : parts) {
    if (part->op == Op::sum) {
      flat.insert(flat.end(), part->parts.begin(), part->parts.end());
    } else {
      flat.push_back(part);
    }
  }
  return flat.size() == 1 ? flat[0] : make(Op::sum, std::move(flat));
}

Term product(std::vector<Term> parts) {
  std::vector<Term> flat;
  for (const Term& part : parts) {
    if (part->op == Op::product) {
      flat.insert(flat.end(), part->parts.begin(), part->parts.end());
    } else {
      flat.push_back(part);
    }
  }
  return flat.size() == 1 ? flat[0] : make(Op::product, std::move(flat));
}

Term negative(Term part) {
  return part->op == Op::negative ? part->parts[0] : make(Op::negative, {std::move(part)});
}

Term power(Term base, long exponent) {
  Node node;
  node.op = Op::power;
  node.parts = {std::move(base)};
  node.p = exponent;
  return std::make_shared<const Node>(std::move(node));
}

Term function_of(Function function, Term argument) {
  Node node;
  node.op = Op::function;
  node.parts = {std::move(argument)};
  node.function = function;
  return std::make_shared<const Node>(std::move(node));
}

Term contract(std::string slots, Term part) {
  return with_slots(Op::contract, std::move(part), std::move(slots));
}

Term particle_sum(char particle, Term part) {
  Node node;
  node.op = Op::particle_sum;
  node.rank = part->rank;
  node.particle = particle;
  node.parts = {std::move(part)};
  return std::make_shared<const Node>(std::move(node));
}

Term with_slots(Op op, Term part, std::string slots) {
  Node node;
  node.op = op;
  if (part != nullptr) node.parts = {std::move(part)};
  node.rank = node.parts.empty() ? 0 : rank_of(op, node.parts);
  node.slots = std::move(slots);
  return std::make_shared<const Node>(std::move(node));
}

std::size_t size(const Term& term) {
  std::size_t sum = 1;
  for (const Term& part : term->parts) sum += size(part);
  return sum;
}

bool same(const Term& a, const Term& b) {
  if (a == b) return true;
  if (a->parts.size() != b->parts.size()) return false;
  const auto key = [](const Node& n) {
    return std::tuple(n.bare, n.decimals, n.op, n.letter, n.slots, n.particle, n.dots, n.function, n.p, n.q);
  };
  return key(*a) == key(*b) &&
         std::equal(a->parts.begin(), a->parts.end(), b->parts.begin(), b->parts.end(), same);
}

const Term& node_at(const Term& term, std::size_t position) {
  if (position-- == 0) return term;
  for (const Term& part : term->parts) {
    const std::size_t inside = size(part);
    if (position < inside) return node_at(part, position);
    position -= inside;
  }
  return term;
}

Term replaced(const Term& term, std::size_t position, const Term& replacement) {
  return rebuilt_at(term, position, replacement);
}

void visit(const Term& term, const std::function<void(const Node&)>& see) {
  see(*term);
  for (const Term& part : term->parts) visit(part, see);
}

bool well_formed(const Term& term, const std::vector<Letter>& letters, std::string& free) {
  if (!Balance(letters).of(term) || !bound_once(term, "")) return false;
  Occurrences found;
  collect_free(term, "", found);
  free.clear();
  for (const auto& [index, count] : found) {
    if (count > 1) return false;
    free += index;
  }
  return true;
}

Term read_otherwise(const Term& term) {
  if (term->bare)
    return product({function_of(term->function, term->parts[0]->parts[0]), term->parts[0]->parts[1]});
  std::vector<Term> parts;
  for (const Term& part : term->parts) parts.push_back(read_otherwise(part));
  return parts.empty() ? term : rebuilt(term, std::move(parts));
}

int derivative_order(const Term& term) {
  int inner = 0;
  for (const Term& part : term->parts) inner = std::max(inner, derivative_order(part));
  switch (term->op) {
    case Op::rate:
    case Op::rate_in:
    case Op::rate_rot:
    case Op::partial:
    case Op::gradient:
    case Op::divergence:
    case Op::curl:
    case Op::along:
      return inner + 1;
    case Op::laplacian:
      return inner + 2;
    case Op::symbol:
      return term->dots;
    default:
      return inner;
  }
}

}  // namespace fuzz
