// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/place/place.h"

#include <fmt/format.h>

namespace rigor {

std::unique_ptr<ChainReading> read_here(RowPlace& place, const ParsedChain& parsed) {
  auto reading = read_chain(place.notes.syntax, place.tree, place.names, parsed);
  add_used(place, reading->used());
  return reading;
}

Judgement judge_here(RowPlace& place, const Claim& claim) {
  Judgement judgement = judge(place.tree, place.names, claim, {}, place.options.cache);
  add_used(place, judgement.used);
  return judgement;
}

std::string written_at(const SourceMap& sources, Span span) {
  std::string text;
  for (const char c : sources.text(span)) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      text += c;
    } else if (!text.empty() && text.back() != ' ') {
      text += ' ';
    }
  }
  return text;
}

std::string name_of_place(const SourceMap& sources, const ParsedChain& parsed) {
  if (!parsed.written.tag.empty()) return parsed.written.tag;
  return fmt::format("in line {}",
                     sources.line_column(parsed.written.span.file, parsed.written.span.begin).line);
}

}  // namespace rigor
