// SPDX-License-Identifier: GPL-3.0-or-later
// `explain` as a whole command.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/command/run.h"
#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "report/wording/explained.h"

namespace rigor {
namespace {

struct Explained {
  int code = 0;
  std::string out;
  std::string err;
};

Explained explain(std::vector<std::string> words) {
  words.insert(words.begin(), {"rigor", "explain"});
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out;
  std::ostringstream err;
  const int code = run(static_cast<int>(pointers.size()), pointers.data(), out, err);
  return {code, out.str(), err.str()};
}

/// A file that is gone at the end.
class NotesFile {
 public:
  explicit NotesFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("rigor-explain-" + std::to_string(::getpid()) + ".md")) {
    std::ofstream(path_) << text;
  }
  ~NotesFile() { std::filesystem::remove(path_); }
  NotesFile(const NotesFile&) = delete;
  NotesFile& operator=(const NotesFile&) = delete;
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The share of chains of which every step that is proved is explained.
double share_of_chains(const std::string& path) {
  SourceMap sources;
  FormsReading reading = read_forms(sources, path, {});
  std::size_t all = 0;
  std::size_t whole = 0;
  for (std::size_t k = 0; k < reading.forms.chains.size(); ++k) {
    if (reading.forms.chains[k].assumed) continue;
    const ExplainedTally counts = tally({explain_chain(reading.forms, k, sources)});
    all += counts.chains;
    whole += counts.whole;
  }
  REQUIRE(all > 10);
  return static_cast<double>(whole) / static_cast<double>(all);
}

}  // namespace

TEST_CASE("a law is shown as one") {
  const NotesFile notes("$$\\ddot x + x = F$$\n");
  const Explained explained = explain({notes.path()});
  CHECK(explained.out.find("stated as a law") != std::string::npos);
  CHECK(explained.out.find("not understood") == std::string::npos);
}

TEST_CASE("a statement on the command line is explained line by line") {
  const Explained text =
      explain({"|\\mathbf A\\times\\mathbf B|^2 = A^2B^2 - (\\mathbf A\\cdot\\mathbf B)^2"});
  CHECK(text.code == 0);
  CHECK(has(text.out, "  |A×B|²\n    = "));
  CHECK(has(text.out, "= A²B² − (A·B)²"));
  CHECK(has(text.out, "explained 1 of 1 step in 1 chain\n"));
}

TEST_CASE("a place is a tag, a label, a heading or a line, and a tag comes before a line") {
  const NotesFile notes(
      "# Sums\n$$a + a = 2a \\tag{5}$$\n$$b + b = 2b \\label{eq:b}$$\n# Squares\n$$c c = c^2$$\n");
  CHECK(has(explain({notes.path(), "--at", "(5)"}).out, "a + a"));
  CHECK(has(explain({notes.path(), "--at", "5"}).out, "a + a"));
  CHECK(has(explain({notes.path(), "--at", "3"}).out, "b + b"));
  CHECK(has(explain({notes.path(), "--at", "eq:b"}).out, "b + b"));
  const Explained section = explain({notes.path(), "--at", "Squares"});
  CHECK(has(section.out, "c²"));
  CHECK(!has(section.out, "b + b"));
  CHECK(has(explain({notes.path(), "--at", "3", "--at", "5"}).out, "2 steps in 2 chains"));
  const Explained unknown = explain({notes.path(), "--at", "Sqares"});
  CHECK(unknown.code == 1);
  CHECK(has(unknown.err, "did you mean `Squares`?"));
  CHECK(unknown.out.empty());
}

TEST_CASE("an order keeps its sign, whether it is given, refuted or not reached") {
  const NotesFile notes(
      "# Orders\n<!-- rigor: scalar a, b\ngiven 0 < a < b\ngiven a b \\neq 7 -->\n"
      "$$a \\le b$$\n$$2a^2 > b^2 \\tag{2}$$\n");
  const Explained text = explain({notes.path(), "--at", "Orders"});
  INFO(text.out);
  CHECK(has(text.out, "  0\n    < a   given\n    < b   given\n"));
  CHECK(has(text.out, "  ab\n    ≠ 7   given\n"));
  CHECK(has(text.out, "  a\n    ≤? b   not reached: "));
  CHECK(has(text.out, "  2a²\n    > b²   refuted\n"));
  CHECK(has(text.out, "0 of them whole (0 %); 1 refuted"));
  CHECK(has(explain({notes.path(), "--format", "latex"}).out, "\\overset{?}{\\le}"));
}

TEST_CASE("what is given is named without the macros of the notes, and letters as they are spelled there") {
  const NotesFile notes(
      "$$\\newcommand{\\E}{\\mathbf{E}}\\newcommand{\\eps}{\\varepsilon_0} 1 = 1$$\n"
      "<!-- rigor: scalar \\eps, \\rho\nvector \\E\ngiven \\eps\\,\\nabla\\cdot\\E = \\rho -->\n"
      "$$\\eps\\,\\nabla\\cdot\\E + \\rho = 2\\rho \\tag{G}$$\n");
  const std::string latex = explain({notes.path(), "--at", "(G)", "--format", "latex"}).out;
  INFO(latex);
  CHECK(has(latex, "\\text{given }"));
  CHECK(has(latex, "\\varepsilon_0"));
  for (const char* lost : {"\\E", "\\eps ", "\\eps\\", "\\epsilon"}) CHECK(!has(latex, lost));
}

TEST_CASE("a refuted step says so and is counted unless it is expected") {
  const NotesFile notes(
      "$$\\mathbf{A}\\times\\mathbf{B} = \\mathbf{B}\\times\\mathbf{A}$$\n<!-- rigor: expect refuted -->\n"
      "$$\\mathbf{A}\\times\\mathbf{C} = \\mathbf{C}\\times\\mathbf{A}$$\n");
  const Explained both = explain({notes.path()});
  CHECK(both.code == 1);
  CHECK(has(both.out, "≠ B×A   refuted\n"));
  CHECK(has(both.out, "≠ C×A   refuted, as expected\n"));
  CHECK(has(both.out, "explained 0 of 1 step in 1 chain; 1 refuted\n"));
  CHECK(explain({notes.path(), "--at", "3"}).code == 0);
}

TEST_CASE("an explanation prints the same bytes twice in each format") {
  for (const char* format : {"text", "latex", "mathml"}) {
    const Explained first = explain({"derivations/vector-identities.tex", "--format", format});
    CHECK(first.out == explain({"derivations/vector-identities.tex", "--format", format}).out);
    CHECK(!first.out.empty());
  }
}

TEST_CASE("at least four in five chains of each file of derivations are explained") {
  for (const auto& entry : std::filesystem::directory_iterator("derivations")) {
    const auto extension = entry.path().extension();
    if (extension != ".md" && extension != ".tex") continue;
    const double share = share_of_chains(entry.path().string());
    INFO(entry.path() << ": " << share);
    CHECK(share >= 0.8);
  }
}

TEST_CASE("explanations as LaTeX compile with amsmath alone") {
  if (std::system("pdflatex --version > /dev/null 2>&1") != 0) {  // NOLINT: no other way to ask
    WARN("skipped: there is no pdflatex");
    return;
  }
  const auto folder =
      std::filesystem::temp_directory_path() / ("rigor-explain-tex-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  for (const char* name : {"vector-identities.tex", "rigid-bodies.md"}) {
    const std::string path = std::string("derivations/") + name;
    std::ofstream(folder / "a.tex")
        << "\\documentclass{article}\n\\usepackage{amsmath}\n\\allowdisplaybreaks\n"
        << "\\begin{document}\n"
        << explain({path, "--format", "latex"}).out << "\\end{document}\n";
    const std::string command =
        "cd '" + folder.string() +
        "' && timeout 100 pdflatex -interaction=nonstopmode -halt-on-error a.tex > a.out 2>&1";
    INFO(name);
    CHECK(std::system(command.c_str()) == 0);  // NOLINT
  }
  std::filesystem::remove_all(folder);
}

}  // namespace rigor
