// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/remarks.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ascii.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

/// A letter of any language.
bool is_of_word(char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80; }

/// Words that restrict nothing: they name an equation, its parts, or where it comes from.
const WordSet& harmless() {
  static const WordSet words(
      // what an equation is called
      "identity identities theorem lemma corollary proposition axiom rule rules law laws definition def "
      "property principle formula relation equation equations eq eqs eqn eqns proof check qed result "
      "distributive distributivity associative associativity commutative commutativity linearity "
      "bilinearity antisymmetry binomial quadratic triangle parallelogram product products quotient chain "
      "sum difference addition double half angle cosine cosines sine sines triple scalar vector tensor "
      "dot cross inner first second third "
      // where it comes from
      "by using use from see via cf recall note ref reference above expand expanding expanded contract "
      "contracting rename renaming relabel relabelling rearrange rearranging collect collecting simplify "
      "simplifying integrating parts the a an of this that is are its we have get find obtain "
      // what its parts are called
      "kinetic potential energy total mass torque momentum angular orbital spin inertia moment force "
      "forces work power charge current field flux velocity acceleration centrifugal centripetal gravity "
      "rotational translational rotation translation intrinsic part parts term terms twice half once "
      "vectors values indices numbers");
  return words;
}

/// People whose names equations bear, with a capital.
const WordSet& names() {
  static const WordSet people(R"(
      Ampere Ampère Archimedes Bernoulli Bessel Bianchi Binet Biot Bohr Born Carnot Cauchy Chasles Civita
      Clausius Coriolis Coulomb Dirac Doppler Einstein Euler Faraday Fourier Galilei Galileo Gauss Gibbs
      Green Hamilton Helmholtz Hooke Huygens Jacobi Kepler Kirchhoff Koenig König Kronecker Lagrange Laplace
      Legendre Leibniz Levi Lorentz Maclaurin Maxwell Minkowski Moivre Navier Newton Noether Ohm Parseval
      Pauli Poisson Poynting Pythagoras Rayleigh Rodrigues Savart Schwarz Schrödinger Steiner Stokes Taylor
      Torricelli Vieta)");
  return people;
}

/// Words between equations that only say that another one follows.
const WordSet& connectives() {
  static const WordSet words(R"(
      and or so thus hence therefore ie also while but giving gives which similarly it likewise now again
      finally follows consequently accordingly implies implying yields yielding then)");
  return words;
}

/// Joints after which something is concluded.
const WordSet& conclusions() {
  static const WordSet words(R"(
      so thus hence therefore giving gives follows consequently accordingly implies implying yields yielding
      then)");
  return words;
}

/// They bring in a condition, a case or a place.
const WordSet& openings() {
  static const WordSet words(R"(
      if for when whenever where with at in on as inside outside within near beyond behind below under during
      along across across between while assuming provided given since because valid whose only)");
  return words;
}

/// Next to an equation they can turn it into another statement: they deny it, go on with it, or are units.
const WordSet& altering() {
  static const WordSet words(R"(
      not no never none nor neither non isn doesn don cannot wrong wrongly false incorrect incorrectly untrue
      invalid fail fails failed mistake error counterexample or instead rather versus vs than
      plus minus times squared cubed over per divided multiplied half mod modulo conj conjugate transposed
      const percent dozen ft foot feet inch inches lb lbs mph mile miles yard yards erg ergs gauss
      dyn dyne cal kcal eV keV MeV GeV TeV year years yr amu au ly pc atm mmHg rpm deg degree degrees)");
  return words;
}

/// What `for all` may take for granted.
const WordSet& quantified() {
  static const WordSet words(R"(
      vectors vector scalars scalar values value indices index numbers tensors times points of and particles
      the)");
  return words;
}

const WordSet& greek() {
  static const WordSet letters(R"(
      alpha beta gamma delta epsilon varepsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau phi
      varphi chi psi omega pi)");
  return letters;
}

/// Words in a row, `'s` left out, `i.e.` as one; styles of letters and references are no words.
struct Spoken {
  std::vector<std::string> words;
  bool foreign = false;  // a sign stands among them that no sentence has: `<`, `=`
};

std::string_view control_at(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  return text.substr(at + 1, end - at - 1);
}

/// The place after `\eqref{eq:1}`, `\mathbf`, `\,`; `at` itself for the control of a letter.
std::size_t behind_silent_control(std::string_view text, std::size_t at) {
  static const WordSet references("eqref ref cite cref autoref");
  static const WordSet styles(R"(
      mathbf boldsymbol bm vec hat mathrm text textbf textit emph rm it bf quad qquad mbox mathsf)");
  const std::string_view name = control_at(text, at);
  const std::size_t behind = at + 1 + name.size();
  if (name.empty()) return std::min(at + 2, text.size());
  if (styles.contains(name)) return behind;
  if (!references.contains(name)) return at;
  const auto close = text.find('}', behind);
  return close == std::string_view::npos ? behind : close + 1;
}

