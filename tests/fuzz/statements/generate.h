// SPDX-License-Identifier: GPL-3.0-or-later
// Statements at random: some true by a rewriting, some false by a slip, some either way.
#pragma once

#include <string>
#include <vector>

#include "random.h"
#include "statement.h"

namespace fuzz {

/// The classes, by name: `vectors`, `orders`, …
[[nodiscard]] const std::vector<std::string>& kinds();

/// Well formed, of at most 60 nodes a side.
[[nodiscard]] Statement statement_of(const std::string& kind, Random& random);

/// What a class puts together.
struct Grammar {
  bool quotients = false, roots = false, functions = false, vectors = false, tensors = false, rates = false,
       frames = false, fields = false, near_one = false;
};

/// Terms of a grammar over given letters.
class Grower {
 public:
  Grower(const std::vector<Letter>& letters, Grammar grammar, Random& random)
      : letters_(letters), grammar_(grammar), random_(random) {}
  [[nodiscard]] Term scalar(int depth);
  [[nodiscard]] Term vector(int depth);
  [[nodiscard]] Term leaf(int rank);
  char particle = 0;  // that is bound here

 private:
  Term tensor();
  Term of_scalars(int depth);
  Term of_vectors(int depth);
  Term differentiated(int rank, int depth);
  const std::vector<Letter>& letters_;
  Grammar grammar_;
  Random& random_;
};

[[nodiscard]] Statement order_of(Random& random);
[[nodiscard]] std::vector<Letter> scalars_of(std::size_t count, Random& random);

}  // namespace fuzz
