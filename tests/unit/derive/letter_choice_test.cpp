// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/letter_choice.h"

#include <set>

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("sums within a product get different letters, terms of a sum share them") {
  Page page;
  const Named a = page.vector("a");
  const IndexId i = page.index("i");
  const IndexId other = page.index("i");
  const Term square = sum({i}, at(a, i) * at(a, i));
  const Term same = sum({other}, at(a, other) * at(a, other));
  CHECK(dump(page.tree, with_letters(page.tree, (square * same).id, {})) ==
        "(multiply (index-sum i (multiply a[i] a[i])) (index-sum j (multiply a[j] a[j])))");
  CHECK(dump(page.tree, with_letters(page.tree, (square + same).id, {})) ==
        "(add (index-sum i (multiply a[i] a[i])) (index-sum i (multiply a[i] a[i])))");
}

TEST_CASE("a free letter is not given to a sum") {
  Page page;
  const Named a = page.vector("a");
  const Named t = page.tensor("T");
  const IndexId i = page.index("i");
  const IndexId summed = page.index("");
  const Term term = sum({summed}, at(t, i, summed) * at(a, summed));
  LetterChoice choice;
  choice.taken = {"i"};
  CHECK(dump(page.tree, with_letters(page.tree, term.id, choice)) == "(index-sum j (multiply T[i,j] a[j]))");
}

TEST_CASE("the letters of the step come before the usual ones") {
  Page page;
  const Named a = page.vector("a");
  const IndexId p = page.index("p");
  const IndexId summed = page.index("");
  LetterChoice choice;
  note_letters(page.tree, sum({p}, at(a, p)).id, choice);
  CHECK(dump(page.tree, with_letters(page.tree, sum({summed}, at(a, summed)).id, choice)) ==
        "(index-sum p a[p])");
}

TEST_CASE("where all letters are taken no letter is given twice") {
  Page page;
  const Named a = page.vector("a");
  Term product = page.number("1");
  for (int k = 0; k < 20; ++k) {
    const IndexId index = page.index("");
    const Term factor = sum({index}, at(a, index) * at(a, index));
    product = k == 0 ? factor : product * factor;
  }
  const std::string text = dump(page.tree, with_letters(page.tree, product.id, {}));
  std::set<std::string> letters;
  const std::string sign = "(index-sum ";
  for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + 1))
    letters.insert(text.substr(at + sign.size(), text.find(' ', at + sign.size()) - at - sign.size()));
  CHECK(letters.size() == 20);
}
