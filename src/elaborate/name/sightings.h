// SPDX-License-Identifier: GPL-3.0-or-later
// How letters are written, over all of a file: a letter that is bold anywhere is a vector everywhere, so the
// whole file is looked at before anything is read.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "elaborate/evidence/evidence.h"
#include "elaborate/name/name_key.h"

namespace rigor {

struct Sightings {
  std::set<std::pair<std::string, bool>> bold;    // base, per particle: `\mathbf{A}` without a letter index
  std::set<std::string> bold_indexed;             // `\boldsymbol\omega_i`
  std::set<NameKey> indexed;                      // rank = number of letter indices: `I_{ij}`
  std::set<std::string> summed_greek;             // `\alpha` of some \sum_\alpha
  SummedMembers members;                          // s of `\sum_s e^{-\beta E_s}`
  std::set<std::string> crossed;                  // bases of bold factors of a cross product
  std::set<NameKey> rates;                        // a time derivative of it is written
  std::set<std::pair<std::string, bool>> fields;  // that a ∂ or ∇ stands directly before: base, vector?
  std::set<std::pair<std::string, bool>> partial_rates;  // that a ∂/∂t stands directly before
  bool places = false;                                   // some derivative by a coordinate is written
  std::set<std::string> mixed_axes;                      // `\lambda_{i'j}`: two indices, one of them primed
  std::set<std::string>
      diagonal;            // X where `X_i = X_{ii}` or `X_{ij} = X_i\delta_{ij}` is said: principal values
  bool hatted_ij = false;  // \hat\imath or \hat\jmath: then \hat k is an axis as well
};

/// Is a time derivative of it written? Sightings are of the whole file, and know no spaces
/// and no complex numbers or operators.
[[nodiscard]] inline bool has_rate(const Sightings& sightings, NameKey key) {
  key.space = 0;
  key.complex = false;
  key.noncommuting = false;
  key.unsized = Unsized::none;
  return sightings.rates.contains(key);
}

}  // namespace rigor
