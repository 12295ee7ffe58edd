// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document/document.h"

#include <utility>

#include "latex/document/document_reader.h"

namespace rigor {
namespace {

/// The highest LaTeX heading that the notes use becomes level 1.
void raise_headings(Document& document) {
  int highest = 0;
  for (const Item& item : document.items) {
    const auto* const heading = std::get_if<Heading>(&item);
    if (heading != nullptr && (highest == 0 || heading->level < highest)) highest = heading->level;
  }
  for (Item& item : document.items) {
    if (auto* const heading = std::get_if<Heading>(&item)) heading->level -= highest - 1;
  }
}

}  // namespace

Document read_document(SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  DocumentReading reading{sources, diagnostics};
  reading.document.file = file;
  if (format_of(sources, file) == Format::latex) {
    InputFiles inputs(sources, file, diagnostics);
    read_latex(reading, file, inputs);
    raise_headings(reading.document);
  } else {
    read_markdown(reading, file);
  }
  return std::move(reading.document);
}

}  // namespace rigor
