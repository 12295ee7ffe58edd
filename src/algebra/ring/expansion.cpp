// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/expansion.h"

#include <ginac/ginac.h>

#include "algebra/packed/packed_letters.h"

namespace rigor {

GiNaC::ex expanded_polynomial(const GiNaC::ex& value) {
  PackedLetters letters;
  add_letters(letters, value);
  const auto read = read_polynomial(value, letters);
  if (!read) return value.expand();
  return read->is_expanded ? value : to_ex(read->value, letters);
}

}  // namespace rigor
