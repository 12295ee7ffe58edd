// SPDX-License-Identifier: GPL-3.0-or-later
// Orders: what cannot be negative is put on one side; and orders of terms at random, which are mostly false.
#include "generate.h"
#include "rewrite.h"

namespace fuzz {
namespace {

/// 0 < a, 0 < a < b or a ≥ 0, so that samples meet it.
void assume_order(Statement& statement, Random& random) {
  auto& letters = statement.letters;
  const auto positive = [&](std::size_t k) { return make(Op::absolute, {symbol(letters, k)}); };
  const Term a = symbol(letters, 0);
  const Term b = symbol(letters, 1);
  switch (random.below(5)) {
    case 0:
      letters[0].value = positive(0);
      statement.given.push_back({a, number(0), Relation::greater});
      break;
    case 1:
      letters[0].value = positive(0);
      letters[1].value = sum({a, positive(1)});
      statement.given.push_back({number(0), a, Relation::less});
      statement.given.push_back({a, b, Relation::less});
      break;
    case 2:
      letters[0].value = positive(0);
      letters[1].value = positive(1);
      statement.given.push_back({a, number(0), Relation::greater_or_equal});
      statement.given.push_back({b, number(0), Relation::greater});
      break;
    default:
      break;
  }
}

/// Never negative, whatever the letters are.
Term not_negative(Grower& grower, Random& random) {
  switch (random.below(6)) {
    case 0:
      return make(Op::absolute, {grower.scalar(1)});
    case 1:
      return make(Op::root, {sum({power(grower.leaf(0), 2), power(grower.leaf(0), 2)})});
    case 2:
      return sum({power(grower.leaf(0), 2), power(grower.leaf(0), 2)});
    case 3: {  // |x| + |y| - |x + y|
      const Term x = grower.leaf(0);
      const Term y = grower.scalar(1);
      return sum(
          {make(Op::absolute, {x}), make(Op::absolute, {y}), negative(make(Op::absolute, {sum({x, y})}))});
    }
    case 4: {  // |A||B| - A·B
      const Term a = grower.leaf(1);
      const Term b = grower.leaf(1);
      if (a == nullptr) return power(grower.leaf(0), 2);
      return sum({product({make(Op::length, {a}), make(Op::length, {b})}), negative(make(Op::dot, {a, b}))});
    }
    default:
      return power(grower.scalar(1), 2);
  }
}

/// x ≥ y with the term y, or its parts, on the other side.
void split(Statement& statement, const Term& difference, const Term& extra, Relation relation) {
  std::vector<Term> left;
  std::vector<Term> right;
  const std::vector<Term> parts =
      difference->op == Op::sum ? difference->parts : std::vector<Term>{difference};
  for (const Term& part : parts)
    part->op == Op::negative ? right.push_back(part->parts[0]) : left.push_back(part);
  if (extra != nullptr) {
    left.push_back(extra);
    right.push_back(extra);
  }
  if (left.empty()) left.push_back(number(0));
  if (right.empty()) right.push_back(number(0));
  statement.sides = {sum(left), sum(right)};
  statement.relations = {relation};
}

/// A term whose square is that of x: ±x, ±|x|, ±√x², and for a product |a||b| as well.
Term of_same_square(const Term& x, Random& random) {
  Term term = x;
  switch (random.below(4)) {
    case 0:
      term = make(Op::absolute, {x});
      break;
    case 1:
      term = make(Op::root, {power(x, 2)});
      break;
    case 2:
      if (x->op != Op::product) break;
      term = product({make(Op::absolute, {x->parts[0]}), x->parts[1]});
      break;
    default:
      break;
  }
  return random.one_in(3) ? negative(term) : term;
}

/// Orders and equations between such terms: squaring both sides would lose what matters.
void compare_roots(Statement& statement, Grower& grower, Random& random) {
  const Term x =
      random.one_in(2) ? product({grower.leaf(0), grower.leaf(0)}) : grower.scalar(random.between(0, 1));
  statement.sides = {of_same_square(x, random), of_same_square(x, random)};
  if (random.one_in(3)) {
    const Term extra = of_same_square(grower.leaf(0), random);
    statement.sides[0] = sum({statement.sides[0], extra});
    if (random.one_in(2)) statement.sides[1] = sum({statement.sides[1], of_same_square(extra, random)});
  }
  statement.relations = {static_cast<Relation>(random.below(5))};
}

void turn(Statement& statement) {
  std::swap(statement.sides[0], statement.sides[1]);
  Relation& relation = statement.relations[0];
  if (relation == Relation::greater) {
    relation = Relation::less;
  } else if (relation == Relation::greater_or_equal) {
    relation = Relation::less_or_equal;
  }
}

}  // namespace

Statement order_of(Random& random) {
  Statement statement;
  statement.kind = "orders";
  statement.letters = scalars_of(3, random);
  if (random.one_in(3)) {
    for (const char* name : {"A", "B"}) {
      Letter letter;
      letter.plain = name;
      letter.rank = 1;
      statement.letters.push_back(letter);
    }
  }
  assume_order(statement, random);
  Grammar grammar;
  grammar.roots = random.one_in(2);
  grammar.quotients = random.one_in(3);
  Grower grower(statement.letters, grammar, random);
  if (random.one_in(4)) {
    compare_roots(statement, grower, random);
    return statement;
  }
  if (random.one_in(3)) {
    statement.sides = {grower.scalar(2), grower.scalar(random.between(0, 2))};
    statement.relations = {static_cast<Relation>(1 + random.below(5))};
    return statement;
  }
  const Relation relation = random.one_in(3) ? Relation::greater : Relation::greater_or_equal;
  Term difference = not_negative(grower, random);
  if (random.one_in(3)) difference = sum({difference, not_negative(grower, random)});
  difference = rewritten(difference, statement.letters, random.between(0, 3), random);
  if (random.one_in(3)) difference = mistaken(difference, statement.letters, random);
  split(statement, difference, random.one_in(2) ? grower.scalar(1) : nullptr, relation);
  if (random.one_in(2)) turn(statement);
  return statement;
}

}  // namespace fuzz
