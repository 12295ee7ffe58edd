// SPDX-License-Identifier: GPL-3.0-or-later
// The GiNaC symbols of one decision, and what each belongs to.
//
// Every particle variable in use has a *frame*, a small number: all symbols of a frame belong to one
// particle. Sums over particles that are not nested use the same frame, so that Σ_α f(α) and Σ_β f(β) are the
// same sum without any renaming.
#pragma once

#include <ginac/ex.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "algebra/packed/numerator.h"
#include "expr/tree/symbol.h"

namespace rigor {

using Frame = std::uint32_t;
using FrameSet = std::uint64_t;  // bit f: something of frame f occurs

inline constexpr Frame common_frame = 0;    // not of one particle
inline constexpr Frame template_frame = 1;  // any particle: assumptions for each particle are solved here
inline constexpr Frame first_free_frame = 2;
inline constexpr Frame frame_limit = 60;

[[nodiscard]] constexpr FrameSet only(Frame frame) {
  return frame == common_frame ? 0 : FrameSet{1} << frame;
}

class Indeterminates {
 public:
  enum class Kind : std::uint8_t { coordinate, moment, radical, parameter, function };
  struct Origin {
    Kind kind = Kind::coordinate;
    FrameSet frames = 0;
    SymbolId symbol{};            // coordinate: which number of which symbol
    std::uint32_t component = 0;  // coordinate
    Frame frame = common_frame;   // coordinate
    std::size_t position = 0;     // in order of creation
  };

  /// The indeterminate of a symbol's component, always the same one.
  [[nodiscard]] GiNaC::ex coordinate(SymbolId symbol, std::uint32_t component, Frame frame);
  /// The same, as the evaluator needs it.
  [[nodiscard]] const Numerator& coordinate_value(SymbolId symbol, std::uint32_t component, Frame frame);
  [[nodiscard]] const Numerator& value_at(std::size_t position) const { return values_[position]; }
  [[nodiscard]] GiNaC::ex fresh(Kind kind, FrameSet frames);

  [[nodiscard]] const Origin& origin(const GiNaC::ex& indeterminate) const;
  /// The frames of all indeterminates that occur in an expression.
  [[nodiscard]] FrameSet frames_of(const GiNaC::ex& value) const;
  /// Of the one at a position.
  [[nodiscard]] FrameSet frames_at(std::size_t position) const { return frames_[position]; }
  /// The positions of all indeterminates that occur in an expression.
  [[nodiscard]] std::set<std::size_t> positions_in(const Numerator& value) const;
  /// A text that is the same in every run, unlike GiNaC's order of terms, and the signs of powers' bases that
  /// go with it: equal for equal expressions.
  [[nodiscard]] std::string fingerprint(const GiNaC::ex& value) const;
  /// A fingerprint that an expression shares with its opposite; `negative` for one of the two, the same one
  /// in every run.
  struct Unsigned {
    std::string text;
    bool negative = false;
  };
  [[nodiscard]] Unsigned unsigned_fingerprint(const GiNaC::ex& value) const;
  /// All indeterminates of one frame with their twins in another (coordinates only).
  [[nodiscard]] GiNaC::exmap twins(Frame from, Frame to);
  /// In order of creation.
  [[nodiscard]] const std::vector<GiNaC::ex>& all() const { return all_; }
  /// The same for packed polynomials.
  [[nodiscard]] const PackedLetters& letters() const { return letters_; }

 private:
  [[nodiscard]] GiNaC::ex add(Origin origin);

  std::map<GiNaC::ex, Origin, GiNaC::ex_is_less> origins_;
  std::vector<GiNaC::ex> all_;
  PackedLetters letters_;
  std::vector<Numerator> values_;  // one for each of all
  std::vector<FrameSet> frames_;   // the same
  [[nodiscard]] std::size_t position_of_coordinate(SymbolId symbol, std::uint32_t component, Frame frame);

  std::map<std::uint64_t, std::size_t> coordinates_;  // positions, by symbol, component and frame
};

}  // namespace rigor
