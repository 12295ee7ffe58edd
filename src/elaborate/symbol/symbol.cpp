// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/symbol.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/name/family.h"
#include "elaborate/reading/change.h"
#include "elaborate/symbol/axes.h"
#include "elaborate/symbol/hole.h"
#include "elaborate/symbol/matrix_letter.h"
#include "elaborate/symbol/named_symbol.h"
#include "elaborate/symbol/space_time_letter.h"
#include "elaborate/symbol/triple_letter.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool all_of_form(const std::vector<WrittenIndex>& axes, IndexForm form) {
  return std::ranges::all_of(axes, [&](const WrittenIndex& axis) { return axis.form == form; });
}

bool is_axis_letter(const WrittenIndex& axis) {
  return axis.form == IndexForm::letter && axis_of_letter(axis.text) != 0;
}

/// \mathbf{\hat X}, \mathbf{\hat Y} and \mathbf{\hat Z} beside numbers X, Y, Z, where the notes have no
/// other axes: then they are the axes.
bool are_capital_axes(const Sightings& sightings) {
  const auto is_bold = [&](std::string_view name) {
    return sightings.bold.contains({std::string(name), false});
  };
  static constexpr std::array<std::string_view, 3> axes{"\\hat{X}", "\\hat{Y}", "\\hat{Z}"};
  static constexpr std::array<std::string_view, 6> others{"X", "Y", "Z", "\\hat{x}", "\\hat{y}", "\\hat{z}"};
  return std::ranges::all_of(axes, is_bold) && std::ranges::none_of(others, is_bold) &&
         !sightings.hatted_ij && !sightings.bold_indexed.contains("e");
}

std::uint8_t hatted_axis(const WrittenSymbol& written, const Sightings& sightings) {
  if (written.accent != Accent::hat || !written.lower.empty() || written.primes > 0) return 0;
  if (const std::uint8_t axis = axis_of_letter(written.letter)) return axis;
  const bool capital = written.letter == "X" || written.letter == "Y" || written.letter == "Z";
  if (capital && written.face == Face::vector && are_capital_axes(sightings))
    return static_cast<std::uint8_t>(written.letter[0] - 'X' + 1);
  if (!sightings.hatted_ij) return 0;
  if (written.letter == "i" || written.letter == "\\imath") return 1;
  if (written.letter == "j" || written.letter == "\\jmath") return 2;
  return written.letter == "k" ? 3 : 0;
}

/// `\delta x` is one symbol, and where \delta is a small number, a product is as likely meant.
bool hides_small_factor(const Reading& reading, const WrittenSymbol& written, const WrittenName& name) {
  const Names& names = reading.names;
  return !written.change.empty() && is_small_scalar(names, reading.tree, written.change) &&
         !is_declared(names.symbols, {name.base, 0, false}) &&
         !is_declared(names.symbols, {name.base, 1, false});
}

void warn_of_bold_index(Reading& reading, const WrittenName& name, Span span) {
  std::string list;
  for (const WrittenIndex& axis : name.axes) list += axis.text + std::string(axis.primes, '\'');
  const bool one = name.axes.size() == 1;
  report(reading.diagnostics, DiagnosticKind::bold_index, span,
         fmt::format("`{}` is a {}, yet it carries the {} `{}`; read as the component", bold(name.base),
                     one ? "vector" : "tensor", one ? "index" : "indices", list),
         {one ? fmt::format("write `{}_{}`", name.base, list)
              : fmt::format("write `{}_{{{}}}`", name.base, list)});
}

bool is_in_company(const Reading& reading, const WrittenName& name) {
  return reading.letters.bold_vectors.contains(name.base) ||
         reading.letters.indexed_vectors.contains(name.base);
}

