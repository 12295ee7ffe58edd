// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/symbol/space_time_letter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/among.h"
#include "elaborate/reading/space_time.h"
#include "elaborate/reading/summation.h"
#include "elaborate/symbol/named_symbol.h"
#include "elaborate/symbol/symbol.h"

namespace rigor {
namespace {

const Evidence& evidence_of(const Reading& reading) { return *reading.names.symbols.evidence; }

bool is_greek_index(const WrittenIndex& index) { return index.form == IndexForm::greek; }

/// All indices in their order: those above come after the first `raised_at` of those below.
std::vector<WrittenIndex> in_order(const WrittenSymbol& written, const std::vector<WrittenIndex>& above) {
  std::vector<WrittenIndex> all = written.lower;
  const auto at = std::min<std::size_t>(written.raised_at, all.size());
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), above.begin(), above.end());
  return all;
}

/// 1 of `p_{1\mu}` and A of `p_A^\mu`: labels come before the Greek indices of a letter that has one index
/// elsewhere. What is left are indices.
std::vector<WrittenIndex> labels_taken(const Reading& reading, WrittenSymbol& written,
                                       const std::vector<WrittenIndex>& above) {
  const auto tensors = evidence_of(reading).space_time.tensors.find(letter_with_marks(written));
  const bool vector =
      tensors == evidence_of(reading).space_time.tensors.end() || *tensors->second.rbegin() < 2;
  static constexpr std::array<std::string_view, 6> indices{"i", "j", "k", "l", "m", "n"};
  std::vector<WrittenIndex> labels;
  const bool greek =
      std::ranges::any_of(written.lower, is_greek_index) || std::ranges::any_of(above, is_greek_index);
  while (!written.lower.empty() && greek) {
    const WrittenIndex& first = written.lower.front();
    const bool word =
        first.form == IndexForm::word || (first.form == IndexForm::letter && !is_one_of(first.text, indices));
    const bool digit = first.form == IndexForm::digit && vector;
    if (!word && !digit) break;
    labels.push_back(first);
    written.lower.erase(written.lower.begin());
    if (written.raised_at > 0) --written.raised_at;
  }
  return labels;
}

/// Letters that are read as what they are on any page.
enum class Fixed : std::uint8_t { none, delta, metric, epsilon };

Fixed fixed_letter(const Reading& reading, const WrittenSymbol& written, std::size_t count) {
  const bool plain = written.accent == Accent::none && written.primes == 0 && written.change.empty();
  if (!plain) return Fixed::none;
  if (written.letter == "\\delta" && count == 2) return Fixed::delta;
  if (written.letter == "\\epsilon" && count == 4) return Fixed::epsilon;
  const SpaceTime& seen = evidence_of(reading).space_time;
  const bool metric = written.letter == "\\eta" || (written.letter == seen.metric && !seen.curved);
  return metric && count == 2 ? Fixed::metric : Fixed::none;
}

/// δ^μ_ν is 1 for equal indices; η_{μν} is δ with the upper index lowered, η^{μν} with the lower one raised.
MaybeTyped metric(Reading& reading, const std::vector<WrittenIndex>& indices, bool kronecker, Span span,
                  const Around& around) {
  std::vector<FreeIndex> free;
  std::array<Slot, 2> slots;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto slot = event_slot(reading, indices[k], around, free);
    if (!slot) return unsupported(reading, span, "such an index on the metric is not read");
    slots[k] = *slot;
  }
  const bool mixed = indices[0].raised != indices[1].raised;
  if (!mixed && kronecker)
    return unsupported(reading, span, "`\\delta` of space-time has one index above and one below",
                       {"`\\eta_{\\mu\\nu}` has both below"});
  const bool above = indices[0].raised && indices[1].raised;
  if (mixed && !indices[0].raised) std::swap(slots[0], slots[1]);
  ExprTree& tree = reading.tree;
  const bool axes = slots[0].axis != 0 && slots[1].axis != 0;
  Typed typed{.free = free};
  if (axes) {
    typed.id = tree.add_number(span, slots[0].axis == slots[1].axis ? "1" : "0");
    if (slots[0].axis != slots[1].axis) return typed;
  } else {
    typed.id = tree.add({.op = Op::delta, .span = span}, {}, slots);
  }
  if (!mixed) typed.id = turned_at(reading, typed.id, slots[above ? 1 : 0], span);
  return contract(reading, std::move(typed));
}

