// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a value.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/grammar/debug.h"
#include "app/grammar/exit_code.h"
#include "source/diagnostic.h"

namespace rigor {

enum class ColorWhen : std::uint8_t { automatic, always, never };

enum class ReportFormat : std::uint8_t { text, json, junit, sarif, github };

/// `rigor check`: files, folders and `-`, the standard input; a sidecar and marks only with exactly one file.
/// What is left open may be in a settings file.
struct CheckCommand {
  std::vector<std::string> files;
  std::optional<std::string> stdin_name;  // what the standard input is called
  std::optional<std::string> sidecar;
  std::optional<std::string> settings;  // a file
  ReportFormat format = ReportFormat::text;
  std::optional<bool> strict;
  std::optional<std::set<Severity>> fail_on;
  std::optional<std::string> baseline;  // an earlier report
  bool dimensions = false;
  bool all_causes = false;
  std::optional<std::size_t> jobs;  // 0: as many as there are processors
  std::optional<std::uint64_t> effort;
  std::optional<std::string> cache;  // a folder
  std::optional<std::string> marks;  // a file for `rigor.sty`
  ColorWhen color = ColorWhen::automatic;
  std::vector<DebugTopic> debug;
};

/// `rigor replay`: a report made by `rigor check --json`.
struct ReplayCommand {
  std::string report;
  ColorWhen color = ColorWhen::automatic;
};

/// Which of the forms in one file of notes are evaluated, and on what.
struct FormsCommand {
  std::string file;
  std::vector<std::string> bodies;  // names in a `bodies` folder, files, or folders of body files
  std::vector<std::string> places;  // tags or headings; empty: all chains
  std::optional<std::string> sidecar;
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor eval`: value, error, condition and time of each form.
struct EvalCommand {
  FormsCommand forms;
  bool json = false;
  bool times = true;
  std::string values;  // `x = 1e-9, \mathbf{A} = (1, 0, 2)`: the only numbers; empty: families and a search
};

/// `rigor bench`: time against error of all forms in all precisions.
struct BenchCommand {
  FormsCommand forms;
  std::string folder;  // for the pictures and the table; empty: the table goes to the output
};

/// `rigor report`: at least one of the outputs; a sidecar only with exactly one file.
struct ReportCommand {
  std::vector<std::string> files;
  std::optional<std::string> html;   // where to; `-`: the output
  std::optional<std::string> latex;  // the same
  std::optional<std::string> sidecar;
  bool forms = true;  // on the page: evaluate them
};

/// `rigor scene`: the quantities that a scene asks of a body.
struct SceneCommand {
  std::vector<std::string> files;
  bool json = false;
  bool explain = false;
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor cases`: what became of each step, for test runners.
struct CasesCommand {
  std::string file;
  std::string results;                   // to be written
  std::optional<std::string> name = {};  // what the name of each case begins with
  std::optional<std::string> sidecar = {};
  bool strict = false;
  std::optional<std::string> ctest = {};  // a listing to be written
};

/// `rigor case`: one of them.
struct CaseCommand {
  std::string results;
  std::string name;
};

enum class MathFormat : std::uint8_t { text, latex, mathml };

/// `rigor explain`: the derivation between the forms of chains.
struct ExplainCommand {
  std::string file;  // or a statement
  std::optional<std::string> sidecar;
  std::vector<std::string> places;  // tags, headings, labels or line numbers; empty: all chains
  MathFormat format = MathFormat::text;
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor read`: how rows were read.
struct ReadCommand {
  std::string file;
  std::optional<std::string> sidecar;
  std::vector<std::string> places;  // tags, headings, labels or line numbers; empty: all rows
  bool json = false;
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor suggest`: directives that settle open rows.
struct SuggestCommand {
  std::string file;
  std::optional<std::string> sidecar;
  bool write = false;
  std::optional<std::string> into;  // `write`: another sidecar than the one that is read
  bool all = false;                 // also what makes rows refuted, suspect or wrong
  ColorWhen color = ColorWhen::automatic;
};

/// `rigor derive`: the holes of notes, or of one statement.
struct DeriveCommand {
  std::string what;                 // a file, or a statement
  bool is_statement = false;        // what the words say; a file of this name goes first
  std::optional<std::string> in;    // a statement's notes
  std::vector<std::string> places;  // tags or headings
  std::optional<std::string> sidecar;
  bool write = false;
  std::string form = "contracted";
  std::vector<std::string> in_terms_of;  // symbols
  std::vector<std::string> first_order;  // symbols
  std::string derivative;                // by what; empty: none
  std::string solve_for;                 // empty: nothing
  MathFormat format = MathFormat::latex;
  ColorWhen color = ColorWhen::automatic;
};

/// Either a command, or a text to print and the code to end with: `--help`, `--version`, or what is wrong.
struct CommandLine {
  std::optional<CheckCommand> check = {};
  std::optional<ReplayCommand> replay = {};
  std::optional<EvalCommand> eval = {};
  std::optional<BenchCommand> bench = {};
  std::optional<SceneCommand> scene = {};
  std::optional<DeriveCommand> derive = {};
  std::optional<ExplainCommand> explain = {};
  std::optional<ReadCommand> read = {};
  std::optional<SuggestCommand> suggest = {};
  std::optional<ReportCommand> report = {};
  std::optional<CasesCommand> cases = {};
  std::optional<CaseCommand> one_case = {};
  std::string text = {};
  ExitCode code = ExitCode::ok;
};

[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv);
/// A command line that ends the program with its reason.
[[nodiscard]] CommandLine usage_error(std::string reason, std::string_view command);

}  // namespace rigor
