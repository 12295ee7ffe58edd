// SPDX-License-Identifier: GPL-3.0-or-later
// A capital is a matrix of unknown size where the words say so, or a transpose, a trace or a determinant is
// taken of it. A small letter is a column where it is transposed, or where a matrix stands before it and the
// words speak of vectors. What is written out, has two indices or is a number is neither.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "elaborate/evidence/evidence.h"
#include "elaborate/evidence/said_pieces.h"

namespace rigor {
namespace {

bool is_one_of_functions(const SyntaxTree& syntax, SyntaxId id,
                         std::initializer_list<std::string_view> names) {
  if (syntax[id].kind != SyntaxKind::function) return false;
  return std::ranges::find(names, std::string_view(syntax.text(id))) != names.end();
}

std::string labelled_name(const WrittenSymbol& symbol) {
  const std::string letter = letter_with_marks(symbol);
  const std::string named = with_labels(letter, symbol.lower);
  return symbol.face == Face::vector ? "\\mathbf{" + named + "}" : named;
}

bool is_capital(const WrittenSymbol& symbol) {
  return symbol.face != Face::tensor && symbol.letter.size() == 1 && is_capital_letter(symbol.letter[0]);
}

/// A small Latin letter, or a bold one.
bool may_be_column(const WrittenSymbol& symbol) {
  const bool small = symbol.letter.size() == 1 && symbol.letter[0] >= 'a' && symbol.letter[0] <= 'z';
  return symbol.accent == Accent::none && symbol.dots == 0 && symbol.change.empty() &&
         ((symbol.face == Face::plain && small && symbol.letter != "t") ||
          (symbol.face == Face::vector && !is_capital(symbol)));
}

/// The letters of a product, a sum or a power, outside of traces and determinants.
void add_capitals(const SyntaxTree& syntax, SyntaxId id, UnsizedMatrices& found) {
  const SyntaxNode& node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      const WrittenSymbol& symbol = syntax.symbol(id);
      if (is_capital(symbol)) found.shown.insert(labelled_name(symbol));
      return;
    }
    case SyntaxKind::power:
      return add_capitals(syntax, syntax.child(id, 0), found);
    case SyntaxKind::function:
      if (is_one_of_functions(syntax, id, {"transpose"})) add_capitals(syntax, syntax.child(id, 0), found);
      return;
    case SyntaxKind::group:
    case SyntaxKind::sum:
    case SyntaxKind::term:
      for (const SyntaxChild& child : syntax.children(id)) {
        if (child.joint != Joint::slash) add_capitals(syntax, child.id, found);
      }
      return;
    default:
      return;
  }
}

/// The capital that a factor is, or a power or transpose of it.
std::optional<std::string> capital_of(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::power || is_one_of_functions(syntax, id, {"transpose"}))
    id = syntax.child(id, 0);
  if (syntax[id].kind != SyntaxKind::symbol || !is_capital(syntax.symbol(id))) return std::nullopt;
  return labelled_name(syntax.symbol(id));
}

std::optional<std::string> column_at_end(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind == SyntaxKind::sum) id = syntax.child(id, 0);
  if (syntax[id].kind == SyntaxKind::term) id = syntax.children(id).back().id;
  if (syntax[id].kind != SyntaxKind::symbol || !may_be_column(syntax.symbol(id))) return std::nullopt;
  return labelled_name(syntax.symbol(id));
}

/// The symbols of a vector product or a product with a dot.
void see_dotted(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, UnsizedMatrices& found) {
  for (std::size_t k = 1; k < factors.size(); ++k) {
    if (factors[k].joint != Joint::dot && factors[k].joint != Joint::cross) continue;
    for (const SyntaxId id : {factors[k - 1].id, factors[k].id}) {
      if (syntax[id].kind == SyntaxKind::symbol) found.dotted.insert(labelled_name(syntax.symbol(id)));
    }
  }
}

