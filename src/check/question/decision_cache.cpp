// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/decision_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/md5.h"
#include "expr/statement/archived.h"

namespace rigor {
namespace {

constexpr std::uint32_t oldest = 8;
constexpr std::size_t most_made = 10'000;  // of a few kilobytes each
constexpr std::size_t largest_file = 48 * 1024 * 1024;

bool has_symbols_of(const ClosedQuestion& question, const Sample& sample) {
  return std::ranges::all_of(sample.values, [&](const SampleValue& value) {
    return static_cast<std::size_t>(value.symbol) < question.symbols.size();
  });
}

/// Does all that it names belong to the question?
bool answers(const ClosedQuestion& asked, const Decision& decision) {
  const auto is_symbol = [&](SymbolId symbol) {
    return static_cast<std::size_t>(symbol) < asked.symbols.size();
  };
  const auto is_assumption = [&](std::size_t which) { return which < asked.question.assumptions.size(); };
  bool proof_fits = !decision.proof || cofactors_hold(*decision.proof);
  if (decision.proof)
    for_each_symbol(*decision.proof, [&](SymbolId symbol) { proof_fits = proof_fits && is_symbol(symbol); });
  return proof_fits && std::ranges::all_of(decision.unfolded, is_symbol) &&
         std::ranges::all_of(decision.assumptions, is_assumption) &&
         (!decision.sample || has_symbols_of(asked, *decision.sample));
}

/// The second look at a refutation: nothing is searched for.
bool still_refutes(const Question& question, const Decision& decision) {
  if (decision.outcome != Outcome::refuted) return true;
  if (!decision.sample) return false;
  const Replay replay = replay_closely(question, *decision.sample);
  return replay.fault == Replay::Fault::none && replay.differ && replay.sides.left == decision.sample->left &&
         replay.sides.right == decision.sample->right;
}

}  // namespace

DecisionCache::DecisionCache(const std::string& folder, const std::string& notes, std::string program)
    : program_(std::move(program)) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(notes, error).lexically_normal();
  path_ = (std::filesystem::path(folder) / (md5(absolute.string()) + ".decisions")).string();
  if (!std::filesystem::exists(path_, error)) return;
  Result<std::vector<SavedAnswer>> saved = read_answers(path_, program_);
  if (!saved) {
    use_.trouble = fmt::format("the cache `{}` cannot be read: {}; everything is decided anew", path_,
                               saved.error().reason);
    changed_ = true;
    return;
  }
  for (SavedAnswer& each : *saved) {
    std::string asked = std::exchange(each.asked, {});
    entries_.emplace(std::move(asked), Entry{std::move(each.answer), each.work, each.age, false});
  }
}

DecisionCache::Entry* DecisionCache::find(const std::string& asked) {
  ++use_.asked;
  const auto entry = entries_.find(asked);
  if (entry == entries_.end()) return nullptr;
  entry->second.asked = true;
  return &entry->second;
}

void DecisionCache::remember(const std::string& asked, std::string answer, std::uint64_t work) {
  entries_[asked] = {std::move(answer), work, 0, true};
  changed_ = true;
}

bool DecisionCache::takes(std::uint64_t work) {
  if (budget_.exhausted() || work > budget_.left()) return false;
  budget_.count(work);
  return true;
}

Decision DecisionCache::decide(const Question& question, const Limits& limits) {
  Limits counted = limits;
  counted.budget = &budget_;
  const ClosedQuestion asked = closed(question);
  const std::string key =
      archived({.kind = AskedQuestion::Kind::decide, .limits = limits, .question = archived(asked)});
  if (!has_file()) return in_notes(decide_once(asked, counted, key), asked);
  if (const Entry* entry = find(key)) {
    auto decision = decision_of_bytes(entry->answer);
    if (decision && answers(asked, *decision) && still_refutes(asked.question, *decision) &&
        takes(entry->work)) {
      ++use_.reused;
      return in_notes(*std::move(decision), asked);
    }
  }
  const std::uint64_t before = budget_.used();
  Decision decision = rigor::decide(asked.question, counted);
  if (!budget_.exhausted()) remember(key, archived(decision), budget_.used() - before);
  return in_notes(std::move(decision), asked);
}

Decision DecisionCache::decide_once(const ClosedQuestion& asked, const Limits& limits,
                                    const std::string& key) {
  const auto known = made_.find(key);
  if (known != made_.end() && takes(known->second.work)) return known->second.decision;
  const std::uint64_t before = budget_.used();
  Decision decision = rigor::decide(asked.question, limits);
  if (!budget_.exhausted() && made_.size() < most_made)
    made_.try_emplace(key, Made{decision, budget_.used() - before});
  return decision;
}

std::optional<Sample> DecisionCache::satisfying_sample(const Question& question, const Sample& known,
                                                       const Limits& limits) {
  Limits counted = limits;
  counted.budget = &budget_;
  std::vector<SymbolId> also;
  for (const SampleValue& value : known.values) also.push_back(value.symbol);
  const ClosedQuestion asked = closed(question, also);
  const auto answer = [&](std::optional<Sample> sample) {
    return sample ? std::optional(in_notes(*std::move(sample), asked)) : std::nullopt;
  };
  const Sample known_there = in_question(known, asked);
  if (!has_file()) return answer(rigor::satisfying_sample(asked.question, known_there, counted));
  const std::string key = archived({.kind = AskedQuestion::Kind::satisfy,
                                    .limits = limits,
                                    .question = archived(asked),
                                    .known = archived(known_there)});
  if (const Entry* entry = find(key)) {
    const bool none = entry->answer.empty();
    auto sample = none ? std::nullopt : sample_of_bytes(entry->answer);
    if ((none || (sample && has_symbols_of(asked, *sample))) && takes(entry->work)) {
      ++use_.reused;
      return answer(std::move(sample));
    }
  }
  const std::uint64_t before = budget_.used();
  std::optional<Sample> sample = rigor::satisfying_sample(asked.question, known_there, counted);
  if (!budget_.exhausted()) remember(key, sample ? archived(*sample) : "", budget_.used() - before);
  return answer(std::move(sample));
}

void DecisionCache::save() {
  if (!changed_) return;
  std::vector<SavedAnswer> saved;
  std::size_t size = 0;
  for (const bool asked : {true, false}) {
    for (const auto& [question, entry] : entries_) {
      const std::uint32_t age = entry.asked ? 0 : entry.age + 1;
      size += entry.asked == asked ? question.size() + entry.answer.size() : 0;
      if (entry.asked != asked || age > oldest || size > largest_file) continue;
      saved.push_back({question, entry.answer, entry.work, age});
    }
  }
  const Result<void> written = write_answers(path_, program_, std::move(saved));
  if (!written)
    use_.trouble = fmt::format("the cache `{}` cannot be written: {}", path_, written.error().reason);
  changed_ = false;
}

Decision decide(DecisionCache* cache, const Question& question, const Limits& limits) {
  return cache == nullptr ? DecisionCache().decide(question, limits) : cache->decide(question, limits);
}

std::optional<Sample> satisfying_sample(DecisionCache* cache, const Question& question, const Sample& known,
                                        const Limits& limits) {
  return cache == nullptr ? DecisionCache().satisfying_sample(question, known, limits)
                          : cache->satisfying_sample(question, known, limits);
}

}  // namespace rigor
