// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/repair_candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <utility>

#include "base/ascii.h"
#include "latex/reading/exchanges.h"
#include "latex/reading/placed_letters.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::array<const char*, 2> side_names{"left", "right"};

int distance_of(Slip slip) {
  switch (slip) {
    case Slip::sign:
    case Slip::order:
      return 20;
    case Slip::indices_swapped:
      return 21;
    case Slip::factor:
    case Slip::index:
      return 23;
    case Slip::power:
    case Slip::product:
    case Slip::bars:
      return 25;
    case Slip::term_extra:
    case Slip::term_missing:
      return 26;
    case Slip::indices_exchanged:
      return 22;
    case Slip::function:
    case Slip::inverted:
    case Slip::terms_exchanged:
    case Slip::letters_exchanged:
      return 24;
    case Slip::rate:
    case Slip::prime:
    case Slip::letter:
      return 28;
    case Slip::factor_missing:
    case Slip::factor_extra:
      return 29;
  }
  return 40;
}

std::string bare_text(TokenView tokens) {
  Tokens bare(tokens.begin(), tokens.end());
  std::erase_if(bare, [](const Token& token) { return is_blank(token) || is_spacing(token); });
  return text_of(bare);
}

/// `(a + b)` and `a + b` are the same.
bool are_alike(TokenView a, TokenView b) {
  const auto without_brackets = [](TokenView tokens) {
    Tokens bare(tokens.begin(), tokens.end());
    std::erase_if(bare, [](const Token& token) { return is_sign(token, "(") || is_sign(token, ")"); });
    return bare_text(bare);
  };
  return without_brackets(a) == without_brackets(b);
}

/// In `\mathbf a\cdot\mathbf b` a face and its letter are shown together.
void show_with_faces(TokenView side, Rewriting& change) {
  const auto is_face = [](const Token& token) { return style_of(token).has_value() || dots_of(token) > 0; };
  while (change.shown_begin > 0 && change.shown_begin < side.size() && is_face(side[change.shown_begin - 1]))
    --change.shown_begin;
  while (change.shown_end > change.shown_begin && change.shown_end < side.size() &&
         is_face(side[change.shown_end - 1]))
    ++change.shown_end;
}

/// Which letters stand there, with their faces, primes and subscripts.
std::set<std::string> symbols_in(TokenView side) {
  std::set<std::string> symbols;
  for (const PlacedLetter& letter : letters_in(side)) {
    std::size_t end = letter.end;
    while (is_sign_at(side, end, "'")) ++end;
    if (is_kind_at(side, end, TokenKind::subscript)) end = script_argument_at(side, end + 1).next;
    symbols.insert(bare_text(side.subspan(letter.begin, end - letter.begin)));
  }
  return symbols;
}

/// How many symbols one of them has alone.
int apart(const std::set<std::string>& a, const std::set<std::string>& b) {
  std::vector<std::string> alone;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(alone));
  return static_cast<int>(alone.size());
}

/// Does it change all that is in a bracket or an argument?
bool changes_all_inside(TokenView side, const Rewriting& change) {
  if (change.begin == 0 || change.end >= side.size()) return false;
  const Token& before = side[change.begin - 1];
  const Token& behind = side[change.end];
  const bool group = before.kind == TokenKind::begin_group && behind.kind == TokenKind::end_group;
  return group || (is_sign_of(before, "([,") && is_sign_of(behind, ")],"));
}

/// `\frac{2}{2}`
bool has_fraction_of_one(TokenView side) {
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (!is_fraction(side[k])) continue;
    const Argument upper = argument_at(side, k + 1);
    const Argument lower = argument_at(side, upper.next);
    if (!upper.content.empty() && bare_text(upper.content) == bare_text(lower.content)) return true;
  }
  return false;
}

/// `[-A, B]` says in another way what `-[A, B]` does, and nobody writes `\frac{x}{-2}`, `\frac{x}{1}` or a
/// fraction as a numerator.
bool is_roundabout(TokenView side, const Rewriting& change) {
  if (!changes_all_inside(side, change)) return false;
  if (change.slip == Slip::sign) return true;
  return change.slip == Slip::factor && !change.text.empty() &&
         (is_fraction(change.text[0]) || (change.text.size() == 1 && change.text[0].text == "1"));
}

/// `\epsilon_{ijk}` rather than `\epsilon_{kij}`.
bool orders_indices(TokenView side, const Rewriting& change) {
  const Tokens after = shown_after(side, change);
  return change.slip == Slip::indices_swapped && std::ranges::is_sorted(indices_in(after), {}, &Token::text);
}

}  // namespace

