// SPDX-License-Identifier: GPL-3.0-or-later
// What holds at a place of the notes: definitions, assumptions, frames. This file stores state; each entry
// has the depth of the section that said it, and ends with that section.
//
// A definition by an equation outlives its section: it says what a name means, and readers go on using the
// name. What a directive says (declares, assumes, calls constant or small) holds where its author put it, and
// ends with the section. After a frame's section, the definitions are again those along fixed axes.
//
// A scope is kept for each place that is looked at later, so that it answers then as it did there. All parts
// are shared: a copy costs a pointer for each, what is said after it is appended, entering a section copies
// nothing, and leaving one copies only the parts that lose an entry.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/shared.h"
#include "elaborate/name/name_key.h"
#include "expr/statement/statement.h"

namespace rigor {

/// A directive or an equation that brought something into scope.
struct Origin {
  std::string text;                        // as it is named in a verdict's `uses`: `definition (8)`
  std::string section;                     // of an equation
  std::optional<std::size_t> directive{};  // number of the directive, to mark it as used
  std::string expanded = {};               // of an assumption: `text` without macros of the notes
  std::size_t place = 0;                   // of an equation: its section, as `Sections` counts them
  std::size_t event = 0;                   // and its display
  bool conditional = false;                // it is after "if", "suppose", "for small …"
  bool on_its_line = false;                // its own line says when: `y = x \quad (x < 1)`
  bool only_counts = false;                // which says only which numbers a letter takes
  bool of_a_case = false;                  // its heading is of a special case
  bool of_a_region = false;                // words before it say where: "outside of the ball"
};

struct NamedDefinition {
  Definition definition;
  Origin origin;
  int depth = 0;
  bool at_instant = false;  // said of components along other axes: it holds now, its derivatives do not
  std::vector<SymbolId> along = {};  // x of `u(x) = A\cos qx + B`: the other letters are parameters
};

struct NamedAssumption {
  Equation equation;
  Origin origin;
  int depth = 0;
  bool at_instant = false;            // as above
  std::optional<SymbolId> rate_of{};  // all it says is how this changes: nothing, where nothing else has it
  bool without_sample = false;  // nothing was found that satisfies it: what is proved from it proves nothing
};

/// An assumption that could not be read: what it would say of its letters is not known.
struct UnreadAssumption {
  std::string text;
  std::set<std::string> letters;
  std::size_t directive = 0;
  int depth = 0;
};

struct DefinedSymbol {
  SymbolId operator()(const NamedDefinition& named) const { return named.definition.symbol; }
};
[[nodiscard]] std::vector<SymbolId> symbols_of(const std::vector<NamedDefinition>& definitions);
/// One for each symbol.
using NamedDefinitions = SharedIndex<NamedDefinition, DefinedSymbol>;

/// What was defined and assumed, to be taken back by `replace`.
struct Held {
  NamedDefinitions definitions;
  SharedList<NamedAssumption> assumptions;
};

/// `frame rot rotates with \boldsymbol{\omega} in in`: components are along the axes of `rotating`; the
/// rotation carries those axes' components to `fixed` ones.
struct Frame {
  std::string rotating;
  std::string fixed;
  SymbolId rotation{};
  ExprId angular_velocity{};
  std::size_t directive = 0;
  int depth = 0;
  Held before = {};  // what held without it, and holds again after its section
};

/// A symbol, or one component of it, that is small: this is 0 to zeroth order.
struct SmallQuantity {
  ExprId quantity{};
  std::vector<ParticleId> particles = {};  // free
  std::size_t directive = 0;
  int depth = 0;
};

struct DeclaredConstant {
  SymbolId symbol{};
  std::optional<std::size_t> directive = {};  // that says so; nothing: it is only taken to be
  int depth = 0;
  std::size_t frames = 0;  // in force where it stands
};

/// The members that `E_n = n^2\epsilon` gives: E_1, E_{n+1}.
struct Family {
  SymbolId general{};      // E_n
  std::string sequence;    // E
  std::string letter;      // n
  bool by_number = false;  // E_1 is meant as well
  int first = 0;           // number that the letter takes
  int depth = 0;
};

/// For each symbol that something is said about, the depth of the outermost section that says it.
using SaidOfSymbols = SharedMap<SymbolId, int>;

struct NameScope {
  NamedDefinitions definitions;
  ExprId last_body{};  // no body of theirs is behind it
  SharedList<NamedAssumption> assumptions;
  SharedList<UnreadAssumption> unread;
  Shared<std::vector<Frame>> frames;  // the last one is in force
  SharedList<DeclaredConstant> constants;
  SharedList<SmallQuantity> small;
  SaidOfSymbols variables;            // they may change
  SaidOfSymbols for_all;              // statements are meant for all their values
  SaidOfSymbols of_other_order;       // declared small, and of another order by what else is said
  SharedList<Family> families;        // that definitions of this section or one around it give
  SaidOfSymbols apart;                // E_0 of a field, though the E_n are a family
  SaidOfSymbols seen;                 // in an equation of this section or one around it
  SharedSet<SymbolId> seen_anywhere;  // in one of any section
  int depth = 0;                      // of the section at hand
};

/// A second definition takes the place of the first.
void define(NameScope& scope, NamedDefinition definition);
[[nodiscard]] const NamedDefinition* definition_of(const NameScope& scope, SymbolId symbol);
/// What it says; nothing: there is none.
[[nodiscard]] std::optional<ExprId> body_of_definition(const NameScope& scope, SymbolId symbol);
/// The symbols below some roots, and below the definitions of these, or of what they are derivatives of.
[[nodiscard]] std::vector<SymbolId> symbols_reached(const ExprTree& tree, const NameScope& scope,
                                                    std::vector<ExprId> roots);
void forget_definition(NameScope& scope, SymbolId symbol);
/// All at once: each time copies what is left.
void forget_definitions(NameScope& scope, const std::vector<SymbolId>& symbols);
void assume(NameScope& scope, NamedAssumption assumption);
void doubt_last_assumption(NameScope& scope);
void note_unread(NameScope& scope, UnreadAssumption unread);

[[nodiscard]] inline Held held(const NameScope& scope) { return {scope.definitions, scope.assumptions}; }
void replace(NameScope& scope, Held held);

void declare_constant(NameScope& scope, SymbolId symbol, std::optional<std::size_t> directive);
[[nodiscard]] bool is_declared_constant(const NameScope& scope, SymbolId symbol);
/// Something else in the notes makes it change; how is then unknown. Returns the directives that called it
/// constant: they count as used, since they are in the way.
[[nodiscard]] Directives withdraw_constant(NameScope& scope, SymbolId symbol);
void declare_variable(NameScope& scope, SymbolId symbol);
/// It is said anew, in a way that defines nothing.
void end_family(NameScope& scope, SymbolId general);
void set_apart(NameScope& scope, SymbolId symbol);
void declare_small(NameScope& scope, SmallQuantity small);
void note_other_order(NameScope& scope, SymbolId small);
[[nodiscard]] inline bool is_of_other_order(const NameScope& scope, SymbolId small) {
  return scope.of_other_order.contains(small);
}
void mean_for_all(NameScope& scope, SymbolId symbol);
/// Are statements meant for all its values? That says nothing about its derivatives.
[[nodiscard]] inline bool is_for_all(const NameScope& scope, SymbolId symbol) {
  return scope.for_all.contains(symbol);
}

/// From here on components are along turning axes.
void enter_frame(NameScope& scope, Frame frame);
/// Undoes entering the last frame, but keeps its definitions.
void withdraw_frame(NameScope& scope);
/// Was it made by an equation since the frame in force began?
[[nodiscard]] bool is_made_in_frame(const NameScope& scope, const NamedDefinition& definition);

/// Was the symbol part of an equation before, in this section or one around it? (A declaration alone is not.)
[[nodiscard]] inline bool seen_in_equation(const NameScope& scope, SymbolId symbol) {
  return scope.seen.contains(symbol);
}
void mark_seen(NameScope& scope, SymbolId symbol);

/// A heading of this level closes all sections of its level and below.
void open_section(NameScope& scope, int level);

}  // namespace rigor
