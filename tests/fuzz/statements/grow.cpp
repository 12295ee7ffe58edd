// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate.h"

namespace fuzz {

Term Grower::leaf(int rank) {
  for (int tries = 0; tries < 40; ++tries) {
    const std::size_t k = random_.below(letters_.size());
    const Letter& letter = letters_[k];
    if (letter.rank != rank || (letter.of_particles && particle == 0)) continue;
    return symbol(letters_, k, "", letter.of_particles ? particle : '\0');
  }
  return rank == 0 ? number(random_.between(1, 3)) : nullptr;
}

Term Grower::scalar(int depth) {
  if (depth <= 0)
    return random_.one_in(6) ? number(random_.between(1, 4), random_.one_in(4) ? 3 : 1) : leaf(0);
  if (grammar_.vectors && random_.one_in(2)) return of_vectors(depth);
  if ((grammar_.rates || grammar_.fields) && random_.one_in(4)) return differentiated(0, depth);
  return of_scalars(depth);
}

Term Grower::of_scalars(int depth) {
  const auto next = [&] { return scalar(depth - 1); };
  switch (random_.below(9)) {
    case 0:
    case 1:
      return sum({next(), random_.one_in(2) ? negative(next()) : next()});
    case 2:
    case 3:
      return product({next(), next()});
    case 4:
      return power(next(), random_.one_in(4) ? 3 : 2);
    case 5:
      if (grammar_.quotients) return make(Op::quotient, {next(), next()});
      return product({number(random_.between(2, 3)), next()});
    case 6:
      if (grammar_.near_one) {
        const Term one = sum({number(1), leaf(0)});
        if (random_.one_in(3)) return make(Op::root, {one});
        return random_.one_in(2) ? power(one, random_.between(2, 4)) : make(Op::quotient, {leaf(0), one});
      }
      if (grammar_.roots) return make(random_.one_in(2) ? Op::root : Op::absolute, {next()});
      return sum({next(), next()});
    case 7:
      if (grammar_.functions) return function_of(static_cast<Function>(random_.below(8)), next());
      return negative(next());
    default:
      return leaf(0);
  }
}

Term Grower::of_vectors(int depth) {
  const auto next = [&] { return vector(depth - 1); };
  switch (random_.below(6)) {
    case 0:
      return power(make(Op::length, {next()}), 2);
    case 1:
      if (grammar_.roots) return make(Op::length, {next()});
      return product({scalar(depth - 2), make(Op::dot, {next(), next()})});
    case 2:
      if (grammar_.tensors) return make(Op::dot, {next(), make(Op::act, {tensor(), next()})});
      return make(Op::dot, {next(), make(Op::cross, {next(), vector(0)})});
    case 3:
      if (grammar_.tensors) return make(Op::trace, {tensor()});
      [[fallthrough]];
    default:
      return make(Op::dot, {next(), next()});
  }
}

Term Grower::vector(int depth) {
  if (depth <= 0) return leaf(1);
  if ((grammar_.frames || grammar_.rates || grammar_.fields) && random_.one_in(3))
    return differentiated(1, depth);
  const auto next = [&] { return vector(depth - 1); };
  switch (random_.below(6)) {
    case 0:
    case 1:
      return make(Op::cross, {next(), next()});
    case 2:
      return sum({next(), random_.one_in(2) ? negative(next()) : next()});
    case 3:
      return product({scalar(depth - 1), next()});
    case 4:
      if (grammar_.tensors) return make(Op::act, {tensor(), next()});
      return next();
    default:
      return leaf(1);
  }
}

Term Grower::differentiated(int rank, int depth) {
  if (grammar_.frames)
    return make(rank == 0           ? Op::rate
                : random_.one_in(2) ? Op::rate_in
                                    : Op::rate_rot,
                {rank == 0 ? scalar(depth - 1) : vector(depth - 1)});
  if (grammar_.fields) {
    if (rank == 1)
      return random_.one_in(3)   ? make(Op::gradient, {scalar(depth - 1)})
             : random_.one_in(2) ? make(Op::along, {leaf(1), vector(depth - 1)})
                                 : make(Op::curl, {vector(depth - 1)});
    return random_.one_in(3) ? make(Op::laplacian, {scalar(depth - 1)})
                             : make(Op::divergence, {vector(depth - 1)});
  }
  return make(Op::rate, {rank == 0 ? scalar(depth - 1) : vector(depth - 1)});
}

Term Grower::tensor() { return leaf(2); }

}  // namespace fuzz
