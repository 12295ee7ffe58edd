// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions that nobody would write, over the letters of one page: all operations, nested at random, always
// the same ones for a seed.
#pragma once

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include "elaborate/elaborated.h"

namespace rigor {

class RandomExpressions {
 public:
  explicit RandomExpressions(unsigned seed) : random_(seed) {
    for (const char* name : {"A", "B", "C"})
      page.declare({name, 1, false}, {.name = "\\mathbf{" + std::string(name) + "}"});
    for (const char* name : {"a", "b", "x", "T_{\\text{rot}}"}) page.declare({name, 0, false});
    page.declare({"S", 2, false}, {.name = "S"});
    page.declare({"m", 0, true}).declare({"r", 1, true}, {.name = "\\mathbf{r}"}).particles("\\alpha");
  }

  Statements page;

  [[nodiscard]] ExprId any(int depth) {
    const int rank = pick(4);
    return rank < 2 ? scalar(depth) : rank == 2 ? vector(depth) : tensor(depth);
  }

 private:
  [[nodiscard]] int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  [[nodiscard]] Slot axis() { return {static_cast<std::uint8_t>(1 + pick(3)), {}}; }

  ExprId add(Op op, int rank, std::initializer_list<ExprId> children, std::initializer_list<Slot> slots = {},
             ExprNode node = {.op = Op::add}) {
    node.op = op;
    node.rank = static_cast<std::uint8_t>(rank);
    const std::vector<ExprId> all(children);
    const std::vector<Slot> at(slots);
    return page.tree.add(node, all, at);
  }
  ExprId symbol(const NameKey& key, int rank, std::initializer_list<Slot> slots = {}) {
    ExprNode node{.op = Op::symbol, .symbol = *find_symbol(page.names.symbols, key)};
    if (key.per_particle) node.particle = particles_.back();
    return add(Op::symbol, rank, {}, slots, node);
  }
  ExprId power(ExprId base, int exponent) {
    return add(Op::power, 0, {base}, {}, {.op = Op::power, .exponent = exponent});
  }
  const char* vector_name() {
    static constexpr const char* names[] = {"A", "B", "C"};
    return names[pick(3)];
  }
  ExprId vector_at(Slot slot) {
    if (!particles_.empty() && pick(2) == 0) return symbol({"r", 1, true}, 0, {slot});
    return symbol({vector_name(), 1, false}, 0, {slot});
  }

  ExprId number() {
    static constexpr const char* digits[] = {"2", "3", "0.5", "10"};
    return page.tree.add_number({}, digits[pick(4)]);
  }

  ExprId small_scalar() {
    static constexpr const char* names[] = {"a", "b", "x", "T_{\\text{rot}}"};
    if (!particles_.empty() && pick(2) == 0) return symbol({"m", 0, true}, 0);
    switch (pick(6)) {
      case 0:
        return number();
      case 1:
        return vector_at(axis());
      case 2:
        return symbol({"S", 2, false}, 0, {axis(), axis()});
      case 3:
        return add(Op::length, 0, {symbol({vector_name(), 1, false}, 1)});
      default:
        return symbol({names[pick(4)], 0, false}, 0);
    }
  }

  ExprId scalar(int depth) {
    if (depth <= 0) return small_scalar();
    const int d = depth - 1;
    switch (pick(22)) {
      case 0:
        return add(Op::add, 0, {scalar(d), scalar(d), scalar(d)});
      case 1:
      case 2:
        return add(Op::add, 0, {scalar(d), add(Op::negate, 0, {scalar(d)})});
      case 3:
        return add(Op::negate, 0, {scalar(d)});
      case 4:
      case 5:
        return add(Op::multiply, 0, {scalar(d), scalar(d)});
      case 6:
        return add(Op::multiply, 0, {scalar(d), scalar(d), scalar(d)});
      case 7:
        return add(Op::divide, 0, {scalar(d), scalar(d)});
      case 8:
        return power(scalar(d), pick(7) - 3);
      case 9:
        return add(Op::root, 0, {scalar(d)});
      case 10:
        return power(add(Op::root, 0, {scalar(d)}), 2 + pick(3));
      case 11:
        return add(Op::length, 0, {vector(d)});
      case 12:
        return add(Op::absolute, 0, {scalar(d)});
      case 13:
      case 14:
        return add(Op::dot, 0, {vector(d), vector(d)});
      case 15:
        return add(Op::component, 0, {vector(d)}, {axis()});
      case 16:
        return add(Op::function, 0, {scalar(d)}, {},
                   {.op = Op::function, .function = static_cast<Function>(pick(3))});
      case 17:
        return determinant();
      case 18:
        return over_particles(0, d);
      default:
        return contraction(d);
    }
  }

  ExprId determinant() {
    return add(Op::determinant, 0,
               {small_scalar(), small_scalar(), small_scalar(), small_scalar(), scalar(1), small_scalar(),
                small_scalar(), small_scalar(), small_scalar()});
  }

