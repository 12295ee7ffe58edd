// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

bool is_whole(std::string_view digits) {
  return !digits.empty() && std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

/// The shape of a side, as far as it is written in rows and columns, and in letters that are known to be.
class Shapes {
 public:
  Shapes(const SyntaxTree& syntax, const Evidence& evidence) : syntax_(syntax), evidence_(evidence) {}

  [[nodiscard]] MatrixShape of(SyntaxId id) const {
    const SyntaxNode& node = syntax_[id];
    switch (node.kind) {
      case SyntaxKind::matrix:
        return written_shape(syntax_, id);
      case SyntaxKind::tuple:
        return of_tuple(id);
      case SyntaxKind::symbol: {
        const auto known = evidence_.matrices.find(matrix_name(syntax_.symbol(id)));
        const bool one = known != evidence_.matrices.end() && known->second.shapes.size() == 1;
        if (one) return *known->second.shapes.begin();
        const auto triple = triple_of_member(evidence_, syntax_.symbol(id));
        return triple ? triple->shape : MatrixShape{};
      }
      case SyntaxKind::group:
      case SyntaxKind::fraction:
        return of(syntax_.child(id, 0));
      case SyntaxKind::sum:
        return of_sum(id);
      case SyntaxKind::term:
        return of_product(id);
      case SyntaxKind::power:
        return of_power(id);
      case SyntaxKind::function:
        return of_function(id);
      default:
        return {};
    }
  }

 private:
  /// A column or row, or a commutator.
  [[nodiscard]] MatrixShape of_tuple(SyntaxId id) const {
    const bool pair = syntax_[id].count == 2 && syntax_[id].payload == 0;
    const MatrixShape first = pair ? of(syntax_.child(id, 0)) : MatrixShape{};
    const bool commutes =
        pair && syntax_.children(id)[0].joint != Joint::comma && first.rows == first.columns;
    return commutes ? first : written_shape(syntax_, id);
  }

  [[nodiscard]] MatrixShape of_function(SyntaxId id) const {
    const SyntaxId argument = syntax_.child(id, 0);
    const MatrixShape inside = of(argument);
    if (syntax_.text(id) == "conjugate") return inside;
    if (syntax_.text(id) == "transpose" || syntax_.text(id) == "adjoint")
      return {inside.columns, inside.rows};
    const std::uint32_t count = syntax_[argument].count;
    if (syntax_.text(id) != "diag" || syntax_[argument].kind != SyntaxKind::tuple || count > most_rows)
      return {};
    return {static_cast<std::uint8_t>(count), static_cast<std::uint8_t>(count)};
  }

  [[nodiscard]] MatrixShape of_sum(SyntaxId id) const {
    for (const SyntaxChild& child : syntax_.children(id)) {
      if (const MatrixShape shape = of(child.id); shape.any()) return shape;
    }
    return {};
  }

  /// Rows of the first and columns of the last; none where a row beside a column makes a number.
  [[nodiscard]] MatrixShape of_product(SyntaxId id) const {
    MatrixShape product;
    const std::span<const SyntaxChild> factors = syntax_.children(id);
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const SyntaxChild& child = factors[k];
      const bool dotted = k + 1 < factors.size() && factors[k + 1].joint == Joint::dot;
      const MatrixShape scalar_product = dotted ? of_dot(child.id, factors[k + 1].id) : MatrixShape{};
      if (scalar_product.any()) ++k;
      const MatrixShape factor = scalar_product.any() ? scalar_product : of(child.id);
      const bool open = syntax_[child.id].kind == SyntaxKind::symbol &&
                        may_be_a_matrix(letter_with_marks(syntax_.symbol(child.id)), evidence_);
      if (!factor.any() && open) return {};
      if (!factor.any()) continue;
      if (product.any() && product.columns != factor.rows) return {};
      product = {product.any() ? product.rows : factor.rows, factor.columns};
    }
    return product.rows == 1 && product.columns == 1 ? MatrixShape{} : product;
  }

  [[nodiscard]] MatrixShape of_vector(SyntaxId id) const {
    if (syntax_[id].kind != SyntaxKind::symbol) return {};
    const auto triple = whole_triple(evidence_, syntax_.symbol(id));
    return triple ? triple->shape : MatrixShape{};
  }

  /// `\boldsymbol\sigma\cdot\mathbf a`
  [[nodiscard]] MatrixShape of_dot(SyntaxId left, SyntaxId right) const {
    const MatrixShape first = of_vector(left);
    return first.any() ? first : of_vector(right);
  }

  [[nodiscard]] MatrixShape of_power(SyntaxId id) const {
    const MatrixShape vector = of_vector(syntax_.child(id, 0));
    const MatrixShape base = vector.any() ? vector : of(syntax_.child(id, 0));
    SyntaxId above = syntax_.child(id, 1);
    if (syntax_[above].kind == SyntaxKind::sum && syntax_[above].count == 1) above = syntax_.child(above, 0);
    const bool whole = syntax_[above].kind == SyntaxKind::number && is_whole(syntax_.text(above));
    return whole && base.rows == base.columns ? base : MatrixShape{};
  }

  const SyntaxTree& syntax_;
  const Evidence& evidence_;
};

