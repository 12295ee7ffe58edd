// SPDX-License-Identifier: GPL-3.0-or-later
// Products: their factors in the order in which they are read, with the signs and brackets between them.
#include <algorithm>

#include "base/ascii.h"
#include "expr/print/latex_printer.h"
#include "expr/print/usual_letters.h"

namespace rigor {
namespace {

bool starts_with_digit(const std::string& text) { return !text.empty() && is_digit(text.front()); }

}  // namespace

/// Scalars are before vectors. A dot or cross product at the end needs no bracket.
std::vector<LatexPrinter::Operand> LatexPrinter::operands_of(ExprId id) const {
  std::vector<Operand> operands;
  const Op op = tree_[id].op;
  if (op == Op::dot || op == Op::cross) {
    operands.push_back({child(id, 0)});
    operands.push_back({child(id, 1), op == Op::dot ? Sign::dot : Sign::cross});
    return operands;
  }
  if (op != Op::multiply) return {{id}};
  for (const bool scalars : {true, false}) {
    for (const ExprId each : tree_.children(id)) {
      if ((tree_[each].rank == 0) == scalars) operands.push_back({each});
    }
  }
  const Op last = tree_[operands.back().id].op;
  if (operands.size() > 1 && (last == Op::dot || last == Op::cross)) {
    const ExprId product = operands.back().id;
    operands.pop_back();
    operands.push_back({child(product, 0)});
    operands.push_back({child(product, 1), last == Op::dot ? Sign::dot : Sign::cross});
  }
  return operands;
}

LatexPrinter::Piece LatexPrinter::term(ExprId id) {
  const std::vector<Operand> operands = operands_of(id);
  if (operands.size() == 1) return piece(operands[0].id);
  std::string text;
  Piece before;
  bool open = false;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const bool last = k + 1 == operands.size();
    const ExprId each = operands[k].id;
    const bool behind_number =
        k > 0 && (tree_[operands[k - 1].id].op == Op::number || is_unit(operands[k - 1].id));
    Piece next = is_unit(each) ? unit(each, behind_number) : piece(each);
    const bool fits = next.level >= Level::factor || (next.headed && last);
    if (!fits || (next.open && !last)) next = in_brackets(next);
    if (k > 0) join(text, operands[k - 1], operands[k], before, next);
    // Between a coefficient and a product of vectors stands a narrow blank.
    const bool product_follows = k > 0 && !last && operands[k].sign == Sign::side_by_side &&
                                 operands[k + 1].sign != Sign::side_by_side && tree_[each].rank > 0 &&
                                 tree_[operands[k - 1].id].rank == 0 && !text.ends_with("\\,") &&
                                 !next.bracketed;
    if (product_follows) text += "\\,";
    const bool closes = k > 0 && tree_[operands[k - 1].id].op == Op::conjugate &&
                        is_ket(child(operands[k - 1].id)) && is_ket(each);
    if (closes) {  // `\langle a|b\rangle`
      next.text.erase(0, 1);
      while (text.back() != '|') text.pop_back();
    }
    append_latex(text, next.text);
    open = next.open;
    before = std::move(next);
  }
  return {text, Level::term, open};
}

void LatexPrinter::join(std::string& text, const Operand& before, const Operand& next,
                        const Piece& before_piece, const Piece& next_piece) const {
  if (next.sign != Sign::side_by_side) {
    text += next.sign == Sign::dot ? "\\cdot" : "\\times";
    return;
  }
  const auto is_numbers = [&](ExprId id) {
    return tree_[id].op == Op::divide && tree_[child(id, 0)].op == Op::number &&
           tree_[child(id, 1)].op == Op::number;
  };
  const bool runs_on = starts_with_digit(next_piece.text) ||
                       (is_numbers(next.id) && tree_[before.id].op == Op::number) ||
                       reads_as_argument(before.id, next.id, next_piece);
  if (runs_on) {
    text += "\\cdot ";
  } else if (next_piece.text.starts_with("\\unit") || (is_unit(next.id) && !next_piece.bracketed)) {
    text += "\\,";
  } else if (!next_piece.bracketed && !next_piece.headed &&
             (before_piece.bracketed || tree_[before.id].op == Op::divide ||
              next_piece.text.front() == '|')) {
    text += "\\,";
  } else if (!next_piece.bracketed && next_piece.text.front() != '\\') {
    text += ' ';
  }
}

/// `f(x + y)` can be the value of a function, and `d x` a differential.
bool LatexPrinter::reads_as_argument(ExprId before, ExprId next, const Piece& next_piece) const {
  if (!is_plain_letter(before)) return false;
  ExprId named = before;
  while (tree_[named].op != Op::symbol) named = child(named);
  const Symbol& symbol = tree_.symbols[tree_[named].symbol];
  const LatexName name = name_of(base_of(tree_.symbols, tree_[named].symbol));
  if (name.letter == "d" && !symbol.declared && !next_piece.bracketed) return true;
  if (tree_[next].op == Op::tuple) return true;
  if (!next_piece.bracketed || is_usual_coefficient(without_face(name.letter))) return false;
  if (symbol.declared && symbol.rank == 0 && name.labels.empty()) return false;
  bool coordinate = false;
  std::vector<ExprId> open{next};
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    const ExprNode& node = tree_[id];
    const bool indexed =
        std::ranges::any_of(tree_.slots(id), [](const Slot& slot) { return slot.axis == 0; });
    const bool vector = node.op == Op::basis || (node.op == Op::symbol && node.rank > 0);
    if (indexed || vector || node.op == Op::delta) return false;
    const bool plain = node.op == Op::length && length_is_plain(child(id));
    if (plain || node.op == Op::symbol) {
      const SymbolId inside = tree_[plain ? child(id) : id].symbol;
      coordinate =
          coordinate || is_usual_coordinate(without_face(name_of(base_of(tree_.symbols, inside)).letter));
      continue;
    }
    for (const ExprId each : tree_.children(id)) open.push_back(each);
  }
  return coordinate;
}

