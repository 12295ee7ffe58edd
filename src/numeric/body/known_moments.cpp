// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/known_moments.h"

namespace rigor {

bool may_have_equal_moments(const SharpTensor& tensor, double error) {
  const auto found = principal_moments(tensor);
  if (!found) return false;
  for (std::size_t k = 1; k < 3; ++k) {
    // A moment moves by |E| ≤ 3 max |E_ij| at most (H. Weyl), and a gap by twice that; six bits are to be
    // left of it.
    const EnclosedGap gap = found->enclosed_gap(k, k - 1);
    if (!(gap.value > 0x1p6 * (6 * error + gap.error))) return true;
  }
  return false;
}

void tell_moments_apart(KnownInertia& known, const std::function<std::optional<ExactTensor>()>& exact) {
  SharpTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) tensor[i][j] = {known.inertia[i][j], known.low[i][j]};
  if (!known.is_sharp || !may_have_equal_moments(tensor, known.error)) return;
  const auto integers = exact();
  if (!integers) return;
  if (const auto moments = exact_moments(*integers))
    known.exact = std::make_shared<const ExactMoments>(*moments);
}

void tell_moments_apart(KnownInertia& known, const ExactBody& exact) {
  known.integers = std::make_shared<const ExactBody>(exact);
  tell_moments_apart(known, [&] { return exact.inertia; });
}

}  // namespace rigor
