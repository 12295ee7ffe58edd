// SPDX-License-Identifier: GPL-3.0-or-later
// How an author writes what the tree only means: the spellings that notes prefer where there are several.
#pragma once

#include <map>
#include <string>

#include "expr/symbol.h"

namespace rigor {

struct Notation {
  std::string epsilon = "\\varepsilon";  // or `\epsilon`
  std::string delta = "\\delta";
  std::string basis = "\\mathbf{e}";  // e_i; `\hat{\mathbf{e}}`
  std::string time = "t";             // of d/dt
  std::map<SymbolId, std::string> whole =
      {};  // a tensor as one letter: `\mathsf{I}`, `\overleftrightarrow{\mathbf{I}}`
};

}  // namespace rigor
