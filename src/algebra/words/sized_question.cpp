// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/sized_question.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

constexpr int highest_power = 8;
constexpr std::uint32_t heaviest = 20'000;

/// Entries row by row. A number is 1×1 and of no size: it can be a multiple of the unit matrix.
struct Block {
  int rows = 1;
  int columns = 1;
  bool number = true;
  std::vector<ExprId> entries;
};

class Sizer {
 public:
  Sizer(SizedQuestion& into, const Question& asked) : into_(into), tree_(*into.tree), asked_(asked) {}

  /// Nothing: it cannot be written out.
  [[nodiscard]] bool equation(Equation& equation) {
    auto left = block(equation.left);
    auto right = block(equation.right);
    if (!left || !right || !alike(*left, *right)) return false;
    equation.left = whole(*left);
    equation.right = whole(*right);
    return tree_[equation.left].weight < heaviest && tree_[equation.right].weight < heaviest;
  }
  [[nodiscard]] bool reaches_matrices(ExprId id) const {
    const auto body_of = [&](SymbolId symbol) {
      const Definition* definition = definition_in(asked_, symbol);
      return definition == nullptr ? std::nullopt : std::optional(definition->body);
    };
    return std::ranges::any_of(symbols_reached(tree_, {id}, body_of),
                               [&](SymbolId symbol) { return tree_.symbols[symbol].noncommuting; });
  }

 private:
  using MaybeBlock = std::optional<Block>;

  [[nodiscard]] MaybeBlock block(ExprId id);
  [[nodiscard]] MaybeBlock symbol(ExprId id);
  [[nodiscard]] Block letter(SymbolId symbol);
  [[nodiscard]] MaybeBlock sum(ExprId id);
  [[nodiscard]] MaybeBlock product(const MaybeBlock& a, const MaybeBlock& b);
  [[nodiscard]] MaybeBlock power(const MaybeBlock& base, int exponent);
  [[nodiscard]] MaybeBlock inverse(const Block& of);
  [[nodiscard]] MaybeBlock over(const MaybeBlock& above, const MaybeBlock& below);
  [[nodiscard]] Block transpose(const Block& of) const;
  [[nodiscard]] ExprId determinant(const std::vector<ExprId>& entries, int rows);
  [[nodiscard]] std::vector<ExprId> minor(const std::vector<ExprId>& entries, int rows, int row,
                                          int column) const;
  [[nodiscard]] bool alike(Block& a, Block& b);
  [[nodiscard]] Block times_unit(const Block& number);
  [[nodiscard]] ExprId whole(const Block& of);

  [[nodiscard]] ExprId add(std::vector<ExprId> terms) {
    if (terms.size() == 1) return terms[0];
    return tree_.add({.op = Op::add, .span = span_}, terms);
  }
  [[nodiscard]] ExprId negate(ExprId id) {
    return tree_.add({.op = Op::negate, .span = span_}, std::span(&id, 1));
  }
  [[nodiscard]] ExprId multiply(ExprId a, ExprId b) {
    const std::array both{a, b};
    return tree_.add({.op = Op::multiply, .span = span_}, both);
  }
  [[nodiscard]] ExprId divide(ExprId a, ExprId b) {
    const std::array both{a, b};
    return tree_.add({.op = Op::divide, .span = span_}, both);
  }
  [[nodiscard]] Space space() const { return {static_cast<std::uint8_t>(into_.rows), space_of_columns}; }

  SizedQuestion& into_;
  ExprTree& tree_;
  const Question& asked_;
  Span span_;
  std::set<SymbolId> opened_;  // definitions that are being put in
};

