// SPDX-License-Identifier: GPL-3.0-or-later
// `\text{KE} = \frac12 mv^2`, `\text{distance}/\text{time}`: words that stand for a quantity, each as one
// letter. That they do is told by their place: beside signs of sums, products and relations, and beside
// nothing else. Words of a sentence, units, and names of functions before their argument stand elsewhere.
//
// A symbol such as `Re` or `KE` that some row shows to be a quantity is one next to other factors as well:
// `\mathrm{Pe} = \mathrm{Re}\,\mathrm{Pr}`. A word that is all of a side behind the first, `p =
// \text{fixed}`, can say a property; it is a quantity where another row, or a relation among words alone,
// shows it to be.
#pragma once

#include <set>
#include <string>

#include "latex/token/tokens.h"

namespace rigor {

/// The letters (`letter_of`) of the words that these tokens show to be quantities.
void add_quantity_words(TokenView tokens, std::set<std::string>& shown);

/// The tokens with one letter in the place of each word that stands for a quantity; `shown`: by other rows.
[[nodiscard]] Tokens with_quantity_words(Tokens tokens, const std::set<std::string>& shown);

/// The same in a directive, which names quantities: words that stand alone are one there.
[[nodiscard]] Tokens with_named_words(Tokens tokens);

}  // namespace rigor
