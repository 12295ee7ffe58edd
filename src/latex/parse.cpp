// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse.h"

#include "latex/parser.h"

namespace rigor {

SyntaxId parse_side(TokenView tokens, Span place, SyntaxTree& tree) {
  return Parser(tree, 0).expression(tokens, place);
}

}  // namespace rigor
