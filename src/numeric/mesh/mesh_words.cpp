// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh_words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "base/ascii.h"

namespace rigor {
std::string_view MeshWords::next_on_line() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  if (at_ < text_.size() && text_[at_] == '#') {
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    return {};
  }
  while (at_ < text_.size() && !is_blank(text_[at_]) && text_[at_] != '\n') ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view MeshWords::next() {
  for (;;) {
    if (const std::string_view word = next_on_line(); !word.empty()) return word;
    if (!next_line()) return {};
  }
}

bool MeshWords::next_line() {
  const auto end = text_.find('\n', at_);
  if (end == std::string_view::npos) {
    at_ = text_.size();
    return false;
  }
  at_ = end + 1;
  ++line_;
  return true;
}

tl::unexpected<Error> MeshWords::refuse(std::string_view reason) const {
  return rigor::refuse(fmt::format("line {}: {}", line_, reason));
}

std::optional<double> finite_number(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_out_of_range = error == std::errc::result_out_of_range;  // and what is too small is no reason
  if (is_out_of_range) value = std::strtod(std::string(word).c_str(), nullptr);
  if ((error != std::errc() && !is_out_of_range) || end != word.data() + word.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string shown(std::string_view word) {
  constexpr std::size_t most = 24;
  std::string text;
  for (const char c : word.substr(0, most)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > most ? "…" : "");
}

}  // namespace rigor
