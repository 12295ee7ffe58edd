// SPDX-License-Identifier: GPL-3.0-or-later
// From one elaborated equation to one verdict. The exact side answers first; then the answer is weighed. A
// refutation counts only if the equation is meant for all values (else it is a law or a condition) and every
// assumption that bears on it was read. A proof counts only if the assumptions can hold together and its
// letters can only be real numbers. A verdict carries what it used, so that a directive without any use is
// found.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "algebra/decide/decide.h"
#include "check/step/report.h"
#include "elaborate/name/names.h"
#include "elaborate/reading/reading.h"
#include "expr/statement/question_names.h"

namespace rigor {

class DecisionCache;
struct RecordedStep;

struct Judgement {
  Verdict verdict = Verdict::not_understood;
  std::string route;
  std::vector<std::string> uses;
  std::optional<Counterexample> counterexample;
  Diagnostics diagnostics;
  Question question = {};                              // the last one that was asked
  bool of_another_question = false;                    // proved: of digits, of matrices
  QuestionNames names = {};                            // of the question's definitions and assumptions
  std::optional<NearlyQuestion> nearly_question = {};  // of `≈`, where it was asked for
  std::optional<Sample> sample = {};                   // refuted: as the exact side gave it
  std::vector<Repair> repairs = {};                    // suspect: what may have been meant
  std::vector<Equation> exists_under = {};  // proved: of a sum or an integral that is taken to exist
  bool measures = false;                    // proved: numbers of the page give the one that it shows
  bool restates = false;                    // a law: it says again what another one says
  bool despite_given = false;               // a law: it fails, though assumptions of directives bear on it
  std::vector<SymbolId> not_for_all = {};   // a law: the letters for which it reads as one
  std::set<std::size_t> used = {};          // directives that were needed, whatever the verdict
};

/// What is judged, and where it is written.
struct Claim {
  Equation equation;
  bool nearly = false;          // equal to first order in what is small
  bool swapped = false;         // `a > b` is asked as b < a
  bool for_all = false;         // its author says that it is meant for all values
  bool as_a_whole = false;      // ≠ of vectors or tensors, asked as |left − right|² ≠ 0
  std::string derived_by = {};  // it is about the derivatives by this of what is written
  Span relation = {};
  Span left = {};
  Span right = {};
  std::string written = {};          // both sides and the relation, where they can be pasted
  const Reading* reading = nullptr;  // for its conventions and guesses
  const Obstacle* doubt = nullptr;   // words next to it that may restrict it
  bool alternative = false;          // it is one of several that may hold
  bool digits_go_on = false;         // `3.1415\dots`: its decimal is cut off
  bool in_both_readings = false;     // a letter or bracket is open, and its other reading is asked, too
  bool explains = false;             // `names` and `nearly_question` are wanted
  RecordedStep* recorded = nullptr;  // a sample to be put in instead of a search
};

/// `cache` answers what it remembers.
[[nodiscard]] Judgement judge(ExprTree& tree, const Names& names, const Claim& claim,
                              const Limits& limits = {}, DecisionCache* cache = nullptr);

/// The same as if each letter were any real number.
[[nodiscard]] Judgement judge_at_once(ExprTree& tree, const Names& names, const Claim& claim,
                                      const Limits& limits = {}, DecisionCache* cache = nullptr);
/// The same where sums count to letters, which are whole numbers then.
[[nodiscard]] Judgement judge_counted(ExprTree& tree, const Names& names, const Claim& claim,
                                      const Limits& limits = {}, DecisionCache* cache = nullptr);

/// A sample that meets the last assumption together with those in scope that bear on it, if one is found;
/// `known` met earlier ones.
[[nodiscard]] std::optional<Sample> sample_of_assumptions(ExprTree& tree, const Names& names,
                                                          const Sample& known = {}, const Limits& limits = {},
                                                          DecisionCache* cache = nullptr);

}  // namespace rigor
