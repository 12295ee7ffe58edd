// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs that look at what was written: Chromium, pdflatex, pdftotext.
#pragma once

#include <string>

namespace rigor {

/// A new folder of this process, which vanishes with it.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// Is the program there? If not, a line says so, which makes CTest skip the test.
[[nodiscard]] bool is_there(const std::string& program);

/// What a shell command prints on both streams.
[[nodiscard]] std::string printed_by(const std::string& command);

/// Chromium with arguments of its own, on a file.
[[nodiscard]] std::string chromium(const std::string& arguments, const std::string& file);

void write_file(const std::string& path, const std::string& text);

}  // namespace rigor
