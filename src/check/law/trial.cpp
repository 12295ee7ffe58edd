// SPDX-License-Identifier: GPL-3.0-or-later
// An equation that holds for all times holds at t = 0, and so do its derivatives: that is what "comparing
// coefficients" comes to, without asking which functions are independent.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/law/bearing.h"
#include "check/law/solves.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "elaborate/name/function_value.h"
#include "expr/calculus/at_origin.h"
#include "expr/calculus/differentiate.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

/// What an unknown is differentiated by: the time, or a place along an axis, or a letter.
struct VariableOfTrial {
  Variable by;
  std::uint8_t axis = 0;
  SymbolId symbol{};
};

struct Trial {
  const PageLaw* function = nullptr;  // `x = A\cos\omega t`
  const PageLaw* equation = nullptr;
  SymbolId unknown{};
  std::vector<VariableOfTrial> variables = {};
};

bool has_smooth_function(const ExprTree& tree, ExprId side) {
  return std::ranges::any_of(nodes_below(tree, {side}), [&](ExprId id) {
    const ExprNode& node = tree[id];
    return node.op == Op::function && (node.function == Function::sin || node.function == Function::cos ||
                                       node.function == Function::exp);
  });
}

/// x of `x = A\cos\omega t`, where nothing defines x.
std::optional<SymbolId> tried_letter(const RowUnderLaws& row, const PageLaw& law) {
  const Equation& equation = law.equation;
  const ExprNode& left = row.tree[equation.left];
  const bool alone = equation.relation == Relation::equal && left.op == Op::symbol && left.rank == 0 &&
                     left.slot_count == 0 && left.particle == no_particle && equation.indices.empty() &&
                     !row.tree.symbols[left.symbol].derivation && !law.at_instant;
  if (!alone || definition_of(row.names.scope, left.symbol) != nullptr ||
      !has_smooth_function(row.tree, equation.right))
    return std::nullopt;
  const std::vector<SymbolId> right = symbols_in(row.tree, equation.right);
  const bool circular = std::ranges::any_of(
      right, [&](SymbolId each) { return base_of(row.tree.symbols, each) == left.symbol; });
  return circular ? std::nullopt : std::optional(left.symbol);
}

std::optional<SymbolId> plain_letter(const Names& names, const std::string& name) {
  return find_symbol(names.symbols, {name, 0, false});
}

/// What the equation differentiates the unknown by; nothing: not at all, or by what is no such variable.
std::optional<std::vector<VariableOfTrial>> variables_in(const RowUnderLaws& row, const Equation& equation,
                                                         SymbolId unknown) {
  std::vector<VariableOfTrial> variables;
  bool mixed = false;  // `du/ds` beside `\partial u/\partial s`
  const auto add = [&](VariableOfTrial each) {
    const auto known = std::ranges::find(variables, each.symbol, &VariableOfTrial::symbol);
    if (known == variables.end()) return variables.push_back(each);
    mixed = mixed || known->by != each.by || known->axis != each.axis;
  };
  for (const ExprId id : nodes_below(row.tree, {equation.left, equation.right})) {
    const ExprNode& node = row.tree[id];
    if (node.op != Op::symbol || base_of(row.tree.symbols, node.symbol) != unknown) continue;
    const auto& derivation = row.tree.symbols[node.symbol].derivation;
    if (!derivation) continue;
    for (const Variable& by : derivation->by) {
      if (by.by == By::small || by.held) return std::nullopt;
      if (by.by == By::letter) add({by, 0, by.letter});
      if (by == By::time) {
        const auto time = plain_letter(row.names, "t");
        if (!time) return std::nullopt;
        add({by, 0, *time});
      }
    }
    for (const Slot& slot : row.tree.slots(id)) {
      if (slot.axis == 0 || slot.axis > 3) return std::nullopt;
      const auto place = plain_letter(row.names, std::string(1, static_cast<char>('x' + slot.axis - 1)));
      if (!place) return std::nullopt;
      add({By::space, slot.axis, *place});
    }
  }
  return variables.empty() || mixed ? std::nullopt : std::optional(std::move(variables));
}

/// Does it change with none of the variables, as far as the section shows? A of `A(\omega)` does not.
bool is_steady(const RowUnderLaws& row, SymbolId letter, const std::vector<VariableOfTrial>& variables) {
  const Symbol& symbol = row.tree.symbols[letter];
  if (symbol.derivation || symbol.integral || symbol.per_particle || symbol.rank > 0) return false;
  if (symbol.is_fixed() || is_declared_constant(row.names.scope, letter)) return true;
  if (row.names.symbols.function_values.contains(letter)) return true;
  const NameKey* key = key_of(row.names.symbols, letter);
  if (key == nullptr) return false;
  const Evidence& evidence = *row.names.symbols.evidence;
  if (!may_be_changing(evidence, key->base)) return true;
  if (evidence.speaks_of_change || has_rate(*row.names.symbols.sightings, *key)) return false;
  const auto applied = evidence.applied.find(key->base);
  if (applied == evidence.applied.end()) return false;
  return std::ranges::none_of(variables,
                              [&](const VariableOfTrial& each) {
                                const NameKey* own = key_of(row.names.symbols, each.symbol);
                                return own == nullptr || is_function_of(evidence, key->base, own->base);
                              }) &&
         std::ranges::all_of(applied->second, [&](const std::vector<std::string>& arguments) {
           return std::ranges::none_of(
               arguments, [&](const std::string& each) { return may_be_changing(evidence, each); });
         });
}

