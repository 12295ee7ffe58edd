// SPDX-License-Identifier: GPL-3.0-or-later
// Sums, quotients, powers, brackets and what is in them.
#include "expr/print/latex_printer.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"

namespace rigor {
namespace {

/// Is it higher than a line, so that its brackets must grow?
bool is_tall(const std::string& text) {
  static constexpr std::string_view tall[] = {"\\frac",  "\\tfrac", "\\sum", "\\int",
                                              "\\begin", "\\left",  "\\sqrt"};
  return std::ranges::any_of(tall,
                             [&](std::string_view sign) { return text.find(sign) != std::string::npos; });
}

const char* sign_of(Function function) {
  switch (function) {
    case Function::sin:
      return "\\sin";
    case Function::cos:
      return "\\cos";
    case Function::exp:
      return "\\exp";
    case Function::log:
      return "\\ln";
    case Function::arcsin:
      return "\\arcsin";
    case Function::arccos:
      return "\\arccos";
    case Function::arctan:
      return "\\arctan";
  }
  return "";
}

std::string exponent_text(int exponent) {
  const std::string digits = std::to_string(exponent);
  return digits.size() == 1 ? "^" + digits : "^{" + digits + "}";
}

}  // namespace

std::string LatexPrinter::print(ExprId root) {
  name_free(root);
  // A side that is a whole tensor of space-time at its letters is read as the whole.
  const ExprNode& node = tree_[root];
  if (node.op == Op::component && tree_[child(root)].op == Op::tuple &&
      tree_[child(root)].axes[0] == space_time && !event_part(root))
    return text(child(root));
  return text(root);
}

LatexPrinter::Piece LatexPrinter::piece(ExprId id) {
  if (tree_.is_zero_literal(id)) return {"0"};
  if (auto known = event(id)) return std::move(*known);
  if (auto known = field(id)) return std::move(*known);
  const ExprNode& node = tree_[id];
  switch (node.op) {
    case Op::number:
      return {tree_.digits(id)};
    case Op::symbol:
      return symbol(id);
    case Op::basis:
      return basis(tree_.slots(id)[0]);
    case Op::delta:
    case Op::epsilon: {
      std::string inside;
      for (const Slot& slot : tree_.slots(id)) append_latex(inside, slot_text(slot, notation_.lettered_axes));
      return {(node.op == Op::delta ? "\\delta" : notation_.epsilon) + subscript(inside)};
    }
    case Op::add:
    case Op::negate:
      return sum(id);
    case Op::multiply:
    case Op::dot:
    case Op::cross:
      return term(id);
    case Op::divide:
      return quotient(id);
    case Op::power:
      return power(id);
    case Op::real_power:
      return real_power(id);
    case Op::root:
      return {"\\sqrt{" + text(child(id)) + "}"};
    case Op::length:
      return length_is_plain(child(id))
                 ? plain_symbol(tree_[child(id)].symbol,
                                ExprNode{.op = Op::length, .particle = tree_[child(id)].particle}, {}, 0)
                 : bars(id);
    case Op::absolute:
      return bars(id);
    case Op::component:
      return component(id);
    case Op::tuple:
      return entries(id);
    case Op::determinant:
      return determinant(id);
    case Op::imaginary_unit:
      return {notation_.imaginary_unit};
    case Op::conjugate:
      if (is_ket(child(id))) {
        const std::string& ket = tree_.symbols[tree_[child(id)].symbol].name;
        return {"\\langle " + ket.substr(1, ket.size() - 8) + "|"};
      }
      return raised(id, has_operators(tree_, id) ? "^\\dagger" : "^*");
    case Op::real_part:
    case Op::imaginary_part: {
      const std::string name = node.op == Op::real_part ? "Re" : "Im";
      return {"\\operatorname{" + name + "}" + in_brackets(piece(child(id))).text, Level::factor};
    }
    case Op::transpose:
      return raised(id, "^{\\mathrm{T}}");
    case Op::trace:
      return {"\\operatorname{tr}" + in_brackets(piece(child(id))).text, Level::factor};
    case Op::matrix_determinant:
      return {"\\det" + in_brackets(piece(child(id))).text, Level::factor};
    case Op::index_sum:
      return index_sum(id);
    case Op::particle_sum:
      return particle_sum(id);
    case Op::function:
      return function(id, 1);
    case Op::table:
      return table(id);
  }
  return {};
}

LatexPrinter::Piece LatexPrinter::in_brackets(const Piece& inside) const {
  const bool tall = is_tall(inside.text);
  return {(tall ? "\\left(" : "(") + inside.text + (tall ? "\\right)" : ")"), Level::base, false, true};
}

LatexPrinter::Piece LatexPrinter::at_least(Level level, ExprId id) {
  Piece inside = piece(id);
  return inside.level >= level ? inside : in_brackets(inside);
}

LatexPrinter::Piece LatexPrinter::sum(ExprId id) {
  std::string text;
  const bool lone = tree_[id].op == Op::negate;
  const std::vector<ExprId> terms =
      lone ? std::vector<ExprId>{id}
           : std::vector<ExprId>(tree_.children(id).begin(), tree_.children(id).end());
  for (const ExprId each : terms) {
    const bool minus = tree_[each].op == Op::negate;
    if (!text.empty()) text += minus ? " - " : " + ";
    if (text.empty() && minus) text += "-";
    text += at_least(Level::term, minus ? child(each) : each).text;
  }
  return {text, Level::sum};
}

/// η_00/|η_00|, the sign of the metric.
bool LatexPrinter::is_metric_sign(ExprId id) const {
  const ExprId above = child(id, 0);
  const ExprId below = child(id, 1);
  return tree_[above].op == Op::symbol && tree_[below].op == Op::absolute &&
         tree_[child(below)].op == Op::symbol && tree_[child(below)].symbol == tree_[above].symbol &&
         tree_.symbols[tree_[above].symbol].name.ends_with("_{00}");
}

LatexPrinter::Piece LatexPrinter::quotient(ExprId id) {
  if (is_metric_sign(id)) return piece(child(id, 0));
  const bool numbers = tree_[child(id, 0)].op == Op::number && tree_[child(id, 1)].op == Op::number;
  return {fmt::format("{}{{{}}}{{{}}}", numbers ? notation_.number_fraction : "\\frac", text(child(id, 0)),
                      text(child(id, 1))),
          Level::factor};
}

/// a^{3/2} is the third power of a root.
LatexPrinter::Piece LatexPrinter::power(ExprId id) {
  const int exponent = tree_[id].exponent;
  const ExprId base = child(id);
  if (exponent == 1) return piece(base);
  // `a^{0}` can mean the order of a term, not a power.
  if (exponent == 0) return {in_brackets(piece(base)).text + exponent_text(exponent), Level::factor};
  if (tree_[base].op == Op::function && tree_[base].function != Function::exp && exponent >= 0)
    return function(base, exponent);
  if (tree_[base].op == Op::root && exponent % 2 != 0) {
    const Piece radicand = piece(child(base));
    if (radicand.level == Level::base && !radicand.bracketed && radicand.text.find('^') == std::string::npos)
      return {fmt::format("{}^{{{}/2}}", radicand.text, exponent), Level::factor};
  }
  const Piece inside = at_least(Level::base, base);
  const bool labelled =
      tree_[base].op == Op::symbol && inside.text.find('^') != std::string::npos;  // `H^{(0)}`
  return {(labelled ? in_brackets(inside).text : inside.text) + exponent_text(exponent), Level::factor};
}

/// `x^{n - 1}`; what stands above is never a number alone, so that it is no order of a term.
LatexPrinter::Piece LatexPrinter::real_power(ExprId id) {
  const Piece base = at_least(Level::base, child(id, 0));
  const bool raised = base.text.find('^') != std::string::npos;
  return {(raised ? in_brackets(base).text : base.text) + "^{" + text(child(id, 1)) + "}", Level::factor};
}

/// `\psi^*`, `(a + b)^*`
/// Its child with a mark above: `A^*`, `(AB)^*`.
LatexPrinter::Piece LatexPrinter::raised(ExprId id, const char* mark) {
  const Piece inside = at_least(Level::base, child(id));
  const bool raised = inside.text.find('^') != std::string::npos && !inside.bracketed;
  return {(raised ? in_brackets(inside).text : inside.text) + mark, Level::factor};
}

bool LatexPrinter::has_letter_e() const {
  for (std::size_t k = 0; k < tree_.symbols.size(); ++k) {
    const Symbol& symbol = tree_.symbols[static_cast<SymbolId>(k)];
    if (symbol.rank == 0 && symbol.name == "e") return true;
  }
  return false;
}

/// Arguments are in brackets, but for a lone letter.
LatexPrinter::Piece LatexPrinter::function(ExprId id, int exponent) {
  const ExprNode& node = tree_[id];
  const ExprId argument = child(id);
  const std::string raised = exponent == 1 ? "" : exponent_text(exponent);
  const std::string inside_braces = text(argument);
  // `e^{2}` is a power of a letter e.
  const bool digits = inside_braces.find_first_not_of("-0123456789") == std::string::npos;
  if (node.function == Function::exp && exponent == 1 && !digits && !has_letter_e())
    return {"e^{" + inside_braces + "}", Level::factor};
  std::string result = sign_of(node.function) + raised;
  const Piece inside = piece(argument);
  if (is_plain_letter(argument) && inside.level == Level::base) {
    append_latex(result, inside.text);
    return {result, Level::factor, true};
  }
  return {result + in_brackets(inside).text, Level::factor};
}

/// A bar after an operand closes, so that bars inside others need signs that say what they are.
LatexPrinter::Piece LatexPrinter::bars(ExprId id) {
  ++bars_;
  const std::string inside = text(child(id));
  --bars_;
  if (bars_ > 0) {
    std::string sized = "\\lvert";
    append_latex(sized, inside);
    return {sized + "\\rvert"};
  }
  const bool tall = is_tall(inside);
  return {(tall ? "\\left|" : "|") + inside + (tall ? "\\right|" : "|")};
}

LatexPrinter::Piece LatexPrinter::component(ExprId id) {
  if (tree_.is_zero_literal(child(id))) return {"0"};
  std::string inside;
  for (const Slot& slot : tree_.slots(id)) append_latex(inside, slot_text(slot, is_any_lettered(child(id))));
  const Piece base = piece(child(id));
  const bool brackets = tree_[child(id)].op != Op::tuple || base.text.front() != '(';
  return {(brackets ? in_brackets(base).text : base.text) + subscript(inside)};
}

/// A triple, or the rows of a matrix.
LatexPrinter::Piece LatexPrinter::entries(ExprId id) {
  std::string result;
  const bool rows = tree_[id].rank > 1;
  for (const ExprId row : tree_.children(id)) {
    if (!rows) {
      result += (result.empty() ? "" : ", ") + text(row);
      continue;
    }
    if (!result.empty()) result += " \\\\ ";
    std::string cells;
    if (tree_[row].op != Op::tuple) cells = text(row);
    for (const ExprId cell : tree_.children(row)) {
      if (tree_[row].op == Op::tuple) cells += (cells.empty() ? "" : " & ") + text(cell);
    }
    result += cells;
  }
  if (rows) return {"\\begin{pmatrix} " + result + " \\end{pmatrix}"};
  return in_brackets({result});
}

LatexPrinter::Piece LatexPrinter::determinant(ExprId id) {
  if (auto tensor = whole_tensor(id)) {
    std::string result = "\\det";
    append_latex(result, *tensor);
    return {result, Level::factor};
  }
  std::string result;
  for (std::size_t k = 0; k < 9; ++k) {
    if (k > 0) result += k % 3 == 0 ? " \\\\ " : " & ";
    result += text(child(id, k));
  }
  return {"\\begin{vmatrix} " + result + " \\end{vmatrix}"};
}

/// For which values of the letters the table has its value: 123 or cyclic permutations.
std::string LatexPrinter::condition(ExprId id, std::size_t value,
                                    const std::vector<std::string>& letters) const {
  const std::vector<std::uint8_t>& entry = tree_.table(id).entry;
  std::vector<std::string> tuples;
  bool diagonal = letters.size() == 2;
  bool beside = diagonal;
  for (std::size_t at = 0; at < entry.size(); ++at) {
    const bool holds = entry[at] == value;
    std::string tuple;
    for (std::size_t rest = at, k = 0; k < letters.size(); ++k, rest /= 3)
      tuple.insert(0, std::to_string(rest % 3 + 1));
    if (diagonal || beside) {
      diagonal = diagonal && holds == (tuple[0] == tuple[1]);
      beside = beside && holds == (tuple[0] != tuple[1]);
    }
    if (holds) tuples.push_back(tuple);
  }
  if (diagonal) return letters[0] + " = " + letters[1];
  if (beside) return letters[0] + " \\ne " + letters[1];
  std::string all;
  for (const std::string& letter : letters) append_latex(all, letter);
  const auto rotated = [](std::string tuple) {
    std::rotate(tuple.begin(), tuple.begin() + 1, tuple.end());
    return tuple;
  };
  const auto has = [&](const std::string& tuple) { return is_one_of(tuple, tuples); };
  const bool cyclic = tuples.size() == 3 && has(rotated(tuples[0])) && has(rotated(rotated(tuples[0]))) &&
                      rotated(tuples[0]) != tuples[0];
  if (cyclic) return all + " = " + tuples[0] + " \\text{ or cyclic permutations}";
  return fmt::format("{} = {}", all, fmt::join(tuples, ", "));
}

LatexPrinter::Piece LatexPrinter::table(ExprId id) {
  std::vector<std::string> letters;
  for (const Slot& slot : tree_.slots(id)) letters.push_back(slot_text(slot, notation_.lettered_axes));
  const std::vector<std::uint8_t>& entry = tree_.table(id).entry;
  std::vector<std::size_t> used;
  for (std::size_t value = 0; value < tree_.children(id).size(); ++value) {
    if (is_one_of(value, entry)) used.push_back(value);
  }
  std::string rows;
  for (const std::size_t value : used) {
    const std::string when = value == used.back() && used.size() > 1 && letters.size() != 2
                                 ? "\\text{otherwise}"
                                 : condition(id, value, letters);
    rows += (rows.empty() ? "" : " \\\\ ") + text(child(id, value)) + " & " + when;
  }
  return {"\\begin{cases} " + rows + " \\end{cases}"};
}

}  // namespace rigor
