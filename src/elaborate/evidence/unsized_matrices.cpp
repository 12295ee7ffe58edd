// SPDX-License-Identifier: GPL-3.0-or-later
// A capital is a matrix of unknown size where the words say so, or a transpose, a trace or a determinant is
// taken of it. A small letter is a column where it is transposed, or where a matrix stands before it and the
// words speak of vectors. What is written out, has two indices or is a number is neither.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

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
void add_capitals(const SyntaxTree& syntax, SyntaxId id, std::set<std::string>& names) {
  const SyntaxNode& node = syntax[id];
  switch (node.kind) {
    case SyntaxKind::symbol: {
      const WrittenSymbol& symbol = syntax.symbol(id);
      if (is_capital(symbol)) names.insert(labelled_name(symbol));
      return;
    }
    case SyntaxKind::power:
      return add_capitals(syntax, syntax.child(id, 0), names);
    case SyntaxKind::function:
      if (is_one_of_functions(syntax, id, {"transpose"})) add_capitals(syntax, syntax.child(id, 0), names);
      return;
    case SyntaxKind::group:
    case SyntaxKind::sum:
    case SyntaxKind::term:
      for (const SyntaxChild& child : syntax.children(id)) {
        if (child.joint != Joint::slash) add_capitals(syntax, child.id, names);
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

/// The last factor of a term, if it may be a column and no row stands in the term.
std::optional<std::string> column_at_end(const SyntaxTree& syntax, SyntaxId id) {
  const bool row = std::ranges::any_of(nodes_below(syntax, {id}), [&](SyntaxId one) {  // `x^TAx`
    return is_one_of_functions(syntax, one, {"transpose"}) &&
           syntax[syntax.child(one, 0)].kind == SyntaxKind::symbol &&
           may_be_column(syntax.symbol(syntax.child(one, 0)));
  });
  if (row) return std::nullopt;
  if (syntax[id].kind == SyntaxKind::term) id = syntax.children(id).back().id;
  if (syntax[id].kind != SyntaxKind::symbol || !may_be_column(syntax.symbol(id))) return std::nullopt;
  return labelled_name(syntax.symbol(id));
}

/// `x = x_0 + Bu`: the ends of all terms of all sides, which are columns together. Empty: one is none.
std::set<std::string> ends_of_terms(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::set<std::string> ends;
  for (const SyntaxId side : sides) {
    std::vector<SyntaxId> terms{side};
    if (syntax[side].kind == SyntaxKind::sum) {
      terms.clear();
      for (const SyntaxChild& child : syntax.children(side)) terms.push_back(child.id);
    }
    for (const SyntaxId term : terms) {
      const bool zero = syntax[term].kind == SyntaxKind::number && syntax.text(term) == "0";
      const auto end = column_at_end(syntax, term);
      if (!end && !zero) return {};
      if (end) ends.insert(*end);
    }
  }
  return ends;
}

/// `x^2`, `1/x`, `\sin x`, `xy`: no column stands there.
void see_numbers(const SyntaxTree& syntax, SyntaxId id, UnsizedMatrices& found) {
  const SyntaxNode& node = syntax[id];
  const auto children = syntax.children(id);
  const auto add = [&](SyntaxId one) {
    while (syntax[one].kind == SyntaxKind::group) one = syntax.child(one, 0);
    if (syntax[one].kind == SyntaxKind::symbol && may_be_column(syntax.symbol(one)))
      found.numbers.insert(labelled_name(syntax.symbol(one)));
  };
  if (node.kind == SyntaxKind::power && children.size() == 2) add(children[0].id);
  if (node.kind == SyntaxKind::fraction && children.size() == 2) add(children[1].id);
  if (node.kind == SyntaxKind::function && !is_one_of_functions(syntax, id, {"transpose", "tr", "det"}))
    add(children[0].id);
  if (node.kind != SyntaxKind::term) return;
  for (std::size_t k = 0; k + 1 < children.size(); ++k) {
    const SyntaxKind next = syntax[children[k + 1].id].kind;
    const bool row = is_one_of_functions(syntax, children[k + 1].id, {"transpose"});
    if (!row && next != SyntaxKind::group) add(children[k].id);
    if (children[k + 1].joint == Joint::slash) add(children[k + 1].id);
  }
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

/// Capitals of factors side by side.
void see_neighbours(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, UnsizedMatrices& found) {
  std::set<std::string> before;
  for (const SyntaxChild& factor : factors) {
    std::set<std::string> here;
    if (factor.joint != Joint::slash) add_capitals(syntax, factor.id, here);
    for (const std::string& letter : here) found.beside[letter].insert(before.begin(), before.end());
    for (const std::string& letter : before) found.beside[letter].insert(here.begin(), here.end());
    before = std::move(here);
  }
}

/// `Ax`, `x^Ty`: the last factor, and what stands before it.
void see_term(const SyntaxTree& syntax, SyntaxId id, UnsizedMatrices& found) {
  const auto factors = syntax.children(id);
  see_dotted(syntax, factors, found);
  if (factors.size() < 2 || factors.back().joint != Joint::juxtaposed) return;
  see_neighbours(syntax, factors, found);
  const auto column = column_at_end(syntax, factors.back().id);
  const SyntaxId before = factors[factors.size() - 2].id;
  if (!column) return;
  if (is_one_of_functions(syntax, before, {"transpose"})) {
    found.acted_on[*column].insert("");
  } else if (const auto matrix = capital_of(syntax, before)) {
    found.acted_on[*column].insert(*matrix);
  }
}

bool is_plain_letter(const WrittenSymbol& symbol) {
  return symbol.face == Face::plain && symbol.lower.empty() && symbol.dots == 0 && symbol.change.empty();
}

/// `P = AB`: the capitals of the other sides, unless these may be numbers, as `x^TAx` is.
void see_made_of(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, SyntaxId alone,
                 UnsizedMatrices& found) {
  std::set<std::string>& made_of = found.made_of[labelled_name(syntax.symbol(alone))];
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    const bool column = syntax[id].kind == SyntaxKind::symbol && may_be_column(syntax.symbol(id));
    if (column && id != alone) return;
  }
  for (const SyntaxId side : sides) {
    if (side != alone) add_capitals(syntax, side, made_of);
  }
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
/// "A tall matrix", "the pseudo-inverse": a matrix that need not be square.
constexpr auto oblong_words =
    std::to_array<std::string_view>({"rectangular", "nonsquare", "pseudo", "pseudoinverse", "overdetermined",
                                     "underdetermined", "regression"});
constexpr auto oblong_pairs =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"least", "squares"},
                                                                  {"design", "matrix"},
                                                                  {"tall", "matrix"},
                                                                  {"wide", "matrix"},
                                                                  {"tall", "matrices"},
                                                                  {"wide", "matrices"},
                                                                  {"more", "rows"},
                                                                  {"more", "columns"},
                                                                  {"fewer", "rows"},
                                                                  {"fewer", "columns"},
                                                                  {"less", "rows"},
                                                                  {"less", "columns"}});
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
  static constexpr auto stems = std::to_array<std::string_view>(
      {"symmetri",   "antisymm",    "skew",        "orthogonal", "orthonorm",  "unitar",      "hermit",
       "diagonal",   "triangular",  "nilpotent",   "idempotent", "project",    "permut",      "rotation",
       "reflection", "commut",      "anticommut",  "definite",   "semidef",    "singular",    "defective",
       "stochastic", "circulant",   "normal",      "involut",    "unimodular", "selfadjoint", "adjoint",
       "pauli",      "gram",        "stiffness",   "mass",       "inertia",    "covarian",    "correlat",
       "hessian",    "metric",      "density",     "reciproc",   "laplacian",  "adjacency",   "moment",
       "admittance", "impedance",   "conductance", "scattering", "dirac",      "spin",        "lorentz",
       "boost",      "householder", "givens",      "hadamard",   "toeplitz",   "hankel",      "markov",
       "transition", "cholesky",    "strain",      "stress",     "polari",     "jones",       "mueller",
       "quaternion", "elementary",  "cyclic",      "exchange",   "shift",      "similar",     "tensor"});
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
    if (kind == SyntaxKind::symbol && syntax.symbol(id).letter == "T" && is_plain_letter(syntax.symbol(id)))
      found.t_is_a_letter = true;
    if (kind == SyntaxKind::symbol && syntax.symbol(id).lower.size() > 1)
      found.indexed.insert(letter_with_marks(syntax.symbol(id)));
    if (kind == SyntaxKind::term) see_term(syntax, id, found);
    see_numbers(syntax, id, found);
    if (!is_one_of_functions(syntax, id, {"transpose", "det", "tr"})) continue;
    const SyntaxId inside = syntax.child(id, 0);
    const bool transposes = syntax.text(id) == "transpose";
    const bool column =
        transposes && syntax[inside].kind == SyntaxKind::symbol && may_be_column(syntax.symbol(inside));
    if (column) {
      found.transposed.insert(labelled_name(syntax.symbol(inside)));
    } else {
      add_capitals(syntax, inside, transposes ? found.shown_by_transpose : found.shown);
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
    if (syntax[side].kind == SyntaxKind::symbol &&
        (is_capital(syntax.symbol(side)) || is_plain_letter(syntax.symbol(side))))
      see_made_of(syntax, sides, side, found);
  }
  if (auto ends = ends_of_terms(syntax, sides); ends.size() > 1) found.alike.push_back(std::move(ends));
}

