// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of one chain, read together: they share their index letters, and what one of them says about a
// letter holds for all.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "check/directive/directive.h"
#include "check/verdict/judge.h"
#include "elaborate/name/names.h"
#include "elaborate/reading/reading.h"

namespace rigor {

class ChainReading {
 public:
  struct Side {
    std::optional<Typed> typed;  // nothing where it cannot be read
    Diagnostics diagnostics;
  };

  /// `syntax` holds the chain's sides.
  ChainReading(const SyntaxTree& syntax, ExprTree& tree, Names& names, const ParsedChain& parsed,
               const ReadingRules& how);
  ChainReading(const ChainReading&) = delete;
  ChainReading& operator=(const ChainReading&) = delete;

  /// Step `which` as one equation or order, greater turned into less; nothing where the sides do not fit,
  /// with diagnostics. `first_order`: `=` means ≈.
  [[nodiscard]] std::optional<Claim> claim(const ParsedChain& parsed, std::size_t which, bool first_order,
                                           Diagnostics& diagnostics);
  /// The same between any two sides, as the relation of step `which`.
  [[nodiscard]] std::optional<Claim> claim(const ParsedChain& parsed, std::size_t which, const Typed& left,
                                           const Typed& right, bool first_order, Diagnostics& diagnostics);
  /// All sides are read, and have the same free letters (a number has none and fits all).
  [[nodiscard]] bool is_balanced() const;
  /// Another part as it is read on one of its sides.
  [[nodiscard]] std::optional<Typed> read(SyntaxId id);
  [[nodiscard]] const Reading& reading() const { return reading_; }
  /// The directives that say what was looked up so far.
  [[nodiscard]] const Directives& used() const { return reading_.found.used; }
  /// What another way to read the chain looked up.
  void add_used(const Directives& used) { reading_.found.used.insert(used.begin(), used.end()); }
  [[nodiscard]] const ReadingRules& how() const { return reading_.rules; }

  std::vector<Side> sides;
  bool for_all = false;  // the author says so: `claim`, `expect refuted`

 private:
  ExprTree& tree_;
  Diagnostics own_;
  Reading reading_;
};

/// The plain reading, unless the indices of the sides only fit in another one: a letter that is free on one
/// side is not summed on another, or a prime does not make another letter of it. What was looked up for those
/// that did not fit is used as well.
[[nodiscard]] std::unique_ptr<ChainReading> read_chain(const SyntaxTree& syntax, ExprTree& tree, Names& names,
                                                       const ParsedChain& parsed, ReadingRules plain = {});

/// How open letters and brackets are read, without what was fitted to the indices of one chain.
[[nodiscard]] inline ReadingRules rules_for_like(const ReadingRules& how) {
  return {.apart = how.apart, .open = how.open};
}

}  // namespace rigor
