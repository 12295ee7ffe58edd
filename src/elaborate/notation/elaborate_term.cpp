// SPDX-License-Identifier: GPL-3.0-or-later
// Products. Among vectors `\times` binds tighter than `\cdot`, and `\cdot` tighter than juxtaposition;
// scalars stand anywhere. Where that leaves two readings (A×B×C, a/bc) the answer is a diagnostic.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/name/spelled.h"
#include "elaborate/notation/elaborator.h"
#include "expr/print/usual_letters.h"

namespace rigor {
namespace {

/// A bracket that holds one bare symbol or number: `(t)`, `(x)`.
bool holds_one_symbol(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind != SyntaxKind::group) return false;
  const SyntaxKind inside = syntax[syntax.child(id, 0)].kind;
  return inside == SyntaxKind::symbol || inside == SyntaxKind::number;
}

/// `\frac{d\phi}{dt}(t + T)`: a derivative, and a bracket that speaks of what it is by.
bool is_taken_at(const SyntaxTree& syntax, SyntaxId derivative, SyntaxId bracket) {
  if (syntax[derivative].kind != SyntaxKind::derivative || syntax[bracket].kind != SyntaxKind::group)
    return false;
  const std::vector<WrittenVariable>& by = syntax.derivative(derivative).by;
  std::vector<SyntaxId> pending{syntax.child(bracket, 0)};
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    for (const SyntaxChild& child : syntax.children(id)) pending.push_back(child.id);
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const std::string& letter = syntax.symbol(id).letter;
    if (std::any_of(by.begin(), by.end(), [&](const auto& each) { return each.symbol.letter == letter; }))
      return true;
  }
  return false;
}

}  // namespace

std::optional<Typed> Elaborator::term(SyntaxId id) {
  const std::span<const SyntaxChild> factors = syntax_.children(id);
  std::vector<Operand> operands;
  bool failed = false;
  bool slash = false;
  for (std::size_t k = 0; k < factors.size();) {
    const SyntaxChild& child = factors[k];
    std::size_t next = k + 1;
    Maybe typed =
        acts_as_operator(syntax_, child.id) ? apply_operator(factors, k, next) : expression(child.id);
    failed = failed || !typed;
    slash = slash || child.joint == Joint::slash;
    if (typed) operands.push_back({std::move(*typed), child.joint, child.joint_span});
    k = next;
  }
  if (failed || reads_as_application(factors) || repeats_greek(factors) || runs_numbers_together(factors))
    return std::nullopt;
  return slash ? with_slashes(std::move(operands), syntax_[id].span)
               : product(std::move(operands), syntax_[id].span);
}

/// Is it declared, as it stands or without its subscripts? Then it is a quantity, and no function.
bool Elaborator::is_declared_letter(const WrittenSymbol& symbol) const {
  const std::string labelled = with_labels(symbol.letter, symbol.lower);
  return names_.is_declared({symbol.letter, 0, false}) || names_.is_declared({symbol.letter, 1, false}) ||
         names_.is_declared({labelled, 0, false});
}

/// `f(x-ct)`, `V(2r)`: a bracket of plain coordinates behind a letter that is no usual coefficient.
bool Elaborator::looks_like_argument(const WrittenSymbol& symbol, SyntaxId bracket) const {
  if (syntax_[bracket].kind != SyntaxKind::group || is_usual_coefficient(symbol.letter)) return false;
  if (is_declared_letter(symbol)) return false;
  bool coordinate = false;
  std::vector<SyntaxId> pending{syntax_.child(bracket, 0)};
  while (!pending.empty()) {
    const SyntaxId id = pending.back();
    pending.pop_back();
    if (syntax_[id].kind == SyntaxKind::symbol) {
      const WrittenSymbol& inside = syntax_.symbol(id);
      const bool labelled =
          std::any_of(inside.lower.begin(), inside.lower.end(),
                      [](const WrittenIndex& index) { return index.form == IndexForm::letter; });
      if (inside.face != Face::plain || labelled || is_kronecker(inside)) return false;
      coordinate = coordinate || is_usual_coordinate(inside.letter);
    }
    for (const SyntaxChild& child : syntax_.children(id)) pending.push_back(child.id);
  }
  return coordinate;
}

