// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/outputs.h"

#include <filesystem>

namespace rigor {

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error) && !error) return true;
  const auto place = [](const std::string& path) {
    std::error_code none;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
  };
  return place(a) == place(b);
}

std::optional<std::string> overwritten_by(const std::string& path, const SourceMap& sources) {
  for (FileId file = 0; file < sources.size(); ++file) {
    if (same_file(path, sources.path(file))) return sources.path(file);
  }
  return std::nullopt;
}

}  // namespace rigor