  ExprId vector(int depth) {
    if (depth <= 0) {
      if (!particles_.empty() && pick(2) == 0) return symbol({"r", 1, true}, 1);
      return pick(4) == 0 ? add(Op::basis, 1, {}, {axis()}) : symbol({vector_name(), 1, false}, 1);
    }
    const int d = depth - 1;
    switch (pick(9)) {
      case 0:
        return add(Op::add, 1, {vector(d), vector(d)});
      case 1:
        return add(Op::add, 1, {vector(d), add(Op::negate, 1, {vector(d)})});
      case 2:
        return add(Op::multiply, 1, {scalar(d), vector(d)});
      case 3:
        return add(Op::divide, 1, {vector(d), scalar(d)});
      case 4:
        return add(Op::cross, 1, {vector(d), vector(d)});
      case 5:
        return pick(2) == 0 ? add(Op::dot, 1, {tensor(d), vector(d)})
                            : add(Op::dot, 1, {vector(d), tensor(d)});
      case 6:
        return add(Op::tuple, 1, {scalar(d), scalar(0), scalar(0)});
      case 7:
        return over_particles(1, d);
      default:
        return add(Op::multiply, 1, {scalar(d), scalar(d), vector(d)});
    }
  }

  ExprId tensor(int depth) {
    if (depth <= 0) return symbol({"S", 2, false}, 2);
    const int d = depth - 1;
    switch (pick(5)) {
      case 0:
        return add(Op::add, 2, {tensor(d), tensor(d)});
      case 1:
        return add(Op::multiply, 2, {scalar(d), tensor(d)});
      case 2:
        return add(Op::multiply, 2, {vector(d), vector(d)});
      case 3:
        return add(Op::dot, 2, {tensor(d), tensor(d)});
      default:
        return add(Op::negate, 2, {tensor(d)});
    }
  }

  ExprId over_particles(int rank, int depth) {
    particles_.push_back(page.tree.add_particle("\\alpha"));
    const ExprId body = rank == 0 ? scalar(depth) : vector(depth);
    const ExprNode node{.op = Op::particle_sum, .particle = particles_.back()};
    particles_.pop_back();
    return add(Op::particle_sum, rank, {body}, {}, node);
  }

  ExprId index_sum(IndexId index, ExprId body) {
    return add(Op::index_sum, page.tree[body].rank, {body}, {}, {.op = Op::index_sum, .index = index});
  }

  /// A sum over an index that occurs once, twice or three times, in places of all kinds.
  ExprId contraction(int depth) {
    static constexpr const char* letters[] = {"i", "j", "k", "l"};
    const IndexId k = page.tree.add_index(letters[pick(4)]);
    const int d = depth - 1;
    switch (pick(9)) {
      case 0:
        return index_sum(k, symbol({"S", 2, false}, 0, {{0, k}, {0, k}}));
      case 1:
        return index_sum(k, power(vector_at({0, k}), 2));
      case 2:
        return index_sum(k, add(Op::add, 0, {indexed(k, d), indexed(k, d)}));
      case 3:
        return index_sum(k, add(Op::multiply, 0, {indexed(k, d), indexed(k, d), indexed(k, d)}));
      case 4:
        return index_sum(k, add(Op::divide, 0, {indexed(k, d), scalar(d)}));
      case 5: {
        const IndexId l = page.tree.add_index("l");
        const ExprId body = add(Op::multiply, 0,
                                {symbol({"S", 2, false}, 0, {{0, k}, {0, l}}), indexed(l, d), indexed(k, d)});
        return index_sum(k, index_sum(l, body));
      }
      default:
        return index_sum(k, add(Op::multiply, 0, {indexed(k, d), scalar(d), indexed(k, d)}));
    }
  }

  /// A scalar with the index free in it.
  ExprId indexed(IndexId k, int depth) {
    const Slot slot{0, k};
    if (depth <= 0) return vector_at(slot);
    const int d = depth - 1;
    switch (pick(11)) {
      case 0:
        return add(Op::add, 0, {indexed(k, d), indexed(k, d)});
      case 1:
        return add(Op::negate, 0, {indexed(k, d)});
      case 2:
        return add(Op::multiply, 0, {scalar(d), indexed(k, d)});
      case 3:
        return add(Op::multiply, 0, {indexed(k, d), scalar(d)});
      case 4:
        return add(Op::divide, 0, {indexed(k, d), scalar(d)});
      case 5:
        return add(Op::component, 0, {vector(d)}, {slot});
      case 6:
        return add(Op::dot, 0, {add(Op::basis, 1, {}, {slot}), vector(d)});
      case 7:
        return power(indexed(k, d), 2);
      case 8:
        return add(Op::divide, 0, {scalar(d), indexed(k, d)});
      case 9: {
        const IndexId l = page.tree.add_index("j");
        return index_sum(l,
                         add(Op::multiply, 0, {symbol({"S", 2, false}, 0, {slot, {0, l}}), indexed(l, d)}));
      }
      default:
        return symbol({"S", 2, false}, 0, {slot, axis()});
    }
  }

  std::mt19937 random_;
  std::vector<ParticleId> particles_;
};

}  // namespace rigor
