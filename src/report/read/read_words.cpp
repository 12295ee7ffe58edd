// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read/read_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace rigor {
namespace {

/// `m`, `x` and `k`
std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
    text += fmt::format("`{}`", names[k]);
  }
  return text;
}

/// Why it counts as a conclusion; empty if nothing says that it is one.
std::string announcement(const ReadRow& row) {
  if (row.link > 1) return fmt::format("link {} of its chain", row.link);
  if (row.inferred) return "behind an arrow or a word on its line";
  return row.announced.empty() ? "" : fmt::format("announced by \"{}\"", row.announced);
}

std::string place_in_notes(Span span, FileId file, const SourceMap& sources) {
  const std::uint32_t line = sources.line_column(span.file, span.begin).line;
  return span.file == file ? fmt::format("in line {}", line)
                           : fmt::format("in {}:{}", sources.path(span.file), line);
}

std::string words_of_source(const LetterSource& source, FileId file, const SourceMap& sources) {
  const std::string place = place_in_notes(source.span, file, sources);
  switch (source.kind) {
    case SourceKind::directive:
      return fmt::format("`rigor: {}` {}", source.text, place);
    case SourceKind::definition:
      return source.text;
    case SourceKind::words:
      return fmt::format("\"{}\" {}", source.text, place);
    case SourceKind::face:
    case SourceKind::indexed:
      return fmt::format("written `{}` {}", sources.text(source.span), place);
    case SourceKind::first:
      return "first " + place;
  }
  return place;
}

}  // namespace

std::string role_words(const ReadRow& row) {
  const std::string why = announcement(row);
  const std::string behind = why.empty() ? "" : "; " + why;
  switch (row.role) {
    case RowRole::unread:
      return "not read";
    case RowRole::skipped:
      return "skipped, as a directive says";
    case RowRole::definition:
      return "definition of its left side";
    case RowRole::given:
      return "given by a directive";
    case RowRole::condition:
      return "condition of the equation next to it";
    case RowRole::approximation:
      return "approximation: it is compared as far as something is small, or to the digits shown" + behind;
    case RowRole::identity:
      return "identity: to be proved for all values of its letters" + behind;
    case RowRole::law:
      return fmt::format("law: it is stated, and not meant for all values of {}", quoted_list(row.for_some));
    case RowRole::conclusion:
      return fmt::format(
          "conclusion, {}: to be proved from what stands above it, since it is not meant for "
          "all values of {}",
          why, quoted_list(row.for_some));
  }
  return "";
}

std::string kind_words(const ReadLetter& letter) {
  std::string text(name_of(letter.kind));
  if (letter.kind == LetterKind::tensor && letter.rank > 2) text += fmt::format(" of rank {}", letter.rank);
  const auto add = [&](bool holds, std::string_view words) {
    if (holds) text += fmt::format(", {}", words);
  };
  const bool counts = letter.kind == LetterKind::index || letter.kind == LetterKind::particle;
  add(counts && !letter.summed, "free");
  add(letter.summed && !letter.repeated, "summed");
  add(letter.summed && letter.repeated, "summed since it stands twice in a term");
  add(letter.per_particle, "one for each particle");
  add(letter.constant, "constant");
  add(letter.small, "small");
  add(letter.field, "depends on the place");
  add(letter.has_rate, "its rate is here");
  add(letter.for_all, "meant for all values");
  add(letter.ordered, "perhaps a matrix or an operator");
  add(letter.complex, "perhaps complex");
  return text;
}

std::string source_words(const ReadLetter& letter, FileId file, const SourceMap& sources) {
  std::vector<std::string> all;
  for (const LetterSource& source : letter.sources) all.push_back(words_of_source(source, file, sources));
  return fmt::format("{}", fmt::join(all, "; "));
}

}  // namespace rigor
