// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of complex numbers, `1 + 2i`, and of their parts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "algebra/parts/real_parts.h"

namespace rigor {

/// `3`, `2i`, `1 - i`, `1 + (1/2)i`
[[nodiscard]] std::string complex_text(const std::string& re, const std::string& im);
/// The parts of what `complex_text` writes.
[[nodiscard]] std::pair<std::string, std::string> parts_of_text(std::string_view text);

/// Values of the real question's symbols as values of the question's, and back.
[[nodiscard]] SampleValue with_complex_values(SampleValue value, const RealQuestion& real);
[[nodiscard]] Sample with_complex_values(Sample sample, const RealQuestion& real);
[[nodiscard]] Sample with_parts(Sample sample, const RealQuestion& real);

/// The sample at one part, 1 or 2, of the sides; its axes are those of the question.
[[nodiscard]] Sample at_part(Sample sample, const RealQuestion& real, std::uint8_t part);
/// The sample of the real question without the axis of parts.
[[nodiscard]] Sample without_part(Sample sample, const RealQuestion& real);

}  // namespace rigor
