// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: whole, as components, as lengths, with dots and after ∂.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "base/among.h"
#include "expr/print/latex_printer.h"
#include "expr/tree/path.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

/// Letters that mean something else when they stand alone.
bool has_own_meaning(const std::string& letter) {
  static constexpr std::string_view own[] = {"d", "e", "i", "j", "t", "\\pi", "\\delta", "\\Delta"};
  return is_one_of(letter, own);
}

bool is_greek(const std::string& letter) { return letter.size() > 1 && letter[0] == '\\'; }

std::string dotted(std::string letter, int dots) {
  static constexpr int most_over_one = 4;  // `\ddddot`
  while (dots > 0) {
    const int here = std::min(dots, most_over_one);
    letter = fmt::format("\\{}ot{{{}}}", std::string(static_cast<std::size_t>(here), 'd'), letter);
    dots -= here;
  }
  return letter;
}

}  // namespace

bool LatexPrinter::is_lettered(SymbolId base) const { return notation_.lettered.contains(base); }

bool LatexPrinter::is_any_lettered(ExprId id) const {
  const std::vector<SymbolId> symbols = symbols_in(tree_, id);
  return std::ranges::any_of(symbols,
                             [&](SymbolId symbol) { return is_lettered(base_of(tree_.symbols, symbol)); });
}

LatexName LatexPrinter::name_of(SymbolId base) const {
  const auto known = notation_.base.find(base);
  LatexName name = latex_name(known == notation_.base.end() ? tree_.symbols[base].name : known->second);
  static constexpr std::string_view epsilon = "\\epsilon";  // how every ε is read, whatever its spelling
  if (const auto at = name.letter.find(epsilon); at != std::string::npos)
    name.letter.replace(at, epsilon.size(), notation_.epsilon);
  return name;
}

std::string LatexPrinter::whole_letter(SymbolId base, const LatexName& name) const {
  if (const auto known = notation_.whole.find(base); known != notation_.whole.end()) return known->second;
  const Symbol& symbol = tree_.symbols[base];
  const std::string plain = without_face(name.letter);
  for (const std::string change : {"\\delta", "\\Delta"}) {  // \delta\mathbf{A}: a change of a vector
    if (symbol.rank != 1 || !plain.starts_with(change) || plain.size() == change.size()) continue;
    const auto rest = plain.find_first_not_of(' ', change.size());
    if (rest == change.size() && plain[rest] != '\\') break;
    return fmt::format("{}\\{}{{{}}}", change, plain[rest] == '\\' ? "boldsymbol" : "mathbf",
                       plain.substr(rest));
  }
  const bool hatted = name.letter.starts_with("\\hat") || name.letter.starts_with("\\vu");
  if (symbol.rank == 0 || symbol.rotation || hatted || has_face(name.letter)) return name.letter;
  const bool greek = is_greek(name.letter);
  if (symbol.rank == 1) return fmt::format("\\{}{{{}}}", greek ? "boldsymbol" : "mathbf", name.letter);
  return fmt::format("\\{}{{{}}}", greek ? "overleftrightarrow" : "mathsf", name.letter);
}

/// `e_1` is the length of a basis vector, and `p_1` that of `\mathbf{p}_1`, if there is one.
bool LatexPrinter::names_another(SymbolId base, const LatexName& name, std::span<const Slot> slots) const {
  if (slots.size() != 1 || slots[0].axis == 0 || is_lettered(base)) return false;
  const std::string letter = without_face(name.letter);
  if (letter == "e") return true;
  const std::string digit = slot_text(slots[0], false);
  for (std::size_t k = 0; k < tree_.symbols.size(); ++k) {
    const auto other = static_cast<SymbolId>(k);
    if (tree_.symbols[other].rank != 1 || tree_.symbols[other].derivation) continue;
    const LatexName its = name_of(other);
    if (its.labels == digit && without_face(its.letter) == letter && its.primes == name.primes) return true;
  }
  return false;
}

