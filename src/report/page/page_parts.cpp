// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/xml.h"
#include "latex/layout/layout_reader.h"
#include "latex/layout/mathml.h"
#include "report/text/bench_text.h"
#include "report/wording/advice.h"
#include "report/wording/finding.h"
#include "report/wording/sample.h"

namespace rigor {
namespace {

constexpr std::size_t most_panels = 4;

/// Words of a line as text, all else as mathematics.
std::string words_html(const Box& box) {
  if (box.kind == BoxKind::words) return xml_escaped(box.text);
  if (box.kind != BoxKind::row) return to_mathml(box, MathStyle::inline_);
  const bool has_words =
      std::ranges::any_of(box.parts, [](const Box& part) { return part.kind == BoxKind::words; });
  if (!has_words) return is_empty(box) ? "" : to_mathml(box, MathStyle::inline_);
  std::string html;
  for (const Box& part : box.parts)
    html += part.kind == BoxKind::words ? xml_escaped(part.text) : to_mathml(part, MathStyle::inline_);
  return html;
}

/// What is between back-ticks is mathematics.
std::string ticked_math_html(const PageContext& page, std::string_view text) {
  std::string html;
  for (bool code = false; true; code = !code) {
    const std::size_t tick = text.find('`');
    const std::string part(text.substr(0, tick));
    html += code ? math_html(page, part, MathStyle::inline_) : xml_escaped(part);
    if (tick == std::string_view::npos) return html;
    text.remove_prefix(tick + 1);
  }
}

std::string uses_html(const PageContext& page, const Step& step) {
  if (step.uses.empty()) return {};
  std::string list = "<ul>";
  for (const std::string& use : step.uses) list += "<li>" + use_html(page, use) + "</li>";
  return term_html("uses", list + "</ul>");
}

std::string sample_html(const PageContext& page, const Counterexample& sample) {
  std::string html;
  const auto values = [&](std::uint32_t particle) {
    std::string list;
    for (const std::string& equation : sample_equations(sample, particle))
      list += "<li>" + math_html(page, equation, MathStyle::inline_) + "</li>";
    return list.empty() ? list : "<ul class=\"values\">" + list + "</ul>";
  };
  std::string all = values(0);
  for (std::uint32_t particle = 1; particle <= sample.particles; ++particle)
    all += fmt::format("<p class=\"particle\">particle {}</p>{}", particle, values(particle));
  if (!all.empty()) html += term_html("sample", all);
  const std::string component = sample_component(sample);
  const std::string where =
      component.empty() ? "" : fmt::format(" <span class=\"quiet\">({})</span>", xml_escaped(component));
  if (sample.squared_distance)
    return html +
           term_html("there", fmt::format("|left − right|² is <b>{}</b>{}", xml_escaped(sample.left), where));
  return html + term_html("there", fmt::format("left is <b>{}</b>, right is <b>{}</b>{}",
                                               xml_escaped(sample.left), xml_escaped(sample.right), where));
}

std::string repairs_html(const PageContext& page, const Step& step) {
  std::string html;
  for (const Repair& repair : step.repairs) {
    html += term_html(
        html.empty() ? heading_of_repairs(step) : "or",
        fmt::format("<div class=\"shown\">{}</div><p class=\"quiet\">{}</p>",
                    math_html(page, repair.statement, MathStyle::display), message_html(remark_on(repair))));
  }
  for (const std::string& condition : step.conditions)
    html += term_html("holds if", math_html(page, condition, MathStyle::inline_));
  return html;
}

std::string chain_html(const Step& step) {
  if (!step.chain) return {};
  const ChainPlace& place = *step.chain;
  if (place.undoes) return term_html("in the chain", "takes back the slip of an earlier step");
  if (!place.first_wrong) return term_html("in the chain", "follows an earlier step that is wrong");
  std::string words = "the first step that is wrong";
  if (place.stays) words += "; its slip stays to the end";
  if (place.undone_at) words += "; a later step takes its slip back";
  return term_html("in the chain", words);
}

std::string derivation_html(const PageContext& page, const Step& step) {
  const WorkedStep* derivation = worked_step_of(page.derivations, page.sources, step);
  if (derivation == nullptr) return {};
  if (derivation->gap) return term_html("in small steps", "none: " + message_html(*derivation->gap));
  const auto printed = [&](const std::string& latex) {
    return to_mathml(page.math.box_of_printed(latex), MathStyle::inline_);
  };
  std::string lines = "<li>" + printed(derivation->start) + "</li>";
  for (const WorkedLine& line : derivation->lines)
    lines += fmt::format("<li><span class=\"math\">{}</span> <span class=\"rule\">{}</span></li>",
                         printed(line.relation + " " + line.latex), words_html(page.math.rule_of(line.rule)));
  return term_html("in small steps", "<ol class=\"small\">" + lines + "</ol>");
}

std::string kinds_of(const Step& step) {
  std::string kinds(name_of(step.verdict));
  if (needs_attention(step)) kinds += " attention";
  const bool warned = std::ranges::any_of(
      step.diagnostics, [](const Diagnostic& each) { return each.severity() == Severity::warning; });
  return warned ? kinds + " warning" : kinds;
}

/// One line of what matters, for the summary of a step that is a whole display.
std::string gist_html(const Step& step) {
  if (!step.diagnostics.empty()) return message_html(step.diagnostics.front().message);
  return message_html(step.route);
}

}  // namespace

std::string math_html(const PageContext& page, const std::string& latex, MathStyle style) {
  const auto box = page.math.box_of(latex);
  return box ? to_mathml(*box, style) : "<code>" + xml_escaped(latex) + "</code>";
}

std::string line_html(const PageContext& page, const std::string& prose) {
  return words_html(page.math.line_of(prose, format_of(page.sources.path(page.file))));
}

std::string message_html(std::string_view message) {
  std::string html;
  bool code = false;
  while (true) {
    const std::size_t tick = message.find('`');
    html += xml_escaped(message.substr(0, tick));
    if (tick == std::string_view::npos) break;
    html += code ? "</code>" : "<code>";
    code = !code;
    message.remove_prefix(tick + 1);
  }
  return code ? html + "</code>" : html;
}

std::string place_html(const PageContext& page, Span span) {
  const std::uint32_t line = page.sources.line_column(span.file, span.begin).line;
  const std::string text = fmt::format("{}:{}", xml_escaped(page.sources.path(span.file)), line);
  if (page.link.empty() || span.file != page.file) return "<span class=\"path\">" + text + "</span>";
  return fmt::format("<a class=\"path\" href=\"{}#L{}\">{}</a>", page.link, line, text);
}

std::string term_html(std::string_view term, std::string_view what) {
  return fmt::format("<div class=\"row\"><dt>{}</dt><dd>{}</dd></div>\n", term, what);
}

std::string use_html(const PageContext& page, const std::string& text) {
  const Use use = use_of(text);
  std::string html = xml_escaped(use.word);
  if (!use.latex.empty()) html += " " + math_html(page, use.latex, MathStyle::inline_);
  if (!use.place.empty())
    html +=
        (use.word == "convention" ? ": " + ticked_math_html(page, use.place) : " " + message_html(use.place));
  return html;
}

std::string diagnostic_html(const PageContext& page, const Diagnostic& diagnostic) {
  std::string html =
      fmt::format("<p><b>{}</b>: {} <span class=\"quiet\">[{}]</span></p>", name_of(diagnostic.severity()),
                  message_html(diagnostic.message), info(diagnostic.kind).name);
  for (const Label& label : diagnostic.labels) {
    if (!label.text.empty())
      html += fmt::format("<p class=\"quiet\">{}: {}</p>", place_html(page, label.span),
                          message_html(label.text));
  }
  for (const std::string& help : diagnostic.help) html += fmt::format("<p>help: {}</p>", message_html(help));
  return fmt::format("<div class=\"diagnostic\">{}</div>", html);
}

std::string step_html(const PageContext& page, const Step& step, StepLine line) {
  const std::string whole = step.left + " " + step.relation + " " + step.right;
  std::string what = "<span class=\"what quiet\">" + gist_html(step) + "</span>";
  const int image = cyclic_image_of(step);
  if (line != StepLine::gist || image > 0) {
    const bool is_whole = line != StepLine::relation || image > 0;
    what = fmt::format(
        "<span class=\"what math\">{}{}</span>", image > 0 ? fmt::format("cyclic image {} of ", image) : "",
        math_html(page, is_whole ? whole : step.relation + " " + step.right, MathStyle::inline_));
  }
  std::string details;
  if (line == StepLine::relation && image == 0)
    details = fmt::format("<div class=\"shown\">{}</div>", math_html(page, whole, MathStyle::display));
  std::string rows;
  if (step.counterexample) rows += sample_html(page, *step.counterexample);
  rows += chain_html(step) + repairs_html(page, step);
  if (!step.route.empty()) rows += term_html("route", xml_escaped(step.route));
  rows += derivation_html(page, step) + uses_html(page, step);
  std::string diagnostics;
  for (const Diagnostic& diagnostic : step.diagnostics) diagnostics += diagnostic_html(page, diagnostic);
  if (!diagnostics.empty()) rows += term_html("report", diagnostics);
  rows += term_html("place", place_html(page, step.span));
  const bool attention = needs_attention(step);
  return fmt::format(
      "<li class=\"step {0}{1}\" data-kinds=\"{2}\"><details{3}><summary><span class=\"mark\"><span "
      "class=\"sign\" "
      "aria-hidden=\"true\">{4}</span>{5}</span>{6}</summary>\n<div "
      "class=\"details\">{7}<dl>\n{8}</dl>{9}</div></details></li>\n",
      name_of(step.verdict),
      attention               ? " attention"
      : step.expected_refuted ? " expected"
                              : "",
      kinds_of(step), attention ? " open" : "", sign_of(step.verdict), verdict_words(step), what, details,
      rows, reading_html(page, step));
}

std::string forms_html(const PageContext& page, const EvaluatedChain& evaluated, std::size_t number) {
  const auto advice = advise(evaluated.result);
  if (!advice) return {};
  std::string list;
  for (std::size_t form = 0; form < evaluated.result.forms.size(); ++form) {
    const WrittenForm& written = evaluated.chain->forms[evaluated.result.forms[form].side];
    list += fmt::format("<div class=\"row\"><dt>{}</dt><dd class=\"math\">{}</dd></div>\n", form_letter(form),
                        math_html(page, written.source, MathStyle::inline_));
  }
  std::string picture;
  if (!advice->all_alike) {
    picture = bench_picture(evaluated, telling_trials(evaluated.result, most_panels));
    const auto replace = [&](std::string_view from, const std::string& to) {
      for (std::size_t at = picture.find(from); at != std::string::npos;
           at = picture.find(from, at + to.size()))
        picture.replace(at, from.size(), to);
    };
    replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    replace("id=\"clip", fmt::format("id=\"f{}-clip", number));
    replace("url(#clip", fmt::format("url(#f{}-clip", number));
    if (const std::size_t start = picture.find("<svg"); start != std::string::npos) picture.erase(0, start);
    picture = "<figure class=\"plot\">" + picture + "</figure>";
  }
  return fmt::format(
      "<details class=\"forms\"><summary><span class=\"mark\">{} forms</span><span class=\"what quiet\">in "
      "floating "
      "point</span></summary><div class=\"details\"><p>{}</p><dl>{}</dl>{}</div></details>\n",
      evaluated.result.forms.size(), message_html(advice_text(evaluated.result, *advice)), list, picture);
}

}  // namespace rigor
