// SPDX-License-Identifier: GPL-3.0-or-later
// From what was written to what is meant, one statement at a time: names, kinds, index sums, vector products.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "elaborate/name/letters.h"
#include "elaborate/name/names.h"
#include "expr/calculus/differentiate.h"
#include "expr/tree/tree.h"
#include "latex/token/syntax.h"
#include "latex/token/vocabulary.h"
#include "source/diagnostic.h"

namespace rigor {

/// An index letter that no sum has bound yet, and where it stands.
struct FreeIndex {
  std::string letter;
  IndexId id{};
  Span span;
  bool rides = false;  // on a principal value `I_i`, which is not counted as an occurrence
};

struct FreeParticle {
  std::string letter;
  ParticleId id{};
  Span span;
};

/// An expression with what its type says.
struct Typed {
  ExprId id{};
  int rank = 0;
  std::vector<FreeIndex> free;          // each letter once
  std::vector<FreeParticle> particles;  // each letter once
  std::vector<FreeIndex> bound;         // letters summed inside
};

/// What a hole is taken for: a whole of a rank, or of rank 0 a component with letters and particles.
struct HoleShape {
  int rank = 0;
  std::vector<std::string> letters = {};
  std::vector<std::string> particles = {};  // at most one
};

/// A hole that was read: a symbol of its own, which belongs to no name.
struct Hole {
  SymbolId symbol{};
  Span span;
};

/// How a statement is read where the plain reading is not what is meant.
struct Reading {
  bool no_sum = false;                  // "(no sum)": no letter is summed but under an explicit sign
  std::set<std::string> unsummed = {};  // nor are these
  bool primes_on_axes = false;          // i' and i are one letter; the prime only says along which axes
  bool dots_on_vectors = false;         // \dot r of the length r is |\dot{\mathbf r}|
  std::optional<HoleShape> hole = {};   // nothing: a hole is not read
};

/// Elaborates the sides of one statement (all sides share their free letters). A side with a mistake gives
/// nothing and a diagnostic for each mistake found. Recursion is bounded by the parser's `max_nesting`, that
/// of derivatives by their budget.
class Elaborator {
 public:
  Elaborator(const SyntaxTree& syntax, ExprTree& tree, Names& names, Letters letters,
             Diagnostics& diagnostics, Reading reading = {});
  Elaborator(const Elaborator&) = delete;
  Elaborator& operator=(const Elaborator&) = delete;

  std::optional<Typed> expression(SyntaxId id);
  /// The derivative of an expression that is elaborated already, by the time.
  Typed rate_of(Typed typed, int times = 1, bool partial = false);

  /// Where a mismatch between sides is shown, and who is told.
  struct Mismatch {
    Span relation;
    Diagnostics& diagnostics;
  };
  /// The equation left = right, with rank and free indices compared; a literal 0 fits everything.
  std::optional<Equation> equation(const Typed& left, const Typed& right, Mismatch mismatch);

  /// Index letters of the left side, in order, for a definition by cases on the right.
  void expect_slots(const std::vector<FreeIndex>& letters) { slot_letters_ = letters; }

  /// Conventions that were needed to read the statement: "`A` is the length of `\mathbf{A}`".
  [[nodiscard]] const std::vector<std::string>& conventions() const { return conventions_; }
  /// A reading that nothing but the statement itself suggests: such a statement may be proved, never refuted.
  [[nodiscard]] std::optional<Obstacle> guess() const;
  /// Symbols that were differentiated though nothing says whether they change: such a statement may be
  /// proved, never refuted.
  [[nodiscard]] const std::vector<SymbolId>& unknown_changes() const { return unknown_changes_; }
  /// Letters that were summed because they stand twice.
  [[nodiscard]] const std::set<std::string>& summed_letters() const { return summed_letters_; }
  /// In the order in which they were read.
  [[nodiscard]] const std::vector<Hole>& holes() const { return holes_; }
  [[nodiscard]] bool has_dotted_length() const { return dotted_length_.has_value(); }
  [[nodiscard]] Span dotted_length() const { return *dotted_length_; }

 private:
  using Maybe = std::optional<Typed>;

  Maybe fail(DiagnosticKind kind, Span span, std::string message, std::vector<std::string> help = {});
  Maybe unsupported(Span span, std::string message, std::vector<std::string> help = {}) {
    return fail(DiagnosticKind::unsupported, span, std::move(message), std::move(help));
  }
  void note(std::string convention);
  ExprId zero_of(const Typed& written, int rank);

