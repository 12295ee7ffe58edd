// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_samples_parts.h"

namespace rigor {

template class Engine<float>;
template std::vector<float> run_on_samples<float>(const Program&, const Samples&, Lanes,
                                                  std::span<const std::uint32_t>);

}  // namespace rigor
