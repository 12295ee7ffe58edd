// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/environments.h"

#include <algorithm>
#include <utility>

#include "base/ascii.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

constexpr std::size_t longest_beginning = 200;  // of an environment, with its `\begin`

bool contains(const WordSet& names, std::string_view name) {
  if (name.ends_with('*')) name.remove_suffix(1);
  return names.contains(name);
}

/// Without white space at both ends, and without comments at the beginning.
std::string_view past_gaps(std::string_view text) {
  text = without_blanks_around(text);
  while (text.starts_with('%'))
    text = without_blanks_around(text.substr(std::min(text.find('\n'), text.size())));
  return text;
}

/// Reads the delimiters in the bodies of definitions, one after the other.
class DelimiterText {
 public:
  explicit DelimiterText(std::string_view text) : rest_(past_gaps(text)) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_ = past_gaps(rest_.substr(word.size()));
    return true;
  }

  /// The text in `{…}`, which holds no braces.
  std::optional<std::string_view> take_group() {
    const std::size_t end = rest_.starts_with('{') ? rest_.find_first_of("{}", 1) : std::string_view::npos;
    if (end == std::string_view::npos || rest_[end] == '{') return std::nullopt;
    const std::string_view inside = past_gaps(rest_.substr(1, end - 1));
    rest_ = past_gaps(rest_.substr(end + 1));
    return inside;
  }

 private:
  std::string_view rest_;
};

/// `name` fills a display: the environment that lays out the same.
std::string_view filled(std::string_view name) {
  static const WordTable fillings("aligned align  gathered gather  split align");
  return fillings.find(name);
}

template <class Names, class Value>
void set(Names& names, std::string_view key, std::optional<Value> value) {
  if (value) {
    names.insert_or_assign(std::string(key), std::move(*value));
  } else if (const auto old = names.find(key); old != names.end()) {
    names.erase(old);
  }
}

void set(std::set<std::string, std::less<>>& names, std::string_view name, bool belongs) {
  if (belongs) {
    names.emplace(name);
  } else if (const auto old = names.find(name); old != names.end()) {
    names.erase(old);
  }
}

std::optional<OwnDisplay> opening_in(const OwnBodies& bodies) {
  auto display = bodies.parameters < 0 ? std::nullopt : display_opening(bodies.opening);
  if (!display) return std::nullopt;
  display->parameters = bodies.parameters;
  display->optional_first = bodies.optional_first;
  return display;
}

}  // namespace

bool is_display_environment(std::string_view name) {
  static const WordSet names(
      "IEEEeqnarray align alignat darray displaymath dmath empheq eqnarray equation flalign gather "
      "multline numcases subeqnarray subnumcases xalignat xxalignat");
  return contains(names, name);
}
bool takes_argument(std::string_view name) {
  static const WordSet names("IEEEeqnarray alignat empheq xalignat xxalignat");
  return contains(names, name);
}
bool takes_options(std::string_view name) {
  static const WordSet names("IEEEeqnarray dmath empheq");
  return contains(names, name);
}
bool is_verbatim_environment(std::string_view name) {
  static const WordSet names(
      "BVerbatim LVerbatim SaveVerbatim Verbatim VerbatimOut alltt comment filecontents lstlisting "
      "luacode minted pycode tcblisting verbatim verbatimtex");
  return contains(names, name);
}
bool is_unread_display(std::string_view name) {
  static const WordSet names("DispWithArrows argmaxi argmini maxi mini");
  return contains(names, name);
}

bool opens_display(std::string_view text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("$$") || rest.starts_with("\\[")) return true;
    if (rest.starts_with("\\begin{")) {
      const std::size_t end = rest.substr(0, longest_beginning).find('}');
      if (end != std::string_view::npos && is_display_environment(rest.substr(7, end - 7))) return true;
    }
    if (text[at] == '\\') ++at;
  }
  return false;
}

std::optional<OwnDisplay> display_opening(std::string_view text) {
  DelimiterText rest(text);
  OwnDisplay display{"displaymath", "displaymath"};
  if (!rest.take("\\[")) {
    const auto name = rest.take("\\begin") ? rest.take_group() : std::nullopt;
    if (!name || !is_display_environment(*name) || *name == "empheq") return std::nullopt;
    display.environment = display.meaning = *name;
    if (takes_argument(*name) && !rest.take_group()) return std::nullopt;
  }
  while (!rest.at_end()) {
    if (rest.take("\\label")) {
      if (!rest.take_group()) return std::nullopt;
      continue;
    }
    const auto inside = rest.take("\\begin") ? rest.take_group() : std::nullopt;
    if (!inside || filled(*inside).empty() || display.meaning != display.environment) return std::nullopt;
    display.meaning = filled(*inside);
  }
  return display;
}

std::string display_closing(std::string_view text) {
  DelimiterText rest(text);
  while (!rest.at_end()) {
    if (rest.take("\\]")) return rest.at_end() ? "displaymath" : "";
    const auto name = rest.take("\\end") ? rest.take_group() : std::nullopt;
    if (!name) return {};
    if (is_display_environment(*name)) return rest.at_end() ? std::string(*name) : "";
    if (filled(*name).empty()) return {};
  }
  return {};
}

void EnvironmentAliases::define(std::string_view control, const OwnBodies& bodies) {
  auto opening = opening_in(bodies);
  set(unread_controls, control, !opening && opens_display(bodies.opening));
  set(begins, control, std::move(opening));
  const std::string closing = bodies.parameters == 0 ? display_closing(bodies.opening) : std::string();
  set(ends, control, closing.empty() ? std::nullopt : std::optional(closing));
}

void EnvironmentAliases::define_environment(std::string_view name, const OwnBodies& bodies) {
  auto display = opening_in(bodies);
  if (display && display_closing(bodies.closing) != display->environment) display.reset();
  set(unread_environments, name, !display && opens_display(bodies.opening));
  set(environments, name, std::move(display));
}

}  // namespace rigor
