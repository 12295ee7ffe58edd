// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ascii.h"
#include "base/version.h"
#include "base/xml.h"
#include "latex/layout/mathml.h"
#include "latex/layout/plain_text.h"
#include "report/page/page_parts.h"
#include "report/page/shown_totals.h"

namespace rigor {
namespace {

/// The body of one file, and its contents list.
class FileWriter {
 public:
  FileWriter(PageNotes& notes, SourceMap& sources, std::size_t number)
      : notes_(notes),
        math_(sources),
        page_{sources, math_, notes.link, notes.shown.report->file, notes.shown.derivations, notes.reading},
        number_(number) {}

  /// `below`: how many levels of heading are above those of the notes; 2 with the path as the first of
  /// them.
  void write(int below) {
    const bool titled = below == 2;
    if (titled) {
      body += fmt::format("<h2 class=\"file\" id=\"f{}\" data-level=\"0\">{}</h2>\n", number_,
                          xml_escaped(notes_.shown.report->path));
      contents += fmt::format("<li class=\"l0\"><a href=\"#f{}\">{}</a></li>\n", number_,
                              xml_escaped(notes_.shown.report->path));
    }
    file_diagnostics();
    for (const ShownItem& item : notes_.shown.items) {
      if (const auto* heading = std::get_if<ShownHeading>(&item)) add(*heading, below);
      if (const auto* equation = std::get_if<ShownEquation>(&item)) add(*equation);
    }
  }

  std::string body;
  std::string contents;

 private:
  void file_diagnostics() {
    const Diagnostics& all = notes_.shown.report->diagnostics;
    const std::string& failure = notes_.shown.report->failure;
    if (all.empty() && failure.empty()) return;
    body += "<section class=\"eq whole\" data-text=\"\"><h3>Of the file as a whole</h3>\n";
    for (const Diagnostic& each : all)
      body += diagnostic_html(page_, each) +
              fmt::format("<p class=\"quiet\">{}</p>", place_html(page_, each.span));
    if (!failure.empty())
      body += fmt::format("<div class=\"diagnostic\"><p><b>not checked to its end</b>: {}</p></div>",
                          xml_escaped(failure));
    body += "</section>\n";
  }

  void add(const ShownHeading& heading, int below) {
    math_.put_in_force(notes_.shown.macros.at(heading.macros));
    const int level = std::clamp(heading.level + below, 2, 6);
    const std::string id = fmt::format("s{}-{}", number_, ++headings_);
    const std::string title = line_html(page_, heading.title);
    section_ = lowered(heading.title);
    body += fmt::format("<h{0} id=\"{1}\" data-level=\"{2}\">{3}</h{0}>\n", level, id, heading.level, title);
    contents +=
        fmt::format("<li class=\"l{}\"><a href=\"#{}\">{}</a></li>\n", std::min(heading.level, 3), id, title);
  }

  void add(const ShownEquation& equation) {
    math_.put_in_force(notes_.shown.macros.at(equation.macros));
    std::string text = section_ + " " + equation.source;
    std::string tag;
    for (const Step* step : equation.steps) {
      text += " " + step->source + " " + step->tag + " " + verdict_words(*step);
      if (tag.empty()) tag = step->tag;
    }
    if (equation.shown) {
      text += " " + to_plain_text(equation.shown->box);
      if (!equation.shown->tag.empty()) tag = equation.shown->tag;
      if (equation.shown->tag.empty() && equation.shown->box.kind == BoxKind::table) tag.clear();
    }
    const std::uint32_t line = page_.sources.line_column(equation.span.file, equation.span.begin).line;
    body += fmt::format("<article class=\"eq{}\" id=\"e{}-{}\" data-text=\"{}\">\n",
                        equation.displayed ? "" : " said", number_, ++equations_, xml_escaped(lowered(text)));
    if (equation.displayed) {
      body +=
          fmt::format("<div class=\"display\"><div class=\"shown\">{}</div>{}</div>\n", shown_html(equation),
                      tag.empty() ? "" : "<span class=\"tag\">" + xml_escaped(tag) + "</span>");
    }
    body += steps_html(equation, line);
    body += forms_of(equation) + "</article>\n";
  }