  // elaborate_symbol.cpp
  Maybe symbol(const WrittenSymbol& written, Span span);
  Maybe special_symbol(const WrittenSymbol& written, Span span, bool& handled);
  Maybe basis_vector(Span span, Slot slot, std::vector<FreeIndex> free);
  Maybe unit_tensor(const WrittenSymbol& written, Span span);
  Maybe vector_symbol(const WrittenSymbol& written, WrittenName name, Span span);
  Maybe plain_symbol(const WrittenSymbol& written, WrittenName name, Span span);
  Maybe length_or_scalar(const WrittenSymbol& written, const WrittenName& name, Span span);
  Maybe make_symbol(const WrittenSymbol& written, const std::string& base, int rank, const WrittenName& name,
                    const std::vector<WrittenIndex>& axes, Span span);
  bool read_slots(const std::vector<WrittenIndex>& axes, std::vector<Slot>& slots,
                  std::vector<FreeIndex>& free);
  void guess_vector(const WrittenName& name, bool as_length);
  bool is_known(const std::string& base, int rank, bool per_particle) const;

  // elaborate_hole.cpp
  Maybe hole(const WrittenSymbol& written, Span span);
  [[nodiscard]] std::string letter_key(const WrittenIndex& axis) const;
  [[nodiscard]] bool is_varying_in_body(const WrittenName& name, int rank, Span span, bool& known);

  // elaborate_axes.cpp
  static bool any_primed(const std::vector<WrittenIndex>& axes);
  std::optional<SymbolId> primed_axes(Span span);
  Maybe along_axes(Typed whole, const std::vector<WrittenIndex>& axes, Span span);
  Maybe direction_cosine(const ExprNode& node, const std::vector<WrittenIndex>& axes, Typed typed, Span span);
  Maybe primed_basis_vector(const WrittenIndex& axis, Span span);
  bool primed_twice(const std::vector<WrittenIndex>& axes, Span span);
  Maybe axis_direction(SyntaxId id, bool& is_axis);
  Maybe angle_cosine(SyntaxId first, SyntaxId second, Span span);
  const Frame* frame_of(const std::string& label) const;
  Maybe frame_derivative(SyntaxId id, const Frame& frame, bool fixed);

  // elaborate_change.cpp
  Maybe rate(const WrittenSymbol& written, Span span);
  [[nodiscard]] bool hides_small_factor(const WrittenSymbol& written, const WrittenName& name) const;
  Maybe derivative(SyntaxId id);
  Maybe by_coordinate(Typed operand, const WrittenSymbol& variable, Span span);
  bool depends_on_other_coordinate(const Typed& operand, const WrittenSymbol& variable, Span span);
  void note_position(SymbolId symbol);
  std::string position_name(SymbolId symbol) const;
  Differentiator& differentiator(By by, Slot axis = {}, bool partial = false);
  bool frame_is_open(const Typed& typed, Span span);
  bool is_total_rate_of_field(const Typed& typed, Span span);
  [[nodiscard]] bool reaches_place(ExprId id) const;
  std::optional<Typed> with_places_open(Typed typed, Span span);
  const WrittenSymbol& nabla_of(SyntaxId id) const;
  Maybe apply_operator(std::span<const SyntaxChild> factors, std::size_t at, std::size_t& next);
  Maybe material_rate(SyntaxId operand, Span span);
  Maybe apply_nabla(FieldOperator what, const Typed& operand, Span span);
  Maybe directional(const Typed& along, const Typed& operand, Span span);
  ExprId partial(ExprId id, std::uint8_t axis);
  ExprId at_axis(ExprId id, std::uint8_t axis);
  ExprId sum_of(std::vector<ExprId> terms, int rank, Span span);

  // elaborate_function.cpp
  Maybe function(SyntaxId id);
  Maybe elementary(const std::string& name, const Typed& argument, Span span);
  Maybe trace_or_determinant(SyntaxId id, bool trace);
  Maybe whole_tensor(SyntaxId id);
  Maybe determinant_of(SyntaxId id, const Typed& inside, Span span);
  Maybe integral(SyntaxId id);

  Maybe contract(Typed typed);  // repeated letters on one symbol: `I_{ii}`

  // elaborate_unit.cpp
  Maybe unit(SyntaxId id);
  ExprId base_unit(std::size_t which, Span span);

