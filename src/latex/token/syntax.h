// SPDX-License-Identifier: GPL-3.0-or-later
// What was WRITTEN: a syntax tree of one file's expressions. It knows signs, scripts and brackets, not what
// they mean: whether `r_{\alpha i}` is a component of a particle's vector is decided one floor up. Nodes lie
// in one vector, children before parents; every node has the span that its author typed.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/span.h"
#include "source/diagnostic.h"

namespace rigor {

enum class SyntaxId : std::uint32_t {};

enum class SyntaxKind : std::uint8_t {
  number,     // 2, 0.25
  symbol,     // a decorated letter with its scripts
  sum,        // a + b - c: children joined by plus or minus (the first one too)
  term,       // a b · c × d / e: children joined by what comes before each
  fraction,   // \frac{a}{b}
  root,       // \sqrt{a}
  power,      // base, exponent
  component,  // (…)_{ij}: one child, lower indices
  group,      // (…), […], {…} with visible brackets
  bars,       // |…|
  norm,       // ‖…‖
  tuple,      // (a, b, c), a column or a row: the entries
  matrix,     // entries row by row, `columns` of them in a row
  determinant,
  big_sum,     // \sum_{…}^{…}: what is added, and both limits where one is more than digits
  cases,       // value, condition, value, condition…
  derivative,  // d/dt, ∂/∂x, ∂_i of one child (see WrittenDerivative); `\dot x` is a symbol with dots
  function,    // \cos, \exp, grad…: `text` is the name, one child is the argument (two of them: a tuple);
             // `conjugate` for z^*, `bar` for \overline{z + w}, `transpose` and `adjoint` for A^T and A^†,
             // `average` for \langle x\rangle; `ket` and `bra`, whose child is their name as `text`
  integral,  // over the body: `text` is the measure (`m` for dm, `V` for dV or d^3r), the first child what
             // is integrated, the second the name of the region if it has one, as `text`
  line_integral,  // over one variable: what is integrated, the variable, and two limits if they are written
  between,        // [F]_a^b: F, two limits, and the variable if `x = a` names it
  unit,           // of measure: `text` is how it is written, `kg.m^2` (see units.h)
  text,           // \text{…}: words
  opaque,         // not read: `message` says why
};

/// The payload of a tuple of two in other brackets than round ones.
inline constexpr std::uint32_t in_square_brackets = 1000;
inline constexpr std::uint32_t in_braces = 1001;
inline constexpr std::uint32_t in_poisson_brackets = 1002;  // `\pb{f}{g}`

/// How a child is joined to what comes before it.
enum class Joint : std::uint8_t { none, plus, minus, juxtaposed, dot, cross, slash, comma };

enum class Face : std::uint8_t { plain, vector, tensor };  // italic; bold or arrow; double arrow
enum class Accent : std::uint8_t { none, hat, bar, tilde };

enum class IndexForm : std::uint8_t { letter, greek, digit, word };

struct WrittenIndex {
  std::string text;  // `i`, `\alpha`, `2`, `rot`; `^{(0)}`: a label above the letter, which is the first
  IndexForm form = IndexForm::letter;
  std::uint8_t primes = 0;
  Span span;
  bool raised = false;  // it stands above the letter: `\partial^\mu`
};

struct WrittenSymbol {
  std::string letter;  // `A`, `\omega` (`\varepsilon` is `\epsilon`), or a word such as `Re`
  Face face = Face::plain;
  Accent accent = Accent::none;
  std::uint8_t primes = 0;
  std::uint8_t dots = 0;  // \dot, \ddot: time derivatives
  std::string change =
      {};  // `\delta` or `\Delta` before the letter: `\delta\mathbf{A}` is one symbol, a change of A
  std::vector<WrittenIndex> lower = {};
  std::uint8_t raised_at = 0;  // of `lower`, how many are before what stands above: 1 for `F_\mu{}^\nu`
  Span letter_span = {};
};

struct WrittenSum {
  std::vector<WrittenIndex> indices;
  std::string from;  // `1` in \sum_{i=1}^{3}; empty: no bound was written
  std::string to;    // `3`, `N`, `\infty`
};

/// What is differentiated by, and how often: `t`, `x`; `\partial_i` is by `x_i`.
struct WrittenVariable {
  WrittenSymbol symbol;
  std::uint8_t times = 1;
};

struct WrittenDerivative {
  bool partial = false;
  std::vector<WrittenVariable> by;
};

struct SyntaxNode {
  SyntaxKind kind;
  Span span;
  std::uint32_t first = 0;    // into the list of children
  std::uint32_t count = 0;    // children
  std::uint32_t payload = 0;  // into symbols, sums, index lists or texts; the number of columns of a matrix
};

/// `[A, B]`, `\{A, B\}`, `\comm{A}{B}`.
[[nodiscard]] constexpr bool is_pair_in_brackets(const SyntaxNode& node) {
  return node.kind == SyntaxKind::tuple && node.count == 2 && node.payload >= in_square_brackets;
}

struct SyntaxChild {
  SyntaxId id;
  Joint joint = Joint::none;
  Span joint_span = {};
};

/// Why a part could not be read.
struct Obstacle {
  DiagnosticKind kind;
  std::string message;
  std::vector<std::string> help = {};
};

class SyntaxTree {
 public:
  SyntaxId add(SyntaxKind kind, Span span, std::span<const SyntaxChild> children = {},
               std::uint32_t payload = 0);
  SyntaxId add_symbol(Span span, WrittenSymbol symbol);
  SyntaxId add_component(Span span, SyntaxId base, std::vector<WrittenIndex> indices);
  SyntaxId add_big_sum(Span span, WrittenSum sum, SyntaxId body);
  SyntaxId add_big_sum(Span span, WrittenSum sum, std::span<const SyntaxChild> body_and_limits);
  SyntaxId add_derivative(Span span, WrittenDerivative derivative, SyntaxId operand);
  SyntaxId add_named(SyntaxKind kind, Span span, std::string name, SyntaxId child);  // function
  SyntaxId add_integral(Span span, std::string measure, SyntaxId body, const std::string& region);
  SyntaxId add_text(SyntaxKind kind, Span span, std::string text);  // number and text
  SyntaxId add_opaque(Span span, Obstacle obstacle);

