// SPDX-License-Identifier: GPL-3.0-or-later
// `\frac{h}{mc} \approx 2.43\times10^{-12}\,\mathrm m` "for the electron": letters to which the page gives no
// value stand for constants if their names or the words around allow it, the dimensions of the sides agree,
// and the digits that are shown do. All of this hardly agrees by chance, so it proves, and names the
// constants. That the digits do not agree refutes nothing, since the letters may be meant otherwise.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "check/constant/constant_units.h"
#include "check/constant/measured_row.h"
#include "check/constant/number_slip.h"
#include "check/doubt/borrowed.h"
#include "check/meaning/measured.h"
#include "check/row/named_members.h"
#include "check/row/row.h"

namespace rigor {
namespace {

constexpr std::size_t most_letters = 8;

/// What the page speaks of: in the paragraph of a row and the one before it, and in all that reaches it.
struct SpokenAround {
  std::string near;
  std::string far;
};

SpokenAround spoken_around(const RowPlace& place) {
  const Prose& prose = place.notes.prose;
  const ProseBeside& here = beside(place);
  const std::string own = spoken_words(here.lead) + spoken_words(here.tail);
  SpokenAround spoken{own, own + spoken_words(place.section)};
  for (const ProseSentence& each : prose.sentences) {
    if (!prose.sections.reaches(each.place, here.place)) continue;
    const std::string words = spoken_words(each.text);
    spoken.far += words;
    if (each.paragraph == here.paragraph || each.paragraph + 1 == here.paragraph) spoken.near += words;
  }
  return spoken;
}

/// A letter that has this name by itself, or whose constant the page calls by its words.
bool is_called(const ExprTree& tree, SymbolId letter, const PhysicalConstant& constant,
               const std::string& spoken) {
  return is_own_name(constant, tree.symbols[letter].name) || speaks_of(constant, spoken);
}

bool are_called(const ExprTree& tree, const MeasuredRow& row, const Assignment& constants,
                const std::string& spoken) {
  for (std::size_t k = 0; k < row.letters.size(); ++k) {
    if (!is_called(tree, row.letters[k], *constants[k], spoken)) return false;
  }
  return true;
}

/// Things near by that can be meant by m, q or R as well.
bool speaks_of_other_things(const std::string& near) {
  static constexpr auto things = std::to_array<std::string_view>(
      {"pion",      "kaon",    "deuteron",      "triton",    "nucleus", "nuclei", "atom", "molecule",
       "meson",     "boson",   "ion",           "tau",       "helium",  "planet", "moon", "star",
       "satellite", "crystal", "semiconductor", "effective", "reduced", "drop",   "dust"});
  return std::ranges::any_of(
      things, [&](std::string_view thing) { return near.find(spoken_words(thing)) != std::string::npos; });
}

/// Is it clear of which constants the row is made? One of them at least has a name that stands for nothing
/// else, or the page speaks of it; and m is the mass of what is spoken of near by. What orbits the sun may be
/// anywhere.
bool is_clear(const ExprTree& tree, const MeasuredRow& row, const Assignment& constants,
              const SpokenAround& spoken) {
  constexpr double celestial = 1e-4;
  bool called = false;
  for (std::size_t k = 0; k < row.letters.size(); ++k) {
    const std::string& name = tree.symbols[row.letters[k]].name;
    if (constants[k]->uncertainty > celestial && !is_own_name(*constants[k], name)) return false;
    const bool near = speaks_of(*constants[k], spoken.near) && !speaks_of_other_things(spoken.near);
    if (!is_usual_name(*constants[k], name) && !near) return false;
    called = called || is_called(tree, row.letters[k], *constants[k], spoken.far);
  }
  return called;
}

/// "On the Moon", "a muon is heavier than the electron": g and m can be those of another thing.
bool may_be_of_another_thing(const RowPlace& place, const MeasuredRow& row, const std::string& spoken) {
  const auto speaks = [&](std::string_view thing) {
    return spoken.find(spoken_words(thing)) != std::string::npos;
  };
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(row.letters,
                               [&](SymbolId each) { return place.tree.symbols[each].name == name; });
  };
  static constexpr auto worlds =
      std::to_array<std::string_view>({"moon", "mars", "jupiter", "venus", "planet"});
  static constexpr auto particles = std::to_array<std::string_view>({"electron", "muon"});
  return (has("g") && std::ranges::any_of(worlds, speaks)) ||
         (has("m") && std::ranges::count_if(particles, speaks) > 1);
}

/// Is the row proved by these constants? What may be read in several ways needs words, or holds in each.
bool is_settled(const RowPlace& place, const MeasuredRow& row, const Compared& found,
                const std::string& spoken) {
  if (found.fitting.empty() || may_be_of_another_thing(place, row, spoken)) return false;
  const Assignment& fitting = found.fitting.front();
  const bool single_digit = row.shown.digits < 2;
  if (single_digit && !are_called(place.tree, row, fitting, spoken)) return false;
  if (found.fitting.size() == found.possible.size()) return true;
  if (found.fitting.size() > 1) return false;
  for (std::size_t k = 0; k < row.letters.size(); ++k) {
    const bool open = std::ranges::any_of(
        found.possible, [&](const Assignment& other) { return other[k]->name != fitting[k]->name; });
    if (open && !is_called(place.tree, row.letters[k], *fitting[k], spoken)) return false;
  }
  return true;
}

/// Is it said in another section? There the letter may be another quantity.
bool is_said_elsewhere(const RowPlace& place, const NamedDefinition& named) {
  return !named.origin.directive &&
         !place.notes.prose.sections.reaches(named.origin.place, beside(place).place);
}

/// Without what other sections define. Was there anything?
bool forget_other_sections(const RowPlace& place, NameScope& scope) {
  const std::size_t before = scope.definitions.size();
  scope.definitions.erase_if([&](const NamedDefinition& named) { return is_said_elsewhere(place, named); });
  return scope.definitions.size() < before;
}

bool rests_on_other_sections(const RowPlace& place, const MeasuredRow& row) {
  const std::vector<SymbolId> reached = symbols_reached(place.tree, row.names.scope, {row.value});
  return std::ranges::any_of(row.names.scope.definitions, [&](const NamedDefinition& named) {
    return std::ranges::find(reached, named.definition.symbol) != reached.end() &&
           is_said_elsewhere(place, named);
  });
}

/// The number is another one, and it is clear of which constants it is made.
bool heed_other_number(RowPlace& place, const StepReading& step, const MeasuredRow& row,
                       const Compared& found, const SpokenAround& spoken, Judgement& judgement) {
  if (!found.fitting.empty() || found.possible.size() != 1 || row.shown.digits < 2 || place.is_stated ||
      judgement.verdict == Verdict::refuted)
    return false;
  const Assignment& constants = found.possible.front();
  if (!is_clear(place.tree, row, constants, spoken)) return false;
  const auto computed = measured_value(place.tree, row.names, row.value, values_of(row.letters, constants));
  const auto written = measured_value(place.tree, row.names, row.shown.side, {});
  if (!computed || !written || written->number == 0) return false;
  const auto names = with_constants(place.tree, row, constants);
  if (!names) return false;
  WrittenNumber number{std::string(place.tree.digits(row.shown.number)), 0,
                       computed->number / written->number};
  constexpr double hopeless = 1e4;      // another quantity is meant
  if (number.ratio <= 0) return false;  // the sign may be a matter of convention
  const double error =
      error_of(place.tree, row, constants, computed->number) + half_a_digit(place.tree, row, written->number);
  if (std::abs(computed->number - written->number) <= error) return false;
  const bool left = row.shown.side == row.claim.equation.left;
  const Span shown_span = left ? row.claim.left : row.claim.right;
  const std::string side = written_at(place, shown_span);
  const auto instead = with_right_number(side, number);
  if (!instead) return false;
  const auto slip = slip_of(number_in(side, number));
  const bool other_thing = !slip && std::abs(std::log10(number.ratio)) > std::log10(hopeless);
  if (other_thing) return false;
  const std::vector<std::string> uses = uses_of(place.tree, *names, row.claim);
  const std::string value = written_at(place, left ? row.claim.right : row.claim.left);
  constexpr double exchanged = 0.015;  // 2.34 is farther from 2.43 than roundings lead
  const bool far = is_far(number.ratio, row.shown.digits) ||
                   (slip == exchanged_digits && std::abs(number.ratio - 1) > exchanged);
  const bool suspect =
      slip && far && number_may_be_suspected(place, step, row.claim, !bare_letter(place.tree, row.value));
  judgement.verdict = suspect ? Verdict::suspect : Verdict::undecided;
  judgement.route = suspect ? "the constants give another number" : "";
  judgement.of_another_question = true;
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.uses = suspect ? uses : std::vector<std::string>{};
  std::vector<std::string> rests;
  for (std::string use : uses) {
    if (use.starts_with("convention: ")) use.erase(0, std::string_view("convention: ").size());
    rests.push_back(std::move(use));
  }
  std::string message = fmt::format("`{}` comes to `{}`", value, *instead);
  if (suspect) message += fmt::format(" ({})", *slip);
  judgement.diagnostics = {{suspect ? DiagnosticKind::suspect : DiagnosticKind::undecided,
                            row.claim.relation,
                            fmt::format("{}, if {}", message, fmt::join(rests, ", ")),
                            {},
                            {suspect ? "`rigor: law next` says that it is meant as it stands"
                                     : "a value that the page gives for a letter counts instead"}}};
  if (suspect) {
    const std::string relation = written_at(place, row.claim.relation);
    judgement.repairs = {{.on_left = left,
                          .statement = left ? fmt::format("{} {} {}", *instead, relation, value)
                                            : fmt::format("{} {} {}", value, relation, *instead),
                          .change = fmt::format("`{}` instead of `{}`", *instead, side),
                          .replaced = side,
                          .replacement = *instead}};
  }
  return true;
}

/// What displays say by `\approx`, of letters that nothing else gives a value. The last one counts. Are there
/// such letters?
bool add_rounded_values(const RowPlace& place, std::vector<GivenValue>& values) {
  const std::size_t before = values.size();
  const auto& rounded = place.above.rounded;
  for (auto each = rounded.rbegin(); each != rounded.rend(); ++each) {
    const bool known = std::ranges::find(values, each->letter, &GivenValue::letter) != values.end();
    if (!known && place.notes.prose.sections.reaches(each->place, beside(place).place))
      values.push_back({each->letter, each->number, each->name});
  }
  return values.size() > before;
}

void note_rounded_value(RowPlace& place, const StepReading& row, const Claim& claim) {
  const auto letter = bare_letter(place.tree, claim.equation.left);
  if (!claim.nearly || !letter || !is_measured(place.tree, claim.equation.right)) return;
  const std::string name = name_of_law(row.parsed.written.tag, claim.relation, place.sources, "value");
  place.found.rounded.push_back({*letter, claim.equation.right, name, beside(place).place});
}

}  // namespace

