// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/spins.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t most_spins = 64;

/// `1` as 2, `\tfrac32` as 3; nothing for anything else, or a large number.
std::optional<int> doubled_spin(const SyntaxTree& syntax, SyntaxId id) {
  const auto number = [&](SyntaxId each) -> std::optional<int> {
    if (syntax[each].kind != SyntaxKind::number) return std::nullopt;
    const std::string& digits = syntax.text(each);
    const bool small = digits.size() <= 2 && digits.find_first_not_of("0123456789") == std::string::npos;
    return small ? std::optional(std::stoi(digits)) : std::nullopt;
  };
  if (syntax[id].kind != SyntaxKind::fraction) {
    const auto whole = number(id);
    return whole ? std::optional(2 * *whole) : std::nullopt;
  }
  return number(syntax.child(id, 1)) == 2 ? number(syntax.child(id, 0)) : std::nullopt;
}

/// What stands between these signs; nothing where something else does.
std::optional<std::vector<int>> doubled_spins(const SyntaxTree& syntax, SyntaxId side, Joint sign) {
  std::vector<int> spins;
  for (const SyntaxChild& child : syntax.children(side)) {
    const auto spin = doubled_spin(syntax, child.id);
    const bool joined = child.joint == sign || (spins.empty() && child.joint == Joint::none);
    if (!spin || !joined) return std::nullopt;
    spins.push_back(*spin);
  }
  return spins;
}

/// What spins make together, each as often as it occurs.
std::vector<int> combined(const std::vector<int>& spins) {
  std::vector<int> made{spins.front()};
  for (std::size_t k = 1; k < spins.size() && made.size() <= most_spins; ++k) {
    std::vector<int> next;
    for (const int each : made) {
      for (int spin = std::abs(each - spins[k]); spin <= each + spins[k]; spin += 2) next.push_back(spin);
    }
    made = std::move(next);
  }
  std::ranges::sort(made);
  return made;
}

bool makes(const SyntaxTree& syntax, SyntaxId product, SyntaxId sum) {
  if (syntax[product].kind != SyntaxKind::term || syntax[sum].kind != SyntaxKind::sum) return false;
  const auto factors = doubled_spins(syntax, product, Joint::cross);
  auto terms = doubled_spins(syntax, sum, Joint::plus);
  if (!factors || !terms || factors->size() < 2 || terms->size() < 2) return false;
  std::ranges::sort(*terms);
  return combined(*factors) == *terms;
}

}  // namespace

bool may_combine_spins(const SyntaxTree& syntax, SyntaxId left, SyntaxId right) {
  return makes(syntax, left, right) || makes(syntax, right, left);
}

}  // namespace rigor
