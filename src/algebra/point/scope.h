// SPDX-License-Identifier: GPL-3.0-or-later
// What a statement reaches: its symbols, the definitions behind them, and the assumptions that concern it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// A question with its definitions found by symbol. The first definition of a symbol counts; a symbol that is
/// taken as zero has none. `opaque`: no definition is unfolded, every symbol is free; what is proved so holds
/// for any definition, and costs less. `opaque_but_squares`: only a name that is defined by its square is
/// unfolded, since nothing says that it is a real number.
class Scope {
 public:
  enum class Definitions : std::uint8_t { unfolded, opaque, opaque_but_squares };

  Scope(const Question& question, Definitions definitions);

  [[nodiscard]] const Question& question() const { return *question_; }
  [[nodiscard]] const ExprTree& tree() const { return *question_->tree; }
  [[nodiscard]] const Definition* definition_of(SymbolId symbol) const {
    return definition_[static_cast<std::size_t>(symbol)];
  }
  /// Is the symbol defined at all, unfolded or not? Then what is declared of it (symmetric, unit) is not
  /// taken for granted.
  [[nodiscard]] bool is_defined(SymbolId symbol) const { return defined_[static_cast<std::size_t>(symbol)]; }
  [[nodiscard]] bool is_circle_number(SymbolId symbol) const {
    return tree().symbols[symbol].circle_number && !is_defined(symbol);
  }
  [[nodiscard]] bool is_zeroed(SymbolId symbol) const { return zeroed_[static_cast<std::size_t>(symbol)]; }

 private:
  const Question* question_;
  std::vector<const Definition*> definition_;  // by symbol
  std::vector<bool> defined_;                  // by symbol
  std::vector<bool> zeroed_;                   // by symbol
};

/// What evaluating some expressions needs. Symbols are in the order of their first occurrence.
struct Reach {
  std::vector<SymbolId> symbols;  // free: neither unfolded nor zeroed
  std::vector<SymbolId> unfolded;
  bool particles = false;           // a sum over particles or a particle's own quantity occurs
  std::vector<SymbolId> angles;     // free symbols, no unit vectors or rotations, that only sin and cos see
  std::vector<SymbolId> exponents;  // the same, that only exp sees
  bool particle_sums = false;
  bool functions = false;
  bool roots = false;  // a root, a length, an absolute value, or what else only some real numbers have
  std::optional<std::string>
      too_large;  // a rank, an exponent or a number beyond what is evaluated: which, as a reason
};

[[nodiscard]] Reach reach(const Scope& scope, std::span<const ExprId> roots);
[[nodiscard]] Reach reach(const Scope& scope, const Equation& equation);

/// The positions of the assumptions that share free symbols with the claim, directly or through other such
/// assumptions, and of those without symbols. The others cannot bear on it: they are about other things.
[[nodiscard]] std::vector<std::size_t> relevant_assumptions(const Scope& scope);

/// These assumptions without those that only fix a symbol which occurs nowhere else. If the claim does not
/// have a symbol, and no more equations have it than it has components, these equations can be met whatever
/// the others say, and a proof seldom needs them.
[[nodiscard]] std::vector<std::size_t> core_assumptions(const Scope& scope,
                                                        const std::vector<std::size_t>& positions);

}  // namespace rigor
