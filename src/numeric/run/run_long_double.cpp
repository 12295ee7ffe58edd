// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_samples_parts.h"

namespace rigor {

template class Engine<long double>;
template std::vector<long double> run_on_samples<long double>(const Program&, const Samples&, Lanes,
                                                              std::span<const std::uint32_t>);

}  // namespace rigor
