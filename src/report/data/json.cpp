// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/json.h"

#include <algorithm>
#include <cmath>

#include "base/version.h"
#include "report/data/json_value.h"
#include "report/wording/causes.h"
#include "report/wording/laws_of.h"

namespace rigor {
namespace {

Json placed(Json object, Span span, const SourceMap& sources) {
  const LineColumn begin = sources.line_column(span.file, span.begin);
  const LineColumn end = sources.line_column(span.file, std::max(span.begin, span.end));
  object.update(
      {{"line", begin.line}, {"column", begin.column}, {"end_line", end.line}, {"end_column", end.column}});
  return object;
}

std::string severity_word(Severity severity) {
  std::string word(name_of(severity));
  std::ranges::replace(word, ' ', '-');
  return word;
}

Json json_of(const Diagnostic& diagnostic, const SourceMap& sources) {
  const auto json_of_label = [&](const Label& label) {
    Json object = placed(Json::object(), label.span, sources);
    object.update({{"file", sources.path(label.span.file)}, {"text", label.text}});
    return object;
  };
  Json object =
      placed({{"kind", info(diagnostic.kind).name}, {"severity", severity_word(diagnostic.severity())}},
             diagnostic.span, sources);
  object.update({{"file", sources.path(diagnostic.span.file)},
                 {"message", diagnostic.message},
                 {"labels", array_of(diagnostic.labels, json_of_label)},
                 {"help", diagnostic.help}});
  return object;
}

Json json_of(const Diagnostics& diagnostics, const SourceMap& sources) {
  return array_of(diagnostics, [&](const Diagnostic& diagnostic) { return json_of(diagnostic, sources); });
}

Json json_of(const Counterexample::Value& value) {
  return {{"symbol", value.symbol},
          {"particle", value.particle},
          {"rank", value.rank},
          {"components", value.components}};
}

Json json_of_drawn(const Counterexample::Value& value) {
  Json object = json_of(value);
  object["beyond"] = value.beyond;
  return object;
}

Json json_of(const Counterexample& sample) {
  const auto json_of_axis = [](const Counterexample::Axis& axis) {
    return Json{{"index", axis.index}, {"value", axis.value}};
  };
  const auto json_of_value = [](const Counterexample::Value& value) { return json_of(value); };
  return {{"particles", sample.particles},
          {"values", array_of(sample.values, json_of_drawn)},
          {"component", array_of(sample.component, json_of_axis)},
          {"left", sample.left},
          {"right", sample.right},
          {"squared_distance", sample.squared_distance},
          {"follows", array_of(sample.follows, json_of_value)}};
}

Json json_of(const ChainPlace& place) {
  return {{"first_wrong", place.first_wrong},
          {"undone_at", or_null(place.undone_at)},
          {"stays", place.stays},
          {"undoes", place.undoes},
          {"first_step", place.first_wrong ? Json(nullptr) : Json(place.first_step)}};
}

Json json_of(const Repair& repair) {
  return {{"side", repair.on_left ? "left" : "right"},
          {"statement", repair.statement},
          {"change", repair.change},
          {"uses", repair.uses}};
}

Json json_of(const Step& step, const SourceMap& sources) {
  Json object = placed(Json::object(), step.span, sources);
  object.update({{"tag", step.tag},
                 {"label", step.label},
                 {"section", step.section},
                 {"source", step.source},
                 {"left", step.left},
                 {"relation", step.relation},
                 {"right", step.right},
                 {"verdict", name_of(step.verdict)},
                 {"route", step.route},
                 {"uses", step.uses},
                 {"counterexample", step.counterexample ? json_of(*step.counterexample) : Json(nullptr)},
                 {"repairs", array_of(step.repairs, [](const Repair& repair) { return json_of(repair); })},
                 {"conditions", step.conditions},
                 {"diagnostics", json_of(step.diagnostics, sources)},
                 {"file", sources.path(step.span.file)},
                 {"chain", step.chain ? json_of(*step.chain) : Json(nullptr)},
                 {"milliseconds", std::round(step.milliseconds * 1000.0) / 1000.0}});
  return object;
}

Json json_of(const Counts& counts) {
  Json object;
  for (std::size_t i = 0; i < verdict_count; ++i)
    object[std::string(name_of(static_cast<Verdict>(i)))] = counts[i];
  return object;
}

Json json_of(const Cause& cause, const SourceMap& sources) {
  const auto json_of_place = [&](Span place) {
    Json object = placed(Json::object(), place, sources);
    object["file"] = sources.path(place.file);
    return object;
  };
  return {{"cause", cause.words},
          {"directives", cause.directives},
          {"steps", cause.steps},
          {"alone", cause.alone},
          {"places", array_of(cause.places, json_of_place)}};
}

Json json_of(const FileReport& file, const SourceMap& sources) {
  const auto json_of_dimension = [](const SymbolDimension& entry) {
    return Json{{"symbol", entry.symbol}, {"dimension", or_null(entry.dimension)}};
  };
  const auto json_of_law = [&](const LawUse& law) {
    return placed({{"name", law.name}, {"used", law.used}}, law.span, sources);
  };
  return {{"file", file.path},
          {"steps", array_of(file.steps, [&](const Step& step) { return json_of(step, sources); })},
          {"diagnostics", json_of(file.diagnostics, sources)},
          {"silenced", json_of(file.silenced, sources)},
          {"counts", json_of(file.counts)},
          {"sidecar", or_null(file.sidecar)},
          {"dimensions", array_of(file.dimensions, json_of_dimension)},
          {"laws", array_of(laws_of(file, sources), json_of_law)},
          {"failure", or_null(file.failure)}};
}

}  // namespace

std::string to_json(const Report& report, const SourceMap& sources) {
  return to_text(
      {{"rigor", version},
       {"format", 2},
       {"files", array_of(report.files, [&](const FileReport& file) { return json_of(file, sources); })},
       {"counts", json_of(report.counts)},
       {"causes", array_of(causes_of(report), [&](const Cause& cause) { return json_of(cause, sources); })}});
}

}  // namespace rigor
