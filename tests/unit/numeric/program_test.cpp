// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "catch.h"
#include "numeric/on_sample.h"
#include "numeric/program/code.h"

using namespace rigor;
using namespace rigor::build;

namespace {

/// What the exact evaluator says is an integer or a small quotient: programs give the nearest double.
void check_same(Page& page, const Term& term, const std::vector<IndexId>& indices = {},
                const std::vector<ParticleId>& particles = {}) {
  const Compared compared = compare(page, term, indices, particles);
  CAPTURE(dump(page.tree, term.id));
  CHECK(compared.computed == Approx(compared.exact).epsilon(1e-15));
}

}  // namespace

TEST_CASE("programs give what the exact evaluator gives: vectors", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  check_same(page, dot(a, b));
  check_same(page, cross(a, b));
  check_same(page, cross(a, cross(b, c)));
  check_same(page, dot(a, cross(b, c)));
  check_same(page, squared(cross(a, b)));
  check_same(page, squared(a) * squared(b) - pow(dot(a, b), 2));
  check_same(page, pow(length(a), 4) - 3 * dot(a, a));
  check_same(page, dot(a, a) * b - dot(a, b) * a);
  check_same(page, tuple(at(a, 1), -at(b, 2), page.number("0.25")));
  check_same(page, absolute(dot(a, b)));
  check_same(page, dot(a, b) / 4 - 1 / (squared(a) + 1 * squared(c)));
  check_same(page, pow(at(a, 1), 3) + pow(at(a, 2), 5) - pow(at(b, 1), 0));
  check_same(page, pow(squared(a) + page.number("1"), -2));
}

TEST_CASE("programs give what the exact evaluator gives: indices", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named t = page.tensor("T");
  const Named s = page.symmetric("S");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const IndexId l = page.index("l");
  const IndexId m = page.index("m");
  check_same(page, sum({i}, at(a, i) * at(b, i)));
  check_same(page, sum({j, k}, page.epsilon(i, j, k) * at(a, j) * at(b, k)), {i});
  check_same(page, sum({i, j, k, l, m}, page.epsilon(i, j, k) * at(a, j) * at(b, k) * page.epsilon(i, l, m) *
                                            at(a, l) * at(b, m)));
  check_same(page, sum({i, j}, at(t, i, j) * at(a, i) * at(b, j)));
  check_same(page, at(t, i, j) - 2 * at(t, j, i) + 5 * page.delta(i, j), {i, j});
  check_same(page, sum({j}, at(s, i, j) * at(b, j)), {i});
  check_same(page, at(s, 2, 1) - 3 * at(s, 1, 2) + at(s, 3, 1));
  check_same(page, sum({i}, at(a, i) * page.basis(i)) + cross(a, b));
  check_same(page, component(dot(t, a), 2));
  check_same(page, component(a * b, j, i), {i, j});
  check_same(page, dot(dot(t, s), b));
  check_same(page, sum({j}, component(cross(a, b), j) * at(t, j, i)), {i});
}

TEST_CASE("programs give what the exact evaluator gives: determinants and tables", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named t = page.tensor("T");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  std::vector<Term> entries;
  std::vector<Term> rows{page.basis(1), page.basis(2), page.basis(3)};
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 3; ++column) {
      entries.push_back(at(t, row, column));
      if (row > 1) rows.push_back(at(t, row, column));
    }
  }
  check_same(page, page.determinant(entries));
  check_same(page, page.determinant(rows));
  const std::vector<ExprId> values{page.number("0").id, page.number("1").id, dot(a, a).id};
  const std::vector<Slot> slots{Place(i).slot, Place(j).slot};
  const Term table{&page.tree, page.tree.add_table({}, values, slots, {{1, 0, 2, 0, 1, 0, 0, 2, 1}})};
  check_same(page, sum({i, j}, table * at(t, i, j)));
  check_same(page, table + at(t, i, j), {i, j});
}

TEST_CASE("programs give what the exact evaluator gives: definitions", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const Named inertia = page.tensor("I");
  const Named omega = page.scalar("\\Omega");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.define(c, cross(a, b) + a);
  page.define(inertia, dot(a, a) * page.delta(i, j) - at(a, i) * at(a, j), {i, j});
  page.define(omega, root(dot(a, a) - dot(b, b)));
  page.question.definitions.back().by_square = true;
  check_same(page, dot(c, b) + squared(c));
  check_same(page, sum({i, j}, at(inertia, i, j) * at(b, i) * at(b, j)) / 2);
  check_same(page, at(inertia, i, j), {i, j});
  check_same(page, at(inertia, j, i) * at(c, j), {i, j});
  check_same(page, pow(omega, 2));
  check_same(page, pow(omega, 4) - at(a, 1));
}

