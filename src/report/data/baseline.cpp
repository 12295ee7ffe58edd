// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>
#include <vector>

#include "base/ascii.h"
#include "report/data/json_value.h"

namespace rigor {
namespace {

std::string path_key(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().generic_string();
}

/// `line 12` is no news if it was line 10: each number counts as one sign.
std::string without_numbers(std::string_view message) {
  std::string text;
  for (const char c : message) {
    const char sign = is_digit(c) ? '#' : c;
    if (sign != '#' || !text.ends_with('#')) text += sign;
  }
  return text;
}

/// `what`: the text of a step, or the message where there is none.
std::string finding_key(const std::string& file, std::string_view what, std::string_view verdict,
                        std::string_view kind) {
  return fmt::format("{}\n{}\n{}\n{}", path_key(file), what, verdict, kind);
}

/// What was written by another program, or by hand, may lack anything.
std::string word_in(const Json& object, const char* key) {
  return object.contains(key) && object.at(key).is_string() ? object.at(key).get<std::string>()
                                                            : std::string();
}

void read_file_findings(const Json& file, Baseline& baseline) {
  const std::string path = word_in(file, "file");
  for (const Json& step : file.at("steps")) {
    const std::string place = step.contains("file") ? word_in(step, "file") : path;
    const std::string source = word_in(step, "source");
    const std::string verdict = word_in(step, "verdict");
    ++baseline.findings[finding_key(place, source, verdict, "")];
    for (const Json& each : step.at("diagnostics"))
      ++baseline.findings[finding_key(place, source, verdict, word_in(each, "kind"))];
  }
  for (const Json& each : file.at("diagnostics")) {
    const std::string place = each.contains("file") ? word_in(each, "file") : path;
    const std::string message = without_numbers(word_in(each, "message"));
    ++baseline.findings[finding_key(place, message, "", word_in(each, "kind"))];
  }
}

/// A diagnostic that stands at several steps is said once, so it is known only if it is known at all of them.
void keep_said_of_new_steps(const Report& report, KnownFindings& known) {
  using Said = std::tuple<DiagnosticKind, FileId, std::uint32_t, std::string>;
  const auto said = [](const Diagnostic& diagnostic) {
    return Said{diagnostic.kind, diagnostic.span.file, diagnostic.span.begin, diagnostic.message};
  };
  std::set<Said> fresh;
  const auto each_of = [&](const auto& visit) {
    for (const FileReport& file : report.files)
      for (const Step& step : file.steps)
        for (const Diagnostic& diagnostic : step.diagnostics) visit(diagnostic);
  };
  each_of([&](const Diagnostic& diagnostic) {
    if (!known.has(diagnostic)) fresh.insert(said(diagnostic));
  });
  each_of([&](const Diagnostic& diagnostic) {
    if (fresh.contains(said(diagnostic))) known.diagnostics.erase(&diagnostic);
  });
}

}  // namespace

Result<Baseline> read_baseline(std::string_view json) {
  try {
    const Json whole = Json::parse(json);
    Baseline baseline;
    for (const Json& file : whole.at("files")) read_file_findings(file, baseline);
    return baseline;
  } catch (const Json::exception&) {
    return refuse("not a report of `rigor check --json`");
  }
}

KnownFindings known_findings(const Report& report, const SourceMap& sources, Baseline baseline) {
  KnownFindings known;
  const auto take = [&](const std::string& key) {
    const auto found = baseline.findings.find(key);
    return found != baseline.findings.end() && found->second > 0 && found->second-- > 0;
  };
  for (const FileReport& file : report.files) {
    for (const Step& step : file.steps) {
      const std::string& path = sources.path(step.span.file);
      const std::string_view verdict = name_of(step.verdict);
      if (take(finding_key(path, step.source, verdict, "")) && severity_of(step)) known.steps.insert(&step);
      for (const Diagnostic& each : step.diagnostics)
        if (take(finding_key(path, step.source, verdict, info(each.kind).name)))
          known.diagnostics.insert(&each);
    }
    for (const Diagnostic& each : file.diagnostics) {
      const std::string key =
          finding_key(sources.path(each.span.file), without_numbers(each.message), "", info(each.kind).name);
      if (take(key)) known.diagnostics.insert(&each);
    }
  }
  keep_said_of_new_steps(report, known);
  return known;
}

}  // namespace rigor
