// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_double_double.h"

#include "numeric/run/run_samples_parts.h"

namespace rigor {

template class Engine<dd_real>;
template std::vector<dd_real> run_on_samples<dd_real>(const Program&, const Samples&, Lanes,
                                                      std::span<const std::uint32_t>);

}  // namespace rigor
