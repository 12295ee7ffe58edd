// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/explained.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/ascii.h"
#include "derive/notation/tidied.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// The lines of one chain as they come.
class Lines {
 public:
  Lines(WrittenForms& forms, std::size_t chain)
      : forms_(forms), chain_(forms.chains[chain]), notation_(notation_at(forms, chain_)) {}

  /// Goes on from an expression: in the block at hand if it ends with it.
  void start_at(ExprId from, std::string rule, const WrittenForm* form) {
    const bool goes_on = last_ && rule.empty() && same_expression(forms_.tree, *last_, forms_.tree, from);
    if (goes_on) return;
    blocks_.push_back({print(from), std::move(rule), {}});
    last_ = from;
    if (form == nullptr || !takes_derivatives(*form, from)) return;
    blocks_.back().head = form->expanded;
    blocks_.back().lines.push_back({"=", print(tidied(forms_.tree, from)), "derivatives taken"});
  }

  /// The last line as the notes write it, where a derivative in it has been carried out.
  void end_at(ExprId to, const WrittenForm& form) {
    if (!takes_derivatives(form, to)) return;
    ExplainedBlock& block = blocks_.back();
    if (block.lines.size() == 1 && block.lines[0].latex == block.head) block.lines.clear();
    block.lines.push_back({"=", form.expanded, "derivatives taken"});
  }

  /// A small step that nobody can see is not shown.
  void add_small(std::string relation, ExprId expr, std::string rule) {
    const auto& lines = blocks_.back().lines;
    if (lines.empty() || lines.back().latex != print(expr)) add(std::move(relation), expr, std::move(rule));
    last_ = expr;
  }
  void add(std::string relation, ExprId expr, std::string rule, LineKind kind = LineKind::holds) {
    blocks_.back().lines.push_back({std::move(relation), print(expr), std::move(rule), kind});
    last_ = expr;
  }
  void add_words(std::string words) {
    if (blocks_.empty()) blocks_.emplace_back();
    blocks_.back().lines.push_back({"", "", std::move(words), LineKind::words});
    last_.reset();
  }
  void end_block() { last_.reset(); }
  [[nodiscard]] std::string print(ExprId expr) const { return print_latex(forms_.tree, expr, notation_); }
  [[nodiscard]] std::vector<ExplainedBlock> take() { return std::move(blocks_); }

 private:
  /// An operator that the notes write has been carried out in what the tree holds.
  [[nodiscard]] bool takes_derivatives(const WrittenForm& form, ExprId expr) const {
    const std::string printed = print(expr);
    for (const std::string_view sign : {"\\nabla", "\\partial", "\\frac{d}{dt}", "\\frac{d^2}{dt^2}",
                                        "\\frac{\\mathrm{d}}{\\mathrm{d}t}"}) {
      if (form.expanded.find(sign) != std::string::npos && printed.find(sign) == std::string::npos)
        return true;
    }
    return false;
  }

  WrittenForms& forms_;
  const WrittenFormChain& chain_;
  Notation notation_;
  std::vector<ExplainedBlock> blocks_;
  std::optional<ExprId> last_;
};

std::string names_of(const ExprTree& tree, const std::vector<IndexId>& letters) {
  std::string names;
  for (const IndexId letter : letters) names += (names.empty() ? "" : ", ") + tree.name(letter);
  return names;
}

ExplainedAs explain_one(WrittenForms& forms, std::size_t chain, std::size_t step, Lines& lines) {
  const WrittenForm left = forms.chains[chain].forms[step];
  const WrittenForm right = forms.chains[chain].forms[step + 1];
  const WrittenStep written = forms.chains[chain].steps[step];
  if (!left.expr || !right.expr) {
    lines.add_words(left.other_space || right.other_space
                        ? "matrices and vectors of another size than three are not explained yet"
                        : "not understood: `rigor check` says why");
    return ExplainedAs::open;
  }
  const std::string relation = written.nearly && written.kind == "=" ? "\\approx" : written.kind;
  if (written.defines || written.given) {
    lines.start_at(*left.expr, "", nullptr);
    lines.add(relation, *right.expr, written.defines ? "definition" : "given");
    return ExplainedAs::known;
  }
  if (written.outcome == Outcome::refuted) {
    lines.start_at(*left.expr, "", &left);
    lines.add(relation == "=" ? "\\ne" : relation, *right.expr,
              written.expected_refuted ? "refuted, as expected" : "refuted", LineKind::refuted);
    lines.end_block();
    return written.expected_refuted ? ExplainedAs::expected_refuted : ExplainedAs::refuted;
  }
  if (written.outcome != Outcome::proved) {
    lines.start_at(*left.expr, "", &left);
    lines.add(relation, *right.expr,
              written.stated    ? "stated as a law"
              : written.outcome ? "not decided by `rigor check`"
                                : "not understood by `rigor check`",
              LineKind::not_reached);
    lines.end_block();
    return ExplainedAs::open;
  }
  const Explanation explanation = explain_step(forms, chain, step);
  const bool components = !explanation.letters.empty();
  const std::string rule = components ? "component " + names_of(forms.tree, explanation.letters) : "";
  lines.start_at(explanation.steps.empty() ? *left.expr : explanation.start, rule,
                 components ? nullptr : &left);
  for (const SmallStep& small : explanation.steps)
    lines.add_small(small.nearly ? "\\approx" : "=", small.expr, small.rule);
  if (explanation.gap) {
    lines.add(relation, *right.expr, "not reached: " + *explanation.gap, LineKind::not_reached);
    lines.end_block();
    return ExplainedAs::open;
  }
  if (components) {
    lines.end_block();
  } else {
    lines.end_at(*right.expr, right);
  }
  return explanation.by_cases ? ExplainedAs::by_cases : ExplainedAs::small;
}

}  // namespace

