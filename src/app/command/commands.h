// SPDX-License-Identifier: GPL-3.0-or-later
// What each command does, behind its command line; the code is the exit code.
#pragma once

#include <istream>
#include <ostream>

#include "app/grammar/command_line.h"

namespace rigor {

// --- cases.cpp: `rigor cases` and `rigor case`: what test runners call, once for all steps of some notes
// and then for each.

/// Checks the notes once and writes what became of each step; the code says only whether that was possible.
[[nodiscard]] ExitCode write_cases(const CasesCommand& command, std::ostream& out, std::ostream& err);

/// One of them: prints it, and its code is that of a check of this step alone.
[[nodiscard]] ExitCode tell_case(const CaseCommand& command, std::ostream& out, std::ostream& err);

// --- check_command.cpp: `rigor check`: files to verdicts, in this process or in several, and verdicts to
// the format that was asked for.

/// The exit code. Progress, `--debug` and what is the matter with a cache go to `err`.
[[nodiscard]] ExitCode check_notes(const CheckCommand& command, std::istream& in, std::ostream& out,
                                   std::ostream& err);

// --- explain.cpp: `rigor explain`: the small steps between the forms of a chain.

/// The code: wrong if something is refuted that was not expected to be, or a place is unknown; open if a step
/// has a gap; ok if all steps are explained. What is no file and has a relation in it is a statement.
[[nodiscard]] ExitCode explain_chains(const ExplainCommand& command, std::ostream& out, std::ostream& err);

// --- forms.cpp: `rigor eval` and `rigor bench`: the written forms of some notes in floating point.

[[nodiscard]] ExitCode evaluate_forms(const EvalCommand& command, std::ostream& out, std::ostream& err);
[[nodiscard]] ExitCode bench_forms(const BenchCommand& command, std::ostream& out, std::ostream& err);

// --- read.cpp: `rigor read`: how each row of some notes was read.

/// The code: wrong if a place is unknown, open if a row that is asked for is not read.
[[nodiscard]] ExitCode show_reading(const ReadCommand& command, std::ostream& out, std::ostream& err);

// --- replay.cpp: `rigor replay REPORT.json`: puts the samples of a report into the notes that it was made
// from.

/// The exit code. Paths in the report are those of the working directory; a relative one that is not there is
/// looked for next to the report.
[[nodiscard]] ExitCode replay(const ReplayCommand& command, std::ostream& out, std::ostream& err);

// --- report.cpp: `rigor report`: notes with their verdicts as a page and as a LaTeX document.

/// Writes what is asked for; `-` is `out`. The code is that of `rigor check`, or no_input if a file cannot be
/// read or written.
[[nodiscard]] ExitCode write_reports(const ReportCommand& command, std::ostream& out, std::ostream& err);

// --- suggest.cpp: `rigor suggest`: directives that would settle open rows, shown and perhaps written.

/// The code says only whether the notes could be read and the sidecar written.
[[nodiscard]] ExitCode suggest_lines(const SuggestCommand& command, std::ostream& out, std::ostream& err);

}  // namespace rigor