/// `Ax`, `x^Ty`: the last factor, and what stands before it.
void see_term(const SyntaxTree& syntax, SyntaxId id, UnsizedMatrices& found) {
  const auto factors = syntax.children(id);
  see_dotted(syntax, factors, found);
  if (factors.size() < 2 || factors.back().joint != Joint::juxtaposed) return;
  const auto column = column_at_end(syntax, factors.back().id);
  const SyntaxId before = factors[factors.size() - 2].id;
  if (!column) return;
  if (is_one_of_functions(syntax, before, {"transpose"})) {
    found.acted_on[*column].insert("");
  } else if (const auto matrix = capital_of(syntax, before)) {
    found.acted_on[*column].insert(*matrix);
  }
}

/// `P = AB`: the capitals of the other sides, unless these may be numbers, as `x^TAx` is.
void see_made_of(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, SyntaxId alone,
                 UnsizedMatrices& found) {
  UnsizedMatrices inside;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol && may_be_column(syntax.symbol(id))) return;
  }
  for (const SyntaxId side : sides) {
    if (side != alone) add_capitals(syntax, side, inside);
  }
  found.made_of[labelled_name(syntax.symbol(alone))].insert(inside.shown.begin(), inside.shown.end());
}

bool is_letter_i(const SyntaxTree& syntax, SyntaxId id) {
  if (syntax[id].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = syntax.symbol(id);
  return symbol.letter == "I" && symbol.lower.empty() && symbol.accent == Accent::none && symbol.dots == 0 &&
         symbol.primes == 0;
}

bool has_capital(const SyntaxTree& syntax, SyntaxId root) {
  return std::ranges::any_of(nodes_below(syntax, {root}), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol && is_capital(syntax.symbol(id)) && !is_letter_i(syntax, id);
  });
}

/// Does I stand where the unit matrix does: alone in a sum or a side, or behind numbers? Counts both kinds of
/// places.
void see_letter_i(const SyntaxTree& syntax, SyntaxId id, bool fits, UnsizedMatrices& found) {
  if (is_letter_i(syntax, id)) {
    ++(fits ? found.units : found.no_units);
    return;
  }
  const SyntaxKind kind = syntax[id].kind;
  const auto children = syntax.children(id);
  const bool sum = kind == SyntaxKind::sum || kind == SyntaxKind::group || kind == SyntaxKind::function;
  for (std::size_t k = 0; k < children.size(); ++k) {
    bool unit = sum;
    if (kind == SyntaxKind::term) {
      unit = k + 1 == children.size() && (k > 0 || fits);
      for (std::size_t other = 0; other < k; ++other) unit = unit && !has_capital(syntax, children[other].id);
    }
    see_letter_i(syntax, children[k].id, unit, found);
  }
}

constexpr std::array<std::string_view, 2> matrix_nouns{"matrix", "matrices"};
constexpr std::array<std::string_view, 6> verbs_of_being{"be", "is", "are", "denote", "denotes", "being"};
constexpr std::array<std::string_view, 2> joining{"and", ","};

/// `A`, `A, B`, `\mathbf{A}`
std::vector<std::string> capitals_in(const SaidPiece& piece) {
  std::vector<std::string> letters;
  if (!piece.formula) return letters;
  for (const std::string_view bold : {"\\mathbf", "\\boldsymbol", "\\bm"}) {
    if (!piece.text.starts_with(bold)) continue;
    std::string inside = piece.text.substr(bold.size());
    std::erase_if(inside, [](char c) { return c == ' ' || c == '{' || c == '}'; });
    if (!is_capital_letter(inside)) return {};
    return {"\\mathbf{" + inside + "}"};
  }
  for (const char c : piece.text) {
    if (c == ' ' || c == ',') continue;
    if (!is_capital_letter(c)) return {};
    letters.emplace_back(1, c);
  }
  const bool word = letters.size() > 1 && piece.text.find(',') == std::string::npos;
  return word ? std::vector<std::string>() : letters;
}

/// "Symmetric matrices", "$A$ and $B$ commute": not all of them are meant.
bool says_special(const SaidPiece& piece) {
  static constexpr std::array<std::string_view, 26> stems{
      "symmetri",   "antisymm",   "skew",      "orthogonal", "orthonorm", "unitar",   "hermit",
      "diagonal",   "triangular", "nilpotent", "idempotent", "projecti",  "project",  "permut",
      "rotation",   "reflection", "commut",    "definite",   "semidef",   "singular", "defective",
      "stochastic", "circulant",  "normal",    "involut",    "unimodular"};
  return !piece.formula &&
         std::ranges::any_of(stems, [&](std::string_view stem) { return piece.text.starts_with(stem); });
}