std::optional<Block> Sizer::block(ExprId id) {
  const ExprNode node = tree_[id];
  span_ = node.span;
  if (node.rank > 0 || node.weight > heaviest) return std::nullopt;
  if (!reaches_matrices(id)) return Block{.entries = {id}};
  const std::vector<ExprId> children(tree_.children(id).begin(), tree_.children(id).end());
  switch (node.op) {
    case Op::symbol:
      return symbol(id);
    case Op::add:
      return sum(id);
    case Op::negate: {
      auto inside = block(children[0]);
      if (!inside) return inside;
      for (ExprId& entry : inside->entries) entry = negate(entry);
      return inside;
    }
    case Op::multiply: {
      auto total = block(children[0]);
      for (std::size_t k = 1; total && k < children.size(); ++k) total = product(total, block(children[k]));
      return total;
    }
    case Op::divide:
      return over(block(children[0]), block(children[1]));
    case Op::power:
      return power(block(children[0]), node.exponent);
    case Op::conjugate:
    case Op::transpose: {
      const auto inside = block(children[0]);
      return inside ? MaybeBlock(transpose(*inside)) : std::nullopt;
    }
    case Op::trace:
    case Op::matrix_determinant: {
      const auto inside = block(children[0]);
      if (!inside || inside->number || inside->rows != inside->columns) return std::nullopt;
      if (node.op == Op::matrix_determinant)
        return Block{.entries = {determinant(inside->entries, inside->rows)}};
      std::vector<ExprId> diagonal;
      for (int k = 0; k < inside->rows; ++k)
        diagonal.push_back(inside->entries[static_cast<std::size_t>(k * (inside->columns + 1))]);
      return Block{.entries = {add(diagonal)}};
    }
    case Op::root:
    case Op::function:
    case Op::absolute:
    case Op::real_power: {
      std::vector<ExprId> arguments;
      for (const ExprId child : children) {
        const auto inside = block(child);
        if (!inside || !inside->number) return std::nullopt;
        arguments.push_back(inside->entries[0]);
      }
      return Block{.entries = {tree_.add(node, arguments)}};
    }
    default:
      return std::nullopt;
  }
}

std::optional<Block> Sizer::symbol(ExprId id) {
  const SymbolId symbol = tree_[id].symbol;
  const Definition* definition = definition_in(asked_, symbol);
  if (definition != nullptr) {
    if (definition->by_square || !definition->indices.empty() || !opened_.insert(symbol).second)
      return std::nullopt;
    into_.unfolded.insert(symbol);
    auto body = block(definition->body);
    opened_.erase(symbol);
    return body;
  }
  if (tree_.symbols[symbol].unsized == Unsized::none) return std::nullopt;
  return letter(symbol);
}

Block Sizer::letter(SymbolId symbol) {
  const bool column = tree_.symbols[symbol].unsized == Unsized::column;
  const auto [at, is_new] = into_.sized.try_emplace(symbol);
  if (is_new) {
    Symbol made;
    made.name = tree_.symbols[symbol].name;
    made.rank = column ? 1 : 2;
    made.axes = AxisSpaces::of(space(), made.rank);
    made.made_at = tree_.size();
    at->second = tree_.symbols.add(std::move(made));
  }
  Block block{.rows = into_.rows, .columns = column ? 1 : into_.rows, .number = false, .entries = {}};
  for (int row = 1; row <= block.rows; ++row) {
    for (int k = 1; k <= block.columns; ++k) {
      const std::array slots{Slot{static_cast<std::uint8_t>(row), {}},
                             Slot{static_cast<std::uint8_t>(k), {}}};
      block.entries.push_back(tree_.add({.op = Op::symbol, .span = span_, .symbol = at->second}, {},
                                        std::span(slots).first(column ? 1 : 2)));
    }
  }
  return block;
}

std::optional<Block> Sizer::sum(ExprId id) {
  MaybeBlock total;
  for (const ExprId child : std::vector<ExprId>(tree_.children(id).begin(), tree_.children(id).end())) {
    auto next = block(child);
    if (!next) return next;
    if (!total) {
      total = std::move(next);
      continue;
    }
    if (!alike(*total, *next)) return std::nullopt;
    for (std::size_t k = 0; k < total->entries.size(); ++k)
      total->entries[k] = add({total->entries[k], next->entries[k]});
  }
  return total;
}

std::optional<Block> Sizer::product(const MaybeBlock& a, const MaybeBlock& b) {
  if (!a || !b) return std::nullopt;
  if (a->number || b->number) {
    Block scaled = a->number ? *b : *a;
    const ExprId factor = a->number ? a->entries[0] : b->entries[0];
    for (ExprId& entry : scaled.entries) entry = multiply(factor, entry);
    return scaled;
  }
  if (a->columns != b->rows) return std::nullopt;
  Block result{
      .rows = a->rows, .columns = b->columns, .number = a->rows == 1 && b->columns == 1, .entries = {}};
  for (int row = 0; row < a->rows; ++row) {
    for (int column = 0; column < b->columns; ++column) {
      std::vector<ExprId> terms;
      for (int k = 0; k < a->columns; ++k)
        terms.push_back(multiply(a->entries[static_cast<std::size_t>(row * a->columns + k)],
                                 b->entries[static_cast<std::size_t>(k * b->columns + column)]));
      result.entries.push_back(add(terms));
    }
  }
  return result;
}

