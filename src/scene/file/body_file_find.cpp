// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <system_error>

#include "base/among.h"
#include "scene/file/body_file.h"
#include "source/suggest.h"

namespace rigor {

namespace fs = std::filesystem;

std::vector<std::string> body_names(const std::vector<std::string>& folders) {
  std::set<std::string> names;
  for (const std::string& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      if (at->path().extension() == ".toml") names.insert(at->path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

Result<std::string> find_body(const std::string& name, const std::vector<std::string>& folders) {
  const auto exists = [](const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
  };
  if (name.find('/') != std::string::npos || name.ends_with(".toml")) {
    if (exists(name)) return name;
    return refuse(fmt::format("there is no file `{}`", name));
  }
  for (const std::string& folder : folders) {
    const fs::path path = fs::path(folder) / (name + ".toml");
    if (!name.empty() && exists(path)) return path.string();
  }
  std::vector<std::string> searched;
  for (const std::string& folder : folders) {
    if (!is_one_of(folder, searched)) searched.push_back(folder);
  }
  const std::vector<std::string> names = body_names(folders);
  std::string reason = fmt::format("there is no body `{}` in `{}`", name, fmt::join(searched, "`, `"));
  if (const auto near = suggest(name, names))
    reason += fmt::format("; did you mean `{}`?", *near);
  else if (!names.empty())
    reason += fmt::format("; there are {}", fmt::join(names, ", "));
  return refuse(reason);
}

}  // namespace rigor
