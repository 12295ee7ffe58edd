// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/notes_to_check.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "app/host/notes_in_folder.h"
#include "base/utf8.h"
#include "latex/text/format.h"

namespace rigor {
namespace {

constexpr std::size_t most_input = std::size_t{64} << 20;  // bytes, as for a file

Result<std::string> all_of(std::istream& in) {
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most_input) return refuse("the standard input has more than 64 MiB");
  }
  return text;
}

Result<FolderNotes> notes_below(const std::string& folder) {
  auto found = notes_in_folder(folder);
  if (!found) return refuse(fmt::format("{}: {}", printable(folder), found.error().reason));
  if (!found->files.empty()) return found;
  const std::string others = print_passed_over(*found);
  return refuse(fmt::format("{}: there are no notes (.tex, .md) with displayed equations{}{}",
                            printable(folder), others.empty() ? "" : "; passed over: ", others));
}

}  // namespace

Result<NotesToCheck> notes_to_check(const CheckCommand& command, const Settings& settings, std::istream& in) {
  NotesToCheck notes;
  std::set<std::string> seen;
  const auto add = [&](const std::string& path) {
    const std::string place = place_on_disk(path);
    if (!seen.insert(place).second) return;
    NotesToCheck::Item& item = notes.items.emplace_back();
    item.path = path;
    if (const auto sidecar = settings.sidecars.find(place); sidecar != settings.sidecars.end())
      item.sidecar = sidecar->second;
    if (command.sidecar) item.sidecar = command.sidecar;
  };
  for (const std::string& path : command.files.empty() ? settings.files : command.files) {
    std::error_code none;
    if (path == standard_input) {
      auto text = all_of(in);
      if (!text) return tl::make_unexpected(text.error());
      notes.items.push_back({command.stdin_name.value_or(path), std::move(*text), command.sidecar});
    } else if (std::filesystem::is_directory(path, none)) {
      const auto found = notes_below(path);
      if (!found) return tl::make_unexpected(found.error());
      for (const std::string& file : found->files) add(file);
      if (const std::string others = print_passed_over(*found); !others.empty())
        notes.remarks.push_back(fmt::format("passed over in {}: {}", printable(path), others));
    } else {
      add(path);
    }
  }
  return notes;
}

}  // namespace rigor
