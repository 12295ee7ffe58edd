// SPDX-License-Identifier: GPL-3.0-or-later
// What is MEANT: a typed expression. Every node has a rank (0 scalar, 1 vector, 2 second-rank tensor). Index
// notation and direct notation are both kept, so that a program can evaluate the form that was written:
// `\epsilon_{ijk}A_jB_k` is sums over components, `\mathbf A\times\mathbf B` is a cross product. Implicit
// sums have become explicit; definitions are still names, unfolded on demand. Nodes lie in one array,
// children before parents, and never change: an id stays valid, and equal parts can be shared, also by copies
// of the tree, which cost little. Axes are orthonormal; in the common space they are 1, 2, 3, right-handed.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/shared.h"
#include "base/span.h"
#include "expr/tree/space.h"
#include "expr/tree/symbol.h"

namespace rigor {

enum class ExprId : std::uint32_t {};
enum class IndexId : std::uint32_t {};     // an index variable, over the axes of its space
enum class ParticleId : std::uint32_t {};  // a particle variable

enum class Op : std::uint8_t {
  number,      // text: decimal digits with at most one point, e.g. `2`, `0.25`
  symbol,      // all slots given: rank 0; no slots: the symbol's rank. `particle` where the symbol is per
               // particle
  basis,       // e_s, a unit vector along the axis of its one slot; rank 1; `axes` says in which space
  delta,       // two slots
  epsilon,     // three slots; ε_123 = 1
  add,         // any number of children, all of one rank
  negate,      // one child
  multiply,    // outer product in order; ranks add up (at most one child of rank > 0 is the usual case)
  divide,      // dividend of any rank, divisor of rank 0
  power,       // child of rank 0, integer `exponent`
  real_power,  // base and exponent of rank 0: a real number where the base is positive; rank 0
  root,        // the non-negative square root; rank 0
  length,      // rank 1 -> rank 0: √(a·a), of complex components √(a*·a); never negative
  absolute,    // rank 0: √(a²), of a complex number √(a*a)
  dot,        // contraction of the last axis of the first with the first axis of the second; rank a + b − 2
  cross,      // ranks 1, 1 -> 1: (a×b)_i = ε_ijk a_j b_k
  component,  // one child of rank = number of slots -> rank 0
  tuple,      // children of equal rank r -> rank r + 1: the components; `axes` says of which space the
              // first axis is, and its dimension how many children there are
  determinant,         // nine children row by row; all of rank 0, or one row of rank 1: ε_ijk a_1i a_2j a_3k
  imaginary_unit,      // i; rank 0
  conjugate,           // one child of any rank, component by component; of an operator its adjoint
  real_part,           // the same
  imaginary_part,      // the same; a real number
  transpose,           // of a matrix of any size; rank 0, as such a matrix has
  trace,               // the same; a number. A second child: how many rows it has, if the notes say so
  matrix_determinant,  // as the trace
  index_sum,           // Σ over `index`, along the axes of its space
  particle_sum,        // Σ over all particles
  function,            // `function` of one child of rank 0; rank 0
  table,  // values by index tuple: children are the values; `entry` says for each tuple which child (see
          // Table)
};

enum class Function : std::uint8_t {
  sin,
  cos,
  exp,
  log,     // to the base e, of what is positive
  arcsin,  // −π/2 … π/2
  arccos,  // 0 … π
  arctan,  // −π/2 … π/2
};

/// A place for an index: a literal axis, from 1, or a variable.
struct Slot {
  std::uint8_t axis = 0;  // 0: the variable is meant
  IndexId variable{};
};
[[nodiscard]] constexpr bool same_slot(const Slot& a, const Slot& b) {
  return a.axis == b.axis && (a.axis != 0 || a.variable == b.variable);
}

inline constexpr ParticleId no_particle{0xffffffffu};

struct ExprNode {
  Op op;
  std::uint8_t rank = 0;
  Span span = {};
  const ExprId* first_child = nullptr;
  const Slot* first_slot = nullptr;
  std::uint32_t count = 0;
  std::uint32_t weight = 1;  // of the tree below: nodes as often as they are reached; at most 2^32 - 1
  std::uint32_t slot_count = 0;
  SymbolId symbol{};
  IndexId index{};                    // index_sum
  ParticleId particle = no_particle;  // symbol, particle_sum
  std::int32_t exponent = 0;          // power
  std::uint32_t payload = 0;          // number: text; table: table
  Function function = Function::sin;  // function
  bool spelled_out = false;           // divide: the notes say `\tan x`, `\sinh x`, `\cosh x` or `\tanh x`
  std::uint64_t likeness = 0;         // equal for what `same_expression` calls the same within one tree
  AxisSpaces axes =
      {};  // of the value; `ExprTree::add` finds them, but for a basis vector and a tuple's first one
};

/// A function of index values: `entry[9(i-1)+3(j-1)+(k-1)]` in three dimensions (the last slot runs fastest)
/// names a child.
struct Table {
  std::vector<std::uint8_t> entry;
};

class ExprTree {
 public:
  SymbolTable symbols;

