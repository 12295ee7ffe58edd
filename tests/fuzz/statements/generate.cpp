// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate.h"

#include <algorithm>
#include <cmath>

#include "rewrite.h"

namespace fuzz {
namespace {

/// `count` different ones of some names.
std::vector<std::string> some(std::vector<std::string> names, std::size_t count, Random& random) {
  for (std::size_t k = 0; k < count; ++k) std::swap(names[k], names[k + random.below(names.size() - k)]);
  names.resize(count);
  return names;
}

std::vector<Letter> vectors_of(std::size_t count, Random& random) {
  std::vector<Letter> letters;
  for (const std::string& name :
       some({"A", "B", "C", "D", "F", "G", "u", "v", "w", "p", "Q"}, count, random)) {
    Letter letter;
    letter.plain = name;
    letter.rank = 1;
    letters.push_back(letter);
  }
  return letters;
}

void add(std::vector<Letter>& letters, const std::string& plain, int rank, Nature nature,
         bool of_particles = false) {
  Letter letter;
  letter.plain = plain;
  letter.rank = rank;
  letter.nature = nature;
  letter.of_particles = of_particles;
  letters.push_back(letter);
}

void append(std::vector<Letter>& letters, const std::vector<Letter>& more) {
  letters.insert(letters.end(), more.begin(), more.end());
}

void set_all(std::vector<Letter>& letters, Nature nature) {
  for (Letter& letter : letters) letter.nature = nature;
}

/// A chain from `start`: each side is the one before, rewritten, sometimes with a slip.
void add_sides(Statement& statement, const Term& start, Relation relation, Random& random) {
  statement.sides = {start};
  const int links = random.one_in(8) ? random.between(2, 3) : 1;
  for (int k = 0; k < links; ++k) {
    Term next = rewritten(statement.sides.back(), statement.letters, random.between(1, 6), random);
    if (random.one_in(2)) next = mistaken(next, statement.letters, random);
    statement.sides.push_back(next);
    statement.relations.push_back(relation);
  }
}

/// The same on both sides of a statement with one step: x = y becomes x + z = z + y, or c x = c y.
void complicate(Statement& statement, const Term& extra, Random& random) {
  if (statement.steps() != 1 || extra == nullptr || extra->rank != statement.sides[0]->rank) return;
  Term& left = statement.sides[0];
  Term& right = statement.sides[1];
  Statement before = statement;
  switch (random.below(6)) {
    case 0:
      left = sum({left, extra});
      right = sum({rewritten(extra, statement.letters, 1, random), right});
      break;
    case 1:
      left = sum({left, negative(extra)});
      right = sum({right, negative(extra)});
      break;
    case 2:
      std::swap(left, right);
      break;
    default:
      break;
  }
  if (!well_formed(statement)) statement = before;
}

/// A lone symbol on the left would define it.
bool defines(const Term& side) {
  const Term& inner = side->op == Op::contract ? side->parts[0] : side;
  return inner->op == Op::symbol || inner->op == Op::length ||
         (inner->op == Op::power && (inner->parts[0]->op == Op::symbol || inner->parts[0]->op == Op::length));
}

struct Plan {
  std::vector<Letter> letters;
  Grammar grammar;
  bool of_vectors = false;  // may be a vector equation
};

Plan plan_of(const std::string& kind, Random& random) {
  Plan plan;
  plan.letters = scalars_of(kind == "polynomials" || kind == "quotients" || kind == "roots" ? 3 : 2, random);
  Grammar& grammar = plan.grammar;
  grammar.quotients = kind == "quotients" || kind == "functions" || random.one_in(4);
  grammar.functions = kind == "functions";
  grammar.roots = kind == "roots";
  if (kind == "polynomials" || kind == "quotients" || kind == "roots" || kind == "functions") return plan;
  grammar.vectors = plan.of_vectors = true;
  append(plan.letters, vectors_of(kind == "vectors" ? 4 : 3, random));
  if (kind == "vectors") {
    grammar.roots = random.one_in(4);
    if (random.one_in(2)) add(plan.letters, "n", 1, Nature::unit);
  } else if (kind == "tensors") {
    grammar.tensors = true;
    add(plan.letters, "S", 2, Nature::free);
    add(plan.letters, "T", 2, Nature::free);
    plan.letters.back().symmetric = true;
  } else if (kind == "rates") {
    grammar.rates = true;
    grammar.functions = random.one_in(3);
    plan.letters[0].nature = Nature::constant;
    if (random.one_in(2)) plan.letters.back().nature = Nature::constant;
  } else if (kind == "frames") {
    grammar.frames = true;
    add(plan.letters, "\\omega", 1, Nature::spin);
  } else if (kind == "fields") {
    grammar.fields = true;
    for (std::size_t k = 0; k < 2; ++k)  // x, y, z are the place
      if (std::string("xyz").find(plan.letters[k].plain) != std::string::npos)
        plan.letters[k].plain = k == 0 ? "f" : "s";
    set_all(plan.letters, Nature::field);
    if (random.one_in(3)) plan.letters.back().nature = Nature::constant;
    if (random.one_in(3)) add(plan.letters, "r", 1, Nature::position);
  }
  return plan;
}

Statement plain_statement(const std::string& kind, Random& random) {
  Plan plan = plan_of(kind, random);
  Statement statement;
  statement.kind = kind;
  statement.letters = plan.letters;
  Grower grower(statement.letters, plan.grammar, random);
  const int depth = random.between(2, kind == "fields" || kind == "frames" ? 2 : 3);
  const bool vector = plan.of_vectors && random.one_in(2);
  const Term start = vector ? grower.vector(depth) : grower.scalar(depth);
  add_sides(statement, start, Relation::equal, random);
  complicate(statement, vector ? grower.vector(1) : grower.scalar(1), random);
  return statement;
}

/// Vectors as components with a free index, or scalars, and then by many steps of index notation.
Statement index_statement(Random& random) {
  Statement statement;
  statement.kind = "indices";
  statement.letters = scalars_of(1, random);
  append(statement.letters, vectors_of(3, random));
  Grammar grammar;
  grammar.vectors = true;
  if (random.one_in(2)) {
    grammar.tensors = true;
    add(statement.letters, "T", 2, Nature::free);
    statement.letters.back().symmetric = random.one_in(2);
  }
  Grower grower(statement.letters, grammar, random);
  Term start = random.one_in(2) ? with_slots(Op::component, grower.vector(2), "i") : grower.scalar(2);
  for (int k = 0; k < 3; ++k) start = rewritten(start, statement.letters, 1, random);
  add_sides(statement, start, Relation::equal, random);
  complicate(statement, grower.scalar(1), random);
  return statement;
}

Statement particle_statement(Random& random) {
  Statement statement;
  statement.kind = "particles";
  statement.letters = scalars_of(1, random);
  append(statement.letters, vectors_of(2, random));
  add(statement.letters, "m", 0, Nature::free, true);
  add(statement.letters, "r", 1, Nature::free, true);
  if (random.one_in(2)) add(statement.letters, "s", 1, Nature::free, true);
  Grammar grammar;
  grammar.vectors = true;
  Grower inside(statement.letters, grammar, random);
  inside.particle = 'a';
  const bool vector = random.one_in(2);
  const auto summed = [&] {
    const Term mass = symbol(statement.letters, 3, "", 'a');
    const Term of = vector ? inside.vector(2) : inside.scalar(2);
    return particle_sum('a', product({mass, of}));
  };
  Term start = summed();
  Grower outside(statement.letters, grammar, random);
  if (random.one_in(3)) start = sum({start, random.one_in(2) ? negative(summed()) : summed()});
  if (random.one_in(3))
    start = vector ? make(Op::cross, {outside.vector(0), start}) : product({outside.scalar(1), start});
  add_sides(statement, start, Relation::equal, random);
  complicate(statement, vector ? outside.vector(1) : outside.scalar(1), random);
  return statement;
}

Statement small_statement(Random& random) {
  Statement statement;
  statement.kind = "small";
  statement.letters = scalars_of(2, random);
  add(statement.letters, "\\delta", 0, Nature::small);
  if (random.one_in(2)) add(statement.letters, "\\eta", 0, Nature::small);
  Grammar grammar;
  grammar.near_one = true;
  grammar.functions = true;
  Grower grower(statement.letters, grammar, random);
  add_sides(statement, grower.scalar(random.between(2, 3)),
            random.one_in(6) ? Relation::equal : Relation::nearly, random);
  return statement;
}

/// a = e and a = e + 1, or ȧ = ė + 1: nothing meets them, and nothing may be proved from them.
Statement contradiction_statement(Random& random) {
  Statement statement;
  statement.kind = "contradictions";
  auto& letters = statement.letters;
  letters = scalars_of(3, random);
  append(letters, vectors_of(3, random));
  const auto s = [&](std::size_t k, int dots = 0) { return symbol(letters, k, "", 0, dots); };
  const Term e = random.one_in(2) ? product({s(1), s(1)}) : make(Op::dot, {s(3), s(4)});
  Claim law{s(0), e, Relation::equal};
  Claim against;
  switch (random.below(6)) {
    case 0:
      against = {s(0), sum({e, number(random.between(1, 3))})};
      break;
    case 1:
      against = {s(0, 1), sum({make(Op::rate, {e}), number(random.between(1, 3))})};
      break;
    case 2:
      law = {s(0, 1), number(0)};
      against = {s(0), sum({symbol(letters, 1), s(2)})};
      statement.given.push_back({s(1, 1), sum({number(1), negative(s(2, 1))})});
      break;
    case 3:
      law = {s(0), number(2)};
      against = {s(0, 1), number(random.between(1, 3))};
      break;
    case 4:
      law = {s(5), make(Op::cross, {s(3), s(4)})};
      against = {make(Op::dot, {s(3), s(5)}), number(random.between(1, 3))};
      break;
    default:
      law = {power(s(0), 2), sum({power(s(1), 2), number(1)})};
      against = {s(0), s(1)};
      break;
  }
  statement.given.push_back(law);
  statement.given.push_back(against);
  std::swap(statement.given[random.below(statement.given.size())], statement.given.back());
  statement.contradictory = true;
  const Term q = random.one_in(2) ? s(1) : make(Op::dot, {s(3), s(3)});
  const Term wrong = sum({product({number(2), q}), number(7)});
  statement.sides = {sum({q, s(2)}), sum({rewritten(wrong, letters, 2, random), s(2)})};
  if (random.one_in(2)) statement.sides = {sum({s(0), number(5)}), sum({e, number(random.between(11, 19))})};
  statement.relations = {Relation::equal};
  return statement;
}

/// √2 ≈ 1.41: numbers with their first digits, or a few units beside.
Statement decimal_statement(Random& random) {
  Statement statement;
  statement.kind = "decimals";
  double value = 0.0;
  Term exact;
  while (!(std::abs(value) > 0.01 && std::abs(value) < 500.0)) {
    const auto part = [&] {
      return number(random.between(1, 19), random.one_in(2) ? random.between(2, 13) : 1);
    };
    const Term a = part();
    const Term b = random.one_in(2) ? make(Op::root, {number(random.between(2, 30))}) : part();
    const auto numeric = [](const Term& term) {
      const Node& node = term->op == Op::root ? *term->parts[0] : *term;
      const double plain = static_cast<double>(node.p) / static_cast<double>(node.q);
      return term->op == Op::root ? std::sqrt(plain) : plain;
    };
    const std::size_t how = random.below(4);
    exact = how == 0 ? sum({a, b}) : how == 1 ? product({a, b}) : how == 2 ? make(Op::quotient, {b, a}) : b;
    value = how == 0   ? numeric(a) + numeric(b)
            : how == 1 ? numeric(a) * numeric(b)
            : how == 2 ? numeric(b) / numeric(a)
                       : numeric(b);
  }
  const int digits = random.between(1, 4);
  const double unit = std::pow(10.0, -digits);
  const double shown =
      random.one_in(2) ? value : value + unit * random.between(2, 30) * (random.one_in(2) ? 1 : -1);
  statement.sides = {exact, decimal(shown, digits)};
  if (random.one_in(4)) std::swap(statement.sides[0], statement.sides[1]);
  statement.relations = {random.one_in(4) ? Relation::equal : Relation::nearly};
  return statement;
}

/// cos k(x - y): a product may end the argument, or not.
Statement readings_statement(Random& random) {
  Statement statement;
  statement.kind = "readings";
  statement.letters = scalars_of(4, random);
  const auto s = [&](std::size_t k) { return symbol(statement.letters, k); };
  const auto bare = [&](Function function) {
    const Term inner = sum({s(1), random.one_in(2) ? negative(s(2)) : s(2)});
    Node node = *function_of(function, product({s(0), inner}));
    node.bare = true;
    return std::make_shared<const Node>(node);
  };
  const auto function = static_cast<Function>(random.below(7));
  const Term whole = bare(function == Function::tan ? Function::sin : function);
  const Term rest = random.one_in(2) ? s(3) : product({s(3), s(0)});
  const Term start = random.one_in(2) ? sum({whole, rest}) : sum({product({rest, whole}), s(1)});
  statement.sides = {start, rewritten(random.one_in(3) ? read_otherwise(start) : start, statement.letters,
                                      random.between(1, 4), random)};
  if (random.one_in(4)) statement.sides[1] = mistaken(statement.sides[1], statement.letters, random);
  statement.relations = {Relation::equal};
  return statement;
}

/// m dv/dt = F, p = m v: laws of motion, and a rate that follows from them or does not.
Statement motion_statement(Random& random) {
  Statement statement;
  statement.kind = "motion";
  auto& letters = statement.letters;
  letters = scalars_of(2, random);
  letters[0].nature = Nature::constant;
  append(letters, vectors_of(4, random));
  const auto s = [&](std::size_t k) { return symbol(letters, k); };
  letters[3].value = product({s(0), symbol(letters, 2, "", 0, 1)});
  Claim law{letters[3].value, s(3)};
  if (random.one_in(2)) law = {symbol(letters, 2, "", 0, 1), make(Op::quotient, {s(3), s(0)})};
  statement.given.push_back(law);
  if (random.one_in(2)) {
    letters[4].value = product({s(0), s(2)});
    statement.given.push_back({s(4), letters[4].value});
  }
  Grammar grammar;
  grammar.vectors = grammar.rates = true;
  Grower grower(letters, grammar, random);
  const bool vector = random.one_in(2);
  const Term known = random.one_in(2) ? s(3) : s(4);
  const Term of =
      vector ? make(Op::cross, {grower.vector(1), known}) : make(Op::dot, {grower.vector(1), known});
  add_sides(statement, sum({of, vector ? grower.vector(2) : grower.scalar(2)}), Relation::equal, random);
  return statement;
}

/// F_ij = -F_ji, and a term in which it may matter.
Statement antisymmetric_statement(Random& random) {
  Statement statement;
  statement.kind = "assumed";
  statement.letters = scalars_of(1, random);
  append(statement.letters, vectors_of(2, random));
  add(statement.letters, "T", 2, Nature::free);
  statement.letters.back().antisymmetric = true;
  const auto t = [&](const char* slots) { return symbol(statement.letters, 3, slots); };
  const auto v = [&](std::size_t k, const char* slot) { return symbol(statement.letters, k, slot); };
  statement.given.push_back({t("ij"), negative(t("ji"))});
  const Term left = contract("ij", product({t("ij"), v(1, "i"), v(2, "j")}));
  const Term right = contract("kl", product({t("kl"), v(1, "l"), v(2, "k")}));
  const Term zero =
      random.one_in(2) ? sum({left, right}) : contract("ij", product({t("ij"), v(1, "i"), v(1, "j")}));
  const Term extra = symbol(statement.letters, 0);
  add_sides(statement, sum({product({number(2), extra}), zero}), Relation::equal, random);
  statement.sides.back() =
      random.one_in(2) ? product({extra, number(2)}) : sum({statement.sides.back(), negative(zero)});
  return statement;
}

/// a + b + c = 0, A·B = 0, or T antisymmetric, and then something that may need it.
Statement assumed_statement(Random& random) {
  Statement statement;
  statement.kind = "assumed";
  statement.letters = scalars_of(3, random);
  append(statement.letters, vectors_of(3, random));
  auto& letters = statement.letters;
  const auto s = [&](std::size_t k) { return symbol(letters, k); };
  Term zero;
  switch (random.below(4)) {
    case 0:
      letters[2].value = negative(sum({s(0), product({number(2), s(1)})}));
      statement.given.push_back({sum({s(0), product({number(2), s(1)}), s(2)}), number(0)});
      zero = product({s(1), statement.given[0].left});
      break;
    case 1: {
      const Term a = s(3);
      letters[4].value = sum(
          {s(4),
           negative(product({make(Op::quotient, {make(Op::dot, {s(4), a}), make(Op::dot, {a, a})}), a}))});
      statement.given.push_back({make(Op::dot, {a, s(4)}), number(0)});
      zero = product({s(0), statement.given[0].left});
      break;
    }
    case 2:
      letters[5].value = negative(sum({s(3), s(4)}));
      statement.given.push_back({sum({s(3), s(4), s(5)}), fuzz::zero(1)});
      zero = make(Op::dot, {s(3), statement.given[0].left});
      break;
    default:
      letters[4].value = product({s(0), s(3)});
      statement.given.push_back({s(4), product({s(0), s(3)})});
      zero = make(Op::dot, {s(5), make(Op::cross, {s(3), s(4)})});
      break;
  }
  Grammar grammar;
  grammar.vectors = true;
  Grower grower(letters, grammar, random);
  const Term start = grower.scalar(2);
  if (random.one_in(4)) return antisymmetric_statement(random);
  add_sides(statement, random.one_in(2) ? sum({start, zero}) : start, Relation::equal, random);
  Term& last = statement.sides.back();
  if (random.one_in(2)) last = sum({last, negative(rewritten(zero, letters, 2, random))});
  if (last->op != Op::sum) last = sum({last, zero});
  return statement;
}

}  // namespace

std::vector<Letter> scalars_of(std::size_t count, Random& random) {
  std::vector<Letter> letters;
  for (const std::string& name :
       some({"a", "b", "c", "g", "h", "x", "y", "z", "\\lambda", "\\mu", "\\kappa", "\\theta", "\\phi", "q"},
            count, random)) {
    Letter letter;
    letter.plain = name;
    if (random.one_in(10)) letter.label = random.one_in(2) ? "0" : "\\text{in}";
    letters.push_back(letter);
  }
  return letters;
}

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> all{
      "polynomials", "quotients", "roots",    "functions", "vectors",  "indices",
      "tensors",     "particles", "rates",    "frames",    "fields",   "small",
      "orders",      "assumed",   "readings", "motion",    "decimals", "contradictions"};
  return all;
}

