// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macro_output.h"

#include "latex/token/words.h"

namespace rigor {
namespace {

std::uint8_t arguments_of(const Token& token) {
  static const WordSet takes_one(
      "acute bar bm boldsymbol boxed breve check ddddot dddot ddot dot grave hat mathbb mathbf mathbfit "
      "mathbfsf mathcal mathfrak mathit mathnormal mathring mathrm mathscr mathsf mathtt mbox norm "
      "operatorname overbrace overleftarrow overleftrightarrow overline overrightarrow pmb sqrt symbf "
      "symbfit symrm text textbf textit textnormal textrm tilde underbrace underline unit va vb vec "
      "vectorbold vectorunit vu widehat widetilde");
  static const WordSet takes_two(
      "binom cfrac dbinom dfrac frac overset stackrel tbinom textcolor tfrac underset");
  if (token.kind != TokenKind::control) return 0;
  return takes_one.contains(token.text) ? 1 : takes_two.contains(token.text) ? 2 : 0;
}

}  // namespace

bool MacroOutput::awaits_argument() const {
  return levels_.back().awaited > 0 && !levels_.back().in_optional;
}

void MacroOutput::add(const Token& token) {
  tokens_.push_back(token);
  if (is_blank(token)) return;
  if (token.kind == TokenKind::begin_group) {
    levels_.emplace_back();
    return;
  }
  if (token.kind == TokenKind::end_group && levels_.size() > 1) levels_.pop_back();
  Level& level = levels_.back();
  if (const auto count = arguments_of(token); count > 0) {
    level = {count, true, false};
  } else if (level.in_optional) {
    level.in_optional = !is_sign(token, "]");
  } else if (level.may_be_optional && is_sign(token, "[")) {
    level.in_optional = true;
  } else if (!(level.may_be_optional && is_sign(token, "*"))) {
    if (level.awaited > 0) --level.awaited;
    level.may_be_optional = false;
  }
}

}  // namespace rigor
