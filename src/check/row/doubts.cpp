// SPDX-License-Identifier: GPL-3.0-or-later
// What else a refuted step may mean: a condition that its words say, an equation for its letters, another
// constant of integration, terms that an average drops, another unit, one of several alternatives.
#include "check/meaning/any_matrix.h"
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/among.h"
#include "base/ascii.h"
#include "check/constant/natural_units.h"
#include "check/doubt/digits.h"
#include "check/doubt/equation_of_letters.h"
#include "check/doubt/named_elements.h"
#include "check/doubt/own_units.h"
#include "check/doubt/spins.h"
#include "check/law/state_facts.h"
#include "check/place/place.h"
#include "check/prose/open_words.h"
#include "check/prose/other_case.h"
#include "check/question/base_letters.h"
#include "check/repair/free_constant.h"
#include "check/repair/missing_condition.h"
#include "check/scope/definition.h"
#include "check/scope/local_kinds.h"
#include "check/word/prose_words.h"
#include "expr/tree/path.h"

namespace rigor {
namespace {

Doubt doubt(std::string message, std::string help) {
  return {.message = std::move(message), .help = {std::move(help)}};
}

bool has_slip(const std::vector<Repair>& repairs) {
  return std::ranges::any_of(repairs, [](const Repair& repair) { return !repair.adds_a_term; });
}

/// An integral sign up to here, or a word of what is integrated or solved.
bool speaks_of_integration(const RowPlace& place) {
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  for (std::size_t k = 0; k <= place.event; ++k) {
    if (!place.notes.prose.sections.reaches(place.notes.prose.beside[k].place, beside.place)) continue;
    const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (place.sources.text(chain.written.span).find("\\int") != std::string_view::npos) return true;
    }
  }
  const auto says = [](std::string_view text) {
    return text.find("integrat") != std::string_view::npos ||
           text.find("antiderivative") != std::string_view::npos ||
           text.find("primitive") != std::string_view::npos ||
           text.find("general solution") != std::string_view::npos ||
           text.find("differential equation") != std::string_view::npos ||
           text.find("integral") != std::string_view::npos;
  };
  if (says(beside.lead) || says(beside.tail)) return true;
  return std::ranges::any_of(place.notes.prose.sentences, [&](const ProseSentence& each) {
    return each.number < beside.sentence && place.notes.prose.sections.reaches(each.place, beside.place) &&
           says(each.text);
  });
}

/// A single sign, number, letter or index: of an exchange or another function there are so many that one of
/// them explains nearly everything.
std::vector<Repair> likely_repairs(RowPlace& place, const WrongStep& wrong) {
  const NeighbourProof proof = [&](ExprTree& tree, const Names& names, const Claim& claim,
                                   Slip slip) -> std::optional<std::vector<std::string>> {
    if (slip >= Slip::indices_exchanged) return std::nullopt;
    Judgement judgement = judge(tree, names, claim, limits_of_candidates, place.options.cache);
    if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
    return std::move(judgement.uses);
  };
  std::vector<Repair> repairs;
  for (TrueNeighbour& each : true_neighbours(place.tree, place.names, wrong, proof, place.options.cache))
    if (!adds_an_unusual_term(each.repair)) repairs.push_back(std::move(each.repair));
  return repairs;
}

// --- each of these: why a refutation may not stay, if that is so

std::optional<Doubt> about_written_zeros(RowPlace& place, const StepReading& row, const Claim& claim) {
  const bool zeros = claim.equation.relation == Relation::unequal &&
                     place.tree.is_zero_literal(row.left().typed->id) &&
                     place.tree.is_zero_literal(row.right().typed->id) &&
                     written_at(place, claim.left) != written_at(place, claim.right);
  if (!zeros) return std::nullopt;
  return Doubt{.message = "it may be about how two zeros are written"};
}

bool is_number_alone(const ExprTree& tree, ExprId side) {
  return tree[side].op == Op::number ||
         (tree[side].op == Op::negate && is_number_alone(tree, tree.children(side)[0]));
}

std::optional<Doubt> of_named_elements(RowPlace& place, const StepReading&, const Claim& claim) {
  if (is_meant_for_all(place.tree, place.names, claim) || !may_multiply_elements(place.tree, claim.equation))
    return std::nullopt;
  return doubt("its indices can number the elements of an algebra, and then it says how these are multiplied",
               "`rigor: claim …` asks whether it holds for all components");
}

std::optional<Doubt> of_spins(RowPlace& place, const StepReading& row, const Claim&) {
  const std::vector<SyntaxId>& sides = row.parsed.sides;
  if (!may_combine_spins(place.notes.syntax, sides[row.which], sides[row.which + 1])) return std::nullopt;
  return Doubt{.message = "it can say which spins the spins of a product make together"};
}

/// `\hat{\mathbf X}` and `\hat{\mathbf Y}`: of a basis that nobody introduces.
std::optional<Doubt> of_a_basis(RowPlace& place, const StepReading& row, const Claim&) {
  std::set<std::string> axes;
  for (const ExprId side : {row.left().typed->id, row.right().typed->id}) {
    for (const SymbolId each : symbols_in(place.tree, side)) {
      const Symbol& symbol = place.tree.symbols[each];
      if (symbol.rank == 1 && is_one_of(symbol.name, {"\\hat{X}", "\\hat{Y}", "\\hat{Z}"}))
        axes.insert(symbol.name);
    }
  }
  if (axes.size() < 2) return std::nullopt;
  return doubt(fmt::format("`{}` can be vectors of one basis", fmt::join(axes, "` and `")),
               "`\\hat x`, `\\hat y` and `\\hat z` are read so");
}

/// `1\,\text{F} = 10^{-15}\,\text{m}`, or a row with such a unit.
std::optional<Doubt> of_a_unit_of_the_notes(RowPlace& place, const StepReading& row, const Claim& claim) {
  const auto units_in = [&](ExprId side) {
    std::set<SymbolId> found;
    for (const SymbolId each : symbols_in(place.tree, side)) {
      if (place.tree.symbols[each].unit_of_measure) found.insert(each);
    }
    return found;
  };
  // `1\,\mathrm{km} = 100\,\mathrm m` is about the unit that is known.
  if (units_in(claim.equation.left) == units_in(claim.equation.right)) return std::nullopt;
  std::set<std::string> units;
  const auto note = [&](std::optional<std::string> unit) {
    if (unit) units.insert(*std::move(unit));
  };
  for (std::size_t k = 0; k <= place.event; ++k) {
    const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[k]);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (chain.written.sides.size() == 2)
        note(unit_introduced(text_of(chain.written.sides[0].tokens), text_of(chain.written.sides[1].tokens)));
    }
  }
  for (const SaidInLine& said : place.notes.prose.said) {
    if (said.before <= place.event) note(unit_introduced_in(place.sources.text(said.span)));
  }
  const std::string text = written_at(place, row.parsed.written.span);
  const auto own =
      std::ranges::find_if(units, [&](const std::string& unit) { return writes_unit(text, unit); });
  if (own == units.end()) return std::nullopt;
  return Doubt{.message =
                   fmt::format("the notes say what the unit `{}` is, so it can be another one than the "
                               "one that is known by this sign",
                               *own)};
}

