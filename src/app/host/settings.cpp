// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/settings.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/grammar/fail_on.h"
#include "app/grammar/limits.h"
#include "scene/file/toml_reader.h"
#include "source/read_file.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

class SettingsReader {
 public:
  SettingsReader(const TomlValue& top, fs::path folder, Diagnostics& diagnostics)
      : reader_(top, "the settings file", diagnostics), folder_(std::move(folder)) {}

  Settings read() {
    Settings settings;
    for (const std::string& file : texts("files")) settings.files.push_back(in_folder(file));
    read_sidecars(settings);
    settings.strict = reader_.truth("strict");
    read_fail_on_list(settings);
    if (const auto jobs = whole("jobs", 0, most_jobs)) settings.jobs = static_cast<std::size_t>(*jobs);
    settings.effort = whole("effort", 1, most_effort);
    reader_.report_unknown();
    return settings;
  }

 private:
  void complain(std::string_view key, std::string message) {
    report(reader_.diagnostics(), DiagnosticKind::bad_toml, reader_.span_of(key), std::move(message));
  }

  [[nodiscard]] std::string in_folder(const std::string& path) const {
    return folder_.empty() ? path : (folder_ / path).lexically_normal().generic_string();
  }

  /// An array of strings that are not empty.
  std::vector<std::string> texts(std::string_view key) {
    std::vector<std::string> all;
    if (!reader_.has(key)) return all;
    const auto* items = reader_.array(key);
    if (items == nullptr) return all;
    for (const TomlValue& item : *items) {
      const auto text = text_of(item, key, reader_.diagnostics());
      if (text && text->empty()) complain(key, fmt::format("`{}` has an empty entry", key));
      if (text && !text->empty()) all.push_back(*text);
    }
    if (items->empty()) complain(key, fmt::format("`{}` is empty", key));
    return all;
  }

  void read_sidecars(Settings& settings) {
    const TomlValue* table = reader_.find("sidecars");
    if (table == nullptr || !is_table(*table, "sidecars", reader_.diagnostics())) return;
    for (const TomlEntry& entry : table->entries) {
      const auto sidecar = text_of(entry.value, entry.key, reader_.diagnostics());
      if (sidecar) settings.sidecars[place_on_disk(in_folder(entry.key))] = in_folder(*sidecar);
    }
  }

  void read_fail_on_list(Settings& settings) {
    for (const std::string& word : texts("fail-on")) {
      const auto read = read_fail_on(word);
      if (!read) {
        complain("fail-on", fmt::format("`fail-on`: {}", read.error().reason));
        continue;
      }
      if (!settings.fail_on) settings.fail_on.emplace();
      settings.fail_on->insert(read->begin(), read->end());
    }
    if (settings.fail_on && settings.strict)
      complain("fail-on", "`strict` and `fail-on` both say what fails; only one of them can be given");
  }

  std::optional<std::uint64_t> whole(std::string_view key, std::uint64_t least, std::uint64_t most) {
    const auto number = reader_.whole(key);
    if (!number) return std::nullopt;
    const auto value = static_cast<std::uint64_t>(*number);
    if (*number >= 0 && value >= least && value <= most) return value;
    complain(key, fmt::format("`{}` is a whole number from {} to {}", key, least, most));
    return std::nullopt;
  }

  TomlReader reader_;
  fs::path folder_;
};

}  // namespace

Settings read_settings(const std::string& path, SourceMap& sources, Diagnostics& diagnostics) {
  auto text = read_file(path);
  if (!text) {
    const FileId file = sources.add(path, "");
    report(diagnostics, DiagnosticKind::unreadable_file, {file, 0, 0}, text.error().reason);
    return {};
  }
  Diagnostics mended = mend_text(*text, 0);
  const FileId file = sources.add(path, std::move(*text));
  for (Diagnostic& diagnostic : mended) diagnostic.span.file = file;
  diagnostics.insert(diagnostics.end(), mended.begin(), mended.end());
  const auto top = parse_toml(sources, file, diagnostics);
  if (!top) return {};
  return SettingsReader(*top, fs::path(path).parent_path(), diagnostics).read();
}

std::string place_on_disk(const std::string& path) {
  std::error_code none;
  return fs::weakly_canonical(fs::absolute(path, none), none).generic_string();
}

}  // namespace rigor
