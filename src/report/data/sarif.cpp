// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/sarif.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/md5.h"
#include "base/version.h"
#include "report/data/json_value.h"
#include "report/wording/escape.h"
#include "report/wording/finding.h"

namespace rigor {
namespace {

constexpr const char* root = "%SRCROOT%";

Json text_object(const std::string& text) { return {{"text", text}}; }

Json region_of(Span span, const SourceMap& sources) {
  const LineColumn begin = sources.line_column(span.file, span.begin);
  const LineColumn end = sources.line_column(span.file, std::max(span.begin, span.end));
  return {{"startLine", begin.line},
          {"startColumn", begin.column},
          {"endLine", end.line},
          {"endColumn", end.column}};
}

std::string_view level_of(Weight weight) {
  switch (weight) {
    case Weight::wrong:
      return "error";
    case Weight::open:
    case Weight::warning:
      return "warning";
    case Weight::expected:
    case Weight::known:
      return "note";
  }
  return "none";
}

std::string without_blanks(std::string_view text) {
  std::string bare(text);
  std::erase_if(bare, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  return bare;
}

Span without_outer_blanks(Span span, const SourceMap& sources) {
  const std::string_view text = sources.text(span);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {span.file, span.begin, span.begin};
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  return {span.file, span.begin + static_cast<std::uint32_t>(first),
          span.begin + static_cast<std::uint32_t>(last) + 1};
}

/// Where the side stands that a repair changes: only if the very text is there that was read.
std::optional<Span> replaced_by(const Repair& repair, const Step& step, const SourceMap& sources) {
  const Span relation = step.relation_span;
  if (relation.file != step.span.file || relation.begin < step.span.begin || relation.end > step.span.end)
    return std::nullopt;
  const Span side = repair.on_left ? Span{relation.file, step.span.begin, relation.begin}
                                   : Span{relation.file, relation.end, step.span.end};
  const Span written = without_outer_blanks(side, sources);
  const bool known = !written.empty() && !repair.replacement.empty() &&
                     without_blanks(sources.text(written)) == without_blanks(repair.replaced);
  return known ? std::optional(written) : std::nullopt;
}

class SarifRun {
 public:
  SarifRun(const SourceMap& sources, const CheckFormat& options) : sources_(sources), options_(options) {}

  Json json_of(const Report& report) {
    Json results = Json::array();
    Json notifications = Json::array();
    for (const FileReport& file : report.files) {
      for (const PlacedDiagnostic& placed : diagnostics_of(file)) results.push_back(result_of(placed));
      for (const Diagnostic& silenced : file.silenced) {
        Json result = result_of({&silenced, nullptr});
        suppress(result, "`allow` in the notes");
        results.push_back(std::move(result));
      }
      if (!file.failure.empty()) notifications.push_back(notification_of(file));
    }
    Json invocation{{"executionSuccessful", notifications.empty()}};
    if (!notifications.empty()) invocation["toolExecutionNotifications"] = std::move(notifications);
    const Json driver{{"name", "rigor"}, {"version", version}, {"rules", rules(options_.rule)}};
    const Json folder{{"description", text_object("the folder in which rigor was called")}};
    return {{"tool", {{"driver", driver}}},
            {"columnKind", "unicodeCodePoints"},
            {"originalUriBaseIds", {{root, folder}}},
            {"results", std::move(results)},
            {"invocations", Json::array({std::move(invocation)})}};
  }

 private:
  /// All kinds, so that `ruleIndex` is the position in the registry.
  static Json rules(const FailureRule& rule) {
    return array_of(diagnostic_table(), [&rule](const DiagnosticInfo& entry) {
      const Diagnostic example{entry.kind, {}, ""};
      const std::string help =
          fmt::format("{} ({}). The section `{}` of rigor's docs/diagnostics.md says more.", entry.summary,
                      name_of(entry.severity), entry.name);
      return Json{{"id", entry.name},
                  {"shortDescription", text_object(std::string(entry.summary))},
                  {"help", text_object(help)},
                  {"defaultConfiguration", {{"level", level_of(weight_of({&example, nullptr}, rule))}}}};
    });
  }

  [[nodiscard]] Json artifact(const std::string& path) const {
    const std::string from_here = path_from(path, options_.folder);
    Json location{{"uri", uri_of_path(from_here)}};
    if (!from_here.starts_with('/')) location["uriBaseId"] = root;
    return location;
  }

  [[nodiscard]] Json location_of(Span span) const {
    return {
        {"physicalLocation",
         {{"artifactLocation", artifact(sources_.path(span.file))}, {"region", region_of(span, sources_)}}}};
  }

  static void suppress(Json& result, const char* reason) {
    result["suppressions"] = Json::array({{{"kind", "inSource"}, {"justification", reason}}});
  }

  Json result_of(const PlacedDiagnostic& placed) {
    const Diagnostic& diagnostic = *placed.diagnostic;
    const Weight weight = weight_of(placed, options_.rule);
    std::string message = diagnostic.message + "\n" + details_of(placed, sources_);
    message.pop_back();
    Json location = location_of(diagnostic.span);
    if (placed.step != nullptr && !placed.step->section.empty())
      location["logicalLocations"] = Json::array({{{"name", placed.step->section}}});
    Json result{{"ruleId", info(diagnostic.kind).name},
                {"ruleIndex", &info(diagnostic.kind) - diagnostic_table().data()},
                {"level", level_of(weight)},
                {"message", text_object(message)},
                {"locations", Json::array({std::move(location)})}};
    add_related(result, diagnostic);
    result["partialFingerprints"] = {{"rigorStatement/v1", fingerprint(placed)}};
    if (placed.step != nullptr && shows_repairs(diagnostic.kind)) add_fixes(result, *placed.step);
    if (weight == Weight::expected) suppress(result, "`expect refuted` in the notes");
    if (weight == Weight::known) result["baselineState"] = "unchanged";
    return result;
  }

  void add_related(Json& result, const Diagnostic& diagnostic) const {
    Json related = Json::array();
    for (const Label& label : diagnostic.labels) {
      Json location = location_of(label.span);
      if (!label.text.empty()) location["message"] = text_object(label.text);
      related.push_back(std::move(location));
    }
    if (!related.empty()) result["relatedLocations"] = std::move(related);
  }

  void add_fixes(Json& result, const Step& step) const {
    Json fixes = Json::array();
    for (const Repair& repair : step.repairs) {
      const auto place = replaced_by(repair, step, sources_);
      if (!place) continue;
      const Json replacement{{"deletedRegion", region_of(*place, sources_)},
                             {"insertedContent", text_object(repair.replacement)}};
      const Json change{{"artifactLocation", artifact(sources_.path(place->file))},
                        {"replacements", Json::array({replacement})}};
      fixes.push_back(
          {{"description", text_object(repair.change)}, {"artifactChanges", Json::array({change})}});
    }
    if (!fixes.empty()) result["fixes"] = std::move(fixes);
  }

  /// The same where only lines above were added: of kind, path and text, and of how many like it came before.
  std::string fingerprint(const PlacedDiagnostic& placed) {
    const Diagnostic& diagnostic = *placed.diagnostic;
    const std::string text = placed.step != nullptr ? placed.step->source : diagnostic.message;
    const std::string about =
        fmt::format("{}\n{}\n{}", info(diagnostic.kind).name,
                    path_from(sources_.path(diagnostic.span.file), options_.folder), text);
    return fmt::format("{}:{}", md5(about), ++seen_[about]);
  }

  [[nodiscard]] Json notification_of(const FileReport& file) const {
    const Json location{{"physicalLocation", {{"artifactLocation", artifact(file.path)}}}};
    return {
        {"level", "error"}, {"message", text_object(file.failure)}, {"locations", Json::array({location})}};
  }

  const SourceMap& sources_;
  const CheckFormat& options_;
  std::map<std::string, int> seen_;
};

}  // namespace

std::string to_sarif(const Report& report, const SourceMap& sources, const CheckFormat& options) {
  return to_text({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                  {"version", "2.1.0"},
                  {"runs", Json::array({SarifRun(sources, options).json_of(report)})}});
}

}  // namespace rigor
