// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/written_forms.h"

#include "base/among.h"

namespace rigor {
namespace {

std::string bare(const std::string& tag) {
  const bool brackets = tag.size() >= 2 && tag.front() == '(' && tag.back() == ')';
  return brackets ? tag.substr(1, tag.size() - 2) : tag;
}

}  // namespace

bool stands_at(const WrittenFormChain& chain, const std::string& place) {
  if (!chain.tag.empty() && bare(chain.tag) == bare(place)) return true;
  return is_one_of(place, chain.headings);
}

Notation notation_at(const WrittenForms& forms, const WrittenFormChain& chain) {
  Notation notation = forms.notation;
  notation.frame = chain.frame;
  return notation;
}

}  // namespace rigor
