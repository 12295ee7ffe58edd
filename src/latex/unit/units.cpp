// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/ascii.h"
#include "latex/unit/unit_table.h"

namespace rigor {
namespace {

std::optional<WrittenUnit> dimension_by_letter(std::string_view letter) {
  static constexpr std::array<std::string_view, 3> letters{"M", "L", "T"};
  const auto found = std::ranges::find(letters, letter);
  if (found == letters.end()) return std::nullopt;
  WrittenUnit unit;
  unit.exponents[static_cast<std::size_t>(found - letters.begin())] = 1;
  return unit;
}

class UnitReader {
 public:
  UnitReader(std::string_view text, UnitNames names) : text_(text), names_(names) {}

  std::optional<WrittenUnit> read() {
    skip();
    if (done()) return fail("a unit is missing");
    while (!done()) {
      if (!factor()) return std::nullopt;
      skip();
    }
    if (open_) return fail("a bracket is not closed");
    return whole_;
  }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::nullopt_t fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
    return std::nullopt;
  }
  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  bool take(std::string_view part) {
    if (!text_.substr(at_).starts_with(part)) return false;
    at_ += part.size();
    return true;
  }

  /// What is between factors and says nothing.
  void skip() {
    static constexpr std::array<std::string_view, 10> between{" ", "\t",  "\n",  ".",   "~",
                                                              "*", "\\,", "\\;", "\\ ", "·"};
    while (std::ranges::any_of(between, [&](std::string_view part) { return take(part); }) ||
           take_control("cdot")) {
    }
  }

  bool take_control(std::string_view word) {
    const std::string_view rest = text_.substr(at_);
    const bool fits = rest.size() > word.size() && rest[0] == '\\' && rest.substr(1).starts_with(word) &&
                      (rest.size() == word.size() + 1 || !is_letter(rest[word.size() + 1]));
    if (fits) at_ += word.size() + 1;
    return fits;
  }

  bool factor() {
    if (take_control("per")) {
      divides_ = true;
      return true;
    }
    if (slashed_ && !open_ && !divides_) return fail("what follows `/` can be read in two ways"), false;
    if (take("/")) {
      slashed_ = true;
      divides_ = true;
      return true;
    }
    if (take("(")) {
      if (open_) return fail("brackets do not nest in a unit"), false;
      open_ = true;
      bracket_divides_ = std::exchange(divides_, false);
      return true;
    }
    if (open_ && take(")")) {
      open_ = false;
      bracket_divides_ = false;
      return true;
    }
    for (const auto& [word, exponent] : {std::pair{"square", 2}, std::pair{"cubic", 3}}) {
      if (take_control(word)) {
        before_ = exponent;
        return true;
      }
    }
    std::optional<WrittenUnit> unit = name();
    if (!unit) return false;
    SmallRational exponent = before_;
    before_ = 1;
    skip_braces();
    if (!exponent_behind(exponent)) return false;
    if (divides_ != bracket_divides_) exponent = exponent * SmallRational(-1);
    divides_ = false;
    return multiply(*unit, exponent);
  }

  void skip_braces() {
    while (take("}")) {
    }
  }

  bool exponent_behind(SmallRational& exponent) {
    if (take_control("squared")) exponent = exponent * SmallRational(2);
    if (take_control("cubed")) exponent = exponent * SmallRational(3);
    if (!take("^") && !take_control("tothe")) return true;
    const bool braced = take("{");
    const auto over = integer();
    if (!over) return fail("an exponent is missing"), false;
    SmallRational own = *over;
    if (braced && take("/")) {
      const auto under = integer();
      if (!under || *under == 0) return fail("an exponent is missing"), false;
      own = SmallRational(*over, *under);
    }
    if (braced && !take("}")) return fail("an exponent is neither a whole number nor a fraction"), false;
    exponent = exponent * own;
    skip_braces();
    return true;
  }

  std::optional<std::int64_t> integer() {
    const bool minus = take("-") || take("−");
    const std::size_t begin = at_;
    while (!done() && is_digit(text_[at_]) && at_ - begin < 3) ++at_;
    std::int64_t value = 0;
    if (begin == at_) return std::nullopt;
    std::from_chars(text_.data() + begin, text_.data() + at_, value);
    return minus ? -value : value;
  }

