// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "app/command/run.h"
#include "app/grammar/exit_code.h"

namespace rigor {
namespace {

/// As one word of a shell command.
std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments) {
  std::string command = "exec " + quoted(RIGOR_PROGRAM);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  std::FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no process could be started");
  Outcome outcome;
  std::array<char, 65536> buffer;
  for (std::size_t size = 0; (size = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.text.append(buffer.data(), size);
  const int status = pclose(pipe);
  outcome.code = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  return outcome;
}

Outcome run_inside(const std::vector<std::string>& arguments) {
  std::vector<const char*> words{"rigor"};
  for (const std::string& argument : arguments) words.push_back(argument.c_str());
  std::ostringstream text;
  const int code = run(static_cast<int>(words.size()), words.data(), text, text);
  return {code, text.str()};
}

int exit_code_of(const FileReport& file) {
  Report report;
  report.files.push_back(file);
  return number_of(exit_code(report, usual_rule(false)));
}

std::vector<std::string> notes_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".md" || extension == ".tex") paths.push_back(entry.path().generic_string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace rigor
