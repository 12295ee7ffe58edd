// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/version.h"

namespace rigor {
namespace {

using Json = nlohmann::ordered_json;

void add_place(Json& object, Span span, const SourceMap& sources) {
  const LineColumn begin = sources.line_column(span.file, span.begin);
  const LineColumn end = sources.line_column(span.file, std::max(span.begin, span.end));
  object["line"] = begin.line;
  object["column"] = begin.column;
  object["end_line"] = end.line;
  object["end_column"] = end.column;
}

std::string severity_word(Severity severity) {
  std::string word(name_of(severity));
  std::ranges::replace(word, ' ', '-');
  return word;
}

Json json_of(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json object;
  object["kind"] = info(diagnostic.kind).name;
  object["severity"] = severity_word(diagnostic.severity());
  add_place(object, diagnostic.span, sources);
  object["file"] = sources.path(diagnostic.span.file);
  object["message"] = diagnostic.message;
  object["labels"] = Json::array();
  for (const Label& label : diagnostic.labels) {
    Json entry;
    add_place(entry, label.span, sources);
    entry["file"] = sources.path(label.span.file);
    entry["text"] = label.text;
    object["labels"].push_back(std::move(entry));
  }
  object["help"] = diagnostic.help;
  return object;
}

Json json_of(const Diagnostics& diagnostics, const SourceMap& sources) {
  Json array = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) array.push_back(json_of(diagnostic, sources));
  return array;
}

Json json_of(const Counterexample::Value& value) {
  Json object;
  object["symbol"] = value.symbol;
  object["particle"] = value.particle;
  object["rank"] = value.rank;
  object["components"] = value.components;
  return object;
}

Json json_of(const Counterexample& sample) {
  Json object;
  object["particles"] = sample.particles;
  object["values"] = Json::array();
  for (const Counterexample::Value& value : sample.values) {
    Json entry = json_of(value);
    entry["beyond"] = value.beyond;
    object["values"].push_back(std::move(entry));
  }
  object["component"] = Json::array();
  for (const Counterexample::Axis& axis : sample.component) {
    Json entry;
    entry["index"] = axis.index;
    entry["value"] = axis.value;
    object["component"].push_back(std::move(entry));
  }
  object["left"] = sample.left;
  object["right"] = sample.right;
  object["squared_distance"] = sample.squared_distance;
  object["follows"] = Json::array();
  for (const Counterexample::Value& value : sample.follows) object["follows"].push_back(json_of(value));
  return object;
}

Json json_of(const ChainPlace& place) {
  Json object;
  object["first_wrong"] = place.first_wrong;
  object["undone_at"] = place.undone_at ? Json(*place.undone_at) : Json(nullptr);
  object["stays"] = place.stays;
  object["undoes"] = place.undoes;
  object["first_step"] = place.first_wrong ? Json(nullptr) : Json(place.first_step);
  return object;
}

Json json_of(const Step& step, const SourceMap& sources) {
  Json object;
  add_place(object, step.span, sources);
  object["tag"] = step.tag;
  object["label"] = step.label;
  object["section"] = step.section;
  object["source"] = step.source;
  object["left"] = step.left;
  object["relation"] = step.relation;
  object["right"] = step.right;
  object["verdict"] = name_of(step.verdict);
  object["route"] = step.route;
  object["uses"] = step.uses;
  object["counterexample"] = step.counterexample ? json_of(*step.counterexample) : Json(nullptr);
  object["repairs"] = Json::array();
  for (const Repair& repair : step.repairs) {
    Json entry;
    entry["side"] = repair.on_left ? "left" : "right";
    entry["statement"] = repair.statement;
    entry["change"] = repair.change;
    object["repairs"].push_back(std::move(entry));
  }
  object["conditions"] = step.conditions;
  object["diagnostics"] = json_of(step.diagnostics, sources);
  object["file"] = sources.path(step.span.file);
  object["chain"] = step.chain ? json_of(*step.chain) : Json(nullptr);
  object["milliseconds"] = std::round(step.milliseconds * 1000.0) / 1000.0;
  return object;
}

Json json_of(const Counts& counts) {
  Json object;
  for (std::size_t i = 0; i < verdict_count; ++i)
    object[std::string(name_of(static_cast<Verdict>(i)))] = counts[i];
  return object;
}

Json json_of(const FileReport& file, const SourceMap& sources) {
  Json object;
  object["file"] = file.path;
  object["steps"] = Json::array();
  for (const Step& step : file.steps) object["steps"].push_back(json_of(step, sources));
  object["diagnostics"] = json_of(file.diagnostics, sources);
  object["silenced"] = json_of(file.silenced, sources);
  object["counts"] = json_of(file.counts);
  object["sidecar"] = file.sidecar.empty() ? Json(nullptr) : Json(file.sidecar);
  object["dimensions"] = Json::array();
  for (const SymbolDimension& entry : file.dimensions) {
    Json symbol;
    symbol["symbol"] = entry.symbol;
    symbol["dimension"] = entry.dimension ? Json(*entry.dimension) : Json(nullptr);
    object["dimensions"].push_back(std::move(symbol));
  }
  object["failure"] = file.failure.empty() ? Json(nullptr) : Json(file.failure);
  return object;
}

}  // namespace

std::string to_json(const Report& report, const SourceMap& sources) {
  Json object;
  object["rigor"] = version;
  object["files"] = Json::array();
  for (const FileReport& file : report.files) object["files"].push_back(json_of(file, sources));
  object["counts"] = json_of(report.counts);
  return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rigor
