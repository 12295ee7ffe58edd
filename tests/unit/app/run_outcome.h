// SPDX-License-Identifier: GPL-3.0-or-later
// The program run on words and a standard input, and a folder of its own for the files it needs.
#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/run.h"
#include "source/write_file.h"

namespace rigor {

struct RunOutcome {
  int code = 0;
  std::string out;
  std::string err;
};

[[nodiscard]] inline RunOutcome run_on(const std::vector<std::string>& words, const std::string& input = "") {
  std::vector<const char*> pointers{"rigor"};
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out;
  std::ostringstream err;
  std::istringstream in(input);
  const int code = run(static_cast<int>(pointers.size()), pointers.data(), out, err, in);
  return {code, out.str(), err.str()};
}

/// Empty at first, and gone with its object.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::string_view name)
      : folder_(std::filesystem::temp_directory_path() / fmt::format("rigor-{}-{}", name, getpid())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ScratchFolder() {
    std::error_code none;
    std::filesystem::remove_all(folder_, none);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Writes a file, with the folders above it; its path.
  std::string write(const std::string& name, std::string_view text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    static_cast<void>(write_file(path.string(), text));
    return path.string();
  }
  [[nodiscard]] std::string path(const std::string& name = "") const {
    return name.empty() ? folder_.string() : (folder_ / name).string();
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace rigor
