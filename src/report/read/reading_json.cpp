// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read/reading_json.h"

#include <algorithm>
#include <string_view>

#include "base/version.h"
#include "report/data/json_value.h"
#include "report/read/read_words.h"

namespace rigor {
namespace {

std::string with_hyphens(std::string_view words) {
  std::string text(words);
  std::ranges::replace(text, ' ', '-');
  return text;
}

/// With where it is, unless it is nowhere.
Json with_place(Json object, Span span, const SourceMap& sources) {
  if (span == Span{}) {
    object.update({{"file", nullptr}, {"line", nullptr}, {"column", nullptr}});
    return object;
  }
  const LineColumn begin = sources.line_column(span.file, span.begin);
  object.update({{"file", sources.path(span.file)}, {"line", begin.line}, {"column", begin.column}});
  return object;
}

Json json_of_letter(const ReadLetter& letter, FileId file, const SourceMap& sources) {
  const auto json_of_source = [&](const LetterSource& source) {
    return with_place({{"kind", name_of(source.kind)}, {"text", source.text}}, source.span, sources);
  };
  return {{"letter", letter.name},
          {"kind", with_hyphens(name_of(letter.kind))},
          {"rank", letter.rank},
          {"per_particle", letter.per_particle},
          {"constant", letter.constant},
          {"small", letter.small},
          {"for_all", letter.for_all},
          {"field", letter.field},
          {"rate", letter.has_rate},
          {"maybe_ordered", letter.ordered},
          {"maybe_complex", letter.complex},
          {"summed", letter.summed},
          {"repeated", letter.repeated},
          {"words", kind_words(letter)},
          {"because", source_words(letter, file, sources)},
          {"sources", array_of(letter.sources, json_of_source)}};
}

Json json_of_row(const ReadRow& row, const FileReport& report, const SourceMap& sources) {
  const Step& step = report.steps[row.step];
  Json obstacles = Json::array();
  for (const Diagnostic& each : step.diagnostics) {
    const Severity severity = each.severity();
    if (severity != Severity::error && severity != Severity::not_understood) continue;
    obstacles.push_back(
        with_place({{"kind", info(each.kind).name}, {"message", each.message}, {"help", each.help}},
                   each.span, sources));
  }
  Json object = with_place(Json::object(), step.span, sources);
  object.update({{"tag", step.tag},
                 {"label", step.label},
                 {"section", step.section},
                 {"link", row.link},
                 {"links", row.links},
                 {"cyclic", row.cyclic},
                 {"source", step.source},
                 {"statement", row.statement},
                 {"role", name_of(row.role)},
                 {"role_words", role_words(row)},
                 {"announced", row.announced},
                 {"inferred", row.inferred},
                 {"for_some", row.for_some},
                 {"letters", array_of(row.letters,
                                      [&](const ReadLetter& each) {
                                        return json_of_letter(each, report.file, sources);
                                      })},
                 {"conventions", row.conventions},
                 {"open", row.open ? Json(row.open->message) : Json(nullptr)},
                 {"restricted", row.restricted},
                 {"grounds", array_of(row.grounds,
                                      [](const Ground& ground) {
                                        return Json{{"kind", name_of(ground.kind)},
                                                    {"name", ground.name},
                                                    {"statement", ground.statement}};
                                      })},
                 {"obstacles", std::move(obstacles)}});
  return object;
}

}  // namespace

std::string reading_json(const NotesReading& reading, const SourceMap& sources) {
  return to_text({{"rigor", version},
                  {"format", 1},
                  {"file", reading.report.path},
                  {"sidecar", or_null(reading.report.sidecar)},
                  {"rows", array_of(reading.rows, [&](const ReadRow& row) {
                     return json_of_row(row, reading.report, sources);
                   })}});
}

}  // namespace rigor