TEST_CASE("programs give what the exact evaluator gives: sums over particles", "[numeric]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named v = page.vectors("v");
  const Named w = page.vector("w");
  const Named x = page.vectors("x");
  const Named inertia = page.tensor("I");
  const Named mass = page.scalar("M");
  const ParticleId alpha = page.particle("\\alpha");
  const ParticleId beta = page.particle("\\beta");
  const ParticleId gamma = page.particle("\\gamma");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.define(v(alpha), cross(w, r(alpha)));
  page.define(mass, over(alpha, m(alpha)));
  page.define(inertia,
              over(beta, m(beta) * (squared(r(beta)) * page.delta(i, j) - at(r(beta), i) * at(r(beta), j))),
              {i, j});
  page.define(x(beta), r(beta) - over(alpha, m(alpha) * r(alpha)));
  check_same(page, over(alpha, m(alpha)));
  check_same(page, over(alpha, m(alpha) * squared(v(alpha))) / 2);
  check_same(page, sum({i, j}, at(inertia, i, j) * at(w, i) * at(w, j)) / 2);
  check_same(page, over(alpha, m(alpha) * cross(r(alpha), v(alpha))));
  check_same(page, over(alpha, over(beta, m(alpha) * m(beta) * squared(r(alpha) - r(beta)))));
  check_same(page, over(alpha, m(alpha) * over(beta, m(beta) * dot(r(beta), w))));
  check_same(page, over(alpha, page.number("3") * mass - m(alpha)));
  check_same(page, over(alpha, mass));
  check_same(page, over(alpha, m(alpha) * squared(x(alpha))));
  check_same(page, mass * over(gamma, over(alpha, m(alpha) * at(v(gamma), 2))));
  check_same(page, m(beta) * r(beta), {}, {beta});
  check_same(page, dot(x(beta), v(gamma)), {}, {beta, gamma});
  check_same(page, over(alpha, squared(r(alpha) - r(beta))), {}, {beta});
}

namespace {

[[nodiscard]] std::string failure(const Page& page, const Term& term) {
  const ProgramRoot root{term.id, {}};
  const auto program = Program::compile(page.tree, page.question.definitions, std::span(&root, 1));
  return program ? std::string() : program.error().reason;
}

[[nodiscard]] std::string_view symbol_of(Instruction op) {
  switch (op) {
    case Instruction::add:
      return "+";
    case Instruction::subtract:
    case Instruction::negate:
      return "-";
    case Instruction::multiply:
      return "*";
    case Instruction::divide:
      return "/";
    case Instruction::root:
      return "root";
    case Instruction::absolute:
      return "abs";
    case Instruction::sin:
      return "sin";
    case Instruction::cos:
      return "cos";
    case Instruction::exp:
      return "exp";
    case Instruction::tan:
      return "tan";
    case Instruction::sinh:
      return "sinh";
    case Instruction::cosh:
      return "cosh";
    case Instruction::tanh:
      return "tanh";
    case Instruction::sum:
      return "sum";
    case Instruction::constant:
    case Instruction::input:
      break;
  }
  return "";
}

/// `%12` (by `number`), `0.5`, `I[1]{p1}`: component 1 for the particle of level 1; `{f0}` is a free
/// particle.
[[nodiscard]] std::string name_of_value(const Code& code, const ExprTree& tree, ValueId id,
                                        std::uint32_t number) {
  const Value& value = code.values[id];
  if (value.op == Instruction::constant) {
    const Constant& constant = code.constants[value.a];
    return constant.digits.empty() ? fmt::format("{}", constant.value) : constant.digits;
  }
  if (value.op != Instruction::input) return fmt::format("%{}", number);
  const ProgramInput& input = code.inputs[value.a];
  std::string name = fmt::format("{}[{}]", tree.symbols[input.symbol].name, input.component);
  if (value.b >= InputParticle::first_free) {
    name += fmt::format("{{f{}}}", value.b - InputParticle::first_free);
  } else if (value.b != InputParticle::none) {
    name += fmt::format("{{p{}}}", value.b);
  }
  return name;
}

/// One instruction a line.
[[nodiscard]] std::string listing(const Page& page, const Term& term) {
  const Program program = compiled(page, term);
  const Code& code = program.code();
  std::string text;
  std::vector<std::uint32_t> number(code.values.size(), 0);
  std::uint32_t last = 0;
  const auto name = [&](ValueId id) { return name_of_value(code, page.tree, id, number[id]); };
  for (ValueId id = 0; id < number.size(); ++id) {
    const Value& value = code.values[id];
    if (!has_operands(value.op)) continue;
    number[id] = ++last;
    text += fmt::format("{} = {}", name(id), symbol_of(value.op));
    if (value.op == Instruction::sum) text += fmt::format(" over p{}", value.level);
    text += " " + name(value.a);
    if (has_second_operand(value.op)) text += " " + name(value.b);
    text += "\n";
  }
  for (const ValueId id : code.outputs) text += fmt::format("result {}\n", name(id));
  return text;
}

}  // namespace