/// `0 = 12`: nobody miscalculates that.
std::optional<Doubt> of_a_contradiction(RowPlace& place, const StepReading& row, const Claim& claim) {
  const ExprId left = row.left().typed->id;
  const ExprId right = row.right().typed->id;
  const bool zero = place.tree.is_zero_literal(left) || place.tree.is_zero_literal(right);
  const bool alone = zero && claim.equation.relation == Relation::equal && row.parsed.sides.size() == 2 &&
                     is_number_alone(place.tree, left) && is_number_alone(place.tree, right);
  if (!alone) return std::nullopt;
  return Doubt{.message = "it is false for all values: it may say that what stands above has no solution",
               .help = {"`rigor: claim …` asks whether it holds"}};
}

bool speaks_of_units(const ExprTree& tree, ExprId side) {
  const std::vector<SymbolId> symbols = symbols_in(tree, side);
  return std::ranges::any_of(
      symbols, [&](SymbolId symbol) { return tree.symbols[symbol].unit_of_measure.has_value(); });
}

std::optional<Doubt> with_a_unit_missing(RowPlace& place, const StepReading& row, const Claim&) {
  const ExprId left = row.left().typed->id;
  const ExprId right = row.right().typed->id;
  const bool left_units = speaks_of_units(place.tree, left);
  if (left_units == speaks_of_units(place.tree, right)) return std::nullopt;
  const std::vector<SymbolId> bare = symbols_in(place.tree, left_units ? right : left);
  const bool is_number =
      std::ranges::all_of(bare, [&](SymbolId each) { return place.tree.symbols[each].circle_number; });
  if (!is_number) return std::nullopt;
  return Doubt{.message = "one side has a unit, and the other is a number without one"};
}