Statement statement_of(const std::string& kind, Random& random) {
  for (;;) {
    Statement statement = kind == "indices"          ? index_statement(random)
                          : kind == "particles"      ? particle_statement(random)
                          : kind == "small"          ? small_statement(random)
                          : kind == "assumed"        ? assumed_statement(random)
                          : kind == "contradictions" ? contradiction_statement(random)
                          : kind == "decimals"       ? decimal_statement(random)
                          : kind == "readings"       ? readings_statement(random)
                          : kind == "motion"         ? motion_statement(random)
                          : kind == "orders"         ? order_of(random)
                                                     : plain_statement(kind, random);
    const bool fits = std::all_of(statement.sides.begin(), statement.sides.end(), [](const Term& side) {
      return size(side) <= 60 && derivative_order(side) <= 3;
    });
    if (!fits || !well_formed(statement)) continue;
    if (statement.relations[0] == Relation::equal && defines(statement.sides[0])) continue;
    const bool moved =
        std::all_of(statement.relations.begin(), statement.relations.end(), [&](const Relation& relation) {
          const auto k = static_cast<std::size_t>(&relation - statement.relations.data());
          return relation != Relation::equal || !same(statement.sides[k], statement.sides[k + 1]);
        });
    if (moved) return statement;
  }
}

}  // namespace fuzz
