// SPDX-License-Identifier: GPL-3.0-or-later
// A name with a word in its subscript that one equation has, and that differs by one letter, or by two
// letters exchanged, from a name that other equations have: `T_{\text{rto}}` beside `T_{\text{rot}}`. Nothing
// says what such a name means, so its equation is taken for a law and would pass. Short labels are left
// alone: `\omega_p` and `\omega_c` are two things.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

#include "base/ascii.h"
#include "check/lint/lint.h"
#include "source/suggest.h"

namespace rigor {
namespace {

struct Name {
  std::set<std::size_t> steps;  // of the report
  Span first;
  bool declared = false;
};

struct Labelled {
  std::string letter;
  std::string label;  // letters only
};

/// `T` and `rot` of `T_{\text{rot}}`.
std::optional<Labelled> taken_apart(const std::string& name) {
  constexpr std::size_t shortest_label = 3;
  const auto mark = name.find('_');
  if (mark == std::string::npos) return std::nullopt;
  if (name.find('^') != std::string::npos) return std::nullopt;
  Labelled result{name.substr(0, mark), {}};
  std::string label = name.substr(mark + 1);
  for (const std::string_view face : {"\\text", "\\mathrm"}) {
    if (const auto at = label.find(face); at != std::string::npos) label.erase(at, face.size());
  }
  for (const char c : label) {
    if (is_letter(c)) result.label += c;
    if (c == '\\' || c == '_') return std::nullopt;
  }
  return result.label.size() >= shortest_label ? std::optional(result) : std::nullopt;
}

bool differ_by_a_slip(const std::string& name, const std::string& other) {
  const auto one = taken_apart(name);
  const auto two = taken_apart(other);
  return one && two && one->letter == two->letter && one->label.size() == two->label.size() &&
         edit_distance(one->label, two->label, 1) == 1;
}

std::map<std::string, Name> names_in(const LintInput& input) {
  std::map<std::string, Name> names;
  for (const StatedEquation& stated : input.stated) {
    for (const ExprId id : nodes_below(input.tree, {stated.left, stated.right})) {
      const ExprNode& node = input.tree[id];
      if (node.op != Op::symbol) continue;
      const Symbol& symbol = input.tree.symbols[base_of(input.tree.symbols, node.symbol)];
      Name& name = names[symbol.name];
      if (name.steps.empty()) name.first = node.span;
      name.steps.insert(stated.step);
      name.declared = name.declared || symbol.declared;
    }
  }
  return names;
}

}  // namespace

Findings lint_names(const LintInput& input) {
  const std::map<std::string, Name> names = names_in(input);
  Findings findings;
  for (const auto& [text, name] : names) {
    if (name.steps.size() > 1 || name.declared) continue;
    for (const auto& [other_text, other] : names) {
      const bool in_one_step = other.steps.contains(*name.steps.begin());
      if (in_one_step || (other.steps.size() == 1 && !other.declared && other.first.begin > name.first.begin))
        continue;
      if (!differ_by_a_slip(text, other_text)) continue;
      findings.push_back(
          {{DiagnosticKind::near_name,
            name.first,
            fmt::format("no other equation has `{}`; is `{}` meant?", text, other_text),
            {{other.first, ""}},
            {fmt::format("`rigor: scalar {}`, or what it is, says that it is another quantity", text)}}});
      break;
    }
  }
  return findings;
}

}  // namespace rigor