/// A Greek subscript that labels no particle, twice in a term: a label, or an index of space-time that is
/// summed.
bool Elaborator::repeats_greek(std::span<const SyntaxChild> factors) {
  std::set<std::string> seen;
  for (const SyntaxChild& child : factors) {
    if (syntax_[child.id].kind != SyntaxKind::symbol) continue;
    std::set<std::string> own;
    for (const WrittenIndex& index : syntax_.symbol(child.id).lower) {
      if (index.form == IndexForm::greek && !names_.labels_particles(index.text)) own.insert(index.text);
    }
    for (const std::string& letter : own) {
      if (seen.insert(letter).second) continue;
      fail(DiagnosticKind::ambiguous_reading, syntax_[child.id].span,
           fmt::format("`{}` twice in a term can be a label or an index that is summed", letter),
           {fmt::format("`rigor: particles {}` makes it a particle's label, which is summed only by `\\sum`",
                        letter)});
      return true;
    }
  }
  return false;
}

/// `f(x)` and `\omega(t)` can be a value of a function or a product; `dx` a differential or a product.
bool Elaborator::reads_as_application(std::span<const SyntaxChild> factors) {
  if (auto spelled = spelled_part(syntax_, factors, names_)) {
    fail(DiagnosticKind::ambiguous_reading, spelled->span, std::move(spelled->message),
         std::move(spelled->help));
    return true;
  }
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    const SyntaxId id = factors[k].id;
    const SyntaxId next = factors[k + 1].id;
    if (factors[k + 1].joint != Joint::juxtaposed) continue;
    if (syntax_[id].kind == SyntaxKind::unit && syntax_[next].kind == SyntaxKind::number) {
      fail(DiagnosticKind::ambiguous_reading, cover(syntax_[id].span, syntax_[next].span),
           "a number behind a unit can be added, as in 1 h 30 min, or multiplied",
           {"a sign between them says which is meant"});
      return true;
    }
    if (is_taken_at(syntax_, id, next)) {
      fail(DiagnosticKind::ambiguous_reading, cover(syntax_[id].span, syntax_[next].span),
           "this can be a product, or the derivative at what the bracket says");
      return true;
    }
    if (syntax_[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax_.symbol(id);
    if (is_kronecker(symbol) || is_levi_civita(symbol) || is_nabla(syntax_, id)) continue;
    if (holds_one_symbol(syntax_, next) || looks_like_argument(symbol, next) ||
        (syntax_[next].kind == SyntaxKind::tuple && symbol.face == Face::plain)) {
      const SyntaxId argument = syntax_.child(next, 0);
      const bool one_symbol =
          syntax_[argument].kind == SyntaxKind::symbol && syntax_[next].kind == SyntaxKind::group;
      if (one_symbol && names_.is_declared({syntax_.symbol(argument).letter, 0, false})) continue;
      fail(DiagnosticKind::ambiguous_reading, cover(syntax_[id].span, syntax_[next].span),
           "this can be a product or the value of a function",
           {"a function's argument is not written in definitions and claims",
            fmt::format("`rigor: scalar {}` makes it a product",
                        one_symbol ? syntax_.symbol(argument).letter : symbol.letter)});
      return true;
    }
    if (applies_elsewhere(id, next)) {
      fail(DiagnosticKind::ambiguous_reading, cover(syntax_[id].span, syntax_[next].span),
           fmt::format("`{}` is written as a function elsewhere: this can be its value or a product",
                       symbol.letter),
           {fmt::format("`rigor: scalar {}` makes it a product", symbol.letter)});
      return true;
    }
    const bool bare_d =
        symbol.letter == "d" && symbol.lower.empty() && symbol.face == Face::plain && symbol.primes == 0;
    SyntaxId changed = next;
    if (syntax_[changed].kind == SyntaxKind::power) changed = syntax_.child(changed, 0);
    const SyntaxKind of = syntax_[changed].kind;
    const bool greek_d = (symbol.letter == "\\delta" || symbol.letter == "\\Delta") && symbol.lower.empty() &&
                         symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0;
    if (greek_d && of == SyntaxKind::group && !names_.is_declared({symbol.letter, 0, false}) &&
        !names_.is_small_scalar(tree_, symbol.letter)) {
      fail(DiagnosticKind::ambiguous_reading, syntax_[id].span,
           fmt::format("`{}` before a bracket can be a change of what is in it, a function, or a factor",
                       symbol.letter),
           {fmt::format("`rigor: scalar {}` makes it a factor", symbol.letter)});
      return true;
    }
    if (bare_d && (of == SyntaxKind::symbol || of == SyntaxKind::group) &&
        !names_.is_declared({"d", 0, false})) {
      fail(DiagnosticKind::ambiguous_reading, syntax_[id].span, "`d` can be a differential or a factor",
           {"`rigor: scalar d` makes it a factor"});
      return true;
    }
  }
  return false;
}

/// `1\,000` and `2\frac{1}{2}` are one number each to most readers, and products to the letter.
bool Elaborator::runs_numbers_together(std::span<const SyntaxChild> factors) {
  const auto is_number_sign = [&](SyntaxId id) { return syntax_[id].kind == SyntaxKind::number; };
  const auto is_numeric_fraction = [&](SyntaxId id) {
    return syntax_[id].kind == SyntaxKind::fraction && is_number_sign(syntax_.child(id, 0)) &&
           is_number_sign(syntax_.child(id, 1));
  };
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {
    const SyntaxId next = factors[k + 1].id;
    if (factors[k + 1].joint != Joint::juxtaposed || !is_number_sign(factors[k].id)) continue;
    if (!is_number_sign(next) && !is_numeric_fraction(next)) continue;
    fail(DiagnosticKind::ambiguous_reading, cover(syntax_[factors[k].id].span, syntax_[next].span),
         "two numbers side by side can be one number or a product", {"write `\\cdot` for a product"});
    return true;
  }
  return false;
}

std::optional<Typed> Elaborator::divide(const Typed& dividend, const Typed& divisor, Span span) {
  if (divisor.rank != 0) {
    return fail(DiagnosticKind::rank_mismatch, tree_[divisor.id].span,
                "a vector or tensor stands in a denominator", {"divide by its length or by a component"});
  }
  if (!divisor.free.empty()) {
    return unsupported(divisor.free[0].span,
                       fmt::format("the index `{}` in a denominator is not decided", divisor.free[0].letter));
  }
  return make(Op::divide, span, dividend.rank, {&dividend, &divisor});
}

/// `ab/c` divides all that stands before; `1/2 m` is one half of m; `a/b c` has two readings.
std::optional<Typed> Elaborator::with_slashes(std::vector<Operand> operands, Span span) {
  for (std::size_t k = 1; k < operands.size(); ++k) {
    if (operands[k].joint != Joint::slash) continue;
    const Typed divisor = operands[k].typed;
    const bool numbers = is_number(operands[k - 1].typed) && is_number(divisor);
    const bool last = k + 1 == operands.size();
    if (!numbers && !last) {
      return fail(DiagnosticKind::ambiguous_reading, operands[k].joint_span,
                  "what stands behind the divisor can belong to it or not",
                  {"write `\\frac{…}{…}` or a bracket"});
    }
    if (numbers) {
      const Maybe quotient = divide(operands[k - 1].typed, divisor,
                                    cover(tree_[operands[k - 1].typed.id].span, tree_[divisor.id].span));
      if (!quotient) return std::nullopt;
      operands[k - 1].typed = *quotient;
      operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(k));
      --k;
      continue;
    }
    operands.resize(k);
    const Maybe dividend = product(std::move(operands), span);
    return dividend ? divide(*dividend, divisor, span) : std::nullopt;
  }
  return product(std::move(operands), span);
}

