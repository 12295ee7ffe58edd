// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/entry/check.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "catch.h"
#include "check/checked.h"

namespace {

using namespace rigor;

/// A folder of its own that goes with the test.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("rigor-check-test-{}", ::getpid());

  Folder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return (path / name).string();
  }
};

std::string kinds(const FileReport& report) {
  std::string text;
  for (const Step& step : report.steps) text += std::string(name_of(step.verdict)) + " ";
  for (const Diagnostic& diagnostic : report.diagnostics)
    text += std::string(info(diagnostic.kind).name) + " ";
  return text;
}

std::string checked_file(const std::string& path, const CheckOptions& options = {}) {
  SourceMap sources;
  return kinds(check_file(sources, path, options));
}

const std::string symmetric = "$$T_{ij} = T_{ji} \\tag{1}$$\n";

}  // namespace

TEST_CASE("a sidecar that nobody named is a regular file in the notes' folder, or is refused") {
  const Folder folder;
  std::filesystem::create_directory(folder.path / "notes");
  const std::string notes = folder.write("notes/a.md", symmetric);
  const std::filesystem::path beside = folder.path / "notes" / "a.rigor";
  const auto put = [&](const std::string& target) {
    std::filesystem::remove(beside);
    std::filesystem::create_symlink(target, beside);
  };
  const std::string directive = "symmetric tensor T_{ij}\n";
  put(folder.write("elsewhere", directive));
  CHECK(checked_file(notes) == "unreadable-file ");
  put("/dev/zero");
  CHECK(checked_file(notes) == "unreadable-file ");
  put("nowhere");
  CHECK(checked_file(notes) == "unreadable-file ");
  folder.write("notes/other", directive);
  put("other");
  CHECK(checked_file(notes) == "proved ");
  std::filesystem::remove(beside);
  REQUIRE(::mkfifo(beside.c_str(), 0600) == 0);
  CHECK(checked_file(notes) == "unreadable-file ");
}

TEST_CASE("a missing file and a folder are unreadable, with the reason") {
  const Folder folder;
  for (const std::string& path : {(folder.path / "none.md").string(), folder.path.string()}) {
    SourceMap sources;
    const FileReport report = check_file(sources, path);
    CHECK(report.unreadable);
    REQUIRE(report.diagnostics.size() == 1);
    CHECK(report.diagnostics[0].kind == DiagnosticKind::unreadable_file);
    CHECK_FALSE(report.diagnostics[0].message.empty());
    CHECK(sources.path(report.file) == path);
  }
}

TEST_CASE("an empty file has no equations") {
  const Folder folder;
  CHECK(checked_file(folder.write("notes.md", "")) == "no-equations ");
  CHECK(lines_of("text only\n") == "1:1 no-equations\n");
}

TEST_CASE("the format follows from the name of the file") {
  const std::string latex = "\\section{One}\n\\[\\delta_{ii} = 3\\] % $$\n";
  CHECK(Checked(latex, "notes.tex").lines() == "proved\n");
  CHECK(Checked("\\begin{comment}\n$$\\delta_{ii} = 2$$\n\\end{comment}\n", "notes.tex").lines() ==
        "1:1 no-equations\n");
  CHECK(Checked("% rigor: for all T_{ij}\n" + symmetric, "notes.tex").lines() == "refuted 2:10 refuted\n");
}

TEST_CASE("a sidecar beside the notes is found by itself") {
  const Folder folder;
  const std::string notes = folder.write("notes.md", symmetric);
  CHECK(checked_file(notes) == "law ");
  folder.write("notes.rigor", "symmetric tensor T\n");
  CHECK(checked_file(notes) == "proved ");
}

TEST_CASE("a sidecar that is named takes the place of the one beside the notes") {
  const Folder folder;
  const std::string notes = folder.write("notes.md", symmetric);
  folder.write("notes.rigor", "symmetric tensor T\n");
  CheckOptions options;
  options.sidecar = folder.write("other.rigor", "at (1)\nfor all T_{ij}\n");
  CHECK(checked_file(notes, options) == "refuted ");
}

TEST_CASE("a sidecar that is named and missing is unreadable") {
  const Folder folder;
  CheckOptions options;
  options.sidecar = (folder.path / "none.rigor").string();
  SourceMap sources;
  const FileReport report = check_file(sources, folder.write("notes.md", symmetric), options);
  CHECK(report.unreadable);
  CHECK(sources.path(report.diagnostics.at(0).span.file) == *options.sidecar);
}

TEST_CASE("a claim of a sidecar is reported where it is anchored in the notes") {
  const Folder folder;
  const std::string notes = folder.write("notes.md", "text\n\n" + symmetric);
  folder.write("notes.rigor", "symmetric tensor T\nat (1)\nclaim T_{12} - T_{21} = 0\n");
  SourceMap sources;
  const FileReport report = check_file(sources, notes);
  REQUIRE(kinds(report) == "proved proved ");
  CHECK(sources.path(report.steps[0].span.file) == notes);
  CHECK(sources.line_column(report.steps[0].span.file, report.steps[0].span.begin).line == 3);
  CHECK(report.steps[0].source == "T_{12} - T_{21} = 0");
}

TEST_CASE("bytes that are no text are reported and the rest is checked") {
  CHECK(lines_of(std::string("a\0b\n\n$$\\delta_{ii} = 3$$\n", 26)) == "proved\n1:2 nul-byte\n");
  CHECK(lines_of("a\xff\n\n$$\\delta_{ii} = 3$$\n") == "proved\n1:2 invalid-utf8\n");
}

TEST_CASE("the report of a text is the same twice") {
  const std::string text =
      "$$(a+b)^2 = a^2 + b^2$$\n\n$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n";
  const Checked first(text);
  const Checked second(text);
  CHECK(first.lines() == second.lines());
  REQUIRE(first.report.steps.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    REQUIRE(first.report.steps[k].counterexample.has_value());
    const Counterexample& one = *first.report.steps[k].counterexample;
    const Counterexample& other = second.report.steps[k].counterexample.value();
    CHECK(one.left == other.left);
    CHECK(one.values.at(0).components == other.values.at(0).components);
  }
}

TEST_CASE("progress is told while a file is checked") {
  SourceMap sources;
  std::size_t told = 0;
  CheckOptions options;
  options.progress = [&](std::size_t done, std::size_t all) { told += done == all ? 1U : 0U; };
  CHECK(kinds(check_text(sources, "notes.md", symmetric + symmetric, options)) == "law proved ");
  CHECK(told == 1);
}