/// What is differentiated by, where the vector is not written beside it; and r of `\mathbf r = r\hat r`,
/// which has a sign. Where the notes differentiate by place, as ∇ does, r is the length of a place.
bool is_number_of_its_own(const Reading& reading, const WrittenName& name) {
  const Names& names = reading.names;
  if (reading.letters.has_nabla || name.per_particle() || is_declared(names.symbols, {name.base, 1, false}))
    return false;
  const bool alone = !is_in_company(reading, name);
  if (alone && reading.letters.by.contains(name.base)) return true;
  if (names.symbols.sightings->places) return false;
  const Evidence& here = *names.symbols.evidence;
  if (here.coefficients.contains(name.base) || (alone && here.by.contains(name.base))) return true;
  const auto number = find_symbol(names.symbols, {name.base, 0, false});
  const auto vector = find_symbol(names.symbols, {name.base, 1, false});
  const auto body = vector ? body_of_definition(names.scope, *vector) : std::nullopt;
  return number && body && is_one_of(*number, symbols_in(reading.tree, *body));
}

/// Bold somewhere else in the notes makes a letter a vector, yet nothing in the statement says so: `R_1` may
/// be a resistance. A length is settled by the vector's use in this section. Is it read as a symbol of its
/// own?
bool stands_apart(Reading& reading, const WrittenName& name, bool as_length) {
  const NameKey key{name.base, 1, name.per_particle()};
  const Names& names = reading.names;
  const auto symbol = find_symbol(names.symbols, key);
  const bool settled = name.per_particle() || is_operator(*names.symbols.evidence, name.base, 1) ||
                       is_declared(names.symbols, key) || is_in_company(reading, name) ||
                       (symbol && definition_of(names.scope, *symbol) != nullptr) ||
                       (symbol && as_length && seen_in_equation(names.scope, *symbol));
  if (settled) return false;
  reading.found.belongs =
      Obstacle{DiagnosticKind::ambiguous_reading,
               fmt::format("`{}` can belong to the vector `{}`, or be a symbol of its own", name.base,
                           bold(name.base)),
               {fmt::format("`rigor: vector {}` or `rigor: scalar …` settles it", bold(name.base))}};
  return reading.rules.apart;
}

/// `a` and `a_i` in one statement: a length and its components, or two letters.
bool stands_apart_in_company(Reading& reading, const WrittenName& name) {
  reading.found.belongs = Obstacle{
      DiagnosticKind::ambiguous_reading,
      fmt::format("`{}` can be the length of the vector with components `{}_i`, or a symbol of its own",
                  name.base, name.base),
      {fmt::format("`rigor: vector {}` or `rigor: scalar {}` settles it", bold(name.base), name.base)}};
  return reading.rules.apart;
}

/// A symbol that other rows may take for a part of a vector.
MaybeTyped symbol_apart(Reading& reading, const Occurrence& at, const std::string& base) {
  note(reading, fmt::format("`{}` is a symbol of its own", base));
  return named_symbol(reading, at, base, 0);
}

/// δ, ε and basis vectors; nothing for other letters.
std::optional<MaybeTyped> unit_or_basis(Reading& reading, const WrittenSymbol& written, Span span,
                                        const Around& around) {
  const Names& names = reading.names;
  if (is_kronecker(written) || is_levi_civita(written)) return unit_tensor(reading, written, span, around);
  const bool e_declared =
      is_declared(names.symbols, {"e", 1, false}) || is_declared(names.symbols, {"\\hat{e}", 1, false});
  if (is_basis_family(written) && !e_declared) {
    if (any_primed(written.lower)) return primed_basis_vector(reading, written.lower[0], span, around);
    if (auto read = try_subscript(reading, written.lower, around))
      return basis_vector(reading, span, read->slots[0], std::move(read->free));
  }
  const std::uint8_t axis = hatted_axis(written, *names.symbols.sightings);
  const int dimension = space_of(names.symbols).dimension;
  if (axis > dimension)
    return unsupported(reading, span,
                       fmt::format("the space has only {} axes, and this is not one of them", dimension));
  if (axis != 0 && !is_declared(names.symbols, {"\\hat{" + written.letter + "}", 1, false}))
    return basis_vector(reading, span, Slot{axis, {}}, {});
  return std::nullopt;
}

bool is_bare_and_undeclared(const Names& names, const WrittenSymbol& written) {
  return written.lower.empty() && written.face == Face::plain && written.accent == Accent::none &&
         written.change.empty() && !is_declared(names.symbols, {written.letter, 0, false});
}

bool speaks_of_operators_here(const Evidence& evidence) {
  return !evidence.noncommuting.empty() || !evidence.noncommuting_triples.empty();
}