bool makes_equal(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::identical || kind == RelationKind::defines;
}

void see_entries(const SyntaxTree& syntax, SyntaxId side, Evidence& evidence) {
  for (const SyntaxId table : nodes_below(syntax, {side})) {
    if (!written_shape(syntax, table).any() && syntax[table].kind != SyntaxKind::determinant) continue;
    for (const SyntaxId id : nodes_below(syntax, {table})) {
      if (syntax[id].kind == SyntaxKind::symbol) evidence.entries.insert(matrix_name(syntax.symbol(id)));
    }
  }
}

/// `v^Tv`, `v^\dagger v`, `v\cdot v`: a number, but v is none.
bool is_row_times_column(const SyntaxTree& syntax, SyntaxId term) {
  const std::span<const SyntaxChild> factors = syntax.children(term);
  const auto is_symbol = [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; };
  const bool squared = factors.size() == 2 && factors[1].joint == Joint::dot && is_symbol(factors[0].id) &&
                       is_symbol(factors[1].id) &&
                       matrix_name(syntax.symbol(factors[0].id)) == matrix_name(syntax.symbol(factors[1].id));
  return squared || std::ranges::any_of(factors, [&](const SyntaxChild& child) {
           return syntax[child.id].kind == SyntaxKind::function &&
                  (syntax.text(child.id) == "transpose" || syntax.text(child.id) == "adjoint");
         });
}

/// A letter, or those of a product.
void take_names(const SyntaxTree& syntax, SyntaxId id, std::set<std::string>& letters) {
  if (syntax[id].kind == SyntaxKind::symbol) letters.insert(matrix_name(syntax.symbol(id)));
  if (syntax[id].kind != SyntaxKind::term || is_row_times_column(syntax, id)) return;
  for (const SyntaxChild& child : syntax.children(id)) take_names(syntax, child.id, letters);
}

/// `\lambda I`, and `\omega^2M` of a matrix M that is written above.
void see_multiple(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, Evidence& evidence) {
  if (factors.size() != 2 || syntax[factors[1].id].kind != SyntaxKind::symbol) return;
  const bool power = syntax[factors[0].id].kind == SyntaxKind::power;
  const SyntaxId first = power ? syntax.child(factors[0].id, 0) : factors[0].id;
  if (syntax[first].kind != SyntaxKind::symbol) return;
  const std::string number = matrix_name(syntax.symbol(first));
  const bool capital = is_capital_letter(number[0]) || (number[0] == '\\' && is_capital_letter(number[1]));
  const std::string matrix = matrix_name(syntax.symbol(factors[1].id));
  const bool usual = number == "\\omega" || number == "\\lambda" || number == "\\mu";
  const bool known = usual && evidence.matrices.contains(matrix) && !evidence.matrices.contains(number);
  if (!capital && ((matrix == "I" && !power) || known))
    evidence.multiples.insert(letter_with_marks(syntax.symbol(first)));
}

