// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/asked_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "base/among.h"
#include "base/utf8.h"
#include "source/suggest.h"

namespace rigor {
namespace {

std::optional<std::uint32_t> line_number(const std::string& place) {
  std::uint32_t line = 0;
  const char* end = place.data() + place.size();
  const auto [last, error] = std::from_chars(place.data(), end, line);
  return error == std::errc() && last == end && line > 0 ? std::optional(line) : std::nullopt;
}

/// `6` for `(6)`.
std::string_view without_brackets(std::string_view tag) {
  const bool bracketed = tag.size() > 1 && tag.front() == '(' && tag.back() == ')';
  return bracketed ? tag.substr(1, tag.size() - 2) : tag;
}

/// By its tag, its label or a heading.
bool is_named(const EquationPlace& place, const std::string& asked) {
  const bool tagged = !place.tag.empty() && without_brackets(place.tag) == without_brackets(asked);
  return tagged || (!place.label.empty() && place.label == asked) || is_one_of(asked, place.headings);
}

}  // namespace

/// A number that is a tag is not a line.
bool AskedPlaces::is_at(const EquationPlace& place, const std::string& asked) const {
  if (is_named(place, asked)) return true;
  const auto line = line_number(asked);
  const bool is_name =
      std::ranges::any_of(places_, [&](const EquationPlace& other) { return is_named(other, asked); });
  if (!line || is_name || place.span.file != file_) return false;
  return sources_.line_column(file_, place.span.begin).line <= *line &&
         *line <= sources_.line_column(file_, place.span.end).line;
}

bool AskedPlaces::wants(std::size_t which) const {
  return asked_.empty() ||
         std::ranges::any_of(asked_, [&](const std::string& asked) { return is_at(places_[which], asked); });
}

bool AskedPlaces::are_all_known(const std::string& path, std::ostream& err) const {
  std::vector<std::string> names;
  for (const EquationPlace& place : places_) {
    if (!place.tag.empty()) names.push_back(place.tag);
    if (!place.label.empty()) names.push_back(place.label);
    names.insert(names.end(), place.headings.begin(), place.headings.end());
  }
  bool known = true;
  for (const std::string& asked : asked_) {
    if (std::ranges::any_of(places_, [&](const EquationPlace& place) { return is_at(place, asked); }))
      continue;
    known = false;
    err << fmt::format("rigor: {}: there is no equation at `{}`", printable(path), printable(asked));
    if (const auto near = suggest(asked, names); near && !line_number(asked))
      err << fmt::format("; did you mean `{}`?", printable(*near));
    err << "\n";
  }
  return known;
}

}  // namespace rigor
