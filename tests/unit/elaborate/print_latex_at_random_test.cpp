// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets, signs of sums and letters are right however operations are nested: what is printed reads back.
#include "catch.h"
#include "elaborate/random_expressions.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// What is wrong with expressions of one seed.
std::string wrong_with(unsigned seed, int depth) {
  RandomExpressions random(seed);
  random.page.beside(
      "\\mathbf{A}\\cdot\\mathbf{B}\\times\\mathbf{C} = \\sum_\\alpha m_\\alpha "
      "\\mathbf{r}_\\alpha\\cdot\\mathbf{r}_\\alpha");
  const ExprId written = random.any(depth);
  const std::string latex = print_latex(random.page.tree, written);
  std::string complaint;
  const auto read = random.page.read(latex, complaint);
  if (read && same_expression(random.page.tree, written, random.page.tree, *read)) return {};
  return std::to_string(seed) + ": " + latex + "\n  " + complaint + "\n  was " +
         dump(random.page.tree, written) + "\n  is  " + (read ? dump(random.page.tree, *read) : "not read") +
         "\n";
}

}  // namespace

TEST_CASE("expressions of all operations at random read back as they are printed", "[print]") {
  std::string wrong;
  int failures = 0;
  for (unsigned seed = 0; seed < 3000 && failures < 10; ++seed) {
    const std::string each = wrong_with(seed, 1 + static_cast<int>(seed % 6));
    if (!each.empty()) ++failures;
    wrong += each;
  }
  INFO(wrong);
  CHECK(wrong.empty());
}

}  // namespace rigor
