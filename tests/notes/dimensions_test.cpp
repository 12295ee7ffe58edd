// SPDX-License-Identifier: GPL-3.0-or-later
// With the dimensions of a mass, a position and the time declared, those of all other quantities of the
// rigid-body notes are found. Then every position, its rate, every mass and angular velocity in their
// displays is left out in its turn, in its place what has no dimension and the same number of axes. Each time
// a dimension must be reported. What is true gets no such report.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>

#include "catch.h"
#include "check/entry/check.h"
#include "program.h"

namespace rigor {
namespace {

struct Drop {
  std::regex factor;
  std::string instead;
};

const std::vector<Drop>& drops() {
  static const std::vector<Drop> all{
      {std::regex(R"(\\dot\{\\mathbf\{r\}\}'?_\\alpha)"), R"(\hat{\mathbf{q}})"},
      {std::regex(R"(\\mathbf\{r\}'?_\\alpha)"), R"(\hat{\mathbf{q}})"},
      {std::regex(R"(\br_\\alpha\^2)"), R"(r_\alpha)"},
      {std::regex(R"(\br_\{\\alpha ?([^}^]+)\}\^2)"), R"(r_{\alpha $1})"},
      {std::regex(R"(\br_\{\\alpha ?([1-3])\}(?!\^))"), R"(1\,)"},
      {std::regex(R"(\br_\{\\alpha ?([^}1-3]+)\}(?!\^))"), R"(\hat{q}_{$1})"},
      {std::regex(R"(\bm_\\alpha)"), R"(1\,)"},
      {std::regex(R"(\\boldsymbol\{\\omega\}(?!_))"), R"(\hat{\mathbf{q}})"}};
  return all;
}

/// A letter below a derivative stays: what is differentiated is no factor.
bool is_factor(const std::string& text, std::size_t at) {
  const std::string before = text.substr(at < 6 ? 0 : at - 6, std::min<std::size_t>(at, 6));
  return !before.ends_with("\\dot{") && !before.ends_with("ddot{") && !before.ends_with("{d");
}

struct Mutant {
  std::string text;
  std::string name;
};

/// Every factor in a display, each left out alone.
std::vector<Mutant> mutants_of(const std::string& notes) {
  std::vector<Mutant> mutants;
  for (const Drop& drop : drops()) {
    for (std::sregex_iterator match(notes.begin(), notes.end(), drop.factor), end; match != end; ++match) {
      const auto at = static_cast<std::size_t>(match->position());
      std::size_t dollars = 0;
      for (auto found = notes.find("$$"); found < at; found = notes.find("$$", found + 2)) ++dollars;
      if (dollars % 2 == 0 || !is_factor(notes, at)) continue;
      const auto line = std::count(notes.begin(), notes.begin() + match->position(), '\n') + 1;
      mutants.push_back({notes.substr(0, at) + match->format(drop.instead) +
                             notes.substr(at + static_cast<std::size_t>(match->length())),
                         fmt::format("line {}: {}", line, match->str())});
    }
  }
  return mutants;
}

bool is_about_dimensions(const Diagnostic& diagnostic) {
  return diagnostic.kind == DiagnosticKind::dimension_mismatch ||
         diagnostic.kind == DiagnosticKind::dimension_clash ||
         diagnostic.kind == DiagnosticKind::dimension_doubt;
}

bool reports_dimensions(const FileReport& report) {
  const auto any = [](const Diagnostics& all) {
    return std::any_of(all.begin(), all.end(), is_about_dimensions);
  };
  return any(report.diagnostics) || std::any_of(report.steps.begin(), report.steps.end(),
                                                [&](const Step& step) { return any(step.diagnostics); });
}

FileReport check(const std::string& path, const std::string& text, const CheckOptions& options) {
  SourceMap sources;
  return check_text(sources, path, text, options);
}

/// What the report found of these symbols, as far as it is something else.
std::string differences(const FileReport& report, const std::map<std::string, std::string>& expected) {
  std::string text;
  for (const auto& [symbol, dimension] : expected) {
    const auto entry = std::find_if(report.dimensions.begin(), report.dimensions.end(),
                                    [&](const SymbolDimension& each) { return each.symbol == symbol; });
    const std::string found =
        entry == report.dimensions.end() ? "not there" : entry->dimension.value_or("free");
    if (found != dimension) text += fmt::format("{}: {}, not {}\n", symbol, found, dimension);
  }
  return text;
}

const std::map<std::string, std::string> of_rigid_bodies{{"t", "T"},
                                                         {"m_\\alpha", "M"},
                                                         {"M", "M"},
                                                         {"\\mathbf{r}_\\alpha", "L"},
                                                         {"\\mathbf{r}'_\\alpha", "L"},
                                                         {"\\mathbf{R}", "L"},
                                                         {"\\mathbf{V}", "L T^{-1}"},
                                                         {"\\mathbf{v}_\\alpha", "L T^{-1}"},
                                                         {"\\boldsymbol{\\omega}", "T^{-1}"},
                                                         {"\\mathbf{F}_\\alpha", "M L T^{-2}"},
                                                         {"\\mathbf{f}_\\alpha", "M L T^{-2}"},
                                                         {"T_{\\text{trans}}", "M L^2 T^{-2}"},
                                                         {"T_{\\text{rot}}", "M L^2 T^{-2}"},
                                                         {"I_{ij}", "M L^2"},
                                                         {"\\mathbf{L}", "M L^2 T^{-1}"},
                                                         {"\\Omega_{1}", "T^{-1}"},
                                                         {"\\Omega_{2}", "T^{-1}"}};

void every_drop_is_found(const std::string& path, const CheckOptions& options, std::size_t at_least) {
  const std::string notes = text_of(path);
  const FileReport report = check(path, notes, options);
  CHECK_FALSE(reports_dimensions(report));
  CHECK(differences(report, of_rigid_bodies) == "");
  const std::vector<Mutant> mutants = mutants_of(notes);
  CHECK(mutants.size() >= at_least);
  for (const Mutant& mutant : mutants) {
    INFO(mutant.name);
    CHECK(reports_dimensions(check(path, mutant.text, options)));
  }
}

TEST_CASE("what is true has no diagnostic about dimensions") {
  std::vector<std::string> paths = notes_in("pass");
  for (const std::string& path : notes_in("../../derivations")) paths.push_back(path);
  if (std::filesystem::exists(RIGOR_ORIGINAL_NOTES)) {
    for (const std::string& path : notes_in(RIGOR_ORIGINAL_NOTES)) paths.push_back(path);
  }
  CHECK(paths.size() > 40);
  for (const std::string& path : paths) {
    INFO(path);
    CHECK_FALSE(reports_dimensions(check(path, text_of(path), {})));
  }
}

TEST_CASE("a position, a mass or an angular velocity that is left out is found by its dimension", "[long]") {
  every_drop_is_found("../../derivations/rigid-bodies.md", {}, 60);
}

TEST_CASE("so it is in the notes as they were written", "[original]") {
  const std::string notes = std::string(RIGOR_ORIGINAL_NOTES) + "/rigid-bodies.md";
  if (!std::filesystem::exists(notes)) {
    WARN("skipped: " << notes << " is not here");
    return;
  }
  every_drop_is_found(notes, {.sidecar = "../../derivations/physics-111.rigor", .progress = {}}, 20);
}

}  // namespace
}  // namespace rigor
