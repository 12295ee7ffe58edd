// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/decision_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/archive.h"
#include "base/md5.h"
#include "expr/statement/question_text.h"
#include "source/read_file.h"
#include "source/system_error.h"
#include "source/write_file.h"

namespace rigor {
namespace {

constexpr std::string_view first_line = "rigor decisions 2\n";
constexpr std::size_t digest_size = 32;
constexpr std::uint32_t oldest = 8;
constexpr std::size_t largest_file = 48 * 1024 * 1024;

// --- answers as bytes, their symbols numbered as in the question's text

struct NumberedValue {
  std::uint64_t symbol = 0;
  std::uint32_t particle = 0;
  std::vector<std::string> components;
};

struct NumberedSample {
  std::uint32_t particles = 0;
  std::vector<NumberedValue> values;
  std::vector<std::uint8_t> axes;
  std::vector<std::uint32_t> free_particles;
  std::string left;
  std::string right;
};

struct NumberedDecision {
  Outcome outcome = Outcome::undecided;
  bool vanishes = false;
  std::string route;
  std::string reason;
  bool no_real_value = false;
  std::vector<std::uint64_t> unfolded;
  std::vector<std::uint64_t> assumptions;
  std::vector<NumberedSample> samples;  // at most one
  std::uint64_t work = 0;               // that it took
};

struct NumberedSatisfaction {
  std::vector<NumberedSample> samples;  // at most one
  std::uint64_t work = 0;
};

struct SavedEntry {
  std::string question;
  std::string answer;
  std::uint32_t age = 0;
};

struct SavedCache {
  std::string program;
  std::vector<SavedEntry> entries;
};

template <class Archive>
void fields(Archive& archive, NumberedValue& value) {
  archive(value.symbol, value.particle, value.components);
}

template <class Archive>
void fields(Archive& archive, NumberedSample& sample) {
  archive(sample.particles, sample.values, sample.axes, sample.free_particles, sample.left, sample.right);
}

template <class Archive>
void fields(Archive& archive, NumberedDecision& decision) {
  archive.bounded(decision.outcome, 3);
  archive(decision.vanishes, decision.route, decision.reason, decision.no_real_value, decision.unfolded,
          decision.assumptions, decision.samples, decision.work);
}

template <class Archive>
void fields(Archive& archive, NumberedSatisfaction& satisfaction) {
  archive(satisfaction.samples, satisfaction.work);
}

template <class Archive>
void fields(Archive& archive, SavedEntry& entry) {
  archive(entry.question, entry.answer, entry.age);
}

template <class Archive>
void fields(Archive& archive, SavedCache& saved) {
  archive(saved.program, saved.entries);
}

template <class Value>
std::string packed(Value value) {
  ArchiveWriter writer;
  writer(value);
  return writer.take();
}

template <class Value>
std::optional<Value> unpacked(std::string_view bytes) {
  Value value;
  ArchiveReader reader(bytes);
  reader(value);
  return reader.finished() ? std::optional(std::move(value)) : std::nullopt;
}

// --- between numbers and symbols; nothing where a symbol is not in the question

std::optional<NumberedSample> numbered(const Sample& sample, const QuestionText& asked) {
  NumberedSample result{sample.particles, {}, sample.axes, sample.free_particles, sample.left, sample.right};
  for (const SampleValue& value : sample.values) {
    const auto number = asked.number_of.find(value.symbol);
    if (number == asked.number_of.end()) return std::nullopt;
    result.values.push_back({number->second, value.particle, value.components});
  }
  return result;
}

std::optional<Sample> with_symbols(const NumberedSample& sample, const QuestionText& asked) {
  Sample result{sample.particles, {}, sample.axes, sample.free_particles, sample.left, sample.right};
  for (const NumberedValue& value : sample.values) {
    if (value.symbol >= asked.symbols.size()) return std::nullopt;
    result.values.push_back({asked.symbols[value.symbol], value.particle, value.components});
  }
  return result;
}

std::optional<NumberedDecision> numbered(const Decision& decision, const QuestionText& asked) {
  NumberedDecision result{decision.outcome,
                          decision.vanishes,
                          decision.route,
                          decision.reason,
                          decision.no_real_value,
                          {},
                          {},
                          {},
                          0};
  for (const SymbolId symbol : decision.unfolded) {
    const auto number = asked.number_of.find(symbol);
    if (number == asked.number_of.end()) return std::nullopt;
    result.unfolded.push_back(number->second);
  }
  result.assumptions.assign(decision.assumptions.begin(), decision.assumptions.end());
  if (decision.sample) {
    auto sample = numbered(*decision.sample, asked);
    if (!sample) return std::nullopt;
    result.samples.push_back(*std::move(sample));
  }
  return result;
}

std::optional<Decision> with_symbols(const NumberedDecision& decision, const QuestionText& asked,
                                     const Question& question) {
  Decision result;
  result.outcome = decision.outcome;
  result.vanishes = decision.vanishes;
  result.route = decision.route;
  result.reason = decision.reason;
  result.no_real_value = decision.no_real_value;
  for (const std::uint64_t number : decision.unfolded) {
    if (number >= asked.symbols.size()) return std::nullopt;
    result.unfolded.push_back(asked.symbols[number]);
  }
  for (const std::uint64_t position : decision.assumptions) {
    if (position >= question.assumptions.size()) return std::nullopt;
    result.assumptions.push_back(static_cast<std::size_t>(position));
  }
  if (!decision.samples.empty()) {
    result.sample = with_symbols(decision.samples.front(), asked);
    if (!result.sample) return std::nullopt;
  }
  return result;
}

/// The second look at a refutation: nothing is searched for.
bool still_refutes(const Question& question, const Decision& decision) {
  if (decision.outcome != Outcome::refuted) return true;
  if (!decision.sample) return false;
  const Replay replay = replay_closely(question, *decision.sample);
  return replay.fault == Replay::Fault::none && replay.differ && replay.sides.left == decision.sample->left &&
         replay.sides.right == decision.sample->right;
}

std::string limits_text(const Limits& limits) {
  const auto& [expanded_terms, steps, quick_points, quick_steps, sample_attempts, fewest_assumptions,
               simplest_sample, budget] = limits;
  static_cast<void>(budget);  // an answer counts what it took
  return fmt::format("limits {} {} {} {} {} {} {}\n", expanded_terms, steps, quick_points, quick_steps,
                     sample_attempts, fewest_assumptions, simplest_sample);
}

std::string sample_text(const Sample& sample, const QuestionText& asked) {
  const auto result = numbered(sample, asked);
  return result ? packed(*result) : "";
}

}  // namespace

DecisionCache::DecisionCache(const std::string& folder, const std::string& notes, std::string program)
    : folder_(folder), program_(std::move(program)) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(notes, error).lexically_normal();
  path_ = (std::filesystem::path(folder) / (md5(absolute.string()) + ".decisions")).string();
  load();
}