/// `n \times n`; nothing: it is none.
std::optional<std::pair<std::string, std::string>> size_in(const SaidPiece& piece) {
  const std::size_t times = piece.formula ? piece.text.find("\\times") : std::string::npos;
  if (times == std::string::npos) return std::nullopt;
  const auto trimmed = [](std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '{' || c == '}'; });
    return text;
  };
  return std::pair(trimmed(piece.text.substr(0, times)), trimmed(piece.text.substr(times + 6)));
}

}  // namespace

void see_unsized_matrices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  UnsizedMatrices& found = evidence.unsized;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    const SyntaxKind kind = syntax[id].kind;
    if (kind == SyntaxKind::symbol && syntax.symbol(id).lower.size() > 1)
      found.indexed.insert(letter_with_marks(syntax.symbol(id)));
    if (kind == SyntaxKind::term) see_term(syntax, id, found);
    if (!is_one_of_functions(syntax, id, {"transpose", "det", "tr"})) continue;
    const SyntaxId inside = syntax.child(id, 0);
    const bool column = syntax.text(id) == "transpose" && syntax[inside].kind == SyntaxKind::symbol &&
                        may_be_column(syntax.symbol(inside));
    if (column) {
      found.transposed.insert(labelled_name(syntax.symbol(inside)));
    } else {
      add_capitals(syntax, inside, found);
    }
  }
  const bool written = std::ranges::any_of(nodes_below(syntax, sides), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::tuple || syntax[id].kind == SyntaxKind::matrix;
  });
  for (const SyntaxId side : sides) {
    if (written && syntax[side].kind == SyntaxKind::symbol)
      found.written.insert(labelled_name(syntax.symbol(side)));
  }
  const bool capitals = std::ranges::any_of(sides, [&](SyntaxId side) { return has_capital(syntax, side); });
  for (const SyntaxId side : sides) {
    see_letter_i(syntax, side, capitals, found);
    if (syntax[side].kind == SyntaxKind::symbol && is_capital(syntax.symbol(side)))
      see_made_of(syntax, sides, side, found);
    const bool alone = syntax[side].kind == SyntaxKind::symbol && may_be_column(syntax.symbol(side));
    for (const SyntaxId other : sides) {
      const auto column = other == side || !alone ? std::nullopt : column_at_end(syntax, other);
      if (column) found.equal[labelled_name(syntax.symbol(side))].insert(*column);
    }
  }
}

void see_said_unsized_matrices(std::string_view text, Evidence& evidence) {
  UnsizedMatrices& found = evidence.unsized;
  const std::vector<SaidPiece> pieces = said_pieces(text);
  for (std::size_t at = 0; at < pieces.size(); ++at) {
    if (const auto size = size_in(pieces[at])) {
      if (size->first == size->second) found.sizes.insert(size->first);
      if (size->first != size->second) found.rectangular = true;
    }
    if (is_word_of(std::array<std::string_view, 4>{"vector", "vectors", "eigenvector", "eigenvectors"},
                   pieces[at]))
      found.speaks_of_columns = true;
    if (pieces[at].text == "square" && at + 1 < pieces.size() && is_word_of(matrix_nouns, pieces[at + 1]))
      found.speaks_of_square = true;
    if (pieces[at].text == "rectangular") found.rectangular = true;
    const bool denied =
        at > 0 && is_word_of(std::array<std::string_view, 3>{"not", "never", "t"}, pieces[at - 1]);
    if (found.special.empty() && !denied && says_special(pieces[at])) found.special = pieces[at].text;
    if (!is_word_of(matrix_nouns, pieces[at])) continue;
    for (std::size_t next = at + 1; next < pieces.size(); ++next) {  // the matrices $A$ and $B$
      const auto letters = capitals_in(pieces[next]);
      found.shown.insert(letters.begin(), letters.end());
      if (letters.empty() && !is_word_of(joining, pieces[next])) break;
    }
    // Let $A$ and $B$ be invertible $n\times n$ matrices
    std::size_t verb = at;
    while (verb > 0 && at - verb < 8 && !is_word_of(verbs_of_being, pieces[verb]) &&
           pieces[verb].text != "." && capitals_in(pieces[verb]).empty())
      --verb;
    if (!is_word_of(verbs_of_being, pieces[verb])) continue;
    while (verb > 0) {
      const auto letters = capitals_in(pieces[--verb]);
      found.shown.insert(letters.begin(), letters.end());
      if (letters.empty() && !is_word_of(joining, pieces[verb])) break;
    }
  }
}

