// SPDX-License-Identifier: GPL-3.0-or-later
// The only file with toml++, which is compiled without exceptions.
#include "scene/file/toml_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/utf8.h"
#include "scene/file/toml_scan.h"

// toml++ asserts what broken files such as `a = [}` violate, and reports them just after. Without NDEBUG
// such a file would end the program, and with it clang takes the assertion for granted: we have neither.
#undef NDEBUG
#define TOML_ASSERT(...) static_assert(true)
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace rigor {
namespace {

constexpr std::size_t most_bytes = std::size_t{16} << 20;
constexpr int most_depth = 64;

class TomlConverter {
 public:
  TomlConverter(const SourceMap& sources, FileId file) : sources_(sources), file_(file) {}

  [[nodiscard]] Span span_of(const toml::source_region& region) const {
    const std::uint32_t begin = offset_of(region.begin);
    return {file_, begin, std::max(begin, offset_of(region.end))};
  }

  TomlValue value_of(const toml::node& node) const {
    TomlValue value;
    value.span = span_of(node.source());
    if (const auto* text = node.as_string()) {
      value.kind = TomlKind::string;
      value.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
      value.kind = TomlKind::number;
      value.whole = true;
      value.number = static_cast<double>(integer->get());
    } else if (const auto* number = node.as_floating_point()) {
      value.kind = TomlKind::number;
      value.number = number->get();
    } else if (const auto* truth = node.as_boolean()) {
      value.kind = TomlKind::boolean;
      value.truth = truth->get();
    } else if (const auto* array = node.as_array()) {
      value.kind = TomlKind::array;
      for (const toml::node& item : *array) value.items.push_back(value_of(item));
    } else if (const auto* table = node.as_table()) {
      add_entries(value, *table);
    } else {
      value.kind = TomlKind::date;
    }
    return value;
  }

 private:
  void add_entries(TomlValue& value, const toml::table& table) const {
    for (const auto& [key, node] : table)
      value.entries.push_back({std::string(key.str()), span_of(key.source()), value_of(node)});
    std::ranges::stable_sort(value.entries, [](const TomlEntry& a, const TomlEntry& b) {
      return a.key_span.begin < b.key_span.begin;
    });
  }

  /// toml++ counts lines and columns from 1, columns in code points.
  [[nodiscard]] std::uint32_t offset_of(const toml::source_position& position) const {
    if (position.line == 0) return 0;
    const std::uint32_t start = sources_.line_start(file_, position.line);
    const std::string_view line = sources_.line_text(file_, position.line);
    std::size_t at = 0;
    for (toml::source_index column = 1; column < position.column && at < line.size(); ++column)
      static_cast<void>(next_code_point(line, at));
    return start + static_cast<std::uint32_t>(at);
  }

  const SourceMap& sources_;
  FileId file_;
};

/// How many tables and arrays are in one another; a loop, since it is asked before anything recurses.
bool is_too_deep(const toml::node& root) {
  std::vector<std::pair<const toml::node*, int>> open{{&root, 0}};
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    if (depth > most_depth) return true;
    if (const auto* array = node->as_array())
      for (const toml::node& item : *array) open.emplace_back(&item, depth + 1);
    if (const auto* table = node->as_table())
      for (const auto& [key, item] : *table) open.emplace_back(&item, depth + 1);
  }
  return false;
}

/// toml++ says `Error while parsing key-value pair: cannot redefine existing string 'mass' as integer`.
std::string message_of(std::string_view description) {
  if (const auto redefined = description.find("cannot redefine existing");
      redefined != std::string_view::npos) {
    const auto open = description.find('\'', redefined);
    const auto close = open == std::string_view::npos ? open : description.find('\'', open + 1);
    if (close != std::string_view::npos)
      return fmt::format("`{}` is given twice", description.substr(open + 1, close - open - 1));
  }
  constexpr std::string_view opening = "Error while parsing ";
  if (description.starts_with(opening)) description.remove_prefix(opening.size());
  return fmt::format("this is not TOML: {}", description);
}

}  // namespace

std::string_view name_of(TomlKind kind) {
  constexpr auto names = std::to_array<std::string_view>(
      {"a string", "a number", "true or false", "a date", "an array", "a table"});
  return names[static_cast<std::size_t>(kind)];
}

std::optional<TomlValue> parse_toml(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  const std::string_view text = sources.text(file);
  if (text.size() > most_bytes) {
    diagnostics.push_back(
        {DiagnosticKind::bad_toml, {file, 0, 0}, fmt::format("the file has more than {} bytes", most_bytes)});
    return std::nullopt;
  }
  const TomlConverter converter(sources, file);
  if (const auto flaw = find_toml_flaw(text)) {
    const Span span{file, static_cast<std::uint32_t>(flaw->begin), static_cast<std::uint32_t>(flaw->end)};
    diagnostics.push_back({DiagnosticKind::bad_toml, span, flaw->message});
    return std::nullopt;
  }
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    diagnostics.push_back({DiagnosticKind::bad_toml, converter.span_of(parsed.error().source()),
                           message_of(parsed.error().description())});
    return std::nullopt;
  }
  if (is_too_deep(parsed.table())) {
    diagnostics.push_back({DiagnosticKind::bad_toml, {file, 0, 0}, "tables are nested too deep"});
    return std::nullopt;
  }
  TomlValue top = converter.value_of(parsed.table());
  top.span = {file, 0, 0};
  return top;
}

}  // namespace rigor
