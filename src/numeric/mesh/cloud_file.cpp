// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/cloud_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <thread>
#include <utility>

#include "base/ascii.h"
#include "numeric/body/known_moments.h"
#include "numeric/mesh/cloud_text.h"
#include "source/mapped_file.h"

namespace rigor {
namespace {

constexpr std::size_t record_size = 4 * sizeof(double);

/// The records of a mapped file, where they lie: a page begins at any double's alignment.
Result<PointColumns> records_of(std::string_view bytes) {
  if constexpr (std::endian::native != std::endian::little)
    return refuse("a binary cloud is little-endian, and this machine is not: give it as text");
  if (bytes.size() % record_size != 0)
    return refuse(
        fmt::format("its {} bytes are not a multiple of {}: each point has four doubles x, y, z and m",
                    bytes.size(), record_size));
  const std::size_t count = bytes.size() / record_size;
  if (count > most_particles)
    return refuse(fmt::format("it has {} points, at most {}", count, most_particles));
  return point_records(reinterpret_cast<const double*>(bytes.data()), count);
}

enum class CloudFormat { binary, text };

Result<CloudFormat> format_of(const std::string& path) {
  const std::string ending = lowered(path.substr(std::min(path.rfind('.'), path.size())));
  if (ending == ".bin") return CloudFormat::binary;
  if (ending == ".txt" || ending == ".csv") return CloudFormat::text;
  return refuse("a cloud's name ends in `.bin`, `.txt` or `.csv`");
}

Result<MappedFile> cloud_bytes(const std::string& path) {
  auto file = MappedFile::open(path);
  if (file && file->bytes().empty()) return refuse("the file is empty");
  return file;
}

/// All that the machine runs at once, where they are worth their start.
std::size_t threads_for(std::size_t points) {
  constexpr std::size_t many_points = 1'000'000;  // 3 ms on one
  return points > many_points ? std::thread::hardware_concurrency() : 1;
}

/// Points at (x − centre) unit, where `centre` is theirs: rounded as `away_from` says, and once by the unit.
Result<Body> about_centre(std::string name, const PointColumns& points, double unit) {
  const SumOptions options{threads_for(points.count)};
  Body body{std::move(name), {}, {}, {}};
  SharpPosition centre{};
  if (const auto sums = sharp_mass_sums(points, options)) {
    centre = sums->centre;
    body.known = known_inertia(*sums, unit);
    if (body.known)
      tell_moments_apart(*body.known, [&] { return times(times(exact_body(points).inertia, unit), unit); });
  } else if (const auto alone = sharp_centre_of_mass(points, options)) {  // where the inertia overflows
    centre = *alone;
  } else {
    return tl::unexpected(alone.error());
  }
  body.masses.resize(points.count);
  for (std::size_t k = 0; k < points.count; ++k) body.masses[k] = points.mass[points.stride * k];
  for (std::size_t i = 0; i < 3; ++i) {
    auto moved = moved_coordinates(points.position[i], points.count, points.stride, centre[i], unit);
    body.positions[i] = std::move(moved.values);
    if (moved.rounded) body.errors.place = 0x1.01p-52;
    body.errors.shift = std::max(body.errors.shift, moved.shift);
  }
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  return body;
}

}  // namespace

Result<Body> read_cloud(std::string name, const std::string& path, double unit) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  const auto file = cloud_bytes(path);
  if (!file) return tl::unexpected(file.error());
  if (*format == CloudFormat::binary) {
    const auto records = records_of(file->bytes());
    if (!records) return tl::unexpected(records.error());
    return about_centre(std::move(name), *records, unit);
  }
  const auto columns = parse_cloud(file->bytes());
  if (!columns) return tl::unexpected(columns.error());
  const auto& [x, y, z, m] = *columns;
  return about_centre(std::move(name), {{x.data(), y.data(), z.data()}, m.data(), m.size()}, unit);
}

}  // namespace rigor
