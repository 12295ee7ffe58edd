// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/notation_of_notes.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/ascii.h"
#include "elaborate/name/letters.h"
#include "expr/tree/latex_name.h"
#include "latex/token/tokens.h"

namespace rigor {
namespace {

using LetterCounts = std::map<std::string, int>;

/// What stands most often, the first one in order where several do.
std::string most_frequent(const LetterCounts& counts) {
  const auto best = std::ranges::max_element(counts, {}, &LetterCounts::value_type::second);
  return best == counts.end() ? std::string() : best->first;
}

/// Faces and accents that every TeX with amsmath sets.
bool is_common(const std::string& letter) {
  static constexpr std::string_view known[] = {
      "\\mathbf{", "\\boldsymbol{",         "\\vec{", "\\overrightarrow{",
      "\\mathsf{", "\\overleftrightarrow{", "\\hat{"};
  return std::ranges::any_of(known, [&](std::string_view face) { return letter.starts_with(face); });
}

/// `\mathbf A` and `\vec\omega` with their braces.
std::string with_braces(const std::string& letter) {
  std::size_t end = 1;
  while (end < letter.size() && is_letter(letter[end])) ++end;
  if (end >= letter.size() || letter[0] != '\\' || letter[end] == '{') return letter;
  std::size_t argument = end;
  while (argument < letter.size() && letter[argument] == ' ') ++argument;
  return letter.substr(0, end) + "{" + with_braces(letter.substr(argument)) + "}";
}

class Sighting {
 public:
  Sighting(const Notes& notes, const Names& names) : notes_(notes), names_(names) {
    for (const Event& event : notes.events) {
      if (const auto* display = std::get_if<ParsedDisplay>(&event)) take(display->chains);
      if (const auto* placed = std::get_if<PlacedDirective>(&event)) take(placed->directive.chains);
    }
  }

  Notation notation(const ExprTree& tree) {
    Notation notation;
    if (controls_["epsilon"] > controls_["varepsilon"]) notation.epsilon = "\\epsilon";
    notation.metric = names_.symbols.evidence->space_time.metric;
    if (controls_["tfrac"] > number_fractions_) notation.number_fraction = "\\tfrac";
    if (!basis_.empty()) notation.basis = most_frequent(basis_);
    choose_axes(notation);
    for (std::size_t k = 0; k < tree.symbols.size(); ++k) {
      const auto symbol = static_cast<SymbolId>(k);
      const NameKey* key = key_of(names_.symbols, symbol);
      if (key != nullptr && key->space == space_time.id && key->base.find('#') != std::string::npos)
        notation.heights[symbol] = key->base.substr(key->base.find('#') + 1);
      if (key == nullptr || tree.symbols[symbol].derivation) continue;
      if (is_principal_value(names_.symbols, tree.symbols, symbol)) notation.principal.insert(symbol);
      if (is_field(names_, tree, symbol)) notation.fields.insert(symbol);
      const std::string& name = tree.symbols[symbol].name;
      const bool renamed = without_face(name) != key->base && !key->base.starts_with("\\unit") &&
                           !tree.symbols[symbol].rotation;
      if (renamed) notation.base[symbol] = key->base;
      const auto axes = axes_on_.find(key->base);
      if (axes != axes_on_.end() && axes->second > 0) notation.lettered.insert(symbol);
      const auto faces = faces_.find({key->base, key->rank > 1});
      if (key->rank > 0 && faces != faces_.end()) notation.whole[symbol] = most_frequent(faces->second);
    }
    return notation;
  }

 private:
  void take(const std::vector<ParsedChain>& chains) {
    for (const ParsedChain& chain : chains) {
      for (std::size_t k = 0; k < chain.sides.size() && chain.image == 0; ++k)
        take(chain.sides[k], chain.written.sides[k].tokens);
    }
  }