void DecisionCache::load() {
  std::error_code error;
  if (!std::filesystem::exists(path_, error)) return;
  const Result<std::string> bytes = read_file(path_);
  if (!bytes) {
    use_.trouble = fmt::format("the cache `{}` cannot be read: {}", path_, bytes.error().reason);
    return;
  }
  std::string_view rest = *bytes;
  const bool ours = rest.starts_with(first_line);
  rest.remove_prefix(std::min(rest.size(), first_line.size()));
  const std::string_view digest = rest.substr(0, digest_size);
  rest.remove_prefix(digest.size());
  auto saved = ours && md5(rest) == digest ? unpacked<SavedCache>(rest) : std::nullopt;
  if (!saved) {
    use_.trouble = fmt::format("the cache `{}` is damaged; all is decided anew", path_);
    changed_ = true;
    return;
  }
  if (saved->program != program_) return;
  for (SavedEntry& entry : saved->entries)
    entries_.emplace(std::move(entry.question), Entry{std::move(entry.answer), entry.age, false});
}

DecisionCache::Entry* DecisionCache::find(const std::string& question) {
  ++use_.asked;
  const auto entry = entries_.find(question);
  if (entry == entries_.end()) return nullptr;
  entry->second.asked = true;
  return &entry->second;
}

void DecisionCache::remember(const std::string& question, std::string answer) {
  entries_[question] = {std::move(answer), 0, true};
  changed_ = true;
}

