// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of LaTeX and of Markdown have in common: the position of the reader, displays, macro
// definitions, and diagnostics about what does not close.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "latex/document/document_input.h"
#include "latex/macro/macro_groups.h"
#include "latex/text/conditionals.h"
#include "latex/text/document_definition.h"
#include "latex/text/document_display.h"

namespace rigor {

/// What one run of read_document collects, over all files.
struct DocumentReading {
  SourceMap& sources;
  Diagnostics& diagnostics;
  Document document = {};
  EnvironmentAliases aliases = {};
  MacroGroups groups = {};
  Switches switches = {};
  std::size_t unread = 0;      // displays reported so far
  std::size_t unbalanced = 0;  // reported so far
  bool stopped = false;        // so much is unbalanced that these are no notes
};

class NotesReader {
 protected:
  NotesReader(DocumentReading& reading, FileId file, Format format)
      : reading_(reading), text_(reading.sources, file, format) {}

  struct Opening {
    DisplayDelimiter delimiter;
    std::size_t begin;
    std::size_t behind;  // the delimiter
    std::string environment = {};
    std::uint32_t quotes = 0;
    const OwnDisplay* own = nullptr;                   // what the author's own name for it means
    std::size_t limit = static_cast<std::size_t>(-1);  // where the text that it is in ends
  };
  /// Adds the display and stands after it, or says that it is not closed and stands where reading goes on.
  void read_display(const Opening& opening);
  /// Adds the display and stands after it if it is closed; else changes nothing.
  DisplayEnd read_closed_display(const Opening& opening);

  /// At `\begin` or `\end` or an alias of one, a display begins or an end is stray. False: it is about
  /// something else.
  bool read_environment(std::string_view word, std::uint32_t quotes,
                        std::size_t limit = static_cast<std::size_t>(-1));
  /// At a control that defines a macro or an environment. False: it does neither.
  bool read_definition(std::string_view word);

  /// `% rigor: …` at the `%`.
  void add_directive(std::size_t percent);
  void add_directives(std::size_t begin, std::size_t end);

  [[nodiscard]] bool goes_on() const { return at_ < text_.size() && !reading_.stopped; }

  void report_unread(Span place, std::string message, std::string help);
  void report(std::size_t begin, std::size_t end, std::string message, std::string help,
              std::vector<Label> labels = {});
  template <class T>
  void add(T item) {
    reading_.document.items.emplace_back(std::move(item));
  }

  DocumentReading& reading_;
  NotesText text_;
  std::size_t at_ = 0;

 private:
  bool report_if_unread(std::string_view word, std::string_view name, std::size_t behind);
  [[nodiscard]] bool is_global(std::size_t definition, std::string_view word) const;
  void report_open(const Opening& opening, const DisplayEnd& end);
  void report_wrong(const Opening& opening, const DisplayEnd& end);
  /// After `[…]` and `{…}` that belong to the environment and not to what it displays.
  std::size_t skip_environment_arguments(Display& display, std::size_t at) const;
  std::size_t skip_own_arguments(const OwnDisplay& own, std::size_t at);
};

/// Read one file into `reading`.
void read_latex(DocumentReading& reading, FileId file, InputFiles& inputs);
/// What a package or a class defines.
void read_package(DocumentReading& reading, FileId file, InputFiles& inputs);
void read_markdown(DocumentReading& reading, FileId file);

}  // namespace rigor