  void take(SyntaxId root, const Tokens& tokens) {
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (tokens[at].kind != TokenKind::control) continue;
      ++controls_[std::string(tokens[at].text)];
      if (!is_control(tokens[at], "frac")) continue;
      const TokenView above = trim(argument_at(tokens, at + 1).content);
      const auto digit = [](const Token& token) { return token.kind == TokenKind::digit; };
      if (std::ranges::all_of(above, digit)) ++number_fractions_;
    }
    std::vector<SyntaxId> open{root};
    while (!open.empty()) {
      const SyntaxId id = open.back();
      open.pop_back();
      if (notes_.syntax[id].kind == SyntaxKind::symbol) take(notes_.syntax.symbol(id), tokens);
      for (const SyntaxChild& child : notes_.syntax.children(id)) open.push_back(child.id);
    }
  }

  void take(const WrittenSymbol& symbol, const Tokens& tokens) {
    const WrittenName name = take_apart(symbol, Letters{}, names_);
    for (const WrittenIndex& axis : symbol.lower) {
      const bool lettered = axis_of_letter(axis.text) != 0 && axis.form == IndexForm::letter;
      if (lettered || axis.form == IndexForm::digit) axes_on_[name.base] += lettered ? 1 : -1;
      if (lettered && !is_basis_family(symbol)) ++letters_;
      if (axis.form == IndexForm::digit && !is_basis_family(symbol)) ++digits_;
    }
    const bool plain = symbol.face == Face::plain && symbol.accent != Accent::hat;
    if (plain || symbol.dots > 0 || !symbol.change.empty()) return;
    const std::string letter = letter_of_tokens(tokens, symbol.letter_span);
    if (!is_common(letter)) return;
    const bool axis = symbol.accent == Accent::hat && symbol.lower.empty() && symbol.primes == 0 &&
                      (axis_of_letter(symbol.letter) != 0 || symbol.letter == "\\imath");
    if (is_basis_family(symbol)) ++basis_[letter];
    if (axis) ++hats_[{letter, symbol.letter}];
    if (!is_basis_family(symbol) && !axis) ++faces_[{name.base, symbol.face == Face::tensor}][letter];
  }

  /// The letter with its face, as it is in the tokens.
  static std::string letter_of_tokens(const Tokens& tokens, Span span) {
    Tokens own;
    for (const Token& token : tokens) {
      if (token.span.file == span.file && token.span.begin >= span.begin && token.span.end <= span.end)
        own.push_back(token);
    }
    return with_braces(latex_name(text_of(own)).letter);
  }

  /// \hat{x}, \hat{y}, \hat{z} where they are the basis of the notes.
  void choose_axes(Notation& notation) {
    notation.lettered_axes = letters_ > digits_;
    int indexed = 0;
    for (const auto& [letter, count] : basis_) indexed += count;
    int hatted = 0;
    for (const auto& [sign, count] : hats_) hatted += count;
    if (hatted <= indexed) return;
    const auto& [text, letter] = hats_.begin()->first;
    const bool dotless = letter == "\\imath";
    const std::array<std::string, 3> all = dotless ? std::array<std::string, 3>{"\\imath", "\\jmath", "k"}
                                                   : std::array<std::string, 3>{"x", "y", "z"};
    const auto at = text.find(letter, 4);
    if (at == std::string::npos) return;
    for (std::size_t k = 0; k < 3; ++k) {
      notation.axes[k] = text;
      notation.axes[k].replace(at, letter.size(), all[k]);
    }
  }

  const Notes& notes_;
  const Names& names_;
  LetterCounts controls_;
  int number_fractions_ = 0;
  int letters_ = 0;  // components along x, y, z
  int digits_ = 0;
  LetterCounts basis_;
  std::map<std::pair<std::string, std::string>, int> hats_;     // `\hat{x}`, `x`
  std::map<std::pair<std::string, bool>, LetterCounts> faces_;  // by base, of a tensor
  std::map<std::string, int> axes_on_;                          // letters more than digits
};

}  // namespace

Notation notation_of_notes(const Notes& notes, const Names& names, const ExprTree& tree) {
  return Sighting(notes, names).notation(tree);
}

}  // namespace rigor