namespace {

using Sentence = std::span<const SaidPiece>;

/// The letters that a sentence calls matrices: "the matrices $A$ and $B$", "let $A$ be an $n\times n$
/// matrix", "and $K$ a matrix".
std::set<std::string> called_matrices(Sentence pieces) {
  static constexpr std::array<std::string_view, 3> articles_before{"a", "an", "the"};
  std::set<std::string> called;
  const auto add = [&](const SaidPiece& piece) {
    const auto letters = capitals_in(piece);
    called.insert(letters.begin(), letters.end());
    return !letters.empty();
  };
  for (std::size_t at = 0; at < pieces.size(); ++at) {
    if (!is_word_of(matrix_nouns, pieces[at])) continue;
    for (std::size_t next = at + 1; next < pieces.size(); ++next) {
      if (!add(pieces[next]) && !is_word_of(joining, pieces[next])) break;
    }
    std::size_t verb = at;
    while (verb > 0 && at - verb < 8 && !is_word_of(verbs_of_being, pieces[verb]) &&
           capitals_in(pieces[verb]).empty())
      --verb;
    if (is_word_of(verbs_of_being, pieces[verb])) {
      while (verb > 0 && (add(pieces[verb - 1]) || is_word_of(joining, pieces[verb - 1]))) --verb;
    } else if (verb + 1 < at && is_word_of(articles_before, pieces[verb + 1])) {
      add(pieces[verb]);
    }
  }
  return called;
}

/// Words of a sentence that introduces matrices which say no more of them. All others may.
bool is_neutral_of_matrices(std::string_view word) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"a",          "all",       "also",        "always",       "an",         "and",      "any",
       "arbitrary",  "are",       "as",          "be",           "both",       "by",       "capital",
       "case",       "choose",    "column",      "columns",      "complex",    "consider", "constant",
       "denote",     "denotes",   "determinant", "determinants", "do",         "every",    "factors",
       "first",      "following", "for",         "from",         "general",    "given",    "has",
       "have",       "here",      "hold",        "holds",        "identity",   "if",       "in",
       "inverse",    "inverses",  "invertible",  "is",           "it",         "its",      "large",
       "let",        "letters",   "many",        "matrices",     "matrix",     "matters",  "n",
       "need",       "no",        "nonsingular", "not",          "number",     "numbers",  "of",
       "on",         "or",        "order",       "power",        "powers",     "product",  "products",
       "real",       "regular",   "rows",        "rule",         "rules",      "scalar",   "scalars",
       "size",       "so",        "square",      "sum",          "sums",       "suppose",  "that",
       "the",        "their",     "then",        "these",        "they",       "this",     "three",
       "throughout", "trace",     "traces",      "transpose",    "transposes", "two",      "unit",
       "vector",     "vectors",   "we",          "where",        "which",      "with",     "write"});
  return is_one_of(word, words);
}

