// SPDX-License-Identifier: GPL-3.0-or-later
// The tree of sections that a page is: below its headings, list items, exercises, examples, theorems and
// admonitions are sections of their own. What is said in one of them is said for it and for what lies in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "latex/document/document.h"

namespace rigor {

/// Sections are numbers; 0 is the page as a whole.
class Sections {
 public:
  Sections() = default;

  /// Does a statement at `from` hold at `at`: is `from` the same section, or one around it?
  [[nodiscard]] bool reaches(std::size_t from, std::size_t at) const;
  /// Is `from` inside an example or an exercise, so that a statement there holds for it alone?
  [[nodiscard]] bool leaves_an_example(std::size_t from, std::size_t at) const;
  /// A new section inside another.
  std::size_t open_in(std::size_t parent, bool example = false);

 private:
  std::vector<std::size_t> parents_{0};
  std::vector<bool> examples_{false};
};

/// Follows the text of notes from heading to heading and from display to display.
class SectionWalk {
 public:
  explicit SectionWalk(Sections& sections) : sections_(sections) {}

  void heading(int level);
  /// Text without comments in which no heading and no display stands.
  void text(std::string_view text, Format format);
  [[nodiscard]] std::size_t here() const { return open_.empty() ? 0 : open_.back().place; }

 private:
  enum class Kind : std::uint8_t { heading, environment, item, named, fence, quote };
  struct Open {
    Kind kind;
    std::size_t place;
    std::size_t depth = 0;  // of a heading its level, of an item the column of its text
    std::string name = {};
  };
  void open(Kind kind, std::size_t depth, std::string name = {});
  /// Closes the innermost section of this kind (and name), with all in it; false: there is none.
  bool close(Kind kind, std::string_view name = {});
  void markdown_line(std::string_view line);
  void latex_line(std::string_view line);
  void item(std::size_t column, std::size_t text_column);

  Sections& sections_;
  std::vector<Open> open_;
  bool after_blank_ = true;
};

}  // namespace rigor
