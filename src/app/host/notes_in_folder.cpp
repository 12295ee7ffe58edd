// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/notes_in_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include "base/among.h"
#include "latex/document/document.h"
#include "source/read_file.h"
#include "source/system_error.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_folder = 64;

bool has_notes_ending(const fs::path& file) {
  return is_one_of(file.extension().string(), {".tex", ".ltx", ".latex", ".md", ".markdown", ".qmd"});
}

/// Where programs put what they make: pages, dependencies, caches.
bool is_passed_over(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (name.starts_with('.') || name.starts_with("cmake-build-")) return true;
  if (is_one_of(name, {"build", "_build", "_site", "_book", "_freeze", "node_modules", "__pycache__"}))
    return true;
  std::error_code none;
  return fs::exists(folder / "CMakeCache.txt", none) || fs::exists(folder / "CACHEDIR.TAG", none);
}

/// Adds the candidates of one folder, and then those below it.
Result<void> collect(const fs::path& folder, std::size_t depth, FolderNotes& found,
                     std::vector<fs::path>& candidates) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path& path = at->path();
    std::error_code none;
    const fs::file_status status = at->symlink_status(none);
    const bool is_hidden = path.filename().string().starts_with('.');
    if (fs::is_directory(status))
      folders.push_back(path);
    else if (fs::is_symlink(status) && !is_hidden && (has_notes_ending(path) || fs::is_directory(path, none)))
      ++found.links;
    else if (fs::is_regular_file(status) && !is_hidden && has_notes_ending(path))
      candidates.push_back(path);
  }
  if (error) return tl::make_unexpected(error_of(error));
  for (const fs::path& each : folders) {
    if (depth == deepest_folder || is_passed_over(each)) {
      ++found.folders;
      continue;
    }
    if (auto below = collect(each, depth + 1, found, candidates); !below) return below;
  }
  return {};
}

struct Candidate {
  std::string path;
  fs::path real;
  bool is_notes = false;
  std::set<fs::path> reads = {};  // with \input, directly or not
};

fs::path real_path(const fs::path& path) {
  std::error_code none;
  return fs::weakly_canonical(path, none);
}

/// What cannot be read is left to the check, which says so.
Candidate look_into(const fs::path& path) {
  Candidate candidate{path.lexically_normal().generic_string(), real_path(path)};
  auto text = read_file(path.string());
  if (!text) {
    candidate.is_notes = true;
    return candidate;
  }
  SourceMap sources;
  static_cast<void>(mend_notes(*text, 0));
  const FileId file = sources.add(path.string(), std::move(*text));
  Diagnostics diagnostics;
  const Document document = read_document(sources, file, diagnostics);
  for (FileId other = file + 1; other < sources.size(); ++other)
    candidate.reads.insert(real_path(sources.path(other)));
  const bool says_something = std::ranges::any_of(document.items, [](const Item& item) {
    return std::holds_alternative<Display>(item) || std::holds_alternative<DirectiveLine>(item);
  });
  const bool lost_something = std::ranges::any_of(diagnostics, [](const Diagnostic& diagnostic) {
    return is_one_of(diagnostic.kind, std::array{DiagnosticKind::unbalanced, DiagnosticKind::missing_input,
                                                 DiagnosticKind::input_outside});
  });
  candidate.is_notes = says_something || lost_something;
  return candidate;
}

}  // namespace

Result<FolderNotes> notes_in_folder(const std::string& folder) {
  FolderNotes found;
  std::vector<fs::path> paths;
  if (auto collected = collect(folder, 0, found, paths); !collected)
    return tl::make_unexpected(collected.error());
  std::ranges::sort(paths);
  std::vector<Candidate> candidates;
  std::set<fs::path> read;  // by another file
  for (const fs::path& path : paths) {
    const Candidate& added = candidates.emplace_back(look_into(path));
    for (const fs::path& other : added.reads)
      if (other != added.real) read.insert(other);
  }
  std::set<fs::path> covered;
  std::vector<const Candidate*> roots;
  const auto take = [&](const Candidate& root) {
    roots.push_back(&root);
    covered.insert(root.real);
    covered.insert(root.reads.begin(), root.reads.end());
  };
  for (const Candidate& each : candidates)
    if (!read.contains(each.real)) take(each);
  for (const Candidate& each : candidates)  // those in circles
    if (!covered.contains(each.real)) take(each);
  found.read_by_others = static_cast<std::uint32_t>(candidates.size() - roots.size());
  for (const Candidate* root : roots) {
    if (root->is_notes)
      found.files.push_back(root->path);
    else
      ++found.without_displays;
  }
  std::ranges::sort(found.files, {}, [](const std::string& path) { return fs::path(path); });
  return found;
}

std::string print_passed_over(const FolderNotes& found) {
  std::vector<std::string> parts;
  const auto add = [&](std::uint32_t count, std::string_view one, std::string_view several) {
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? one : several));
  };
  add(found.without_displays, "file without displayed equations", "files without displayed equations");
  add(found.read_by_others, "file that another one reads", "files that others read");
  add(found.folders, "hidden or build folder", "hidden or build folders");
  add(found.links, "link", "links");
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace rigor