/// What is divided by, what a sine is taken of, and what is equal to a number: `A = 5`.
void see_numbers(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::fraction)
      take_names(syntax, syntax.child(id, 1), evidence.plain_numbers);
    if (syntax[id].kind == SyntaxKind::term) {
      see_multiple(syntax, syntax.children(id), evidence);
      for (const SyntaxChild& child : syntax.children(id)) {
        if (child.joint == Joint::slash) take_names(syntax, child.id, evidence.plain_numbers);
      }
    }
    static constexpr std::array<std::string_view, 5> of_numbers{"sin", "cos", "tan", "ln", "log"};
    if (syntax[id].kind == SyntaxKind::function && is_one_of(syntax.text(id), of_numbers))
      take_names(syntax, syntax.child(id, 0), evidence.plain_numbers);
  }
  const bool value = std::ranges::any_of(sides, [&](SyntaxId side) {
    if (syntax[side].kind == SyntaxKind::sum && syntax[side].count == 1) side = syntax.child(side, 0);
    return syntax[side].kind == SyntaxKind::number && syntax.text(side) != "0" && syntax.text(side) != "1";
  });
  for (const SyntaxId side : sides) {
    if (value && syntax[side].kind == SyntaxKind::symbol) take_names(syntax, side, evidence.plain_numbers);
  }
}

/// `\sigma_i` of a triple is no matrix of its own; nor is \sigma_z of one that the words name.
bool is_indexed_member(const WrittenSymbol& symbol, const Evidence& evidence) {
  const auto triple = triple_of_member(evidence, symbol);
  return triple && !is_one_of(matrix_name(symbol), triple->members);
}

/// `\sigma_z` that only the words name is an operator among others: a, \sigma_+ and what has a dagger.
bool is_beside_operators(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides,
                         const Evidence& evidence) {
  bool usual = false;
  bool others = false;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    others = others || (syntax[id].kind == SyntaxKind::function && syntax.text(id) == "adjoint");
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const auto member = triple_of_member(evidence, symbol);
    const auto triple = member ? member : whole_triple(evidence, symbol);
    usual = usual || (triple && triple->usual);
    const bool ladder =
        symbol.lower.size() == 1 && (symbol.lower[0].text == "+" || symbol.lower[0].text == "-");
    others = others || ladder || (!triple && symbol.accent == Accent::hat && symbol.face == Face::plain);
  }
  return usual && others;
}

bool names_letter(const SyntaxTree& syntax, SyntaxId id, const std::string& name) {
  return std::ranges::any_of(nodes_below(syntax, {id}), [&](SyntaxId each) {
    return syntax[each].kind == SyntaxKind::symbol && matrix_name(syntax.symbol(each)) == name;
  });
}

}  // namespace

bool is_matrix_letter(const WrittenSymbol& symbol, const Evidence& evidence) {
  const std::string name = matrix_name(symbol);
  const auto letter = evidence.matrices.find(name);
  const bool length = symbol.face == Face::plain && evidence.vectors.contains(name);
  return letter != evidence.matrices.end() && !letter->second.of_itself && !length;
}

bool holds_matrix_letter(const SyntaxTree& syntax, SyntaxId id, const Evidence& evidence) {
  return std::ranges::any_of(nodes_below(syntax, {id}), [&](SyntaxId each) {
    return written_shape(syntax, each).any() ||
           (syntax[each].kind == SyntaxKind::symbol && is_matrix_letter(syntax.symbol(each), evidence));
  });
}

