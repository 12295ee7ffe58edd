// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/host/asked_places.h"
#include "app/host/progress.h"
#include "app/host/screen.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"
#include "report/text/explanation_text.h"
#include "source/render.h"

namespace rigor {
namespace {

/// Is there a relation outside all brackets?
bool has_relation(const std::string& text) {
  SourceMap sources;
  const FileId file = sources.add("", text);
  const Tokens tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(text.size())});
  return std::ranges::any_of(tokens, [](const Token& token) { return relation_kind(token).has_value(); });
}

FormsReading read(const ExplainCommand& command, SourceMap& sources) {
  FormRequest request;
  request.sidecar = command.sidecar;
  std::error_code error;
  const bool is_file = std::filesystem::exists(command.file, error);
  if (is_file || !has_relation(command.file)) return read_forms(sources, command.file, request);
  return read_forms_of_text(sources, "statement", "$$\n" + command.file + "\n$$\n", request);
}

AskedPlaces places_of(const ExplainCommand& command, const FormsReading& reading, const SourceMap& sources) {
  std::vector<EquationPlace> places;
  for (const WrittenFormChain& chain : reading.forms.chains)
    places.push_back({chain.tag, chain.label, chain.headings, chain.span});
  return {command.places, std::move(places), reading.report.file, sources};
}

/// The chains at all places that are asked for; every claim if there are none.
std::vector<std::size_t> chosen_chains(const ExplainCommand& command, const FormsReading& reading,
                                       const AskedPlaces& places) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < reading.forms.chains.size(); ++k) {
    const WrittenFormChain& chain = reading.forms.chains[k];
    const bool claims = std::ranges::any_of(
        chain.steps, [](const WrittenStep& step) { return !step.defines && !step.given; });
    if (command.places.empty() ? claims && !chain.assumed : places.wants(k)) chosen.push_back(k);
  }
  return chosen;
}

/// What is wrong in the notes outside all steps, and in the steps that are not understood.
void print_unread(const FileReport& report, const SourceMap& sources, std::ostream& err) {
  const auto print = [&](const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics) {
      if (each.severity() == Severity::error && each.kind != DiagnosticKind::refuted)
        err << render(each, sources);
    }
  };
  print(report.diagnostics);
  for (const Step& step : report.steps) {
    if (step.verdict == Verdict::not_understood) print(step.diagnostics);
  }
}

}  // namespace

ExitCode explain_chains(const ExplainCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  FormsReading reading = read(command, sources);
  if (reading.report.unreadable) {
    for (const Diagnostic& each : reading.report.diagnostics) err << render(each, sources);
    return ExitCode::no_input;
  }
  print_unread(reading.report, sources, err);
  const AskedPlaces places = places_of(command, reading, sources);
  if (!places.are_all_known(command.file, err)) return ExitCode::wrong;
  std::vector<ExplainedChain> chains;
  {
    Progress progress(err, screen_of(err).is_terminal);
    const std::vector<std::size_t> chosen = chosen_chains(command, reading, places);
    for (const std::size_t chain : chosen) {
      progress.update(command.file, chains.size(), chosen.size(), "chains explained");
      chains.push_back(explain_chain(reading.forms, chain, sources));
    }
  }
  switch (command.format) {
    case MathFormat::text:
      out << explanation_text(chains, terminal_options(command.color, out));
      break;
    case MathFormat::latex:
      out << explanation_latex(chains);
      break;
    case MathFormat::mathml:
      out << explanation_mathml(chains);
      break;
  }
  const ExplainedTally counts = tally(chains);
  if (counts.refuted > 0) return ExitCode::wrong;
  return counts.explained < counts.steps ? ExitCode::open : ExitCode::ok;
}

}  // namespace rigor
