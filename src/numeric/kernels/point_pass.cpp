// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/point_pass.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <thread>
#include <vector>

#include "numeric/kernels/high_low.h"

namespace rigor {
namespace {

/// A thread takes some 10 us to start, a chunk 5 us to sum.
constexpr std::size_t least_chunks_a_thread = 8;

PointPlaces later(PointPlaces places, std::size_t first) {
  for (const double*& at : places.at) at += places.stride * first;
  return places;
}

class PointPass {
 public:
  PointPass(SumPoints sum, const PointColumns& points, const PointScale& scale, const SharpPosition& centre)
      : sum_(sum), places_(places_of(points)), count_(points.count), scale_(scale) {
    for (std::size_t i = 0; i < 3; ++i) {
      high_[i] = centre[i].high;
      low_[i] = centre[i].low;
    }
  }

  /// Numbers that `run` needs for scaled points.
  [[nodiscard]] std::size_t scratch_size() const { return scale_.is_one() ? 0 : 4 * chunk_points; }

  /// The chunks from `begin` to `end`.
  void run(std::size_t begin, std::size_t end, double* scratch, PointSums* sums) const noexcept {
    for (std::size_t chunk = begin; chunk < end; ++chunk) {
      const std::size_t first = chunk * chunk_points;
      const std::size_t count = std::min(count_ - first, chunk_points);
      PointPlaces places = later(places_, first);
      if (!scale_.is_one()) places = scaled_into(scratch, places, count);
      sum_(places, count, high_, low_, sums[chunk]);
    }
  }

 private:
  PointPlaces scaled_into(double* to, const PointPlaces& from, std::size_t count) const {
    PointPlaces places;
    const double* const masses = from.at[3];
    for (std::size_t i = 0; i < 4; ++i) {
      double* const column = to + i * chunk_points;
      const double factor = std::ldexp(1.0, i < 3 ? scale_.length : scale_.mass);
      for (std::size_t k = 0; k < count; ++k)
        column[k] = masses[from.stride * k] == 0 ? 0 : from.at[i][from.stride * k] * factor;
      places.at[i] = column;
    }
    return places;
  }

  SumPoints sum_;
  PointPlaces places_;
  std::size_t count_;
  PointScale scale_;
  double high_[3];
  double low_[3];
};

/// The sums of the chunks in their order, in double-double.
PointSums combined(const std::vector<PointSums>& chunks) {
  PointSums all = chunks[0];
  for (std::size_t k = 1; k < chunks.size(); ++k) {
    for (int q = 0; q < PointSums::count; ++q) {
      const HighLow sum = HighLow{all.high[q], all.low[q]} + HighLow{chunks[k].high[q], chunks[k].low[q]};
      all.high[q] = sum.high;
      all.low[q] = sum.low;
    }
    all.has_sign = all.has_sign || chunks[k].has_sign;
    all.is_wide = all.is_wide || chunks[k].is_wide;
  }
  return all;
}

}  // namespace

PointPlaces places_of(const PointColumns& points) {
  return {{points.position[0], points.position[1], points.position[2], points.mass}, points.stride};
}

PointSums point_pass(SumPoints sum, const PointColumns& points, const PointScale& scale,
                     const SharpPosition& centre, std::size_t threads) {
  const PointPass pass(sum, points, scale, centre);
  const std::size_t chunks = (points.count + chunk_points - 1) / chunk_points;
  const std::size_t shares =
      std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(1, chunks / least_chunks_a_thread));
  std::vector<PointSums> sums(chunks);
  std::vector<double> scratch(shares * pass.scratch_size());
  const auto run_shares = [&](std::size_t from, std::size_t to) {
    pass.run(chunks * from / shares, chunks * to / shares, scratch.data() + from * pass.scratch_size(),
             sums.data());
  };
  std::size_t begun = 1;
  {
    std::vector<std::jthread> others;  // joined at the end of the block
    others.reserve(shares);
    try {
      for (; begun < shares; ++begun) others.emplace_back(run_shares, begun, begun + 1);
    } catch (const std::system_error&) {  // the system has no more threads: what is left is done here
    }
    run_shares(0, 1);
    run_shares(begun, shares);
  }
  return combined(sums);
}

}  // namespace rigor
