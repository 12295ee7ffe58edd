// SPDX-License-Identifier: GPL-3.0-or-later
// How one row of the notes was read. Nothing here is a verdict.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/step/report.h"
#include "latex/token/syntax.h"
#include "source/diagnostic.h"

namespace rigor {

/// What a row is to those around it.
enum class RowRole : std::uint8_t {
  unread,         // it is not read whole, and says nothing
  skipped,        // by a directive
  definition,     // it says what its left side is
  given,          // by a directive: it is assumed
  condition,      // of the equation next to it
  approximation,  // ≈, or an order: it is compared to some order, or to the digits shown
  identity,       // it reads as meant for all values
  law,            // it is meant for some values, and stated
  conclusion,     // it is meant for some values, and announced as a conclusion
};

/// `law` and so on: as in the JSON.
[[nodiscard]] std::string_view name_of(RowRole role);

enum class LetterKind : std::uint8_t {
  scalar,
  vector,
  unit_vector,
  tensor,
  symmetric_tensor,
  rotation,
  function_value,
  measure_unit,
  index,
  particle,
};

/// `unit vector` and so on.
[[nodiscard]] std::string_view name_of(LetterKind kind);

/// `face`: bold, under an arrow or a hat. `first`: where it stands first.
enum class SourceKind : std::uint8_t { directive, definition, words, face, indexed, first };

/// `definition` and so on: as in the JSON.
[[nodiscard]] std::string_view name_of(SourceKind kind);

/// What says what a letter is.
struct LetterSource {
  SourceKind kind = SourceKind::first;
  std::string text = {};  // of the directive, the definition or the words
  Span span = {};
};

struct ReadLetter {
  std::string name;  // LaTeX
  LetterKind kind = LetterKind::scalar;
  int rank = 0;
  bool per_particle = false;
  bool constant = false;  // a directive or a definition says so
  bool small = false;
  bool for_all = false;
  bool field = false;     // it depends on the place
  bool has_rate = false;  // the row differentiates it by the time
  bool ordered = false;   // the section may mean a matrix or an operator
  bool complex = false;   // the section may mean a complex number
  bool summed = false;    // an index or a particle: bound by a sum
  bool repeated = false;  // and the sum is not written, since the letter stands twice in a term
  std::vector<LetterSource> sources = {};
};

/// What a row would be proved from.
struct Ground {
  enum class Kind : std::uint8_t { definition, given, said, law, conclusion };
  Kind kind = Kind::law;
  std::string name;            // as `uses` has it: `definition v (8)`, `law in line 12`
  std::string statement = {};  // LaTeX
};

[[nodiscard]] std::string_view name_of(Ground::Kind kind);

struct ReadRow {
  std::size_t step = 0;  // of the report: its place, tag and source, and why it is not read
  std::vector<std::string> headings = {};
  std::size_t link = 1;  // of its chain
  std::size_t links = 1;
  bool cyclic = false;  // it is said for its cyclic images, too
  RowRole role = RowRole::unread;
  std::string announced = {};              // by which word, in its sentence
  bool inferred = false;                   // an arrow is before it
  std::vector<std::string> for_some = {};  // of a law: the letters that it is not meant for all values of
  std::string statement = {};              // LaTeX, with all its sums; empty: it is not read
  std::vector<ReadLetter> letters = {};
  std::vector<std::string> conventions = {};
  std::optional<Obstacle> open = {};         // what could be read in another way
  std::vector<std::string> restricted = {};  // words and conditions next to it
  std::vector<Ground> grounds = {};
};

/// Of one file.
struct NotesReading {
  FileReport report;  // verdicts and counts in it are not those of a check
  std::vector<ReadRow> rows = {};
};

}  // namespace rigor
