// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/scene_json.h"

#include <nlohmann/json.hpp>

#include "scene/quantity/quantity_dimension.h"

namespace rigor {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const SceneQuantity& quantity) {
  Json object;
  object["quantity"] = quantity.source;
  object["axes"] = quantity.axes;
  object["unit"] = quantity.dimension ? Json(si_unit(*quantity.dimension)) : Json(nullptr);
  object["value"] = quantity.value;
  object["error"] = quantity.error.empty() ? Json(nullptr) : Json(quantity.error);
  if (!quantity.rows.empty()) object["rows"] = quantity.rows;
  return object;
}

Json json_of(const Motion& motion) {
  Json object;
  object["times"] = motion.times;
  object["spin"] = motion.spins;
  object["orientation"] = motion.orientations;
  object["closed_form"] = motion.closed_form;
  object["steps"] = motion.steps;
  object["evaluations"] = motion.evaluations;
  object["stopped"] = motion.stopped.empty() ? Json(nullptr) : Json(motion.stopped);
  return object;
}

Json json_of(const SceneDrift& drift) {
  Json object;
  object["quantity"] = drift.source;
  object["constant"] = drift.constant;
  object["in_space"] = drift.in_space;
  object["relative_change"] = drift.relative;
  return object;
}

Json json_of(const SceneNode& node) {
  Json object;
  object["node"] = node.name;
  object["computed"] = node.computed;
  object["reason"] = node.reason;
  object["milliseconds"] = node.milliseconds;
  return object;
}

Json json_of_problem(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json object;
  const LineColumn place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
  object["kind"] = info(diagnostic.kind).name;
  object["file"] = sources.path(diagnostic.span.file);
  object["line"] = place.line;
  object["column"] = place.column;
  object["message"] = diagnostic.message;
  object["help"] = diagnostic.help;
  return object;
}

template <class Items>
Json array_of(const Items& items) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(json_of(item));
  return array;
}

}  // namespace

std::string to_json(const SceneResult& result, const SourceMap& sources, bool times) {
  Json object;
  object["format"] = 1;
  object["title"] = result.title;
  object["body"] = result.body;
  object["along_principal_axes"] = result.along_principal_axes;
  object["quantities"] = array_of(result.quantities);
  object["motion"] = result.motion ? json_of(*result.motion) : Json(nullptr);
  object["drifts"] = array_of(result.drifts);
  object["nodes"] = array_of(result.nodes);
  if (!times) {
    for (Json& node : object["nodes"]) node.erase("milliseconds");
  }
  object["computed"] = result.counts().computed;
  object["skipped"] = result.counts().skipped;
  object["diagnostics"] = Json::array();
  for (const Diagnostic& diagnostic : result.diagnostics)
    object["diagnostics"].push_back(json_of_problem(diagnostic, sources));
  return object.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rigor
