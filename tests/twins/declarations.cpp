// SPDX-License-Identifier: GPL-3.0-or-later
#include "declarations.h"

#include <fmt/format.h>

#include <algorithm>

#include "elaborate/name/letters.h"
#include "latex/parse/parse.h"

namespace rigor::twins {
namespace {

bool is_axis(const WrittenSymbol& symbol) {
  return is_basis_family(symbol) || (symbol.accent == Accent::hat && axis_of_letter(symbol.letter) != 0);
}

/// The vector's name in a directive: `\mathbf{r}_\alpha`.
std::string name_of(const WrittenSymbol& symbol) {
  std::string name = fmt::format("\\boldsymbol{{{}}}", symbol.letter);
  if (symbol.accent == Accent::hat) name = fmt::format("\\hat{{{}}}", name);
  for (const WrittenIndex& index : symbol.lower) {
    if (index.form == IndexForm::greek) name += fmt::format("_{}", index.text);
  }
  return name;
}

/// The letters that stand for something by a definition: the left sides of those steps.
std::set<std::string> defined_letters(const std::vector<Step>& steps) {
  std::set<std::string> letters;
  for (const Step& step : steps) {
    if (step.verdict != Verdict::definition) continue;
    SourceMap sources;
    SyntaxTree syntax;
    const Span all{sources.add("left", step.left), 0, static_cast<std::uint32_t>(step.left.size())};
    const SyntaxId left = parse_side(lex(sources, all), all, syntax);
    if (syntax[left].kind == SyntaxKind::symbol) letters.insert(syntax.symbol(left).letter);
  }
  return letters;
}

/// The nodes of all displayed equations, those above before those below.
std::vector<SyntaxId> displayed_nodes(const Notes& notes) {
  std::vector<SyntaxId> nodes;
  for (const Event& event : notes.events) {
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains)
      nodes.insert(nodes.end(), chain.sides.begin(), chain.sides.end());
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    for (const SyntaxChild& child : notes.syntax.children(nodes[k])) nodes.push_back(child.id);
  }
  return nodes;
}

}  // namespace

/// A letter that is a number: plain, with no index and no axis.
bool is_scalar(const WrittenSymbol& symbol) {
  const bool bare = symbol.face == Face::plain && symbol.accent == Accent::none && symbol.primes == 0 &&
                    symbol.change.empty() && symbol.letter != "t" && symbol.letter != "e" &&
                    symbol.letter != "d" && axis_of_letter(symbol.letter) == 0;
  return bare && std::all_of(symbol.lower.begin(), symbol.lower.end(), [](const WrittenIndex& index) {
           return index.form == IndexForm::greek || (index.form == IndexForm::digit && index.text == "0");
         });
}

std::string scalar_name(const WrittenSymbol& symbol) {
  std::string name = symbol.letter;
  for (const WrittenIndex& index : symbol.lower) name += fmt::format("_{}", index.text);
  return name;
}

std::set<std::string> declarations(const Notes& notes, const std::vector<Step>& steps) {
  const std::set<std::string> defined = defined_letters(steps);
  std::set<std::string> declarations;
  std::set<std::string> other_faces;  // letters of vectors and tensors
  for (const SyntaxId id : displayed_nodes(notes)) {
    if (notes.syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = notes.syntax.symbol(id);
    if (!is_scalar(symbol)) other_faces.insert(symbol.letter);
  }
  for (const SyntaxId id : displayed_nodes(notes)) {
    if (notes.syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = notes.syntax.symbol(id);
    if (is_scalar(symbol) && !defined.contains(symbol.letter) && !other_faces.contains(symbol.letter))
      declarations.insert(fmt::format("scalar {}", scalar_name(symbol)));
  }
  for (const SyntaxId id : displayed_nodes(notes)) {
    if (notes.syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = notes.syntax.symbol(id);
    if (symbol.face != Face::vector || is_axis(symbol) || defined.contains(symbol.letter)) continue;
    const bool unit = symbol.accent == Accent::hat;
    declarations.insert(fmt::format("{}vector {}", unit ? "unit " : "", name_of(symbol)));
  }
  return declarations;
}

std::set<std::string> meant_for_all(const SourceMap& sources, const Notes& notes,
                                    const std::set<std::string>& declarations) {
  std::set<std::string> lines;
  const auto mean = [&](std::string_view symbol) { lines.insert(fmt::format("for all {}", symbol)); };
  for (const std::string_view declaration : declarations)
    mean(declaration.substr(declaration.rfind(' ') + 1));
  for (const Event& event : notes.events) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed == nullptr) continue;
    const DirectiveKind kind = placed->directive.kind;
    if (kind != DirectiveKind::vector && kind != DirectiveKind::scalar && kind != DirectiveKind::tensor)
      continue;
    for (const SyntaxId symbol : placed->directive.symbols) mean(sources.text(notes.syntax[symbol].span));
  }
  return lines;
}

}  // namespace rigor::twins
