// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/read_recorded.h"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

namespace rigor {
namespace {

using ParsedJson = nlohmann::json;

/// Thrown and caught in this file only.
struct Malformed {
  std::string reason;
};

/// A value of the JSON, and the way to it for messages.
class Entry {
 public:
  Entry(const ParsedJson& value, std::string way) : value_(&value), way_(std::move(way)) {}

  [[nodiscard]] Entry operator[](const char* key) const {
    if (!value_->is_object() || !value_->contains(key)) fail_at(way_to(key), "is missing");
    return {(*value_)[key], way_to(key)};
  }
  [[nodiscard]] bool has(const char* key) const {
    return value_->is_object() && value_->contains(key) && !(*value_)[key].is_null();
  }
  [[nodiscard]] std::vector<Entry> entries() const {
    if (!value_->is_array()) fail_at(way_, "is not an array");
    std::vector<Entry> all;
    for (std::size_t k = 0; k < value_->size(); ++k)
      all.emplace_back((*value_)[k], fmt::format("{}[{}]", way_, k));
    return all;
  }
  [[nodiscard]] std::string text() const {
    if (!value_->is_string()) fail_at(way_, "is not a string");
    return value_->get<std::string>();
  }
  [[nodiscard]] std::uint32_t count() const {
    const bool fits = value_->is_number_unsigned() &&
                      value_->get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
    if (!fits) fail_at(way_, "is not a number of things");
    return value_->get<std::uint32_t>();
  }

 private:
  [[nodiscard]] std::string way_to(const char* key) const { return way_.empty() ? key : way_ + "." + key; }
  [[noreturn]] static void fail_at(const std::string& way, const char* what) {
    throw Malformed{fmt::format("{} {}", way.empty() ? "the whole" : way, what)};
  }

  const ParsedJson* value_;
  std::string way_;
};

std::vector<Counterexample::Value> read_values(const Entry& from) {
  std::vector<Counterexample::Value> values;
  for (const Entry& each : from.entries()) {
    Counterexample::Value& value = values.emplace_back();
    value.symbol = each["symbol"].text();
    value.particle = each["particle"].count();
    value.rank = static_cast<int>(each["rank"].count());
    for (const Entry& component : each["components"].entries()) value.components.push_back(component.text());
  }
  return values;
}

Counterexample read_example(const Entry& from) {
  Counterexample example;
  example.particles = from["particles"].count();
  example.values = read_values(from["values"]);
  if (from.has("follows")) example.follows = read_values(from["follows"]);
  for (const Entry& each : from["component"].entries())
    example.component.push_back({each["index"].text(), static_cast<int>(each["value"].count())});
  example.left = from["left"].text();
  example.right = from["right"].text();
  return example;
}

RecordedFile read_file_entry(const Entry& from) {
  RecordedFile file;
  file.path = from["file"].text();
  if (from.has("sidecar")) file.sidecar = from["sidecar"].text();
  std::map<std::tuple<std::string, std::uint32_t, std::uint32_t, std::string>, std::size_t> seen;
  for (const Entry& each : from["steps"].entries()) {
    RecordedStep step;
    step.file = each.has("file") ? each["file"].text() : file.path;
    step.line = each["line"].count();
    step.column = each["column"].count();
    step.source = each["source"].text();
    step.earlier = seen[{step.file, step.line, step.column, step.source}]++;
    if (each["verdict"].text() != "refuted") continue;
    step.example = read_example(each["counterexample"]);
    file.steps.push_back(std::move(step));
  }
  return file;
}

}  // namespace

Result<std::vector<RecordedFile>> read_recorded(std::string_view json) {
  const ParsedJson whole = ParsedJson::parse(json, nullptr, false);
  if (whole.is_discarded()) return tl::make_unexpected(Error{"it is not JSON"});
  try {
    std::vector<RecordedFile> files;
    for (const Entry& each : Entry(whole, "")["files"].entries()) files.push_back(read_file_entry(each));
    return files;
  } catch (const Malformed& malformed) {
    return tl::make_unexpected(Error{malformed.reason});
  }
}

}  // namespace rigor