std::optional<Doubt> in_natural_units(RowPlace& place, const StepReading&, const Claim& claim) {
  if (!may_have_natural_units(place.tree, place.names, claim.equation)) return std::nullopt;
  return Doubt{.message =
                   "an energy in electronvolts may stand for a mass, a time or a temperature, which has "
                   "another dimension"};
}

/// `\begin{pmatrix} … \end{pmatrix} = 3`: a multiple of the unit matrix, or something made of the matrix.
bool is_matrix_against_number(const ExprTree& tree, const Typed& left, const Typed& right) {
  const auto is_written_out = [&](const Typed& side) {
    return side.rank == 2 && tree[side.id].op == Op::tuple;
  };
  return (is_written_out(left) && right.rank == 0 && !tree.is_zero_literal(right.id)) ||
         (is_written_out(right) && left.rank == 0 && !tree.is_zero_literal(left.id));
}

std::optional<Doubt> of_a_matrix_and_a_number(RowPlace& place, const StepReading& row, const Claim&) {
  if (!is_matrix_against_number(place.tree, *row.left().typed, *row.right().typed)) return std::nullopt;
  return Doubt{
      .message =
          "one side is a matrix, and the number on the other can be a multiple of the unit matrix, or "
          "belong to the matrix in another way",
      .help = {"write the unit matrix, or `\\det`, `\\operatorname{tr}` or what else is meant"},
      .kind = DiagnosticKind::ambiguous_reading,
      .verdict = Verdict::not_understood};
}

/// "Set `U = 0` … Thus `U = \begin{pmatrix} 2 & 3 …`": a calculation gives its letter one value after the
/// other.
bool takes_another_value(const RowPlace& place, const Typed& left, const Typed& right) {
  const auto is_value = [&](ExprId id) { return symbols_in(place.tree, id).empty(); };
  const ExprNode& node = place.tree[left.id];
  if (node.op != Op::symbol || node.slot_count > 0 || !is_value(right.id)) return false;
  const NamedDefinition* named = definition_of(place.names.scope, node.symbol);
  if (named == nullptr || named->origin.directive || !is_value(named->definition.body)) return false;
  const std::string lead = lowered(place.notes.prose.beside[named->origin.event].lead);
  return std::ranges::any_of(words_of(lead), [](std::string_view word) {
    return is_one_of(word, {"set", "start", "starting", "begin", "initialize", "initialise", "initially",
                            "initial", "guess"});
  });
}

std::optional<Doubt> of_another_value(RowPlace& place, const StepReading& row, const Claim&) {
  if (!takes_another_value(place, *row.left().typed, *row.right().typed)) return std::nullopt;
  return Doubt{.message = "its letter had another value before, with which a calculation began"};
}

