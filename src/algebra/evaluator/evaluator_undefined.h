// SPDX-License-Identifier: GPL-3.0-or-later
// Where an expression may have no value, for `evaluator.h`: 0 · 1/0 has none. What is free of quotients and
// roots has one for all values of its symbols, and after a factor 0 it is not evaluated.
#pragma once

#include "algebra/evaluator/evaluator.h"

namespace rigor {

/// Throws or rejects as evaluating would where there is no value. A root needs no value that is known
/// exactly.
template <class Domain>
void Evaluator<Domain>::demand_value(ExprId id) {
  if (!may_lack_value(id)) return;
  if (node(id).op == Op::root) {
    domain_->check_root(scalar(child(id)));
  } else {
    static_cast<void>(array(id));
  }
}

/// Does it divide, or take a root or a logarithm of what may be negative? Definitions are unfolded; each node
/// is asked once.
template <class Domain>
bool Evaluator<Domain>::may_lack_value(ExprId id) {
  if (may_lack_value_.empty()) may_lack_value_.resize(tree_->size());
  if (const auto known = may_lack_value_[static_cast<std::size_t>(id)]) return *known;
  const Level level(depth_);
  const ExprNode& here = node(id);
  bool may_lack = here.op == Op::divide || here.op == Op::root || here.op == Op::real_power ||
                  (here.op == Op::power && here.exponent < 0) ||
                  (here.op == Op::function && here.function > Function::exp);
  const Definition* definition = here.op == Op::symbol ? scope_->definition_of(here.symbol) : nullptr;
  if (definition != nullptr) may_lack = may_lack_value(definition->body);
  for (const ExprId each : tree_->children(id)) may_lack = may_lack || may_lack_value(each);
  may_lack_value_[static_cast<std::size_t>(id)] = may_lack;
  return may_lack;
}

}  // namespace rigor
