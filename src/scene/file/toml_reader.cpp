// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/toml_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/among.h"
#include "scene/file/quantity_text.h"
#include "source/suggest.h"

namespace rigor {
namespace {

const TomlEntry* entry_of(const TomlValue& table, std::string_view key) {
  const auto found = std::ranges::find(table.entries, key, &TomlEntry::key);
  return found == table.entries.end() ? nullptr : &*found;
}

bool is_kind(const TomlValue& value, TomlKind kind, std::string_view name, Diagnostics& diagnostics) {
  if (value.kind == kind) return true;
  report(diagnostics, DiagnosticKind::bad_toml, value.span,
         fmt::format("`{}` is {}, but must be {}", name, name_of(value.kind), name_of(kind)));
  return false;
}

}  // namespace

bool TomlReader::has(std::string_view key) { return find(key) != nullptr; }

const TomlValue* TomlReader::find(std::string_view key) {
  if (!is_one_of(key, asked_)) asked_.emplace_back(key);
  const TomlEntry* entry = entry_of(table_, key);
  return entry == nullptr ? nullptr : &entry->value;
}

const TomlValue* TomlReader::require(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr)
    report(diagnostics_, DiagnosticKind::bad_toml, table_.span, fmt::format("{} has no `{}`", what_, key));
  return value;
}

std::optional<std::string> TomlReader::text(std::string_view key) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : text_of(*value, key, diagnostics_);
}

std::optional<double> TomlReader::number(std::string_view key) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : number_of(*value, key, diagnostics_);
}

std::optional<std::int64_t> TomlReader::whole(std::string_view key) {
  constexpr double largest = 9e15;  // below it every whole number is a double
  const TomlValue* value = find(key);
  if (value == nullptr || !is_kind(*value, TomlKind::number, key, diagnostics_)) return std::nullopt;
  if (!value->whole || std::abs(value->number) > largest) {
    report(diagnostics_, DiagnosticKind::bad_toml, value->span,
           fmt::format("`{}` must be a whole number", key));
    return std::nullopt;
  }
  return static_cast<std::int64_t>(value->number);
}

std::optional<bool> TomlReader::truth(std::string_view key) {
  const TomlValue* value = find(key);
  if (value == nullptr || !is_kind(*value, TomlKind::boolean, key, diagnostics_)) return std::nullopt;
  return value->truth;
}

std::optional<double> TomlReader::quantity(std::string_view key, const Dimension& dimension) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : quantity_of(*value, key, dimension, diagnostics_);
}

std::optional<std::vector<double>> TomlReader::quantities(std::string_view key, const Dimension& dimension,
                                                          std::size_t count) {
  const TomlValue* value = find(key);
  return value == nullptr ? std::nullopt : quantities_of(*value, key, dimension, count, diagnostics_);
}

const std::vector<TomlValue>* TomlReader::array(std::string_view key) {
  const TomlValue* value = find(key);
  return value == nullptr || !is_kind(*value, TomlKind::array, key, diagnostics_) ? nullptr : &value->items;
}

void TomlReader::accept_all() {
  for (const TomlEntry& entry : table_.entries) asked_.push_back(entry.key);
}

void TomlReader::report_unknown() {
  for (const TomlEntry& entry : table_.entries) {
    if (is_one_of(entry.key, asked_)) continue;
    std::vector<std::string> help;
    if (const auto near = suggest(entry.key, asked_))
      help.push_back(fmt::format("did you mean `{}`?", *near));
    report(diagnostics_, DiagnosticKind::unknown_key, entry.key_span,
           fmt::format("{} has a key `{}`, which is not known", what_, entry.key), std::move(help));
  }
}

Span TomlReader::span_of(std::string_view key) const {
  const TomlEntry* entry = entry_of(table_, key);
  return entry == nullptr ? table_.span : cover(entry->key_span, entry->value.span);
}

std::optional<std::string> text_of(const TomlValue& value, std::string_view name, Diagnostics& diagnostics) {
  if (!is_kind(value, TomlKind::string, name, diagnostics)) return std::nullopt;
  return value.text;
}

std::optional<double> number_of(const TomlValue& value, std::string_view name, Diagnostics& diagnostics) {
  if (!is_kind(value, TomlKind::number, name, diagnostics)) return std::nullopt;
  if (std::isfinite(value.number)) return value.number;
  report(diagnostics, DiagnosticKind::bad_toml, value.span,
         fmt::format("`{}` is {}, but must be finite", name, value.number));
  return std::nullopt;
}

std::optional<double> quantity_of(const TomlValue& value, std::string_view name, const Dimension& dimension,
                                  Diagnostics& diagnostics) {
  if (value.kind == TomlKind::number) return number_of(value, name, diagnostics);
  if (value.kind != TomlKind::string) {
    report(diagnostics, DiagnosticKind::bad_toml, value.span,
           fmt::format("`{}` is {}, but must be {}: a string with a unit, or a number in SI units", name,
                       name_of(value.kind), name_of(dimension)));
    return std::nullopt;
  }
  const auto quantity = read_quantity(value.text);
  if (!quantity) {
    report(diagnostics, DiagnosticKind::wrong_unit, value.span, quantity.error().reason);
    return std::nullopt;
  }
  if (quantity->dimension == dimension) return quantity->value;
  report(diagnostics, DiagnosticKind::wrong_unit, value.span,
         fmt::format("`{}` is {}, but `{}` must be {}", value.text, name_of(quantity->dimension), name,
                     name_of(dimension)));
  return std::nullopt;
}

std::optional<std::vector<double>> quantities_of(const TomlValue& value, std::string_view name,
                                                 const Dimension& dimension, std::size_t count,
                                                 Diagnostics& diagnostics) {
  if (!is_kind(value, TomlKind::array, name, diagnostics)) return std::nullopt;
  if (count != 0 && value.items.size() != count) {
    report(diagnostics, DiagnosticKind::bad_toml, value.span,
           fmt::format("`{}` has {} values, but must have {}", name, value.items.size(), count));
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const TomlValue& item : value.items) {
    if (const auto number = quantity_of(item, name, dimension, diagnostics)) numbers.push_back(*number);
  }
  if (numbers.size() != value.items.size()) return std::nullopt;
  return numbers;
}

bool is_table(const TomlValue& value, std::string_view name, Diagnostics& diagnostics) {
  return is_kind(value, TomlKind::table, name, diagnostics);
}

}  // namespace rigor
