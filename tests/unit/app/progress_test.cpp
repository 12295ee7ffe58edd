// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/progress.h"

#include <sstream>

#include "catch.h"

namespace rigor {
namespace {

/// A progress line with a clock that stands still until it is moved.
struct Watched {
  explicit Watched(bool shown) : progress(err, shown, [this] { return now; }) {}

  std::string after(int milliseconds) {
    now += std::chrono::milliseconds(milliseconds);
    err.str("");
    progress.update("notes.md", 12, 63);
    return err.str();
  }

  std::ostringstream err;
  Progress::Time now{};
  Progress progress;
};

TEST_CASE("progress appears after a second and then ten times a second") {
  Watched watched(true);
  CHECK(watched.after(999).empty());
  CHECK(watched.after(1) == "\r\x1b[Knotes.md: 12 of 63 displays");
  CHECK(watched.after(99).empty());
  CHECK_FALSE(watched.after(1).empty());
}

TEST_CASE("progress that was shown is erased, and only then") {
  Watched quick(true);
  CHECK(quick.after(10).empty());
  quick.progress.clear();
  CHECK(quick.err.str().empty());

  Watched slow(true);
  CHECK_FALSE(slow.after(2000).empty());
  slow.err.str("");
  slow.progress.clear();
  CHECK(slow.err.str() == "\r\x1b[K");
  slow.progress.clear();
  CHECK(slow.err.str() == "\r\x1b[K");
}

TEST_CASE("no progress is shown where there is no terminal") {
  Watched watched(false);
  CHECK(watched.after(5000).empty());
}

}  // namespace
}  // namespace rigor
