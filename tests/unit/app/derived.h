// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor derive` as a whole command, and notes for it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/command/run.h"

namespace rigor {

struct Derived {
  int code = 0;
  std::string out;
  std::string err;
};

inline Derived derived(std::vector<std::string> words) {
  words.insert(words.begin(), {"rigor", "derive"});
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out;
  std::ostringstream err;
  const int code = run(static_cast<int>(pointers.size()), pointers.data(), out, err);
  return {code, out.str(), err.str()};
}

/// One file of notes, gone at the end.
class HoleFile {
 public:
  explicit HoleFile(const std::string& text, const std::string& ending = ".md")
      : path_(std::filesystem::temp_directory_path() /
              ("rigor-derive-" + std::to_string(::getpid()) + "-" + std::to_string(++count) + ending)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~HoleFile() { std::filesystem::remove(path_); }
  HoleFile(const HoleFile&) = delete;
  HoleFile& operator=(const HoleFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }
  [[nodiscard]] std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

 private:
  static inline int count = 0;
  std::filesystem::path path_;
};

}  // namespace rigor
