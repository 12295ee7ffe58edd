// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/host/progress.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"
#include "report/text/explanation_text.h"
#include "source/render.h"
#include "source/suggest.h"

namespace rigor {
namespace {

std::optional<std::uint32_t> line_number(const std::string& place) {
  std::uint32_t line = 0;
  const char* end = place.data() + place.size();
  const auto [last, error] = std::from_chars(place.data(), end, line);
  return error == std::errc() && last == end && line > 0 ? std::optional(line) : std::nullopt;
}

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

/// The notes and the places that are asked for.
class Chooser {
 public:
  Chooser(const ExplainCommand& command, const FormsReading& reading, const SourceMap& sources)
      : command_(command), reading_(reading), sources_(sources) {}

  /// The chains at all places that are asked for; every claim if there are none.
  [[nodiscard]] std::vector<std::size_t> chains() const {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < reading_.forms.chains.size(); ++k) {
      const WrittenFormChain& chain = reading_.forms.chains[k];
      const bool claims = std::ranges::any_of(
          chain.steps, [](const WrittenStep& step) { return !step.defines && !step.given; });
      const bool wanted = command_.places.empty()
                              ? claims && !chain.assumed
                              : std::ranges::any_of(command_.places, [&](const std::string& place) {
                                  return is_at(chain, place);
                                });
      if (wanted) chosen.push_back(k);
    }
    return chosen;
  }

  /// False, with a message, if the notes do not have a place.
  [[nodiscard]] bool knows_all_places(std::ostream& err) const {
    std::vector<std::string> names;
    for (const WrittenFormChain& chain : reading_.forms.chains) {
      if (!chain.tag.empty()) names.push_back(chain.tag);
      if (!chain.label.empty()) names.push_back(chain.label);
      names.insert(names.end(), chain.headings.begin(), chain.headings.end());
    }
    bool known = true;
    for (const std::string& place : command_.places) {
      if (std::ranges::any_of(reading_.forms.chains,
                              [&](const WrittenFormChain& chain) { return is_at(chain, place); }))
        continue;
      known = false;
      err << fmt::format("rigor: {}: there is no equation at `{}`", printable(command_.file),
                         printable(place));
      if (const auto near = suggest(place, names); near && !line_number(place))
        err << fmt::format("; did you mean `{}`?", printable(*near));
      err << "\n";
    }
    return known;
  }

 private:
  /// A number that is a tag is not a line.
  bool is_at(const WrittenFormChain& chain, const std::string& place) const {
    if (stands_at(chain, place) || (!chain.label.empty() && chain.label == place)) return true;
    const auto line = line_number(place);
    const bool is_tag = std::ranges::any_of(
        reading_.forms.chains, [&](const WrittenFormChain& other) { return stands_at(other, place); });
    if (!line || is_tag || chain.span.file != reading_.report.file) return false;
    return sources_.line_column(chain.span.file, chain.span.begin).line <= *line &&
           *line <= sources_.line_column(chain.span.file, chain.span.end).line;
  }

  const ExplainCommand& command_;
  const FormsReading& reading_;
  const SourceMap& sources_;
};

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
  const Chooser chooser(command, reading, sources);
  if (!chooser.knows_all_places(err)) return ExitCode::wrong;
  std::vector<ExplainedChain> chains;
  {
    Progress progress(err, screen_of(err).is_terminal);
    const std::vector<std::size_t> chosen = chooser.chains();
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