  // elaborate_term.cpp
  Maybe term(SyntaxId id);
  struct Operand {
    Typed typed;
    Joint joint;
    Span joint_span;
  };
  bool reads_as_application(std::span<const SyntaxChild> factors);
  [[nodiscard]] bool applies_elsewhere(SyntaxId symbol, SyntaxId bracket) const;
  bool looks_like_argument(const WrittenSymbol& symbol, SyntaxId bracket) const;
  [[nodiscard]] bool is_declared_letter(const WrittenSymbol& symbol) const;
  bool repeats_greek(std::span<const SyntaxChild> factors);
  bool runs_numbers_together(std::span<const SyntaxChild> factors);
  void guess_dyad(const std::vector<Operand>& vectors, Span span);
  Maybe divide(const Typed& dividend, const Typed& divisor, Span span);
  Maybe with_slashes(std::vector<Operand> operands, Span span);
  Maybe product(std::vector<Operand> operands, Span span);
  bool separate_scalars(const std::vector<Operand>& operands, std::vector<Typed>& scalars,
                        std::vector<Operand>& vectors);
  bool cross_products(std::vector<Operand>& vectors);
  bool dot_products(std::vector<Operand>& vectors);
  Maybe outer_product(std::vector<Typed> scalars, const std::vector<Operand>& vectors, Span span);
  bool is_number(const Typed& typed) const { return tree_[typed.id].op == Op::number; }

  // elaborate_indices.cpp
  bool sum_repeated(const std::vector<Typed>& factors, std::vector<FreeIndex>& to_sum,
                    std::vector<FreeIndex>& free, std::vector<FreeIndex>& bound);
  void note_riding(const std::string& letter, const std::vector<FreeIndex>& where, std::size_t riding);
  void warn_of_bold_index(const WrittenName& name, const std::string& whole, Span span);
  Typed sum_over(Typed body, const std::vector<FreeIndex>& letters);

  // elaborate_sum.cpp
  Maybe sum(SyntaxId id);
  Maybe big_sum(SyntaxId id);
  bool same_type(const Typed& first, const Typed& other, const char* what, Mismatch mismatch) const;

  // elaborate_forms.cpp
  bool is_exponential(SyntaxId id) const;
  bool reads_as_order(SyntaxId id) const;
  Maybe power(SyntaxId id);
  bool names_a_tensor(SyntaxId id) const;
  Maybe bars(SyntaxId id, bool norm);
  bool is_derivative_in_bracket(SyntaxId id) const;
  Maybe component(SyntaxId id);
  bool is_matrix_product(SyntaxId id) const;
  Maybe tuple(SyntaxId id);
  Maybe matrix(SyntaxId id);
  Maybe determinant(SyntaxId id);
  Maybe square_root(SyntaxId id);
  Maybe cases(SyntaxId id);
  std::optional<int> integer(SyntaxId id) const;
  std::optional<int> half_integer(SyntaxId id) const;  // twice the exponent
  Typed make(Op op, Span span, int rank, std::initializer_list<const Typed*> parts, int exponent = 0);

  IndexId index(const std::string& letter);
  ParticleId particle(const std::string& letter);
  bool is_bound_letter(const std::string& letter) const { return bound_indices_.contains(letter); }

  Maybe read(SyntaxId id);

  const SyntaxTree& syntax_;
  ExprTree& tree_;
  Names& names_;
  Letters letters_;
  Diagnostics& diagnostics_;
  Reading reading_;
  std::vector<SymbolId> unknown_changes_;
  DerivativeBudget derivatives_;
  std::map<std::tuple<By, bool, std::uint8_t, IndexId>, Differentiator>
      differentiators_;  // each with what it knows
  std::set<std::string> summed_letters_;
  std::optional<Span> dotted_length_;
  bool squared_ = false;                            // at a symbol with the exponent 2
  std::map<std::string, std::uint8_t> fixed_axes_;  // letters that stand for one axis for now
  std::optional<ParticleId> body_point_;            // inside an integral over the body
  std::map<std::string, IndexId> free_indices_;
  std::map<std::string, std::vector<IndexId>> bound_indices_;  // innermost explicit sum last
  std::map<std::string, std::vector<ParticleId>> bound_particles_;
  std::map<std::string, ParticleId> free_particles_;
  std::vector<FreeIndex> slot_letters_;
  std::vector<std::string> conventions_;
  std::optional<Obstacle> guess_;
  std::vector<Hole> holes_;
  std::set<std::string> positions_;  // the ways in which the statement writes the position
  bool differentiates_position_ = false;
  std::optional<std::string> region_;  // of an integral
  std::optional<Span> dyad_;           // bold letters side by side, which may be matrices
};

/// The union of both lists by letter.
void merge_free(std::vector<FreeIndex>& into, const std::vector<FreeIndex>& from);
void merge_free(std::vector<FreeParticle>& into, const std::vector<FreeParticle>& from);
[[nodiscard]] bool is_literal_zero(const ExprTree& tree, const Typed& typed);

}  // namespace rigor