/// Does the section show that the letter is the number i? Not where it also is a subscript.
bool is_imaginary_unit(const Reading& reading, const WrittenSymbol& written) {
  const Evidence& evidence = *reading.names.symbols.evidence;
  const bool upright = written.letter == "\\mathrm{i}" && !evidence.no_units.contains(written.letter);
  return may_be_imaginary_unit(written) && is_bare_and_undeclared(reading.names, written) &&
         (upright || evidence.imaginary_units.contains(written.letter)) &&
         (speaks_of_operators_here(evidence) || reading.letters.indices.contains(written.letter) ||
          !reading.letters.below.contains(written.letter)) &&
         !reading.letters.counted.contains(written.letter) &&
         !reading.indices.summed.contains(written.letter) &&
         !reading.particles.summed.contains(written.letter);
}

/// `\bar z` of a complex z; nothing where the bar is part of a name.
std::optional<MaybeTyped> overlined(Reading& reading, WrittenSymbol written, Span span,
                                    const Around& around) {
  if (std::exchange(written.accent, Accent::none) != Accent::bar) return std::nullopt;
  const std::set<std::string>& complex = reading.names.symbols.evidence->complex_numbers;
  if (!complex.contains(complex_name(written))) return std::nullopt;
  const auto inside = elaborate_symbol(reading, written, span, around);
  if (!inside) return MaybeTyped();
  return MaybeTyped(apply_op(reading.tree, Op::conjugate, span, inside->rank, {*inside}));
}

/// Does the section show that it is an operator, or a component of three?
bool names_an_operator(const Reading& reading, const WrittenSymbol& written, const WrittenName& name) {
  if (written.face != Face::plain || name.per_particle()) return false;
  const Evidence& evidence = *reading.names.symbols.evidence;
  return is_operator(evidence, with_labels(name.base, name.axes), 0) ||
         (name.axes.size() == 1 && is_operator(evidence, name.base, 1));
}

/// `\mathbb 1`, and "the unit matrix $I$", beside operators.
bool is_unit_operator(const Reading& reading, const WrittenSymbol& written) {
  const Evidence& evidence = *reading.names.symbols.evidence;
  if (!speaks_of_operators_here(evidence)) return false;
  if (written.letter == "\\mathbb{1}" || written.letter == "\\mathbb{I}") return true;
  const UnsizedMatrices& unsized = evidence.unsized;
  const bool by_use = written.letter == "I" && !unsized.matrices.empty() && unsized.units > 0 &&
                      unsized.no_units == 0 && !evidence.matrices.contains("I");
  return is_bare_and_undeclared(reading.names, written) &&
         (by_use || evidence.units.contains(written.letter));
}

/// A matrix or a column of any size; also where the letter is bold.
std::optional<MaybeTyped> unsized_symbol(Reading& reading, const WrittenSymbol& written, Span span) {
  const std::string labelled = with_labels(letter_with_marks(written), written.lower);
  const std::string name = written.face == Face::vector ? "\\mathbf{" + labelled + "}" : labelled;
  if (unsized_letter(*reading.names.symbols.evidence, name) == Unsized::none) return std::nullopt;
  const SymbolId symbol = symbol_named(reading, {.base = name}, name, span);
  return Typed{.id = reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol})};
}

/// Why a letter is no quantity that is read: it stands for a change, an average or i.
std::optional<Obstacle> no_quantity(const Reading& reading, const WrittenSymbol& written) {
  const Names& names = reading.names;
  const std::string& letter = written.letter;
  if (letter.starts_with("\\mathbb") && !is_declared_letter(names, written))
    return unread(
        fmt::format("`{}` can be an average, a probability, a set or a unit, which are not decided with",
                    letter),
        {fmt::format("`rigor: scalar {}` makes it a quantity", letter)});
  if (!is_bare_and_undeclared(names, written)) return std::nullopt;
  // `\frac{\delta}{\delta q}`: what is no change by itself may be one beside others.
  const bool beside_changes = reading.letters.changes.contains(letter);
  if (((letter == "\\delta" || letter == "\\Delta") && beside_changes) || letter == "\\mathrm{d}")
    return unread(
        fmt::format("`{}` without indices reads as a small change, which is not decided yet", letter));
  // Where the section writes i for it, j is a current.
  const std::set<std::string>& units = names.symbols.evidence->imaginary_units;
  if (may_be_imaginary_unit(written) && !reading.letters.counted.contains(letter) &&
      (units.empty() || units.contains(letter)))
    return Obstacle{
        DiagnosticKind::ambiguous_reading,
        fmt::format("`{}` can be the imaginary unit or a quantity of this name, and nothing here says which",
                    letter),
        {fmt::format("`rigor: scalar {0}` makes it a quantity; `e^{{{0}\\dots}}` or \"the imaginary unit "
                     "${0}$\" show that it is none",
                     letter)}};
  return std::nullopt;
}

