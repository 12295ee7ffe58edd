// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/among.h"
#include "base/md5.h"
#include "base/utf8.h"

namespace rigor {
namespace {

/// The worst first; the last of a display without steps.
enum class StepMark : std::uint8_t { refuted, open, proved, given, silent };
constexpr std::array<std::string_view, 5> mark_names{"refuted", "open", "proved", "given", "silent"};

StepMark mark_of(const Step& step) {
  const bool malformed = std::ranges::any_of(step.diagnostics, [](const auto& each) {
    return each.severity() == Severity::error && each.kind != DiagnosticKind::unexpected_verdict;
  });
  switch (step.verdict) {
    case Verdict::refuted:
      return StepMark::refuted;
    case Verdict::proved:
      return malformed ? StepMark::open : StepMark::proved;
    case Verdict::given:
    case Verdict::definition:
    case Verdict::law:
      return malformed ? StepMark::open : StepMark::given;
    case Verdict::undecided:
    case Verdict::not_understood:
    case Verdict::skipped:
    case Verdict::suspect:
      break;
  }
  return StepMark::open;
}

/// Words that typeset no display of their own, and all of their argument.
constexpr std::array<std::string_view, 14> harmless_words{"cite",  "emph",     "eqref",  "footnote", "item",
                                                          "label", "noindent", "par",    "quad",     "qquad",
                                                          "ref",   "text",     "textbf", "textit"};

/// What comes before and after a display on its lines can neither leave it out nor typeset another one
/// there: words, inline math and harmless commands, with braces that are closed where they are opened.
bool is_harmless(std::string_view text) {
  int depth = 0;
  bool in_math = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '$') in_math = !in_math;
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth < 0) return false;
    if (text[at] != '\\') continue;
    const std::string_view rest = text.substr(at + 1);
    const std::size_t size = std::min(
        rest.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ@"), rest.size());
    const std::string_view word = rest.substr(0, size);
    const bool known = is_one_of(word, harmless_words);
    if (size > 0 && !in_math && !known) return false;
    at += std::max<std::size_t>(size, 1);
  }
  return depth == 0 && !in_math;
}

/// What is on the lines of the display next to it, without a comment.
std::string beside(Span display, LineColumn begin, LineColumn end, const SourceMap& sources) {
  const Span before{display.file, sources.line_start(display.file, begin.line), display.begin};
  const Span behind{display.file, display.end, sources.line_start(display.file, end.line + 1)};
  const std::string_view rest = sources.text(behind);
  return fmt::format("{}{}", sources.text(before), rest.substr(0, rest.find('%')));
}

/// One display's line.
std::string line_of(Span display, const FileReport& file, const SourceMap& sources) {
  std::array<std::size_t, mark_names.size()> found{};
  std::size_t all = 0;
  for (const Step& step : file.steps) {
    const bool inside =
        step.span.file == display.file && step.span.begin >= display.begin && step.span.begin < display.end;
    if (!inside) continue;
    ++found[static_cast<std::size_t>(mark_of(step))];
    ++all;
  }
  const auto most = std::find_if(found.begin(), found.end() - 1, [](std::size_t count) { return count > 0; });
  const auto worst = static_cast<std::size_t>(most - found.begin());
  const LineColumn begin = sources.line_column(display.file, display.begin);
  const LineColumn end = sources.line_column(display.file, std::max(display.begin + 1, display.end) - 1);
  const bool clear = all == 0 || is_harmless(beside(display, begin, end, sources));
  const std::string_view name = clear ? mark_names[worst] : "unclear";
  return fmt::format("display {} {} {} {} {}\n", begin.line, end.line, name, found[worst], all);
}

std::string path_beside(const std::string& path, const std::string& notes) {
  std::error_code none;
  const auto normal = [&none](const std::string& each) {
    return std::filesystem::absolute(std::filesystem::path(each), none).lexically_normal();
  };
  return printable(normal(path).lexically_relative(normal(notes).parent_path()).generic_string());
}

/// Where a sidecar would be found that is not there.
std::string absent_sidecar(const FileReport& file) {
  if (!file.sidecar.empty()) return "";
  const std::string beside = std::filesystem::path(file.path).replace_extension(".rigor").string();
  return beside == file.path ? "" : fmt::format("absent {}\n", path_beside(beside, file.path));
}

}  // namespace

std::string to_marks(const FileReport& file, const SourceMap& sources) {
  std::vector<FileId> files{file.file};
  for (FileId id = 0; id < sources.size(); ++id) {
    if (id != file.file) files.push_back(id);
  }
  std::string text = "rigor-marks 2\n" + absent_sidecar(file);
  for (const FileId id : files) {
    text += fmt::format("file {} {}\n", md5(sources.text(id)), path_beside(sources.path(id), file.path));
    for (const Span& display : file.displays) {
      if (display.file == id) text += line_of(display, file, sources);
    }
  }
  return text;
}

}  // namespace rigor
