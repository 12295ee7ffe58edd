// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/check.h"
#include "catch.h"
#include "source/read_file.h"
#include "source/write_file.h"

namespace rigor {
namespace {

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

Outcome run_with(std::vector<const char*> words) {
  words.insert(words.begin(), "rigor");
  std::ostringstream out;
  std::ostringstream err;
  const int code = run(static_cast<int>(words.size()), words.data(), out, err);
  return {code, out.str(), err.str()};
}

TEST_CASE("a wrong command line ends with 64 and speaks on the error stream only") {
  const Outcome outcome = run_with({"check"});
  CHECK(outcome.code == 64);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "rigor: FILE is required\nTry `rigor check --help`.\n");
}

TEST_CASE("help ends with 0 and speaks on the output only") {
  const Outcome outcome = run_with({"--help"});
  CHECK(outcome.code == 0);
  CHECK(outcome.out.find("Exit codes:") != std::string::npos);
  CHECK(outcome.err.empty());
}

TEST_CASE("a file that is missing ends with 66, even where others are read") {
  const Outcome outcome = run_with({"check", "no/such/notes.md", "docs/json.md", "--color", "never"});
  CHECK(outcome.code == 66);
  CHECK(outcome.out.find("no/such/notes.md:1:1: error: ") != std::string::npos);
  CHECK(outcome.out.find("docs/json.md\n") != std::string::npos);
  CHECK(outcome.out.find(" in 2 files: ") != std::string::npos);
}

TEST_CASE("marks of a file that cannot be read replace no marks") {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("rigor-marks-{}", getpid());
  REQUIRE(write_file(path.string(), "earlier marks\n"));
  CHECK(run_with({"check", "no/such/notes.tex", "--marks", path.c_str()}).code == 66);
  CHECK(read_file(path.string()).value() == "earlier marks\n");
  std::filesystem::remove(path);
}

TEST_CASE("marks overwrite neither the notes nor their sidecar") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("rigor-overwrite-{}", getpid());
  std::filesystem::create_directory(folder);
  const std::string notes = (folder / "a.md").string();
  const std::string sidecar = (folder / "a.rigor").string();
  REQUIRE(write_file(notes, "$$ A^2 = A^2 $$\n"));
  REQUIRE(write_file(sidecar, "% nothing\n"));
  const std::string detour = (folder / ".." / folder.filename() / "a.rigor").string();
  for (const std::string& marks : {notes, detour}) {
    const Outcome outcome = run_with({"check", notes.c_str(), "--marks", marks.c_str()});
    CHECK(outcome.code == 64);
    CHECK(outcome.err == fmt::format("rigor: `{}` is read here, and is not overwritten with marks\n", marks));
  }
  CHECK(read_file(notes).value() == "$$ A^2 = A^2 $$\n");
  CHECK(read_file(sidecar).value() == "% nothing\n");
  std::filesystem::remove_all(folder);
}

TEST_CASE("with --json the output is JSON and nothing else") {
  const Outcome outcome = run_with({"check", "--json", "no/such/notes.md"});
  CHECK(outcome.code == 66);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["files"][0]["file"] == "no/such/notes.md");
  CHECK(json["files"][0]["diagnostics"][0]["kind"] == "unreadable-file");
  CHECK(outcome.err.empty());
}

TEST_CASE("colour is written where it is asked for, and not into what is no terminal by itself") {
  CHECK(run_with({"check", "no/such.md", "--color", "always"}).out.find('\x1b') != std::string::npos);
  CHECK(run_with({"check", "no/such.md"}).out.find('\x1b') == std::string::npos);
}

TEST_CASE("output that cannot be written is not passed over") {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  std::ostringstream err;
  const std::vector<const char*> words{"rigor", "check", "docs/json.md"};
  CHECK(run(static_cast<int>(words.size()), words.data(), out, err) == 66);
  CHECK(err.str() == "rigor: the standard output cannot be written\n");
}

TEST_CASE("every exception ends with 70 and its text") {
  std::ostringstream err;
  CHECK(run_guarded(err, [] { return 2; }) == 2);
  CHECK(err.str().empty());
  CHECK(run_guarded(err, []() -> int { throw InternalError("check failed"); }) == 70);
  CHECK(run_guarded(err, []() -> int { throw std::runtime_error("no memory"); }) == 70);
  CHECK(run_guarded(err, []() -> int { throw 7; }) == 70);
  CHECK(err.str() ==
        "rigor: internal error: check failed\n"
        "rigor: unexpected error: no memory\n"
        "rigor: unexpected error\n");
}

}  // namespace
}  // namespace rigor