bool DecisionCache::takes(std::uint64_t work) {
  if (work > budget_.left()) return false;
  budget_.count(work);
  return true;
}

Decision DecisionCache::decide(const Question& question, const Limits& limits) {
  Limits counted = limits;
  counted.budget = &budget_;
  if (!remembers()) return rigor::decide(question, counted);
  const QuestionText asked = question_text(question);
  const std::string key = "decide\n" + limits_text(limits) + asked.text;
  if (const Entry* entry = find(key)) {
    const auto saved = unpacked<NumberedDecision>(entry->answer);
    auto decision = saved ? with_symbols(*saved, asked, question) : std::nullopt;
    if (decision && still_refutes(question, *decision) && takes(saved->work)) {
      ++use_.reused;
      return *std::move(decision);
    }
  }
  const std::uint64_t before = budget_.used();
  Decision decision = rigor::decide(question, counted);
  auto saved = budget_.exhausted() ? std::nullopt : numbered(decision, asked);
  if (saved) {
    saved->work = budget_.used() - before;
    remember(key, packed(*std::move(saved)));
  }
  return decision;
}

std::optional<Sample> DecisionCache::satisfying_sample(const Question& question, const Sample& known,
                                                       const Limits& limits) {
  Limits counted = limits;
  counted.budget = &budget_;
  if (!remembers()) return rigor::satisfying_sample(question, known, counted);
  std::vector<SymbolId> also;
  for (const SampleValue& value : known.values) also.push_back(value.symbol);
  const QuestionText asked = question_text(question, also);
  const std::string key =
      "satisfy\n" + limits_text(limits) + asked.text + "known\n" + sample_text(known, asked);
  if (const Entry* entry = find(key)) {
    const auto saved = unpacked<NumberedSatisfaction>(entry->answer);
    const bool none = saved && saved->samples.empty();
    std::optional<Sample> sample;
    if (saved && !none) sample = with_symbols(saved->samples.front(), asked);
    if ((sample || none) && takes(saved->work)) {
      ++use_.reused;
      return sample;
    }
  }
  const std::uint64_t before = budget_.used();
  std::optional<Sample> sample = rigor::satisfying_sample(question, known, counted);
  NumberedSatisfaction saved;
  if (auto found = sample ? numbered(*sample, asked) : std::nullopt)
    saved.samples.push_back(*std::move(found));
  saved.work = budget_.used() - before;
  if (!budget_.exhausted() && sample.has_value() != saved.samples.empty())
    remember(key, packed(std::move(saved)));
  return sample;
}

void DecisionCache::save() {
  if (!changed_) return;
  SavedCache saved{program_, {}};
  std::size_t size = 0;
  for (const bool asked : {true, false}) {
    for (const auto& [question, entry] : entries_) {
      const std::uint32_t age = entry.asked ? 0 : entry.age + 1;
      size += entry.asked == asked ? question.size() + entry.answer.size() : 0;
      if (entry.asked != asked || age > oldest || size > largest_file) continue;
      saved.entries.push_back({question, entry.answer, age});
    }
  }
  const std::string content = packed(std::move(saved));
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  const Result<void> written = error ? tl::make_unexpected(error_of(error))
                                     : replace_file(path_, std::string(first_line) + md5(content) + content);
  if (!written)
    use_.trouble = fmt::format("the cache `{}` cannot be written: {}", path_, written.error().reason);
  changed_ = false;
}

Decision decide(DecisionCache* cache, const Question& question, const Limits& limits) {
  return cache == nullptr ? decide(question, limits) : cache->decide(question, limits);
}

std::optional<Sample> satisfying_sample(DecisionCache* cache, const Question& question, const Sample& known,
                                        const Limits& limits) {
  return cache == nullptr ? satisfying_sample(question, known, limits)
                          : cache->satisfying_sample(question, known, limits);
}

}  // namespace rigor
