// SPDX-License-Identifier: GPL-3.0-or-later
// Every chain of the notes in derivations/, explained and checked again.
#include "algebra/decide/decide.h"
#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "derive/chain/explanation.h"

using namespace rigor;

namespace {

/// Is what stands before a step equal to what stands behind it, in the step's own question or in one that
/// knows the definitions behind earlier equations?
bool holds(const WrittenForms& forms, const Question& question, const Explanation& explanation) {
  ExprId before = explanation.start;
  for (const SmallStep& step : explanation.steps) {
    if (!step.nearly) {
      Question small = question;
      small.tree = &forms.tree;
      small.claim.left = before;
      small.claim.right = step.expr;
      small.claim.indices.insert(small.claim.indices.end(), explanation.letters.begin(),
                                 explanation.letters.end());
      if (decide(small, {.simplest_sample = false}).outcome == Outcome::refuted) return false;
    }
    before = step.expr;
  }
  return true;
}

struct Share {
  int chains = 0;
  int explained = 0;
  int by_cases = 0;
  int wrong = 0;
};

Share share_of(const std::string& path) {
  SourceMap sources;
  FormsReading reading = read_forms(sources, path, {});
  WrittenForms& forms = reading.forms;
  Share share;
  for (std::size_t c = 0; c < forms.chains.size(); ++c) {
    bool any = false;
    bool all = true;
    for (std::size_t s = 0; s < forms.chains[c].steps.size(); ++s) {
      if (!forms.chains[c].steps[s].question || forms.chains[c].steps[s].outcome != Outcome::proved) continue;
      any = true;
      const Explanation explanation = explain_step(forms, c, s);
      all = all && !explanation.gap;
      share.by_cases += explanation.by_cases ? 1 : 0;
      const auto& nearly = forms.chains[c].steps[s].nearly_question;
      const Question own = nearly ? nearly->exact : *forms.chains[c].steps[s].question;
      std::vector<KnownEquation> earlier;
      for (std::size_t k = 0; k <= c; ++k) earlier.push_back({{}, "", forms.chains[k].definitions});
      const Question question = widened(forms.tree, own, earlier);
      share.wrong += holds(forms, question, explanation) ? 0 : 1;
    }
    share.chains += any ? 1 : 0;
    share.explained += any && all ? 1 : 0;
  }
  return share;
}

}  // namespace

TEST_CASE("four of five chains of the notes are explained by steps that hold, few of them by cases") {
  for (const char* name :
       {"rigid-bodies.md", "rotating-frames.tex", "vector-calculus.tex", "vector-identities.tex"}) {
    INFO(name);
    const Share share = share_of(std::string("derivations/") + name);
    CHECK(share.chains > 20);
    CHECK(5 * share.explained >= 4 * share.chains);
    CHECK(20 * share.by_cases <= share.chains);
    CHECK(share.wrong == 0);
  }
}
