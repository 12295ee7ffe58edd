// SPDX-License-Identifier: GPL-3.0-or-later
// The symbol of a name, whole or along axes.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// A letter where it stands.
struct Occurrence {
  const WrittenSymbol& written;
  WrittenName name;
  Span span;
  const Around& around;
};

/// The symbol of this rank, or its component along `axes`; in an integral over the body, that of its point.
[[nodiscard]] MaybeTyped named_symbol(Reading& reading, const Occurrence& at, const std::string& base,
                                      int rank, const std::vector<WrittenIndex>& axes = {});

/// How the vector of a name is written: `\mathbf{A}`.
[[nodiscard]] std::string bold(const std::string& base);
/// Was it declared, or seen with this rank?
[[nodiscard]] bool is_known(const Names& names, const std::string& base, int rank, bool per_particle);
/// Is it declared, as it stands or without its subscripts? Then it is a quantity, and no function.
[[nodiscard]] bool is_declared_letter(const Names& names, const WrittenSymbol& symbol);

}  // namespace rigor
