// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds of point masses from files, by the ending of the name in any case:
//
//   .bin          records of four little-endian doubles x, y, z, m, 32 bytes a point, nothing else
//   .txt, .csv    a line `x y z m` for each point, with blanks or commas between the numbers; `#` begins a
//                 comment, lines without a number are ignored
//
// in m and kg. Files are mapped and given back as they are read, so that points are in memory once: sums over
// a binary file read it where it lies; text is parsed there. A reason names the point or the line (from 1).
#pragma once

#include <string>

#include "numeric/body/body.h"

namespace rigor {

/// The points as a body, about their centre of mass; `unit` is the length of 1 in the file, m. Summed
/// by all cores where there are more than 10^6 points.
[[nodiscard]] Result<Body> read_cloud(std::string name, const std::string& path, double unit = 1);

}  // namespace rigor
