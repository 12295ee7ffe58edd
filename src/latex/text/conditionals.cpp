// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/text/conditionals.h"

#include <algorithm>
#include <array>

#include "base/among.h"

namespace rigor {

bool opens_conditional(std::string_view control) {
  static constexpr auto with_braces = std::to_array<std::string_view>(
      {"iff",        "ifthenelse", "ifthispageodd",   "ifbool",     "ifblank",    "ifboolexpr",
       "ifboolexpe", "ifcsdef",    "ifcsempty",       "ifcsmacro",  "ifcsstring", "ifcsundef",
       "ifcsvoid",   "ifdef",      "ifdefempty",      "ifdefmacro", "ifdefparam", "ifdefstring",
       "ifdefvoid",  "ifdimcomp",  "ifinlist",        "ifnumcomp",  "ifnumequal", "ifnumgreater",
       "ifnumless",  "ifnumodd",   "ifpackageloaded", "ifstrempty", "ifstrequal", "iftoggle",
       "ifundef"});
  return control.starts_with("if") && !is_one_of(control, with_braces);
}

bool Switches::turn(std::string_view control) {
  for (const bool on : {true, false}) {
    const std::string_view word = on ? "true" : "false";
    if (!control.ends_with(word)) continue;
    const auto found = on_.find(control.substr(0, control.size() - word.size()));
    if (found == on_.end()) continue;
    found->second = on;
    return true;
  }
  return false;
}

std::optional<bool> Switches::value(std::string_view control) const {
  if (control == "iftrue") return true;
  if (control == "iffalse") return false;
  const auto found = control.starts_with("if") ? on_.find(control.substr(2)) : on_.end();
  return found == on_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<BranchEnd> find_branch_end(const NotesText& text, std::size_t from, bool to_fi) {
  int depth = 0;
  for (std::size_t at = from; at < text.size(); ++at) {
    if (text[at] == '%') at = text.line_end(at);
    if (text[at] != '\\') continue;
    const std::string_view word = text.control_word(at);
    const std::size_t behind = at + 1 + word.size();
    if (opens_conditional(word)) ++depth;
    if (word == "fi" && depth-- == 0) return BranchEnd{at, behind, true};
    if (!to_fi && depth == 0 && (word == "else" || word == "or")) return BranchEnd{at, behind, false};
    at += std::max<std::size_t>(word.size(), 1);
  }
  return std::nullopt;
}

}  // namespace rigor