bool LatexPrinter::is_ket(ExprId id) const {
  return tree_[id].op == Op::symbol && tree_.symbols[tree_[id].symbol].ket &&
         !tree_.symbols[tree_[id].symbol].derivation;
}

/// One letter with its scripts, no face: `a`, `A_i`, `S_{ii}`.
bool LatexPrinter::is_plain_letter(ExprId id) const {
  while (tree_[id].op == Op::index_sum || (tree_[id].op == Op::power && tree_[id].exponent == 1))
    id = child(id);
  if (tree_[id].op == Op::length) return length_is_plain(child(id));
  return tree_[id].op == Op::symbol && tree_[id].rank == 0 &&
         !tree_.symbols[tree_[id].symbol].unit_of_measure;
}

bool LatexPrinter::is_unit(ExprId id) const {
  if (tree_[id].op == Op::power) id = child(id);
  if (tree_[id].op == Op::symbol) return tree_.symbols[tree_[id].symbol].unit_of_measure.has_value();
  if (tree_[id].op != Op::multiply) return false;
  return std::ranges::all_of(tree_.children(id), [&](ExprId each) { return is_unit(each); });
}

/// `\mathrm{m}^2` after a number, `\unit{m}^2` elsewhere; the factors of a unit stand side by side.
LatexPrinter::Piece LatexPrinter::unit(ExprId id, bool behind_number) {
  if (tree_[id].op == Op::multiply) {
    std::string text;
    for (const ExprId each : tree_.children(id)) {
      if (!text.empty()) text += "\\,";
      text += unit(each, behind_number || !text.empty()).text;
    }
    return {text, Level::factor};
  }
  const bool raised = tree_[id].op == Op::power;
  std::string name = tree_.symbols[tree_[raised ? child(id) : id].symbol].name;
  if (!behind_number && name.starts_with("\\mathrm")) name.replace(0, 7, "\\unit");
  if (raised) name += "^{" + std::to_string(tree_[id].exponent) + "}";
  return {name, Level::factor};
}

/// What the summation convention sums needs no sign.
LatexPrinter::Piece LatexPrinter::index_sum(ExprId id) {
  if (auto known = primed_component(id)) return std::move(*known);
  std::vector<IndexId> indices;
  ExprId body = id;
  for (; tree_[body].op == Op::index_sum; body = child(body)) indices.push_back(tree_[body].index);
  std::vector<std::pair<std::uint32_t, std::optional<std::string>>> outer;
  std::string explicit_letters;
  for (const IndexId index : indices) {
    const auto key = static_cast<std::uint32_t>(index);
    const auto known = letters_.find(key);
    outer.emplace_back(key, known == letters_.end() ? std::nullopt : std::optional(known->second));
    if (known != letters_.end()) letters_.erase(known);
    letters_[key] = free_letter(tree_.name(index), false);
    if (!notation_.every_sum && is_implied(body, index)) continue;
    if (!explicit_letters.empty()) explicit_letters += ',';
    append_latex(explicit_letters, letters_[key]);
  }
  Piece result;
  if (explicit_letters.empty()) {
    result = piece(body);
  } else {
    const Piece summand = at_least(Level::term, body);
    std::string text = "\\sum" + subscript(explicit_letters);
    if (summand.text.front() != '\\' && !summand.bracketed) text += ' ';
    append_latex(text, summand.text);
    result = {text, Level::term, true, false, true};
  }
  for (auto entry = outer.rbegin(); entry != outer.rend(); ++entry) {
    letters_.erase(entry->first);
    if (entry->second) letters_[entry->first] = *entry->second;
  }
  return result;
}

LatexPrinter::Piece LatexPrinter::particle_sum(ExprId id) {
  if (auto known = integral(id)) return std::move(*known);
  const auto key = static_cast<std::uint32_t>(tree_[id].particle);
  const std::string& name = tree_.name(tree_[id].particle);
  const std::string letter = free_letter(name == "∫" ? "\\alpha" : name, true);
  particle_letters_[key] = letter;
  const Piece summand = at_least(Level::term, child(id));
  particle_letters_.erase(key);
  std::string text = "\\sum" + subscript(letter);
  if (summand.text.front() != '\\' && !summand.bracketed) text += ' ';
  append_latex(text, summand.text);
  return {text, Level::term, true, false, true};
}

/// An integral over the body is a sum over its points, with the mass or the volume as the last factor.
std::optional<LatexPrinter::Piece> LatexPrinter::integral(ExprId id) {
  const ParticleId point = tree_[id].particle;
  if (tree_.name(point) != "∫" || tree_[child(id)].op != Op::multiply) return std::nullopt;
  const auto factors = tree_.children(child(id));
  if (factors.size() != 2 || tree_[factors[1]].op != Op::symbol) return std::nullopt;
  const std::string& measure = tree_.symbols[tree_[factors[1]].symbol].name;
  if (measure != "m" && measure != "V") return std::nullopt;
  const auto key = static_cast<std::uint32_t>(point);
  particle_letters_[key] = "";
  const Piece inside = at_least(Level::term, factors[0]);
  particle_letters_.erase(key);
  std::string text = "\\int";
  if (inside.text.front() != '\\' && !inside.bracketed) text += ' ';
  append_latex(text, inside.text);
  return Piece{text + "\\,d" + measure, Level::term, true, false, true};
}

}  // namespace rigor
