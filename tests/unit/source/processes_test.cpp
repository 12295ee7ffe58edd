// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/processes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "app/host/program_identity.h"
#include "catch.h"

namespace rigor {
namespace {

using Answers = std::vector<Result<std::string>>;

Answers answers(std::size_t count, std::size_t most_at_once,
                const std::function<std::string(std::size_t)>& work) {
  return in_processes({count, [&](std::size_t piece, const ReportProgress&) { return work(piece); }, {}},
                      most_at_once);
}

TEST_CASE("answers have the order of the pieces, however many are at work") {
  for (const std::size_t most : {0, 1, 2, 3, 20}) {
    const Answers found = answers(7, most, [](std::size_t piece) {
      if (piece == 0) ::usleep(20'000);
      return std::string(piece * 100'000, 'x') + std::to_string(piece);
    });
    REQUIRE(found.size() == 7);
    for (std::size_t piece = 0; piece < 7; ++piece)
      CHECK((found[piece].value() == std::string(piece * 100'000, 'x') + std::to_string(piece)));
  }
  CHECK(answers(0, 2, [](std::size_t) { return ""; }).empty());
}

TEST_CASE("what a process that is killed did not answer is done here") {
  const pid_t here = ::getpid();
  const Pieces pieces{5,
                      [&](std::size_t piece, const ReportProgress&) {
                        if (piece % 2 == 0 && ::getpid() != here) ::raise(SIGKILL);
                        if (piece == 1 && ::getpid() != here) throw std::runtime_error("no memory");
                        return std::to_string(piece);
                      },
                      {}};
  for (const std::size_t most : {0, 1, 2, 8})
    CHECK((in_processes_or_here(pieces, most) == std::vector<std::string>{"0", "1", "2", "3", "4"}));
}

TEST_CASE("a piece that crashes is an error of its own and no other's") {
  const Answers found = answers(5, 2, [](std::size_t piece) -> std::string {
    if (piece == 0) {
      std::signal(SIGSEGV, SIG_DFL);  // not that of the test program
      std::raise(SIGSEGV);
    }
    if (piece == 2) std::raise(SIGKILL);
    if (piece == 3) throw std::runtime_error("wrong");
    if (piece == 4) ::_exit(3);
    return "well";
  });
  CHECK(found[0].error().reason.starts_with("its process"));
  CHECK(found[1].value() == "well");
  CHECK(found[2].error().reason.starts_with("its process was ended by signal 9"));
  CHECK(found[3].error().reason == "wrong");
  CHECK(found[4].error().reason == "its process ended with code 3 and no answer");
}

TEST_CASE("progress of every piece is heard here") {
  std::vector<std::size_t> last(3, 0);
  const Pieces pieces{3,
                      [](std::size_t, const ReportProgress& progress) {
                        for (std::size_t done = 1; done <= 4; ++done) progress(done, 4);
                        return std::string();
                      },
                      [&](std::size_t piece, std::size_t done, std::size_t) { last[piece] = done; }};
  CHECK(in_processes(pieces, 2).size() == 3);
  CHECK(last == std::vector<std::size_t>{4, 4, 4});
}

TEST_CASE("there is a processor, and the program has one identity") {
  CHECK(processor_count() >= 1);
  CHECK(program_identity() == program_identity());
  CHECK(program_identity().starts_with("rigor "));
}

}  // namespace
}  // namespace rigor
