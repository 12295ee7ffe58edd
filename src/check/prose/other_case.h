// SPDX-License-Identifier: GPL-3.0-or-later
// Has another case been named since something was said? "In incompressible flow" a law is stated; what a row
// behind "let the flow be compressible" concludes does not follow from it, with or without a blank line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/prose/prose.h"

namespace rigor {

/// The case for which something is said, by the words of its sentence, of the sentences before it in its
/// paragraph, and of its heading.
struct CaseSaid {
  std::vector<std::string> words = {};
  std::size_t sentence = 0;  // its number
  std::string heading = {};
};

[[nodiscard]] CaseSaid case_said_at(const Prose& prose, std::size_t event, const std::string& heading);
/// The same of something in a line.
[[nodiscard]] CaseSaid case_said_in(const Prose& prose, std::size_t sentence, const std::string& heading);

/// "In the opposite direction", "now it goes down": in the sentences behind one, up to the display at
/// `event`, or beside it.
[[nodiscard]] bool names_an_opposite_since(const Prose& prose, std::size_t event, std::size_t sentence);

/// What is named between these and a row.
class CasesNamed {
 public:
  /// Up to the display at `event`, in its section and those around it. What is said is not kept: `prose` must
  /// outlive this. Cost: linear in the words of cases.
  CasesNamed(const Prose& prose, std::size_t event, const std::string& heading);
  /// Was another case named since, and not the same one again? `defines`: see `is_kind_shut_out_by()`.
  [[nodiscard]] bool names_another_since(const CaseSaid& said, bool defines = false) const;

 private:
  const std::vector<std::string>& different_;  // words of all cases
  std::size_t sentence_;                       // that leads to the row
  std::vector<CaseWord> named_;                // in the sentences before it
  std::vector<std::string> last_clause_;       // and in its own
  std::vector<std::string> in_heading_;
  std::string heading_;
};

}  // namespace rigor
