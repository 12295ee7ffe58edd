// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text/explanation_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/paint.h"
#include "base/utf8.h"
#include "latex/layout/layout.h"
#include "latex/layout/mathml.h"
#include "latex/layout/plain_text.h"
#include "latex/layout/typeset.h"

namespace rigor {
namespace {

constexpr std::size_t widest_text = 72;  // cells next to which a rule is
constexpr double widest_line = 24;       // em

/// Mathematics that was printed, laid out.
Box layout_of_latex(const std::string& latex) {
  SourceMap sources;
  const FileId file = sources.add("", latex);
  return layout_of(lex(sources, {file, 0, static_cast<std::uint32_t>(latex.size())}));
}

std::string plain_text(const std::string& latex) { return to_plain_text(layout_of_latex(latex)); }

std::string plain_rule(const std::string& rule) {
  std::string text;
  for (const RulePart& part : rule_parts(rule)) text += part.is_math ? plain_text(part.text) : part.text;
  return text;
}

std::string sign_of(const ExplainedLine& line) {
  const std::string sign = plain_text(line.relation);
  if (line.kind != LineKind::not_reached) return sign;
  return sign == "=" ? "≟" : sign + "?";
}

Paint paint_of_line(LineKind kind) {
  if (kind == LineKind::holds) return Paint::faint;
  return kind == LineKind::refuted ? Paint::bad : Paint::open;
}

void append_block(std::string& text, const ExplainedBlock& block, const TerminalOptions& options) {
  std::size_t column = 0;
  std::vector<std::string> lines;
  for (const ExplainedLine& line : block.lines) {
    lines.push_back(line.kind == LineKind::words ? "" : sign_of(line) + " " + plain_text(line.latex));
    const std::size_t width = cells(lines.back());
    if (width <= widest_text) column = std::max(column, width);
  }
  if (!block.head.empty()) {
    text += "  " + plain_text(block.head);
    if (!block.rule.empty()) text += paint("  (" + plain_rule(block.rule) + ")", Paint::faint, options.color);
    text += "\n";
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const ExplainedLine& line = block.lines[k];
    text += "    " + lines[k];
    const std::string rule = plain_rule(line.rule);
    const std::size_t width = cells(lines[k]);
    const Paint style = paint_of_line(line.kind);
    if (line.kind == LineKind::words) {
      text += paint(rule, style, options.color);
    } else if (!rule.empty()) {
      if (width > column) text += "\n    " + std::string(column, ' ');
      if (width <= column) text += std::string(column - width, ' ');
      text += "   " + paint(rule, style, options.color);
    }
    text += "\n";
  }
}

/// Cut before + and − where at most `deepest` round brackets are open, so that the lines fit if they can.
std::vector<std::string> cut_within(const std::string& latex, int deepest, bool& fits) {
  std::vector<std::string> lines{""};
  int braces = 0;  // and environments
  int brackets = 0;
  std::size_t begin = 0;
  fits = true;
  const auto put = [&](std::size_t end) {
    const std::string term = latex.substr(begin, end - begin);
    const bool joins =
        lines.back().empty() || typeset_width(layout_of_latex(lines.back() + term)) <= widest_line;
    if (!joins) lines.emplace_back();
    lines.back() += term;
    fits = fits && typeset_width(layout_of_latex(lines.back())) <= widest_line;
    begin = end;
  };
  for (std::size_t at = 0; at < latex.size(); ++at) {
    const char c = latex[at];
    if (c == '{' || latex.compare(at, 6, "\\begin") == 0) ++braces;
    if (c == '}' || latex.compare(at, 4, "\\end") == 0) --braces;
    if (c == '(') ++brackets;
    if (c == ')') --brackets;
    const bool sign = (c == '+' || c == '-') && at > 0 && latex[at - 1] == ' ' && at + 1 < latex.size() &&
                      latex[at + 1] == ' ';
    if (sign && braces == 0 && brackets <= deepest) put(at - 1);
  }
  put(latex.size());
  return lines;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// Outside all brackets if that is enough, else inside them; brackets that grow cannot be cut.
std::vector<std::string> cut(const std::string& latex) {
  static constexpr int deepest = 3;
  bool fits = true;
  std::vector<std::string> lines;
  for (int depth = 0; depth <= deepest; ++depth) {
    lines = cut_within(latex, depth, fits);
    if (fits) break;
  }
  if (lines.size() == 1) return lines;
  for (std::string& line : lines) {
    for (const char* sign : {"(", ")", "|"}) {
      replace_all(line, std::string("\\left") + sign, std::string("\\Bigl") + sign);
      replace_all(line, std::string("\\right") + sign, std::string("\\Bigr") + sign);
    }
  }
  return lines;
}

/// `&& \text{definition of }\mathbf{v}_\alpha`
std::string rule_latex(const std::string& rule, bool for_tex) {
  std::string text;
  for (const RulePart& part : rule_parts(rule))
    text += part.is_math ? part.text : "\\text{" + (for_tex ? typeset_words(part.text) : part.text) + "}";
  return text;
}

/// The rows of an alignment, without its environment.
std::string rows_of_chain(const ExplainedChain& chain, bool for_tex) {
  std::vector<std::string> rows;
  for (const ExplainedBlock& block : chain.blocks) {
    if (!block.head.empty()) {
      rows.push_back("& " + block.head);
      if (!block.rule.empty()) rows.back() += " && " + rule_latex("(" + block.rule + ")", for_tex);
    }
    for (const ExplainedLine& line : block.lines) {
      if (line.kind == LineKind::words) {
        rows.push_back("&\\quad " + rule_latex(line.rule, for_tex));
        continue;
      }
      const std::vector<std::string> parts = for_tex ? cut(line.latex) : std::vector<std::string>{line.latex};
      for (std::size_t k = 0; k < parts.size(); ++k)
        rows.push_back(k == 0 ? "&\\quad " + shown_relation(line) + " " + parts[k]
                              : "&\\qquad {}" + parts[k]);
      if (!line.rule.empty()) rows.back() += " && " + rule_latex(line.rule, for_tex);
    }
  }
  return fmt::format("{}", fmt::join(rows, " \\\\\n"));
}

}  // namespace

std::string explanation_text(const std::vector<ExplainedChain>& chains, const TerminalOptions& options) {
  std::string text;
  for (const ExplainedChain& chain : chains) {
    text += paint(printable(chain.place), Paint::strong, options.color) + "\n";
    for (const ExplainedBlock& block : chain.blocks) append_block(text, block, options);
    text += "\n";
  }
  return text + tally_text(tally(chains)) + "\n";
}

std::string explanation_latex(const std::vector<ExplainedChain>& chains) {
  std::string text;
  for (const ExplainedChain& chain : chains) {
    text += "% " + printable(chain.place) + "\n\\begin{align*}\n" + rows_of_chain(chain, true) +
            "\n\\end{align*}\n";
  }
  return text + "% " + tally_text(tally(chains)) + "\n";
}

std::string explanation_mathml(const std::vector<ExplainedChain>& chains) {
  std::string text;
  for (const ExplainedChain& chain : chains)
    text += to_mathml(layout_of_latex("\\begin{aligned}" + rows_of_chain(chain, false) + "\\end{aligned}"),
                      MathStyle::display) +
            "\n";
  return text;
}

}  // namespace rigor
