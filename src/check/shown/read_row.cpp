// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/shown/read_row.h"

#include <array>

namespace rigor {
namespace {

constexpr std::array<std::string_view, 9> role_names{"unread",   "skipped",   "definition",
                                                     "given",    "condition", "approximation",
                                                     "identity", "law",       "conclusion"};
constexpr std::array<std::string_view, 10> letter_kind_names{
    "scalar",   "vector",         "unit vector",     "tensor", "symmetric tensor",
    "rotation", "function value", "unit of measure", "index",  "particle label"};
constexpr std::array<std::string_view, 6> source_kind_names{"directive", "definition", "words",
                                                            "face",      "indexed",    "first"};
constexpr std::array<std::string_view, 5> ground_kind_names{"definition", "given", "said", "law",
                                                            "conclusion"};

template <class Names, class Value>
std::string_view entry_of(const Names& names, Value value) {
  return names[static_cast<std::size_t>(value)];
}

}  // namespace

std::string_view name_of(RowRole role) { return entry_of(role_names, role); }
std::string_view name_of(LetterKind kind) { return entry_of(letter_kind_names, kind); }
std::string_view name_of(SourceKind kind) { return entry_of(source_kind_names, kind); }
std::string_view name_of(Ground::Kind kind) { return entry_of(ground_kind_names, kind); }

}  // namespace rigor
