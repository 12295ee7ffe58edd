// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of a chain that are refuted have to do with each other.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/utf8.h"
#include "check/place/place.h"
#include "check/question/decision_cache.h"
#include "check/repair/chain_ends.h"

namespace rigor {
namespace {

constexpr std::size_t longest_side = 60;  // cells of a side that is named in a sentence

Link link_of(const Step& step, const WrittenRelation& relation) {
  if (!is_equality(relation.kind)) return Link::no_equality;
  switch (step.verdict) {
    case Verdict::proved:
    case Verdict::given:
    case Verdict::definition:
      return Link::holds;
    case Verdict::refuted:
      return Link::fails;
    default:
      return Link::open;
  }
}

void add_help(Step& step, std::string help) {
  for (Diagnostic& diagnostic : step.diagnostics) {
    if (diagnostic.kind == DiagnosticKind::refuted) diagnostic.help.push_back(std::move(help));
  }
}

void add_label(Step& step, Span span, std::string text) {
  for (Diagnostic& diagnostic : step.diagnostics) {
    if (diagnostic.kind == DiagnosticKind::refuted) diagnostic.labels.push_back({span, std::move(text)});
  }
}

/// Is one side of a chain equal to another that is not its neighbour? Judged as a step would be.
Link across(RowPlace& place, const ParsedChain& parsed, std::size_t left, std::size_t right,
            ChainReading& reading) {
  const Side& from = reading.sides[left];
  const Side& to = reading.sides[right];
  if (!from.typed || !to.typed) return Link::open;
  Diagnostics mismatches;
  const auto claim = reading.claim(parsed, right - 1, *from.typed, *to.typed, false, mismatches);
  if (!claim) return Link::open;
  switch (judge_here(place, *claim).verdict) {
    case Verdict::proved:
      return Link::holds;
    case Verdict::refuted:
      return Link::fails;
    default:
      return Link::open;
  }
}

void explain_slip(const RowPlace& place, const ParsedChain& parsed, std::size_t first_step,
                  const ChainPlace& at, Step& step, std::size_t which) {
  const auto side = [&](std::size_t k) {
    return shorten(written_at(place, parsed.written.sides[k].span), longest_side);
  };
  step.chain = at;
  step.chain->first_step += first_step;
  if (step.chain->undone_at) *step.chain->undone_at += first_step;
  const std::vector<WrittenRelation>& relations = parsed.written.relations;
  std::size_t last = which + 1;  // side of the equalities in a row
  while (last < relations.size() && is_equality(relations[last].kind)) ++last;
  if (at.undone_at == which + 1) {
    add_help(step, fmt::format("`{}` alone is wrong: `{} = {}` holds", side(which + 1), side(which),
                               side(which + 2)));
  } else if (at.undone_at) {
    add_help(step,
             fmt::format("the slip is undone later: `{} = {}` holds", side(which), side(*at.undone_at + 1)));
  } else if (at.stays && which + 1 < last) {
    add_help(step, fmt::format("the slip stays to the end of the chain: `{} = {}` does not hold, either",
                               side(which), side(last)));
  }
  if (at.first_wrong) return;
  add_label(step, relations[at.first_step].span, "the first wrong step of the chain");
  add_help(step, at.undoes
                     ? fmt::format("this step takes back the slip of the first wrong one: `{} = {}` holds",
                                   side(at.first_step), side(which + 1))
                     : "a further slip: the step is wrong even if the first wrong one is mended");
}

}  // namespace

void explain_slips(RowPlace& place, const ParsedChain& parsed, ChainReading& reading, std::size_t first_step,
                   std::span<Step> steps) {
  const std::vector<WrittenRelation>& relations = parsed.written.relations;
  if (parsed.written.condition || relations.size() < 2 || steps.size() != relations.size()) return;
  std::vector<Link> links;
  for (std::size_t k = 0; k < relations.size(); ++k) links.push_back(link_of(steps[k], relations[k]));
  if (std::ranges::count(links, Link::fails) == 0) return;
  place.options.cache->begin(place.options.effort);
  const auto decide_across = [&](std::size_t i, std::size_t k) {
    return across(place, parsed, i, k, reading);
  };
  const auto places = places_in_chain(links, decide_across);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k]) explain_slip(place, parsed, first_step, *places[k], steps[k], k);
  }
}

}  // namespace rigor
