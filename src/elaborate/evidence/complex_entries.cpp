// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/complex_entries.h"

#include <set>
#include <string>
#include <utility>

namespace rigor {
namespace {

/// The letter of `i`, `-i`, `\frac{i}{2}`, `i\sin\theta`: one that can be the unit, times numbers and sines
/// only.
std::string unit_of_entry(const SyntaxTree& syntax, SyntaxId entry) {
  std::string unit;
  for (const SyntaxId id : nodes_below(syntax, {entry})) {
    switch (syntax[id].kind) {
      case SyntaxKind::function:
        return unit;
      case SyntaxKind::number:
      case SyntaxKind::sum:
      case SyntaxKind::term:
      case SyntaxKind::fraction:
      case SyntaxKind::root:
      case SyntaxKind::group:
        break;
      case SyntaxKind::symbol:
        if (!unit.empty() || !may_be_imaginary_unit(syntax.symbol(id))) return {};
        unit = syntax.symbol(id).letter;
        break;
      default:
        return {};
    }
  }
  return unit;
}

bool is_negative(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::sum && syntax[id].count == 1 &&
         syntax.children(id)[0].joint == Joint::minus;
}

/// Of j, which can be a coupling in a symmetric matrix, its negative must face it.
void see_unit(const SyntaxTree& syntax, SyntaxId above, SyntaxId below, Evidence& evidence) {
  const std::string unit = unit_of_entry(syntax, above);
  if (unit.empty() || unit != unit_of_entry(syntax, below)) return;
  const bool sure =
      unit.find('i') != std::string::npos || is_negative(syntax, above) != is_negative(syntax, below);
  if (sure) evidence.imaginary_units.insert(unit);
}

/// Its letters and numbers in their order.
std::string spelled_entry(const SyntaxTree& syntax, SyntaxId root) {
  std::string text;
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (syntax[id].kind == SyntaxKind::symbol) text += letter_with_marks(syntax.symbol(id)) + ' ';
    if (syntax[id].kind == SyntaxKind::number) text += std::string(syntax.text(id)) + ' ';
  }
  return text;
}

/// i of `x - iy` that faces `x + iy`.
void see_unit_of_conjugates(const SyntaxTree& syntax, SyntaxId above, SyntaxId below, Evidence& evidence) {
  const auto is_sum_of_two = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::sum && syntax[id].count == 2;
  };
  if (!is_sum_of_two(above) || !is_sum_of_two(below)) return;
  const auto [real, imaginary] = std::pair(syntax.children(above)[0], syntax.children(above)[1]);
  const auto [other_real, other] = std::pair(syntax.children(below)[0], syntax.children(below)[1]);
  const bool conjugates = real.joint == other_real.joint && imaginary.joint != other.joint &&
                          spelled_entry(syntax, real.id) == spelled_entry(syntax, other_real.id) &&
                          spelled_entry(syntax, imaginary.id) == spelled_entry(syntax, other.id);
  if (!conjugates) return;
  std::set<std::string> units;
  for (const SyntaxId id : nodes_below(syntax, {imaginary.id})) {
    if (syntax[id].kind == SyntaxKind::symbol && may_be_imaginary_unit(syntax.symbol(id)))
      units.insert(syntax.symbol(id).letter);
  }
  if (units.size() == 1) evidence.imaginary_units.insert(*units.begin());
}

/// The symbols below that are starred, or those that are not.
std::set<std::string> names_below(const SyntaxTree& syntax, SyntaxId root, bool starred) {
  std::set<std::string> names;
  const auto is_star = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::function && syntax.text(id) == "conjugate" &&
           syntax[syntax.child(id, 0)].kind == SyntaxKind::symbol;
  };
  std::set<SyntaxId> under_star;
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (is_star(id)) under_star.insert(syntax.child(id, 0));
    if (syntax[id].kind == SyntaxKind::symbol && under_star.contains(id) == starred)
      names.insert(complex_name(syntax.symbol(id)));
  }
  return names;
}

/// V^* that V faces across the diagonal is no label, nor are the other stars of that matrix; its entries are
/// numbers.
bool faces_its_conjugate(const SyntaxTree& syntax, SyntaxId above, SyntaxId below) {
  const std::set<std::string> plain = names_below(syntax, above, false);
  const std::set<std::string> starred = names_below(syntax, below, true);
  return plain.size() == 1 && plain == starred;
}

}  // namespace

void see_complex_entries(const SyntaxTree& syntax, SyntaxId table, Evidence& evidence) {
  const std::uint32_t columns = syntax[table].payload;
  if (syntax[table].kind != SyntaxKind::matrix || syntax[table].count != columns * columns) return;
  bool conjugates = false;
  for (std::uint32_t row = 0; row < columns; ++row) {
    for (std::uint32_t column = row + 1; column < columns; ++column) {
      const SyntaxId above = syntax.child(table, row * columns + column);
      const SyntaxId below = syntax.child(table, column * columns + row);
      see_unit(syntax, above, below, evidence);
      see_unit_of_conjugates(syntax, above, below, evidence);
      conjugates = conjugates || faces_its_conjugate(syntax, above, below) ||
                   faces_its_conjugate(syntax, below, above);
    }
  }
  if (!conjugates) return;
  evidence.complex_numbers.merge(names_below(syntax, table, true));
  for (const SyntaxId id : nodes_below(syntax, {table})) {  // operators would have daggers
    if (syntax[id].kind == SyntaxKind::symbol) evidence.plain_numbers.insert(matrix_name(syntax.symbol(id)));
  }
}

}  // namespace rigor