bool agrees_with_constants(RowPlace& place, const StepReading& row, const Claim& own, Judgement& judgement) {
  const bool open = judgement.verdict == Verdict::law || judgement.verdict == Verdict::undecided;
  if (!open || own.recorded != nullptr || own.equation.relation != Relation::equal || row.unsettled)
    return false;
  const Claim claim = with_plain_number(place.tree, own);
  const auto shown = number_shown(place.tree, place.names, claim);
  if (!shown || place.tree[claim.equation.left].rank != 0 || is_meant_for_all(place.tree, place.names, claim))
    return false;
  const ExprId value = shown->side == claim.equation.left ? claim.equation.right : claim.equation.left;
  const SpokenAround spoken = spoken_around(place);
  std::vector<GivenValue> values = values_above(place);
  const bool rounded = add_rounded_values(place, values);
  note_rounded_value(place, row, claim);
  std::vector<Names> ways;
  const auto add_way = [&](Names names, const std::vector<GivenValue>& lines) {
    ways.push_back(with_members(place, std::move(names), value, lines));
  };
  const std::vector<GivenValue> lines = said_of_letters(place);
  add_way(with_values(place, row.parsed, claim, values, false), lines);
  add_way(with_values(place, row.parsed, claim, values, true), lines);
  add_way(with_values(place, row.parsed, claim, values, false), said_of_letters(place, true));
  add_way(with_values(place, row.parsed, claim, values, false, false), {});
  Names own_section = with_values(place, row.parsed, claim, values, false);
  if (forget_other_sections(place, own_section.scope)) add_way(std::move(own_section), lines);
  Names exact = with_values(place, row.parsed, claim, values, false);
  if (forget_rounded_constants(place.tree, exact.scope, spoken.far)) add_way(std::move(exact), lines);
  std::optional<std::pair<MeasuredRow, Compared>> other;
  for (const Names& way : ways) {
    MeasuredRow measured{claim, *shown, value, way};
    measured.letters = letters_without_value(place.tree, measured.names, value);
    if ((measured.letters.empty() && !rounded) || measured.letters.size() > most_letters) continue;
    Compared found = compare_with_constants(place.tree, measured, spoken.far, place.options.cache);
    if (is_settled(place, measured, found, spoken.far)) {
      const auto names = with_constants(place.tree, measured, found.fitting.front());
      if (!names) continue;
      prove_by_numbers(place, row, own, uses_of(place.tree, *names, claim), "to the digits shown", judgement);
      return true;
    }
    if (!other && !found.possible.empty() && !rests_on_other_sections(place, measured))
      other.emplace(std::move(measured), std::move(found));
  }
  const bool bare = bare_letter(place.tree, value).has_value() && other &&
                    other->first.letters == std::vector{*bare_letter(place.tree, value)};
  return other && !bare && heed_other_number(place, row, other->first, other->second, spoken, judgement);
}

}  // namespace rigor
