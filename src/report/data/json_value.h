// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as the writers of this room build it: members stay in the order in which they were given.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace rigor {

using Json = nlohmann::ordered_json;

/// `null` stands for what is not there.
template <class Value>
[[nodiscard]] Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}
template <class Value>
[[nodiscard]] Json or_null(const Value& value) {
  return value.empty() ? Json(nullptr) : Json(value);
}

template <class Items, class ValueOf>
[[nodiscard]] Json array_of(const Items& items, const ValueOf& value_of) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(value_of(item));
  return array;
}

/// What is not UTF-8 is replaced.
[[nodiscard]] inline std::string to_text(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rigor