namespace {

/// `A` of `A_{1}` and of `\\mathbf{A}`.
std::string letter_alone(const std::string& name) {
  const std::string_view bold = "\\mathbf{";
  const std::size_t begin = name.starts_with(bold) ? bold.size() : 0;
  return name.substr(begin, name.find_first_of("_}", begin) - begin);
}

}  // namespace

void settle_unsized_matrices(Evidence& evidence) {
  UnsizedMatrices& found = evidence.unsized;
  const auto is_known = [&](const std::string& name) {
    const std::string bare = letter_alone(name);
    return evidence.matrices.contains(name) || evidence.written_out.contains(bare) ||
           evidence.declared_real.contains(name) || evidence.plain_numbers.contains(name) ||
           evidence.units.contains(name) || found.written.contains(name) || found.indexed.contains(bare) ||
           (evidence.vectors.contains(bare) && name == bare) || found.dotted.contains(name) ||
           evidence.triples.contains(bare) || evidence.crossed.contains(bare);
  };
  const bool unit = found.units > 0 && found.no_units == 0;
  for (const std::string& name : found.shown) {
    if (!is_known(name) && !(unit && name == "I")) found.matrices.insert(name);
  }
  for (bool grew = true; grew;) {  // P of `P = M(M^TM)^{-1}M^T`
    grew = false;
    for (const auto& [letter, names] : found.made_of) {
      const bool made =
          !is_known(letter) && !(unit && letter == "I") &&
          std::ranges::any_of(names, [&](const std::string& name) { return found.matrices.contains(name); });
      grew = (made && found.matrices.insert(letter).second) || grew;
    }
  }
  const auto may_be_one = [&](const std::string& name) {
    return !evidence.declared_real.contains(name) && !evidence.matrices.contains(name) &&
           !found.written.contains(name) && !found.indexed.contains(letter_alone(name)) &&
           !found.dotted.contains(name);
  };
  const bool vectors = found.speaks_of_columns || !found.transposed.empty();
  for (const std::string& name : found.transposed) {
    if (may_be_one(name)) found.columns.insert(name);
  }
  for (const auto& [name, before] : found.acted_on) {
    const bool acted = std::ranges::any_of(
        before, [&](const std::string& matrix) { return matrix.empty() || found.matrices.contains(matrix); });
    if (acted && vectors && may_be_one(name)) found.columns.insert(name);
  }
  for (const auto& [name, others] : found.equal) {
    const bool column =
        std::ranges::any_of(others, [&](const std::string& other) { return found.columns.contains(other); });
    if (column && may_be_one(name)) found.columns.insert(name);
  }
  // Where some are written out, vectors have the three components of space, or those that are written.
  const bool out = std::ranges::any_of(found.transposed,
                                       [&](const std::string& name) { return found.written.contains(name); });
  if (found.matrices.empty() || out) found.columns.clear();
  evidence.noncommuting.insert(found.matrices.begin(), found.matrices.end());
  evidence.noncommuting.insert(found.columns.begin(), found.columns.end());
}

Unsized unsized_letter(const Evidence& evidence, const std::string& base) {
  const UnsizedMatrices& found = evidence.unsized;
  const bool square = !found.sizes.empty() || found.speaks_of_square;
  if (found.matrices.contains(base))
    return found.rectangular ? Unsized::oblong : square ? Unsized::square : Unsized::matrix;
  return evidence.unsized.columns.contains(base) ? Unsized::column : Unsized::none;
}

}  // namespace rigor
