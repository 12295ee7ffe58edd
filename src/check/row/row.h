// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of one row, in two steps: `ask` gets the answer of the exact side, and `settle` weighs it
// against the words around the row. Between the two, the walk looks whether the answer shows that a name has
// another meaning.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "check/law/from_laws.h"
#include "check/place/place.h"

namespace rigor {

[[nodiscard]] inline bool is_open(const Judgement& judgement) { return judgement.verdict != Verdict::proved; }

/// Nothing: the step has its verdict, by another reading or as a condition.
[[nodiscard]] std::optional<Judgement> ask(RowPlace& place, const StepReading& row, const Claim& claim,
                                           Step& step);
void settle(RowPlace& place, const StepReading& row, const Claim& claim, Judgement judgement, Step& step);
void accept(Judgement judgement, Step& step);

// --- alternatives.cpp: `a = 0 or b = 0`: one of several equations holds. It is proved if the product of
// all differences is 0.

bool proves_alternatives(RowPlace& place, const ParsedChain& parsed, Step& step);

// --- cases.cpp: Definitions that hold for a case only, at another place, or until their letter gets
// another meaning.

/// Do words of its sentence limit the display at hand to a case?
/// `demands`: also "must" and "satisfy", which say of operators what they are.
bool is_conditional(const RowPlace& place, bool demands = true);
/// The same, but for what is left out as small from there on: "for small angles".
bool is_of_a_passing_case(const RowPlace& place, bool demands);
/// Is its heading about a special case: "Electrostatics", "In vacuum"?
bool is_of_a_case(const RowPlace& place);
/// `f = e^{-x} \Rightarrow …` on one of several such lines of a display: each is a case of its own.
bool is_one_of_the_cases(const RowPlace& place, const ParsedChain& parsed);
/// Where proofs of a row are weighed.
Standpoint standpoint_of_proofs(RowPlace& place, const ParsedChain& parsed);
/// Takes a proof back that rests on a definition for another case, or on one that has been replaced since.
void heed_proof(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);

// --- digit_bounds.cpp: `\sqrt{19} = 4.3`: numbers that no sample gives exactly are compared by rational
// bounds.

/// `\approx` and rounded decimals: numbers agree to the digits shown, and nothing else fails where nothing is
/// small.
void heed_digits(RowPlace& place, const Claim& claim, Judgement& judgement);
void refute_by_digits(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);
/// A recorded refutation by bounds has no sample to put in, so the bounds are computed again.
bool replay_by_digits(RowPlace& place, const Claim& claim, Step& step);

// --- doubts.cpp: What a refuted row may mean if it is not an identity.

/// Why a verdict cannot stay, and what the author can do.
struct Doubt {
  std::string message;
  std::vector<std::string> help = {};
  DiagnosticKind kind = DiagnosticKind::restricted;
  Verdict verdict = Verdict::undecided;
};

void withdraw(Judgement& judgement, const Claim& claim, Doubt doubt);
// --- proofs.cpp: What the words and the relations around a row leave of its proof.

/// Is it said for numbers for which its sums and integrals, which the proof takes to exist, do not? "For $x >
/// 1$ the series $\sum x^n$", "for all $x$".
void heed_existence(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);
/// Basis vectors in rates are read as fixed; "the axes turn with the body" says something else.
[[nodiscard]] std::optional<Doubt> about_turning_axes(RowPlace& place, const Claim& claim);

/// The first reason why the row need not be wrong.
[[nodiscard]] std::optional<Doubt> doubt_of_refutation(RowPlace& place, const StepReading& row,
                                                       const Claim& claim);

// --- linked.cpp: Rows that hang on others of their line or sentence.

/// "where" is before it: it says what its left side is, also after that was used.
bool is_said_to_explain(const RowPlace& place, const ParsedChain& parsed);
/// `H = T + V` behind a row.
struct DefinitionBehind {
  const ParsedChain* chain = nullptr;
  bool said = false;  // "where" is before it; else it defines only what no row has had before
};
/// On the line of the row or, after "where", in the rest of its sentence.
std::vector<DefinitionBehind> definitions_behind(const RowPlace& place, const ParsedChain& parsed);
/// What the row is inferred from, where that cannot be taken for granted: it was not read.
std::string unread_premise(RowPlace& place, const ParsedChain& parsed);

// --- laws_above.cpp: What rows, and relations in lines of prose, leave to the rows below them.

/// Not what holds on its line only.
void leave_to_rows_below(RowPlace& place, const ParsedChain& parsed, const Equation& equation, Span relation,
                         Standing standing);
/// The same of a relation in a line of prose that names a quantity, "The combination $E = …$ does not
/// change", or says what a new letter is, "With $N = a^\dagger a$ this becomes". In its paragraph a problem
/// holds: "We solve $y'' = -y$ with $y(0) = 1$".
void leave_what_a_line_says(RowPlace& place, const SaidInLine& said);
/// "With $N = a^\dagger a$ this becomes"; not "For a sphere, let $V = …$", and not where another line says
/// something else of the letter.
[[nodiscard]] bool is_said_for_good(RowPlace& place, const SaidInLine& said, SymbolId letter);
/// The laws above that hold here, in the order of the notes; not the other links of its own chain.
/// `of_any_thing`: also `C = \epsilon A/d` of "Plates have" below the definition `C = Q/V`.
[[nodiscard]] Laws available_to(const RowPlace& place, const ParsedChain& parsed, bool of_any_thing = false);
/// Of these, what its sentence names: "From (2.1)".
[[nodiscard]] Laws named_beside(const RowPlace& place, const Laws& available);
/// "At the top", "the boundary condition is": words before a row that say it for a moment or a place.
[[nodiscard]] bool is_of_a_moment(const RowPlace& place);
/// `x(0) = x_0`, `u(h) = U`: it speaks of a moment or a place, and holds at all times. A letter alone beside
/// such a value is another name of it, also N of `N_1(0) = N`.
[[nodiscard]] bool is_about_values(const RowPlace& place, const Equation& equation);
/// `u(0) = u(h) = 0`: several values, and no link follows from the others.
[[nodiscard]] bool states_values(const RowPlace& place, const ParsedChain& parsed,
                                 const ChainReading& reading);
/// `x = 0`, `\phi = \phi_0`, `x_1 = x_2 + h` behind such words: it defines nothing, and has no rate.
[[nodiscard]] bool says_values_at_a_moment(const RowPlace& place, const Equation& equation);
/// "For instance": it holds where the example does.
[[nodiscard]] bool is_an_example(const RowPlace& place);

// --- page_laws.cpp: What follows from these laws.

/// What a row may be proved from.
struct Grounds {
  std::shared_ptr<const std::vector<PageLaw>> own;  // what its sentence says, and what is so by convention
  Laws of_its_sentence = {};                        // of these: they hold for this row only
  AvailableLaws all = {};
  AvailableLaws founded = {};  // without conclusions of which no proof was found
};

[[nodiscard]] Grounds grounds_of(RowPlace& place, const StepReading& row, const Claim& claim);
/// A conclusion that follows from nothing itself.
[[nodiscard]] bool is_open(const PageLaw& law);
/// As a conclusion: by its words, behind an arrow, or as a later link of a chain.
[[nodiscard]] bool is_announced(const RowPlace& place, const StepReading& row);
/// Proved from laws of the page, or said by one of them already; else the judgement stays as it is.
[[nodiscard]] bool follows_from_page(RowPlace& place, const StepReading& row, const Claim& claim,
                                     Judgement& judgement);
/// A law is left to the rows below, unless it is suspect. One that is announced as a conclusion is undecided:
/// it follows from nothing.
void state_law(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);

// --- suspects.cpp: What stands one slip of the pen away from a row that does not follow.

/// "In an incompressible fluid", "At $B$ we find": words of the sentence, the heading or the sentences around
/// it that may say the row for a case.
[[nodiscard]] bool may_be_of_a_case(const RowPlace& place, const ParsedChain& parsed);
/// One slip of the pen away from what follows, and nothing else can be meant. No row below rests on it.
[[nodiscard]] bool is_suspect(RowPlace& place, const StepReading& row, const Claim& claim,
                              Judgement& judgement);
/// Is what is near it asked for, if this becomes of it?
[[nodiscard]] bool is_told_what_is_near(const RowPlace& place, const StepReading& row, Verdict verdict);
/// What follows from the page near a row that is left open or suspect; of a law only where that is asked for.
/// Where the row shows a number, what agrees to its digits.
void offer_what_is_near(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);
/// The same of a row that cannot be read as it stands.
void offer_what_is_near_unread(const RowPlace& place, const StepReading& row, Step& step);

// --- sizes.cpp: Masses, radii and frequencies are positive.

/// That those of a claim are which the page calls so.
[[nodiscard]] std::vector<NamedAssumption> sizes_said(RowPlace& place, const Claim& claim);
/// The same with those of the laws around it, if roots or logarithms ask for signs.
[[nodiscard]] std::vector<NamedAssumption> sizes_that_matter(RowPlace& place, const StepReading& row,
                                                             const Claim& claim);
/// Proved if the letters that the page calls so are; else the judgement stays as it is.
[[nodiscard]] bool follows_for_sizes(RowPlace& place, const StepReading& row, const Claim& claim,
                                     Judgement& judgement);

/// Proved if what the words before it hold, "at constant temperature", is constant; else the judgement stays
/// as it is.
[[nodiscard]] bool follows_with_letters_held(RowPlace& place, const StepReading& row, const Claim& claim,
                                             Judgement& judgement);

// --- readings.cpp: Chains with places that can be read in two ways. All readings are decided, and only a
// verdict that all share counts.

/// Names both readings of the first such place.
[[nodiscard]] Diagnostic two_readings(const ParsedChain& parsed);
/// Without readings that are nonsense: if one is left, it is the only one; if none is, the first shows why.
ParsedChain sensible_readings(RowPlace& place, const ParsedChain& parsed);
/// Settles a row in which a letter can be part of a vector or a symbol of its own, or a bracket can be a
/// factor or an argument. As a symbol of its own it says the least: what is proved so holds in each reading.
/// A part of a vector proves as well, by the convention that it names; a factor does not. All else must be
/// the verdict of both.
void settle_in_both(RowPlace& place, const StepReading& row, const Claim& claim, Judgement judgement,
                    Step& step);
/// The verdict is the one that all readings have in common, if there is one.
void decide_in_all_readings(RowPlace& place, const StepReading& row, const Claim& claim, Step& step);

// --- remainders.cpp: `e^x = 1 + x + O(x^2)`: sides that are compared as power series.

/// `+ O(x^n)` ends the right side.
[[nodiscard]] bool is_up_to_order(const StepReading& row);
void decide_up_to_order(RowPlace& place, const StepReading& row, Step& step);

// --- slips.cpp: How the refuted rows of a chain hang together.

/// Says of each refuted step of a chain whether it is the first wrong one, what becomes of its slip, and
/// whether it only takes back an earlier one.
void explain_slips(RowPlace& place, const ParsedChain& parsed, ChainReading& reading, std::size_t first_step,
                   std::span<Step> steps);

// --- values.cpp: `U \approx 1.8\cdot10^{-6}\,\mathrm J`, where the page gives numbers for the letters of U.

/// Proved to the digits shown, or suspect; else the judgement stays as it is.
[[nodiscard]] bool agrees_with_values(RowPlace& place, const StepReading& row, const Claim& claim,
                                      Judgement& judgement);

// --- constants.cpp: `\frac{h}{mc} \approx 2.43\cdot10^{-12}\,\mathrm m`, where nothing but the names of the
// letters says which constants they are.

/// Proved to the digits shown, or suspect; else the judgement stays, with the number that would be right.
[[nodiscard]] bool agrees_with_constants(RowPlace& place, const StepReading& row, const Claim& claim,
                                         Judgement& judgement);

// --- surroundings.cpp: The words and conditions around a row, and what they leave of its verdict.

/// Is there an "or" next to it, on its line or in the prose between two displays?
bool is_alternative(const RowPlace& place, const ParsedChain& parsed);
/// `a > 0, \quad \sqrt{a^2} = a`: orders of letters on the line of an equation say when it holds.
std::vector<const ParsedChain*> conditions_beside(const RowPlace& place, const ParsedChain& parsed);
bool is_condition_beside(const RowPlace& place, const ParsedChain& parsed);
Standpoint standpoint(RowPlace& place, const ParsedChain& parsed);
/// Takes a refutation back that rests on something not said for this place; keeps laws for later rows.
void heed_surroundings(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);

}  // namespace rigor
