// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"

namespace rigor {
namespace {

/// Files of one test; gone with it.
class CasesFolder {
 public:
  CasesFolder() {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~CasesFolder() { std::filesystem::remove_all(path_); }
  CasesFolder(const CasesFolder&) = delete;
  CasesFolder& operator=(const CasesFolder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

 private:
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / fmt::format("rigor_cases_{}", getpid());
};

const std::string vectors =
    "$$\\mathbf{A}\\times\\mathbf{B} = -\\mathbf{B}\\times\\mathbf{A} \\tag{1}$$\n\n"
    "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A} \\tag{2}$$\n";

TEST_CASE("one check writes what became of each step, and each is told by its name") {
  const CasesFolder folder;
  folder.write("v.md", vectors);
  const CasesCommand command{.file = folder / "v.md", .results = folder / "v.json", .name = "v"};
  std::ostringstream out;
  std::ostringstream err;
  CHECK(write_cases(command, out, err) == ExitCode::ok);
  CHECK(err.str().empty());
  CHECK(out.str() == (folder / "v.md") + ": 3 cases: 2 passed, 1 failed, 0 open\n");

  std::ostringstream told;
  CHECK(tell_case({folder / "v.json", "v (1) step 1"}, told, err) == ExitCode::ok);
  CHECK(tell_case({folder / "v.json", "v (2) step 1"}, told, err) == ExitCode::wrong);
  CHECK(told.str().find((folder / "v.md") + ":3:30: refuted: the sides differ") != std::string::npos);
  CHECK(told.str().find("sample: \\mathbf{A} = (1, 0, 0)") != std::string::npos);
  CHECK(tell_case({folder / "v.json", "v (whole file)"}, told, err) == ExitCode::ok);
  CHECK(err.str().empty());
}

TEST_CASE("a case that is no more, and results that are none, are said so") {
  const CasesFolder folder;
  folder.write("v.md", vectors);
  std::ostringstream out;
  std::ostringstream err;
  CHECK(write_cases({.file = folder / "v.md", .results = folder / "v.json"}, out, err) == ExitCode::ok);
  CHECK(tell_case({folder / "v.json", "v (3) step 1"}, out, err) == ExitCode::wrong);
  CHECK(err.str().find("there is no case `v (3) step 1` any more") != std::string::npos);
  CHECK(tell_case({folder / "missing.json", "x"}, out, err) == ExitCode::no_input);
  CHECK(tell_case({folder / "v.md", "x"}, out, err) == ExitCode::wrong);
  CHECK(err.str().find("not what `rigor cases` writes") != std::string::npos);
}

TEST_CASE("results never take the place of the notes") {
  const CasesFolder folder;
  folder.write("v.md", vectors);
  std::ostringstream out;
  std::ostringstream err;
  CHECK(write_cases({.file = folder / "v.md", .results = folder / "./v.md"}, out, err) == ExitCode::usage);
  CHECK(write_cases({.file = folder / "v.md", .results = folder / "v.json", .ctest = folder / "v.md"}, out,
                    err) == ExitCode::usage);
  CHECK(err.str().find("which is read") != std::string::npos);
  CHECK(write_cases({.file = folder / "v.md", .results = folder / "v.json"}, out, err) == ExitCode::ok);
}

TEST_CASE("notes that are not there and results that cannot be written leave nothing behind") {
  const CasesFolder folder;
  folder.write("v.md", vectors);
  std::ostringstream out;
  std::ostringstream err;
  CHECK(write_cases({.file = folder / "w.md", .results = folder / "w.json"}, out, err) == ExitCode::no_input);
  CHECK_FALSE(std::filesystem::exists(folder / "w.json"));
  CHECK(write_cases({.file = folder / "v.md", .results = folder / "no/v.json"}, out, err) ==
        ExitCode::no_input);
  CHECK(err.str().find("no/v.json: cannot be written") != std::string::npos);
  CHECK(out.str().empty());
}

}  // namespace
}  // namespace rigor
