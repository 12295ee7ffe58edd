// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/print/print_latex.h"

#include "expr/print/latex_printer.h"

namespace rigor {

std::string print_latex(const ExprTree& tree, ExprId root, const Notation& notation) {
  return LatexPrinter(tree, notation).print(root);
}

}  // namespace rigor
