// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/point/indeterminates.h"

#include <fmt/format.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <span>
#include <utility>

#include "algebra/engine/exact_number.h"
#include "base/check.h"

namespace rigor {

using GiNaC::ex;

ex Indeterminates::add(Origin origin) {
  origin.position = all_.size();
  const ex created = GiNaC::symbol();
  origins_.emplace(created, origin);
  all_.push_back(created);
  letters_.add(created);
  frames_.push_back(origin.frames);
  const std::pair power(origin.position, 1);
  values_.emplace_back(PackedPolynomial(1, std::span(&power, 1)), letters_);
  return created;
}

std::size_t Indeterminates::position_of_coordinate(SymbolId symbol, std::uint32_t component, Frame frame) {
  const std::uint64_t key = (static_cast<std::uint64_t>(symbol) << 32) | (component << 8) | frame;
  const auto [known, is_new] = coordinates_.try_emplace(key, all_.size());
  if (is_new) {
    static_cast<void>(add({.kind = Kind::coordinate,
                           .frames = only(frame),
                           .symbol = symbol,
                           .component = component,
                           .frame = frame}));
  }
  return known->second;
}

ex Indeterminates::coordinate(SymbolId symbol, std::uint32_t component, Frame frame) {
  return all_[position_of_coordinate(symbol, component, frame)];
}

const Numerator& Indeterminates::coordinate_value(SymbolId symbol, std::uint32_t component, Frame frame) {
  return values_[position_of_coordinate(symbol, component, frame)];
}

ex Indeterminates::fresh(Kind kind, FrameSet frames) { return add({.kind = kind, .frames = frames}); }

const Indeterminates::Origin& Indeterminates::origin(const ex& indeterminate) const {
  const auto found = origins_.find(indeterminate);
  RIGOR_CHECK(found != origins_.end(), origins_.size());
  return found->second;
}

FrameSet Indeterminates::frames_of(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) return origin(value).frames;
  if (GiNaC::is_a<GiNaC::numeric>(value)) return 0;
  FrameSet frames = 0;
  for (std::size_t i = 0; i < value.nops(); ++i) frames |= frames_of(value.op(i));
  return frames;
}

std::set<std::size_t> Indeterminates::positions_in(const Numerator& value) const {
  std::set<std::size_t> positions;
  if (const PackedPolynomial* const packed = value.packed(letters_)) {
    const std::vector<int> degrees = packed->degrees(letters_.count());
    for (std::size_t x = 0; x < degrees.size(); ++x) {
      if (degrees[x] > 0) positions.insert(x);
    }
    return positions;
  }
  const auto collect = [&](const auto& self, const ex& part) -> void {
    if (GiNaC::is_a<GiNaC::symbol>(part)) positions.insert(origin(part).position);
    if (GiNaC::is_a<GiNaC::numeric>(part)) return;
    for (std::size_t i = 0; i < part.nops(); ++i) self(self, part.op(i));
  };
  collect(collect, value.written());
  return positions;
}

std::string Indeterminates::fingerprint(const ex& value) const {
  const Unsigned parts = unsigned_fingerprint(value);
  return parts.negative ? "-" + parts.text : parts.text;
}

/// The first term of a sum, by its text, is taken for positive. GiNaC turns the signs of sums under powers
/// and in products by its own order. Recursion: as deep as the expression.
Indeterminates::Unsigned Indeterminates::unsigned_fingerprint(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) return {fmt::format("x{}", origin(value).position)};
  if (GiNaC::is_a<GiNaC::numeric>(value)) {
    const auto number = cln::the<Rational>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
    return {to_text(cln::abs(number)), cln::minusp(number)};
  }
  if (GiNaC::is_a<GiNaC::power>(value)) {
    const Unsigned base = unsigned_fingerprint(value.op(0));
    return {fmt::format("({}^{})", base.text, fingerprint(value.op(1))),
            base.negative && value.op(1).info(GiNaC::info_flags::odd)};
  }
  std::vector<Unsigned> parts;
  for (std::size_t i = 0; i < value.nops(); ++i) parts.push_back(unsigned_fingerprint(value.op(i)));
  std::ranges::sort(parts, {}, &Unsigned::text);
  const bool is_product = GiNaC::is_a<GiNaC::mul>(value);
  bool negative = !parts.empty() && parts.front().negative;
  if (is_product) {
    negative = std::ranges::count_if(parts, &Unsigned::negative) % 2 != 0;
    std::erase_if(parts, [](const Unsigned& each) { return each.text == "1"; });  // of an opposite
    if (parts.size() == 1) return {parts.front().text, negative};
  }
  std::string text = "(";
  for (const Unsigned& part : parts) {
    text += is_product ? '*' : part.negative == negative ? '+' : '-';
    text += part.text;
  }
  return {text + ")", negative};
}

GiNaC::exmap Indeterminates::twins(Frame from, Frame to) {
  GiNaC::exmap map;
  const std::vector<ex> present = all_;
  for (const ex& each : present) {
    const Origin whose = origin(each);
    if (whose.kind == Kind::coordinate && whose.frame == from) {
      map.emplace(each, coordinate(whose.symbol, whose.component, to));
    }
  }
  return map;
}

}  // namespace rigor