/// The sides of an equation speak of the same symbols as a rule: then the slip was the one that one of them
/// has alone.
int RepairCandidates::imbalance(std::size_t which, TokenView now) const {
  constexpr int likelier = 3;  // for each symbol
  constexpr int most = 9;
  const std::set<std::string> other = symbols_in(side(1 - which));
  const int before = apart(symbols_in(side(which)), other);
  const int gain = before - apart(symbols_in(now), other);
  return gain <= 0 ? 0 : gain == before ? -most : -std::min(most, likelier * gain);
}

/// How unlikely it is that the slip is on this side: another step supports it, or it is a name that is
/// defined.
int RepairCandidates::suspicion(std::size_t which) const {
  const Trust trust = which == 0 ? wrong_.left : wrong_.right;
  const bool name = which == 0 && end_of_letter(trim(side(0))) > 0 && letters_of({side(0)}).size() == 1 &&
                    side(0).size() <= 12 && terms_of_side(side(0)).size() == 1;
  return (which == 0 ? 1 : 0) + (trust == Trust::supported ? 12 : 0) - (trust == Trust::doubted ? 4 : 0) +
         (name ? 6 : 0);
}

RepairCandidate RepairCandidates::made(std::size_t which, Slip slip, Tokens tokens, std::string change,
                                       int further) const {
  const auto longer = static_cast<int>(tokens.size()) - static_cast<int>(side(which).size());
  const bool of_letters = slip == Slip::letter || slip == Slip::prime || slip == Slip::rate ||
                          slip == Slip::factor_missing || slip == Slip::factor_extra;
  const int balance = of_letters ? imbalance(which, tokens) : 0;
  const int distance = distance_of(slip) + std::clamp(longer, -4, 12) + further + suspicion(which) + balance;
  return {slip, which, std::move(tokens), std::move(change), distance};
}

/// A sign or factor inside of brackets is less likely than one before a term, and factors are in the order
/// of the alphabet as a rule.
RepairCandidate RepairCandidates::made(std::size_t which, const Rewriting& rewriting) const {
  Rewriting change = rewriting;
  show_with_faces(side(which), change);
  const std::string from =
      text_of(side(which).subspan(change.shown_begin, change.shown_end - change.shown_begin));
  const std::string to = text_of(shown_after(side(which), change));
  const bool inside = change.slip == Slip::sign || change.slip == Slip::factor;
  const bool in_order = (change.slip == Slip::order && to < from) || orders_indices(side(which), change);
  const int further = in_order ? -1 : is_roundabout(side(which), change) ? 8 : inside ? 2 : 0;
  const std::string words =
      to.empty()     ? fmt::format("`{}` is one too many on the {} side", from, side_names[which])
      : from.empty() ? fmt::format("`{}` is missing on the {} side", to, side_names[which])
                     : fmt::format("`{}` for `{}` on the {} side", to, from, side_names[which]);
  RepairCandidate candidate = made(which, change.slip, rewritten(side(which), change), words, further);
  candidate.roundabout = is_roundabout(side(which), change) ||
                         (has_fraction_of_one(candidate.tokens) && !has_fraction_of_one(side(which)));
  return candidate;
}

std::vector<RepairCandidate> RepairCandidates::rewritten_sides(bool whole_side) const {
  return made_by([&](TokenView side) { return rewritings_of(side, chain(), whole_side); });
}

std::vector<RepairCandidate> RepairCandidates::insertions() const {
  return made_by([&](TokenView side) { return insertions_of(side, chain()); });
}

std::vector<RepairCandidate> RepairCandidates::with_letters_near() const {
  constexpr int further = 4;
  std::vector<RepairCandidate> candidates =
      made_by([&](TokenView side) { return letters_from(wrong_.near, side, chain()); });
  for (RepairCandidate& each : candidates) each.distance += further;
  return candidates;
}

template <class Rewrite>
std::vector<RepairCandidate> RepairCandidates::made_by(const Rewrite& rewrite) const {
  constexpr std::size_t most = 1200;
  std::vector<RepairCandidate> candidates;
  for (const std::size_t which : {1u, 0u}) {
    for (const Rewriting& change : rewrite(side(which))) candidates.push_back(made(which, change));
  }
  sort_and_reduce(candidates, side(0), side(1));
  if (candidates.size() > most) candidates.erase(candidates.begin() + most, candidates.end());
  return candidates;
}

