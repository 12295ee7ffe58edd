// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/parts/real_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algebra/engine/undecidable.h"
#include "algebra/parts/parts_of.h"

namespace rigor {
namespace {

[[nodiscard]] std::vector<ExprId> roots_of(const Question& question) {
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Definition& definition : question.definitions) roots.push_back(definition.body);
  for (const Equation& assumption : question.assumptions)
    roots.insert(roots.end(), {assumption.left, assumption.right});
  return roots;
}

[[nodiscard]] bool is_of_complex(Op op) {
  return op == Op::imaginary_unit || op == Op::conjugate || op == Op::real_part || op == Op::imaginary_part;
}

/// Gives the complex symbols their axis; they come first, so that derivatives by place stay the last ones.
[[nodiscard]] std::vector<bool> put_in_parts(ExprTree& tree) {
  for (std::size_t k = 0; k < tree.index_count(); ++k) {
    if (tree.space(static_cast<IndexId>(k)).id == space_of_parts.id)
      throw Undecidable("complex numbers in so many spaces are not decided");
  }
  std::vector<bool> in_parts(tree.symbols.size(), false);
  for (std::size_t k = 0; k < in_parts.size(); ++k) {
    if (!tree.symbols[static_cast<SymbolId>(k)].complex) continue;
    Symbol& symbol = tree.symbols.write(static_cast<SymbolId>(k));
    if (symbol.symmetric || symbol.unit || symbol.rotation)
      throw Undecidable(
          fmt::format("the complex `{}` is symmetric, a unit vector or a rotation", symbol.name));
    in_parts[k] = true;
    symbol.complex = false;
    symbol.axes = AxisSpaces::of(space_of_parts, 1).then(1, symbol.axes);
    ++symbol.rank;
  }
  return in_parts;
}

class QuestionInParts {
 public:
  explicit QuestionInParts(const Question& question)
      : tree_(std::make_unique<ExprTree>(*question.tree)),
        in_parts_(put_in_parts(*tree_)),
        reader_(*tree_, in_parts_) {}

  [[nodiscard]] RealQuestion read(const Question& question, std::span<const Equation> more) {
    RealQuestion real;
    real.question = question;
    real.question.claim = equation(question.claim);
    real.sides = question.claim;
    real.sides.relation = Relation::equal;
    real.sides = equation(real.sides);
    real.sides_in_parts = (*tree_)[real.sides.left].rank != (*tree_)[question.claim.left].rank;
    for (Definition& each : real.question.definitions) each = definition(each);
    for (Equation& each : real.question.assumptions) each = equation(each);
    for (const Equation& each : more) real.more.push_back(further(each, real.sides_in_parts));
    real.tree = std::move(tree_);
    real.in_parts = std::move(in_parts_);
    real.question.tree = real.tree.get();
    return real;
  }

 private:
  /// With the axis of parts if the sides of the claim have it, so that components can be compared.
  [[nodiscard]] std::optional<Equation> further(Equation each, bool in_parts) {
    try {
      if (!in_parts || each.relation != Relation::equal) return equation(each);
      each.left = reader_.pair(reader_.of(each.left));
      each.right = reader_.pair(reader_.of(each.right));
      return each;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] Equation equation(Equation equation) {
    const ComplexParts left = reader_.of(equation.left);
    const ComplexParts right = reader_.of(equation.right);
    const bool real = !left.im && !right.im;
    if (real) {
      equation.left = *left.re;
      equation.right = *right.re;
    } else if (equation.relation == Relation::equal) {
      equation.left = reader_.pair(left);
      equation.right = reader_.pair(right);
    } else if (equation.relation == Relation::unequal && (*tree_)[equation.left].rank == 0) {
      const Span span = (*tree_)[equation.left].span;
      equation.left = reader_.distance_squared(left, right);
      equation.right = tree_->add_number(span, "0");
    } else {
      throw Undecidable("an order is one of real numbers, and a side may not be real");
    }
    return equation;
  }

  [[nodiscard]] Definition definition(Definition definition) {
    const ComplexParts body = reader_.of(definition.body);
    const std::string& name = tree_->symbols[definition.symbol].name;
    if (!in_parts_[static_cast<std::size_t>(definition.symbol)]) {
      if (body.im)
        throw Undecidable(
            fmt::format("`{}` is read as a real number, but what defines it may not be real", name));
      definition.body = *body.re;
      return definition;
    }
    if (definition.by_square)
      throw Undecidable(fmt::format("the complex `{}` is defined by its square only", name));
    definition.body = reader_.pair(body);
    if (definition.indices.empty()) return definition;
    const Slot part{0, tree_->add_index("", space_of_parts)};
    definition.indices.insert(definition.indices.begin(), part.variable);
    const Span span = (*tree_)[definition.body].span;
    definition.body =
        tree_->add({.op = Op::component, .span = span}, std::span(&definition.body, 1), std::span(&part, 1));
    return definition;
  }

  std::unique_ptr<ExprTree> tree_;
  std::vector<bool> in_parts_;
  PartsReader reader_;
};

}  // namespace

bool is_about_complex(const Question& question) {
  const ExprTree& tree = *question.tree;
  return std::ranges::any_of(nodes_below(tree, roots_of(question)), [&](ExprId id) {
    return is_of_complex(tree[id].op) || (tree[id].op == Op::symbol && tree.symbols[tree[id].symbol].complex);
  });
}

RealQuestion in_real_parts(const Question& question, std::span<const Equation> more) {
  return QuestionInParts(question).read(question, more);
}

}  // namespace rigor
