// SPDX-License-Identifier: GPL-3.0-or-later
// What the statements of one file say of dimensions. `dimensions.h` solves it.
#pragma once

#include <string>
#include <vector>

#include "check/dimension/dimension_form.h"
#include "check/ledger/ledger.h"
#include "check/step/report.h"

namespace rigor {

/// How a statement entered.
enum class DimensionSource : std::uint8_t {
  law,    // a display, or by `let` or `given`: what it says about dimensions holds for the whole file
  local,  // by `where` or `claim`: its letters can mean something else elsewhere
};

struct DimensionStatement {
  std::size_t step = 0;  // in the report
  DimensionSource source = DimensionSource::law;
  Span span;                                 // of both sides, where they are written
  std::vector<DimensionEquation> equations;  // the last one compares the sides, if they are compared
  std::vector<std::size_t> assumed = {};     // the statements of the `where`s in force
};

/// One line of `units`, for one symbol.
struct DeclaredUnit {
  DimensionForm symbol;
  Dimension dimension;
  Span span;
  std::size_t directive = 0;
  bool used = false;  // by a statement
};

/// Whose dimension an unknown is.
struct UnknownName {
  std::string text;     // LaTeX; empty: of no symbol
  bool listed = false;  // in the table of dimensions
};

struct DimensionRecord {
  std::vector<UnknownName> unknowns;
  std::vector<DeclaredUnit> units;
  std::vector<DimensionEquation> facts;  // that belong to no statement
  std::vector<DimensionStatement> statements;
};

inline constexpr Unknown time_unknown = 0;
inline constexpr Unknown space_unknown = 1;

/// What the ledger's statements and `units` lines say. All verdicts are known: what a name stood for before
/// it got another meaning is another quantity. A statement whose letters are only guessed says nothing.
[[nodiscard]] DimensionRecord record_dimensions(const Ledger& ledger, const SyntaxTree& syntax,
                                                const FileReport& report);

}  // namespace rigor
