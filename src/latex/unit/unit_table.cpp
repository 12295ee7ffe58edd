// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/unit_table.h"

#include <array>
#include <cstdint>
#include <string>

#include "base/ascii.h"

namespace rigor {
namespace {

/// A unit by its sign and its word in siunitx.
struct NamedUnit {
  std::string_view sign;
  std::string_view word;
  std::array<std::int8_t, 7> exponents;  // kg, m, s, A, K, mol, cd
  std::int64_t factor = 1;
  int ten = 0;
};

constexpr auto unit_table = std::to_array<NamedUnit>({
    {"g", "gram", {1}, 1, -3},
    {"m", "metre", {0, 1}},
    {"m", "meter", {0, 1}},
    {"s", "second", {0, 0, 1}},
    {"A", "ampere", {0, 0, 0, 1}},
    {"K", "kelvin", {0, 0, 0, 0, 1}},
    {"mol", "mole", {0, 0, 0, 0, 0, 1}},
    {"cd", "candela", {0, 0, 0, 0, 0, 0, 1}},
    {"N", "newton", {1, 1, -2}},
    {"J", "joule", {1, 2, -2}},
    {"W", "watt", {1, 2, -3}},
    {"Pa", "pascal", {1, -1, -2}},
    {"Hz", "hertz", {0, 0, -1}},
    {"C", "coulomb", {0, 0, 1, 1}},
    {"V", "volt", {1, 2, -3, -1}},
    {"F", "farad", {-1, -2, 4, 2}},
    {"\\Omega", "ohm", {1, 2, -3, -2}},
    {"S", "siemens", {-1, -2, 3, 2}},
    {"Wb", "weber", {1, 2, -2, -1}},
    {"T", "tesla", {1, 0, -2, -1}},
    {"H", "henry", {1, 2, -2, -2}},
    {"min", "minute", {0, 0, 1}, 60},
    {"h", "hour", {0, 0, 1}, 3600},
    {"d", "day", {0, 0, 1}, 86400},
    {"L", "litre", {0, 3}, 1, -3},
    {"l", "liter", {0, 3}, 1, -3},
    {"t", "tonne", {1}, 1000},
    {"bar", "bar", {1, -1, -2}, 1, 5},
    {"Å", "angstrom", {0, 1}, 1, -10},
    {"eV", "electronvolt", {1, 2, -2}, 1'602'176'634, -28},
    {"atm", "atmosphere", {1, -1, -2}, 101'325},
    {"mmHg", "mmHg", {1, -1, -2}, 133'322'387'415, -9},
    {"G", "gauss", {1, 0, -2, -1}, 1, -4},
    {"au", "astronomicalunit", {0, 1}, 149'597'870'700},
    {"AU", "au", {0, 1}, 149'597'870'700},
    {"ly", "lightyear", {0, 1}, 9'460'730'472'580'800},
    {"Bq", "becquerel", {0, 0, -1}},
    {"lm", "lumen", {0, 0, 0, 0, 0, 0, 1}},
    {"lx", "lux", {0, -2, 0, 0, 0, 0, 1}},
    {"days", "days", {0, 0, 1}, 86400},
    {"hours", "hours", {0, 0, 1}, 3600},
    {"minutes", "minutes", {0, 0, 1}, 60},
    {"seconds", "seconds", {0, 0, 1}},
    {"%", "percent", {}, 1, -2},
    {"rad", "radian", {}},
    {"sr", "steradian", {}},
});

struct Prefix {
  std::string_view sign;
  std::string_view word;
  int ten;
};

constexpr auto prefix_table = std::to_array<Prefix>({{"da", "deca", 1},
                                                     {"h", "hecto", 2},
                                                     {"k", "kilo", 3},
                                                     {"M", "mega", 6},
                                                     {"G", "giga", 9},
                                                     {"T", "tera", 12},
                                                     {"P", "peta", 15},
                                                     {"d", "deci", -1},
                                                     {"c", "centi", -2},
                                                     {"m", "milli", -3},
                                                     {"\\mu", "micro", -6},
                                                     {"µ", "micro", -6},
                                                     {"n", "nano", -9},
                                                     {"p", "pico", -12},
                                                     {"f", "femto", -15}});

/// A multiple such as the hour takes no prefix, but the electronvolt does; nor does a plural, or an angle.
bool takes_prefix(const NamedUnit& unit) {
  return (unit.factor == 1 || unit.sign == "eV") && unit.sign != "rad" && unit.sign != "sr" &&
         unit.sign != "seconds";
}

WrittenUnit unit_of(const NamedUnit& named, int ten = 0) {
  WrittenUnit unit;
  for (std::size_t k = 0; k < unit.exponents.size(); ++k) unit.exponents[k] = named.exponents[k];
  unit.factor = named.factor;
  unit.ten = named.ten + ten;
  return unit;
}

bool take_word(std::string_view& text, std::string_view word) {
  const bool fits = text.size() > word.size() && text[0] == '\\' && text.substr(1).starts_with(word) &&
                    (text.size() == word.size() + 1 || !is_letter(text[word.size() + 1]));
  if (fits) text.remove_prefix(word.size() + 1);
  return fits;
}

/// `\km`, `\us`, `\kohm`: a sign as a control, with `u` for µ. Those that TeX has for other things are none.
std::optional<WrittenUnit> take_unit_abbreviation(std::string_view& text) {
  std::size_t end = 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  if (text.empty() || text[0] != '\\' || end == 1) return std::nullopt;
  std::string sign(text.substr(1, end - 1));
  if (sign == "d" || sign == "t" || sign == "min" || sign == "H") return std::nullopt;
  if (sign.size() > 1 && sign[0] == 'u') sign.replace(0, 1, "µ");
  if (sign.ends_with("ohm")) sign.replace(sign.size() - 3, 3, "\\Omega");
  const auto unit = unit_by_sign(sign);
  if (unit) text.remove_prefix(end);
  return unit;
}

}  // namespace

std::optional<WrittenUnit> unit_by_sign(std::string_view sign) {
  for (const NamedUnit& named : unit_table) {
    if (named.sign == sign) return unit_of(named);
  }
  for (const Prefix& prefix : prefix_table) {
    if (!sign.starts_with(prefix.sign)) continue;
    for (const NamedUnit& named : unit_table) {
      if (takes_prefix(named) && named.sign == sign.substr(prefix.sign.size()))
        return unit_of(named, prefix.ten);
    }
  }
  return std::nullopt;
}

std::optional<WrittenUnit> take_unit_words(std::string_view& text) {
  int ten = 0;
  for (bool more = true; more;) {
    more = false;
    for (const Prefix& prefix : prefix_table) {
      if (!take_word(text, prefix.word)) continue;
      ten += prefix.ten;
      more = ten < 100 && ten > -100;
    }
  }
  if (take_word(text, "kilogram")) return unit_of(unit_table[0], ten + 3);
  for (const NamedUnit& named : unit_table) {
    if (take_word(text, named.word)) return unit_of(named, ten);
  }
  return ten == 0 ? take_unit_abbreviation(text) : std::nullopt;
}

}  // namespace rigor
