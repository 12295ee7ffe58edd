// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/forms_of_name.h"

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"

namespace rigor {
namespace {

std::vector<std::vector<std::string>> forms_in(const std::string& notes) {
  SourceMap sources;
  const FormsReading reading = read_forms_of_text(sources, "notes.md", notes, {});
  std::vector<std::vector<std::string>> all;
  for (const WrittenFormChain& chain : forms_of_one_name(reading.forms)) {
    all.emplace_back();
    for (const WrittenForm& form : chain.forms) all.back().push_back(form.source);
  }
  return all;
}

using Forms = std::vector<std::vector<std::string>>;

TEST_CASE("chains that begin with one name are forms of one quantity, each form once") {
  CHECK(forms_in("$$T = (a + b)^2$$\n\n$$T = a^2 + 2ab + b^2 = (a + b)^2$$\n\n$$S = 2a$$\n") ==
        Forms{{"T", "(a + b)^2", "a^2 + 2ab + b^2"}});
}

TEST_CASE("a chain with a step that is not proved is no form of a name") {
  CHECK(forms_in("<!-- rigor: scalar a, b -->\n$$T = (a + b)^2$$\n\n$$T = a^2 + b^2$$\n").empty());
  CHECK(forms_in("<!-- rigor: scalar a, b -->\n$$T = (a + b)^2$$\n\n$$T \\ge 0$$\n").empty());
  CHECK(forms_in("<!-- rigor:\nscalar a, x\nsmall x\n-->\n$$T = (a + x)^2 - a^2$$\n\n$$T \\approx 2ax$$\n")
            .empty());
}

TEST_CASE("components and free letters are no forms of one name") {
  CHECK(forms_in("$$(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_jB_k$$\n\n"
                 "$$(\\mathbf{A}\\times\\mathbf{B})_i = -\\epsilon_{ijk}B_jA_k$$\n")
            .empty());
}

}  // namespace
}  // namespace rigor
