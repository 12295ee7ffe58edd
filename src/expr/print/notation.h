// SPDX-License-Identifier: GPL-3.0-or-later
// How an author writes what the tree only means: the spellings that notes prefer where there are several.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "expr/tree/symbol.h"

namespace rigor {

/// Two sets of axes, in which one vector changes in different ways; components are along the rotating ones.
struct FrameNames {
  SymbolId rotation{};
  std::string rotating;
  std::string fixed;
};

struct Notation {
  std::string epsilon = "\\varepsilon";        // or `\epsilon`
  std::string metric = "\\eta";                // of space-time; or `g`
  std::string basis = "\\mathbf{e}";           // e_i; `\hat{\mathbf{e}}`
  std::array<std::string, 3> axes = {};        // `\hat{x}`…; empty: e_1, e_2, e_3
  std::string number_fraction = "\\frac";      // of two numbers; `\tfrac`
  std::string imaginary_unit = "i";            // or `j`
  bool lettered_axes = false;                  // x, y, z rather than 1, 2, 3 where no symbol decides
  std::map<SymbolId, std::string> base = {};   // the name without a face, where the notes have a macro for it
  std::map<SymbolId, std::string> whole = {};  // as one letter with its face: `\mathsf{I}`, `\vec{r}`
  std::set<SymbolId> lettered = {};            // components are A_x, A_y, A_z
  std::set<SymbolId> principal = {};           // of principal values: an index on them goes along
  std::set<SymbolId> fields = {};              // their rate is ∂/∂t
  std::map<SymbolId, std::string> heights = {};  // `ud`: in curved space each height is a tensor of its own
  std::optional<FrameNames> frame = {};          // in force
  bool every_sum = false;  // over indices is written, also where the summation convention gives it back
};

}  // namespace rigor
