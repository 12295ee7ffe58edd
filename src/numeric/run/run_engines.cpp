// SPDX-License-Identifier: GPL-3.0-or-later
// The engine for each arithmetic of a machine.
#include "numeric/run/run_double_double.h"
#include "numeric/run/run_samples_parts.h"

namespace rigor {

template class Engine<float>;
template std::vector<float> run_on_samples<float>(const Program&, const Samples&, Lanes,
                                                  std::span<const std::uint32_t>);

template class Engine<double>;
template std::vector<double> run_on_samples<double>(const Program&, const Samples&, Lanes,
                                                    std::span<const std::uint32_t>);

template class Engine<long double>;
template std::vector<long double> run_on_samples<long double>(const Program&, const Samples&, Lanes,
                                                              std::span<const std::uint32_t>);

template class Engine<dd_real>;
template std::vector<dd_real> run_on_samples<dd_real>(const Program&, const Samples&, Lanes,
                                                      std::span<const std::uint32_t>);

}  // namespace rigor