/// Every letter but the unknown and the variables is constant.
bool are_all_steady(const RowUnderLaws& row, const Trial& trial) {
  const Equation& equation = trial.equation->equation;
  const std::vector<SymbolId> letters = symbols_reached(
      row.tree, row.names.scope, {equation.left, equation.right, trial.function->equation.right});
  return std::ranges::all_of(letters, [&](SymbolId each) {
    const bool variable =
        std::ranges::any_of(trial.variables, [&](const VariableOfTrial& of) { return of.symbol == each; });
    return variable || base_of(row.tree.symbols, each) == trial.unknown ||
           is_steady(row, each, trial.variables);
  });
}

/// Those near the row first: another section may have tried another function.
Laws nearest_first(const RowUnderLaws& row, Laws laws) {
  const FileId file = row.claim.relation.file;
  std::ranges::stable_sort(laws, std::ranges::greater{}, [&](const PageLaw* law) {
    return std::pair(law->span.file == file, law->span.begin);
  });
  return laws;
}

std::optional<Trial> trial_among(const RowUnderLaws& row, const Laws& bearing) {
  for (const PageLaw* function : bearing) {
    const auto unknown = tried_letter(row, *function);
    if (!unknown) continue;
    for (const PageLaw* equation : bearing) {
      if (equation == function || equation->at_instant || equation->equation.relation != Relation::equal ||
          !equation->equation.indices.empty())
        continue;
      auto variables = variables_in(row, equation->equation, *unknown);
      if (!variables) continue;
      Trial trial{function, equation, *unknown, *std::move(variables)};
      // d/dt of what depends on the place may follow the motion.
      const NameKey* key = key_of(row.names.symbols, *unknown);
      const bool in_place = trial.variables.size() > 1;
      const bool partial =
          key != nullptr && row.names.symbols.sightings->partial_rates.contains({key->base, false});
      if ((in_place && !partial) || trial.variables.size() > 2 || !are_all_steady(row, trial)) continue;
      return trial;
    }
  }
  return std::nullopt;
}

class PutIn {
 public:
  PutIn(const RowUnderLaws& row, const Trial& trial) : row_(row), trial_(trial) {
    for (const VariableOfTrial& each : trial.variables) symbols_.insert(each.symbol);
  }

  /// The equation with the trial function for its unknown.
  std::optional<Equation> equation() {
    const auto by = [&](ExprId id) -> std::optional<ExprId> {
      const SymbolId symbol = row_.tree[id].symbol;
      if (base_of(row_.tree.symbols, symbol) != trial_.unknown) return std::nullopt;
      const auto& derivation = row_.tree.symbols[symbol].derivation;
      ExprId value = trial_.function->equation.right;
      if (!derivation) return value;
      const std::vector<Slot> slots(row_.tree.slots(id).begin(), row_.tree.slots(id).end());
      std::size_t place = 0;
      for (const Variable& each : derivation->by) {
        const std::uint8_t axis = each == By::space && place < slots.size() ? slots[place++].axis : 0;
        value = derivative(value, *std::ranges::find_if(trial_.variables, [&](const VariableOfTrial& of) {
                             return each == By::space ? of.axis == axis && axis != 0
                                                      : of.axis == 0 && of.by == each;
                           }));
      }
      return value;
    };
    Equation result = trial_.equation->equation;
    result.left = replaced(row_.tree, result.left, by);
    result.right = replaced(row_.tree, result.right, by);
    return budget_.exceeded ? std::nullopt : std::optional(result);
  }

  Equation differentiated(Equation equation, const VariableOfTrial& by) {
    equation.left = derivative(equation.left, by);
    equation.right = derivative(equation.right, by);
    return equation;
  }

  std::optional<Equation> at_zero(Equation equation) {
    const auto left = at_origin(row_.tree, equation.left, symbols_);
    const auto right = at_origin(row_.tree, equation.right, symbols_);
    if (!left || !right || budget_.exceeded) return std::nullopt;
    equation.left = *left;
    equation.right = *right;
    return equation;
  }