void see_sentence(Sentence pieces, UnsizedMatrices& found) {
  const auto word_at = [&](std::size_t at) {
    return at < pieces.size() && !pieces[at].formula ? std::string_view(pieces[at].text) : std::string_view{};
  };
  const std::set<std::string> called = called_matrices(pieces);
  found.called.insert(called.begin(), called.end());
  for (const SaidPiece& piece : pieces) {
    const auto size = size_in(piece);
    for (const std::string& letter : called) {
      if (size && size->first == size->second) found.rows[letter] = size->first;
    }
  }
  for (std::size_t at = 0; at < pieces.size(); ++at) {
    if (const auto size = size_in(pieces[at])) {
      if (size->first == size->second) found.sizes.insert(size->first);
      if (size->first == "1" && found.special.empty()) found.special = "1\\times1";
      if (size->first != size->second) found.rectangular = true;
    }
    if (pieces[at].formula) {
      found.t_is_a_letter = found.t_is_a_letter || pieces[at].text == "T";
      continue;
    }
    const std::string_view word = word_at(at);
    const bool denied = at > 0 && is_one_of(word_at(at - 1), {"not", "never", "t", "non"});
    if (is_one_of(word, {"vector", "vectors", "eigenvector", "eigenvectors"})) found.speaks_of_columns = true;
    if (word == "square" && is_word_of(matrix_nouns, pieces[std::min(at + 1, pieces.size() - 1)]))
      (denied ? found.rectangular : found.speaks_of_square) = true;
    const bool in_pair =
        std::ranges::find(oblong_pairs, std::pair(word, word_at(at + 1))) != oblong_pairs.end();
    if (is_word_of(oblong_words, pieces[at]) || in_pair) found.rectangular = true;
    if (word == "block" || word == "blocks") found.speaks_of_blocks = true;
    const bool sign = word.size() == 1 && !is_letter(word[0]);
    const bool same_size = word == "same" && is_one_of(word_at(at + 1), {"size", "order", "dimension"});
    const bool says_more =
        says_special(pieces[at]) || (!called.empty() && !sign && !same_size && !is_neutral_of_matrices(word));
    if (found.special.empty() && !denied && says_more) found.special = word;
  }
}

}  // namespace

