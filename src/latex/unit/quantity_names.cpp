// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/quantity_names.h"

#include <algorithm>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "latex/token/vocabulary.h"
#include "latex/token/words.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

constexpr std::size_t most_words = 5;  // more are a sentence

/// They join, ask, deny, or say something of a quantity; or they stand for what is left out.
const WordSet& words_of_sentences() {
  static const WordSet words(R"(
      if for when whenever where with since because unless while until then than thus hence so therefore
      otherwise else elsewhere and or but not no only also as is are was were be being been has have had will
      would can could may might must should let define defined denote denotes given gives give assume assuming
      suppose say says see use using recall note that which who what how any some each every all both either
      neither we us our you your they it its here there now again such via cf eq eqn equation
      const cst cte konst constant constants konstante constante costante term terms other others rest etc
      similar order orders hot cc hc conj conjugate conjugated transpose transposed permutation permutations
      cyclic perm perms something anything nothing proof solution answer definition def yes)");
  return words;
}

/// What is left out of an equation, and another thing in each: `E_0 + \text{quantum corrections}`.
const WordSet& left_out() {
  static const WordSet words(R"(
      correction corrections derivative derivatives differential divergence integral integrals
      remainder remainders contribution contributions part parts piece pieces noise stuff
      error errors powers counterterm counterterms perturbation perturbations background effects)");
  return words;
}

/// What a quantity is. Some of them are nouns, too.
const WordSet& properties() {
  static const WordSet words(R"(
      true false unknown undefined finite infinite infinity nonzero zero none even odd integer real imaginary complex
      positive negative large small big huge tiny fixed conserved invariant arbitrary independent dependent
      maximum minimum maximal minimal high low increasing decreasing stationary steady exact approximate
      stable unstable linear nonlinear symmetric antisymmetric parallel perpendicular orthogonal same equal
      up down in out inside outside before after above below identity unity)");
  return words;
}

/// What is counted or measured in: `100\,\frac{\text{miles}}{\text{hour}}`.
const WordSet& counted() {
  static const WordSet words(R"(
      second minute hour hours day days week weeks month months year years yr yrs mile miles foot feet inch
      inches yard yards ft lb lbs pound pounds ounce ounces ton tons gram grams meter meters metre metres
      kilogram kilograms kilometer kilometers kilometre kilometres newton newtons joule joules watt watts
      volt volts amp amps ampere amperes ohm ohms kelvin kelvins pascal pascals hertz tesla coulomb coulombs
      degree degrees radian radians deg cal kcal calorie calories BTU Btu mph kph rpm psi dB dBm gal gallon
      gallons liter liters litre litres mole moles molecule molecules atom atoms ion ions photon photons
      particle particles electron electrons proton protons neutron neutrons nucleon nucleons person people
      dollar dollars cent cents cycle cycles rev revolution revolutions turn turns unit units percent percents
      ppm ppb kpc Mpc Gpc Gyr Myr kyr Torr torr amu Da molar times item items sample samples count counts bit
      bits byte bytes pixel pixels point points step steps event events decay decays USD EUR GBP Hz Ry Sv Gy Ci
      Bq AU MeV GeV keV TeV eV kWh MPa kPa GPa)");
  return words;
}

/// They act on what follows, or stand for a map, a matrix or a set.
const WordSet& acting() {
  static const WordSet words(R"(
      sgn sign sinc erf erfc Ker ker Im im Hom End Aut Id id Tr tr Lie Span span Res arg Arg argmin argmax
      CNOT SWAP QFT NOT AND OR XOR CZ DFT FFT FT Identity Ad ad Li Ei Si Ai Bi Var Cov Corr Vol Rot Sym Alt Pf
      lcm rank)");
  return words;
}

bool has_vowel(std::string_view word) { return word.find_first_of("aeiouAEIOU") != std::string_view::npos; }

bool is_capital(char c) { return is_capital_letter(c); }
bool is_any_letter(char c) { return is_letter(c); }
bool is_capitals(std::string_view word) { return std::ranges::all_of(word, is_capital); }

/// `mgh`, `nRT`, `dx`: short and in small letters, this is a product or a differential.
bool can_be_product(std::string_view word) {
  if (!is_small_letter(word.front())) return false;
  const bool mixed = std::ranges::any_of(word, is_capital);
  return word.size() < 4 || mixed || !has_vowel(word);
}

bool is_function(std::string_view word) {
  static const WordSet numbers("Re det determinant trace Trace");  // without an argument they name one
  const bool acts = !function_name(word).empty() || field_operator(word) || word == "rot";
  return (acts && !numbers.contains(word)) || acting().contains(word);
}

/// Letters, and `-` or `'` between them; all of an abbreviation with points.
bool is_word(std::string_view word) {
  const bool spelled =
      std::ranges::all_of(word, [](char c) { return is_letter(c) || c == '-' || c == '\''; });
  return spelled && is_letter(word.front()) && is_letter(word.back());
}

/// `K.E.` as `KE`; empty for anything else.
std::string abbreviated(std::string_view phrase) {
  std::string letters;
  for (std::size_t at = 0; at < phrase.size(); at += 2) {
    const bool point = at + 1 == phrase.size() ? !letters.empty() : phrase[at + 1] == '.';
    if (!is_capital_letter(phrase[at]) || !point) return {};
    letters += phrase[at];
  }
  return letters.size() > 1 ? letters : std::string();
}

bool is_counted(std::string_view word) {
  static const WordSet others("per light square cubic");
  return counted().contains(word) || counted().contains(lowered(word)) || others.contains(lowered(word)) ||
         is_unit_word(word, true);
}

bool is_name_alone(std::string_view word) {
  if (word.size() < 2 || can_be_product(word) || is_function(word)) return false;
  return !is_counted(word);
}

}  // namespace

bool can_name_quantity(std::string_view phrase) {
  if (const std::string letters = abbreviated(phrase); !letters.empty()) return can_name_quantity(letters);
  const std::vector<std::string_view> words = words_in(phrase);
  if (words.empty() || words.size() > most_words || !std::ranges::all_of(words, is_word)) return false;
  for (const std::string_view word : words) {
    const std::string low = lowered(word);
    if (words_of_sentences().contains(low) || left_out().contains(low)) return false;
    if (word.size() == 1 && word != "a") return false;  // a symbol
  }
  if (words.size() == 1) return is_name_alone(words.front());
  if (std::ranges::all_of(words, is_counted)) return false;  // "light years"
  static const WordSet prepositions("of in to from by on per at into onto the a an");
  return !prepositions.contains(lowered(words.front())) && !prepositions.contains(lowered(words.back()));
}

bool can_say_property(std::string_view phrase) { return properties().contains(lowered(phrase)); }

bool is_symbol_of_letters(std::string_view phrase) {
  if (!abbreviated(phrase).empty()) return true;
  constexpr std::size_t longest_capitals = 5;
  constexpr std::size_t longest_symbol = 3;
  if (phrase.empty() || !std::ranges::all_of(phrase, is_any_letter)) return false;
  return is_capitals(phrase) ? phrase.size() <= longest_capitals
                             : is_capital_letter(phrase.front()) && phrase.size() <= longest_symbol;
}

}  // namespace rigor
