// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/decide/contradiction.h"

#include "algebra/engine/undecidable.h"

#include <numeric>

#include "algebra/decide/prove.h"
#include "algebra/parts/real_parts.h"
#include "algebra/words/operator_question.h"

namespace rigor {

bool assumptions_contradict(const Question& question, const Limits& limits) {
  if (is_about_operators(question)) return false;
  if (is_about_complex(question)) {
    try {
      return assumptions_contradict(in_real_parts(question).question, limits);
    } catch (const Undecidable&) {
      return false;
    }
  }
  const Scope scope(question, Scope::Definitions::unfolded);
  std::vector<std::size_t> all(question.assumptions.size());
  std::iota(all.begin(), all.end(), 0u);
  Work work;
  try {
    return prove(scope, {.effort = Effort::plain, .assumptions = all}, limits, work).holds;
  } catch (const Contradiction&) {
    return true;
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace rigor
