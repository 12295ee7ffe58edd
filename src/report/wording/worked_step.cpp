// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/worked_step.h"

#include <string_view>

#include "derive/chain/explanation.h"
#include "expr/print/print_latex.h"

namespace rigor {
namespace {

WorkedStep worked(WrittenForms& forms, std::size_t chain, std::size_t step) {
  const Explanation explained = explain_step(forms, chain, step);
  const WrittenFormChain& of = forms.chains[chain];
  const Notation notation = notation_at(forms, of);
  WorkedStep derivation{.span = cover(of.forms[step].span, of.forms[step + 1].span),
                        .image = of.image,
                        .start = print_latex(forms.tree, explained.start, notation),
                        .lines = {},
                        .gap = explained.gap};
  for (const SmallStep& each : explained.steps)
    derivation.lines.push_back(
        {each.nearly ? "\\approx" : "=", print_latex(forms.tree, each.expr, notation), each.rule});
  return derivation;
}

}  // namespace

std::vector<WorkedStep> worked_steps(WrittenForms& forms) {
  std::vector<WorkedStep> all;
  for (std::size_t chain = 0; chain < forms.chains.size(); ++chain) {
    for (std::size_t step = 0; step < forms.chains[chain].steps.size(); ++step) {
      const WrittenFormChain& of = forms.chains[chain];
      const WrittenStep& written = of.steps[step];
      const bool is_proved = written.outcome == Outcome::proved && !written.defines;
      if (is_proved && of.forms[step].expr && of.forms[step + 1].expr)
        all.push_back(worked(forms, chain, step));
    }
  }
  return all;
}

int cyclic_image_of(const Step& step) {
  constexpr std::string_view mark = " (cyclic image ";
  const std::string written = step.left + " " + step.relation + " " + step.right;
  if (!step.source.starts_with(written)) return 0;
  const std::string_view behind = std::string_view(step.source).substr(written.size());
  return behind.starts_with(mark) && behind.size() > mark.size() ? behind[mark.size()] - '0' : 0;
}

const WorkedStep* worked_step_of(const std::vector<WorkedStep>& all, const SourceMap& sources,
                                 const Step& step) {
  if (step.verdict != Verdict::proved) return nullptr;
  const int image = cyclic_image_of(step);
  for (const WorkedStep& each : all) {
    const bool same = each.span.begin == step.span.begin && each.span.end == step.span.end &&
                      each.image == image && sources.path(each.span.file) == sources.path(step.span.file);
    if (same && (!each.lines.empty() || each.gap)) return &each;
  }
  return nullptr;
}

}  // namespace rigor