void see_said_unsized_matrices(std::string_view text, Evidence& evidence) {
  const std::vector<SaidPiece> pieces = said_pieces(text);
  for (std::size_t begin = 0; begin < pieces.size();) {
    std::size_t end = begin;
    while (end < pieces.size() && pieces[end].text != ".") ++end;
    if (end > begin) see_sentence(Sentence(pieces).subspan(begin, end - begin), evidence.unsized);
    begin = end + 1;
  }
}

namespace {

/// `A` of `A_{1}` and of `\mathbf{A}`.
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
  if (found.t_is_a_letter) {
    found.transposed.clear();
  } else {
    found.shown.insert(found.shown_by_transpose.begin(), found.shown_by_transpose.end());
  }
  found.shown.insert(found.called.begin(), found.called.end());
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
    for (const auto& [letter, names] : found.beside) {  // B of `A(B + C)`
      const bool acts =
          !is_known(letter) && !(unit && letter == "I") &&
          std::ranges::any_of(names, [&](const std::string& name) { return found.matrices.contains(name); });
      grew = (acts && found.matrices.insert(letter).second) || grew;
    }
  }
  const auto may_be_one = [&](const std::string& name) {
    return !evidence.declared_real.contains(name) && !evidence.matrices.contains(name) &&
           !found.written.contains(name) && !found.indexed.contains(letter_alone(name)) &&
           !found.dotted.contains(name) && !found.numbers.contains(name);
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
  for (bool grew = true; grew;) {  // x_0 of `x = x_0 + Bu`
    grew = false;
    for (const std::set<std::string>& ends : found.alike) {
      const bool column =
          std::ranges::any_of(ends, [&](const std::string& name) { return found.columns.contains(name); });
      for (const std::string& name : ends)
        grew = (column && may_be_one(name) && found.columns.insert(name).second) || grew;
    }
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
