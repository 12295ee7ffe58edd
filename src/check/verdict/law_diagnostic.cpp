// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/law_diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "base/among.h"
#include "base/ascii.h"
#include "source/suggest.h"

namespace rigor {
namespace {

/// A known name that differs in face, primes or one letter of a long name. One that the statement has, too,
/// is another quantity, and so is one with another number, sign or accent.
std::optional<std::string> likely_meant(const std::string& name, const std::vector<std::string>& known,
                                        const std::set<std::string>& in_statement) {
  const std::string bare = bare_name(name);
  const auto is_word = [](const std::string& text) {
    return std::ranges::all_of(text,
                               [](char each) { return is_letter(each) || each == '\\' || each == '_'; });
  };
  for (const std::string& other : known) {
    if (in_statement.contains(other)) continue;
    const std::string candidate = bare_name(other);
    const bool long_enough = bare.size() > 4 && candidate.size() > 4 && is_word(bare) && is_word(candidate);
    if (candidate == bare || (long_enough && edit_distance(candidate, bare, 1) == 1)) return other;
  }
  return std::nullopt;
}

}  // namespace

std::string quoted_names(const ExprTree& tree, const std::vector<SymbolId>& symbols) {
  std::string text;
  std::vector<std::string> names;
  for (const SymbolId symbol : symbols) {
    const std::string& name = tree.symbols[symbol].name;
    if (!is_one_of(name, names)) names.push_back(name);
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
    text += "`" + names[k] + "`";
  }
  return text;
}

std::vector<SymbolId> bases_of(const ExprTree& tree, const std::vector<SymbolId>& symbols) {
  std::vector<SymbolId> bases;
  for (const SymbolId symbol : symbols) {
    const SymbolId base = base_of(tree.symbols, symbol);
    const auto has_its_name = [&](SymbolId other) {
      return tree.symbols[other].name == tree.symbols[base].name;
    };
    if (std::ranges::none_of(bases, has_its_name)) bases.push_back(base);
  }
  return bases;
}

std::string bare_name(std::string name) {
  for (const char* mark : {"\\mathbf", "\\boldsymbol", "\\text", "\\mathrm", "{", "}", "'"}) {
    for (std::size_t at = name.find(mark); at != std::string::npos; at = name.find(mark))
      name.erase(at, std::string(mark).size());
  }
  return name;
}

Diagnostic without_ground(const ExprTree& tree, const Names& names, const Claim& claim,
                          const Judgement& judgement) {
  const std::vector<SymbolId>& not_for_all = judgement.not_for_all;
  Diagnostic diagnostic{
      DiagnosticKind::follows_from_nothing, claim.relation,
      fmt::format("{}, and nothing says that {} {} meant for all values",
                  judgement.despite_given ? "it does not follow from what is assumed"
                                          : "no proof of this conclusion from what stands above it was found",
                  quoted_names(tree, not_for_all), not_for_all.size() == 1 ? "is" : "are")};
  const std::vector<std::string> known = known_names(names, tree);
  std::set<std::string> in_statement;
  for (const ExprId side : {claim.equation.left, claim.equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) in_statement.insert(tree.symbols[symbol].name);
  }
  for (const SymbolId symbol : not_for_all) in_statement.insert(tree.symbols[symbol].name);
  for (const SymbolId symbol : not_for_all) {
    const std::string& name = tree.symbols[symbol].name;
    if (const auto near = likely_meant(name, known, in_statement))
      diagnostic.help.push_back(fmt::format("is `{}` meant for `{}`?", *near, name));
  }
  constexpr std::size_t longest_line = 120;
  const bool fits = !claim.written.empty() && claim.written.size() <= longest_line;
  if (judgement.despite_given)
    diagnostic.help.push_back(fmt::format("`rigor: claim {}` asks for values for which it fails",
                                          fits ? std::string_view(claim.written) : "EQUATION"));
  else
    diagnostic.help.emplace_back(
        "what it follows from can stand above it, as an equation or as `rigor: given …`");
  return diagnostic;
}

}  // namespace rigor
