// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of letters decides what they are: a letter that is bold somewhere is a vector. Evidence of a
// section and of those around it is a section's own; other evidence may help a proof, and refutes nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "check/event/notes.h"
#include "elaborate/name/names.h"

namespace rigor {

/// Notes in `names.symbols.sightings` how every symbol is written in the events that are asked for. Gives the
/// directives that say what its subscripts are.
Directives sight_events(const Notes& notes, Names& names,
                        const std::function<bool(std::size_t)>& is_asked_for);

/// While it lives, only what is seen in an event's own section, and in those around it, counts.
class LocalKinds {
 public:
  LocalKinds(const Notes& notes, Names& names, std::size_t event);
  ~LocalKinds();
  LocalKinds(const LocalKinds&) = delete;
  LocalKinds& operator=(const LocalKinds&) = delete;

  /// The directives that say what the subscripts in these sections are: what they are for may be in a row
  /// that is not read.
  [[nodiscard]] const Directives& used() const { return used_; }

  /// A letter of the chain that is a vector, or has indices, by another section only.
  [[nodiscard]] std::optional<std::string> borrowed_letter(const SyntaxTree& syntax,
                                                           const ParsedChain& parsed) const;

 private:
  Names& names_;
  Shared<Sightings> everywhere_;
  Directives used_;
};

}  // namespace rigor
