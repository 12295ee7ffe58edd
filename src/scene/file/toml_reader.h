// SPDX-License-Identifier: GPL-3.0-or-later
// Typed reading of a TOML table. Every mistake is a diagnostic at its place: `bad-toml` for a wrong type and
// for what is missing, `unknown-key`, `wrong-unit`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expr/tree/dimension.h"
#include "scene/file/toml_value.h"

namespace rigor {

/// Reads the keys of one table and remembers which were asked for, so that `report_unknown` finds the others.
/// A getter gives nothing where the key is missing, without a word, or where its value is wrong, with a
/// diagnostic. The table must outlive the reader.
class TomlReader {
 public:
  /// `what`: for messages, `the body`.
  TomlReader(const TomlValue& table, std::string what, Diagnostics& diagnostics)
      : table_(table), what_(std::move(what)), diagnostics_(diagnostics) {}

  [[nodiscard]] bool has(std::string_view key);
  /// The value of a key, of whatever type; null: it is missing.
  [[nodiscard]] const TomlValue* find(std::string_view key);
  /// The same, with a diagnostic where it is missing.
  [[nodiscard]] const TomlValue* require(std::string_view key);

  [[nodiscard]] std::optional<std::string> text(std::string_view key);
  [[nodiscard]] std::optional<double> number(std::string_view key);
  [[nodiscard]] std::optional<std::int64_t> whole(std::string_view key);
  [[nodiscard]] std::optional<bool> truth(std::string_view key);
  /// In SI units: `"10 cm"`, or a number, which is in SI units already.
  [[nodiscard]] std::optional<double> quantity(std::string_view key, const Dimension& dimension);
  [[nodiscard]] std::optional<std::vector<double>> quantities(std::string_view key,
                                                              const Dimension& dimension, std::size_t count);
  /// An array's items, or null.
  [[nodiscard]] const std::vector<TomlValue>* array(std::string_view key);

  /// The other keys are not judged: what they would mean is not known.
  void accept_all();
  /// A diagnostic for each key that nobody asked for, with the nearest that somebody did. Call it last.
  void report_unknown();

  [[nodiscard]] const TomlValue& table() const { return table_; }
  [[nodiscard]] Diagnostics& diagnostics() { return diagnostics_; }
  /// The key and value, or the table's place where it is missing.
  [[nodiscard]] Span span_of(std::string_view key) const;

 private:
  const TomlValue& table_;
  std::string what_;
  Diagnostics& diagnostics_;
  std::vector<std::string> asked_;
};

/// `name`: what the value is called in a message, `mass`.
[[nodiscard]] std::optional<std::string> text_of(const TomlValue& value, std::string_view name,
                                                 Diagnostics& diagnostics);
/// Finite.
[[nodiscard]] std::optional<double> number_of(const TomlValue& value, std::string_view name,
                                              Diagnostics& diagnostics);
[[nodiscard]] std::optional<double> quantity_of(const TomlValue& value, std::string_view name,
                                                const Dimension& dimension, Diagnostics& diagnostics);
/// An array of exactly `count` quantities of one dimension; with a count of 0, of any number.
[[nodiscard]] std::optional<std::vector<double>> quantities_of(const TomlValue& value, std::string_view name,
                                                               const Dimension& dimension, std::size_t count,
                                                               Diagnostics& diagnostics);
/// Is it a table? A diagnostic if not.
[[nodiscard]] bool is_table(const TomlValue& value, std::string_view name, Diagnostics& diagnostics);

}  // namespace rigor
