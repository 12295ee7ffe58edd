// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/document.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/version.h"
#include "latex/layout/layout_reader.h"
#include "latex/layout/typeset.h"
#include "report/page/notes_math.h"
#include "report/page/shown_totals.h"
#include "report/wording/finding.h"
#include "report/wording/sample.h"

namespace rigor {
namespace {

constexpr double line_width = 33;           // in em, for mathematics next to a mark
constexpr double small_width = 34;          // in em of the small print, for mathematics next to a rule
constexpr double most_derived_width = 110;  // in em of the small print: no line of a derivation is wider
constexpr double most_width = 300;          // in em: what is wider is shown as source

constexpr std::string_view preamble = R"tex(\documentclass[11pt,a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp}
\IfFileExists{lmodern.sty}{\usepackage{lmodern}}{}
\usepackage{amsmath,amssymb,graphicx,color}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0pt}
\raggedbottom
\hbadness=10000 \vbadness=10000
\emergencystretch=3em
\definecolor{proved}{rgb}{0.08,0.36,0.20}
\definecolor{refuted}{rgb}{0.65,0.11,0.09}
\definecolor{named}{rgb}{0.20,0.33,0.56}
\definecolor{open}{rgb}{0.47,0.29,0.00}
\definecolor{quiet}{rgb}{0.33,0.35,0.38}
\newsavebox{\rigorbox}
\newsavebox{\rigorside}
\newlength{\rigorroom}
% mathematics, made smaller where it is wider than \rigorroom
\newcommand{\rigorfit}[1]{\sbox{\rigorbox}{$#1$}%
  \ifdim\wd\rigorbox>\rigorroom\resizebox{0.995\rigorroom}{!}{\usebox{\rigorbox}}\else\usebox{\rigorbox}\fi}
% indent, mathematics, tag, mark
\newcommand{\rigorline}[4]{\par\setlength{\rigorroom}{7em}%
  \sbox{\rigorside}{\quad\rigorfit{\text{#3}}\quad\hbox to 8.4em{#4\hfil}}%
  \setlength{\rigorroom}{\dimexpr\linewidth-\wd\rigorside-#1\relax}%
  \hbox to\linewidth{\hspace*{#1}\rigorfit{\displaystyle #2}\hfill\usebox{\rigorside}}\vspace{4pt}}
\newcommand{\rigormark}[3]{{\footnotesize\color{#1}\hbox to 1.4em{$#2$\hfil}#3}}
\newcommand{\rigorplain}[2]{\par\setlength{\rigorroom}{\dimexpr\linewidth-#1\relax}%
  \hbox to\linewidth{\hspace*{#1}\rigorfit{\displaystyle #2}\hfill}\vspace{4pt}}
% indent, mathematics, the rule in words
\newcommand{\rigorsmall}[3]{\par{\leftskip=0pt\rightskip=0pt\setlength{\rigorroom}{0.64\textwidth}%
  \hbox to\textwidth{\hspace*{#1}\rigorfit{\displaystyle #2}\hfill\parbox{0.24\textwidth}{\raggedright\linewidth=0.24\textwidth #3}}}\vspace{2pt}}
\newcommand{\rigorinline}[1]{\setlength{\rigorroom}{\linewidth}\rigorfit{#1}}
\newenvironment{rigornote}{\par\begingroup\footnotesize\color{quiet}\leftskip=2em\rightskip=0pt plus 1fil\advance\linewidth-2em\relax\parskip=1.5pt}{\par\endgroup\vspace{4pt}}
\newcommand{\rigorhead}[2]{\par\vspace{14pt}{\raggedright #1\bfseries #2\par}\nobreak\vspace{6pt}}
\begin{document}
)tex";

std::string document_mark(const Step& step) {
  struct Look {
    std::string_view colour, sign;
  };
  const Look look = [&]() -> Look {
    switch (step.verdict) {
      case Verdict::proved:
        return {"proved", "\\checkmark"};
      case Verdict::refuted:
        return {"refuted", "\\times"};
      case Verdict::definition:
        return {"named", ":="};
      case Verdict::given:
        return {"quiet", "\\diamond"};
      case Verdict::undecided:
        return {"open", "?"};
      case Verdict::not_understood:
        return {"open", "\\oslash"};
      case Verdict::law:
        return {"quiet", "\\S"};
      case Verdict::suspect:
        return {"refuted", "!"};
      case Verdict::skipped:
        break;
    }
    return {"quiet", "-"};
  }();
  std::string words(name_of(step.verdict));
  std::ranges::replace(words, '-', ' ');
  if (step.expected_refuted) words += step.verdict == Verdict::refuted ? ", expected" : " (!)";
  return fmt::format("\\rigormark{{{}}}{{{}}}{{{}}}", look.colour, look.sign, words);
}

class NotesWriter {
 public:
  NotesWriter(ShownNotes& notes, SourceMap& sources) : notes_(notes), sources_(sources), math_(sources) {}

  std::string write() {
    out_ +=
        fmt::format("\\rigorhead{{\\small\\ttfamily\\mdseries}}{{{}}}\n", typeset_words(notes_.report->path));
    add_file_diagnostics();
    for (const ShownItem& item : notes_.items) {
      if (const auto* heading = std::get_if<ShownHeading>(&item)) add(*heading);
      if (const auto* equation = std::get_if<ShownEquation>(&item)) add(*equation);
    }
    return std::move(out_);
  }

 private:
  /// What is reported of no single step.
  void add_file_diagnostics() {
    std::string text;
    for (const Diagnostic& each : notes_.report->diagnostics) text += diagnostic(each);
    if (!notes_.report->failure.empty())
      text += note_line("not checked to its end", typeset_words(notes_.report->failure));
    if (!text.empty()) out_ += "\\begin{rigornote}\n" + text + "\\end{rigornote}\n";
  }

  static std::string note_line(const std::string& head, const std::string& what) {
    return fmt::format("\\textit{{{}}}\\enskip {}\\par\n", head, what);
  }

  std::string diagnostic(const Diagnostic& each) {
    const std::uint32_t at = sources_.line_column(each.span.file, each.span.begin).line;
    std::string place = fmt::format("line {}", at);
    if (sources_.path(each.span.file) != notes_.report->path)
      place = typeset_words(sources_.path(each.span.file)) + ", " + place;
    std::string text =
        note_line(place, std::string(name_of(each.severity())) + ": " + message(each.message, false));
    for (const std::string& help : each.help) text += note_line("help", message(help, false));
    return text;
  }

  void add(const ShownHeading& heading) {
    math_.put_in_force(notes_.macros.at(heading.macros));
    const std::string_view size = heading.level <= 1   ? "\\Large"
                                  : heading.level == 2 ? "\\large"
                                                       : "\\normalsize";
    out_ += fmt::format("\\rigorhead{{{}}}{{{}}}\n", size,
                        line(math_.line_of(heading.title, format_of(notes_.report->path))));
  }

  static std::string line(const Box& box) {
    if (box.kind == BoxKind::words) return typeset_words(box.text);
    if (box.kind != BoxKind::row) return "\\rigorinline{" + to_typeset(box) + "}";
    std::string all;
    for (const Box& part : box.parts)
      all +=
          part.kind == BoxKind::words ? typeset_words(part.text) : "\\rigorinline{" + to_typeset(part) + "}";
    return all;
  }

  void add(const ShownEquation& equation) {
    math_.put_in_force(notes_.macros.at(equation.macros));
    if (equation.steps.empty()) return whole(equation);
    out_ += "\\par\\vspace{5pt}\n";
    const Step* before = nullptr;
    last_uses_.clear();
    for (const Step* each : equation.steps) {
      const bool goes_on = before != nullptr && before->right == each->left && before->tag == each->tag &&
                           cyclic_image_of(*before) == 0 && cyclic_image_of(*each) == 0;
      step(*each, goes_on);
      before = each;
    }
  }

  /// A display without a step.
  void whole(const ShownEquation& equation) {
    if (!equation.shown || typeset_width(equation.shown->box) > most_width) {
      out_ += fmt::format("\\begin{{rigornote}}\\ttfamily {}\\end{{rigornote}}\n",
                          typeset_source(equation.source));
      return;
    }
    for (const Box& each : broken_lines(equation.shown->box, line_width + 8))
      out_ += fmt::format("\\rigorplain{{0em}}{{{}}}\n", to_typeset(each));
  }

  void step(const Step& step, bool goes_on) {
    auto left = math_.box_of(step.left);
    if (const int image = cyclic_image_of(step); image > 0 && left)
      left = row_box({words_box(fmt::format("cyclic image {} of ", image)), *std::move(left)});
    const auto right = math_.box_of(step.relation + " " + step.right);
    const bool is_read = !step.left.empty() || !step.right.empty();
    const bool is_set =
        is_read && left && right && typeset_width(*left) < most_width && typeset_width(*right) < most_width;
    if (!is_set) {
      out_ +=
          fmt::format("\\begin{{rigornote}}\\ttfamily {}\\end{{rigornote}}\n", typeset_source(step.source));
      out_ +=
          fmt::format("\\rigorline{{0em}}{{}}{{{}}}{{{}}}\n", typeset_words(step.tag), document_mark(step));
      return notes_of(step);
    }
    std::vector<Box> lines;
    std::size_t first_indented = 0;
    if (!goes_on && typeset_width(*left) + typeset_width(*right) <= line_width) {
      Box both;
      append(both, *left);
      append(both, *right);
      lines.push_back(std::move(both));
      first_indented = 1;
    } else {
      if (!goes_on) lines = broken_lines(*left, line_width);
      first_indented = lines.empty() ? 0 : 1;
      for (Box& each : broken_lines(*right, line_width - 2)) lines.push_back(std::move(each));
    }
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const bool last = k + 1 == lines.size();
      out_ += fmt::format("\\rigorline{{{}em}}{{{}}}{{{}}}{{{}}}\n", k < first_indented ? 0 : 2,
                          to_typeset(lines[k]), last ? typeset_words(tag_of(step)) : "",
                          last ? document_mark(step) : "");
    }
    notes_of(step);
  }

  static std::string tag_of(const Step& step) {
    return step.tag.empty() || step.tag.starts_with('(') ? step.tag : "(" + step.tag + ")";
  }

  static void append(Box& row, const Box& more) {
    if (more.kind != BoxKind::row) {
      row.parts.push_back(more);
      return;
    }
    row.parts.insert(row.parts.end(), more.parts.begin(), more.parts.end());
  }

  std::string inline_math(const std::string& latex) {
    const auto box = math_.box_of(latex);
    if (!box || typeset_width(*box) > most_width) return "\\texttt{" + typeset_source(latex) + "}";
    return "\\rigorinline{" + to_typeset(*box) + "}";
  }

  /// What is between back-ticks is set as mathematics, or as source.
  std::string message(std::string_view text, bool as_math) {
    std::string all;
    for (bool code = false; true; code = !code) {
      const std::size_t tick = text.find('`');
      const std::string part(text.substr(0, tick));
      if (!code) {
        all += typeset_words(part);
      } else {
        all += as_math ? inline_math(part) : "\\texttt{" + typeset_source(part) + "}";
      }
      if (tick == std::string_view::npos) return all;
      text.remove_prefix(tick + 1);
    }
  }

  /// Below a step, in small print: the sample, what is true, what was used, what is reported.
  void notes_of(const Step& step) {
    std::string text;
    const auto add_line = [&](const std::string& head, const std::string& what) {
      text += note_line(head, what);
    };
    if (step.counterexample) sample(*step.counterexample, add_line);
    for (const Repair& repair : step.repairs)
      add_line(std::string(&repair == step.repairs.data() ? heading_of_repairs(step) : "or"),
               inline_math(repair.statement) + " --- " + message(remark_on(repair), false));
    for (const std::string& condition : step.conditions) add_line("holds if", inline_math(condition));
    if (const WorkedStep* found = worked_step_of(notes_.derivations, sources_, step))
      text += derivation(*found);
    if (!step.uses.empty() && step.uses != last_uses_) {
      last_uses_ = step.uses;
      std::string uses;
      for (const std::string& each : step.uses) uses += (uses.empty() ? "" : ", ") + use(each);
      add_line("uses", uses);
    }
    for (const Diagnostic& each : step.diagnostics) text += diagnostic(each);
    if (!text.empty()) out_ += "\\begin{rigornote}\n" + text + "\\end{rigornote}\n";
  }

  /// One line a rule: mathematics at the left, the rule in words at the right.
  std::string derivation(const WorkedStep& derivation) {
    if (derivation.gap) return note_line("in small steps", "none: " + message(*derivation.gap, false));
    std::string text;
    const auto add_line = [&](std::string_view indent, const std::string& latex, const std::string& rule) {
      const Box box = math_.box_of_printed(latex);
      if (typeset_width(box) > most_width) return;
      const std::vector<Box> lines = broken_lines(box, small_width);
      for (const Box& line : lines) {
        text += fmt::format("\\rigorsmall{{{}}}{{{}}}{{{}}}\n", indent, to_typeset(line),
                            &line == &lines.back() ? rule : "");
      }
    };
    const bool is_long = std::ranges::any_of(derivation.lines, [&](const WorkedLine& line) {
      return typeset_width(math_.box_of_printed(line.latex)) > most_derived_width;
    });
    if (is_long) return "its small steps are too long to be set here\\par\n";
    add_line("2em", derivation.start, "");
    for (const WorkedLine& line : derivation.lines)
      add_line("3em", line.relation + " " + line.latex, this->line(math_.rule_of(line.rule)));
    return text;
  }

  template <class AddLine>
  void sample(const Counterexample& example, const AddLine& add_line) {
    const auto values = [&](std::uint32_t particle) {
      std::string list;
      for (const std::string& each : sample_equations(example, particle))
        list += (list.empty() ? "" : ",\\quad ") + inline_math(each);
      return list;
    };
    if (const std::string common = values(0); !common.empty()) add_line("sample", common);
    for (std::uint32_t particle = 1; particle <= example.particles; ++particle) {
      if (const std::string own = values(particle); !own.empty())
        add_line(fmt::format("particle {}", particle), own);
    }
    std::string where = sample_component(example);
    if (!where.empty()) where = " (" + where + ")";
    const std::string sides = example.squared_distance
                                  ? "the squared distance of the sides is " + example.left
                                  : "left is " + example.left + ", right is " + example.right;
    add_line("there", typeset_words(sides + where));
  }

  std::string use(const std::string& text) {
    const Use used = use_of(text);
    std::string all = typeset_words(used.word);
    if (!used.latex.empty()) all += " " + inline_math(used.latex);
    if (!used.place.empty()) all += (used.word == "convention" ? ": " : " ") + message(used.place, true);
    return all;
  }

  ShownNotes& notes_;
  SourceMap& sources_;
  NotesMath math_;
  std::string out_;
  std::vector<std::string> last_uses_;  // in this display: said once for steps that follow each other
};

std::string summary(const std::vector<ShownNotes>& notes) {
  ShownTotals totals;
  for (const ShownNotes& each : notes) add_to(totals, *each.report);
  std::string text = attention_words(totals) + ".";
  std::string list;
  for (std::size_t k = 0; k < verdict_count; ++k) {
    if (totals.counts[k] > 0)
      list += (list.empty() ? " " : ", ") + counted(static_cast<Verdict>(k), totals.counts[k]);
  }
  return list.empty() ? text : text + list + ".";
}

}  // namespace

std::string latex_document(std::vector<ShownNotes>& notes, SourceMap& sources) {
  std::string text = fmt::format("% Made by rigor {}\n{}", version, preamble);
  text += "{\\raggedright\\LARGE\\bfseries Equations and their verdicts\\par}\\vspace{6pt}\n";
  text += fmt::format("{{\\raggedright {}\\par The prose of the notes is not reproduced.\\par}}\n",
                      summary(notes));
  for (ShownNotes& each : notes) text += NotesWriter(each, sources).write();
  return text + "\\end{document}\n";
}

}  // namespace rigor