TEST_CASE("definitions in a circle are refused, with a name", "[numeric]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  page.define(a, 2 * b);
  page.define(b, a + page.number("1"));
  CHECK(failure(page, a * a) == "the definitions of `a` are circular");
}

TEST_CASE("what is too large or too deep is refused", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Term deep = x;
  for (int i = 0; i < 2000; ++i) deep = sin(deep);
  CHECK(failure(page, deep) == "it nests too deeply");
  const Named t = page.tensor("T");
  Term large = t;
  for (int i = 0; i < 3; ++i) large = large * Term(t);
  CHECK(failure(page, large) == "a tensor has too many components");
  CHECK(failure(page, pow(x, 1001)) == "an exponent is too large");
  std::vector<IndexId> many;
  Term sums = x;
  for (int i = 0; i < 16; ++i) sums = sum({page.index("i")}, sums);
  CHECK(failure(page, sums) == "the program would be too large");
}

TEST_CASE("the last definition of a symbol counts", "[numeric]") {
  Page page;
  const Named a = page.scalar("a");
  page.define(a, page.number("2"));
  page.define(a, page.number("3"));
  CHECK(evaluate(compiled(page, a * a), Samples(1, 0))[0] == 9.0);
}

TEST_CASE("what is written is kept: nothing is expanded, factored or left out but what is 0", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named a = page.vector("A");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(listing(page, x * (x + y) - y * (x + y)) ==
        "%1 = + x[0] y[0]\n%2 = * x[0] %1\n%3 = * y[0] %1\n%4 = - %2 %3\nresult %4\n");
  CHECK(listing(page, 1 / (2 * x) * y / 2).find("0.5") == std::string::npos);
  CHECK(listing(page, page.number("1") / 2 * x).find("* 0.5 x[0]") != std::string::npos);
  CHECK(listing(page, page.number("1") / 3 * x).find("/ 1 3") != std::string::npos);
  CHECK(listing(page, sum({i, j}, page.delta(i, j) * at(a, i) * at(a, j))) == listing(page, dot(a, a)));
  CHECK(listing(page, squared(a)) == listing(page, dot(a, a)));
  CHECK(listing(page, cross(a, a)) != listing(page, a));
  CHECK(listing(page, 0 * x).find("* ") != std::string::npos);
}

TEST_CASE("a value is computed once, and outside the loops that it does not depend on", "[numeric]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named w = page.vector("w");
  const ParticleId alpha = page.particle("\\alpha");
  const ParticleId beta = page.particle("\\beta");
  const Program one = compiled(page, over(alpha, m(alpha) * dot(w, w)));
  CHECK(one.counts().once == 5);
  CHECK(one.counts().per_particle == 2);
  // Both sums are over the same terms.
  const Term twice = over(alpha, m(alpha) * squared(r(alpha))) + over(beta, m(beta) * squared(r(beta)));
  CHECK(compiled(page, twice).counts().per_particle == 7);
  // An inner sum that does not depend on the outer particle is computed before.
  const Term nested = over(alpha, m(alpha) * over(beta, m(beta)));
  CHECK(listing(page, nested) ==
        "%1 = sum over p1 m[0]{p1}\n%2 = * m[0]{p1} %1\n%3 = sum over p1 %2\nresult %3\n");
}