MaybeTyped vector_symbol(Reading& reading, const Occurrence& at) {
  const WrittenName& name = at.name;
  const Names& names = reading.names;
  const bool tensor = at.written.face == Face::tensor;
  const bool particle = name.per_particle();
  const int rank = static_cast<int>(name.axes.size());
  if (rank == 0) {
    const bool declared_vector = is_declared(names.symbols, {name.base, 1, particle});
    const bool declared_tensor = is_declared(names.symbols, {name.base, 2, particle});
    if (!tensor && !declared_vector && !declared_tensor &&
        names.symbols.sightings->indexed.contains({name.base, 2, particle}) &&
        !names.symbols.sightings->crossed.contains(name.base) &&
        !names.symbols.sightings->indexed.contains({name.base, 1, particle})) {
      return ambiguous(
          reading, at.span,
          fmt::format("`{}` can be a vector, or the tensor with components `{}_{{ij}}`", bold(name.base),
                      name.base),
          {fmt::format("`rigor: tensor {0}` or `rigor: vector {0}` settles it", bold(name.base))});
    }
    return named_symbol(reading, at, name.base, tensor || (declared_tensor && !declared_vector) ? 2 : 1);
  }
  if (tensor) return named_symbol(reading, at, name.base, rank, name.axes);
  if (all_of_form(name.axes, IndexForm::digit))
    return named_symbol(reading, at, with_labels(name.base, name.axes), 1);
  const bool hatted = at.written.accent == Accent::hat && at.written.face == Face::plain;
  const bool whole_vector_known = is_declared(names.symbols, {name.base, 1, particle}) ||
                                  names.symbols.sightings->bold.contains({name.base, particle});
  const bool tensor_component = rank > 1 && is_declared(names.symbols, {name.base, rank, particle});
  const std::string& first = name.axes[0].text;
  if (tensor_component ||
      (rank == 1 && (whole_vector_known || hatted) && !reading.indices.summed.contains(first))) {
    if (!hatted) warn_of_bold_index(reading, name, at.span);
    return named_symbol(reading, at, name.base, rank, name.axes);
  }
  return ambiguous(
      reading, at.span,
      fmt::format("the index on `{}` can name a particle, a component or a label", bold(name.base)),
      {fmt::format("`rigor: particles {}` makes it a particle; a component is written `{}_{}`", first,
                   name.base, first)});
}

