// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/scene_json.h"

#include "report/data/json_value.h"
#include "scene/quantity/quantity_dimension.h"

namespace rigor {
namespace {

Json json_of(const SceneQuantity& quantity) {
  Json object{{"quantity", quantity.source},
              {"axes", quantity.axes},
              {"unit", quantity.dimension ? Json(si_unit(*quantity.dimension)) : Json(nullptr)},
              {"value", quantity.value},
              {"error", or_null(quantity.error)}};
  if (!quantity.rows.empty()) object["rows"] = quantity.rows;
  return object;
}

Json json_of(const Motion& motion) {
  return {{"times", motion.times},
          {"spin", motion.spins},
          {"orientation", motion.orientations},
          {"closed_form", motion.closed_form},
          {"steps", motion.steps},
          {"evaluations", motion.evaluations},
          {"split_order", or_null(motion.split_order)},
          {"stopped", or_null(motion.stopped)}};
}

Json json_of(const SceneDrift& drift) {
  return {{"quantity", drift.source},
          {"constant", drift.constant},
          {"in_space", drift.in_space},
          {"relative_change", drift.relative}};
}

Json json_of(const SceneNode& node, bool times) {
  Json object{{"node", node.name}, {"computed", node.computed}, {"reason", node.reason}};
  if (times) object["milliseconds"] = node.milliseconds;
  return object;
}

Json json_of_problem(const Diagnostic& diagnostic, const SourceMap& sources) {
  const LineColumn place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
  return {{"kind", info(diagnostic.kind).name},
          {"file", sources.path(diagnostic.span.file)},
          {"line", place.line},
          {"column", place.column},
          {"message", diagnostic.message},
          {"help", diagnostic.help}};
}

}  // namespace

std::string to_json(const SceneResult& result, const SourceMap& sources, bool times) {
  const Json json{
      {"format", 1},
      {"title", result.title},
      {"body", result.body},
      {"along_principal_axes", result.along_principal_axes},
      {"quantities", array_of(result.quantities, [](const SceneQuantity& each) { return json_of(each); })},
      {"motion", result.motion ? json_of(*result.motion) : Json(nullptr)},
      {"drifts", array_of(result.drifts, [](const SceneDrift& drift) { return json_of(drift); })},
      {"nodes", array_of(result.nodes, [&](const SceneNode& node) { return json_of(node, times); })},
      {"computed", result.counts().computed},
      {"skipped", result.counts().skipped},
      {"diagnostics",
       array_of(result.diagnostics, [&](const Diagnostic& each) { return json_of_problem(each, sources); })}};
  return to_text(json, 1);
}

}  // namespace rigor