/// The letter with its dots and subscripts; without slots the whole, or the length if the node is one.
LatexPrinter::Piece LatexPrinter::plain_symbol(SymbolId base, const ExprNode& node,
                                               std::span<const Slot> slots, int dots) const {
  const Symbol& symbol = tree_.symbols[base];
  if (symbol.ket || is_kronecker_of_states(symbol)) return {symbol.name};
  const LatexName name = name_of(base);
  const bool whole = slots.empty() && node.op != Op::length;
  std::string particle;
  if (node.particle != no_particle) {
    const auto known = particle_letters_.find(static_cast<std::uint32_t>(node.particle));
    particle = known == particle_letters_.end() ? tree_.name(node.particle) : known->second;
  }
  std::string inside = name.labels;
  append_latex(inside, particle);
  const bool one_digit = name.labels.size() == 1 && name.labels[0] >= '1' && name.labels[0] <= '3';
  const bool label_runs_on = !slots.empty() && name.has_bare_label();
  const bool lettered = is_lettered(base) || label_runs_on;
  std::string letter =
      dotted(whole ? whole_letter(base, name) : without_face(name.letter), dots) + name.primes;
  if (!slots.empty() && symbol.axes[0] == space_time) {
    std::vector<Slot> none;
    return {dotted(name.letter, dots) + name.primes + event_indices(name.labels, slots, none, base)};
  }
  if (symbol.rank == 0) letter = dotted(name.letter, dots) + name.primes;
  if ((label_runs_on && !(one_digit && slots.size() == 1)) ||
      names_another(base, name, slots)) {  // (\mathbf{v}_{a})_i
    std::string indices;
    for (const Slot& slot : slots) append_latex(indices, slot_text(slot, is_lettered(base)));
    letter = dotted(whole_letter(base, name), dots) + name.primes;
    return {"(" + letter + subscript(inside) + name.behind + ")" + subscript(indices)};
  }
  for (const Slot& slot : slots) append_latex(inside, slot_text(slot, lettered));
  return {letter + subscript(inside) + name.behind};
}

/// `\frac{dx}{dt}`, and `\frac{d}{dt}\frac{\partial L}{\partial x}` of what is a derivative already.
LatexPrinter::Piece LatexPrinter::differentiated(Piece of, std::string above, const std::string& below) {
  if (of.text.starts_with("\\frac") || of.text.starts_with("\\left(") || of.text.starts_with('|'))
    return {fmt::format("\\frac{{{}}}{{{}}}{}", above, below, of.text), Level::factor, true};
  if (above.starts_with('\\') && of.text.front() != '\\') above += ' ';
  append_latex(above, of.text);
  return {fmt::format("\\frac{{{}}}{{{}}}", above, below), Level::factor};
}

LatexPrinter::Piece LatexPrinter::symbol(ExprId id) {
  const ExprNode& node = tree_[id];
  const Symbol& symbol = tree_.symbols[node.symbol];
  if (symbol.derivation) return derivative(id, symbol);
  // Cosines between axes that have no letter: \delta_{i'j}.
  if (symbol.rotation && symbol.name.ends_with('\'') && node.slot_count == 2) {
    const auto slots = tree_.slots(id);
    std::string first = slot_text(slots[0], false);
    if (!first.ends_with('\'')) first += '\'';
    append_latex(first, slot_text(slots[1], false));
    return {"\\delta" + subscript(first)};
  }
  return plain_symbol(node.symbol, node, tree_.slots(id), 0);
}

/// `\dot{\mathbf{r}}_\alpha`, `\partial_i A_j`, `\frac{\partial \mathbf{E}}{\partial t}`, and the rate in a
/// rotating frame, which the components are along.
LatexPrinter::Piece LatexPrinter::derivative(ExprId id, const Symbol& symbol) {
  const ExprNode& node = tree_[id];
  const auto slots = tree_.slots(id);
  const SymbolId base = symbol.derivation->base;
  const int rates = symbol.order(By::time);
  const int axes = symbol.order(By::space);
  const std::size_t own = slots.empty() ? 0 : slots.size() - static_cast<std::size_t>(axes);
  const bool field = notation_.fields.contains(base) || axes > 0;
  const bool in_frame = notation_.frame && slots.empty() && tree_.symbols[base].rank > 0;
  const bool letters = symbol.order() > rates + axes + symbol.order(By::small);
  const int dots = field || in_frame || letters || tree_.symbols[base].ket ? 0 : rates;
  Piece result = plain_symbol(base, node, slots.first(own), dots);
  if (symbol.order(By::small) > 0) {
    result.text = std::string(symbol.name);
    return result;
  }
  if (letters) result = by_letters(std::move(result), *symbol.derivation);
  if (rates > 0 && dots == 0) {
    const std::string order = rates == 1 ? "" : "^" + std::to_string(rates);
    const char* sign = field ? "\\partial" : "d";
    std::string below = sign;
    append_latex(below, (field ? " t" : "t") + order);
    result = differentiated(std::move(result), sign + order, below);
    if (in_frame)
      result = {fmt::format("\\left({}\\right)_{{\\text{{{}}}}}", result.text, notation_.frame->rotating)};
  }
  if (axes > 0 && slots.empty()) {
    for (int k = 0; k < axes; ++k) {
      std::string text = "\\nabla";
      append_latex(text, result.text);
      result = {text, Level::term, true};
    }
    return result;
  }
  for (std::size_t k = own; k < slots.size(); ++k) {
    std::string text =
        "\\partial" + subscript(slot_text(slots[k], is_lettered(base) || notation_.lettered_axes));
    if (result.text.front() != '\\') text += ' ';
    append_latex(text, result.text);
    result = {text, Level::factor, true};
  }
  return result;
}