MaybeTyped length_or_scalar(Reading& reading, const Occurrence& at) {
  const WrittenName& name = at.name;
  const Names& names = reading.names;
  const bool particle = name.per_particle();
  const NameKey scalar{name.base, 0, particle};
  const bool defined = find_symbol(names.symbols, scalar) &&
                       definition_of(names.scope, *find_symbol(names.symbols, scalar)) != nullptr;
  for (const int rank : {1, 2}) {
    if (is_plain(names.symbols, {name.base, rank, particle}))
      return named_symbol(reading, at, name.base, rank);
  }
  // A letter that is bold in another section only is another letter here.
  const Evidence& here = *names.symbols.evidence;
  const bool bold_here = name.base == "r" || !here.letters.contains(at.written.letter) ||
                         here.vectors.contains(letter_with_marks(at.written));
  const bool bold_somewhere = names.symbols.sightings->bold.contains({name.base, particle});
  const auto vector_elsewhere = find_symbol(names.symbols, {name.base, 1, particle});
  const bool of_another_section = bold_somewhere && !bold_here && vector_elsewhere &&
                                  definition_of(names.scope, *vector_elsewhere) != nullptr;
  reading.found.may_be_length = reading.found.may_be_length || of_another_section;
  const bool bold_seen = (bold_somewhere && bold_here) ||
                         (of_another_section && reading.rules.lengths_of_other_sections) ||
                         is_declared(names.symbols, {name.base, 1, particle});
  const bool by_company = !bold_seen && at.written.lower.size() == name.particles.size() &&
                          reading.letters.indexed_vectors.contains(name.base);
  const bool component = here.components.contains(name.base);
  if (is_declared(names.symbols, scalar) || defined || component || (!bold_seen && !by_company))
    return named_symbol(reading, at, name.base, 0);
  if (is_number_of_its_own(reading, name)) return symbol_apart(reading, at, name.base);
  if ((bold_seen && stands_apart(reading, name, true)) ||
      (by_company && stands_apart_in_company(reading, name)))
    return symbol_apart(reading, at, name.base);
  const auto vector = named_symbol(reading, at, name.base, 1);
  if (!vector) return vector;
  if (has_complex_numbers(reading.tree, vector->id))
    return ambiguous(reading, at.span,
                     fmt::format("`{}` can be the length of the complex `{}`, or a number of its own",
                                 name.base, bold(name.base)),
                     {fmt::format("write `|{}|` for the length", bold(name.base))});
  note(reading, fmt::format("`{}` is the length of `{}`", name.base, bold(name.base)));
  return apply_op(reading.tree, Op::length, at.span, 0, {*vector});
}

/// m of `E_m` stands for a number, also where it is not written as one.
void resolve_counters(Reading& reading, const std::string& base, Span span) {
  if (reading.names.scope.families.empty()) return;
  const auto member = member_name({base, 0, false});
  if (!member) return;
  for (const auto& [letter, factor] : member->letters)
    symbol_named(reading, {letter, 0, false}, letter, span);
}

MaybeTyped plain_symbol(Reading& reading, Occurrence at) {
  WrittenName& name = at.name;
  if (name.axes.empty()) {
    resolve_counters(reading, name.base, at.span);
    return length_or_scalar(reading, at);
  }
  const Names& names = reading.names;
  const bool particle = name.per_particle();
  if (name.axes.size() == 2 && name.axes[0].form == IndexForm::digit &&
      name.axes[1].form == IndexForm::letter &&
      names.symbols.sightings->bold.contains(
          {with_labels(name.base, {name.axes[0]}), particle})) {  // p_{1x} of \mathbf{p}_1
    name.base = with_labels(name.base, {name.axes[0]});
    name.axes.erase(name.axes.begin());
  }
  const int rank = static_cast<int>(name.axes.size());
  if (std::ranges::all_of(name.axes, is_index_letter))
    return named_symbol(reading, at, name.base, rank, name.axes);
  const bool known = is_known(names, name.base, rank, particle);
  const std::string labelled = with_labels(name.base, name.axes);
  const bool labelled_declared = is_declared(names.symbols, {labelled, 0, particle});
  const bool labelled_known =
      names.symbols.sightings->bold.contains({labelled, particle}) || labelled_declared;
  if (known && labelled_known && rank == 1 && !labelled_declared) {
    return ambiguous(reading, at.span,
                     fmt::format("`{}` can be a component of `{}` or the length of `{}`", labelled,
                                 bold(name.base), bold(labelled)),
                     {fmt::format("write `|{}|` for the length", bold(labelled))});
  }
  const bool mixed =
      !all_of_form(name.axes, IndexForm::digit) && !std::ranges::all_of(name.axes, is_axis_letter);
  if (known && !labelled_known && rank == 1 && stands_apart(reading, name, false)) {
    name.axes.clear();
    return symbol_apart(reading, at, labelled);
  }
  if ((known && !labelled_known) || mixed) return named_symbol(reading, at, name.base, rank, name.axes);
  name.base = labelled;
  name.axes.clear();
  resolve_counters(reading, name.base, at.span);
  return length_or_scalar(reading, at);
}