bool may_be_a_matrix(const std::string& letter, const Evidence& evidence) {
  static constexpr std::array<std::string_view, 17> columns_and_maps{
      "u", "v", "w",     "x",     "y",        "z",     "p",    "q",    "f",
      "g", "h", "\\psi", "\\phi", "\\varphi", "\\chi", "\\xi", "\\eta"};
  if (evidence.numbers.contains(letter)) return false;
  const bool capital = is_capital_letter(letter[0]);
  if (!capital && evidence.entries.contains(letter)) return false;  // a capital can be a block of a matrix
  const bool greek_capital = letter.size() > 1 && letter[0] == '\\' && is_capital_letter(letter[1]);
  return capital || greek_capital || letter.starts_with("\\math") || letter.starts_with("\\hat") ||
         is_one_of(letter, columns_and_maps) || evidence.is_ordered(letter);
}

MatrixShape written_shape(const SyntaxTree& syntax, SyntaxId id) {
  const SyntaxNode& node = syntax[id];
  const bool table = node.kind == SyntaxKind::matrix ||
                     (node.kind == SyntaxKind::tuple && node.payload != 0 && !is_pair_in_brackets(node));
  if (!table) return {};
  const std::uint32_t rows = node.count / node.payload;
  if (node.count == 1 || rows > most_rows || node.payload > most_rows) return {};
  return {static_cast<std::uint8_t>(rows), static_cast<std::uint8_t>(node.payload)};
}

std::string matrix_name(const WrittenSymbol& symbol) {
  std::string name = letter_with_marks(symbol);
  if (symbol.face == Face::vector) name = "\\mathbf{" + name + "}";
  if (symbol.face == Face::tensor) name = "\\mathsf{" + name + "}";
  if (symbol.lower.empty()) return name;
  name += "_{";
  for (const WrittenIndex& index : symbol.lower) name += index.text + std::string(index.primes, '\'');
  return name + "}";
}

void see_matrices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                  Evidence& evidence) {
  see_triples(syntax, sides, written, evidence);
  see_numbers(syntax, sides, evidence);
  for (const SyntaxId side : sides) see_entries(syntax, side, evidence);
  const bool equal = std::ranges::all_of(
      written.relations, [](const WrittenRelation& relation) { return makes_equal(relation.kind); });
  if (!equal || sides.size() < 2 || is_beside_operators(syntax, sides, evidence)) return;
  const Shapes shapes(syntax, evidence);
  std::set<MatrixShape> found;
  bool itself = false;
  for (const SyntaxId side : sides) {
    const MatrixShape shape = shapes.of(side);
    if (syntax[side].kind != SyntaxKind::symbol && shape.any()) found.insert(shape);
    itself = itself || written_shape(syntax, side).any();
  }
  if (found.empty()) return;
  for (const SyntaxId side : sides) {
    if (syntax[side].kind != SyntaxKind::symbol || syntax.symbol(side).dots > 0) continue;
    const WrittenSymbol& symbol = syntax.symbol(side);
    // A bold column of three is a vector like any other.
    const bool vector = symbol.face == Face::vector && found == std::set{MatrixShape{3, 1}};
    const bool row = symbol.face == Face::vector && found == std::set{MatrixShape{1, 3}};
    if (!itself && is_indexed_member(symbol, evidence)) continue;
    // `ABC = i` says that a product is a multiple of the unit matrix.
    const bool number = may_be_imaginary_unit(symbol) || symbol.letter == "\\hbar" || symbol.letter == "\\pi";
    if (vector || row || symbol.face == Face::tensor || (number && !itself)) continue;
    MatrixLetter& letter = evidence.matrices[matrix_name(symbol)];
    letter.written = letter.written || itself;
    for (const SyntaxId other : sides) {
      letter.of_itself = letter.of_itself || (written_shape(syntax, other).any() &&
                                              names_letter(syntax, other, matrix_name(symbol)));
    }
    letter.shapes.insert(found.begin(), found.end());
    letter.set_there.emplace(syntax[side].span.file, syntax[side].span.begin);
  }
}

}  // namespace rigor
