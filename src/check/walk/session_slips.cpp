// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps of a chain that are refuted have to do with each other.
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "check/question/decision_cache.h"
#include "check/repair/chain_ends.h"
#include "check/walk/session.h"

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

}  // namespace

/// Is one side of a chain equal to another that is not beside it? Judged as a step would be.
Link Session::across(const ParsedChain& parsed, std::size_t left, std::size_t right, ChainReading& reading) {
  const Side& from = reading.sides[left];
  const Side& to = reading.sides[right];
  if (!from.typed || !to.typed) return Link::open;
  Diagnostics mismatches;
  const auto claim = reading.claim(parsed, right - 1, *from.typed, *to.typed, false, mismatches);
  if (!claim) return Link::open;
  switch (judge(tree_, names_, *claim, {}, options_.cache).verdict) {
    case Verdict::proved:
      return Link::holds;
    case Verdict::refuted:
      return Link::fails;
    default:
      return Link::open;
  }
}

/// Says of each refuted step of a chain whether it is the first wrong one, what becomes of its slip, and
/// whether it only takes back an earlier one.
void Session::explain_slips(const ParsedChain& parsed, std::size_t first_step, ChainReading& reading,
                            const Context& context) {
  const std::vector<WrittenRelation>& relations = parsed.written.relations;
  if (context.first_order || parsed.written.condition || relations.size() < 2 ||
      report_.steps.size() != first_step + relations.size())
    return;
  std::vector<Link> links;
  for (std::size_t k = 0; k < relations.size(); ++k)
    links.push_back(link_of(report_.steps[first_step + k], relations[k]));
  if (std::count(links.begin(), links.end(), Link::fails) == 0) return;
  options_.cache->begin(options_.effort);
  const auto decide_across = [&](std::size_t i, std::size_t k) { return across(parsed, i, k, reading); };
  const auto places = places_in_chain(links, decide_across);
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k]) explain_slip(parsed, first_step, k, *places[k]);
  }
}

void Session::explain_slip(const ParsedChain& parsed, std::size_t first_step, std::size_t which,
                           const ChainPlace& place) {
  const auto side = [&](std::size_t k) {
    return shorten(written(parsed.written.sides[k].span), longest_side);
  };
  Step& step = report_.steps[first_step + which];
  step.chain = place;
  step.chain->first_step += first_step;
  if (step.chain->undone_at) *step.chain->undone_at += first_step;
  const std::vector<WrittenRelation>& relations = parsed.written.relations;
  std::size_t last = which + 1;  // side of the equalities in a row
  while (last < relations.size() && is_equality(relations[last].kind)) ++last;
  if (place.undone_at == which + 1) {
    add_help(step, fmt::format("`{}` alone is wrong: `{} = {}` holds", side(which + 1), side(which),
                               side(which + 2)));
  } else if (place.undone_at) {
    add_help(step, fmt::format("the slip is undone later: `{} = {}` holds", side(which),
                               side(*place.undone_at + 1)));
  } else if (place.stays && which + 1 < last) {
    add_help(step, fmt::format("the slip stays to the end of the chain: `{} = {}` does not hold, either",
                               side(which), side(last)));
  }
  if (place.first_wrong) return;
  add_label(step, relations[place.first_step].span, "the first wrong step of the chain");
  add_help(step, place.undoes
                     ? fmt::format("this step takes back the slip of the first wrong one: `{} = {}` holds",
                                   side(place.first_step), side(which + 1))
                     : "a further slip: the step is wrong whatever becomes of the first wrong one");
}

}  // namespace rigor