Spoken spoken_in(std::string_view text) {
  static constexpr std::string_view signs = " .,;:()[]{}-+'`!?$~_&\"/";
  Spoken spoken;
  std::string word;
  const auto finish = [&] {
    if (!word.empty()) spoken.words.push_back(std::exchange(word, {}));
  };
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\\') {
      finish();
      const std::size_t behind = behind_silent_control(text, at);
      at = behind == at ? at + 1 : behind;
      continue;
    }
    const bool letter = is_of_word(text[at]);
    const bool digit = is_digit(text[at]);
    if (letter || digit) {
      word += text[at++];
      continue;
    }
    spoken.foreign = spoken.foreign || signs.find(text[at]) == std::string_view::npos;
    const bool abbreviated = text[at] == '.' && word.size() == 1 && at + 1 < text.size() &&
                             is_of_word(text[at + 1]);  // i.e., e.g.
    const bool possessive = text[at] == '\'' && text.substr(at, 2) == "'s" &&
                            (at + 2 == text.size() || !is_of_word(text[at + 2]));
    if (!abbreviated) finish();
    at += possessive ? 2 : 1;
  }
  finish();
  return spoken;
}

bool is_number(const std::string& word) {
  return std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_symbol(const std::string& word) {
  return (word.size() == 1 && !is_number(word)) || greek().contains(word);
}

/// "no sum", "no summation over repeated indices", "(not summed on j)".
bool says_no_sum(const std::vector<std::string>& words) {
  static const WordSet negations("no not without never");
  static const WordSet sums("sum sums summed summation summing");
  static const WordSet rest(R"(
      over on in for the index indices repeated and or here implied intended convention)");
  std::size_t at = 0;
  if (words.size() > 1 && (words[0] == "with" || words[0] == "but" || words[0] == "and")) ++at;
  if (at + 1 >= words.size() || !negations.contains(words[at])) return false;
  const bool implied = words[at + 1] == "implied" || words[at + 1] == "einstein";
  at += implied ? 2 : 1;
  if (at >= words.size() || !sums.contains(words[at])) return false;
  return std::all_of(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end(),
                     [](const std::string& word) { return is_symbol(word) || rest.contains(word); });
}

/// "and cyclic permutations of 1, 2, 3", "plus cyclic", "etc."; other letters than those of the axes are
/// another statement.
bool says_cyclic(const std::vector<std::string>& words) {
  static const WordSet cyclic("cyclic cyclical cyclically cyc cycl");
  static const WordSet rest(R"(
      permutations permutation permuted perm perms of the indices axes labels subscripts components thereof
      for other others 1 2 3 rest)");
  if (words.size() == 1) return words[0] == "etc";
  if (words.size() < 2 || (words[0] != "and" && words[0] != "plus")) return false;
  if (words.size() == 2 && words[1] == "etc") return true;
  return cyclic.contains(words[1]) &&
         std::all_of(words.begin() + 2, words.end(), [](const std::string& word) {
           return rest.contains(word) || word == "x" || word == "y" || word == "z";
         });
}

/// "for all vectors", "for every $i$".
bool says_for_all(const std::vector<std::string>& words) {
  static const WordSet all("all any every each");
  if (words.size() < 3 || words[0] != "for" || !all.contains(words[1])) return false;
  return std::all_of(words.begin() + 2, words.end(),
                     [](const std::string& word) { return is_symbol(word) || quantified().contains(word); });
}

}  // namespace

Remark remark_of(const std::string& words) {
  const Spoken spoken = spoken_in(words);
  if (spoken.foreign) return Remark::unread;
  std::vector<std::string> low;
  for (const std::string& word : spoken.words) low.push_back(lowered(word));
  if (says_no_sum(low)) return Remark::no_sum;
  if (says_cyclic(low)) return Remark::cyclic;
  if (says_for_all(low)) return Remark::quantifier;
  bool joins = false;
  bool names_it = low.empty();
  for (std::size_t k = 0; k < low.size(); ++k) {
    const bool joint = connectives().contains(low[k]);
    const bool known = harmless().contains(low[k]) || names().contains(spoken.words[k]);
    if (!joint && !known && !is_number(low[k]) && !is_symbol(spoken.words[k])) return Remark::unread;
    joins = joins || joint;
    names_it = names_it || known || is_number(low[k]);
  }
  if (joins) return Remark::connective;
  return names_it ? Remark::remark : Remark::unread;
}

bool concludes(const std::string& words) {
  return std::ranges::any_of(spoken_in(words).words,
                             [](const std::string& word) { return conclusions().contains(lowered(word)); });
}

bool opens_a_condition(const std::string& words) {
  const Spoken spoken = spoken_in(words);
  return !spoken.words.empty() && openings().contains(lowered(spoken.words.front()));
}

bool can_only_restrict(const std::string& words) {
  const Spoken spoken = spoken_in(words);
  if (words.find_first_of("?!") != std::string::npos) return false;
  if (spoken.foreign && !opens_a_condition(words)) return false;
  const bool named = std::ranges::any_of(
      spoken.words, [](const std::string& word) { return word.size() > 1 && is_of_word(word[0]); });
  return named && std::ranges::none_of(spoken.words, [](const std::string& word) {
           return altering().contains(word) || altering().contains(lowered(word));
         });
}

bool stands_apart(const std::string& words) {
  static constexpr std::string_view openings = "([,;:";
  const auto first = words.find_first_not_of(" ~");
  if (first == std::string::npos || openings.find(words[first]) != std::string_view::npos) return true;
  const Spoken spoken = spoken_in(words);
  static const WordSet sources("by using from see via cf for");
  return !spoken.words.empty() && sources.contains(lowered(spoken.words[0]));
}

std::set<std::string> symbols_in_words(const std::string& words) {
  std::set<std::string> symbols;
  for (const std::string& word : spoken_in(words).words) {
    if (is_symbol(word) && word != "a" && word != "A") symbols.insert(word);
  }
  return symbols;
}

}  // namespace rigor