 private:
  ExprId derivative(ExprId of, const VariableOfTrial& by) {
    const auto dependence_of = [&](SymbolId symbol) {
      return symbol == by.symbol ? Dependence{Dependence::Kind::variable, by.axis}
                                 : Dependence{Dependence::Kind::constant};
    };
    return Differentiator(row_.tree, by.by, dependence_of, budget_, Slot{by.axis, {}}).derivative_or_zero(of);
  }

  const RowUnderLaws& row_;
  const Trial& trial_;
  std::set<SymbolId> symbols_;
  DerivativeBudget budget_;
};

/// The equation and its derivatives where the variables are 0; nothing where one is not known there. Higher
/// ones say that the trial function can solve it at all: `A\cos\omega t` solves no `\ddot x + x^3 = 0`.
std::optional<std::vector<Equation>> equations_at_zero(PutIn& put_in, const Trial& trial) {
  const auto whole = put_in.equation();
  if (!whole) return std::nullopt;
  const int most = trial.variables.size() > 1 ? 2 : 3;  // derivatives in all
  struct Derived {
    Equation equation;
    std::size_t last = 0;  // the variable of the last derivative
    int order = 0;
  };
  std::vector<Derived> along{{*whole}};
  for (std::size_t k = 0; k < along.size(); ++k) {
    const Derived of = along[k];
    for (std::size_t by = of.last; by < trial.variables.size() && of.order < most; ++by)
      along.push_back({put_in.differentiated(of.equation, trial.variables[by]), by, of.order + 1});
  }
  std::vector<Equation> found;
  for (const Derived& each : along) {
    const auto at_zero = put_in.at_zero(each.equation);
    if (!at_zero) return std::nullopt;
    found.push_back(*at_zero);
  }
  return found;
}

/// A and k of `A\sin kx`: were one 0, the trial function would vanish, or not change with x.
std::vector<SymbolId> letters_of_a_trial(const RowUnderLaws& row, const Trial& trial) {
  std::vector<SymbolId> letters;
  const ExprId function = trial.function->equation.right;
  const auto is_variable = [&](SymbolId each) {
    return std::ranges::any_of(trial.variables, [&](const VariableOfTrial& of) { return of.symbol == each; });
  };
  for (const SymbolId each : symbols_in(row.tree, function)) {
    const Symbol& symbol = row.tree.symbols[each];
    if (is_variable(each) || symbol.is_fixed() || symbol.rank > 0) continue;
    const auto without = at_origin(row.tree, function, {each});
    const bool vanishes = without && row.tree.is_zero_literal(*without);
    const auto stops = [&](ExprId id) {
      if (row.tree[id].op != Op::function) return false;
      const auto own = at_origin(row.tree, row.tree.children(id)[0], {each});
      const auto moves = [&](ExprId part) {
        return std::ranges::count_if(symbols_in(row.tree, part), is_variable);
      };
      return own && moves(*own) < moves(row.tree.children(id)[0]);
    };
    const std::vector<ExprId> nodes = nodes_below(row.tree, {function});
    if (vanishes || std::ranges::any_of(nodes, stops)) letters.push_back(each);
  }
  return letters;
}

Names with_letters_not_zero(const RowUnderLaws& row, const std::vector<SymbolId>& letters) {
  Names names = row.names;
  for (const SymbolId each : letters) {
    Equation nonzero;
    nonzero.left = row.tree.add({.op = Op::symbol, .span = row.claim.relation, .symbol = each});
    nonzero.right = row.tree.add_number(row.claim.relation, "0");
    nonzero.relation = Relation::unequal;
    const std::string says = fmt::format("convention: `{}` is not 0", row.tree.symbols[each].name);
    assume(names.scope, {std::move(nonzero), Origin{says, {}, std::nullopt}, 0});
  }
  return names;
}

/// c and \mu of `\omega^2 = c^2k^2 + \mu^2`, which stand in squares only: s for c^2 leaves samples that are
/// met.
class Squares {
 public:
  Squares(const RowUnderLaws& row, const std::vector<Equation>& equations) : row_(row) {
    std::set<SymbolId> in_squares;
    std::set<SymbolId> elsewhere;
    for (const Equation& each : equations) {
      for (const ExprId side : {each.left, each.right}) look(side, in_squares, elsewhere);
    }
    for (const SymbolId each : in_squares) {
      const Symbol& symbol = row.tree.symbols[each];
      const bool plain = !symbol.is_fixed() && symbol.rank == 0 && !symbol.per_particle &&
                         definition_of(row.names.scope, each) == nullptr &&
                         key_of(row.names.symbols, each) != nullptr;
      if (!plain || elsewhere.contains(each)) continue;
      squares_[each] =
          row.tree.symbols.add({.name = fmt::format("{}^2", symbol.name), .first_seen = symbol.first_seen});
    }
  }

  Equation replaced_in(Equation equation) {
    equation.left = replaced_in(equation.left);
    equation.right = replaced_in(equation.right);
    return equation;
  }