std::optional<Block> Sizer::power(const MaybeBlock& base, int exponent) {
  if (!base || std::abs(exponent) > highest_power) return std::nullopt;
  const auto factor = exponent < 0 ? inverse(*base) : base;
  if (exponent == 0) return Block{.entries = {tree_.add_number(span_, "1")}};
  MaybeBlock total = factor;
  for (int k = 1; k < std::abs(exponent); ++k) total = product(total, factor);
  return total;
}

/// The adjugate over the determinant.
std::optional<Block> Sizer::inverse(const Block& of) {
  if (of.number) return Block{.entries = {divide(tree_.add_number(span_, "1"), of.entries[0])}};
  if (of.rows != of.columns) return std::nullopt;
  const ExprId below = determinant(of.entries, of.rows);
  Block result = of;
  for (int row = 0; row < of.rows; ++row) {
    for (int column = 0; column < of.columns; ++column) {
      const ExprId part = of.rows == 1 ? tree_.add_number(span_, "1")
                                       : determinant(minor(of.entries, of.rows, row, column), of.rows - 1);
      const bool minus = (row + column) % 2 == 1;
      result.entries[static_cast<std::size_t>(column * of.rows + row)] =
          divide(minus ? negate(part) : part, below);
    }
  }
  return result;
}

std::optional<Block> Sizer::over(const MaybeBlock& above, const MaybeBlock& below) {
  if (!above || !below) return std::nullopt;
  return product(above, inverse(*below));
}

Block Sizer::transpose(const Block& of) const {
  Block result{.rows = of.columns, .columns = of.rows, .number = of.number, .entries = of.entries};
  for (int row = 0; row < of.rows; ++row) {
    for (int column = 0; column < of.columns; ++column)
      result.entries[static_cast<std::size_t>(column * of.rows + row)] =
          of.entries[static_cast<std::size_t>(row * of.columns + column)];
  }
  return result;
}

std::vector<ExprId> Sizer::minor(const std::vector<ExprId>& entries, int rows, int row, int column) const {
  std::vector<ExprId> rest;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      if (i != row && j != column) rest.push_back(entries[static_cast<std::size_t>(i * rows + j)]);
    }
  }
  return rest;
}

/// By minors along the first row.
ExprId Sizer::determinant(const std::vector<ExprId>& entries, int rows) {
  if (rows == 1) return entries[0];
  std::vector<ExprId> terms;
  for (int column = 0; column < rows; ++column) {
    const ExprId term = multiply(entries[static_cast<std::size_t>(column)],
                                 determinant(minor(entries, rows, 0, column), rows - 1));
    terms.push_back(column % 2 == 0 ? term : negate(term));
  }
  return add(terms);
}

Block Sizer::times_unit(const Block& number) {
  Block result{.rows = into_.rows, .columns = into_.rows, .number = false, .entries = {}};
  const ExprId zero = tree_.add_number(span_, "0");
  for (int row = 0; row < into_.rows; ++row) {
    for (int column = 0; column < into_.rows; ++column)
      result.entries.push_back(row == column ? number.entries[0] : zero);
  }
  return result;
}

/// Makes a number beside a square matrix a multiple of the unit matrix, and 0 whatever stands beside it.
bool Sizer::alike(Block& a, Block& b) {
  if (a.number == b.number) return a.rows == b.rows && a.columns == b.columns;
  Block& number = a.number ? a : b;
  const Block& other = a.number ? b : a;
  const bool square = other.rows == other.columns;
  if (!square && !tree_.is_zero_literal(number.entries[0])) return false;
  if (square) {
    number = times_unit(number);
  } else {
    number = {.rows = other.rows,
              .columns = other.columns,
              .number = false,
              .entries = std::vector<ExprId>(other.entries.size(), number.entries[0])};
  }
  return true;
}

ExprId Sizer::whole(const Block& of) {
  if (of.number) return of.entries[0];
  const AxisSpaces axes = AxisSpaces::of(space(), 1);
  const auto tuple = [&](std::span<const ExprId> entries, int rank) {
    return tree_.add({.op = Op::tuple, .rank = static_cast<std::uint8_t>(rank), .span = span_, .axes = axes},
                     entries);
  };
  if (of.rows == 1 || of.columns == 1) return tuple(of.entries, 1);
  std::vector<ExprId> lines;
  for (int row = 0; row < of.rows; ++row)
    lines.push_back(
        tuple(std::span(of.entries)
                  .subspan(static_cast<std::size_t>(row * of.columns), static_cast<std::size_t>(of.columns)),
              1));
  return tuple(lines, 2);
}

