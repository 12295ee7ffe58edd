// SPDX-License-Identifier: GPL-3.0-or-later
// `rigor suggest` as a whole command.
#include <filesystem>

#include "catch.h"
#include "report/suggest/candidates.h"
#include "run_outcome.h"
#include "source/read_file.h"

namespace rigor {
namespace {

constexpr const char* rate =
    "# A rate\n\nThe mass of the cart varies.\n\n$$P = MV$$\n\n$$\\dot P = M\\dot V$$\n";
constexpr const char* both_orders = "# Both orders\n\n$$ab = -ba$$\n\n$$aba = a^2b$$\n";

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string content_of(const std::string& path) { return read_file(path).value_or("not there"); }

}  // namespace

TEST_CASE("a directive that settles a row is shown, and nothing is written") {
  const ScratchFolder folder("suggest-show");
  const std::string notes = folder.write("notes.md", rate);
  const RunOutcome outcome = run_on({"suggest", notes});
  CHECK(outcome.code == 0);
  CHECK(says(outcome.out, "at section \"A rate\": rigor: constant M"));
  CHECK(says(outcome.out, "not understood -> proved"));
  CHECK_FALSE(std::filesystem::exists(folder.path("notes.rigor")));
}

TEST_CASE("a root that fails for a negative letter asks for its sign, not for all its values") {
  const ScratchFolder folder("suggest-sign");
  const std::string notes = folder.write("notes.md",
                                         "# An orbit\n\n$$v = \\sqrt{\\frac{GM}{r}}$$\n\n"
                                         "$$T = \\frac{2\\pi r}{v} = 2\\pi\\sqrt{\\frac{r^3}{GM}}$$\n");
  const RunOutcome outcome = run_on({"suggest", notes});
  CHECK(says(outcome.out, "at section \"An orbit\": rigor: given r > 0"));
  CHECK(says(outcome.out, "undecided -> proved"));
  CHECK_FALSE(says(outcome.out, "for all"));
}

TEST_CASE("what is accepted is written below its heading, and a second run adds nothing") {
  const ScratchFolder folder("suggest-write");
  const std::string notes = folder.write("notes.md", rate);
  CHECK(run_on({"suggest", notes, "--write"}).code == 0);
  const std::string once = content_of(folder.path("notes.rigor"));
  CHECK(once == "# found by `rigor suggest`\nat section \"A rate\"\nconstant M\n");
  CHECK(run_on({"check", notes}).code == 0);
  const RunOutcome again = run_on({"suggest", notes, "--write"});
  CHECK(says(again.out, "no line is known that settles any"));
  CHECK(content_of(folder.path("notes.rigor")) == once);
}

TEST_CASE("lines are added at the end of a sidecar that is there") {
  const ScratchFolder folder("suggest-append");
  const std::string notes = folder.write("notes.md", rate);
  const std::string shared = folder.write("shared.rigor", "allow idle-sum");
  CHECK(run_on({"suggest", notes, "--write", shared}).code == 0);
  CHECK(says(content_of(shared), "allow idle-sum\n\n# found by `rigor suggest`\nat section \"A rate\"\n"));
  CHECK_FALSE(std::filesystem::exists(folder.path("notes.rigor")));
}

TEST_CASE("a directive that makes a row refuted is shown and written only with --all") {
  const ScratchFolder folder("suggest-worse");
  const std::string notes = folder.write("notes.md", both_orders);
  const RunOutcome held = run_on({"suggest", notes, "--write"});
  CHECK(says(held.out, "and is held back"));
  CHECK(says(held.out, "not understood -> refuted  ab = -ba"));
  CHECK_FALSE(std::filesystem::exists(folder.path("notes.rigor")));
  CHECK(run_on({"suggest", notes, "--write", "--all"}).code == 0);
  CHECK(says(content_of(folder.path("notes.rigor")), "scalar a\n"));
  CHECK(run_on({"check", notes}).code == 1);
}

TEST_CASE("the notes are no sidecar") {
  const ScratchFolder folder("suggest-notes");
  const std::string notes = folder.write("notes.md", rate);
  CHECK(run_on({"suggest", notes, "--write", notes}).code == 64);
  CHECK(content_of(notes) == rate);
}

TEST_CASE("the same notes get the same suggestions, byte for byte") {
  const ScratchFolder folder("suggest-again");
  const std::string notes = folder.write("notes.md", std::string(rate) + "\n" + both_orders);
  CHECK(run_on({"suggest", notes}).out == run_on({"suggest", notes}).out);
}

TEST_CASE("a sidecar names each place once") {
  CHECK(
      sidecar_lines({{"at start", "scalar a"}, {"at section \"B\"", "scalar b"}, {"at start", "scalar c"}}) ==
      "at start\nscalar a\nscalar c\nat section \"B\"\nscalar b\n");
}

}  // namespace rigor