  /// They are positive, and the letters not 0.
  void assume_in(Names& names) const {
    for (const auto& [letter, square] : squares_) {
      Equation positive;
      positive.left = row_.tree.add_number(row_.claim.relation, "0");
      positive.right = row_.tree.add({.op = Op::symbol, .span = row_.claim.relation, .symbol = square});
      positive.relation = Relation::less;
      const std::string says = fmt::format("convention: `{}` is not 0", row_.tree.symbols[letter].name);
      assume(names.scope, {std::move(positive), Origin{says, {}, std::nullopt}, 0});
      declare_constant(names.scope, square, std::nullopt);
    }
  }

 private:
  bool is_square(ExprId id) const {
    const ExprNode& node = row_.tree[id];
    return node.op == Op::power && node.exponent > 0 && node.exponent % 2 == 0 &&
           row_.tree[row_.tree.children(id)[0]].op == Op::symbol;
  }

  void look(ExprId id, std::set<SymbolId>& in_squares, std::set<SymbolId>& elsewhere) const {
    const ExprNode& node = row_.tree[id];
    if (is_square(id)) {
      in_squares.insert(row_.tree[row_.tree.children(id)[0]].symbol);
      return;
    }
    if (node.op == Op::symbol) elsewhere.insert(node.symbol);
    for (const ExprId child : row_.tree.children(id)) look(child, in_squares, elsewhere);
  }

  ExprId replaced_in(ExprId id) {
    const ExprNode node = row_.tree[id];
    if (is_square(id)) {
      const auto found = squares_.find(row_.tree[row_.tree.children(id)[0]].symbol);
      if (found == squares_.end()) return id;
      const ExprId square = row_.tree.add({.op = Op::symbol, .span = node.span, .symbol = found->second});
      if (node.exponent == 2) return square;
      return row_.tree.add({.op = Op::power, .span = node.span, .exponent = node.exponent / 2},
                           std::span(&square, 1));
    }
    std::vector<ExprId> children(row_.tree.children(id).begin(), row_.tree.children(id).end());
    bool differs = false;
    for (ExprId& child : children) {
      const ExprId own = std::exchange(child, replaced_in(child));
      differs = differs || own != child;
    }
    if (!differs) return id;
    const std::vector<Slot> slots(row_.tree.slots(id).begin(), row_.tree.slots(id).end());
    return row_.tree.add(node, children, slots);
  }

  const RowUnderLaws& row_;
  std::map<SymbolId, SymbolId> squares_;
};

}  // namespace

std::optional<Judgement> follows_from_trial(const RowUnderLaws& row, const Laws& bearing) {
  const Equation& own = row.claim.equation;
  if (own.relation != Relation::equal || !own.indices.empty()) return std::nullopt;
  const auto trial = trial_among(row, nearest_first(row, bearing));
  if (!trial) return std::nullopt;
  const std::set<SymbolId> letters = base_letters(row.tree, row.names.scope, own);
  const bool of_constants = std::ranges::none_of(letters, [&](SymbolId each) {
    return each == trial->unknown || std::ranges::any_of(trial->variables, [&](const VariableOfTrial& of) {
             return of.symbol == each;
           });
  });
  if (!of_constants) return std::nullopt;
  PutIn put_in(row, *trial);
  const auto equations = equations_at_zero(put_in, *trial);
  if (!equations) return std::nullopt;
  std::vector<Equation> all = *equations;
  all.push_back(own);
  Squares squares(row, all);
  Names names = with_letters_not_zero(row, letters_of_a_trial(row, *trial));
  squares.assume_in(names);
  Claim claim = row.claim;
  std::vector<PageLaw> laws;
  laws.reserve(equations->size());
  Laws set;
  for (const Equation& each : *equations) {
    const auto vanishes = [&](ExprId side) { return row.tree.is_zero_literal(side); };
    if (vanishes(each.left) && vanishes(each.right)) continue;
    claim.equation = squares.replaced_in(each);
    // Most higher derivatives say nothing new.
    const bool further = laws.size() > trial->variables.size();
    if (further &&
        judge(row.tree, with_laws(row.tree, names, set), claim, {}, row.cache).verdict == Verdict::proved)
      continue;
    PageLaw& law = laws.emplace_back(*trial->equation);
    law.equation = claim.equation;
    law.at_instant = true;
    set.push_back(&law);
  }
  claim.equation = squares.replaced_in(own);
  auto found = prove_from({row.tree, names, claim, row.cache}, set);
  if (!found || !is_one_of(trial->equation->name, found->uses)) return std::nullopt;
  found->uses.insert(found->uses.begin(), trial->function->name);
  found->route = fmt::format("{} in {}", trial->function->name, trial->equation->name);
  return found;
}

}  // namespace rigor