std::optional<Doubt> among_alternatives(RowPlace& place, const StepReading& row, const Claim&) {
  if (!is_alternative(place, row.parsed)) return std::nullopt;
  return Doubt{.message = "it is only one of several alternatives"};
}

/// The letter by which it fails, and would not if it were read by what its own section says.
std::optional<std::string> letter_borrowed_for(RowPlace& place, const StepReading& row, const Claim& claim) {
  const LocalKinds local(place.notes, place.names, place.event);
  add_used(place, local.used());
  const auto letter = local.borrowed_letter(place.notes.syntax, row.parsed);
  if (!letter) return std::nullopt;
  for (const UseDirective& use : place.above.uses) {
    const bool here =
        place.notes.prose.sections.reaches(use.place, place.notes.prose.beside[place.event].place);
    if (!here || !is_one_of(*letter, use.letters)) continue;
    place.found.used.insert(use.directive);
    return std::nullopt;
  }
  const auto reading = read_here(place, row.parsed);
  if (!reading->sides[row.which].typed || !reading->sides[row.which + 1].typed) return letter;
  Diagnostics ignored;
  const auto other = reading->claim(row.parsed, row.which, claim.nearly, ignored);
  if (!other || judge_here(place, *other).verdict != Verdict::refuted) return letter;
  return std::nullopt;
}

std::optional<Doubt> by_a_borrowed_letter(RowPlace& place, const StepReading& row, const Claim& claim) {
  const auto letter = letter_borrowed_for(place, row, claim);
  if (!letter) return std::nullopt;
  return Doubt{.message = fmt::format("it fails only where `{}` is read as in another section", *letter),
               .help = {fmt::format("`rigor: use {}` says that it is meant so here, too", *letter)},
               .kind = DiagnosticKind::borrowed};
}

std::optional<Doubt> of_special_matrices(RowPlace& place, const StepReading&, const Claim& claim) {
  const auto why = why_not_all_matrices(place.tree, place.names, claim.equation);
  if (!why) return std::nullopt;
  return doubt(
      "it does not hold for all matrices, and " + *why,
      "`rigor: given …` states what is assumed of them, such as `A^T = A`; \"let $A$ be a matrix\" says "
      "that any is meant");
}

/// It is true with another sign, factor or letter: then a slip is likelier than another meaning.
std::optional<Doubt> for_other_values(RowPlace& place, const StepReading& row, const Claim& claim) {
  if (is_meant_for_all(place.tree, place.names, claim) || is_about_matrices(place.tree, claim.equation))
    return std::nullopt;
  const WrongStep wrong{.parsed = row.parsed, .which = row.which, .first_order = row.first_order};
  const std::string_view lead = place.notes.prose.beside[place.event].lead;
  std::optional<std::vector<Repair>> known;
  const auto repairs = [&]() -> const std::vector<Repair>& {
    if (!known) known = likely_repairs(place, wrong);
    return *known;
  };
  const auto word = open_word(place.notes.prose, place.event);
  const std::vector<std::string> conditions =
      missing_conditions(place.tree, place.names, wrong, place.options.cache);
  const auto weights = std::ranges::find_if(conditions, is_sum_of_weights);
  if (!conditions.empty() && (word || weights != conditions.end()) && !has_slip(repairs())) {
    if (word)
      return doubt(
          fmt::format("it does not hold for all values; it holds if `{}`, and `{}` next to it may say so",
                      conditions.front(), *word),
          "`rigor: given …` states this condition; `rigor: claim …` asks whether the step holds without it");
    return doubt(
        fmt::format("it does not hold for all values; it holds if `{}`", *weights),
        "`rigor: given …` states this condition; `rigor: claim …` asks whether the step holds without it");
  }
  if (const auto dropped = word_of_dropped_terms(place.notes.prose, place.event);
      dropped && !has_slip(repairs()))
    return doubt(
        fmt::format("it does not hold for all values, and `{}` next to it may say which terms vanish",
                    *dropped),
        "`rigor: claim …` asks whether it holds for all values");
  if (speaks_of_integration(place)) {
    if (const auto letter = absorbing_constant(place.tree, place.names, wrong, place.options.cache))
      return doubt(
          fmt::format("it holds with another constant `{}` on the right, and a constant of integration may "
                      "absorb factors",
                      *letter),
          "use another letter for the second constant; `rigor: claim …` asks whether it holds as written");
  }
  if (row.which == 0 && row.parsed.written.relations.size() == 1 &&
      may_be_an_equation_of_letters(place.tree, claim.equation) && !announces_an_identity(lead) &&
      (names_an_equation_of_letters(lead) ||
       (!reads_as_identity(place.tree, claim.equation) && repairs().empty())))
    return doubt(
        "it does not hold for all values, and no small slip explains that: it may say which values are meant",
        "`rigor: claim …` asks whether it holds for all values; so does `hence` or `identity` in its "
        "sentence");
  return std::nullopt;
}

