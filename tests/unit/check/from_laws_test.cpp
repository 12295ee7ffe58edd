// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the laws of a page, and what must not.
#include <algorithm>

#include "base/ascii.h"
#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

std::string display(const std::string& statement) { return "$$" + statement + "$$\n\n"; }

const Step& last_step(const Checked& checked) { return checked.report.steps.back(); }

std::string last_verdict(const std::string& text) {
  return std::string(name_of(last_step(Checked(text)).verdict));
}

/// Laws of a page, and a row that follows from them.
struct Page {
  std::string laws;
  std::string row;
};

std::vector<Page> pages() {
  const std::string oscillator =
      display("m\\ddot x = -kx") + display("E = \\tfrac12m\\dot x^2 + \\tfrac12kx^2");
  const std::string maxwell =
      "<!-- rigor: constant \\mu, \\epsilon -->\n\n" +
      display("\\nabla\\times\\mathbf E = -\\partial_t\\mathbf B") +
      display("\\nabla\\times\\mathbf B = \\mu\\mathbf J + \\mu\\epsilon\\,\\partial_t\\mathbf E") +
      display("\\mathbf S = \\frac1\\mu\\mathbf E\\times\\mathbf B") +
      display("u = \\frac\\epsilon2E^2 + \\frac1{2\\mu}B^2");
  return {
      {oscillator, "\\ddot x + \\frac{k}{m}x = 0"},
      {oscillator, "x\\ddot x + \\frac{k}{m}x^2 = 0"},
      {display("p = \\rho g h") + display("F = pA"), "\\frac{F}{A} = \\rho g h"},
      {display("c_1 + c_2 = y_0") + display("r_1c_1 + r_2c_2 = v_0"), "(r_1 - r_2)c_1 = v_0 - r_2y_0"},
      {maxwell, "\\partial_tu + \\nabla\\cdot\\mathbf S = -\\mathbf J\\cdot\\mathbf E"},
      {display("\\dot{\\mathbf L} = \\mathbf r\\times\\mathbf F") +
           display("\\mathbf F = f\\mathbf r + \\mathbf G"),
       "\\dot{\\mathbf L} = \\mathbf r\\times\\mathbf G"},
  };
}

/// The row with one sign turned, or a 3 in front of one letter.
std::vector<std::string> twins_of(const std::string& row) {
  std::vector<std::string> twins;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] == '+' || row[k] == '-') {
      twins.push_back(row);
      twins.back()[k] = row[k] == '+' ? '-' : '+';
    }
    const bool starts = k == 0 || (!is_letter(row[k - 1]) && row[k - 1] != '\\' && row[k - 1] != '_');
    const std::string_view rest = std::string_view(row).substr(k);
    const bool operates =
        rest.starts_with("\\nabla") || rest.starts_with("\\cdot") || rest.starts_with("\\times");
    if (starts && (is_letter(row[k]) || row[k] == '\\') && !operates)
      twins.push_back(row.substr(0, k) + "3" + row.substr(k));
  }
  return twins;
}

}  // namespace

TEST_CASE("a row that follows from laws of the page is proved, and names them") {
  for (const Page& page : pages()) {
    const Checked checked(page.laws + display(page.row));
    CAPTURE(page.row, checked.lines());
    CHECK(last_step(checked).verdict == Verdict::proved);
    const std::vector<std::string>& uses = last_step(checked).uses;
    CHECK(std::any_of(uses.begin(), uses.end(), [](const std::string& use) {
      return use.rfind("law in line ", 0) == 0 || use.rfind("definition", 0) == 0;
    }));
  }
}

TEST_CASE("no twin of a row that follows from laws is proved") {
  for (const Page& page : pages()) {
    std::size_t read = 0;
    for (const std::string& twin : twins_of(page.row)) {
      const Checked checked(page.laws + display(twin));
      CAPTURE(twin, checked.lines());
      CHECK(last_step(checked).verdict != Verdict::proved);
      if (last_step(checked).verdict != Verdict::not_understood) ++read;
    }
    CAPTURE(page.row);
    CHECK(read >= 3);
  }
}

TEST_CASE("laws that leave only zeros prove nothing") {
  const std::string both = display("m\\ddot x = -kx") + display("m\\ddot x = kx");
  CHECK(last_verdict(both + display("m\\ddot x = 7kx")) == "law");
  CHECK(last_verdict(both + display("\\ddot x = 0")) == "law");
  CHECK(last_verdict(display("ab = 0") + display("(a + b)^2 = a^2 + b^2")) != "proved");
}

TEST_CASE("links of a chain do not follow from each other") {
  CHECK(last_verdict(display("F = ma") + display("W = sq = tp")) == "undecided");
  CHECK(last_verdict(display("\\dot v m = F") +
                     display("\\frac{\\dot v}{2} = \\frac{F}{2m} = \\frac{G}{m}")) == "undecided");
}

TEST_CASE("a law that is said again is a law, a conclusion from nothing is undecided") {
  const std::string law = display("M\\dot V = P");
  const Checked again(law + display("-2P = -2M\\dot V"));
  CHECK(last_step(again).verdict == Verdict::law);
  CHECK(last_step(again).route == "restates law in line 1");
  CHECK(last_verdict(law + "Hence\n" + display("M\\dot V = 2P + Q")) == "undecided");
  CHECK(last_verdict(law + "Hence\n" + display("M\\dot V = 2P")) == "suspect");
  CHECK(last_verdict(law + "Another law is\n" + display("M\\dot V = 2P")) == "law");
}

TEST_CASE("what is meant for all values does not rest on a law") {
  const std::string law = display("ab = c");
  CHECK(last_verdict(law + display("2ab = 2c")) == "law");
  CHECK(last_verdict(law + "<!-- rigor: for all a, b, c -->\n\n" + display("2ab = 2c")) == "refuted");
}

TEST_CASE("a step can be expected to be a law") {
  CHECK(Checked("<!-- rigor: expect law -->\n\n" + display("ma = F")).report.diagnostics.empty());
  CHECK(Checked("<!-- rigor: expect law -->\n\n" + display("(a + b)^2 = a^2 + 2ab + b^2"))
            .report.diagnostics.size() == 1);
}
