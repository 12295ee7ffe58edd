// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <rigor/rigor.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "catch.h"

namespace rigor {
namespace {

const char* const lagrange = R"(|\mathbf{A}\times\mathbf{B}|^2 = A^2B^2 - (\mathbf{A}\cdot\mathbf{B})^2)";
const char* const slip = R"(|\mathbf{A}\times\mathbf{B}|^2 = A^2B^2 + (\mathbf{A}\cdot\mathbf{B})^2)";

TEST_CASE("a true statement is proved, and nothing is said about it") {
  const CheckedStep checked = step(lagrange);
  CHECK(checked.verdict == StepVerdict::proved);
  CHECK(checked.holds);
  CHECK(checked.message.empty());
  CHECK_FALSE(checked.route.empty());
  CHECK(checked.statement == lagrange);
}

TEST_CASE("a wrong statement has a sample, the nearest true one, and a message with its place") {
  const CheckedStep checked = step(slip);
  CHECK(checked.verdict == StepVerdict::refuted);
  CHECK_FALSE(checked.holds);
  CHECK(checked.sample == R"(\mathbf{A} = (1, 0, 0), \mathbf{B} = (1, 0, 0); left 0, right 2)");
  REQUIRE_FALSE(checked.repairs.empty());
  CHECK(checked.repairs.front() == lagrange);
  CHECK(checked.line == 1);
  CHECK(checked.message.starts_with("<statement>.tex:1:"));
  CHECK(checked.message.find("true is: ") != std::string::npos);
}

TEST_CASE("a chain is as bad as its worst step") {
  CHECK(step("1 + 1 = 2 = 3 - 1").verdict == StepVerdict::proved);
  const CheckedStep wrong = step("1 + 1 = 2 = 3");
  CHECK(wrong.verdict == StepVerdict::refuted);
  CHECK(wrong.statement == "2 = 3");
}

TEST_CASE("a context declares, defines and assumes") {
  const char* const statement = R"(\frac{d}{dt}\left(\tfrac12 m\dot{x}^2 + \tfrac12 kx^2\right) = 0)";
  CHECK(step(statement).verdict == StepVerdict::law);
  const CheckedStep checked = step(statement,
                                   "% rigor: scalar x, m, k\n% rigor: constant m, k\n"
                                   "% rigor: given m\\ddot{x} = -kx\n");
  CHECK(checked.verdict == StepVerdict::proved);
  CHECK(checked.holds);
  CHECK_FALSE(checked.uses.empty());
  CHECK(step("\\v{A}\\times\\v{A} = 0", "\\newcommand{\\v}[1]{\\mathbf{#1}}").holds);
}

TEST_CASE("what is wrong with the context is part of the answer") {
  const CheckedStep unused = step("1 = 1", "% rigor: vector \\mathbf{Q}");
  CHECK(unused.verdict == StepVerdict::proved);
  CHECK_FALSE(unused.holds);
  CHECK(unused.message.find("[unused-directive]") != std::string::npos);
  const CheckedStep false_context = step("1 = 1", "\\[ 1 = 2 \\]");
  CHECK_FALSE(false_context.holds);
  CHECK(false_context.message.find("[refuted]") != std::string::npos);
}

TEST_CASE("what is no statement is not understood, and says so") {
  for (const char* text : {"", "x", "\\frac{", "\\oint f(s)\\,ds = 0", "\\] \\[", "\xff = \xfe"}) {
    INFO(text);
    const CheckedStep checked = step(text);
    CHECK_FALSE(checked.holds);
    CHECK(checked.verdict == StepVerdict::not_understood);
    CHECK_FALSE(checked.message.empty());
  }
}

TEST_CASE("notes are steps in their order, and a file that is missing is not readable") {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("rigor_api_{}.md", getpid());
  std::ofstream(path) << "$$1 = 1 \\tag{1}$$\n\n$$2 = 3 \\tag{2}$$\n";
  const CheckedNotes checked = notes(path.string());
  std::filesystem::remove(path);
  CHECK(checked.readable);
  CHECK_FALSE(checked.all_hold);
  REQUIRE(checked.steps.size() == 2);
  CHECK(checked.steps[0].holds);
  CHECK(checked.steps[1].tag == "(2)");
  CHECK(checked.steps[1].line == 3);
  CHECK(checked.steps[1].column == 3);
  CHECK(checked.message.starts_with(path.string() + ":3:5: refuted: "));

  const CheckedNotes missing = notes("/nowhere/at/all.tex");
  CHECK_FALSE(missing.readable);
  CHECK_FALSE(missing.all_hold);
  CHECK(missing.message.find("no such file") != std::string::npos);
}

TEST_CASE("warnings are failures if asked for, and a sidecar is read") {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string path = (folder / fmt::format("rigor_api_{}_w.md", getpid())).string();
  const std::string sidecar = (folder / fmt::format("rigor_api_{}_s.txt", getpid())).string();
  std::ofstream(path) << "$$q = 3$$\n\n$$1 = 1$$\n";
  std::ofstream(sidecar) << "warn unused-definition\n";
  CHECK(notes(path).all_hold);
  CHECK(notes(path, {sidecar, false}).all_hold);
  CHECK_FALSE(notes(path, {sidecar, true}).all_hold);
  CHECK_FALSE(notes(path, {"/nowhere/physics.rigor", false}).readable);
  std::filesystem::remove(path);
  std::filesystem::remove(sidecar);
}

TEST_CASE("a checked step is printed with its verdict and its message") {
  std::ostringstream text;
  text << step("1 = 2");
  CHECK(text.str().starts_with("1 = 2\nrefuted"));
  CHECK(text.str().find("<statement>.tex:1:") != std::string::npos);
}

TEST_CASE("calls from several threads wait for each other") {
  std::vector<std::thread> threads;
  std::vector<int> proved(4, 0);
  for (std::size_t i = 0; i < proved.size(); ++i)
    threads.emplace_back([&, i] { proved[i] = step(lagrange).holds ? 1 : 0; });
  for (std::thread& thread : threads) thread.join();
  CHECK(proved == std::vector<int>(4, 1));
}

}  // namespace
}  // namespace rigor
