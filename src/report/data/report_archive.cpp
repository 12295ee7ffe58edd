// SPDX-License-Identifier: GPL-3.0-or-later
// Each struct is taken apart into all its members, so that one that is added does not compile before it is
// packed.
#include "report/data/report_archive.h"

#include <utility>

#include "base/archive.h"
#include "check/step/repair_fields.h"

namespace rigor {
namespace {

struct PackedText {
  std::string path;
  std::string text;
};

struct PackedReport {
  std::vector<PackedText> texts;
  FileReport file;
};

}  // namespace

template <class Archive>
void fields(Archive& archive, Span& span) {
  auto& [file, begin, end] = span;
  archive(file, begin, end);
}

template <class Archive>
void fields(Archive& archive, Label& label) {
  auto& [span, text] = label;
  archive(span, text);
}

template <class Archive>
void fields(Archive& archive, Diagnostic& diagnostic) {
  auto& [kind, span, message, labels, help] = diagnostic;
  archive.bounded(kind, diagnostic_table().size());
  archive(span, message, labels, help);
}

template <class Archive>
void fields(Archive& archive, Counterexample::Value& value) {
  auto& [symbol, particle, rank, components, beyond] = value;
  archive(symbol, particle, rank, components, beyond);
}

template <class Archive>
void fields(Archive& archive, Counterexample::Axis& axis) {
  auto& [index, value] = axis;
  archive(index, value);
}

template <class Archive>
void fields(Archive& archive, Counterexample& example) {
  auto& [particles, values, component, left, right, follows, squared_distance] = example;
  archive(particles, values, component, left, right, follows, squared_distance);
}

template <class Archive>
void fields(Archive& archive, ChainPlace& place) {
  auto& [first_wrong, undoes, stays, first_step, undone_at] = place;
  archive(first_wrong, undoes, stays, first_step, undone_at);
}

template <class Archive>
void fields(Archive& archive, Step& step) {
  auto& [span, relation_span, tag, label, section, source, left, relation, right, verdict, expected_refuted,
         measures, restates, route, uses, counterexample, chain, repairs, conditions, repair_milliseconds,
         diagnostics, milliseconds, work] = step;
  archive(span, relation_span, tag, label, section, source, left, relation, right);
  archive.bounded(verdict, verdict_count);
  archive(expected_refuted, measures, restates, route, uses, counterexample, chain, repairs, conditions,
          repair_milliseconds, diagnostics, milliseconds, work);
}

template <class Archive>
void fields(Archive& archive, SymbolDimension& entry) {
  auto& [symbol, dimension] = entry;
  archive(symbol, dimension);
}

template <class Archive>
void fields(Archive& archive, CacheUse& use) {
  auto& [asked, reused, trouble] = use;
  archive(asked, reused, trouble);
}

template <class Archive>
void fields(Archive& archive, FileReport& report) {
  auto& [path, file, sidecar, unreadable, steps, diagnostics, silenced, dimensions, counts, displays, failure,
         cache] = report;
  archive(path, file, sidecar, unreadable, steps, diagnostics, silenced, dimensions, counts, displays,
          failure, cache);
}

namespace {

template <class Archive>
void fields(Archive& archive, PackedText& packed) {
  archive(packed.path, packed.text);
}

template <class Archive>
void fields(Archive& archive, PackedReport& packed) {
  archive(packed.texts, packed.file);
}

void move_by(FileId offset, Diagnostics& diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    diagnostic.span.file += offset;
    for (Label& label : diagnostic.labels) label.span.file += offset;
  }
}

/// The report's first file has the id `offset`.
void move_by(FileId offset, FileReport& report) {
  report.file += offset;
  for (Step& step : report.steps) {
    step.span.file += offset;
    step.relation_span.file += offset;
    move_by(offset, step.diagnostics);
  }
  move_by(offset, report.diagnostics);
  move_by(offset, report.silenced);
  for (Span& display : report.displays) display.file += offset;
}

}  // namespace

std::string pack(const FileReport& file, const SourceMap& sources) {
  PackedReport packed;
  for (FileId id = 0; id < sources.size(); ++id)
    packed.texts.push_back({sources.path(id), std::string(sources.text(id))});
  packed.file = file;
  ArchiveWriter writer;
  writer(packed);
  return writer.take();
}

std::optional<FileReport> unpack(std::string_view bytes, SourceMap& sources) {
  PackedReport packed;
  ArchiveReader reader(bytes);
  reader(packed);
  if (!reader.finished()) return std::nullopt;
  move_by(static_cast<FileId>(sources.size()), packed.file);
  for (PackedText& text : packed.texts) sources.add(std::move(text.path), std::move(text.text));
  return std::move(packed.file);
}

}  // namespace rigor
