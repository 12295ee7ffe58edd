// SPDX-License-Identifier: GPL-3.0-or-later
// A definition by cases over index values becomes a table of its values.
#include <fmt/format.h>

#include "elaborate/notation/elaborator.h"
#include "elaborate/notation/index_condition.h"

namespace rigor {

std::optional<Typed> Elaborator::cases(SyntaxId id) {
  const Span span = syntax_[id].span;
  if (slot_letters_.empty() || slot_letters_.size() > 4)
    return unsupported(span, "cases are read in the definition of a symbol with index letters only");
  std::vector<std::string> letters;
  std::vector<Slot> slots;
  for (const FreeIndex& free : slot_letters_) {
    letters.push_back(free.letter);
    slots.push_back({0, index(free.letter)});
  }
  std::vector<ExprId> values;
  std::size_t size = 1;
  for (std::size_t k = 0; k < letters.size(); ++k) size *= 3;
  constexpr std::uint8_t open = 0xff;
  Table table{std::vector<std::uint8_t>(size, open)};
  const std::span<const SyntaxChild> children = syntax_.children(id);
  for (std::size_t k = 0; k + 1 < children.size(); k += 2) {
    const Maybe value = expression(children[k].id);
    if (!value) return std::nullopt;
    if (value->rank != 0 || !value->free.empty())
      return unsupported(syntax_[children[k].id].span,
                         "a case with indices or vectors of its own is not read");
    const std::string& words = syntax_.text(children[k + 1].id);
    const auto holds = read_index_condition(words, letters);
    if (!holds)
      return unsupported(syntax_[children[k + 1].id].span,
                         fmt::format("the condition `{}` is not understood", words));
    if (values.size() >= 100) return unsupported(span, "more than 100 cases are not read");
    for (std::size_t at = 0; at < size; ++at) {
      if ((*holds)[at] && table.entry[at] == open) table.entry[at] = static_cast<std::uint8_t>(values.size());
    }
    values.push_back(value->id);
  }
  for (const std::uint8_t entry : table.entry) {
    if (entry == open) return unsupported(span, "the cases do not cover all values of the indices");
  }
  Typed typed;
  for (const FreeIndex& free : slot_letters_) {
    if (!is_bound_letter(free.letter)) typed.free.push_back({free.letter, index(free.letter), span});
  }
  typed.id = tree_.add_table(span, values, slots, std::move(table));
  return typed;
}

}  // namespace rigor
