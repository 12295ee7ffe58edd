// SPDX-License-Identifier: GPL-3.0-or-later
// From a claim to the question that the exact side is asked: with the definitions behind its symbols, those
// of derivatives made on demand, and the assumptions that share a symbol with it. An assumption holds at all
// times and places, so its derivatives are assumptions, too.
#pragma once

#include <span>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

struct Prepared {
  Question question;
  std::vector<const Origin*> definitions;           // where each of the question's definitions comes from
  std::vector<std::vector<const Origin*>> put_in;   // into each: other definitions, as into the value F(a)
  std::vector<const NamedAssumption*> assumptions;  // the same; nullptr where a kind implies it (|n| = 1)
  std::size_t without_slack = 0;                    // so many of the assumptions would be there without slack
  std::optional<std::string> too_large = {};        // why derivatives are missing: then nothing is decided
  std::size_t made = 0;                   // so many nodes were made for derivatives: the work it took
  std::vector<SymbolId> unknown_changes;  // differentiated, though nothing says whether they change
  std::vector<SymbolId> parameters =
      {};                // of these, those that were held, as what is written of x holds them
  Directives used = {};  // that say how something changes, or that it is small
  std::vector<std::string> conventions = {};  // that the values of its integrals rest on
  std::vector<const NamedAssumption*> integrals_rest_on =
      {};  // the values of its integrals, or that they exist
  std::optional<std::size_t> exists_under =
      {};  // from here on, assumptions without which an integral has none
  std::optional<std::string> open_integral = {};  // an integral whose value is not known, and why
  bool open_sum = false;                          // there are sums, of which this may be one
  bool open_average = false;                      // there are averages, of which only linearity is known
  bool has_laws_of_operators = false;             // that bear on these
  bool has_rates_or_times = false;  // something in the assumptions has a rate, or speaks of the time or place
  /// Taken, speaks of the time or place itself, and leaves no quantity free to follow it: what it says at all
  /// times would have to be compared coefficient by coefficient.
  const NamedAssumption* unmatched = nullptr;
};

/// How a claim is meant: exactly, or order by order in what is small.
enum class Precision : std::uint8_t { exact, small_order };

/// `slack`: by how many orders derivatives of assumptions may go beyond those in the claim: a condition may
/// only show in them. `order`: which derivative by the small parameter is asked for, where everything small
/// is 0; 0 and 1 make "equal to first order". `also`: expressions that are to be evaluated under the same
/// definitions and assumptions.
[[nodiscard]] Prepared prepare(ExprTree& tree, const Names& names, const Equation& claim, int slack = 0,
                               Precision precision = Precision::exact, int order = 0,
                               std::span<const ExprId> also = {});

/// The members of families that the equation speaks of are defined, in names that are a copy.
void define_members(ExprTree& tree, Names& names, const Equation& equation);

/// Do the assumptions that bear on a question speak of derivatives, times or places, so that more slack may
/// show more?
[[nodiscard]] bool speaks_of_derivatives(const Prepared& prepared);

}  // namespace rigor
