// SPDX-License-Identifier: GPL-3.0-or-later
// What a wrong step may have been meant to say, before it is known what of it is true: sides rewritten, and
// terms that may have another coefficient or be missing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/directive/directive.h"
#include "elaborate/reading/reading.h"
#include "latex/reading/rewritings.h"

namespace rigor {

/// What the steps before and after a wrong one say about one of its sides.
enum class Trust : std::uint8_t { unknown, supported, doubted };

struct WrongStep {
  const ParsedChain& parsed;
  std::size_t which = 0;
  bool first_order = false;     // `=` means ≈
  Trust left = Trust::unknown;  // supported: the step before it is proved
  Trust right = Trust::unknown;
  ReadingRules rules = {};             // by which it was read
  const Names* proved_with = nullptr;  // by which neighbours are read for a proof; else as for samples
  std::vector<TokenView> near = {};    // sides in lines before and after it, whose terms may be missing here
};

struct RepairCandidate {
  Slip slip = Slip::sign;
  std::size_t side = 0;     // 0 left, 1 right
  Tokens tokens;            // of the side
  std::string change;       // in words
  int distance = 0;         // from what was written: the likelier the slip, the nearer; a token counts one
  bool roundabout = false;  // it says what a nearer one says, as nobody would
};

/// A term to which the difference of the sides is compared.
struct ComparedTerm {
  std::size_t side = 0;
  std::optional<std::size_t> which = {};  // a term of the side, with its sign; none: a term more
  Tokens tokens = {};
  int further = 0;
};

class RepairCandidates {
 public:
  /// The tokens of all sides of the chain, without layout; they outlive this.
  RepairCandidates(const WrongStep& wrong, const std::vector<Tokens>& sides) : wrong_(wrong), sides_(sides) {}

  [[nodiscard]] TokenView side(std::size_t which) const { return sides_[wrong_.which + which]; }
  /// Each side with one slip taken back, the nearest first. `whole_side`: also the terms of the side as a
  /// whole.
  [[nodiscard]] std::vector<RepairCandidate> rewritten_sides(bool whole_side) const;
  /// Each side with a term more inside of its brackets, the nearest first.
  [[nodiscard]] std::vector<RepairCandidate> insertions() const;
  /// Each side with a letter that stands in lines near it, and in no side of its chain; the nearest first.
  [[nodiscard]] std::vector<RepairCandidate> with_letters_near() const;
  /// The terms of both sides, then those that may be missing: terms of the chain, images of its terms, terms
  /// of lines near it, simple products.
  [[nodiscard]] std::vector<ComparedTerm> terms() const;
  /// Longer products of vectors that may be missing.
  [[nodiscard]] std::vector<ComparedTerm> longer_terms() const;
  /// What becomes of the side where left − right is `ratio` times the term.
  [[nodiscard]] RepairCandidate with(const ComparedTerm& term, Coefficient ratio) const;

 private:
  [[nodiscard]] RepairCandidate made(std::size_t which, Slip slip, Tokens tokens, std::string change,
                                     int further) const;
  [[nodiscard]] RepairCandidate made(std::size_t which, const Rewriting& rewriting) const;
  template <class Rewrite>
  [[nodiscard]] std::vector<RepairCandidate> made_by(const Rewrite& rewrite) const;
  [[nodiscard]] int suspicion(std::size_t which) const;
  [[nodiscard]] bool is_the_shorter_sum(std::size_t which) const;
  [[nodiscard]] int imbalance(std::size_t which, TokenView now) const;
  [[nodiscard]] std::string words_for(std::size_t which, std::size_t term, Coefficient times) const;
  [[nodiscard]] std::vector<TokenView> chain() const { return {sides_.begin(), sides_.end()}; }

  const WrongStep& wrong_;
  const std::vector<Tokens>& sides_;
};

/// The nearest first; twice the same, `a = a` and what was written are left out.
void sort_and_reduce(std::vector<RepairCandidate>& candidates, TokenView left, TokenView right);

}  // namespace rigor
