// SPDX-License-Identifier: GPL-3.0-or-later
// A page that writes out σ_x, σ_y and σ_z, or σ_1, σ_2 and σ_3, as matrices of one size shows that σ stands
// for all three. Who counts spins, `\sigma_i^z` and `\boldsymbol\sigma_1\cdot\boldsymbol\sigma_2`, means one
// triple for each: there an index is a place, and nothing is shown.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

constexpr std::array<std::array<std::string_view, 3>, 2> usual_axes{{{"x", "y", "z"}, {"1", "2", "3"}}};
constexpr std::string_view pauli_letter = "\\sigma";
constexpr MatrixShape pauli_shape{2, 2};

std::array<std::string, 3> member_names(const std::string& letter,
                                        const std::array<std::string_view, 3>& axes) {
  std::array<std::string, 3> names;
  for (std::size_t k = 0; k < 3; ++k) names[k] = letter + "_{" + std::string(axes[k]) + "}";
  return names;
}

/// The one square shape that all three have.
std::optional<MatrixShape> shape_of_members(const Evidence& evidence,
                                            const std::array<std::string, 3>& members) {
  std::set<MatrixShape> shapes;
  for (const std::string& member : members) {
    const auto known = evidence.matrices.find(member);
    if (known == evidence.matrices.end() || known->second.of_itself) return std::nullopt;
    shapes.insert(known->second.shapes.begin(), known->second.shapes.end());
  }
  const bool square =
      shapes.size() == 1 && shapes.begin()->is_matrix() && shapes.begin()->rows == shapes.begin()->columns;
  return square ? std::optional(*shapes.begin()) : std::nullopt;
}

/// Is a matrix of this letter on the page, so that the usual ones need not be meant?
bool is_on_the_page(const Evidence& evidence, const std::string& letter) {
  if (evidence.written_out.contains(letter) || evidence.matrices.contains(letter)) return true;
  return std::ranges::any_of(evidence.matrices,
                             [&](const auto& each) { return each.first.starts_with(letter + "_"); });
}

/// i, j, k and a, b, c; but \sigma_n beside a vector \mathbf n is the component along it.
bool is_index_of_triples(const Evidence& evidence, const WrittenIndex& index) {
  static constexpr auto letters =
      std::to_array<std::string_view>({"i", "j", "k", "l", "m", "n", "a", "b", "c", "d"});
  return index.form == IndexForm::letter && index.primes == 0 && is_one_of(index.text, letters) &&
         !evidence.vectors.contains(index.text) && !evidence.hatted.contains("\\hat{" + index.text + "}");
}

bool is_axis(const WrittenIndex& index) {
  return index.primes == 0 && std::ranges::any_of(usual_axes, [&](const auto& axes) {
           return is_one_of(std::string_view(index.text), axes);
         });
}

/// `\sigma_i^z`, `\sigma^x`: the axis stands above.
bool is_axis_above(const SyntaxTree& syntax, SyntaxId exponent) {
  static constexpr auto above = std::to_array<std::string_view>({"x", "y", "z", "+", "-", "\\pm", "a"});
  return syntax[exponent].kind == SyntaxKind::symbol && is_one_of(syntax.symbol(exponent).letter, above);
}

/// `\sigma_p`, `\sigma_A`: the standard deviation of an observable, or the spin of one of two.
bool names_a_spread(const WrittenSymbol& symbol) {
  static constexpr auto observables =
      std::to_array<std::string_view>({"p", "q", "r", "t", "E", "A", "B", "X", "P", "H", "\\omega"});
  return symbol.face == Face::plain && symbol.lower.size() == 1 &&
         is_one_of(symbol.lower[0].text, observables);
}

/// Letters that stand for several triples.
void see_many(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol) {
      const WrittenSymbol& symbol = syntax.symbol(id);
      const bool labelled = symbol.face == Face::vector ? !symbol.lower.empty() : symbol.lower.size() > 1;
      const bool spread = letter_with_marks(symbol) == pauli_letter && names_a_spread(symbol);
      const bool above = !symbol.lower.empty() && symbol.lower[0].text.starts_with('^');
      if (labelled || above || spread) evidence.many_triples.insert(letter_with_marks(symbol));
    }
    if (syntax[id].kind != SyntaxKind::power || !is_axis_above(syntax, syntax.child(id, 1))) continue;
    const SyntaxId base = syntax.child(id, 0);
    if (syntax[base].kind == SyntaxKind::symbol)
      evidence.many_triples.insert(letter_with_marks(syntax.symbol(base)));
  }
}

/// Who multiplies a vector with matrices means one of space, whose components are real.
void see_vectors_beside(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId term : nodes_below(syntax, sides)) {
    if (syntax[term].kind != SyntaxKind::term) continue;
    const std::span<const SyntaxChild> factors = syntax.children(term);
    for (std::size_t k = 1; k < factors.size(); ++k) {
      if (factors[k].joint != Joint::dot) continue;
      const SyntaxId both[] = {factors[k - 1].id, factors[k].id};
      if (!std::ranges::all_of(both, [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; }))
        continue;
      const WrittenSymbol& left = syntax.symbol(both[0]);
      const WrittenSymbol& right = syntax.symbol(both[1]);
      if (whole_triple(evidence, left).has_value() == whole_triple(evidence, right).has_value()) continue;
      const WrittenSymbol& vector = whole_triple(evidence, left) ? right : left;
      if (!evidence.complex_vectors) evidence.real.insert(letter_with_marks(vector));
    }
  }
}

