// SPDX-License-Identifier: GPL-3.0-or-later
// A definition by cases over index values becomes a table of its values.
#include <fmt/format.h>

#include "elaborate/notation/index_condition.h"
#include "elaborate/notation/notations.h"

namespace rigor {

MaybeTyped elaborate_cases(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  if (around.slots.empty() || around.slots.size() > 4)
    return unsupported(reading, span, "cases are read only in the definition of a symbol with index letters");
  if (space_of(reading.names.symbols) != common_space)
    return unsupported(reading, span, "cases by index values are read in three dimensions only");
  std::vector<std::string> letters;
  std::vector<Slot> slots;
  for (const FreeIndex& free : around.slots) {
    letters.push_back(free.letter);
    slots.push_back({0, index_named(reading, free.letter)});
  }
  std::vector<ExprId> values;
  std::size_t size = 1;
  for (std::size_t k = 0; k < letters.size(); ++k) size *= 3;
  constexpr std::uint8_t open = 0xff;
  Table table{std::vector<std::uint8_t>(size, open)};
  const std::span<const SyntaxChild> children = syntax.children(id);
  for (std::size_t k = 0; k + 1 < children.size(); k += 2) {
    const auto value = elaborate(reading, children[k].id, around);
    if (!value) return std::nullopt;
    if (value->rank != 0 || !value->free.empty())
      return unsupported(reading, syntax[children[k].id].span,
                         "a case with indices or vectors of its own is not read");
    const std::string& words = syntax.text(children[k + 1].id);
    const auto holds = read_index_condition(words, letters);
    if (!holds)
      return unsupported(reading, syntax[children[k + 1].id].span,
                         fmt::format("the condition `{}` is not understood", words));
    if (values.size() >= 100) return unsupported(reading, span, "more than 100 cases are not read");
    for (std::size_t at = 0; at < size; ++at) {
      if ((*holds)[at] && table.entry[at] == open) table.entry[at] = static_cast<std::uint8_t>(values.size());
    }
    values.push_back(value->id);
  }
  for (const std::uint8_t entry : table.entry) {
    if (entry == open) return unsupported(reading, span, "the cases do not cover all values of the indices");
  }
  Typed typed;
  for (const FreeIndex& free : around.slots) {
    if (!reading.indices.summed.contains(free.letter))
      typed.free.push_back({free.letter, index_named(reading, free.letter), span});
  }
  typed.id = reading.tree.add_table(span, values, slots, std::move(table));
  return typed;
}

}  // namespace rigor
