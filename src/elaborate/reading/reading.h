// SPDX-License-Identifier: GPL-3.0-or-later
// The state of reading one statement. This file only stores, so that each notation can be a file of free
// functions (in this room and those above it) and no class knows them all.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "elaborate/name/letters.h"
#include "elaborate/name/names.h"
#include "elaborate/reading/typed.h"
#include "expr/calculus/differentiate.h"
#include "latex/token/syntax.h"
#include "source/diagnostic.h"

namespace rigor {

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

/// A bracket that can be a factor or the argument of a function.
enum class OpenBracket : std::uint8_t {
  refused,
  factor,
  argument,
};

/// How a statement is read where the plain reading is not what is meant.
struct ReadingRules {
  bool no_sum = false;                  // "(no sum)": no letter is summed but under an explicit sign
  std::set<std::string> unsummed = {};  // nor are these
  bool primes_on_axes = false;          // i' and i are one letter; the prime only says along which axes
  bool dots_on_vectors = false;         // \dot r of the length r is |\dot{\mathbf r}|
  bool differentials = false;           // each term has one: `dU = T\,dS - p\,dV`
  bool divides_by_all = false;          // all that follows a slash: `e^2/4\pi\varepsilon_0`
  bool apart = false;                   // what can belong to a vector of this letter is a symbol of its own
  bool lengths_of_other_sections = false;  // v beside a \mathbf v that another section defines
  OpenBracket open = OpenBracket::refused;
  std::optional<HoleShape> hole = {};  // nothing: a hole is not read
};

/// What is around the part that is read. It is handed down, and kept nowhere.
struct Around {
  std::span<const FreeIndex> slots = {};          // letters of the left side, for cases on the right
  std::map<std::string, std::uint8_t> axes = {};  // a determinant's letters, which stand for one axis each
  std::optional<ParticleId> body_point = {};      // of an integral over the body
  bool squared = false;                           // the part is a symbol, and the exponent 2 is on it
};

/// All sides of the statement share their free letters, and what one side says about a letter holds for all.
/// The objects referred to outlive it.
struct Reading {
  const SyntaxTree& syntax;
  ExprTree& tree;
  Names& names;
  Letters letters;
  Diagnostics& diagnostics;
  ReadingRules rules = {};

  /// What the letters of one kind stand for.
  template <typename Id>
  struct Variables {
    std::map<std::string, Id> free = {};                 // shared by all sides
    std::map<std::string, std::vector<Id>> summed = {};  // by a written Σ, the innermost last
  };
  Variables<IndexId> indices = {};
  Variables<ParticleId> particles = {};
  std::vector<std::string> counting = {};  // letters that sums around the part run through whole numbers

  /// What the statement says apart from its meaning.
  struct Found {
    std::vector<std::string> conventions;  // that were needed: "`A` is the length of `\mathbf{A}`"
    std::set<std::string> summed_letters;  // because they stand twice
    std::vector<Hole> holes;               // in the order in which they were read
    std::optional<Span> dotted_length;     // \dot r, squared, where r is the length of a particle's vector
    std::optional<std::string> region;     // of its integrals
    bool values = false;                   // it has values of functions: `V(r_0)`, a symbol of its own
    std::optional<SymbolId> integrated;    // the variable of its last integral
    std::optional<Span> dyad;              // bold letters side by side, which may be matrices
    std::optional<Obstacle> guess;         // see guess_of()
    std::optional<Obstacle> belongs;  // a letter was taken for a part of a vector: see ReadingRules::apart
    bool may_be_length = false;       // as `ReadingRules::lengths_of_other_sections` would read it
    std::optional<Obstacle> applied;  // a bracket can be a factor or an argument: see OpenBracket
    bool applied_elsewhere =
        false;  // it looks like a factor, but the section writes the letter as a function
    std::vector<SymbolId> unknown_changes;  // differentiated though nothing says whether they change: such a
                                            // statement may be proved, never refuted
    std::set<std::string> positions;        // the ways in which it writes the position
    Directives used;                        // what was looked up is said by these
    bool differentiates_position = false;
    bool triples = false;  // it has `\sigma_i` or `\boldsymbol\sigma`, which are matrices
    std::optional<std::string> index_of_all =
        {};                 // i of `S_i = \frac\hbar2\sigma_i`, which defines all three
    bool matrices = false;  // what does not fit may be another matrix than was read: no mistake for sure
    bool differentiates_logarithm = false;  // whose derivative has values where it has none itself
  } found = {};