  /// `kg`, `\kilo\gram`, `\mathrm{kg}`, `1`.
  std::optional<WrittenUnit> name() {
    while (take_control("mathrm") || take_control("text") || take_control("textrm") || take_control("rm") ||
           take_control("unit") || take_control("si") || take("{") || take(" ")) {
    }
    if (take("1")) return WrittenUnit{};
    if (take("Å") || take_control("AA") || take_ring()) return unit_by_sign("Å");
    if (!done() && text_[at_] == '\\' && !text_.substr(at_).starts_with("\\mu") &&
        !text_.substr(at_).starts_with("\\Omega"))
      return word();
    const std::size_t begin = at_;
    if (take("µ") || take_control("mu")) take(" ");
    while (!done() && is_letter(text_[at_])) ++at_;
    if (!take_control("Omega")) static_cast<void>(take("Ω"));
    std::string sign(text_.substr(begin, at_ - begin));
    std::erase(sign, ' ');
    if (const auto ohm = sign.find("Ω"); ohm != std::string::npos) sign.replace(ohm, 2, "\\Omega");
    if (names_ == UnitNames::dimensions) {
      if (const auto dimension = dimension_by_letter(sign)) return dimension;
    }
    if (const auto unit = unit_by_sign(sign)) return unit;
    return fail(sign.empty() ? fmt::format("`{}` is not a unit", text_.substr(at_))
                             : fmt::format("`{}` is not a unit", sign));
  }

  /// `\mathring{A}`, `\mathring{\mathrm{A}}`
  bool take_ring() {
    const std::size_t begin = at_;
    if (take_control("mathring") || take_control("r")) {
      while (take("{") || take_control("mathrm") || take_control("text") || take(" ")) {
      }
      if (take("A")) return true;
    }
    at_ = begin;
    return false;
  }

  std::optional<WrittenUnit> word() {
    std::string_view rest = text_.substr(at_);
    const std::size_t before = rest.size();
    const auto unit = take_unit_words(rest);
    at_ += before - rest.size();
    if (unit) return unit;
    return fail(fmt::format("`{}` is not a unit", text_.substr(at_)));
  }

  bool multiply(const WrittenUnit& unit, const SmallRational& exponent) {
    for (std::size_t k = 0; k < unit.exponents.size(); ++k)
      whole_.exponents[k] = whole_.exponents[k] + unit.exponents[k] * exponent;
    if (unit.factor == SmallRational(1) && unit.ten == 0) return true;
    if (exponent.under() != 1) return fail("a root of a multiple of a unit is not read"), false;
    const std::int64_t times = exponent.over() < 0 ? -exponent.over() : exponent.over();
    constexpr int largest_power = 1'000;
    if (times > largest_power) return fail("a power of a unit is too large"), false;
    for (std::int64_t k = 0; k < times; ++k)
      whole_.factor = exponent.over() < 0 ? whole_.factor / unit.factor : whole_.factor * unit.factor;
    whole_.ten += unit.ten * static_cast<int>(exponent.over());
    if (std::abs(whole_.ten) > largest_power) return fail("a power of ten is too large"), false;
    if (!whole_.factor.is_valid()) return fail("a factor of a unit is too large"), false;
    return true;
  }

  std::string_view text_;
  UnitNames names_;
  std::size_t at_ = 0;
  WrittenUnit whole_;
  bool divides_ = false;  // the next factor
  bool slashed_ = false;  // nothing more may follow
  bool open_ = false;     // inside a bracket
  bool bracket_divides_ = false;
  SmallRational before_ = 1;  // \square
  std::string problem_;
};

}  // namespace

std::optional<WrittenUnit> read_unit(std::string_view text, UnitNames names, std::string* problem) {
  UnitReader reader(text, names);
  auto unit = reader.read();
  if (problem != nullptr) *problem = reader.problem();
  return unit;
}

bool is_unit_word(std::string_view text, bool spaced) {
  if (text.empty() || text == "1" || text == "d" || (text.size() == 1 && !spaced)) return false;
  return read_unit(text, UnitNames::units).has_value();
}

}  // namespace rigor
