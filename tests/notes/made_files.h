// SPDX-License-Identifier: GPL-3.0-or-later
// The files that run/cases.txt names with `@`: too large or too strange to keep. Its foot says what is in
// each.
#pragma once

#include <string>

namespace rigor {

/// A folder of its own for what a test writes, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Writes the file and returns its path. Throws std::out_of_range for a name that no recipe has.
[[nodiscard]] std::string make_file(const std::string& name, const TemporaryFolder& folder);

}  // namespace rigor
