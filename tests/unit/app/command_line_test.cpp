// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/command_line.h"

#include "algebra/engine/engine_version.h"
#include "base/version.h"
#include "catch.h"

namespace rigor {
namespace {

CommandLine parse(std::vector<const char*> words) {
  words.insert(words.begin(), "rigor");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

std::string usage_error(std::vector<const char*> words) {
  const CommandLine line = parse(std::move(words));
  CHECK_FALSE(line.check);
  CHECK(line.code == ExitCode::usage);
  return line.text.substr(0, line.text.find('\n'));
}

TEST_CASE("files and nothing else leave every option as it is") {
  const CommandLine line = parse({"check", "a.md", "b.tex"});
  REQUIRE(line.check);
  CHECK(line.check->files == std::vector<std::string>{"a.md", "b.tex"});
  CHECK_FALSE(line.check->sidecar);
  CHECK(line.check->format == ReportFormat::text);
  CHECK_FALSE(line.check->strict);
  CHECK(line.check->color == ColorWhen::automatic);
  CHECK(line.check->debug.empty());
}

TEST_CASE("a statement, a file or a name that is empty is a wrong command line") {
  for (const auto& words : std::vector<std::vector<const char*>>{{"derive", ""},
                                                                 {"derive", " "},
                                                                 {"check", ""},
                                                                 {"eval", "a.md", "--at", ""},
                                                                 {"explain", "\t"},
                                                                 {"check", "a.md", "--sidecar", ""},
                                                                 {"derive", "x^2=4", "--solve-for", ""}}) {
    CHECK(usage_error(words).find("is empty") != std::string::npos);
  }
}

TEST_CASE("options are read before and after the files") {
  const CommandLine line = parse({"check", "--json", "--debug", "time", "a.md", "--strict", "--sidecar",
                                  "s.rigor", "--debug", "steps", "--color", "always"});
  REQUIRE(line.check);
  CHECK(line.check->files == std::vector<std::string>{"a.md"});
  CHECK(line.check->sidecar == "s.rigor");
  CHECK(line.check->format == ReportFormat::json);
  CHECK(line.check->strict);
  CHECK(line.check->color == ColorWhen::always);
  CHECK(line.check->debug == std::vector<DebugTopic>{DebugTopic::time, DebugTopic::steps});
}

TEST_CASE("formats, processes, a cache and marks are read, and what contradicts is refused") {
  const CommandLine line =
      parse({"check", "a.md", "--format", "sarif", "-j", "3", "--cache", "c", "--marks", "m"});
  REQUIRE(line.check);
  CHECK(line.check->format == ReportFormat::sarif);
  CHECK(line.check->jobs == 3);
  CHECK(line.check->cache == "c");
  CHECK(line.check->marks == "m");
  CHECK(usage_error({"check", "a.md", "--json", "--format", "text"}) ==
        "rigor: `--json` is `--format json`, but `--format text` is given");
  CHECK(usage_error({"check", "a.md", "--jobs", "3x"}) ==
        "rigor: `--jobs` is a number from 0 to 1024, not `3x`");
  CHECK(usage_error({"check", "a.md", "b.md", "--marks", "m"}) ==
        "rigor: `--marks` belongs to one file, and 2 are given");
}

TEST_CASE("a sidecar with an empty name is a sidecar") {
  const CommandLine line = parse({"check", "a.md", "--sidecar", ""});
  CHECK((!line.check || line.check->sidecar == ""));
}

TEST_CASE("a replay is of one report") {
  const CommandLine line = parse({"replay", "report.json", "--color", "never"});
  CHECK_FALSE(line.check);
  REQUIRE(line.replay);
  CHECK(line.replay->report == "report.json");
  CHECK(line.replay->color == ColorWhen::never);
  CHECK(usage_error({"replay"}) == "rigor: REPORT is required");
  CHECK(usage_error({"replay", "a.json", "b.json"}) ==
        "rigor: the following argument was not expected: b.json");
  CHECK(usage_error({"rplay", "a.json"}) == "rigor: `rplay` is not a command; did you mean `replay`?");
}

TEST_CASE("forms are of one file, on bodies and at places that may be repeated") {
  const CommandLine line = parse({"eval", "a.md", "--body", "book", "--body", "c.toml", "--at", "(6)",
                                  "--json", "--no-times", "--sidecar", "s.rigor"});
  REQUIRE(line.eval);
  CHECK(line.eval->forms.file == "a.md");
  CHECK(line.eval->forms.bodies == std::vector<std::string>{"book", "c.toml"});
  CHECK(line.eval->forms.places == std::vector<std::string>{"(6)"});
  CHECK(line.eval->forms.sidecar == "s.rigor");
  CHECK(line.eval->json);
  CHECK_FALSE(line.eval->times);
  const CommandLine bench = parse({"bench", "a.md", "--into", "out"});
  REQUIRE(bench.bench);
  CHECK(bench.bench->folder == "out");
  CHECK_FALSE(bench.bench->forms.sidecar);
  CHECK(usage_error({"eval"}) == "rigor: FILE is required");
  CHECK(usage_error({"eval", "a.md", "b.md"}) == "rigor: the following argument was not expected: b.md");
}

TEST_CASE("scenes are read from files") {
  const CommandLine line = parse({"scene", "book.toml", "coin.toml", "--explain"});
  REQUIRE(line.scene);
  CHECK(line.scene->files == std::vector<std::string>{"book.toml", "coin.toml"});
  CHECK(line.scene->explain);
  CHECK_FALSE(line.scene->json);
  CHECK(usage_error({"scence", "a.toml"}) == "rigor: `scence` is not a command; did you mean `scene`?");
}

TEST_CASE("what is wrong with a command line is said in one line") {
  CHECK(usage_error({}) == "rigor: a subcommand is required");
  CHECK(usage_error({"check", "a.md", "--foo"}) == "rigor: the following argument was not expected: --foo");
  CHECK(usage_error({"check", "a.md", "--color", "pink"}) ==
        "rigor: --color: unknown colour setting `pink`; known: auto, always, never");
  CHECK(usage_error({"check", "a.md", "--debug", "all"}) ==
        "rigor: --debug: unknown topic `all`; known: time, steps, work, cache");
  CHECK(usage_error({"check", "a.md", "b.md", "--sidecar", "s.rigor"}) ==
        "rigor: `--sidecar` belongs to one file, and 2 are given");
}

TEST_CASE("help and version are no errors") {
  CHECK(parse({"--version"}).code == ExitCode::ok);
  CHECK(parse({"--version"}).text == "rigor " + std::string(version) + "\nwith " + engine_version() + "\n");
  const CommandLine help = parse({"check", "--help"});
  CHECK(help.code == ExitCode::ok);
  for (const char* part : {"--json", "--sidecar FILE", "--strict", "--color", "--debug", "--format", "--jobs",
                           "--cache", "--marks", "Examples:", "  66  "})
    CHECK(help.text.find(part) != std::string::npos);
}

TEST_CASE("help of a command is what the command itself says") {
  CHECK(parse({"help", "check"}).text == parse({"check", "--help"}).text);
  CHECK(parse({"help"}).text == parse({"--help"}).text);
  CHECK(parse({"help", "help"}).text == parse({"help", "--help"}).text);
  CHECK(usage_error({"help", "chekc"}) == "rigor: COMMAND: `chekc` is not a command; did you mean `check`?");
  CHECK(usage_error({"help", "check", "eval"}) == "rigor: the following argument was not expected: eval");
}

TEST_CASE("cases are of one file, and one case has a name") {
  const CommandLine line = parse({"cases", "a.md", "--into", "r.json", "--name", "n", "--sidecar", "s",
                                  "--strict", "--ctest", "l.cmake"});
  REQUIRE(line.cases);
  CHECK(line.cases->file == "a.md");
  CHECK(line.cases->results == "r.json");
  CHECK(line.cases->name == "n");
  CHECK(line.cases->sidecar == "s");
  CHECK(line.cases->strict);
  CHECK(line.cases->ctest == "l.cmake");
  const CommandLine one = parse({"case", "r.json", "n (1) step 1"});
  REQUIRE(one.one_case);
  CHECK(one.one_case->name == "n (1) step 1");
  CHECK(usage_error({"cases", "a.md"}) == "rigor: --into is required");
  CHECK(usage_error({"case", "r.json"}) == "rigor: NAME is required");
}

}  // namespace
}  // namespace rigor
