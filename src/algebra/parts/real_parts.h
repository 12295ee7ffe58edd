// SPDX-License-Identifier: GPL-3.0-or-later
// A question about complex numbers as one about real numbers. A complex symbol becomes a real one with one
// more axis, the first, of two dimensions: 1 is its real part, 2 its imaginary part. An expression becomes
// two, of which one is missing where the other is all there is: 2i has no real part, |z| no imaginary one. An
// equation of complex sides becomes one with that axis, so it is proved if both parts are equal and refuted
// if one of them differs.
//
// Why a tree and not a further kind of number in the evaluator: then constraints, proofs, samples and their
// search have nothing to learn, and a question without complex numbers pays nothing.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "expr/statement/statement.h"

namespace rigor {

/// Does i, a conjugate or part, or a complex symbol occur?
[[nodiscard]] bool is_about_complex(const Question& question);

struct RealQuestion {
  std::unique_ptr<ExprTree> tree;  // symbols, definitions and assumptions are numbered as before
  Question question;               // in `tree`
  std::vector<bool> in_parts;      // by symbol: was complex, and now has the axis of parts
  Equation sides;                  // what the claim's sides are worth: as in the claim, but for ≠
  bool sides_in_parts = false;     // these have the axis of parts
  std::vector<std::optional<Equation>> more;  // further claims; nothing where one cannot be taken apart
};

/// Throws Undecidable where a root or an order is asked of what may not be real, or a real symbol is defined
/// by what may not be.
[[nodiscard]] RealQuestion in_real_parts(const Question& question, std::span<const Equation> more = {});

}  // namespace rigor
