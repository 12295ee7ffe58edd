// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/sizes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/among.h"
#include "check/word/prose_behind.h"

namespace rigor {
namespace {

using Words = std::vector<std::string_view>;

/// "mass" of "mass" and of "masses". No energy, charge, speed, density or temperature: these may be negative,
/// or 0.
std::optional<std::string_view> size_named(std::string_view word) {
  static constexpr auto sizes =
      std::to_array<std::pair<std::string_view, std::string_view>>({{"mass", "masses"},
                                                                    {"radius", "radii"},
                                                                    {"diameter", "diameters"},
                                                                    {"length", "lengths"},
                                                                    {"width", "widths"},
                                                                    {"thickness", "thicknesses"},
                                                                    {"area", "areas"},
                                                                    {"volume", "volumes"},
                                                                    {"frequency", "frequencies"},
                                                                    {"wavelength", "wavelengths"},
                                                                    {"period", "periods"},
                                                                    {"resistance", "resistances"},
                                                                    {"capacitance", "capacitances"},
                                                                    {"inductance", "inductances"},
                                                                    {"permittivity", "permittivities"},
                                                                    {"permeability", "permeabilities"},
                                                                    {"viscosity", "viscosities"},
                                                                    {"stiffness", "stiffnesses"},
                                                                    {"semi-axis", "semi-axes"}});
  for (const auto& [one, several] : sizes) {
    if (word == one || word == several) return one;
  }
  return std::nullopt;
}

/// "a spring of spring constant $k$"; not "a constant $k$".
std::optional<std::string_view> size_at(const Words& words, std::size_t at) {
  if (at > 0 && words[at] == "constant" && is_one_of(words[at - 1], {"spring", "force", "gravitational"}))
    return "spring constant";
  if (at > 0 && is_one_of(words[at - 1], {"charge", "current", "energy", "probability", "momentum", "number",
                                          "unit", "per", "in", "focal", "scattering", "slip", "relative",
                                          "gauge", "excess", "flux", "spin"}))
    return std::nullopt;  // "the charge density $\rho$"
  return size_named(words[at]);
}

/// Between "$m$" and its noun: "is the", "(the reduced", "denotes a".
bool joins(std::string_view word) {
  return is_one_of(word, {"is",      "are",     "the",     "a",       "an",    "its",    "be",
                          "denotes", "being",   "reduced", "total",   "rest",  "inner",  "outer",
                          "angular", "natural", "(",       "uniform", "their", "plasma", "respective"});
}

bool is_verb(std::string_view word) { return is_one_of(word, {"is", "are", "be", "denotes", "being"}); }

bool is_list_sign(std::string_view word) { return is_one_of(word, {",", "and"}); }

class SizeReader {
 public:
  explicit SizeReader(const Words& words) : words_(words) {}

  std::vector<SaidSize> read() {
    std::size_t maths = 0;  // before the word at hand
    for (std::size_t at = 0; at < words_.size(); ++at) {
      if (words_[at] == "$") ++maths;
      const auto noun = size_at(words_, at);
      if (!noun) continue;
      if (at + 1 < words_.size() && words_[at + 1] == "$") {
        of_those_behind(at + 1, maths, *noun);
      } else {
        of_one_before(at, maths, *noun);
      }
    }
    return std::move(said_);
  }

 private:
  /// "masses $m_1$, $m_2$ and $m_3$"; "mass $m$ and $q$" says nothing of q.
  void of_those_behind(std::size_t at, std::size_t maths, std::string_view noun) {
    said_.push_back({maths++, noun});
    if (size_named(words_[at - 1]) == words_[at - 1]) return;  // of one
    for (std::size_t next = at + 1; next < words_.size() && is_list_sign(words_[next]);) {
      while (next < words_.size() && is_list_sign(words_[next])) ++next;
      if (next >= words_.size() || words_[next] != "$") return;
      said_.push_back({maths++, noun});
      ++next;
    }
  }

  /// "where $m$ is the mass and $\omega$ the angular frequency", "$R$ (the radius)"; not "$E$ of the mass".
  void of_one_before(std::size_t at, std::size_t maths, std::string_view noun) {
    const std::size_t last = at;
    bool verb = false;
    while (at > 0 && joins(words_[at - 1])) verb = is_verb(words_[--at]) || words_[at] == "(" || verb;
    if (at == last || at == 0 || words_[at - 1] != "$" || maths == 0) return;
    const bool in_a_list = at > 1 && is_one_of(words_[at - 2], {",", "and", "with"});
    if (verb || in_a_list) said_.push_back({maths - 1, noun});
  }

  const Words& words_;
  std::vector<SaidSize> said_;
};

}  // namespace

std::vector<SaidSize> said_sizes(std::string_view sentence) {
  const Words words = parts_of_sentence(sentence);
  return SizeReader(words).read();
}

bool is_positive_constant(std::string_view name) {
  return is_one_of(name, {"\\hbar", "\\epsilon_{0}", "\\mu_{0}", "k_{\\mathrm{B}}", "k_{B}"});
}

}  // namespace rigor
