// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_sample.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"

namespace rigor {
namespace {

bool are_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::optional<double> nearest_double(std::string_view rational) {
  using boost::multiprecision::cpp_int;
  const std::size_t slash = rational.find('/');
  const std::string_view over = rational.substr(0, slash);
  const std::string_view under = slash == std::string_view::npos ? "1" : rational.substr(slash + 1);
  if (!are_digits(over.starts_with('-') ? over.substr(1) : over) || !are_digits(under)) return std::nullopt;
  const auto number = [](std::string_view digits) {  // a leading 0 would make it octal
    const bool negative = digits.starts_with('-');
    if (negative) digits.remove_prefix(1);
    digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
    const cpp_int value{std::string(digits)};
    return negative ? cpp_int(-value) : value;
  };
  const cpp_int divisor = number(under);
  if (divisor == 0) return std::nullopt;
  const boost::multiprecision::cpp_rational value(number(over), divisor);
  return value.convert_to<double>();
}

void put_sample(const ExprTree& tree, const Sample& sample, Samples& samples) {
  std::map<std::pair<SymbolId, std::uint32_t>, std::vector<double>> particles;
  for (const SampleValue& value : sample.values) {
    for (std::uint32_t k = 0; k < value.components.size(); ++k) {
      const auto number = nearest_double(value.components[k]);
      RIGOR_CHECK(number.has_value(), value.components[k]);
      if (!tree.symbols[value.symbol].per_particle) {
        samples.set(value.symbol, k, *number);
        continue;
      }
      std::vector<double>& column =
          particles.try_emplace({value.symbol, k}, std::vector<double>(sample.particles, 0.0)).first->second;
      RIGOR_CHECK(value.particle >= 1 && value.particle <= column.size(), value.particle);
      column[value.particle - 1] = *number;
    }
  }
  for (auto& [place, column] : particles) samples.set_particles(place.first, place.second, std::move(column));
}

Samples samples_of(const ExprTree& tree, const Sample& sample) {
  Samples samples(1, sample.particles);
  put_sample(tree, sample, samples);
  return samples;
}

}  // namespace rigor