/// `\dot x`. A dot on the length r of a vector is d|r|/dt, to the letter; on that of a particle's vector,
/// squared, a missing bold face may be meant, as in ½ Σ m ṙ².
MaybeTyped dotted_symbol(Reading& reading, const WrittenSymbol& written, Span span, const Around& around) {
  WrittenSymbol bare = written;
  const int times = std::exchange(bare.dots, std::uint8_t{0});
  auto typed = elaborate_symbol(reading, bare, span, around);
  if (!typed || frame_is_open(reading, *typed, span) || is_total_rate_of_field(reading, *typed, span))
    return std::nullopt;
  if (reading.tree[typed->id].op != Op::length || !around.squared)
    return rate_of(reading, std::move(*typed), times);
  const ExprNode& vector_of_length = reading.tree[reading.tree.children(typed->id)[0]];
  const bool of_particle =
      vector_of_length.op == Op::symbol && reading.tree.symbols[vector_of_length.symbol].per_particle;
  if (!of_particle) return rate_of(reading, std::move(*typed), times);
  reading.found.dotted_length = span;
  if (!reading.rules.dots_on_vectors) return rate_of(reading, std::move(*typed), times);
  typed->id = reading.tree.children(typed->id)[0];
  typed->rank = 1;
  const Typed vector = rate_of(reading, std::move(*typed), times);
  return apply_op(reading.tree, Op::length, span, 0, {vector});
}

/// `f^{(2)}`: f is a usual letter for a function, or the section differentiates it or shows its argument.
bool may_be_derivative_of_order(const Names& names, const WrittenSymbol& written) {
  if (written.lower.empty() || !written.lower.front().text.starts_with("^{(")) return false;
  const std::string labelled = with_labels(written.letter, {written.lower.front()});
  const bool declared = is_declared(names.symbols, {labelled, 0, false}) ||
                        is_declared(names.symbols, {with_labels(written.letter, written.lower), 0, false});
  if (!is_digit(written.lower.front().text[3]) || declared) return false;
  static constexpr std::array<std::string_view, 8> functions{"f",     "g",        "h",     "y",
                                                             "\\psi", "\\varphi", "\\phi", "\\Psi"};
  const Evidence& evidence = *names.symbols.evidence;
  const std::string& letter = written.letter;
  const auto differentiates = [&](const auto& each) { return each.second.contains(letter); };
  return is_one_of(letter, functions) || evidence.primed.contains(letter) ||
         evidence.changing.contains(letter) || is_applied(evidence, letter) ||
         std::ranges::any_of(evidence.by, differentiates);
}

/// `x_i` inside a sum over i: a value of the sequence x, and a symbol of its own.
std::optional<MaybeTyped> member_of_sequence(Reading& reading, const WrittenSymbol& written, Span span,
                                             const Around& around) {
  const auto counter = std::ranges::find_if(
      reading.counting, [&](const std::string& letter) { return is_member_of_sequence(written, letter); });
  if (counter == reading.counting.end()) return std::nullopt;
  const auto at = elaborate_symbol(reading, {.letter = *counter, .letter_span = span}, span, around);
  if (!at) return MaybeTyped();
  const std::string base = letter_with_marks(written);
  const std::string name = fmt::format("{}_{{{}}}", base, *counter);
  const SymbolId symbol = symbol_named(reading, {base + "[" + *counter + "]", 0, false}, name, span);
  if (!reading.names.symbols.function_values.contains(symbol)) {
    const SymbolId of = symbol_named(reading, {base + "[]", 0, false}, base, span);
    reading.names.symbols.function_values.put({symbol, {of, {*counter}, {at->id}, true}});
  }
  return Typed{.id = reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol})};
}

}  // namespace

