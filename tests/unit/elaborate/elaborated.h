// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of elaboration share: statements with what the rest of a file says about their letters.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elaborate/notation/elaborate.h"
#include "elaborate/reading/equation.h"
#include "latex/dump_syntax.h"

namespace rigor {

/// The statements of a file, in order; what any of them shows about a letter holds for all, as in a file of
/// notes.
class Statements {
 public:
  ExprTree tree;
  Names names;
  std::vector<std::string> conventions;  // of the last statement that was read
  std::optional<Obstacle> guess;
  Directives used;  // as the directives that the last statement looked up are numbered

  /// Words of `vector \mathbf A`: a symbol is declared by its key.
  Statements& declare(const NameKey& key, Symbol symbol = {}) {
    if (symbol.name.empty()) symbol.name = key.base;
    rigor::declare(names, tree, key, std::move(symbol), next_directive_++);
    return *this;
  }
  Statements& particles(const std::string& letter) {
    declare_particles(names, letter, next_directive_++);
    return *this;
  }

  /// Takes in how a statement elsewhere in the file writes its letters.
  Statements& beside(const std::string& statement) {
    sides_of(statement);
    return *this;
  }

  /// An expression without a relation; nothing, and what is wrong with it, where it cannot be read.
  std::optional<ExprId> read(const std::string& expression, std::string& complaint) {
    const std::vector<SyntaxId> sides = sides_of(expression);
    Diagnostics diagnostics;
    Reading reading{syntax_, tree, names, read_letters(syntax_, sides, names), diagnostics};
    const auto typed = elaborate(reading, sides.at(0));
    for (const Diagnostic& diagnostic : diagnostics) complaint += diagnostic.message + "; ";
    return typed ? std::optional(typed->id) : std::nullopt;
  }

  /// Both sides' dumps, `A = B`, after the column and kind of each diagnostic: `3 bold-index: (…) = (…)`. An
  /// expression without a relation gives its own dump, a side with a mistake `?`.
  std::string meaning(const std::string& statement) {
    const std::vector<SyntaxId> sides = sides_of(statement);
    Diagnostics diagnostics;
    Reading reading{syntax_, tree, names, read_letters(syntax_, sides, names), diagnostics};
    std::vector<std::optional<Typed>> typed;
    for (const SyntaxId side : sides) {
      Around around;
      if (!typed.empty() && typed[0]) around.slots = typed[0]->free;
      typed.push_back(elaborate(reading, side, around));
    }
    const bool equation = typed.size() == 2 && typed[0] && typed[1];
    if (equation) static_cast<void>(equate(reading, *typed[0], *typed[1], {relation_, diagnostics}));
    conventions = reading.found.conventions;
    guess = guess_of(reading);
    used = reading.found.used;
    stretches_.back()->diagnostics = std::move(diagnostics);
    std::string text = stretches_.back()->complaints();
    if (!text.empty()) text += ": ";
    for (const auto& side : typed) {
      if (&side != typed.data()) text += " = ";
      text += side ? dump(tree, side->id) : "?";
    }
    return text;
  }

 private:
  /// The sides around the one `=` outside all brackets, parsed and sighted.
  std::vector<SyntaxId> sides_of(const std::string& statement) {
    stretches_.push_back(std::make_unique<Stretch>(statement));
    const Tokens whole = stretches_.back()->side();
    const TokenView tokens = whole;
    std::vector<SyntaxId> sides;
    Nesting nesting(false);
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= tokens.size(); ++at) {
      const bool end = at == tokens.size();
      if (!end && (nesting.enter(tokens[at]) != 0 || !is_sign(tokens[at], "="))) continue;
      const TokenView side = tokens.subspan(begin, at - begin);
      sides.push_back(parse_side(side, span_of(side), syntax_));
      if (!end) relation_ = tokens[at].span;
      begin = at + 1;
    }
    for (const SyntaxId side : sides) sight_sums(syntax_, side, names.symbols.sightings.write());
    for (const SyntaxId side : sides) sight_faces(syntax_, side, names);
    sight_indices(syntax_, sides, names);
    return sides;
  }

  SyntaxTree syntax_;
  std::vector<std::unique_ptr<Stretch>> stretches_;
  Span relation_;
  std::size_t next_directive_ = 0;
};

/// The meaning of one statement that stands alone.
[[nodiscard]] inline std::string meaning(const std::string& statement) {
  return Statements().meaning(statement);
}

}  // namespace rigor