  IndexId add_index(std::string name, Space space = common_space);
  ParticleId add_particle(std::string name);
  [[nodiscard]] const std::string& name(IndexId id) const {
    return index_names_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] Space space(IndexId id) const { return index_spaces_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const std::string& name(ParticleId id) const {
    return particle_names_[static_cast<std::size_t>(id)];
  }

  /// Adds a node; rank, children and slots are checked against the table at Op (a violation is our own bug).
  ExprId add(ExprNode node, std::span<const ExprId> children = {}, std::span<const Slot> slots = {});
  ExprId add_number(Span span, std::string digits);
  ExprId add_table(Span span, std::span<const ExprId> values, std::span<const Slot> slots, Table table);

  [[nodiscard]] const ExprNode& operator[](ExprId id) const { return nodes_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] std::span<const ExprId> children(ExprId id) const {
    return {(*this)[id].first_child, (*this)[id].count};
  }
  [[nodiscard]] std::span<const Slot> slots(ExprId id) const {
    return {(*this)[id].first_slot, (*this)[id].slot_count};
  }
  [[nodiscard]] const std::string& digits(ExprId id) const;
  [[nodiscard]] const Table& table(ExprId id) const;
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] std::size_t index_count() const { return index_names_.size(); }
  [[nodiscard]] std::size_t particle_count() const { return particle_names_.size(); }
  [[nodiscard]] bool is_zero_literal(ExprId id) const;

 private:
  ExprId append(ExprNode node, std::span<const ExprId> children, std::span<const Slot> slots);
  [[nodiscard]] AxisSpaces axes_of(const ExprNode& node, std::span<const ExprId> children,
                                   std::span<const Slot> slots) const;
  void check_slot(const Slot& slot, Space of) const;
  [[nodiscard]] std::uint64_t likeness_of(const ExprNode& node) const;

  SharedArray<ExprNode> nodes_;
  SharedSpans<ExprId> children_;
  SharedSpans<Slot> slots_;
  SharedArray<std::string> numbers_;
  SharedArray<Table> tables_;
  SharedArray<std::string> index_names_;
  SharedArray<Space> index_spaces_;
  SharedArray<std::string> particle_names_;
};

/// How many components its value has.
[[nodiscard]] inline std::size_t component_count(const ExprNode& node) {
  return component_count(node.rank, node.axes);
}

/// Does the whole expression belong to the common space of three dimensions?
[[nodiscard]] bool is_of_common_space(const ExprTree& tree, ExprId root);

/// Some roots and all that stands below them: each node once, before its children, and these from the left.
[[nodiscard]] std::vector<ExprId> nodes_below(const ExprTree& tree, std::vector<ExprId> roots);

/// Does it name an axis: by a basis vector, or by a component with a number?
[[nodiscard]] bool names_an_axis(const ExprTree& tree, ExprId root);
/// Does i or a complex symbol occur in it? What has neither is real. Definitions are not unfolded.
[[nodiscard]] bool has_complex_numbers(const ExprTree& tree, ExprId root);
/// Does an operator occur in it? Then its products keep their order, which only `algebra/words` knows.
/// Definitions are not unfolded.
[[nodiscard]] bool has_operators(const ExprTree& tree, ExprId root);
/// The symbols below a node, in order of first occurrence, each once. Definitions are not unfolded.
[[nodiscard]] std::vector<SymbolId> symbols_in(const ExprTree& tree, ExprId root);

/// The symbols below some roots, and below what `body_of` says that they are defined as (an optional ExprId);
/// each once.
template <class BodyOf>
[[nodiscard]] std::vector<SymbolId> symbols_reached(const ExprTree& tree, std::vector<ExprId> roots,
                                                    const BodyOf& body_of) {
  std::vector<SymbolId> reached;
  std::set<SymbolId> seen;
  while (!roots.empty()) {
    const ExprId root = roots.back();
    roots.pop_back();
    for (const SymbolId symbol : symbols_in(tree, root)) {
      if (!seen.insert(symbol).second) continue;
      reached.push_back(symbol);
      if (const std::optional<ExprId> body = body_of(symbol)) roots.push_back(*body);
    }
  }
  return reached;
}

/// An S-expression for `--debug expr` and for tests, e.g. `(dot A (cross B C))`. A symbol shows its particle
/// in braces and its slots in brackets: `r{\alpha}[i]`, `I[1,j]`.
[[nodiscard]] std::string dump(const ExprTree& tree, ExprId root);

}  // namespace rigor
