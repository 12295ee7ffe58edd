// SPDX-License-Identifier: GPL-3.0-or-later
// What tests ask of a decision. A refutation counts only if its sample can be replayed, and comes out the
// same twice.
#pragma once

#include <optional>
#include <string>

#include "algebra/decide/decide.h"
#include "algebra/engine/exact_number.h"
#include "expr/build.h"

namespace rigor::build {

[[nodiscard]] inline bool is_proved(const Question& question) {
  return decide(question).outcome == Outcome::proved;
}

[[nodiscard]] inline bool is_same(const Sample& a, const Sample& b) {
  const auto text = [](const Sample& sample) {
    std::string all = std::to_string(sample.particles) + '|' + sample.left + '|' + sample.right;
    for (const auto axis : sample.axes) all += '|' + std::to_string(axis);
    for (const auto particle : sample.free_particles) all += '|' + std::to_string(particle);
    for (const SampleValue& value : sample.values) {
      all += ";" + std::to_string(static_cast<std::uint32_t>(value.symbol)) + '#' +
             std::to_string(value.particle);
      for (const std::string& component : value.components) all += ' ' + component;
    }
    return all;
  };
  return text(a) == text(b);
}

/// Refuted by a sample on which the sides differ, or are not in order, when it is replayed.
[[nodiscard]] inline bool is_refuted(const Question& question) {
  const Decision decision = decide(question);
  const Decision again = decide(question);
  if (decision.outcome != Outcome::refuted || !decision.sample || !again.sample) return false;
  const std::optional<SideValues> sides = replay(question, *decision.sample);
  if (!sides || sides->left != decision.sample->left || sides->right != decision.sample->right) return false;
  const auto left = from_text(sides->left);  // none of what is enclosed
  const auto right = from_text(sides->right);
  const bool differ =
      left && right ? !is_related(*left, question.claim.relation, *right) : sides->left != sides->right;
  return differ && is_same(*decision.sample, *again.sample);
}

/// The reason why a question is left open; empty if it is not.
[[nodiscard]] inline std::string reason_open(const Question& question, const Limits& limits = {}) {
  const Decision decision = decide(question, limits);
  return decision.outcome == Outcome::undecided ? decision.reason : "";
}

/// The value of a symbol in a sample, its components joined by blanks; empty if it has none.
[[nodiscard]] inline std::string value_of(const Sample& sample, const Named& symbol,
                                          std::uint32_t particle = 0) {
  std::string text;
  for (const SampleValue& value : sample.values) {
    if (value.symbol != symbol.symbol || value.particle != particle) continue;
    for (const std::string& component : value.components) text += (text.empty() ? "" : " ") + component;
  }
  return text;
}

}  // namespace rigor::build
