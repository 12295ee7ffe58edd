// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/notes_in_folder.h"

#include <filesystem>

#include "app/run_outcome.h"
#include "catch.h"

namespace rigor {
namespace {

std::vector<std::string> files_in(const ScratchFolder& folder) {
  const auto found = notes_in_folder(folder.path());
  REQUIRE(found);
  std::vector<std::string> names;
  for (const std::string& file : found->files)
    names.push_back(std::filesystem::path(file).lexically_relative(folder.path()).generic_string());
  return names;
}

TEST_CASE("notes below a folder come in the order of their paths") {
  const ScratchFolder folder("order");
  folder.write("b/two.md", "$$ a = a $$\n");
  folder.write("b.tex", "\\[ a = a \\]\n");
  folder.write("a/z.md", "$$ a = a $$\n");
  folder.write("a/deep/y.tex", "\\[ a = a \\]\n");
  CHECK(files_in(folder) == std::vector<std::string>{"a/deep/y.tex", "a/z.md", "b/two.md", "b.tex"});
}

TEST_CASE("what is no notes, hidden, built or read by others is counted and not checked") {
  const ScratchFolder folder("passed");
  folder.write("main.tex", "\\input{parts/one}\n\\input{parts/two}\n");
  folder.write("parts/one.tex", "\\[ a = a \\]\n");
  folder.write("parts/two.tex", "Words only.\n");
  folder.write("README.md", "No equation.\n");
  folder.write("data.csv", "1,2\n");
  folder.write(".git/x.md", "$$ a = a $$\n");
  folder.write("_build/x.md", "$$ a = a $$\n");
  folder.write("made/CMakeCache.txt", "");
  folder.write("made/x.md", "$$ a = a $$\n");
  const auto found = notes_in_folder(folder.path());
  REQUIRE(found);
  CHECK(files_in(folder) == std::vector<std::string>{"main.tex"});
  CHECK(found->read_by_others == 2);
  CHECK(found->without_displays == 1);
  CHECK(found->folders == 3);
  CHECK(print_passed_over(*found) ==
        "1 file without displayed equations, 2 files that others read, 3 hidden or build folders");
}

TEST_CASE("files that read each other in a circle are checked once") {
  const ScratchFolder folder("circle");
  folder.write("a.tex", "\\input{b}\n\\[ a = a \\]\n");
  folder.write("b.tex", "\\input{a}\n\\[ b = b \\]\n");
  CHECK(files_in(folder) == std::vector<std::string>{"a.tex"});
}

TEST_CASE("notes whose only display is not closed are notes, and so are those that say something only") {
  const ScratchFolder folder("unclosed");
  folder.write("open.tex", "\\begin{equation} a = a\n\n");
  folder.write("said.md", "<!-- rigor: scalar a -->\n");
  CHECK(files_in(folder) == std::vector<std::string>{"open.tex", "said.md"});
}

TEST_CASE("links lead nowhere") {
  const ScratchFolder folder("links");
  const ScratchFolder other("linked");
  const std::string target = other.write("x.md", "$$ a = a $$\n");
  folder.write("own.md", "$$ a = a $$\n");
  std::filesystem::create_symlink(target, folder.path("x.md"));
  std::filesystem::create_directory_symlink(other.path(), folder.path("all"));
  CHECK(files_in(folder) == std::vector<std::string>{"own.md"});
  CHECK(notes_in_folder(folder.path())->links == 2);
}

TEST_CASE("a folder without notes, and one that is not there, say so") {
  const ScratchFolder folder("none");
  folder.write("README.md", "Nothing.\n");
  const RunOutcome outcome = run_on({"check", folder.path()});
  CHECK(outcome.code == 66);
  CHECK(outcome.err.find("there are no notes (.tex, .md) with displayed equations; passed over: 1 file "
                         "without displayed equations") != std::string::npos);
  CHECK_FALSE(notes_in_folder(folder.path("no-such-folder")));
}

}  // namespace
}  // namespace rigor
