// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/span.h"
#include "expr/statement/statement.h"

namespace rigor {

/// How it came to stand on the page.
enum class Standing : std::uint8_t {
  law,         // it is stated
  result,      // it follows from what stands above it
  conclusion,  // it is announced as one, and no proof of it was found
};

/// A relation that the page states, or that follows from such.
struct PageLaw {
  Equation equation;
  std::string name;  // as a verdict names it: `law (3)`, `law in line 12`, `result in line 14`
  Span span = {};
  std::size_t place = 0;        // its section, as `Sections` counts them
  std::size_t argument = 0;     // and its argument, as `ProseBeside` counts them
  bool at_instant = false;      // it may hold at one moment or place only: it says nothing of rates
  bool of_a_case = false;       // behind "for critical damping": it holds in its argument only
  bool of_its_own = false;      // words before it speak of something: "Particle B obeys"
  bool names_a_letter = false;  // "with $N = a^\dagger a$": a letter that is new there
  bool by_convention = false;   // `\hat x^\dagger = \hat x`: beside every set of laws, where adjoints are
  bool proves_only = false;     // no slip is suspected beside it
  Standing standing = Standing::law;
};

using Laws = std::vector<const PageLaw*>;

}  // namespace rigor
