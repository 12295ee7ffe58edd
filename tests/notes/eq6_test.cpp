// SPDX-License-Identifier: GPL-3.0-or-later
// The square of a cross product, Eq. (6) of the notes, edited in one place at a time: alone on a page without
// any directive, and inside derivations/rigid-bodies.md.
#include <algorithm>

#include "catch.h"
#include "check/entry/check.h"
#include "program.h"

namespace rigor {
namespace {

using enum Verdict;

const std::string chain = R"(\begin{aligned}
  |\mathbf{A}\times\mathbf{B}|^2
    &= (\varepsilon_{ijk} A_j B_k)(\varepsilon_{ilm} A_l B_m) \\
    &= (\delta_{jl}\delta_{km} - \delta_{jm}\delta_{kl})\,A_j B_k A_l B_m \\
    &= A_i A_i B_j B_j - A_i B_i A_j B_j \\
    &= A^2 B^2 - (\mathbf{A}\cdot\mathbf{B})^2
\end{aligned})";

struct Edit {
  std::string name;
  std::string from;
  std::string to;
  std::vector<Verdict> verdicts;
};

const std::vector<Edit> edits{
    {"nothing edited", "", "", {proved, proved, proved, proved}},
    {"a sign between two products of deltas",
     R"(\delta_{km} - \delta_{jm})",
     R"(\delta_{km} + \delta_{jm})",
     {proved, refuted, refuted, proved}},
    {"a sign in the last line", R"(B^2 - ()", R"(B^2 + ()", {proved, proved, proved, refuted}},
    {"two indices of epsilon swapped",
     R"(\varepsilon_{ilm})",
     R"(\varepsilon_{iml})",
     {refuted, refuted, proved, proved}},
    {"two indices of the deltas swapped",
     R"((\delta_{jl}\delta_{km})",
     R"((\delta_{jk}\delta_{lm})",
     {proved, refuted, refuted, proved}},
    {"two indices of the last term swapped, which changes nothing",
     "B_i A_j B_j",
     "B_j A_j B_i",
     {proved, proved, proved, proved}},
    {"a power lost", "A^2 B^2", "A^2 B", {proved, proved, proved, refuted}},
    {"the cross product reversed, which the square does not see",
     R"(|\mathbf{A}\times\mathbf{B}|)",
     R"(|\mathbf{B}\times\mathbf{A}|)",
     {proved, proved, proved, proved}},
    {"a free index left over",
     "B_i A_j B_j",
     "B_i A_j B_k",
     {proved, proved, not_understood, not_understood}},
};

/// The text with the edit made where it first fits behind `begin`.
std::string edited(std::string text, const Edit& edit, std::size_t begin) {
  const std::size_t at = text.find(edit.from, begin);
  REQUIRE(at != std::string::npos);
  return text.replace(at, edit.from.size(), edit.to);
}

/// Where the relation of each step stands, found in the text alone.
std::vector<LineColumn> relations_behind(const std::string& text, std::size_t begin, std::size_t count) {
  std::vector<LineColumn> places;
  for (std::size_t at = begin; places.size() < count; ++at) {
    at = text.find("&=", at);
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::size_t line_start = text.rfind('\n', at) + 1;
    places.push_back({static_cast<std::uint32_t>(line) + 1, static_cast<std::uint32_t>(at - line_start) + 2});
  }
  return places;
}

bool has_kind(const Step& step, DiagnosticKind kind) {
  return std::ranges::any_of(step.diagnostics, [&](const Diagnostic& one) { return one.kind == kind; });
}

/// Both vectors are in it, and the sides differ.
void check_sample(const Step& step) {
  REQUIRE(step.counterexample.has_value());
  std::vector<std::string> symbols;
  for (const Counterexample::Value& value : step.counterexample->values) {
    symbols.push_back(value.symbol);
    CHECK(value.components.size() == 3);
  }
  CHECK(symbols == std::vector<std::string>{"\\mathbf{A}", "\\mathbf{B}"});
  CHECK(step.counterexample->left != step.counterexample->right);
}

/// A free index is left over in the third row, whichever step reads it.
void check_step(const Step& step, Verdict verdict, LineColumn relation, std::uint32_t third_row,
                const SourceMap& sources) {
  INFO(step.source);
  CHECK(name_of(step.verdict) == name_of(verdict));
  CHECK(sources.line_column(step.relation_span.file, step.relation_span.begin) == relation);
  CHECK(has_kind(step, DiagnosticKind::refuted) == (verdict == refuted));
  CHECK(has_kind(step, DiagnosticKind::free_index_mismatch) == (verdict == not_understood));
  for (const Diagnostic& diagnostic : step.diagnostics) {
    const LineColumn place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
    if (diagnostic.kind == DiagnosticKind::refuted) CHECK(place == relation);
    if (diagnostic.kind == DiagnosticKind::free_index_mismatch) CHECK(place.line == third_row);
  }
  if (verdict == refuted)
    check_sample(step);
  else
    CHECK_FALSE(step.counterexample.has_value());
}

/// Checks the four steps that stand at `begin` and behind.
void check_chain(const FileReport& report, const Edit& edit, const std::string& text, std::size_t begin,
                 const SourceMap& sources) {
  const auto first =
      std::ranges::find_if(report.steps, [&](const Step& step) { return step.span.begin >= begin; });
  REQUIRE(report.steps.end() - first >= 4);
  const auto relations = relations_behind(text, begin, 4);
  for (std::size_t i = 0; i < 4; ++i)
    check_step(*(first + static_cast<std::ptrdiff_t>(i)), edit.verdicts[i], relations[i], relations[2].line,
               sources);
}

bool all_proved(const Edit& edit) {
  return std::ranges::all_of(edit.verdicts, [](Verdict verdict) { return verdict == proved; });
}

TEST_CASE("an edit of the chain is answered at its relation sign, on a page without a directive") {
  for (const Edit& edit : edits) {
    DYNAMIC_SECTION(edit.name) {
      const std::string text = edited("# A square\n\n$$" + chain + "$$\n", edit, 0);
      SourceMap sources;
      const FileReport report = check_text(sources, "square.md", text);
      REQUIRE(report.steps.size() == 4);
      check_chain(report, edit, text, 0, sources);
      CHECK(exit_code_of(report) == (all_proved(edit) ? 0 : 1));
    }
  }
}

TEST_CASE("an edit of the chain inside the derivation is answered there and nowhere else") {
  const std::string path = "../../derivations/rigid-bodies.md";
  const std::string original = text_of(path);
  const std::size_t begin = original.find(chain);
  REQUIRE(begin != std::string::npos);
  SourceMap original_sources;
  const FileReport before = check_text(original_sources, path, original);
  for (const Edit& edit : edits) {
    DYNAMIC_SECTION(edit.name) {
      const std::string text = edited(original, edit, begin);
      SourceMap sources;
      const FileReport report = check_text(sources, path, text);
      check_chain(report, edit, text, begin, sources);
      REQUIRE(report.steps.size() == before.steps.size());
      for (std::size_t i = 0; i < report.steps.size(); ++i) {
        INFO(report.steps[i].source);
        if (report.steps[i].tag != "(6)") CHECK(report.steps[i].verdict == before.steps[i].verdict);
      }
    }
  }
}

}  // namespace
}  // namespace rigor