MaybeTyped elaborate_symbol(Reading& reading, const WrittenSymbol& written, Span span, const Around& around) {
  if (auto tensor = lowered_letter(reading, written, span, around)) return *std::move(tensor);
  const bool sequence = !reading.counting.empty();
  if (sequence) {
    if (auto triple = triple_letter(reading, written, span, around)) return *std::move(triple);
  }
  if (auto member = member_of_sequence(reading, written, span, around)) return *std::move(member);
  if (written.letter == hole_letter) return elaborate_hole(reading, written, span, around);
  if (written.dots > 0) {
    if (auto triple = triple_letter(reading, written, span, around)) return *std::move(triple);
  }
  if (written.dots > 0) return dotted_symbol(reading, written, span, around);
  if (written.letter == "\\nabla") return unsupported(reading, span, "`\\nabla` has nothing to act on here");
  if (auto letter = matrix_letter(reading, written, span)) return *std::move(letter);
  if (auto triple = triple_letter(reading, written, span, around)) return *std::move(triple);
  if (speaks_of_operators_here(*reading.names.symbols.evidence)) {
    if (auto letter = unsized_symbol(reading, written, span)) return *std::move(letter);
    if (is_unit_operator(reading, written)) return Typed{.id = reading.tree.add_number(span, "1")};
    WrittenName name = take_apart(written, reading.letters, reading.names);
    if (names_an_operator(reading, written, name)) {
      reading.found.used.insert(name.used.begin(), name.used.end());
      return plain_symbol(reading, {written, std::move(name), span, around});
    }
  }
  if (auto fixed = unit_or_basis(reading, written, span, around)) return *std::move(fixed);
  if (is_imaginary_unit(reading, written))
    return Typed{.id = reading.tree.add({.op = Op::imaginary_unit, .span = span})};
  if (auto conjugate = overlined(reading, written, span, around)) return *std::move(conjugate);
  if (const auto obstacle = no_quantity(reading, written)) return fail(reading, span, *obstacle);
  if (may_be_derivative_of_order(reading.names, written)) {
    const std::string labelled = with_labels(written.letter, {written.lower.front()});
    return ambiguous(
        reading, span,
        fmt::format("`{}` can be a derivative of `{}`, or a symbol of its own", labelled, written.letter),
        {fmt::format("`rigor: scalar {}` makes it a symbol", labelled)});
  }
  WrittenName name = take_apart(written, reading.letters, reading.names);
  reading.found.used.insert(name.used.begin(), name.used.end());
  if (hides_small_factor(reading, written, name)) {
    return ambiguous(reading, span,
                     fmt::format("`{}` is read as one symbol, a change, but `{}` is small by itself",
                                 name.base, written.change),
                     {fmt::format("for the product, write `{}` after the other factors", written.change)});
  }
  const auto greek_label = [](const WrittenIndex& index) { return index.form == IndexForm::greek; };
  if (std::ranges::count_if(written.lower, greek_label) > 1) {
    return unsupported(reading, span, "two Greek subscripts, as of space-time, are not decided");
  }
  for (const WrittenIndex& index : written.lower) {
    std::vector<std::string> counters = counters_in(index);
    if (index.text.starts_with("^{(")) counters.emplace_back(1, index.text[3]);  // `a^{(N)}` in a sum over N
    const bool bound = std::ranges::any_of(counters, [&](const std::string& letter) {
      return reading.letters.is_index(letter) || reading.indices.summed.contains(letter) ||
             reading.particles.summed.contains(letter);
    });
    const bool several =
        counters.size() > 1 && (written.letter == "\\delta" || written.letter == "\\epsilon");
    if (bound || several)
      return unsupported(reading, span, fmt::format("`{}` beside an index is not read", index.text));
  }
  const bool capital = is_capital_letter(written.letter);
  if (written.accent == Accent::hat && written.face == Face::plain && capital &&
      !is_declared(reading.names.symbols, {name.base, 1, false})) {
    return ambiguous(
        reading, span, fmt::format("`{}` can be a unit vector or an operator", name.base),
        {fmt::format("`rigor: vector {}` or a bold letter says that it is a vector; with operators "
                     "nothing is decided",
                     name.base)});
  }
  if (name.particles.size() > 1)
    return unsupported(reading, span, "a quantity of two particles is not decided yet");
  if (written.face != Face::plain || written.accent == Accent::hat)
    return vector_symbol(reading, {written, std::move(name), span, around});
  auto typed = plain_symbol(reading, {written, std::move(name), span, around});
  if (typed && typed->rank == 0 && may_be_unit_matrix(reading, written))
    typed->with_unit = reading.tree.add_number(span, "1");
  return typed;
}

}  // namespace rigor
