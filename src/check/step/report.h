// SPDX-License-Identifier: GPL-3.0-or-later
// The answer for a set of files: what every reporter prints.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

/// `law`: read whole, meant for some values only, and it follows from nothing that stands here. `suspect`: it
/// does not follow, and one slip of the pen away stands something that does.
enum class Verdict : std::uint8_t {
  proved,
  refuted,
  given,
  definition,
  undecided,
  not_understood,
  skipped,
  law,
  suspect
};
inline constexpr std::size_t verdict_count = 9;

/// `not-understood` and so on: as in the JSON.
[[nodiscard]] std::string_view name_of(Verdict verdict);

/// An exact sample on which a step's sides differ, in the notes' own symbols.
struct Counterexample {
  struct Value {
    std::string symbol;          // LaTeX: `\mathbf{r}_{\alpha}`
    std::uint32_t particle = 0;  // from 1; 0: no particle label
    int rank = 0;
    std::vector<std::string> components;  // exact, row by row
    bool beyond = false;  // a derivative that only derivatives of assumptions speak of: not printed
  };
  struct Axis {
    std::string index;  // `i`; empty for an axis of a vector equation
    int value = 0;      // 1..3; in space-time 0..3
  };
  std::uint32_t particles = 0;
  std::vector<Value> values;
  std::vector<Axis> component;
  std::string left;
  std::string right;
  std::vector<Value> follows = {};  // what the values make of the defined symbols that are in the step
  bool squared_distance = false;  // `left` is |left − right|², of vectors or tensors that are to be unequal
};

/// Where a refuted step is in its chain of equalities. Steps count from 0.
struct ChainPlace {
  bool first_wrong = false;    // what comes before holds, or was put right again
  bool undoes = false;         // it takes back the slip of the first wrong step
  bool stays = false;          // of a first wrong step: its slip is there at the end of the chain
  std::size_t first_step = 0;  // of a later step: the first wrong one
  std::optional<std::size_t> undone_at = {};  // of a first wrong step: the one that takes its slip back
};

/// A true statement near one that is wrong, or a statement that follows near one that is left open.
struct Repair {
  bool on_left = false;                // which side is changed
  std::string statement;               // LaTeX of the whole step, in the author's notation
  std::string change;                  // in words
  std::string replaced = {};           // the changed side as it was read, blanks folded, macros replaced
  std::string replacement = {};        // the same side of the statement
  bool adds_a_term = false;            // rather than changing what is there
  std::vector<std::string> uses = {};  // near an open step: what it follows from
};

/// `law (3)`, or without a tag `law in line 12`, where its relation stands.
[[nodiscard]] std::string name_of_law(const std::string& tag, Span relation, const SourceMap& sources,
                                      std::string_view word);

/// Diagnostics that are mended by a true statement near by: a refutation, indices or ranks that do not fit.
[[nodiscard]] bool shows_repairs(DiagnosticKind kind);

/// One relation of one chain.
struct Step {
  Span span;  // the relation and both its sides
  Span relation_span;
  std::string tag;
  std::string label;
  std::string section;
  std::string source;  // the step as written, blanks folded
  std::string left;
  std::string relation;
  std::string right;
  Verdict verdict = Verdict::not_understood;
  bool expected_refuted = false;  // a directive says that the step is false, or suspected
  bool measures = false;          // proved: the numbers of the page give the number that it shows
  bool restates = false;          // of a law: it says again what another one says
  std::string route;
  std::vector<std::string> uses;  // definitions, assumptions, conventions: `definition I_{ij} (8)`
  std::optional<Counterexample> counterexample;
  std::optional<ChainPlace> chain;      // of a refuted step, if the chain has other steps
  std::vector<Repair> repairs;          // of a wrong or an open step, the nearest first; at most three
  std::vector<std::string> conditions;  // under which a refuted step would hold, as LaTeX; at most two
  double repair_milliseconds = 0.0;     // the time that was taken to find them
  Diagnostics diagnostics;
  double milliseconds = 0.0;
  std::uint64_t work =
      0;  // units (`algebra/engine/budget.h`) for its verdict or for what helps, whichever took more
};

/// What was found of one symbol's dimension.
struct SymbolDimension {
  std::string symbol;                    // LaTeX, with letters for its indices: `I_{ij}`, `m_\alpha`
  std::optional<std::string> dimension;  // `M L^2 T^{-1}`; nothing: it is free
};

using Counts = std::array<std::uint32_t, verdict_count>;

/// How often a memory of earlier decisions was asked, and what was the matter with it.
struct CacheUse {
  std::uint32_t asked = 0;
  std::uint32_t reused = 0;
  std::string trouble = {};  // why it could not be read or written; empty: nothing
};

struct FileReport {
  std::string path;
  FileId file = 0;
  std::string sidecar = {};  // a path; empty: there is none
  bool unreadable = false;
  std::vector<Step> steps;
  Diagnostics diagnostics;                  // those of no single step
  Diagnostics silenced;                     // warnings that an `allow` keeps out of all others
  std::vector<SymbolDimension> dimensions;  // the time first, others as first met
  Counts counts{};
  std::vector<Span> displays = {};  // those that were found, delimiters included, in the order of the notes
  std::string failure = {};         // of rigor itself: then the file was not checked to its end
  std::optional<CacheUse> cache = {};  // where decisions are remembered
};

struct Report {
  std::vector<FileReport> files;
  Counts counts{};
  double milliseconds = 0.0;
};

/// What the whole run amounts to, worst first.
struct Tally {
  bool failed = false;  // rigor itself
  bool unreadable = false;
  bool wrong = false;  // refuted (unless expected), proved where a refutation was expected, or malformed
  bool open = false;   // undecided or not understood
};
[[nodiscard]] Tally tally(const Report& report, bool strict);

}  // namespace rigor