std::optional<Doubt> of_degrees_alone(RowPlace& place, const StepReading&, const Claim& claim) {
  if (!has_degrees_alone(place.tree, place.names, claim.equation)) return std::nullopt;
  return Doubt{.message = "the degrees can be those of a temperature, or whole turns may be left out",
               .help = {"beside π or an inverse function they are angles"}};
}

/// `dL = I\,d\omega` of `L = I\omega`: the differentials that it does not write may be 0 here.
std::optional<Doubt> of_letters_held(RowPlace& place, const StepReading&, const Claim& claim) {
  ExprTree& tree = place.tree;
  if (!has_differentials(tree, claim.equation)) return std::nullopt;
  std::set<SymbolId> written;
  for (const ExprId side : {claim.equation.left, claim.equation.right}) {
    for (const SymbolId each : symbols_in(tree, side)) {
      if (is_differential(tree.symbols, each)) written.insert(base_of(tree.symbols, each));
    }
  }
  Names held = place.names;
  std::vector<std::string> letters;
  for (const SymbolId letter : base_letters(tree, place.names.scope, claim.equation)) {
    const Symbol& symbol = tree.symbols[letter];
    if (written.contains(letter) || symbol.is_fixed() ||
        definition_of(place.names.scope, letter) != nullptr ||
        is_declared_constant(place.names.scope, letter))
      continue;
    declare_constant(held.scope, letter, std::nullopt);
    letters.push_back(fmt::format("`{}`", symbol.name));
  }
  if (letters.empty() ||
      judge(tree, held, claim, limits_of_candidates, place.options.cache).verdict != Verdict::proved)
    return std::nullopt;
  return Doubt{.message = fmt::format("it holds if {} {} not change here, and nothing says so",
                                      fmt::join(letters, " and "), letters.size() == 1 ? "does" : "do"),
               .help = {"`rigor: claim …` asks whether it holds for all changes"}};
}

/// `(\partial p/\partial T)_V` where T is declared constant: that it has a derivative by T speaks against it.
std::optional<Doubt> by_a_constant(RowPlace& place, const StepReading&, const Claim& claim) {
  const ExprTree& tree = place.tree;
  for (const ExprId side : {claim.equation.left, claim.equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      const auto& derivation = tree.symbols[symbol].derivation;
      if (!derivation) continue;
      for (const Variable& by : derivation->by) {
        const bool constant = by.by == By::letter && is_declared_constant(place.names.scope, by.letter);
        if (!constant) continue;
        const std::string& letter = tree.symbols[by.letter].name;
        return Doubt{
            .message = fmt::format("`{0}` is declared constant, and it differentiates by `{0}`", letter),
            .help = {fmt::format("a heading can part it from the lines for which `{}` is constant", letter)}};
      }
    }
  }
  return std::nullopt;
}