/// The sign of a permutation of four axes; 0 where two are the same.
int sign_of(std::array<int, 4> axes) {
  int sign = 1;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      if (axes[a] == axes[b]) return 0;
      if (axes[a] > axes[b]) sign = -sign;
    }
  }
  return sign;
}

/// ε^{0123} is 1, and with lower indices −1: nothing on a page says it as a rule, and what has two of them
/// does not depend on it.
MaybeTyped epsilon(Reading& reading, const std::vector<WrittenIndex>& indices, Span span,
                   const Around& around) {
  std::vector<FreeIndex> free;
  std::vector<Slot> slots;
  for (const WrittenIndex& index : indices) {
    const auto slot = event_slot(reading, index, around, free);
    if (!slot || slot->axis != 0)
      return unsupported(reading, span, "a component of `\\varepsilon` in space-time is not decided");
    slots.push_back(*slot);
  }
  ExprTree& tree = reading.tree;
  const ExprId one = tree.add_number(span, "1");
  const std::array<ExprId, 3> values{tree.add_number(span, "0"), one,
                                     tree.add({.op = Op::negate, .span = span}, std::span(&one, 1))};
  Table table;
  for (int at = 0; at < 256; ++at) {
    const int sign = sign_of({at / 64, at / 16 % 4, at / 4 % 4, at % 4});
    table.entry.push_back(sign == 0 ? 0 : sign > 0 ? 1 : 2);
  }
  Typed typed{.id = tree.add_table(span, values, slots, std::move(table)), .free = free};
  for (std::size_t k = 0; k < slots.size(); ++k) {
    if (!indices[k].raised) typed.id = turned_at(reading, typed.id, slots[k], span);
  }
  if (!reading.found.guess)
    reading.found.guess = unread("nothing says whether `\\varepsilon^{0123}` is 1 or −1");
  return contract(reading, std::move(typed));
}

/// The components along the axes of space, of which some slots are Latin letters.
ExprId spatial_part(Reading& reading, SymbolId symbol, std::vector<Slot> slots,
                    const std::vector<std::size_t>& latin, std::size_t which, Span span) {
  ExprTree& tree = reading.tree;
  if (which == latin.size()) return tree.add({.op = Op::symbol, .span = span, .symbol = symbol}, {}, slots);
  std::vector<ExprId> entries;
  for (std::uint8_t axis = 2; axis <= 4; ++axis) {
    slots[latin[which]] = {axis, {}};
    entries.push_back(spatial_part(reading, symbol, slots, latin, which + 1, span));
  }
  return tree.add({.op = Op::tuple, .rank = static_cast<std::uint8_t>(latin.size() - which), .span = span},
                  entries);
}

/// V^μ and V_μ of one row are related by a metric of which nothing is known.
void note_heights(Reading& reading, const std::string& base, const std::vector<WrittenIndex>& indices) {
  const std::string begin = fmt::format("`{}` with indices ", base);
  std::string own = begin;
  for (const WrittenIndex& index : indices) own += index.raised ? "above, " : "below, ";
  own.resize(own.size() - 2);
  own += " is a tensor of its own";
  const auto& known = reading.found.conventions;
  const bool other = std::ranges::any_of(
      known, [&](const std::string& each) { return each.starts_with(begin) && each != own; });
  if (other && !reading.found.guess)
    reading.found.guess = unread(fmt::format(
        "nothing is known of the metric, which relates the indices above and below on `{}`", base));
  note(reading, own);
}

