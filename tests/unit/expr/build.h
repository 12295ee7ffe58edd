// SPDX-License-Identifier: GPL-3.0-or-later
// Expression trees for tests, written nearly as on paper: `dot(A, cross(B, C))`, `sum({i, j}, at(I, i, j) *
// at(w, i) * at(w, j))`. A Page holds a tree and the question asked of it; terms know their page.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor::build {

struct Term {
  ExprTree* tree = nullptr;
  ExprId id{};

  [[nodiscard]] int rank() const { return (*tree)[id].rank; }
};

[[nodiscard]] inline Term node(Op op, std::initializer_list<Term> children, int rank, ExprNode more = {}) {
  std::vector<ExprId> ids;
  for (const Term& child : children) ids.push_back(child.id);
  more.op = op;
  more.rank = static_cast<std::uint8_t>(rank);
  ExprTree* tree = children.begin()->tree;
  return {tree, tree->add(more, ids)};
}

[[nodiscard]] inline Term number_like(const Term& other, const std::string& digits) {
  return {other.tree, other.tree->add_number({}, digits)};
}

[[nodiscard]] inline Term operator+(const Term& a, const Term& b) { return node(Op::add, {a, b}, a.rank()); }
[[nodiscard]] inline Term operator-(const Term& a) { return node(Op::negate, {a}, a.rank()); }
[[nodiscard]] inline Term operator-(const Term& a, const Term& b) { return a + -b; }
[[nodiscard]] inline Term operator*(const Term& a, const Term& b) {
  return node(Op::multiply, {a, b}, a.rank() + b.rank());
}
[[nodiscard]] inline Term operator*(int a, const Term& b) { return number_like(b, std::to_string(a)) * b; }
[[nodiscard]] inline Term operator/(const Term& a, const Term& b) {
  return node(Op::divide, {a, b}, a.rank());
}
[[nodiscard]] inline Term operator/(const Term& a, int b) { return a / number_like(a, std::to_string(b)); }
[[nodiscard]] inline Term operator/(int a, const Term& b) { return number_like(b, std::to_string(a)) / b; }
[[nodiscard]] inline Term pow(const Term& a, int exponent) {
  return node(Op::power, {a}, 0, ExprNode{.op = Op::power, .exponent = exponent});
}
[[nodiscard]] inline Term dot(const Term& a, const Term& b) {
  return node(Op::dot, {a, b}, a.rank() + b.rank() - 2);
}
[[nodiscard]] inline Term cross(const Term& a, const Term& b) { return node(Op::cross, {a, b}, 1); }
[[nodiscard]] inline Term length(const Term& a) { return node(Op::length, {a}, 0); }
[[nodiscard]] inline Term squared(const Term& a) { return a.rank() == 1 ? pow(length(a), 2) : pow(a, 2); }
[[nodiscard]] inline Term absolute(const Term& a) { return node(Op::absolute, {a}, 0); }
[[nodiscard]] inline Term function(Function function, const Term& of) {
  return node(Op::function, {of}, 0, ExprNode{.op = Op::function, .function = function});
}
[[nodiscard]] inline Term sin(const Term& a) { return function(Function::sin, a); }
[[nodiscard]] inline Term cos(const Term& a) { return function(Function::cos, a); }
[[nodiscard]] inline Term exp(const Term& a) { return function(Function::exp, a); }
[[nodiscard]] inline Term root(const Term& a) { return node(Op::root, {a}, 0); }
[[nodiscard]] inline Term tuple(const Term& x, const Term& y, const Term& z) {
  return node(Op::tuple, {x, y, z}, x.rank() + 1);
}
[[nodiscard]] inline Term sum(std::initializer_list<IndexId> indices, Term body) {
  for (auto index = std::rbegin(indices); index != std::rend(indices); ++index) {
    body = node(Op::index_sum, {body}, body.rank(), ExprNode{.op = Op::index_sum, .index = *index});
  }
  return body;
}
[[nodiscard]] inline Term over(ParticleId particle, const Term& body) {
  return node(Op::particle_sum, {body}, body.rank(), ExprNode{.op = Op::particle_sum, .particle = particle});
}

/// An index variable or a literal axis, as a place for either.
struct Place {
  Place(IndexId variable) : slot{.axis = 0, .variable = variable} {}  // NOLINT: meant to convert
  Place(int axis) : slot{.axis = static_cast<std::uint8_t>(axis), .variable = {}} {}  // NOLINT
  Slot slot;
};

/// A symbol, for one particle if it is per particle; as a term, the whole symbol.
struct Named {
  ExprTree* tree = nullptr;
  SymbolId symbol{};
  ParticleId particle = no_particle;

  [[nodiscard]] Named operator()(ParticleId of) const { return {tree, symbol, of}; }
  operator Term() const {  // NOLINT: meant to convert
    const auto rank = static_cast<std::uint8_t>(tree->symbols[symbol].rank);
    return {tree,
            tree->add(ExprNode{.op = Op::symbol, .rank = rank, .symbol = symbol, .particle = particle})};
  }
};

