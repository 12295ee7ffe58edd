// SPDX-License-Identifier: GPL-3.0-or-later
// A question is a value: its answer depends neither on what was asked before it nor on who asks.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

#include "algebra/decide/decide.h"
#include "catch.h"
#include "check/entry/check.h"
#include "check/question/decision_cache.h"
#include "expr/statement/archived.h"
#include "source/read_file.h"
#include "source/write_file.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

using Order = std::vector<std::size_t>;

/// A folder that is removed when its object goes out of scope.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("rigor-order-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] fs::path path() const { return path_; }

 private:
  fs::path path_;
};

/// What a check of the notes asks, with the answers.
std::vector<SavedAnswer> asked_in(const std::string& notes) {
  const Folder folder;
  DecisionCache cache(folder.path().string(), notes, "p");
  SourceMap sources;
  const FileReport report = check_file(sources, notes, {.cache = &cache});
  REQUIRE_FALSE(report.unreadable);
  cache.save();
  if (fs::is_empty(folder.path())) return {};
  auto answers = read_answers(fs::directory_iterator(folder.path())->path().string(), "p");
  REQUIRE(answers);
  return *std::move(answers);
}

/// The answer to what was asked, as bytes.
std::string decided_anew(const std::string& bytes) {
  const auto asked = asked_of_bytes(bytes);
  const auto question = asked ? question_of_bytes(asked->question) : std::nullopt;
  if (!question) return "not read back";
  Budget budget;
  Limits limits = asked->limits;
  limits.budget = &budget;
  if (asked->kind == AskedQuestion::Kind::decide) return archived(decide(question->question, limits));
  const auto known = sample_of_bytes(asked->known);
  if (!known) return "not read back";
  const auto sample = satisfying_sample(question->question, *known, limits);
  return sample ? archived(*sample) : "";
}

/// The questions that get another answer in this order.
std::vector<std::size_t> answered_otherwise(const std::vector<SavedAnswer>& answers, const Order& order) {
  std::vector<std::size_t> otherwise;
  for (const std::size_t which : order) {
    if (decided_anew(answers[which].asked) != answers[which].answer) otherwise.push_back(which);
  }
  return otherwise;
}

/// The same in a process of its own.
std::vector<std::size_t> answered_otherwise_elsewhere(const std::vector<SavedAnswer>& answers,
                                                      const Order& order) {
  const Folder folder;
  const std::string path = (folder.path() / "otherwise").string();
  const pid_t child = ::fork();
  if (child == 0) {
    std::string text;
    for (const std::size_t which : answered_otherwise(answers, order)) text += std::to_string(which) + "\n";
    ::_exit(replace_file(path, text) ? 0 : 1);
  }
  int status = -1;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(status == 0);
  const auto text = read_file(path);
  REQUIRE(text);
  std::istringstream lines(*text);
  return {std::istream_iterator<std::size_t>(lines), {}};
}

/// How many questions were asked.
std::size_t check_orders(const std::string& notes) {
  INFO(notes);
  const std::vector<SavedAnswer> answers = asked_in(notes);
  Order order(answers.size());
  std::iota(order.begin(), order.end(), 0);
  const Order none;
  std::reverse(order.begin(), order.end());
  CHECK(answered_otherwise(answers, order) == none);
  std::mt19937 random(7);
  std::shuffle(order.begin(), order.end(), random);
  const auto half = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  CHECK(answered_otherwise(answers, {order.begin(), half}) == none);
  CHECK(answered_otherwise_elsewhere(answers, {half, order.end()}) == none);
  return answers.size();
}

std::set<std::string> notes_in(const std::string& folder) {
  std::set<std::string> notes;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".md" || kind == ".tex") notes.insert(entry.path().string());
  }
  return notes;
}

TEST_CASE("the questions of the derivations have the same answers in any order and process") {
  const std::set<std::string> all = notes_in("derivations");
  for (const std::string& notes : all) CHECK(check_orders(notes) > 0);
  CHECK_FALSE(all.empty());
}

TEST_CASE("the questions of the small notes have the same answers in any order and process", "[long]") {
  std::size_t asked = 0;
  for (const char* folder : {"tests/notes/pass", "tests/notes/fail"}) {
    for (const std::string& notes : notes_in(folder)) asked += check_orders(notes);
  }
  CHECK(asked > 1000);
}

TEST_CASE("the questions of the notes in RIGOR_ORDER_OF", "[.order]") {
  const char* const of = std::getenv("RIGOR_ORDER_OF");
  REQUIRE(of != nullptr);
  std::istringstream paths(of);
  for (std::string notes; paths >> notes;) static_cast<void>(check_orders(notes));
}

}  // namespace
}  // namespace rigor