  static std::string shown_html(const ShownEquation& equation) {
    return equation.shown ? to_mathml(equation.shown->box, MathStyle::display)
                          : "<pre>" + xml_escaped(equation.source) + "</pre>";
  }

  std::string steps_html(const ShownEquation& equation, std::uint32_t line) const {
    if (equation.steps.empty())
      return fmt::format("<p class=\"quiet nothing\">line {}: says nothing that can be checked</p>\n", line);
    const StepLine shown = !equation.displayed          ? StepLine::equation
                           : equation.steps.size() == 1 ? StepLine::gist
                                                        : StepLine::relation;
    std::string html = "<ol class=\"steps\">\n";
    for (const Step* step : equation.steps) html += step_html(page_, *step, shown);
    return html + "</ol>\n";
  }

  /// The chains that are in the display.
  std::string forms_of(const ShownEquation& equation) {
    std::string html;
    for (const EvaluatedChain& chain : notes_.evaluated.chains) {
      const Span span = chain.chain->span;
      const bool inside = page_.sources.path(span.file) == page_.sources.path(equation.span.file) &&
                          span.begin >= equation.span.begin && span.end <= equation.span.end;
      if (inside && equation.displayed && chain.chain->image == 0)
        html += forms_html(page_, chain, number_ * 10'000 + ++pictures_);
    }
    return html;
  }

  PageNotes& notes_;
  NotesMath math_;
  PageContext page_;
  std::size_t number_;
  std::size_t headings_ = 0;
  std::size_t equations_ = 0;
  std::size_t pictures_ = 0;
  std::string section_;
};

struct VerdictMeaning {
  Verdict verdict;
  std::string_view words;
};

constexpr std::array<VerdictMeaning, verdict_count> meanings{
    {{Verdict::proved, "equal for all values of the symbols, by an exact procedure"},
     {Verdict::refuted, "the sides differ on an exact sample, which is shown"},
     {Verdict::given, "assumed, as the notes say"},
     {Verdict::definition, "gives a name to something"},
     {Verdict::undecided, "neither proved nor refuted, for the reason that is given"},
     {Verdict::not_understood, "the notation is not read, so nothing is claimed"},
     {Verdict::skipped, "left out because a directive says so"},
     {Verdict::law, "stated, not concluded: it relates quantities, and later rows can follow from it"},
     {Verdict::suspect, "does not follow, but one slip of the pen away stands something that does"}}};

std::string filter_button(std::string_view kind, std::string_view sign, std::string_view words,
                          std::size_t count, bool pressed) {
  const std::string mark =
      sign.empty() ? "" : fmt::format("<span class=\"sign\" aria-hidden=\"true\">{}</span>", sign);
  return fmt::format(
      "<button type=\"button\" class=\"{0}\" data-filter=\"{0}\" aria-pressed=\"{1}\">{2}{3} "
      "<b>{4}</b></button>\n",
      kind, pressed, mark, words, count);
}

std::string controls(const ShownTotals& totals) {
  std::string html =
      "<div class=\"controls\" role=\"group\" aria-label=\"Filter the steps\" hidden>\n<div "
      "class=\"buttons\">\n";
  html += filter_button("all", "", "all", totals.steps, true);
  html += filter_button("attention", "!", "needs attention", totals.attention, false);
  for (const VerdictMeaning& meaning : meanings) {
    const std::uint32_t count = totals.counts.at(static_cast<std::size_t>(meaning.verdict));
    std::string words(name_of(meaning.verdict));
    std::ranges::replace(words, '-', ' ');
    if (count > 0)
      html += filter_button(name_of(meaning.verdict), sign_of(meaning.verdict), words, count, false);
  }
  if (totals.warned > 0) html += filter_button("warning", "△", "with a warning", totals.warned, false);
  return html +
         "</div>\n<div class=\"search\"><label for=\"find\">Find</label><input id=\"find\" type=\"search\" "
         "placeholder=\"tag, symbol, heading …\" autocomplete=\"off\" spellcheck=\"false\"><output "
         "id=\"shown\" "
         "aria-live=\"polite\"></output></div>\n</div>\n";
}

std::string legend(const ShownTotals& totals) {
  std::string html = "<dl class=\"legend\">\n";
  for (const VerdictMeaning& meaning : meanings) {
    const std::uint32_t count = totals.counts.at(static_cast<std::size_t>(meaning.verdict));
    if (count == 0) continue;
    html += fmt::format(
        "<div class=\"{}\"><dt><span class=\"sign\" aria-hidden=\"true\">{}</span>{}"
        "</dt><dd>{}</dd></div>\n",
        name_of(meaning.verdict), sign_of(meaning.verdict), counted(meaning.verdict, count), meaning.words);
  }
  return html + "</dl>\n";
}

/// The heading that is above all others of the only file, taken out of its items, with its macros put in
/// force; else the paths.
std::string take_title(NotesMath& math, std::vector<PageNotes>& notes) {
  if (notes.size() == 1) {
    std::vector<ShownItem>& items = notes.front().shown.items;
    const auto* first = items.empty() ? nullptr : std::get_if<ShownHeading>(&items.front());
    const auto is_top = [&](const ShownItem& item) {
      const auto* heading = std::get_if<ShownHeading>(&item);
      return heading != nullptr && heading->level <= first->level;
    };
    if (first != nullptr && std::ranges::count_if(items, is_top) == 1) {
      std::string title = first->title;
      math.put_in_force(notes.front().shown.macros.at(first->macros));
      items.erase(items.begin());
      return title;
    }
    return notes.front().shown.report->path;
  }
  return fmt::format("{} files of notes", notes.size());
}

}  // namespace

std::string html_page(std::vector<PageNotes>& notes, SourceMap& sources) {
  ShownTotals totals;
  for (const PageNotes& each : notes) add_to(totals, *each.shown.report);
  NotesMath title_math(sources);
  const std::string title = take_title(title_math, notes);
  const PageContext page{sources,
                         title_math,
                         notes.front().link,
                         notes.front().shown.report->file,
                         notes.front().shown.derivations,
                         notes.front().reading};
  std::string body;
  std::string contents;
  std::string paths;
  for (std::size_t k = 0; k < notes.size(); ++k) {
    FileWriter writer(notes[k], sources, k + 1);
    writer.write(notes.size() > 1 ? 2 : title == notes.front().shown.report->path ? 1 : 0);
    body += writer.body;
    contents += writer.contents;
    const std::string path = xml_escaped(notes[k].shown.report->path);
    paths += (k == 0 ? "" : ", ") +
             (notes[k].link.empty() ? path : fmt::format("<a href=\"{}\">{}</a>", notes[k].link, path));
  }
  const std::string nav = contents.empty() ? ""
                                           : "<nav class=\"contents\" aria-label=\"Contents\"><details "
                                             "open><summary>Contents</summary><ul>\n" +
                                                 contents + "</ul></details></nav>\n";
  const std::string lead = attention_words(totals, "<b>", "</b>") + ".";
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"rigor {}\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<a class=\"skip\" href=\"#equations\">Skip to the equations</a>\n"
      "<header class=\"top\">\n<p class=\"kicker\">Equations checked by rigor</p>\n<h1>{}</h1>\n"
      "<p class=\"paths\">{}</p>\n<p class=\"lead\">{}</p>\n"
      "<p class=\"quiet\">Headings and displayed equations with the verdict of each step; the prose of the "
      "notes is not "
      "reproduced. What a directive of the notes states stands in a dashed frame. Open a step to see "
      "why.</p>\n{}</header>\n{}<div class=\"page\">\n{}<main "
      "id=\"equations\" tabindex=\"-1\">\n{}"
      "<p class=\"none\" hidden>No step fits this filter.</p>\n</main>\n</div>\n"
      "<script>\n{}</script>\n</body>\n</html>\n",
      version, xml_escaped(title), page_style(), line_html(page, title), paths, lead, legend(totals),
      controls(totals), nav, body, page_script());
}

}  // namespace rigor
