// SPDX-License-Identifier: GPL-3.0-or-later
// Notes that somebody wrote, with bytes and tokens deleted, doubled and exchanged.
#pragma once

#include <string>
#include <vector>

#include "random.h"

namespace fuzz {

struct Notes {
  std::string path;
  std::string text;
};

/// All `.md` and `.tex` files below some folders, by name; longer ones than 64 KiB are left out.
[[nodiscard]] std::vector<Notes> notes_below(const std::vector<std::string>& folders);

/// Up to sixty lines of one of them, spoilt in one to four places.
[[nodiscard]] Notes spoilt(const std::vector<Notes>& all, Random& random);

/// The same notes with lines taken away, as long as `bad` says so of them.
template <typename Bad>
[[nodiscard]] Notes fewer_lines(Notes notes, const Bad& bad);

[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

template <typename Bad>
Notes fewer_lines(Notes notes, const Bad& bad) {
  std::vector<std::string> lines = lines_of(notes.text);
  for (std::size_t width = lines.size() / 2; width > 0; width /= 2) {
    for (std::size_t from = 0; from + width <= lines.size();) {
      Notes next{notes.path, ""};
      for (std::size_t k = 0; k < lines.size(); ++k)
        if (k < from || k >= from + width) next.text += lines[k];
      if (bad(next)) {
        notes = next;
        lines = lines_of(notes.text);
      } else {
        from += width;
      }
    }
  }
  return notes;
}

}  // namespace fuzz