std::string shown_relation(const ExplainedLine& line) {
  return line.kind == LineKind::not_reached ? "\\overset{?}{" + line.relation + "}" : line.relation;
}

ExplainedChain explain_chain(WrittenForms& forms, std::size_t chain, const SourceMap& sources) {
  const WrittenFormChain& written = forms.chains[chain];
  ExplainedChain explained;
  const LineColumn place = sources.line_column(written.span.file, written.span.begin);
  explained.place = fmt::format("{}:{}", sources.path(written.span.file), place.line);
  if (!written.tag.empty()) explained.place += " " + written.tag;
  if (written.image > 0) explained.place += fmt::format(", cyclic image {}", written.image);
  Lines lines(forms, chain);
  for (std::size_t step = 0; step < forms.chains[chain].steps.size(); ++step) {
    const bool assumed = forms.chains[chain].assumed;
    if (assumed) forms.chains[chain].steps[step].given = true;
    explained.steps.push_back(explain_one(forms, chain, step, lines));
  }
  explained.blocks = lines.take();
  return explained;
}

ExplainedTally tally(const std::vector<ExplainedChain>& chains) {
  ExplainedTally tally;
  for (const ExplainedChain& chain : chains) {
    const ExplainedTally before = tally;
    for (const ExplainedAs step : chain.steps) {
      if (step == ExplainedAs::known || step == ExplainedAs::expected_refuted) continue;
      ++tally.steps;
      if (step == ExplainedAs::refuted) ++tally.refuted;
      if (step == ExplainedAs::by_cases) ++tally.by_cases;
      if (step == ExplainedAs::small || step == ExplainedAs::by_cases) ++tally.explained;
    }
    if (tally.steps == before.steps) continue;
    ++tally.chains;
    if (tally.steps - before.steps == tally.explained - before.explained) ++tally.whole;
  }
  return tally;
}

std::string tally_text(const ExplainedTally& tally) {
  std::string text = fmt::format("explained {} of {} step{} in {} chain{}", tally.explained, tally.steps,
                                 tally.steps == 1 ? "" : "s", tally.chains, tally.chains == 1 ? "" : "s");
  if (tally.chains > 1 && tally.whole < tally.chains)
    text += fmt::format(", {} of them whole ({} %)", tally.whole, 100 * tally.whole / tally.chains);
  if (tally.by_cases > 0) text += fmt::format(", {} component by component", tally.by_cases);
  if (tally.refuted > 0) text += fmt::format("; {} refuted", tally.refuted);
  return text;
}

std::vector<RulePart> rule_parts(const std::string& rule) {
  std::vector<RulePart> parts;
  const auto is_math = [&](const std::string& word) {
    if (word.find_first_of("\\_^{}") != std::string::npos) return true;
    const bool letter = word.size() == 1 && is_letter(word[0]);
    if (letter && word != "a") return true;
    const bool sign = word == "=" || word == "+" || word == "-" ||
                      word.find_first_not_of("0123456789.") == std::string::npos;
    return sign && !parts.empty() && parts.back().is_math;
  };
  for (std::size_t at = 0; at < rule.size();) {
    const std::size_t end = std::min(rule.find(' ', at), rule.size());
    const std::string word = rule.substr(at, end - at);
    const bool math = !word.empty() && is_math(word);
    if (parts.empty() || parts.back().is_math != math) {
      if (!parts.empty() && !parts.back().is_math) parts.back().text += ' ';
      parts.push_back({math, (parts.empty() || math ? "" : " ") + word});
    } else {
      parts.back().text += ' ' + word;
    }
    at = end + 1;
  }
  return parts;
}

}  // namespace rigor
