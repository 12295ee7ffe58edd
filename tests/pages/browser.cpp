// SPDX-License-Identifier: GPL-3.0-or-later
#include "browser.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace rigor {

Folder::Folder() {
  static int made = 0;
  path_ = (std::filesystem::temp_directory_path() /
           ("rigor-pages-" + std::to_string(getpid()) + "-" + std::to_string(++made)))
              .string();
  std::filesystem::create_directories(path_);
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

bool is_there(const std::string& program) {
  if (!printed_by("command -v " + program).empty()) return true;
  std::cout << "skipped: no " << program << " here\n";
  return false;
}

std::string printed_by(const std::string& command) {
  std::FILE* pipe = popen(("( " + command + " ) 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no process could be started");
  std::string text;
  std::array<char, 65536> buffer;
  for (std::size_t size = 0; (size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), size);
  pclose(pipe);
  return text;
}

std::string chromium(const std::string& arguments, const std::string& file) {
  const Folder profile;
  return printed_by(
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --user-data-dir='" +
      profile.path("profile") + "' " + arguments + " 'file://" + file + "' 2>/dev/null");
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace rigor
