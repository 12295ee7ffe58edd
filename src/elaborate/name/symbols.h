// SPDX-License-Identifier: GPL-3.0-or-later
// What letters are: which symbol a key stands for, what a directive says about it, and where it was seen.
// This file stores state and answers what follows from that alone; `Names` answers what also depends on the
// place.
//
// A symbol is looked up by a key and not by its text, since one letter is written in many ways and one text
// is several symbols. A directive declares to the end of its section; after that the letter is a symbol like
// any other again. A later declaration that says the same means the same symbol. Sightings are of the whole
// file. Evidence is of the section at hand and those around it, and is kept with the place where it was
// valid.
//
// All parts are shared: a copy costs a pointer for each, and what comes after it is appended.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/shared.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/name/name_key.h"
#include "elaborate/name/sightings.h"
#include "expr/tree/tree.h"

namespace rigor {

/// What declares a key, or a letter that labels particles.
struct Declaration {
  std::size_t directive = 0;
  int depth = 0;  // of the section that it is in
};

/// From here to the end of the section, vectors, tensors and indices belong to it.
struct SpaceInForce {
  Space space;
  Declaration declared;
};

/// `x(0)`, `V''(r_0)`: a function where its variables have these values; or a member of a sequence.
struct FunctionValue {
  SymbolId of{};                            // x; V''
  std::vector<std::string> variables = {};  // t; r; none: nothing says which they are
  std::vector<ExprId> at = {};
  bool indexed = false;  // `x_i` in a sum over i from 1 to n: `at` stands below
};

struct Symbols {
  struct Declared {
    SymbolId symbol{};
    Declaration by;
  };

  SharedMap<NameKey, SymbolId> entries;   // but for those that
  SharedMap<NameKey, Declared> declared;  // a directive declares here, which end with their section
  SharedMap<SymbolId, NameKey> keys;
  SharedMap<NameKey, SymbolId> declared_before;  // in any section
  SharedMap<SymbolId, FunctionValue> function_values;
  SharedMap<std::string, Declaration> particle_letters;
  Shared<std::vector<SpaceInForce>> spaces;                             // the innermost last
  Shared<std::map<std::pair<std::string, int>, Space>> spaces_by_name;  // of the file: name and dimension
  Shared<std::set<NameKey>> plain;      // `vector A`: the plain letter is the vector itself, not its length
  std::optional<SymbolId> primed_axes;  // the rotation whose first axis is primed, if they were spoken of
  Shared<Sightings> sightings;
  Shared<Evidence> evidence;
};

/// The space that vectors, tensors and indices belong to here: the common one where none was entered.
[[nodiscard]] inline Space space_of(const Symbols& symbols) {
  return symbols.spaces->empty() ? common_space : symbols.spaces->back().space;
}
/// The space of columns with so many entries: the one in force or the common one where that has as many axes,
/// so that a column can be a vector; else one that is shared by all columns of that length.
[[nodiscard]] Space column_space(const Symbols& symbols, int dimension);
[[nodiscard]] AxisSpaces axes_of(const Symbols& symbols, MatrixShape shape);
/// The directive that says so, if one does.
[[nodiscard]] std::optional<std::size_t> space_declared_by(const Symbols& symbols);
/// The key of this name where the space in force is.
[[nodiscard]] NameKey placed(const Symbols& symbols, NameKey key);

// Keys that are looked up need not say their space: it is the one in force.

/// The symbol if it exists.
[[nodiscard]] std::optional<SymbolId> find_symbol(const Symbols& symbols, const NameKey& key);
/// The symbol of this key, made at first sight. Where it is declared, the directive is used: declared_by().
SymbolId resolve(Symbols& symbols, ExprTree& tree, const NameKey& key, const std::string& name, Span span);
/// Nothing for symbols that no name of the notes stands for, derivatives among them.
[[nodiscard]] const NameKey* key_of(const Symbols& symbols, SymbolId symbol);

/// The directive that says what the symbol is, if one does.
[[nodiscard]] std::optional<std::size_t> declared_by(const Symbols& symbols, const NameKey& key);
[[nodiscard]] inline bool is_declared(const Symbols& symbols, const NameKey& key) {
  return declared_by(symbols, key).has_value();
}
[[nodiscard]] inline bool is_plain(const Symbols& symbols, const NameKey& key) {
  return symbols.plain->contains(placed(symbols, key)) && is_declared(symbols, key);
}

/// By a directive, or by a sum over it.
[[nodiscard]] bool labels_particles(const Symbols& symbols, const std::string& letter);
/// The directive that says so, if one does.
[[nodiscard]] std::optional<std::size_t> particles_declared_by(const Symbols& symbols,
                                                               const std::string& letter);

/// I_i where `I_{ij} = I_i\delta_{ij}` is said: three numbers that belong to axes, no vector.
[[nodiscard]] bool is_principal_value(const Symbols& symbols, const SymbolTable& table, SymbolId symbol);
/// Does a ∂ or ∇ stand directly before it somewhere in the file? The Lagrangian L is not the vector **L**: of
/// one letter, numbers and vectors are told apart.
[[nodiscard]] bool is_differentiated_by_place(const Symbols& symbols, const NameKey& key);

/// A heading of this level closes sections: what their directives declared is declared no longer.
void close_sections(Symbols& symbols, int level);

}  // namespace rigor