std::optional<Typed> Elaborator::product(std::vector<Operand> operands, Span span) {
  if (operands.size() == 1) return operands[0].typed;
  std::vector<Typed> factors;
  for (const Operand& operand : operands) factors.push_back(operand.typed);
  std::vector<FreeIndex> to_sum;
  Typed total;
  std::vector<FreeIndex> free;
  std::vector<FreeIndex> bound;
  if (!sum_repeated(factors, to_sum, free, bound)) return std::nullopt;
  std::vector<Typed> scalars;
  std::vector<Operand> vectors;
  if (!separate_scalars(operands, scalars, vectors) || !cross_products(vectors) || !dot_products(vectors))
    return std::nullopt;
  Maybe result = outer_product(std::move(scalars), vectors, span);
  if (!result) return std::nullopt;
  result->free = std::move(free);
  result->bound = std::move(bound);
  return sum_over(std::move(*result), to_sum);
}

/// A scalar between a product sign and a vector belongs to the vector: `\mathbf R\times m\mathbf V`.
bool Elaborator::separate_scalars(const std::vector<Operand>& operands, std::vector<Typed>& scalars,
                                  std::vector<Operand>& vectors) {
  Joint carried = Joint::none;
  const Operand* crossed = nullptr;  // a scalar that a `\times` leads to
  const Operand* previous = nullptr;
  for (const Operand& operand : operands) {
    const bool after_scalar = previous != nullptr && previous->typed.rank == 0;
    const bool by_number = is_number(operand.typed) || (after_scalar && is_number(previous->typed));
    const bool dotted = operand.joint == Joint::dot && previous != nullptr;
    const bool product_dotted =
        dotted &&
        ((operand.typed.rank == 0 && previous->typed.rank == 1 && tree_[operand.typed.id].op == Op::dot) ||
         (operand.typed.rank == 1 && after_scalar && tree_[previous->typed.id].op == Op::dot));
    if (product_dotted) {
      fail(DiagnosticKind::rank_mismatch, operand.joint_span, "a dot product of a vector and a scalar",
           {"leave `\\cdot` out, if a multiple is meant"});
      return false;
    }
    if (operand.typed.rank == 0) {
      if (operand.joint == Joint::dot || operand.joint == Joint::cross) carried = operand.joint;
      if (operand.joint == Joint::cross && !by_number) crossed = &operand;
      scalars.push_back(operand.typed);
    } else {
      const bool from_scalar_only =
          vectors.empty() && operand.joint == Joint::cross && after_scalar && !by_number;
      if (from_scalar_only) {
        fail(DiagnosticKind::rank_mismatch, operand.joint_span, "a cross product of a scalar and a vector",
             {"write the product without `\\times`, or declare the scalar as a vector"});
        return false;
      }
      const bool joined = operand.joint == Joint::dot || operand.joint == Joint::cross;
      Joint joint = joined ? operand.joint : (carried != Joint::none ? carried : Joint::juxtaposed);
      if (vectors.empty()) joint = Joint::none;
      vectors.push_back({operand.typed, joint, operand.joint_span});
      carried = Joint::none;
      crossed = nullptr;
    }
    previous = &operand;
  }
  if (crossed != nullptr) {
    const bool any_vector = !vectors.empty();
    fail(any_vector ? DiagnosticKind::rank_mismatch : DiagnosticKind::ambiguous_reading, crossed->joint_span,
         any_vector ? "a cross product of a vector and a scalar"
                    : "`\\times` between scalars can be a product, or a cross product of vectors",
         {"bold or `\\vec` letters are vectors, and so is what `rigor: vector …` declares"});
    return false;
  }
  return true;
}