/// `\frac{d^2u}{d\theta^2}`, `\frac{\partial L}{\partial \dot{q}}`, `\left(\frac{\partial S}{\partial
/// T}\right)_V`.
LatexPrinter::Piece LatexPrinter::by_letters(Piece result, const Derivation& derivation) const {
  const auto name = [&](SymbolId id) {
    const ExprNode node{.op = Op::symbol, .symbol = id};
    return plain_symbol(base_of(tree_.symbols, id), node, {}, tree_.symbols[id].order(By::time)).text;
  };
  const auto end = derivation.by.end();
  for (auto each = derivation.by.begin(); each != end;
       each = std::upper_bound(each, end, *each, std::greater<>())) {
    if (each->by != By::letter) continue;
    if (is_along_path(tree_.symbols, *each)) {
      result.text.insert(0, "d");
      continue;
    }
    const auto count = derivation.by.count(*each);
    const std::string order = count == 1 ? "" : "^" + std::to_string(count);
    const char* sign = each->partial ? "\\partial" : "d";
    std::string below = sign;
    append_latex(below, name(each->letter));
    result = differentiated(std::move(result), sign + order, below + order);
    result.open = true;  // a bracket behind it could be where it is taken
    if (each->held) result = {fmt::format("\\left({}\\right)_{{{}}}", result.text, name(*each->held))};
  }
  return result;
}

/// May the length of the vector be written as its plain letter?
bool LatexPrinter::length_is_plain(ExprId id) const {
  const ExprNode& node = tree_[id];
  if (node.op != Op::symbol || node.rank != 1 || tree_.symbols[node.symbol].derivation) return false;
  const Symbol& vector = tree_.symbols[node.symbol];
  if (vector.complex) return false;  // of a complex vector it can be a number of its own
  const LatexName name = name_of(node.symbol);
  const auto particle = particle_letters_.find(static_cast<std::uint32_t>(node.particle));
  const bool in_body =
      node.particle != no_particle && particle != particle_letters_.end() && particle->second.empty();
  const bool bold = (has_face(name.letter) || notation_.base.contains(node.symbol) || in_body) &&
                    !name.letter.starts_with("\\hat");
  const std::string letter = without_face(name.letter);
  if (!bold || has_own_meaning(letter)) return false;
  const auto clashes = [&](SymbolId id_of_other) {
    const Symbol& other = tree_.symbols[id_of_other];
    if (other.derivation || other.per_particle != vector.per_particle) return false;
    const LatexName its = name_of(id_of_other);
    const bool same_letter = without_face(its.letter) == letter && its.primes == name.primes;
    if (other.rank == 0) return same_letter && its.labels == name.labels;
    return name.has_bare_label() && same_letter && other.rank == 1 && its.labels.empty();
  };
  for (std::size_t k = 0; k < tree_.symbols.size(); ++k) {
    if (clashes(static_cast<SymbolId>(k))) return false;
  }
  return true;
}

LatexPrinter::Piece LatexPrinter::basis(const Slot& slot) const {
  if (slot.axis != 0 && slot.axis <= notation_.axes.size() && !notation_.axes[slot.axis - 1u].empty())
    return {notation_.axes[slot.axis - 1u]};
  return {notation_.basis + subscript(slot_text(slot, notation_.lettered_axes))};
}

}  // namespace rigor