/// The shape of a multiple of a triple, `\frac\hbar2\boldsymbol\sigma`, and with an index of its member
/// `\frac\hbar2\sigma_i`. Recursion: as deep as the tree.
MatrixShape shape_of_multiple(const SyntaxTree& syntax, SyntaxId id, const std::string& index,
                              const Evidence& evidence) {
  const SyntaxNode& node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      const WrittenSymbol& symbol = syntax.symbol(id);
      const auto triple = index.empty() ? whole_triple(evidence, symbol) : triple_of_member(evidence, symbol);
      const bool same = triple && (index.empty() || symbol.lower[0].text == index);
      return same ? triple->shape : MatrixShape{};
    }
    case SyntaxKind::group:
    case SyntaxKind::fraction:
      return shape_of_multiple(syntax, syntax.child(id, 0), index, evidence);
    case SyntaxKind::sum:
      return node.count == 1 ? shape_of_multiple(syntax, syntax.child(id, 0), index, evidence)
                             : MatrixShape{};
    case SyntaxKind::term: {
      MatrixShape found;
      for (const SyntaxChild& child : syntax.children(id)) {
        const bool vector =
            syntax[child.id].kind == SyntaxKind::symbol && syntax.symbol(child.id).face == Face::vector;
        const MatrixShape shape = child.joint == Joint::slash
                                      ? MatrixShape{}
                                      : shape_of_multiple(syntax, child.id, index, evidence);
        const bool product = child.joint == Joint::dot || child.joint == Joint::cross;
        if (product || (vector && !shape.any()) || (shape.any() && found.any())) return {};
        if (shape.any()) found = shape;
      }
      return found;
    }
    default:
      return {};
  }
}

}  // namespace

std::optional<MatrixTriple> triple_of(const Evidence& evidence, const std::string& letter) {
  if (evidence.many_triples.contains(letter)) return std::nullopt;
  for (const auto& axes : usual_axes) {
    const auto members = member_names(letter, axes);
    if (const auto shape = shape_of_members(evidence, members)) return MatrixTriple{*shape, members, false};
  }
  const auto vector = evidence.triples.find(letter);
  if (vector != evidence.triples.end() && vector->second.shapes.size() == 1)
    return MatrixTriple{.shape = *vector->second.shapes.begin()};
  const bool pauli = letter == pauli_letter && evidence.speaks_of_pauli && vector == evidence.triples.end() &&
                     !is_on_the_page(evidence, letter);
  if (pauli) return MatrixTriple{.shape = pauli_shape, .usual = true};
  return std::nullopt;
}

std::optional<MatrixTriple> whole_triple(const Evidence& evidence, const WrittenSymbol& symbol) {
  if (symbol.face != Face::vector || !symbol.lower.empty()) return std::nullopt;
  return triple_of(evidence, letter_with_marks(symbol));
}

std::optional<MatrixTriple> triple_of_member(const Evidence& evidence, const WrittenSymbol& symbol) {
  if (symbol.face != Face::plain || symbol.lower.size() != 1) return std::nullopt;
  const WrittenIndex& index = symbol.lower[0];
  if (!is_axis(index) && !is_index_of_triples(evidence, index)) return std::nullopt;
  return triple_of(evidence, letter_with_marks(symbol));
}

void see_triples(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                 Evidence& evidence) {
  see_many(syntax, sides, evidence);
  see_vectors_beside(syntax, sides, evidence);
  const bool equal = std::ranges::all_of(written.relations, [](const WrittenRelation& relation) {
    return relation.kind == RelationKind::equal || relation.kind == RelationKind::identical ||
           relation.kind == RelationKind::defines;
  });
  if (!equal || sides.size() < 2) return;
  for (const SyntaxId side : sides) {
    if (syntax[side].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(side);
    const std::string name = letter_with_marks(symbol);
    const bool whole = symbol.face == Face::vector && symbol.lower.empty();
    const bool member = symbol.face == Face::plain && symbol.lower.size() == 1 && sides.size() == 2 &&
                        side == sides[0] && is_index_of_triples(evidence, symbol.lower[0]);
    const auto known = triple_of(evidence, name);
    if ((!whole && !member) || symbol.dots > 0 || (known && !known->members[0].empty())) continue;
    for (const SyntaxId other : sides) {
      if (syntax[other].kind == SyntaxKind::symbol) continue;
      const MatrixShape shape =
          shape_of_multiple(syntax, other, whole ? std::string() : symbol.lower[0].text, evidence);
      if (!shape.any()) continue;
      MatrixLetter& letter = evidence.triples[name];
      letter.shapes.insert(shape);
      letter.set_there.emplace(syntax[side].span.file, syntax[side].span.begin);
    }
  }
}

}  // namespace rigor
