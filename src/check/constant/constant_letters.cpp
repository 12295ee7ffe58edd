// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/constant_letters.h"

#include "base/ascii.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

/// `electrons`, `electron's`, `electrons'`
std::string_view singular(std::string_view word) {
  while (word.ends_with('\'') || word.ends_with('-')) word.remove_suffix(1);
  if (word.ends_with("'s")) word.remove_suffix(2);
  constexpr std::size_t shortest = 4;  // of a plural: `ions`
  if (word.size() >= shortest && word.ends_with('s') && !word.ends_with("ss")) word.remove_suffix(1);
  return word;
}

/// `m_{\text{e}}`, `m_{\rm e}` and `m_{e}` are `m_e`; `\mathrm{u}` stays.
std::string plain_name(std::string_view name) {
  const std::size_t labels = name.find('_');
  if (labels == std::string_view::npos) return std::string(name);
  std::string plain(name.substr(0, labels));
  for (std::size_t at = labels; at < name.size();) {
    bool skipped = false;
    for (const std::string_view face : {"\\text", "\\mathrm", "\\textrm", "\\rm"}) {
      const std::size_t end = at + face.size();
      if (!name.substr(at).starts_with(face) || (end < name.size() && is_letter(name[end]))) continue;
      at = end;
      skipped = true;
      break;
    }
    if (skipped) continue;
    if (name[at] != '{' && name[at] != '}' && name[at] != ' ') plain += name[at];
    ++at;
  }
  return plain;
}

bool is_among(std::string_view name, std::string_view names) {
  while (!names.empty()) {
    const std::size_t end = names.find(' ');
    if (plain_name(names.substr(0, end)) == name) return true;
    names.remove_prefix(end == std::string_view::npos ? names.size() : end + 1);
  }
  return false;
}

}  // namespace

std::string spoken_words(std::string_view text) {
  const std::string small = lowered(text);
  const std::vector<std::string_view> words = words_of(small);
  std::string spoken = " ";
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool unit = words[k] == "electron" && k + 1 < words.size() && words[k + 1].starts_with("volt");
    if (!unit) spoken += std::string(singular(words[k])) + " ";
  }
  return spoken;
}

bool speaks_of(const PhysicalConstant& constant, std::string_view spoken) {
  std::string_view words = constant.words;
  while (!words.empty()) {
    const std::size_t end = words.find('|');
    if (spoken.find(spoken_words(words.substr(0, end))) != std::string_view::npos) return true;
    words.remove_prefix(end == std::string_view::npos ? words.size() : end + 1);
  }
  return false;
}

bool is_own_name(const PhysicalConstant& constant, std::string_view name) {
  return is_among(plain_name(name), constant.own);
}

bool is_usual_name(const PhysicalConstant& constant, std::string_view name) {
  return is_own_name(constant, name) || is_among(plain_name(name), constant.usual);
}

std::vector<const PhysicalConstant*> constants_of(std::string_view name, std::string_view spoken) {
  const std::string plain = plain_name(name);
  std::vector<const PhysicalConstant*> found;
  for (const PhysicalConstant& constant : physical_constants()) {
    if (is_among(plain, constant.own) || is_among(plain, constant.usual) ||
        (is_among(plain, constant.spoken) && speaks_of(constant, spoken)))
      found.push_back(&constant);
  }
  return found;
}

}  // namespace rigor