TEST_CASE("a program for a form takes few registers", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Plan plan = make_plan(compiled(page, squared(cross(a, b))).code(), Lanes::samples);
  CHECK(plan.wide_registers + plan.narrow_registers <= 3);
}

TEST_CASE("the square of a cross product is one step, whichever vector is the same for all samples",
          "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Program program = compiled(page, squared(cross(a, b)));
  for (const int same : {0, 1, 2}) {
    std::vector<std::uint8_t> varies;
    for (const ProgramInput& input : program.inputs())
      varies.push_back(
          (same == 1 && input.symbol == a.symbol) || (same == 2 && input.symbol == b.symbol) ? 0 : 1);
    const Plan plan = make_plan(program.code(), Lanes::samples, varies);
    REQUIRE(plan.each.size() == 1);
    CHECK(plan.each[0].kernel == Kernel::cross_square);
  }
}

TEST_CASE("factors, signs and sums at the end of a step take no step of their own", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named s = page.symmetric("S");
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId alpha = page.particle("\\alpha");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const auto steps = [&](const Term& term) {
    const Program program = compiled(page, term);
    std::vector<std::uint8_t> varies;
    for (const ProgramInput& input : program.inputs())
      varies.push_back(input.symbol == a.symbol || input.symbol == b.symbol ? 1 : 0);
    std::vector<Kernel> kernels;
    for (const PlanStep& step : make_plan(program.code(), Lanes::samples, varies).each)
      kernels.push_back(step.kernel);
    return kernels;
  };
  using Kernels = std::vector<Kernel>;
  CHECK(steps(squared(a) * squared(b) - pow(dot(a, b), 2)) == Kernels{Kernel::gram});
  CHECK(steps(-(at(a, 1) + at(b, 1)) / at(s, 1, 2)) == Kernels{Kernel::add});
  CHECK(steps(sum({i, j}, at(s, i, j) * at(a, i) * at(a, j)) / 2) == Kernels{Kernel::quadratic_form_3});
  CHECK(steps(over(alpha, m(alpha) * squared(cross(a, r(alpha))))) ==
        Kernels{Kernel::clear, Kernel::loop, Kernel::cross_square});
  // Of three results, in order or not.
  CHECK(steps(dot(cross(a, b), a)) == Kernels{Kernel::cross, Kernel::product_sum_3});
  const Term momentum = m(alpha) * cross(r(alpha), cross(a, r(alpha)));
  CHECK(steps(over(alpha, momentum)) ==
        Kernels{Kernel::clear, Kernel::clear, Kernel::clear, Kernel::loop, Kernel::cross, Kernel::cross});
  // r² comes first: it is the same for all samples.
  CHECK(
      steps(over(alpha, m(alpha) * (squared(a) * squared(r(alpha)) - pow(dot(a, r(alpha)), 2)))) ==
      Kernels{Kernel::square_sum_3, Kernel::clear, Kernel::loop, Kernel::square_sum_3, Kernel::less_square});
}

TEST_CASE("a program asks only for the inputs that its results depend on", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named s = page.symmetric("S");
  const Named c = page.vector("C");
  page.define(c, cross(a, b));
  const Program one = compiled(page, at(c, 3) + component(dot(s, a), 1));
  std::vector<std::pair<SymbolId, std::uint32_t>> inputs;
  for (const ProgramInput& input : one.inputs()) inputs.emplace_back(input.symbol, input.component);
  std::sort(inputs.begin(), inputs.end());
  const std::vector<std::pair<SymbolId, std::uint32_t>> expected{{a.symbol, 0}, {a.symbol, 1}, {a.symbol, 2},
                                                                 {b.symbol, 0}, {b.symbol, 1}, {s.symbol, 0},
                                                                 {s.symbol, 1}, {s.symbol, 2}};
  CHECK(inputs == expected);
}

TEST_CASE("a sum of constants is taken at compile time only if no digit is lost", "[numeric]") {
  Page page;
  const auto sum = [&](const char* a, const char* b) { return page.number(a) + page.number(b); };
  const auto operations = [&](const Term& term) { return compiled(page, term).counts().once; };
  CHECK(operations(sum("4194304", "0.5")) == 0);  // 2^22 + 2^-1: 24 bits
  CHECK(operations(sum("8388608", "0.5")) == 1);  // 25 bits
  // 2^49 + 2^-13 is 2^49 in double.
  CHECK(operations(sum("562949953421312", "0.0001220703125")) == 1);
}
