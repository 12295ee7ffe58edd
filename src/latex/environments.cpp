// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/environments.h"

#include <algorithm>
#include <array>

#include "latex/ascii.h"

namespace rigor {
namespace {

constexpr std::size_t longest_name = 200;  // of an environment, with its `\begin`

constexpr auto displays = std::to_array<std::string_view>(
    {"IEEEeqnarray", "align", "alignat", "darray", "displaymath", "dmath", "empheq", "eqnarray", "equation",
     "flalign", "gather", "multline", "xalignat", "xxalignat"});
constexpr auto with_argument =
    std::to_array<std::string_view>({"IEEEeqnarray", "alignat", "empheq", "xalignat", "xxalignat"});
constexpr auto with_options = std::to_array<std::string_view>({"IEEEeqnarray", "dmath", "empheq"});
constexpr auto verbatims =
    std::to_array<std::string_view>({"Verbatim", "comment", "lstlisting", "minted", "verbatim"});

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
  if (name.ends_with('*')) name.remove_suffix(1);
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The name in `\begin{name}`, for `mark` = `\begin`, where nothing else stands in `body`.
std::string_view name_in(std::string_view body, std::string_view mark) {
  if (!body.starts_with(mark) || !body.ends_with('}')) return {};
  body = without_blanks_around(body.substr(mark.size()));
  if (!body.starts_with('{')) return {};
  const std::string_view name = without_blanks_around(body.substr(1, body.size() - 2));
  return is_display_environment(name) ? name : std::string_view();
}

void set(EnvironmentAliases::Names& names, std::string_view control, std::string_view environment) {
  if (!environment.empty()) {
    names.insert_or_assign(std::string(control), std::string(environment));
  } else if (const auto old = names.find(control); old != names.end()) {
    names.erase(old);
  }
}

}  // namespace

bool is_display_environment(std::string_view name) { return contains(displays, name); }
bool takes_argument(std::string_view name) { return contains(with_argument, name); }
bool takes_options(std::string_view name) { return contains(with_options, name); }
bool is_verbatim_environment(std::string_view name) { return contains(verbatims, name); }

bool opens_display(std::string_view text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("$$") || rest.starts_with("\\[")) return true;
    if (rest.starts_with("\\begin{")) {
      const std::size_t end = rest.substr(0, longest_name).find('}');
      if (end != std::string_view::npos && is_display_environment(rest.substr(7, end - 7))) return true;
    }
    if (text[at] == '\\') ++at;
  }
  return false;
}

void EnvironmentAliases::define(std::string_view control, std::string_view body) {
  body = without_blanks_around(body);
  set(begins, control, name_in(body, "\\begin"));
  set(ends, control, name_in(body, "\\end"));
}

}  // namespace rigor
