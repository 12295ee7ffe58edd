// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/sample_bodies.h"

#include <filesystem>

#include "base/utf8.h"
#include "scene/file/body_file.h"
#include "source/render.h"

namespace rigor {

std::vector<std::string> body_folders(const std::string& beside) {
  const std::filesystem::path folder = std::filesystem::path(beside).parent_path();
  return {(folder / "bodies").string(), (folder / ".." / "bodies").lexically_normal().string(), "bodies",
          "derivations/bodies"};
}

ExitCode read_bodies(const std::vector<std::string>& names, const std::string& beside, SourceMap& sources,
                     std::vector<Body>& bodies, std::ostream& err) {
  for (const std::string& name : names) {
    std::vector<std::string> paths;
    std::error_code error;
    const auto found = find_body(name, body_folders(beside));
    if (std::filesystem::is_directory(name, error) && (!found || *found == name)) {
      for (const std::string& each : body_names({name}))
        paths.push_back((std::filesystem::path(name) / (each + ".toml")).string());
    } else if (found) {
      paths.push_back(*found);
    }
    if (paths.empty()) {
      const bool folder = std::filesystem::is_directory(name, error);
      const std::string reason =
          folder || found ? "there is no body in the folder `" + name + "`" : found.error().reason;
      err << "rigor: " << printable(reason) << "\n";
      return ExitCode::no_input;
    }
    for (const std::string& path : paths) {
      Diagnostics diagnostics;
      auto body = read_body_file(path, sources, diagnostics);
      for (const Diagnostic& diagnostic : diagnostics) err << render(diagnostic, sources);
      if (!body) return ExitCode::wrong;
      bodies.push_back(std::move(*body));
    }
  }
  return ExitCode::ok;
}

}  // namespace rigor