  struct Derivatives {
    Derivatives() = default;
    Derivatives(const Derivatives&) = delete;  // the differentiators refer to the reading
    Derivatives& operator=(const Derivatives&) = delete;
    DerivativeBudget budget;  // used up inside a part: `elaborate` of that part fails
    std::map<std::tuple<Variable, bool, std::uint8_t, IndexId>, Differentiator>
        by;  // each with what it knows
  } derivatives = {};
};

/// A reading that nothing but the statement itself suggests: such a statement may be proved, never refuted.
[[nodiscard]] std::optional<Obstacle> guess_of(const Reading& reading);
/// The same without guesses that leave one other reading.
[[nodiscard]] std::optional<Obstacle> lasting_guess_of(const Reading& reading);
void note(Reading& reading, std::string convention);
/// Of x, y, z, the vector r and the vector x, any one can be the position; nothing says how two of them are
/// related.
void note_position(Reading& reading, SymbolId symbol);

/// The symbol of a key; the directive that declares it is used.
SymbolId symbol_named(Reading& reading, const NameKey& key, const std::string& name, Span span);
/// How a symbol changes; the directive that says so is used.
[[nodiscard]] Dependence change_of(Reading& reading, SymbolId symbol, const Variable& by);

/// The space that vectors, tensors and indices belong to here; the directive that says so is used.
Space use_space(Reading& reading);

/// The variable of a letter: of the innermost written sum over it, else of the statement.
[[nodiscard]] IndexId index_named(Reading& reading, const std::string& letter);
[[nodiscard]] IndexId index_named(Reading& reading, const std::string& letter, Space space);
[[nodiscard]] ParticleId particle_named(Reading& reading, const std::string& letter);

[[nodiscard]] inline Obstacle unread(std::string message, std::vector<std::string> help = {}) {
  return {DiagnosticKind::unsupported, std::move(message), std::move(help)};
}

/// A diagnostic, and nothing.
inline std::nullopt_t fail(Reading& reading, DiagnosticKind kind, Span span, std::string message,
                           std::vector<std::string> help = {}) {
  report(reading.diagnostics, kind, span, std::move(message), std::move(help));
  return std::nullopt;
}
inline std::nullopt_t fail(Reading& reading, Span span, const Obstacle& obstacle) {
  return fail(reading, obstacle.kind, span, obstacle.message, obstacle.help);
}
inline std::nullopt_t unsupported(Reading& reading, Span span, std::string message,
                                  std::vector<std::string> help = {}) {
  return fail(reading, DiagnosticKind::unsupported, span, std::move(message), std::move(help));
}
inline std::nullopt_t ambiguous(Reading& reading, Span span, std::string message,
                                std::vector<std::string> help = {}) {
  return fail(reading, DiagnosticKind::ambiguous_reading, span, std::move(message), std::move(help));
}
/// What is no vector or tensor may be a matrix or a column beside others.
[[nodiscard]] inline DiagnosticKind kind_of_mismatch(const Reading& reading) {
  return reading.found.matrices ? DiagnosticKind::unsupported : DiagnosticKind::rank_mismatch;
}
inline std::nullopt_t wrong_rank(Reading& reading, Span span, std::string message,
                                 std::vector<std::string> help = {}) {
  return fail(reading, kind_of_mismatch(reading), span, std::move(message), std::move(help));
}

}  // namespace rigor