MaybeTyped tensor(Reading& reading, const std::string& base, const std::vector<WrittenIndex>& indices,
                  Span span, const Around& around) {
  constexpr std::size_t most_indices = 4;
  if (indices.size() > most_indices)
    return unsupported(reading, span, "tensors of rank above 4 are not decided");
  ExprTree& tree = reading.tree;
  std::string name = base;
  if (evidence_of(reading).space_time.curved) {  // nothing is known of a metric: each height is a letter
    std::string heights;
    for (const WrittenIndex& index : indices) heights += index.raised ? 'u' : 'd';
    name += "#" + heights;
  }
  NameKey key{name, static_cast<int>(indices.size()), false};
  key.space = space_time.id;
  const SymbolId symbol = symbol_named(reading, key, base, span);
  if (base == "g" && indices.size() == 2 && evidence_of(reading).space_time.curved)
    tree.symbols.write(symbol).symmetric = true;
  Typed typed;
  std::vector<Slot> slots;
  std::vector<std::size_t> latin;
  std::vector<Slot> latin_slots;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (indices[k].form == IndexForm::letter) {
      const IndexId id = index_named(reading, indices[k].text);
      if (tree.space(id) != common_space) return unsupported(reading, span, "such an index is not read");
      latin.push_back(k);
      latin_slots.push_back({0, id});
      slots.push_back({});
      if (!reading.indices.summed.contains(indices[k].text))
        typed.free.push_back({indices[k].text, id, indices[k].span});
      continue;
    }
    const auto slot = event_slot(reading, indices[k], around, typed.free);
    if (!slot) return unsupported(reading, span, "such an index of space-time is not read");
    slots.push_back(*slot);
  }
  if (evidence_of(reading).space_time.curved) note_heights(reading, base, indices);
  typed.id = spatial_part(reading, symbol, slots, latin, 0, span);
  if (!latin.empty()) typed.id = component_of(tree, typed.id, latin_slots);
  for (std::size_t k = 0; k < slots.size() && !evidence_of(reading).space_time.curved; ++k) {
    if (indices[k].raised) continue;
    const bool of_space = is_one_of(k, latin);  // all axes of space have one sign
    typed.id = turned_at(reading, typed.id, of_space ? Slot{2, {}} : slots[k], span);
  }
  return contract(reading, std::move(typed));
}

/// Does the section show the letter with Greek indices?
bool is_tensor(const Reading& reading, const WrittenSymbol& written) {
  return evidence_of(reading).space_time.tensors.contains(letter_with_marks(written));
}

/// `x^1` is no power, so that `x^2` is none beside it.
bool has_first_component(const SyntaxTree& syntax, const WrittenSymbol& written) {
  for (std::uint32_t k = 0; k < syntax.size(); ++k) {
    const SyntaxId id{k};
    if (syntax[id].kind != SyntaxKind::power) continue;
    const SyntaxId base = syntax.child(id, 0);
    const SyntaxId above = syntax.child(id, 1);
    const bool one = syntax[above].kind == SyntaxKind::number && syntax.text(above) == "1";
    if (one && syntax[base].kind == SyntaxKind::symbol && syntax.symbol(base).letter == written.letter)
      return true;
  }
  return false;
}

MaybeTyped with_indices(Reading& reading, WrittenSymbol written, const std::vector<WrittenIndex>& above,
                        Span span, const Around& around) {
  if (written.dots > 0)
    return unsupported(reading, span,
                       "a dot on a tensor of space-time can be by the time or by the proper time",
                       {"`\\frac{d}{d\\tau}` is read"});
  const std::vector<WrittenIndex> labels = labels_taken(reading, written, above);
  const std::vector<WrittenIndex> indices = in_order(written, above);
  const bool readable = std::ranges::all_of(
      indices, [](const WrittenIndex& index) { return index.form != IndexForm::word && index.primes == 0; });
  if (!readable || indices.empty())
    return unsupported(reading, span, "such indices of space-time are not read");
  switch (labels.empty() ? fixed_letter(reading, written, indices.size()) : Fixed::none) {
    case Fixed::delta:
      return metric(reading, indices, true, span, around);
    case Fixed::metric:
      return metric(reading, indices, false, span, around);
    case Fixed::epsilon:
      return epsilon(reading, indices, span, around);
    case Fixed::none:
      break;
  }
  return tensor(reading, with_labels(letter_with_marks(written), labels), indices, span, around);
}

}  // namespace

