// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/host/given_values.h"
#include "app/host/progress.h"
#include "app/host/sample_bodies.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/read_forms.h"
#include "expr/statement/forms_of_name.h"
#include "report/data/eval_json.h"
#include "report/text/bench_text.h"
#include "report/text/eval_text.h"
#include "report/wording/advice.h"
#include "source/render.h"
#include "source/suggest.h"

namespace rigor {
namespace {

constexpr std::size_t most_panels = 4;

/// The notes with their forms, and the bodies.
struct Forms {
  SourceMap sources;
  FormsReading reading;
  std::vector<Body> bodies;
  std::vector<const WrittenFormChain*> chains;
  bool malformed = false;  // something in the notes cannot be read
  [[nodiscard]] ExitCode code() const { return malformed ? ExitCode::wrong : ExitCode::ok; }
};

/// The chains at the places that are asked for. Claims only: what is assumed is not computed.
ExitCode choose_chains(const FormsCommand& command, Forms& forms, std::ostream& err) {
  const std::vector<WrittenFormChain>& all = forms.reading.forms.chains;
  std::vector<std::string> names;
  for (const WrittenFormChain& chain : all) {
    if (!chain.tag.empty()) names.push_back(chain.tag);
    names.insert(names.end(), chain.headings.begin(), chain.headings.end());
    const bool wanted =
        command.places.empty() || std::ranges::any_of(command.places, [&](const std::string& place) {
          return stands_at(chain, place);
        });
    if (wanted && !chain.assumed) forms.chains.push_back(&chain);
  }
  for (const std::string& place : command.places) {
    const bool known =
        std::ranges::any_of(all, [&](const WrittenFormChain& chain) { return stands_at(chain, place); });
    if (known) continue;
    err << fmt::format("rigor: {}: no equation and no section is named `{}`", printable(command.file),
                       printable(place));
    if (const auto near = suggest(place, names)) err << fmt::format("; did you mean `{}`?", printable(*near));
    err << "\n";
    return ExitCode::wrong;
  }
  return ExitCode::ok;
}

/// What is wrong in the notes, so that it cannot be evaluated. True if there is anything.
bool print_errors(const FileReport& report, const SourceMap& sources, std::ostream& err) {
  bool any = false;
  const auto print_all = [&](const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.severity() != Severity::error) continue;
      err << render(diagnostic, sources);
      any = true;
    }
  };
  print_all(report.diagnostics);
  for (const Step& step : report.steps) print_all(step.diagnostics);
  return any;
}

ExitCode read_all(const FormsCommand& command, Forms& forms, std::ostream& err) {
  const ExitCode bodies = read_bodies(command.bodies, command.file, forms.sources, forms.bodies, err);
  if (bodies != ExitCode::ok) return bodies;
  FormRequest request;
  request.sidecar = command.sidecar;
  forms.reading = read_forms(forms.sources, command.file, request);
  if (forms.reading.report.unreadable) {
    for (const Diagnostic& each : forms.reading.report.diagnostics) err << render(each, forms.sources);
    return ExitCode::no_input;
  }
  forms.malformed = print_errors(forms.reading.report, forms.sources, err);
  return choose_chains(command, forms, err);
}

EvaluatedNotes evaluate_all_forms(const FormsCommand& command, const Forms& forms,
                                  const TrialOptions& options, std::ostream& err) {
  EvaluatedNotes notes{.path = command.file, .chains = {}};
  Progress progress(err, screen_of(err).is_terminal);
  std::size_t done = 0;
  for (const WrittenFormChain* chain : forms.chains) {
    progress.update(command.file, done++, forms.chains.size(), "chains in floating point");
    ChainResult result = measure_chain(forms.reading.forms, *chain, forms.bodies, options);
    if (result.forms.empty() && result.left_out.empty()) continue;
    notes.chains.push_back({chain, std::move(result)});
  }
  return notes;
}

/// All chains: fewer samples for each.
TrialOptions trials_for(const FormsCommand& command, bool times) {
  TrialOptions trials{.times = times};
  if (command.places.empty()) {
    trials.samples = 256;
    trials.operations = 200'000;
  }
  return trials;
}

/// False if the file cannot be written.
bool write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  return static_cast<bool>(file.flush());
}

/// The forms that differ, with pictures in the folder if there is one; then those that err alike.
std::optional<std::string> bench_text(const std::vector<EvaluatedChain>& chains, const SourceMap& sources,
                                      const std::filesystem::path& folder, std::ostream& err) {
  std::string differing;
  std::string alike;
  std::map<std::string, std::size_t> used;  // names of pictures
  for (const EvaluatedChain& chain : chains) {
    const auto advice = advise(chain.result);
    if (!advice) continue;  // nothing to compare
    if (advice->all_alike) {
      alike += bench_row(chain, sources);
      continue;
    }
    const auto trials = telling_trials(chain.result, most_panels);
    std::optional<std::string> picture;
    if (!folder.empty()) {
      const std::string name = file_name_of(*chain.chain, sources);
      const std::size_t earlier = used[name]++;
      picture = earlier == 0 ? name + ".svg" : fmt::format("{}-{}.svg", name, earlier + 1);
      if (!write(folder / *picture, bench_picture(chain, trials))) {
        err << fmt::format("rigor: {}: cannot be written\n", printable((folder / *picture).string()));
        return std::nullopt;
      }
    }
    differing += bench_markdown(chain, trials, sources, picture);
  }
  if (!alike.empty()) differing += bench_rows_head() + alike;
  return differing;
}

}  // namespace

ExitCode evaluate_forms(const EvalCommand& command, std::ostream& out, std::ostream& err) {
  Forms forms;
  if (const ExitCode code = read_all(command.forms, forms, err); code != ExitCode::ok) return code;
  TrialOptions trials = trials_for(command.forms, command.times);
  if (!command.values.empty()) {
    auto values = read_given_values(command.values);
    if (!values) {
      err << fmt::format("rigor: --with: {}\n", printable(values.error().reason));
      return ExitCode::wrong;
    }
    trials.values = std::move(*values);
  }
  const EvaluatedNotes notes = evaluate_all_forms(command.forms, forms, trials, err);
  const TerminalOptions options = terminal_options(command.forms.color, out);
  out << (command.json ? evaluation_json(notes, forms.sources)
                       : print_evaluation(notes, forms.sources, options));
  return forms.code();
}

ExitCode bench_forms(const BenchCommand& command, std::ostream& out, std::ostream& err) {
  Forms forms;
  if (const ExitCode code = read_all(command.forms, forms, err); code != ExitCode::ok) return code;
  const std::vector<WrittenFormChain> named = forms_of_one_name(forms.reading.forms);
  if (command.forms.places.empty()) {
    for (const WrittenFormChain& chain : named) forms.chains.push_back(&chain);
  }
  const std::filesystem::path folder(command.folder);
  std::error_code error;
  if (!command.folder.empty()) std::filesystem::create_directories(folder, error);
  const EvaluatedNotes notes = evaluate_all_forms(command.forms, forms, trials_for(command.forms, true), err);
  const auto text = bench_text(notes.chains, forms.sources, folder, err);
  if (!text) return ExitCode::no_input;
  if (command.folder.empty()) {
    out << *text;
    return forms.code();
  }
  const std::string name = std::filesystem::path(command.forms.file).stem().string() + "-forms.md";
  if (write(folder / name, *text)) return forms.code();
  err << fmt::format("rigor: {}: cannot be written\n", printable((folder / name).string()));
  return ExitCode::no_input;
}

}  // namespace rigor
