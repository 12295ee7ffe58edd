// SPDX-License-Identifier: GPL-3.0-or-later
#include "spoil.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fuzz {
namespace {

constexpr std::size_t longest = 64 * 1024;
constexpr std::size_t most_lines = 60;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// `\frac`, `\{`, a run of blanks or digits, or one byte.
std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k + 1;
    if (text[k] == '\\' && end < text.size()) {
      const bool word = is_letter(text[end++]);
      while (word && end < text.size() && is_letter(text[end])) ++end;
    } else if (text[k] == ' ') {
      while (end < text.size() && text[end] == ' ') ++end;
    }
    tokens.push_back(text.substr(k, end - k));
    k = end;
  }
  return tokens;
}

std::vector<std::string> bytes_of(const std::string& text) {
  std::vector<std::string> bytes;
  for (const char c : text) bytes.emplace_back(1, c);
  return bytes;
}

void spoil_once(std::vector<std::string>& parts, Random& random) {
  if (parts.size() < 2) return;
  const std::size_t at = random.below(parts.size());
  const std::size_t other =
      random.one_in(2) ? random.below(parts.size()) : std::min(at + 1, parts.size() - 1);
  const auto place = parts.begin() + static_cast<std::ptrdiff_t>(at);
  switch (random.below(5)) {
    case 0:
      parts.erase(place);
      break;
    case 1:
      parts.insert(place, parts[at]);
      break;
    case 2:
      std::swap(parts[at], parts[other]);
      break;
    case 3:
      parts[at] = parts[other];
      break;
    default:
      parts.insert(place, parts[other]);
      break;
  }
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line + "\n");
  return lines;
}

std::vector<Notes> notes_below(const std::vector<std::string>& folders) {
  std::vector<Notes> all;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string ending = entry.path().extension().string();
      if (!entry.is_regular_file() || (ending != ".md" && ending != ".tex") || entry.file_size() > longest)
        continue;
      std::ifstream file(entry.path(), std::ios::binary);
      std::stringstream text;
      text << file.rdbuf();
      if (!text.str().empty()) all.push_back({entry.path().string(), text.str()});
    }
  }
  std::sort(all.begin(), all.end(), [](const Notes& a, const Notes& b) { return a.path < b.path; });
  return all;
}

Notes spoilt(const std::vector<Notes>& all, Random& random) {
  const Notes& taken = random.of(all);
  const std::vector<std::string> lines = lines_of(taken.text);
  std::string text;
  const std::size_t first = lines.size() > most_lines ? random.below(lines.size() - most_lines) : 0;
  for (std::size_t k = first; k < lines.size() && k < first + most_lines; ++k) text += lines[k];
  const int times = random.between(1, 4);
  for (int k = 0; k < times; ++k) {
    auto parts = random.one_in(4) ? bytes_of(text) : tokens_of(text);
    spoil_once(parts, random);
    text.clear();
    for (const std::string& part : parts) text += part;
  }
  const bool latex = taken.path.size() > 4 && taken.path.substr(taken.path.size() - 4) == ".tex";
  return {latex ? "nowhere/notes.tex" : "nowhere/notes.md", text};
}

}  // namespace fuzz