bool Elaborator::cross_products(std::vector<Operand>& vectors) {
  for (std::size_t k = 1; k < vectors.size();) {
    if (vectors[k].joint != Joint::cross) {
      ++k;
      continue;
    }
    if (k + 1 < vectors.size() && vectors[k + 1].joint == Joint::cross) {
      fail(DiagnosticKind::ambiguous_reading, vectors[k + 1].joint_span,
           "a cross product is not associative, so `A × B × C` has two readings",
           {"put one of the two products in brackets"});
      return false;
    }
    if (vectors[k - 1].typed.rank != 1 || vectors[k].typed.rank != 1) {
      unsupported(vectors[k].joint_span, "a cross product with a tensor is not decided");
      return false;
    }
    const Span span = cover(tree_[vectors[k - 1].typed.id].span, tree_[vectors[k].typed.id].span);
    vectors[k - 1].typed = make(Op::cross, span, 1, {&vectors[k - 1].typed, &vectors[k].typed});
    vectors.erase(vectors.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return true;
}

bool Elaborator::dot_products(std::vector<Operand>& vectors) {
  for (std::size_t k = 1; k < vectors.size();) {
    if (vectors[k].joint != Joint::dot) {
      ++k;
      continue;
    }
    Typed& left = vectors[k - 1].typed;
    if (left.rank == 0) {
      fail(DiagnosticKind::ambiguous_reading, vectors[k].joint_span, "`A · B · C` has two readings",
           {"put one of the two products in brackets"});
      return false;
    }
    const Typed& right = vectors[k].typed;
    const Span span = cover(tree_[left.id].span, tree_[right.id].span);
    left = make(Op::dot, span, left.rank + right.rank - 2, {&left, &right});
    vectors.erase(vectors.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return true;
}

std::optional<Typed> Elaborator::outer_product(std::vector<Typed> scalars,
                                               const std::vector<Operand>& vectors, Span span) {
  int rank = 0;
  for (const Operand& vector : vectors) {
    if (rank > 0 && vector.typed.rank > 0 && rank + vector.typed.rank > 2) {
      return fail(DiagnosticKind::ambiguous_reading, tree_[vector.typed.id].span,
                  "a tensor next to a vector can be their contraction or their outer product",
                  {"write `\\cdot` for the contraction"});
    }
    if (rank > 0 && vector.typed.rank > 0) guess_dyad(vectors, span);
    rank += vector.typed.rank;
    scalars.push_back(vector.typed);
  }
  if (scalars.size() == 1) return scalars[0];
  Typed total;
  total.rank = rank;
  std::vector<ExprId> children;
  for (const Typed& factor : scalars) {
    children.push_back(factor.id);
    merge_free(total.free, factor.free);
    merge_free(total.particles, factor.particles);
  }
  total.id = tree_.add({.op = Op::multiply, .rank = static_cast<std::uint8_t>(rank), .span = span}, children);
  return total;
}

/// `\mathbf A\mathbf B` is a dyad of vectors; with bold letters for matrices it is their product.
void Elaborator::guess_dyad(const std::vector<Operand>& vectors, Span span) {
  const bool undeclared = std::any_of(vectors.begin(), vectors.end(), [&](const Operand& vector) {
    const ExprNode& node = tree_[vector.typed.id];
    return node.op == Op::tuple || (node.op == Op::symbol && !tree_.symbols[node.symbol].declared);
  });
  note("two vectors side by side are their dyad");
  if (!undeclared) return;
  dyad_ = span;
  const bool hats = std::any_of(vectors.begin(), vectors.end(), [&](const Operand& vector) {
    const ExprNode& node = tree_[vector.typed.id];
    return node.op == Op::symbol && tree_.symbols[node.symbol].name.starts_with("\\hat");
  });
  guess_ =
      hats ? Obstacle{DiagnosticKind::ambiguous_reading,
                      "letters with hats side by side can be a dyad of vectors or a product of operators, "
                      "which are not decided with",
                      {}}
           : Obstacle{DiagnosticKind::ambiguous_reading,
                      "bold letters side by side can be a dyad of vectors or a product of matrices",
                      {"`rigor: vector …` says that they are vectors"}};
}

}  // namespace rigor
