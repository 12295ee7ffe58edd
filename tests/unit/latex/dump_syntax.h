// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of reading share: a stretch of mathematics with its macros expanded; chains as one line
// each; the syntax tree as an S-expression: `\mathbf A\times B_i` is `(term vector:A ×B[i])`, `a - b` is
// `(sum +a -b)`, `\frac{d}{dt}\delta\dot x` is `(d/dt \delta.dot:x)`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "latex/macro/macros.h"
#include "latex/parse/parse.h"
#include "latex/split/rows.h"
#include "latex/split/split.h"
#include "latex/token/tokens.h"

namespace rigor {

/// A text as the passes behind macro expansion see it. Tokens are views into the sources, so it stays where
/// it is.
struct Stretch {
  SourceMap sources;
  MacroTable macros;
  Diagnostics diagnostics;
  Tokens tokens;
  TokenUses uses{0};  // nobody counts

  explicit Stretch(std::string text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    const FileId file = sources.add("notes.tex", std::move(text));
    tokens = expand(lex(sources, {file, 0, size}), macros, diagnostics).value_or(Tokens{});
  }
  Stretch(const Stretch&) = delete;
  Stretch& operator=(const Stretch&) = delete;

  /// The one cell of the one row, with `\left` and `\right` worked in.
  [[nodiscard]] Tokens side() { return read_rows(tokens, diagnostics, uses).front().cells.front(); }
  [[nodiscard]] std::string written(Span span) const { return std::string(sources.text(span)); }
  /// `3 unbalanced`: the column and the kind of each diagnostic, with commas between.
  [[nodiscard]] std::string complaints() const {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
      const LineColumn place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
      text += text.empty() ? "" : ", ";
      text += std::to_string(place.column) + " " + std::string(info(diagnostic.kind).name);
    }
    return text;
  }
};

/// `a = b = c`, then its tag and label in brackets, then `?` and the kind of what stands beside it and is not
/// read; `!no-sum` and `!cyclic` where words say so; `~restricted`, and `<=` behind an arrow.
[[nodiscard]] inline std::string dump_chain(const WrittenChain& chain) {
  std::string text;
  for (std::size_t k = 0; k < chain.sides.size(); ++k) {
    if (k > 0) text += ' ' + chain.relations[k - 1].text + ' ';
    text += text_of(chain.sides[k].tokens);
  }
  for (const std::string& name : {chain.tag, chain.label}) text += name.empty() ? "" : " [" + name + "]";
  if (chain.no_sum) text += " !no-sum";
  if (chain.cyclic) text += " !cyclic";
  if (chain.doubt && !chain.alternative) text += " ~restricted";
  if (chain.inference == Inference::conclusion) text += " <=";
  if (chain.inference == Inference::equivalence) text += " <=>";
  if (chain.explains) text += " :explains";
  return chain.condition ? text + " ?" + std::string(info(chain.condition->kind).name) : text;
}

/// One chain after the other, with ` // ` between.
[[nodiscard]] inline std::string dump_chains(const std::vector<WrittenChain>& chains) {
  std::string text;
  for (const WrittenChain& chain : chains) text += (text.empty() ? "" : " // ") + dump_chain(chain);
  return text;
}

[[nodiscard]] inline std::string dump_indices(const std::vector<WrittenIndex>& indices) {
  std::string text;
  for (const WrittenIndex& index : indices) {
    text += text.empty() ? '[' : ',';
    text += index.form == IndexForm::word ? '"' + index.text + '"' : index.text;
    text += std::string(index.primes, '\'');
  }
  return text.empty() ? text : text + ']';
}

[[nodiscard]] inline std::string dump_symbol(const WrittenSymbol& symbol) {
  static constexpr const char* faces[] = {"", "vector:", "tensor:"};
  static constexpr const char* accents[] = {"", "hat:", "bar:", "tilde:"};
  const std::string dots = symbol.dots == 0 ? "" : std::string(symbol.dots, 'd').substr(1) + "dot:";
  return (symbol.change.empty() ? "" : symbol.change + '.') + faces[static_cast<int>(symbol.face)] +
         std::string(accents[static_cast<int>(symbol.accent)]) + dots + symbol.letter +
         std::string(symbol.primes, '\'') + dump_indices(symbol.lower);
}

/// `d/dt`, `∂/∂x[i]^2`.
[[nodiscard]] inline std::string dump_derivative(const WrittenDerivative& derivative) {
  const std::string sign = derivative.partial ? "∂" : "d";
  std::string text = sign + '/';
  for (const WrittenVariable& variable : derivative.by) {
    text += sign + dump_symbol(variable.symbol);
    if (variable.times > 1) text += '^' + std::to_string(variable.times);
  }
  return text;
}

/// What stands for a node that is no leaf, before its children.
[[nodiscard]] inline std::string head_of(const SyntaxTree& tree, SyntaxId id) {
  static constexpr const char* heads[] = {
      "number",     "symbol",   "sum",      "term",     "fraction", "root",        "power", "component",
      "group",      "bars",     "norm",     "tuple",    "matrix",   "determinant", "sum",   "cases",
      "derivative", "function", "integral", "integral", "between",  "text",        "opaque"};
  std::string head = heads[static_cast<int>(tree[id].kind)];
  if (tree[id].kind == SyntaxKind::component) head += dump_indices(tree.indices(id));
  if (tree[id].kind == SyntaxKind::derivative) return dump_derivative(tree.derivative(id));
  if (tree[id].kind == SyntaxKind::function) return tree.text(id);
  if (tree[id].kind == SyntaxKind::integral) return head + " d" + tree.text(id);
  if (tree[id].kind != SyntaxKind::big_sum) return head;
  const WrittenSum& sum = tree.big_sum(id);
  head += " over " + dump_indices(sum.indices);
  if (!sum.from.empty()) head += " from " + sum.from;
  return sum.to.empty() ? head : head + " to " + sum.to;
}

[[nodiscard]] inline std::string dump_syntax(const SyntaxTree& tree, SyntaxId id) {
  static constexpr const char* joints[] = {"", "+", "-", "", "·", "×", "/", "", "[", "{"};
  const SyntaxKind kind = tree[id].kind;
  if (kind == SyntaxKind::number) return tree.text(id);
  if (kind == SyntaxKind::unit) return '<' + tree.text(id) + '>';
  if (kind == SyntaxKind::text) return '"' + tree.text(id) + '"';
  if (kind == SyntaxKind::symbol) return dump_symbol(tree.symbol(id));
  if (kind == SyntaxKind::opaque) return '<' + std::string(info(tree.obstacle(id).kind).name) + '>';
  std::string text = '(' + head_of(tree, id);
  for (const SyntaxChild& child : tree.children(id)) {
    text += ' ';
    text += joints[static_cast<int>(child.joint)];
    text += dump_syntax(tree, child.id);
  }
  return text + ')';
}

}  // namespace rigor
