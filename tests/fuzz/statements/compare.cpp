// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare.h"

#include <fmt/format.h>

#include <algorithm>

namespace fuzz {
namespace {

std::optional<std::string> wrong_in(const Answer& answer, const std::vector<Truth>& truths) {
  if (!answer.failure.empty()) return answer.failure;
  if (!answer.error.empty()) return "an error on well-formed notes: " + answer.error;
  if (answer.steps.size() != truths.size())
    return fmt::format("{} steps were written, {} are reported", truths.size(), answer.steps.size());
  for (std::size_t k = 0; k < truths.size(); ++k) {
    const bool twofold = truths[k] == Truth::twofold;
    if (twofold && answer.steps[k] == Said::proved) return "proved, but it is false in another reading";
    if (twofold && answer.steps[k] == Said::refuted) return "refuted, but it is true in another reading";
    if (answer.steps[k] == Said::proved && truths[k] == Truth::fails) return "proved, but it is false";
    if (answer.steps[k] == Said::refuted && truths[k] == Truth::holds) return "refuted, but it is true";
  }
  return std::nullopt;
}

/// A letter's name without faces, braces and the indices that declare what it is.
std::string bare(std::string name) {
  for (const char* face : {"\\mathbf", "\\boldsymbol", "\\mathsf", "\\overleftrightarrow", "\\text",
                           "\\mathrm", "\\hat", "\\vec", "\\bm", "\\alpha", "_{ij}", "{", "}", " "}) {
    for (std::size_t at = name.find(face); at != std::string::npos; at = name.find(face))
      name.erase(at, std::string(face).size());
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

/// The sample of a refutation in our own letters; empty: it has others.
std::vector<Given> in_letters(const std::vector<Sampled>& sample, const std::vector<Letter>& letters) {
  std::vector<Given> found;
  for (const Sampled& sampled : sample) {
    for (std::size_t k = 0; k < letters.size(); ++k) {
      const Letter& letter = letters[k];
      const std::string name = letter.label.empty() ? letter.plain : letter.plain + "_" + letter.label;
      if (bare(name) == bare(sampled.symbol)) found.push_back({k, sampled.particle, sampled.components});
    }
  }
  return found.size() == sample.size() ? found : std::vector<Given>{};
}

/// What the refutation's own sample says: nothing, or what is wrong with it. It may show what we did not see.
std::optional<std::string> wrong_with_sample(const Claim& claim, const Statement& statement,
                                             const std::vector<Sampled>& sample, Random& random,
                                             Truth& truth) {
  const std::vector<Given> given = in_letters(sample, statement.letters);
  if (given.empty() || !same(read_otherwise(claim.left), claim.left) ||
      !same(read_otherwise(claim.right), claim.right))
    return std::nullopt;
  bool meets = true;
  const Truth there = truth_at(claim, statement.letters, statement.given, given, random, meets);
  if (!meets && !statement.contradictory) return "refuted with a sample that breaks what is given";
  if (there == Truth::holds) return "refuted with a sample on which it holds";
  if (truth == Truth::holds && there == Truth::fails) truth = Truth::fails;
  if (truth == Truth::holds && claim.relation != Relation::equal) truth = there;
  return std::nullopt;
}

/// `twofold`: a reading makes it true, another one false.
Truth truth_in_all_readings(const Claim& claim, const Statement& statement, Random& random) {
  if (statement.contradictory) {
    const Truth alone = truth_of(claim, statement.letters, {}, random);
    return alone == Truth::fails ? Truth::fails : Truth::unclear;
  }
  const Truth first = truth_of(claim, statement.letters, statement.given, random);
  const Claim other{read_otherwise(claim.left), read_otherwise(claim.right), claim.relation};
  if (same(other.left, claim.left) && same(other.right, claim.right)) return first;
  const Truth second = truth_of(other, statement.letters, statement.given, random);
  if (first == second) return first;
  return first == Truth::unclear || second == Truth::unclear ? Truth::unclear : Truth::twofold;
}

/// The beginning of a complaint, which stays when the notes become smaller.
std::string kind_of(const std::string& wrong) {
  const std::string kept = wrong.substr(0, wrong.find('`'));
  return kept.substr(0, 60);
}

/// Everything that is one node or one term smaller.
std::vector<Statement> smaller(const Statement& statement) {
  std::vector<Statement> all;
  if (statement.steps() > 1) {
    for (std::size_t k = 0; k < statement.steps(); ++k) {
      all.push_back(statement);
      all.back().sides = {statement.sides[k], statement.sides[k + 1]};
      all.back().relations = {statement.relations[k]};
    }
  }
  for (std::size_t k = 0; k < statement.given.size() && !statement.contradictory; ++k) {
    all.push_back(statement);
    all.back().given.erase(all.back().given.begin() + static_cast<std::ptrdiff_t>(k));
    if (!all.back().given.empty()) continue;
    for (Letter& letter : all.back().letters) letter.value = nullptr;
  }
  const auto with = [&](std::size_t side, std::size_t position, const Term& term) {
    all.push_back(statement);
    all.back().sides[side] = replaced(statement.sides[side], position, term);
  };
  for (std::size_t side = 0; side < statement.sides.size(); ++side) {
    for (std::size_t position = 0; position < size(statement.sides[side]); ++position) {
      const Term& node = node_at(statement.sides[side], position);
      for (const Term& part : node->parts)
        if (part->rank == node->rank) with(side, position, part);
      if ((node->op != Op::sum && node->op != Op::product) || node->parts.size() < 3) continue;
      for (std::size_t k = 0; k < node->parts.size(); ++k) {
        std::vector<Term> parts = node->parts;
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        with(side, position, rebuilt(node, parts));
      }
    }
  }
  return all;
}

}  // namespace

Compared compare(const Statement& statement, const Style& style, std::uint64_t seed, bool replay) {
  Compared compared;
  compared.answer = ask(file_name(style), notes(statement, style), replay);
  Random random(seed);
  for (std::size_t k = 0; k < statement.steps(); ++k)
    compared.truths.push_back(truth_in_all_readings(statement.step(k), statement, random));
  std::optional<std::string> wrong;
  for (std::size_t k = 0; k < std::min(statement.steps(), compared.answer.steps.size()); ++k) {
    if (compared.answer.steps[k] != Said::refuted || wrong || compared.truths[k] == Truth::twofold) continue;
    wrong = wrong_with_sample(statement.step(k), statement, compared.answer.samples[k], random,
                              compared.truths[k]);
  }
  compared.wrong = wrong ? wrong : wrong_in(compared.answer, compared.truths);
  return compared;
}

Disagreement shrunk(Statement statement, const Style& style, std::uint64_t seed, const std::string& wrong) {
  std::string last = wrong;
  bool changed = true;
  for (int round = 0; changed && round < 60; ++round) {
    changed = false;
    for (Statement& next : smaller(statement)) {
      if (!well_formed(next)) continue;
      const Compared compared = compare(next, style, seed, wrong.rfind("replay", 0) == 0);
      if (!compared.wrong || kind_of(*compared.wrong) != kind_of(wrong)) continue;
      last = *compared.wrong;
      statement = std::move(next);
      changed = true;
      break;
    }
  }
  return {last, notes(statement, style), file_name(style)};
}

namespace {

std::string page_of(const std::vector<Statement>& page, const Style& style) {
  std::string text;
  for (std::size_t k = 0; k < page.size(); ++k)
    text += section(page[k], style, fmt::format("{} {}", page[k].kind, k + 1)) + "\n";
  return text;
}

std::optional<Disagreement> wrong_on(const std::vector<Statement>& page, const std::vector<Truth>& truths,
                                     const Style& style) {
  const std::string text = page_of(page, style);
  const auto wrong = wrong_in(ask(file_name(style), text, true), truths);
  if (!wrong) return std::nullopt;
  return Disagreement{*wrong, text, file_name(style)};
}

/// Samples may miss where an order fails, and here no refutation's sample is looked at.
Truth truth_on_a_page(const Claim& claim, const Statement& statement, Random& random) {
  const Truth truth = truth_in_all_readings(claim, statement, random);
  return truth == Truth::holds && claim.relation != Relation::equal ? Truth::unclear : truth;
}

}  // namespace

std::optional<Disagreement> compare_page(const std::vector<Statement>& page, const Style& style,
                                         std::uint64_t seed) {
  Random random(seed);
  std::vector<std::vector<Truth>> truths;
  for (const Statement& statement : page) {
    truths.emplace_back();
    for (std::size_t k = 0; k < statement.steps(); ++k)
      truths.back().push_back(truth_on_a_page(statement.step(k), statement, random));
  }
  std::vector<Statement> kept = page;
  const auto flat = [&] {
    std::vector<Truth> all;
    for (const auto& some : truths) all.insert(all.end(), some.begin(), some.end());
    return all;
  };
  auto found = wrong_on(kept, flat(), style);
  for (std::size_t k = 0; found && k < kept.size();) {
    const auto with = kept;
    const auto with_truths = truths;
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(k));
    truths.erase(truths.begin() + static_cast<std::ptrdiff_t>(k));
    const auto fewer = kept.empty() ? std::nullopt : wrong_on(kept, flat(), style);
    if (fewer && kind_of(fewer->what) == kind_of(found->what)) {
      found = fewer;
      continue;
    }
    kept = with;
    truths = with_truths;
    ++k;
  }
  return found;
}

}  // namespace fuzz
