// SPDX-License-Identifier: GPL-3.0-or-later
// A name with a word in its subscript that one equation has, and that differs by one letter, or by two
// letters exchanged, from a name that other equations have: `T_{\text{rto}}` beside `T_{\text{rot}}`. Nothing
// says what such a name means, so its equation is taken for a law and would pass. Short labels are left
// alone: `\omega_p` and `\omega_c` are two things.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "check/lint/lint.h"
#include "source/suggest.h"

namespace rigor {
namespace {

struct SeenName {
  std::set<std::size_t> steps;  // of the report
  Span first;
  bool declared = false;
};
using SeenNames = std::map<std::string, SeenName>;

struct Labelled {
  std::string letter;
  std::string label;  // letters only
};
/// With their labels: names of one letter whose labels are of one length.
using Alike = std::vector<std::pair<const SeenNames::value_type*, std::string>>;

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

SeenNames names_in(const LintInput& input) {
  SeenNames names;
  for (const StatedEquation& stated : input.stated) {
    for (const ExprId id : nodes_below(input.tree, {stated.left, stated.right})) {
      const ExprNode& node = input.tree[id];
      if (node.op != Op::symbol) continue;
      const Symbol& symbol = input.tree.symbols[base_of(input.tree.symbols, node.symbol)];
      SeenName& name = names[symbol.name];
      if (name.steps.empty()) name.first = node.span;
      name.steps.insert(stated.step);
      name.declared = name.declared || symbol.declared;
    }
  }
  return names;
}

/// In the order of their texts.
std::map<std::pair<std::string, std::size_t>, Alike> alike_in(const SeenNames& names) {
  std::map<std::pair<std::string, std::size_t>, Alike> groups;
  for (const auto& each : names) {
    if (auto apart = taken_apart(each.first))
      groups[{apart->letter, apart->label.size()}].emplace_back(&each, std::move(apart->label));
  }
  return groups;
}

/// Is the second name known from elsewhere, or was it there first?
bool was_there_before(const SeenName& name, const SeenName& other) {
  if (other.steps.contains(*name.steps.begin())) return false;
  return other.steps.size() > 1 || other.declared || other.first.begin <= name.first.begin;
}

}  // namespace

Findings lint_names(const LintInput& input) {
  const SeenNames names = names_in(input);
  Findings findings;
  for (const auto& [shape, alike] : alike_in(names)) {
    for (const auto& [named, label] : alike) {
      const auto& [text, name] = *named;
      if (name.steps.size() > 1 || name.declared) continue;
      const auto meant = std::ranges::find_if(alike, [&](const auto& other) {
        return was_there_before(name, other.first->second) && edit_distance(label, other.second, 1) == 1;
      });
      if (meant == alike.end()) continue;
      const auto& [meant_text, other] = *meant->first;
      findings.push_back(
          {{DiagnosticKind::near_name,
            name.first,
            fmt::format("no other equation has `{}`; is `{}` meant?", text, meant_text),
            {{other.first, ""}},
            {fmt::format("`rigor: scalar {}`, or what it is, says that it is another quantity", text)}}});
    }
  }
  return findings;
}

}  // namespace rigor
