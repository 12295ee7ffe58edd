// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor check` as a whole: what it reads, and how it ends.
#include <nlohmann/json.hpp>

#include "app/run_outcome.h"
#include "catch.h"

namespace rigor {
namespace {

constexpr const char* wrong = "<!-- rigor: for all a, b -->\n$$ (a+b)^2 = a^2+b^2 $$\n";
constexpr const char* right = "<!-- rigor: for all a, b -->\n$$ (a+b)^2 = a^2+2ab+b^2 $$\n";
constexpr const char* open = "$$ a = \\oint b $$\n";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST_CASE("a folder is checked like its files, and says what it passed over") {
  const ScratchFolder folder("check-folder");
  folder.write("a.md", right);
  folder.write("b.md", wrong);
  folder.write("README.md", "Words.\n");
  const RunOutcome outcome = run_on({"check", folder.path()});
  CHECK(outcome.code == 1);
  CHECK(outcome.out.find(" in 2 files: ") != std::string::npos);
  CHECK(outcome.out.find("passed over in " + folder.path() + ": 1 file without displayed equations\n") !=
        std::string::npos);
  const RunOutcome twice = run_on({"check", folder.path(), folder.path("b.md"), "--json"});
  CHECK(nlohmann::json::parse(twice.out)["files"].size() == 2);
  CHECK(first_line(twice.err) == "passed over in " + folder.path() + ": 1 file without displayed equations");
}

TEST_CASE("the standard input is read as what it looks like, or as its name says") {
  const RunOutcome markdown = run_on({"check", "-"}, std::string("# A\n\n") + wrong);
  CHECK(markdown.code == 1);
  CHECK(markdown.out.find("-:4:12: refuted: ") != std::string::npos);
  const std::string latex = "\\section{A}\n% rigor: for all a, b\n\\[ (a+b)^2 = a^2+b^2 \\]\n";
  CHECK(run_on({"check", "-"}, latex).out.find("-:3:12: refuted: ") != std::string::npos);
  const std::string bare = "\\[ a = a \\]\n\n\\[ b = b % c \\]\n\\]\n";
  CHECK(run_on({"check", "-", "--stdin-name", "x/n.tex"}, bare).out.find("x/n.tex\n") == 0);
  CHECK(run_on({"check", "-", "--stdin-name", "n.tex"}, bare).code == 0);
}

TEST_CASE("the standard input has the sidecar of its name, and none without one") {
  const ScratchFolder folder("stdin-sidecar");
  folder.write("n.rigor", "for all a, b, c\n");
  const std::string notes = "$$ a + b = c $$\n";
  CHECK(run_on({"check", "-"}, notes).code == 0);
  CHECK(run_on({"check", "-", "--stdin-name", folder.path("n.md")}, notes).code == 1);
}

TEST_CASE("--fail-on ends with 1 exactly if something listed was found, else with 0") {
  const auto code = [](const char* list, const std::string& notes) {
    return run_on({"check", "-", "--fail-on", list}, notes).code;
  };
  CHECK(code("refuted", wrong) == 1);
  CHECK(code("suspect,open,error,warning", wrong) == 0);
  CHECK(code("open", open) == 1);
  CHECK(code("not-understood", open) == 1);
  CHECK(code("undecided, refuted", open) == 0);
  CHECK(code("refuted,suspect,open,error,warning", right) == 0);
  CHECK(code("error", std::string(right) + "<!-- rigor: scalar c -->\n") == 1);
  CHECK(code("refuted", std::string("<!-- rigor: expect refuted -->\n") + wrong) == 0);
  CHECK(run_on({"check", "no/such.md", "--fail-on", "refuted"}).code == 66);
}

TEST_CASE("formats for test runners fail what --fail-on lists, and nothing else") {
  const auto failures = [](const char* list) {
    const RunOutcome outcome =
        run_on({"check", "-", "--format", "junit", "--fail-on", list}, std::string(wrong) + open);
    return outcome.out.substr(outcome.out.find("failures="), 12);
  };
  CHECK(failures("refuted") == "failures=\"1\"");
  CHECK(failures("refuted,open") == "failures=\"2\"");
  CHECK(failures("undecided") == "failures=\"0\"");
}

TEST_CASE("a list of what fails is checked word by word") {
  CHECK(first_line(run_on({"check", "-", "--fail-on", "refutd"}).err) ==
        "rigor: --fail-on: `refutd` is not known; did you mean `refuted`?");
  CHECK(run_on({"check", "-", "--fail-on", "refuted,"}).code == 64);
  CHECK(run_on({"check", "-", "--fail-on", "refuted", "--strict"}).code == 64);
}

TEST_CASE("with a baseline only what is new fails, wherever it stands now") {
  const ScratchFolder folder("baseline");
  const std::string notes = folder.write("n.md", std::string(wrong) + open);
  const std::string report = folder.write("old.json", run_on({"check", notes, "--json"}).out);
  folder.write("n.md", std::string("Words.\n\n") + wrong + open);
  const RunOutcome same = run_on({"check", notes, "--baseline", report});
  CHECK(same.code == 0);
  CHECK(same.out.find("[refuted]") == std::string::npos);
  CHECK(same.out.find("passed over since " + report + " has them: 2 verdicts, 2 diagnostics\n") !=
        std::string::npos);
  folder.write("n.md", std::string(wrong) + open + "$$ (a+b)^3 = a^3+b^3 $$\n");
  const RunOutcome fresh = run_on({"check", notes, "--baseline", report});
  CHECK(fresh.code == 1);
  CHECK(fresh.out.find("n.md:4:12: refuted") != std::string::npos);
  CHECK(fresh.out.find("n.md:2:12: refuted") == std::string::npos);
}

TEST_CASE("of two findings that are alike a baseline knows as many as it has") {
  const ScratchFolder folder("baseline-count");
  const std::string notes = folder.write("n.md", wrong);
  const std::string report = folder.write("old.json", run_on({"check", notes, "--json"}).out);
  folder.write("n.md", std::string(wrong) + "$$ (a+b)^2 = a^2+b^2 $$\n");
  CHECK(run_on({"check", notes, "--baseline", report}).code == 1);
}

TEST_CASE("a step that was open and is refuted now is new") {
  const ScratchFolder folder("baseline-worse");
  const std::string notes = folder.write("n.md", "$$ a + b = c $$\n");
  const std::string report = folder.write("old.json", run_on({"check", notes, "--json"}).out);
  folder.write("n.md", "<!-- rigor: for all a, b, c -->\n$$ a + b = c $$\n");
  CHECK(run_on({"check", notes, "--baseline", report}).code == 1);
}

TEST_CASE("a baseline that is no report is no baseline") {
  const ScratchFolder folder("no-baseline");
  const std::string notes = folder.write("n.md", right);
  const std::string report = folder.write("old.json", "{\"files\": [{}]}");
  const RunOutcome outcome = run_on({"check", notes, "--baseline", report});
  CHECK(outcome.code == 66);
  CHECK(outcome.err == "rigor: " + report + ": not a report of `rigor check --json`\n");
  CHECK(run_on({"check", notes, "--baseline", folder.path("none.json")}).code == 66);
}

TEST_CASE("a settings file says which files, which sidecars and what fails") {
  const ScratchFolder folder("settings");
  folder.write("notes/a.md", "$$ (a+b)^2 = a^2+b^2 $$\n");
  folder.write("notes/b.md", open);
  folder.write("shared/all.rigor", "for all a, b\n");
  const std::string settings = folder.write("rigor.toml",
                                            "files = [\"notes\"]\n"
                                            "sidecars = { \"notes/a.md\" = \"shared/all.rigor\" }\n"
                                            "fail-on = [\"refuted\", \"open\"]\n"
                                            "jobs = 2\n"
                                            "effort = 100000\n");
  const RunOutcome outcome = run_on({"check", "--settings", settings, "--json"});
  CHECK(outcome.code == 1);
  const auto report = nlohmann::json::parse(outcome.out);
  CHECK(report["files"].size() == 2);
  CHECK(report["counts"]["refuted"] == 1);
  CHECK(run_on({"check", "--settings", settings, folder.path("notes/b.md"), "--fail-on", "refuted"}).code ==
        0);
  CHECK(run_on({"check", "--settings", settings, folder.path("notes/b.md"), "--no-strict"}).code == 2);
}

TEST_CASE("an unknown key, a wrong value and two rules in a settings file are errors at their places") {
  const ScratchFolder folder("bad-settings");
  const auto complaint = [&](std::string_view text) {
    const std::string path = folder.write("s.toml", text);
    const RunOutcome outcome = run_on({"check", "--settings", path, "-"}, right);
    CHECK(outcome.code == 64);
    CHECK(outcome.out.empty());
    return outcome.err.substr(outcome.err.find("s.toml"));
  };
  const std::string unknown = complaint("file = [\"a.md\"]\n");
  CHECK(first_line(unknown) ==
        "s.toml:1:1: error: the settings file has a key `file`, which is not known [unknown-key]");
  CHECK(unknown.find("did you mean `files`?") != std::string::npos);
  CHECK(complaint("jobs = -1\n").find("`jobs` is a whole number from 0 to 1024") != std::string::npos);
  CHECK(complaint("strict = true\nfail-on = [\"open\"]\n").find("only one of them") != std::string::npos);
  CHECK(complaint("fail-on = [\"opne\"]\n").find("did you mean `open`?") != std::string::npos);
  CHECK(complaint("files = []\n").find("`files` is empty") != std::string::npos);
  CHECK(run_on({"check", "--settings", folder.path("none.toml"), "-"}, right).code == 64);
}

}  // namespace
}  // namespace rigor