std::optional<MaybeTyped> raised_letter(Reading& reading, SyntaxId power, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId base = syntax.child(power, 0);
  if (!evidence_of(reading).space_time.shown || syntax[base].kind != SyntaxKind::symbol) return std::nullopt;
  const WrittenSymbol& written = syntax.symbol(base);
  std::vector<WrittenIndex> above = indices_above(syntax, syntax.child(power, 1));
  if (above.empty() || written.face != Face::plain || written.letter == "e") return std::nullopt;
  const bool greek = std::ranges::any_of(above, is_greek_index);
  for (const WrittenIndex& index : above) {
    if (is_greek_index(index) && !is_space_time_index(evidence_of(reading), index)) return std::nullopt;
  }
  if (!greek) {
    const bool vector = above.size() == 1 && above[0].form == IndexForm::letter && written.lower.empty() &&
                        written.dots == 0 && !is_tensor(reading, written) &&
                        is_known(reading.names, letter_with_marks(written), 1, false);
    if (vector) {  // `E^i` of `\mathbf E`, which is E_i
      WrittenSymbol component = written;
      component.lower.push_back(above[0]);
      component.lower.back().raised = false;
      return elaborate_symbol(reading, component, syntax[power].span, around);
    }
    const bool below = std::ranges::any_of(written.lower, is_greek_index);
    const bool several = above.size() > 1;
    const bool component =
        above.size() == 1 && (above[0].text == "0" || above[0].text == "1" ||
                              above[0].form == IndexForm::letter || has_first_component(syntax, written));
    if (!is_tensor(reading, written) || !(below || several || component)) return std::nullopt;
  }
  return with_indices(reading, written, above, syntax[power].span, around);
}

namespace {

/// `i`, `2`; not `0`, `x` or a word.
bool is_axis_of_space(const WrittenIndex& index) {
  if (index.form == IndexForm::digit) return index.text >= "1" && index.text <= "3" && index.text.size() == 1;
  return index.form == IndexForm::letter && index.text.size() == 1 && index.text >= "i" && index.text <= "n";
}

}  // namespace

std::optional<MaybeTyped> lowered_letter(Reading& reading, const WrittenSymbol& written, Span span,
                                         const Around& around) {
  const Evidence& evidence = evidence_of(reading);
  if (!evidence.space_time.shown || written.face != Face::plain || written.lower.empty()) return std::nullopt;
  const auto is_index = [&](const WrittenIndex& index) { return is_space_time_index(evidence, index); };
  const bool all = std::ranges::all_of(
      written.lower, [&](const WrittenIndex& index) { return !is_greek_index(index) || is_index(index); });
  const bool labels = std::ranges::any_of(written.lower, [&](const WrittenIndex& index) {
    return labels_particles(reading.names.symbols, index.text);
  });
  if (!all || labels || !is_tensor(reading, written)) return std::nullopt;
  const std::set<std::size_t>& counts = evidence.space_time.tensors.at(letter_with_marks(written));
  const bool greek = std::ranges::any_of(written.lower, is_index);
  const bool component = written.lower.size() > 1 && counts.contains(written.lower.size()) &&
                         std::ranges::all_of(written.lower, [](const WrittenIndex& index) {
                           return index.form == IndexForm::digit || index.form == IndexForm::letter;
                         });
  // In `a_ib^i` beside a^\mu and \mathbf a the sign depends on which of them is meant.
  if (!greek && !component && counts.contains(1) && written.lower.size() == 1 &&
      is_axis_of_space(written.lower[0]) &&
      reading.names.symbols.sightings->bold.contains({letter_with_marks(written), false}))
    return MaybeTyped(ambiguous(
        reading, span,
        fmt::format(
            "this can be a component of the vector `\\mathbf{{{0}}}`, or of `{0}` with its index below",
            written.letter)));
  if (!greek && !component) return std::nullopt;
  return with_indices(reading, written, {}, span, around);
}

bool is_four_vector(const Reading& reading, SyntaxId id) {
  if (!evidence_of(reading).space_time.shown || reading.syntax[id].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& written = reading.syntax.symbol(id);
  return written.face == Face::plain && is_tensor(reading, written) &&
         evidence_of(reading).space_time.tensors.at(letter_with_marks(written)).contains(1);
}

bool is_coordinate_on_line(const Reading& reading, const WrittenSymbol& written) {
  const SpaceTime& seen = evidence_of(reading).space_time;
  const bool plain = written.letter == "x" && written.lower.empty() && written.primes == 0;
  return seen.shown && plain && seen.on_line.contains("y") && seen.on_line.contains("z");
}

}  // namespace rigor