std::vector<ComparedTerm> RepairCandidates::terms() const {
  constexpr std::size_t most = 480;
  std::vector<ComparedTerm> terms;
  std::array<std::set<std::string>, 2> known;
  for (const std::size_t which : {0u, 1u}) {
    const std::vector<SideTerm> own = terms_of_side(side(which));
    for (std::size_t k = 0; k < own.size(); ++k) {
      terms.push_back({which, k, Tokens(own[k].with_sign.begin(), own[k].with_sign.end())});
      known[which].insert(text_of(without_layout(own[k].tokens)));
    }
  }
  const auto add_more = [&](TokenView term, int further) {
    const Tokens tokens = without_layout(term);
    for (const std::size_t which : {1u, 0u}) {
      if (terms.size() < most && known[which].insert(text_of(tokens)).second)
        terms.push_back({which, std::nullopt, tokens, further});
    }
  };
  std::vector<TokenView> nearby = chain();
  for (const TokenView other : nearby) {
    for (const SideTerm& term : terms_of_side(other)) add_more(term.tokens, 0);
  }
  for (const TokenView other : wrong_.near) {
    for (const SideTerm& term : terms_of_side(other)) add_more(term.tokens, 2);
  }
  for (const TokenView other : nearby) {
    for (const Tokens& term : expanded_terms_of(other)) add_more(term, 0);
  }
  for (const Tokens& term : field_terms_of(nearby)) add_more(term, 1);
  const Tokens one{{TokenKind::digit, "1", span_of(side(1))}};
  add_more(one, 2);
  for (const std::size_t which : {1u, 0u}) {
    for (const SideTerm& term : terms_of_side(side(which))) {
      for (const Tokens& image : images_of_term(term.tokens, nearby)) add_more(image, 1);
    }
  }
  nearby.insert(nearby.end(), wrong_.near.begin(), wrong_.near.end());
  for (const Tokens& product : products_of(letters_of(nearby))) add_more(product, 2);
  return terms;
}

std::vector<ComparedTerm> RepairCandidates::longer_terms() const {
  std::vector<ComparedTerm> terms;
  for (const Tokens& product : vector_products_of(chain())) {
    for (const std::size_t which : {1u, 0u}) terms.push_back({which, std::nullopt, product, 2});
  }
  return terms;
}

/// A term is missing in a sum, rather than beside the product that it equals.
bool RepairCandidates::is_the_shorter_sum(std::size_t which) const {
  return terms_of_side(side(which)).size() < 2 && terms_of_side(side(1 - which)).size() > 1;
}

RepairCandidate RepairCandidates::with(const ComparedTerm& term, Coefficient ratio) const {
  const long turned = term.side == 0 ? -ratio.numerator : ratio.numerator;
  const TokenView whole = side(term.side);
  if (!term.which) {
    const Rewriting more = with_term(whole, term.tokens, {turned, ratio.denominator});
    return made(term.side, Slip::term_missing, rewritten(whole, more),
                fmt::format("`{}` is missing on the {} side", text_of(more.text), side_names[term.side]),
                term.further + (is_the_shorter_sum(term.side) ? 4 : 0));
  }
  const Coefficient times{ratio.denominator + turned, ratio.denominator};
  const Rewriting change = with_coefficient(whole, *term.which, times);
  const bool usual = std::abs(times.numerator) <= 2 && times.denominator <= 2;
  return made(term.side, change.slip, rewritten(whole, change), words_for(term.side, *term.which, times),
              usual ? 0 : 2);
}

std::string RepairCandidates::words_for(std::size_t which, std::size_t term, Coefficient times) const {
  const bool alone = terms_of_side(side(which)).size() == 1;
  const std::string what = alone ? fmt::format("the {} side", side_names[which])
                                 : fmt::format("term {} on the {}", term + 1, side_names[which]);
  if (times.numerator == 0) return what + (alone ? " is 0" : " is one too many");
  if (times.numerator == -times.denominator) return what + " has the opposite sign";
  const std::string number = times.denominator == 1
                                 ? std::to_string(times.numerator)
                                 : fmt::format("{}/{}", times.numerator, times.denominator);
  return fmt::format("{} must be {} times as large", what, number);
}

void sort_and_reduce(std::vector<RepairCandidate>& candidates, TokenView left, TokenView right) {
  std::ranges::stable_sort(candidates, {}, &RepairCandidate::distance);
  std::array<std::set<std::string>, 2> known{std::set{bare_text(left)}, std::set{bare_text(right)}};
  std::erase_if(candidates, [&](const RepairCandidate& candidate) {
    return are_alike(candidate.tokens, candidate.side == 0 ? right : left) ||
           !known[candidate.side].insert(bare_text(candidate.tokens)).second;
  });
}

}  // namespace rigor
