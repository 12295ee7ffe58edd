// SPDX-License-Identifier: GPL-3.0-or-later
// Rigor as a library: checks equations out of a C++ program, such as a test. C++17 and later.
//
//   rigor::CheckedStep checked = rigor::step("\\mathbf{A}\\times\\mathbf{B} =
//   -\\mathbf{B}\\times\\mathbf{A}"); checked.verdict == rigor::StepVerdict::proved
//
// Nothing here throws for anything that is written in a statement or in notes; what is thrown is a
// std::exception, for want of memory or for an error of Rigor itself. Calls from several threads wait for
// each other.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#if defined(__GNUC__)
#define RIGOR_API __attribute__((visibility("default")))
#else
#define RIGOR_API
#endif

namespace rigor {

/// What is known of a step: as docs/trust.md has it.
enum class StepVerdict {
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

/// `proved`, `not-understood`, ...: as in the JSON.
RIGOR_API std::string_view name_of(StepVerdict verdict);

/// One relation, and what became of it. Mathematics is LaTeX in the author's notation.
struct CheckedStep {
  StepVerdict verdict = StepVerdict::not_understood;
  bool holds = false;   // proved, or given, defined, a law, skipped, or refuted where the notes expect that;
                        // and nothing is wrong with it or with its context
  std::string file;     // where it stands: a path; `<statement>.tex` for a text in memory
  unsigned line = 1;    // from 1
  unsigned column = 1;  // from 1, in code points
  std::string tag;      // as written; empty: none
  std::string statement;             // as written, blanks folded
  std::string route;                 // how it was decided
  std::vector<std::string> uses;     // the definitions, assumptions and conventions that this rests on
  std::string sample;                // of a refuted step: exact values on which the sides differ; else empty
  std::vector<std::string> repairs;  // true statements near by, each proved, the nearest first
  std::vector<std::string> conditions;  // under which a refuted step holds
  std::string message;  // what `rigor check` says: places, samples, what is true; empty if nothing is wrong
};

/// Some notes, and what became of each step.
struct CheckedNotes {
  std::string file;
  bool readable = false;
  bool all_hold = false;           // each step holds, and nothing else is wrong in the notes
  std::vector<CheckedStep> steps;  // in the order of the notes
  std::string message;             // what is said of all that does not hold, and of no step
};

/// How notes are read.
struct NotesOptions {
  std::string sidecar = {};  // directives next to the notes; empty: `NAME.rigor`, if there is one
  bool strict = false;       // warnings count as errors
};

/// Checks one statement, as it would be in a display. `context` is LaTeX that is before it: directives
/// (`% rigor: given ...`), macros, definitions in displays. A chain is as bad as its worst step: it is proved
/// if all its steps are, and refuted if one is. What is wrong with the context is part of the answer.
RIGOR_API CheckedStep step(std::string_view statement, std::string_view context = {});

/// Checks a file of notes, LaTeX or Markdown.
RIGOR_API CheckedNotes notes(const std::string& path, const NotesOptions& options = {});

/// The statement, its verdict and the message.
RIGOR_API std::ostream& operator<<(std::ostream& out, const CheckedStep& checked);
RIGOR_API std::ostream& operator<<(std::ostream& out, const CheckedNotes& checked);

}  // namespace rigor
