// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a value is in a list.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string_view>

namespace rigor {

/// An entry of the list equals the value.
template <class Value, class List>
[[nodiscard]] constexpr bool is_one_of(const Value& value, const List& list) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}
[[nodiscard]] constexpr bool is_one_of(std::string_view word, std::initializer_list<std::string_view> list) {
  return std::ranges::find(list, word) != list.end();
}

}  // namespace rigor