template <class... Slots>
[[nodiscard]] Term at(const Named& symbol, const Slots&... slots) {
  const std::vector<Slot> all{Place(slots).slot...};
  const ExprNode node{.op = Op::symbol, .symbol = symbol.symbol, .particle = symbol.particle};
  return {symbol.tree, symbol.tree->add(node, {}, all)};
}

template <class... Slots>
[[nodiscard]] Term component(const Term& of, const Slots&... slots) {
  const std::vector<Slot> all{Place(slots).slot...};
  return {of.tree, of.tree->add(ExprNode{.op = Op::component}, std::vector{of.id}, all)};
}

/// A tree, with what is declared on it, and the question asked.
class Page {
 public:
  Page() { question.tree = &tree; }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  ExprTree tree;
  Question question;

  [[nodiscard]] Named add(Symbol symbol) { return {&tree, tree.symbols.add(std::move(symbol)), no_particle}; }
  [[nodiscard]] Named scalar(std::string name) { return add({.name = std::move(name)}); }
  [[nodiscard]] Named vector(std::string name) { return add({.name = std::move(name), .rank = 1}); }
  [[nodiscard]] Named tensor(std::string name) { return add({.name = std::move(name), .rank = 2}); }
  [[nodiscard]] Named symmetric(std::string name) {
    return add({.name = std::move(name), .rank = 2, .symmetric = true});
  }
  [[nodiscard]] Named unit(std::string name) {
    return add({.name = std::move(name), .rank = 1, .unit = true});
  }
  [[nodiscard]] Named rotation(std::string name) {
    return add({.name = std::move(name), .rank = 2, .rotation = true});
  }
  [[nodiscard]] Named derivative(const Named& of, By by) {
    return {&tree, tree.symbols.derivative(of.symbol, by), of.particle};
  }
  [[nodiscard]] Named scalars(std::string name) {
    return add({.name = std::move(name), .per_particle = true});
  }
  [[nodiscard]] Named vectors(std::string name) {
    return add({.name = std::move(name), .rank = 1, .per_particle = true});
  }

  [[nodiscard]] IndexId index(std::string name) { return tree.add_index(std::move(name)); }
  [[nodiscard]] ParticleId particle(std::string name) { return tree.add_particle(std::move(name)); }

  [[nodiscard]] Term number(const std::string& digits) { return {&tree, tree.add_number({}, digits)}; }
  [[nodiscard]] Term zero() { return number("0"); }
  [[nodiscard]] Term delta(Place i, Place j) { return slotted(Op::delta, 0, {i.slot, j.slot}); }
  [[nodiscard]] Term epsilon(Place i, Place j, Place k) {
    return slotted(Op::epsilon, 0, {i.slot, j.slot, k.slot});
  }
  [[nodiscard]] Term basis(Place i) { return slotted(Op::basis, 1, {i.slot}); }
  [[nodiscard]] Term zero_vector() { return tuple(zero(), zero(), zero()); }
  [[nodiscard]] Term determinant(const std::vector<Term>& rows) {
    std::vector<ExprId> ids;
    int rank = 0;
    for (const Term& each : rows) {
      ids.push_back(each.id);
      rank = std::max(rank, each.rank());
    }
    return {&tree, tree.add(ExprNode{.op = Op::determinant, .rank = static_cast<std::uint8_t>(rank)}, ids)};
  }

  void define(const Named& symbol, const Term& body, std::vector<IndexId> indices = {}) {
    question.definitions.push_back({symbol.symbol, std::move(indices), symbol.particle, body.id});
  }
  void given(const Term& left, const Term& right, std::vector<IndexId> indices = {},
             std::vector<ParticleId> particles = {}) {
    question.assumptions.push_back({left.id, right.id, std::move(indices), std::move(particles)});
  }
  void given(const Term& left, Relation relation, const Term& right, std::vector<ParticleId> particles = {}) {
    question.assumptions.push_back({left.id, right.id, {}, std::move(particles), relation});
  }
  const Question& claim(const Term& left, Relation relation, const Term& right,
                        std::vector<ParticleId> particles = {}) {
    question.claim = {left.id, right.id, {}, std::move(particles), relation};
    return question;
  }
  const Question& claim(const Term& left, const Term& right, std::vector<IndexId> indices = {},
                        std::vector<ParticleId> particles = {}) {
    question.claim = {left.id, right.id, std::move(indices), std::move(particles)};
    return question;
  }

 private:
  [[nodiscard]] Term slotted(Op op, int rank, std::vector<Slot> slots) {
    return {&tree, tree.add(ExprNode{.op = op, .rank = static_cast<std::uint8_t>(rank)}, {}, slots)};
  }
};

}  // namespace rigor::build