/// `\dot{\mathbf A} = \dot A_i\mathbf e_i + \boldsymbol\omega\times\mathbf A` in a rotating frame
std::optional<Doubt> in_turning_axes(RowPlace& place, const StepReading&, const Claim& claim) {
  return about_turning_axes(place, claim);
}

/// `N = mg - ma` behind "Now the lift goes down. Then", below `N = mg + ma`: with a slip taken back it only
/// says again what N is, and a sentence between them has words of its own.
std::optional<Doubt> of_what_is_said_anew(RowPlace& place, const StepReading& row, const Claim& claim) {
  const ExprNode& left = place.tree[claim.equation.left];
  const bool alone = left.op == Op::symbol && row.which == 0;
  const NamedDefinition* said = alone ? definition_of(place.names.scope, left.symbol) : nullptr;
  if (said == nullptr || said->origin.directive || said->origin.event == place.event || claim.for_all)
    return std::nullopt;
  const Prose& prose = place.notes.prose;
  const std::size_t first = prose.beside[said->origin.event].sentence;
  const bool between = std::ranges::any_of(prose.sentences, [&](const ProseSentence& each) {
    return each.number > first && each.number < beside(place).sentence && has_own_words(each.text);
  });
  if (!between && !names_an_opposite_since(prose, place.event, first)) return std::nullopt;
  const WrongStep wrong{.parsed = row.parsed, .which = row.which, .first_order = row.first_order};
  const auto repairs = likely_repairs(place, wrong);
  const std::string body = written_at(place, place.tree[said->definition.body].span);
  const bool again = std::ranges::any_of(repairs, [&](const Repair& each) {
    return !each.on_left && bare_formula(each.replacement) == bare_formula(body);
  });
  if (!again) return std::nullopt;
  return Doubt{
      .message = fmt::format("it says anew what `{}` is, and the words since `{}` may speak of another "
                             "case",
                             written_at(place, left.span), said->origin.text),
      .help = {fmt::format("`rigor: use {}` says that the earlier meaning holds",
                           use_of(place.names, place.tree, left.symbol))},
      .kind = DiagnosticKind::borrowed};
}

/// "Then", "hence" behind a row that is not read, or that words restrict: these restrict what is concluded,
/// too.
std::optional<Doubt> behind_an_open_row(RowPlace& place, const StepReading&, const Claim& claim) {
  const std::optional<RowBefore>& above = place.above.open_row;
  const ProseBeside& here = beside(place);
  if (!above || above->paragraph != here.paragraph || !announces_a_conclusion(here.lead) || claim.for_all)
    return std::nullopt;
  const LineColumn line = place.sources.line_column(above->span.file, above->span.begin);
  return Doubt{.message = fmt::format("it may follow from the row in line {}, which is open", line.line),
               .help = {"`rigor: claim …` asks whether it holds for all values"}};
}

}  // namespace

void withdraw(Judgement& judgement, const Claim& claim, Doubt doubt) {
  judgement.verdict = doubt.verdict;
  judgement.counterexample.reset();
  judgement.sample.reset();
  judgement.diagnostics = {{doubt.kind, claim.relation, std::move(doubt.message), {}, std::move(doubt.help)}};
}

std::optional<Doubt> doubt_of_refutation(RowPlace& place, const StepReading& row, const Claim& claim) {
  for (const auto ask : {behind_an_open_row,  of_what_is_said_anew,   by_a_constant,
                         in_turning_axes,     of_named_elements,      of_spins,
                         of_a_basis,          of_a_unit_of_the_notes, of_letters_held,
                         of_degrees_alone,    of_a_contradiction,     with_a_unit_missing,
                         in_natural_units,    about_written_zeros,    of_a_matrix_and_a_number,
                         of_another_value,    among_alternatives,     by_a_borrowed_letter,
                         of_special_matrices, for_other_values}) {
    if (auto doubt = ask(place, row, claim)) return doubt;
  }
  return std::nullopt;
}

}  // namespace rigor