[[nodiscard]] std::vector<ExprId> roots_of(const Question& question) {
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
  for (const Definition& each : question.definitions) roots.push_back(each.body);
  return roots;
}

/// The second children of traces and determinants.
[[nodiscard]] std::vector<ExprId> numbers_of_rows(const Question& question) {
  std::vector<ExprId> said;
  for (const ExprId id : nodes_below(*question.tree, roots_of(question))) {
    const Op op = (*question.tree)[id].op;
    if ((op == Op::trace || op == Op::matrix_determinant) && (*question.tree)[id].count == 2)
      said.push_back(question.tree->children(id)[1]);
  }
  return said;
}

/// n becomes the number. False: another number is written.
[[nodiscard]] bool put_in_rows(SizedQuestion& sized) {
  ExprTree& tree = *sized.tree;
  std::set<SymbolId> letters;
  for (const ExprId said : numbers_of_rows(sized.question)) {
    if (tree[said].op == Op::number && tree.digits(said) != std::to_string(sized.rows)) return false;
    if (tree[said].op == Op::symbol) letters.insert(tree[said].symbol);
  }
  if (letters.empty()) return true;
  const auto put_in = [&](ExprId& root) {
    root = replaced(tree, root, [&](ExprId id) -> std::optional<ExprId> {
      if (!letters.contains(tree[id].symbol)) return std::nullopt;
      return tree.add_number(tree[id].span, std::to_string(sized.rows));
    });
  };
  put_in(sized.question.claim.left);
  put_in(sized.question.claim.right);
  for (Equation& each : sized.question.assumptions) {
    put_in(each.left);
    put_in(each.right);
  }
  for (Definition& each : sized.question.definitions) put_in(each.body);
  return true;
}

[[nodiscard]] Sample renamed(Sample sample, const std::map<SymbolId, SymbolId>& names) {
  for (SampleValue& value : sample.values) {
    if (const auto found = names.find(value.symbol); found != names.end()) value.symbol = found->second;
  }
  return sample;
}

}  // namespace

int stated_rows(const Question& question) {
  int rows = 0;
  for (const ExprId said : numbers_of_rows(question)) {
    if ((*question.tree)[said].op == Op::number) rows = std::stoi(question.tree->digits(said));
  }
  return rows;
}

std::optional<SizedQuestion> at_size(const Question& question, int rows) {
  SizedQuestion result;
  result.tree = std::make_unique<ExprTree>(*question.tree);
  result.question = question;
  result.question.tree = result.tree.get();
  result.rows = rows;
  if (!put_in_rows(result)) return std::nullopt;
  const Question given = result.question;
  Sizer sizer(result, given);
  if (!question.claim.particles.empty() || !question.claim.indices.empty()) return std::nullopt;
  if (!sizer.equation(result.question.claim)) return std::nullopt;
  for (Equation& assumption : result.question.assumptions) {
    const bool about = sizer.reaches_matrices(assumption.left) || sizer.reaches_matrices(assumption.right);
    if (!about) continue;
    if (!assumption.indices.empty() || !sizer.equation(assumption)) return std::nullopt;
  }
  std::erase_if(result.question.definitions, [&](const Definition& definition) {
    return result.tree->symbols[definition.symbol].noncommuting || sizer.reaches_matrices(definition.body);
  });
  return result;
}

Sample unsized(Sample sample, const SizedQuestion& of) {
  std::map<SymbolId, SymbolId> names;
  for (const auto& [letter, made] : of.sized) names[made] = letter;
  return renamed(std::move(sample), names);
}

Sample sized(Sample sample, const SizedQuestion& of) { return renamed(std::move(sample), of.sized); }

int rows_of_sample(const ExprTree& tree, const Sample& sample) {
  int rows = 0;
  for (const SampleValue& value : sample.values) {
    const Unsized kind = tree.symbols[value.symbol].unsized;
    if (kind == Unsized::none) continue;
    const auto count = static_cast<int>(value.components.size());
    const int own = kind == Unsized::column ? count : static_cast<int>(std::lround(std::sqrt(count)));
    if ((rows != 0 && own != rows) || own < 1 || own > 3) return 0;
    rows = own;
  }
  return rows;
}

}  // namespace rigor
