// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the exact side. Each question is closed first (`closed_question.h`), so that its answer does not
// depend on what was asked before it. Decisions of this run are remembered, since neighbours of one row and
// sets of laws lead to the same questions, and those of earlier runs on the same notes, too: what was
// asked is compared as a whole (the closed question, the limits, the program), so that an answer is only ever
// used again for the very same question.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "algebra/decide/decide.h"
#include "check/question/decision_file.h"
#include "check/step/report.h"
#include "expr/statement/closed_question.h"

namespace rigor {

/// One file in a folder for each file of notes. A file that is damaged, cut short, or of another program is
/// as good as none. A sample that refutes is put into the question again before it is believed. Nothing
/// throws.
class DecisionCache {
 public:
  /// Of this run only.
  DecisionCache() = default;
  /// `program` identifies this build, with the libraries that decide.
  DecisionCache(const std::string& folder, const std::string& notes, std::string program);

  /// Starts the next step, with so much work for all questions about it. A remembered answer counts the work
  /// it took when it was decided, so that verdicts are the same with and without a cache.
  void begin(std::uint64_t effort) { budget_ = Budget(effort); }
  [[nodiscard]] Budget& budget() { return budget_; }

  [[nodiscard]] Decision decide(const Question& question, const Limits& limits);
  [[nodiscard]] std::optional<Sample> satisfying_sample(const Question& question, const Sample& known,
                                                        const Limits& limits);
  /// Writes the file if anything is new, without answers that several runs in turn did not need.
  void save();
  [[nodiscard]] const CacheUse& use() const { return use_; }

 private:
  struct Entry {
    std::string answer;  // as in `SavedAnswer`
    std::uint64_t work = 0;
    std::uint32_t age = 0;
    bool asked = false;
  };
  /// A decision of this run, and the work that it took.
  struct Made {
    Decision decision;
    std::uint64_t work = 0;
  };
  [[nodiscard]] Decision decide_once(const ClosedQuestion& asked, const Limits& limits,
                                     const std::string& key);
  Entry* find(const std::string& asked);
  void remember(const std::string& asked, std::string answer, std::uint64_t work);
  [[nodiscard]] bool has_file() const { return !path_.empty(); }
  /// Counts what an answer took before; false if there is not so much left.
  [[nodiscard]] bool takes(std::uint64_t work);

  std::string path_;
  std::string program_;
  std::map<std::string, Entry> entries_;        // by what was asked
  std::unordered_map<std::string, Made> made_;  // the same, where there is no file
  CacheUse use_;
  Budget budget_;
  bool changed_ = false;
};

/// As long as it lives, at most this much of what is left of a step's work may be used; then the rest of that
/// is there again.
class ShareOfWork {
 public:
  ShareOfWork(DecisionCache& cache, std::uint64_t most) : cache_(cache), of_step_(cache.budget()) {
    cache_.budget() = Budget(std::min(of_step_.left(), most));
  }
  ~ShareOfWork() {
    if (!of_step_.exhausted()) of_step_.count(std::min(cache_.budget().used(), of_step_.left()));
    cache_.budget() = of_step_;
  }
  ShareOfWork(const ShareOfWork&) = delete;
  ShareOfWork& operator=(const ShareOfWork&) = delete;

 private:
  DecisionCache& cache_;
  Budget of_step_;
};

/// Remembered, or decided; with no cache, decided.
[[nodiscard]] Decision decide(DecisionCache* cache, const Question& question, const Limits& limits = {});
[[nodiscard]] std::optional<Sample> satisfying_sample(DecisionCache* cache, const Question& question,
                                                      const Sample& known, const Limits& limits);

}  // namespace rigor
