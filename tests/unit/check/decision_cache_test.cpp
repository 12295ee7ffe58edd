// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/decision_cache.h"

#include <unistd.h>

#include <filesystem>

#include "catch.h"
#include "check/entry/check.h"
#include "expr/build.h"
#include "source/read_file.h"
#include "source/write_file.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

const std::string notes =
    "<!-- rigor: scalar k -->\n"
    "$$\\mathbf{C} = \\mathbf{A}\\times\\mathbf{B}$$\n\n"
    "$$\\mathbf{C}\\cdot\\mathbf{A} = 0$$\n\n"
    "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n";

/// A folder for the caches of one test.
class CacheFolder {
 public:
  CacheFolder() : path_(fs::temp_directory_path() / ("rigor-cache-" + std::to_string(::getpid()))) {
    fs::remove_all(path_);
  }
  ~CacheFolder() { fs::remove_all(path_); }
  CacheFolder(const CacheFolder&) = delete;
  CacheFolder& operator=(const CacheFolder&) = delete;

  /// What is asked and reused in a run on the notes.
  CacheUse run(const std::string& text, const std::string& program = "p") {
    DecisionCache cache(path_.string(), "notes.md", program);
    SourceMap sources;
    report = check_text(sources, "notes.md", text, {.cache = &cache});
    cache.save();
    return cache.use();
  }
  [[nodiscard]] std::string file() const { return fs::directory_iterator(path_)->path().string(); }
  [[nodiscard]] fs::path path() const { return path_; }
  FileReport report;

 private:
  fs::path path_;
};

std::vector<Verdict> verdicts(const FileReport& report) {
  std::vector<Verdict> all;
  for (const Step& step : report.steps) all.push_back(step.verdict);
  return all;
}

const std::vector<Verdict> expected{Verdict::definition, Verdict::proved, Verdict::refuted};

TEST_CASE("what was decided is not decided again, and the report is the same") {
  CacheFolder folder;
  const CacheUse first = folder.run(notes);
  CHECK(first.asked > 0);
  CHECK(verdicts(folder.report) == expected);
  const FileReport before = folder.report;
  const CacheUse second = folder.run(notes);
  CHECK(second.reused == second.asked);
  CHECK(second.asked == first.asked);
  CHECK(verdicts(folder.report) == expected);
  for (std::size_t k = 0; k < before.steps.size(); ++k) {
    CHECK(folder.report.steps[k].route == before.steps[k].route);
    CHECK(folder.report.steps[k].uses == before.steps[k].uses);
  }
  CHECK(folder.report.steps[2].counterexample->left == before.steps[2].counterexample->left);
}

TEST_CASE("lines above that declare nothing lose nothing") {
  CacheFolder folder;
  static_cast<void>(folder.run(notes));
  const CacheUse moved = folder.run("# A heading\n\nWords.\n\n" + notes);
  CHECK(moved.reused == moved.asked);
}

TEST_CASE("another definition upstream is another question") {
  CacheFolder folder;
  static_cast<void>(folder.run(notes));
  std::string changed = notes;
  changed.replace(changed.find("\\times"), 6, "+");
  const CacheUse use = folder.run(changed);
  CHECK(use.reused < use.asked);
  CHECK(folder.report.steps[1].verdict != Verdict::proved);
}

TEST_CASE("another program decides all by itself") {
  CacheFolder folder;
  static_cast<void>(folder.run(notes));
  CHECK(folder.run(notes, "q").trouble.empty());
  static_cast<void>(folder.run(notes));
  const CacheUse first = folder.run(notes, "q");
  const CacheUse second = folder.run(notes, "q");
  CHECK(first.reused < second.reused);
}

TEST_CASE("a damaged or shortened cache changes no verdict and is made anew") {
  CacheFolder folder;
  static_cast<void>(folder.run(notes));
  const std::string path = folder.file();
  const std::string bytes = read_file(path).value();
  std::vector<std::string> damaged{"", "rigor decisions 1\n", std::string(5000, '\xff'),
                                   bytes.substr(0, bytes.size() / 2), bytes + "x"};
  for (std::size_t at = 0; at < bytes.size(); at += bytes.size() / 40) {
    damaged.push_back(bytes);
    damaged.back()[at] = static_cast<char>(damaged.back()[at] ^ 1);
  }
  for (const std::string& text : damaged) {
    REQUIRE(write_file(path, text));
    const CacheUse use = folder.run(notes);
    CHECK(use.trouble.find("is damaged") != std::string::npos);
    CHECK(verdicts(folder.report) == expected);
    CHECK(folder.run(notes).trouble.empty());
  }
}

TEST_CASE("a cache that cannot be written says so and changes no verdict") {
  CacheFolder folder;
  REQUIRE(write_file(folder.path().string(), "a file, no folder"));
  CHECK(folder.run(notes).trouble.find("cannot be written: ") != std::string::npos);
  CHECK(verdicts(folder.report) == expected);
}

TEST_CASE("a question that is asked again in a run gets the same answer and counts the same work") {
  build::Page page;
  const build::Named x = page.scalar("x");
  const build::Named y = page.scalar("y");
  page.given(x, 2 * y);
  DecisionCache cache;
  const auto asked = [&](const build::Term& right) {
    const std::uint64_t before = cache.budget().used();
    const Decision decision = cache.decide(page.claim(build::pow(x, 2), right), {});
    return std::pair(decision.outcome, cache.budget().used() - before);
  };
  const build::Term right = 4 * build::pow(y, 2);
  const auto first = asked(right);
  CHECK(first.first == Outcome::proved);
  CHECK(first.second > 0);
  CHECK(asked(right) == first);
  CHECK(asked(3 * build::pow(y, 2)).first == Outcome::refuted);
  cache.begin(0);
  CHECK(asked(right).first != Outcome::proved);  // no work is left for what it took
}

TEST_CASE("what is no longer asked for is forgotten in the end") {
  CacheFolder folder;
  static_cast<void>(folder.run(notes));
  const auto size = fs::file_size(folder.file());
  std::string last;
  for (int k = 2; k < 14; ++k) {
    last = "$$\\mathbf{A}\\cdot\\mathbf{A} = " + std::to_string(k) + "\\mathbf{A}\\cdot\\mathbf{A}$$\n";
    static_cast<void>(folder.run(last));
  }
  const CacheUse first = folder.run(notes);
  const CacheUse second = folder.run(notes);
  CHECK(first.reused < second.reused);
  CHECK(fs::file_size(folder.file()) < 20 * size);
}

}  // namespace
}  // namespace rigor
