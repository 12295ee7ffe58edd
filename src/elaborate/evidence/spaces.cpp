// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/ascii.h"

namespace rigor {
namespace {

/// Words for another number of dimensions.
constexpr std::array<std::string_view, 16> other_dimensions{
    "two dimension",    "two-dimension",  "2-dimension",         "2 dimension",
    "four dimension",   "four-dimension", "4-dimension",         "4 dimension",
    "n dimension",      "n-dimension",    "d dimension",         "d-dimension",
    "higher dimension", "any dimension",  "arbitrary dimension", "any number of dimension"};

/// Words for a space whose metric is not δ.
constexpr std::array<std::string_view, 6> other_metrics{"spacetime",   "space-time", "minkowski",
                                                        "four-vector", "4-vector",   "four-moment"};

/// Words for three dimensions whose components do not belong to right-handed Cartesian axes.
constexpr std::array<std::string_view, 12> other_axes{"curvilinear",
                                                      "non-orthogonal",
                                                      "oblique",
                                                      "covariant",
                                                      "contravariant",
                                                      "metric tensor",
                                                      "christoffel",
                                                      "left-handed",
                                                      "cylindrical coordinate",
                                                      "spherical coordinate",
                                                      "polar coordinate",
                                                      "skew coordinate"};

/// In formulas of a line; those with matrices of three rows are not among them.
constexpr std::array<std::string_view, 14> other_formulas{
    "\\mathbb{R}^2", "\\mathbb{R}^4", "\\mathbb{R}^n", "\\mathbb{R}^d", "\\mathbb R^2",
    "\\mathbb R^4",  "\\mathbb R^n",  "\\mathbb R^d",  "n\\times n",    "n \\times n",
    "N\\times N",    "N \\times N",   "2\\times 2",    "2\\times2"};

/// The first phrase that begins a word of the text, up to the end of its last word; small letters.
template <std::size_t n>
std::string_view first_in(std::string_view text, const std::array<std::string_view, n>& phrases) {
  for (const std::string_view phrase : phrases) {
    for (auto at = text.find(phrase); at != std::string_view::npos; at = text.find(phrase, at + 1)) {
      if (at > 0 && is_letter_or_digit(text[at - 1]) && is_letter_or_digit(phrase[0])) continue;
      std::size_t end = at + phrase.size();
      while (end < text.size() && is_letter_or_digit(phrase.back()) && is_letter_or_digit(text[end])) ++end;
      return text.substr(at, end - at);
    }
  }
  return {};
}

/// `$D = 4$ dimensions`, `$n$-dimensional`, not `$3$ dimensions`.
std::string_view counted_dimensions(std::string_view text) {
  for (const std::string_view behind : {"$ dimension", "$-dimension"}) {
    const auto at = text.find(behind);
    if (at != std::string_view::npos && at > 0 && text[at - 1] != '3')
      return text.substr(at + 2, behind.size() - 2);
  }
  return {};
}

/// "Indices run from 0 to 3", "the index runs from $1$ to $n$": not from 1 to 3.
std::string_view counted_indices(std::string_view text) {
  constexpr std::string_view from = " from ";
  const auto subject = std::min(text.find("indices"), text.find("index"));
  if (subject == std::string_view::npos) return {};
  const auto at = text.find(from, subject);
  const auto end = text.find_first_of(".;:", subject);
  if (at == std::string_view::npos || at > end) return {};
  const std::string_view verb = text.substr(subject, at - subject);
  if (verb.find(" run") == std::string_view::npos && verb.find(" range") == std::string_view::npos) return {};
  std::string range;
  for (const char c : text.substr(at + from.size(), end - at - from.size())) {
    if (c != '$' && c != '{' && c != '}') range += c;
  }
  const bool three = range.starts_with("1 to 3") || range.starts_with("one to three");
  return three ? std::string_view{} : text.substr(subject, std::min(end, text.size()) - subject);
}

}  // namespace

void see_spaces(std::string_view text, Evidence& evidence) {
  const std::string lower = lowered_line(text);
  if (evidence.other_metric.empty()) evidence.other_metric = first_in(lower, other_metrics);
  if (evidence.other_space.empty()) evidence.other_space = first_in(lower, other_dimensions);
  if (evidence.other_space.empty()) evidence.other_space = first_in(lower, other_metrics);
  if (evidence.other_space.empty()) evidence.other_space = first_in(text, other_formulas);
  if (evidence.other_space.empty()) evidence.other_space = counted_dimensions(lower);
  if (evidence.other_space.empty()) evidence.other_space = counted_indices(lower);
  if (evidence.other_axes.empty()) evidence.other_axes = first_in(lower, other_axes);
}

}  // namespace rigor
