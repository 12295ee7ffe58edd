// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/shown/grounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "check/law/bearing.h"
#include "check/question/base_letters.h"
#include "check/row/row.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

constexpr std::size_t most_of_each = 8;

std::string_view sign_of_relation(Relation relation) {
  switch (relation) {
    case Relation::equal:
      return "=";
    case Relation::less:
      return "<";
    case Relation::less_or_equal:
      return "\\le";
    case Relation::unequal:
      return "\\ne";
  }
  return "=";
}

std::string equation_latex(const ExprTree& tree, const Equation& equation, const Notation& notation) {
  return fmt::format("{} {} {}", print_latex(tree, equation.left, notation),
                     sign_of_relation(equation.relation), print_latex(tree, equation.right, notation));
}

bool share_letters(const std::set<SymbolId>& letters, const std::set<SymbolId>& others) {
  return std::ranges::any_of(others, [&](SymbolId each) { return letters.contains(each); });
}

class GroundList {
 public:
  GroundList(RowPlace& place, const Equation& equation, const Notation& notation)
      : place_(place),
        equation_(equation),
        notation_(notation),
        letters_(base_letters(place.tree, place.names.scope, equation)) {}

  /// What its letters are defined by, and what these are.
  void add_definitions() {
    std::size_t left = most_of_each;
    const NameScope scope = place_.names.scope;
    for (const SymbolId symbol : symbols_reached(place_.tree, scope, {equation_.left, equation_.right})) {
      const NamedDefinition* named = definition_of(scope, symbol);
      if (named == nullptr || left == 0 || !is_new(named->origin.text)) continue;
      const Equation meaning = as_equation(place_.tree, named->definition);
      grounds_.push_back({Ground::Kind::definition, named->origin.text, latex(meaning)});
      --left;
    }
  }

  void add_given() {
    std::size_t left = most_of_each;
    for (const NamedAssumption& each : place_.names.scope.assumptions) {
      if (left == 0 || !bears(each.equation) || !is_new(each.origin.text)) continue;
      grounds_.push_back({Ground::Kind::given, each.origin.text, latex(each.equation)});
      --left;
    }
  }

  /// In lines of prose and next to the row.
  void add_said(const Standpoint& at) {
    std::size_t left = most_of_each;
    for (const Fact& fact : at.facts) {
      if (left == 0 || !fact.proves || !bears(fact.equation) || !is_new(fact.text)) continue;
      grounds_.push_back({Ground::Kind::said, fact.text, latex(fact.equation)});
      --left;
    }
  }

  void add_laws(const ParsedChain& parsed) {
    std::size_t left = most_of_each;
    const Laws bearing =
        laws_that_bear(place_.tree, place_.names.scope, equation_, available_to(place_, parsed));
    for (const PageLaw* law : bearing) {
      if (left == 0 || !bears(law->equation) || !is_new(law->name)) continue;
      const auto kind = law->standing == Standing::conclusion ? Ground::Kind::conclusion : Ground::Kind::law;
      grounds_.push_back({kind, law->name, latex(law->equation)});
      --left;
    }
  }

  std::vector<Ground> take() { return std::move(grounds_); }

 private:
  [[nodiscard]] bool bears(const Equation& other) const {
    return share_letters(letters_, base_letters(place_.tree, place_.names.scope, other));
  }
  [[nodiscard]] bool is_new(const std::string& name) const {
    return std::ranges::none_of(grounds_, [&](const Ground& each) { return each.name == name; });
  }
  [[nodiscard]] std::string latex(const Equation& equation) const {
    return equation_latex(place_.tree, equation, notation_);
  }

  RowPlace& place_;
  const Equation& equation_;
  const Notation& notation_;
  std::set<SymbolId> letters_;
  std::vector<Ground> grounds_;
};

}  // namespace

std::vector<Ground> grounds_of(RowPlace& place, const ParsedChain& parsed, const Equation& equation,
                               const Notation& notation) {
  GroundList list(place, equation, notation);
  list.add_definitions();
  list.add_given();
  list.add_said(standpoint(place, parsed));
  list.add_laws(parsed);
  return list.take();
}

}  // namespace rigor
