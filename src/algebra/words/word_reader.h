// SPDX-License-Identifier: GPL-3.0-or-later
// An expression as sums of words, one for each component.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "algebra/engine/budget.h"
#include "algebra/words/word_rules.h"
#include "algebra/words/word_sum.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Which axes the open indices stand for.
using AxesOfIndices = std::map<IndexId, std::uint8_t>;

/// Which definitions of operators are put in.
enum class Unfolding : std::uint8_t {
  none,
  unspoken,  // of letters that no assumption has: N of `N = a^\dagger a` where a law is about a
  all
};

/// Throws Undecidable where operators are under a root or in a function, in a denominator beside others, or
/// in a definition of what is read as a number. Definitions of numbers are never unfolded. Recursion: as deep
/// as the tree, through definitions.
class WordReader {
 public:
  WordReader(const Question& question, CommutingParts& parts, Unfolding unfolding, Budget& budget);

  /// One sum for a scalar, one for each axis for a vector.
  [[nodiscard]] std::vector<WordSum> read(ExprId id, const AxesOfIndices& axes);
  /// What is 0 by the meaning of inverses that were read: 1/W of a sum or product W is a letter S, with
  /// WS = SW = 1.
  [[nodiscard]] const std::vector<WordSum>& inverses() const { return inverse_laws_; }
  [[nodiscard]] bool has_transposes() const { return transposes_; }
  [[nodiscard]] bool has_adjoints() const { return adjoints_; }
  [[nodiscard]] bool has_determinants() const { return determinants_; }
  [[nodiscard]] const std::set<SymbolId>& squares() const { return square_; }
  [[nodiscard]] bool is_square(SymbolId matrix) const { return square_.contains(matrix); }
  [[nodiscard]] bool has_traces() const { return traces_; }
  /// A law that no matrices of finite size obey: nothing is said of traces.
  void forbid_traces() { traces_forbidden_ = true; }
  /// What is read from here on is a law, and its inverses exist.
  void read_laws(bool laws) { of_page_ = laws; }
  /// Brings what is in traces, determinants and inverses into a normal form from here on.
  void reduce_by(const WordRules* rules) { rules_ = rules; }
  /// What was used for that.
  [[nodiscard]] const Positions& used() const { return used_; }
  /// The definitions that were needed.
  [[nodiscard]] const std::set<SymbolId>& unfolded() const { return unfolded_; }

 private:
  using Components = std::vector<WordSum>;

  [[nodiscard]] const ExprTree& tree() const { return parts_.tree(); }
  void see_squares();
  [[nodiscard]] bool unfolds(SymbolId symbol) const;
  [[nodiscard]] bool reaches_operators(ExprId id);
  [[nodiscard]] std::optional<WordSum> function_of_numbers(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] std::optional<ExprId> rows_of(ExprId id) const;
  [[nodiscard]] Components commuting(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] WordSum read_scalar(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] Components symbol(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] Components defined(const Definition& definition, ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] Components product(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] Components dot_or_cross(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] WordSum power(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] WordSum quotient(ExprId id, const AxesOfIndices& axes);
  [[nodiscard]] WordSum inverse_of(const WordSum& below);
  [[nodiscard]] WordSum inverse_letter(const WordSum& below);
  [[nodiscard]] bool is_number(ExprId id) const;
  [[nodiscard]] bool is_annihilated(SymbolId letter) const;
  [[nodiscard]] bool knows_something();
  [[nodiscard]] WordSum reduced(WordSum sum);
  [[nodiscard]] WordSum with_all_numbers_out(const WordSum& sum);
  [[nodiscard]] Coefficient trace(const WordSum& of, std::optional<ExprId> rows);
  [[nodiscard]] Coefficient trace_of_states(const WordSum& of);
  [[nodiscard]] std::optional<ExprId> squared(ExprId id);
  [[nodiscard]] WordSum dot(ExprId left, ExprId right, const AxesOfIndices& axes);
  [[nodiscard]] std::uint8_t axis_of(const Slot& slot, const AxesOfIndices& axes) const;
  [[nodiscard]] ExprId at_axes(ExprId id, const AxesOfIndices& axes);

  const Question& question_;
  CommutingParts& parts_;
  Unfolding unfolding_;
  Budget& budget_;
  std::set<SymbolId> spoken_of_;  // by assumptions
  std::set<SymbolId> square_;     // matrices that a trace, a power or an inverse is taken of
  std::set<SymbolId> inverted_;   // matrices of which an inverse is written
  bool transposes_ = false;       // the question has some
  bool adjoints_ = false;
  bool determinants_ = false;
  bool traces_ = false;
  bool traces_forbidden_ = false;
  bool of_page_ = false;  // a law or a definition is being read
  std::vector<std::pair<WordSum, SymbolId>> inverse_letters_;
  std::vector<WordSum> inverse_laws_;
  const WordRules* rules_ = nullptr;
  Positions used_;
  std::map<ExprId, bool> reaching_;
  std::set<SymbolId> unfolded_;
  std::set<SymbolId> opened_;  // definitions that are being read
};

}  // namespace rigor