  [[nodiscard]] const SyntaxNode& operator[](SyntaxId id) const {
    return nodes_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] std::span<const SyntaxChild> children(SyntaxId id) const;
  [[nodiscard]] SyntaxId child(SyntaxId id, std::size_t which) const { return children(id)[which].id; }
  [[nodiscard]] const WrittenSymbol& symbol(SyntaxId id) const;
  [[nodiscard]] const std::vector<WrittenIndex>& indices(SyntaxId id) const;  // of a component
  [[nodiscard]] const WrittenSum& big_sum(SyntaxId id) const;
  [[nodiscard]] const WrittenDerivative& derivative(SyntaxId id) const;
  [[nodiscard]] const std::string& text(SyntaxId id) const;  // of number, text, function, integral
  [[nodiscard]] const Obstacle& obstacle(SyntaxId id) const;
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  std::vector<SyntaxNode> nodes_;
  std::vector<SyntaxChild> children_;
  std::vector<WrittenSymbol> symbols_;
  std::vector<std::vector<WrittenIndex>> index_lists_;
  std::vector<WrittenSum> sums_;
  std::vector<WrittenDerivative> derivatives_;
  std::vector<std::string> texts_;
  std::vector<Obstacle> obstacles_;
};

/// Some roots and all that stands below them: each node before its children, and these from the left.
[[nodiscard]] std::vector<SyntaxId> nodes_below(const SyntaxTree& syntax, std::vector<SyntaxId> roots);

}  // namespace rigor
