// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/cloud_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>
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

/// Of points in units of `unit` m, whose inertia becomes known.
Result<SharpPosition> centre_of(const PointColumns& points, double unit, Body& body) {
  const SumOptions options{threads_for(points.count)};
  if (const auto sums = sharp_mass_sums(points, options)) {
    body.known = known_inertia(*sums, unit);
    if (body.known)
      tell_moments_apart(*body.known, [&] { return times(times(exact_body(points).inertia, unit), unit); });
    return sums->centre;
  }
  return sharp_centre_of_mass(points, options);  // where the inertia overflows
}

/// Points from `begin` on, at (x − centre) unit: rounded as `away_from` says, and once by the unit.
void move_points(const PointColumns& points, std::size_t begin, std::size_t count,
                 const SharpPosition& centre, double unit, Body& body) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::span<double> into = std::span(body.positions[i]).subspan(begin, count);
    const double* const from = points.position[i] + points.stride * begin;
    const MoveErrors moved = move_coordinates(from, points.stride, centre[i], unit, into);
    if (moved.rounded) body.errors.place = 0x1.01p-52;
    body.errors.shift = std::max(body.errors.shift, moved.shift);
  }
}

/// Moved from the file block by block, which is then forgotten: the points are in memory once.
Result<void> move_records(const MappedFile& file, double unit, Body& body) {
  constexpr std::size_t block = 1 << 16;
  const auto records = records_of(file.bytes());
  if (!records) return tl::unexpected(records.error());
  const auto centre = centre_of(*records, unit, body);
  if (!centre) return tl::unexpected(centre.error());
  body.masses.reserve(records->count);  // and not written to before the file's are forgotten
  for (std::vector<double>& coordinates : body.positions) coordinates.reserve(records->count);
  for (std::size_t begin = 0; begin < records->count; begin += block) {
    const std::size_t count = std::min(block, records->count - begin);
    for (std::vector<double>& coordinates : body.positions) coordinates.resize(begin + count);
    move_points(*records, begin, count, *centre, unit, body);
    for (std::size_t k = begin; k < begin + count; ++k)
      body.masses.push_back(records->mass[records->stride * k]);
    file.forget(begin * record_size, count * record_size);
  }
  return {};
}

/// Moved where they lie.
Result<void> move_columns(std::array<std::vector<double>, 4> columns, double unit, Body& body) {
  for (std::size_t i = 0; i < 3; ++i) body.positions[i] = std::move(columns[i]);
  body.masses = std::move(columns[3]);
  const auto centre = centre_of(points_of(body), unit, body);
  if (!centre) return tl::unexpected(centre.error());
  move_points(points_of(body), 0, body.size(), *centre, unit, body);
  return {};
}

}  // namespace

Result<Body> read_cloud(std::string name, const std::string& path, double unit) {
  const auto format = format_of(path);
  if (!format) return tl::unexpected(format.error());
  const auto file = cloud_bytes(path);
  if (!file) return tl::unexpected(file.error());
  Body body{std::move(name), {}, {}, {}};
  const auto read = [&]() -> Result<void> {
    if (*format == CloudFormat::binary) return move_records(*file, unit, body);
    auto columns =
        parse_cloud(file->bytes(), [&](std::size_t begin, std::size_t count) { file->forget(begin, count); });
    if (!columns) return tl::unexpected(columns.error());
    return move_columns(std::move(*columns), unit, body);
  };
  if (const auto done = read().and_then([&] { return check_body(body); }); !done)
    return tl::unexpected(done.error());
  return body;
}

}  // namespace rigor
