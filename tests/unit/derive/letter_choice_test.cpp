// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/letter_choice.h"

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
