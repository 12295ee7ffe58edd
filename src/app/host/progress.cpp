// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/progress.h"

#include <fmt/format.h>

#include <utility>

#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::chrono::milliseconds patience{1000};
constexpr std::chrono::milliseconds pause{100};
constexpr std::string_view erase_line = "\r\x1b[K";

}  // namespace

Progress::Progress(std::ostream& err, bool shown, Clock clock)
    : err_(err), shown_(shown), clock_(std::move(clock)), next_(clock_() + patience) {}

void Progress::update(const std::string& path, std::size_t done, std::size_t all, std::string_view what) {
  if (!shown_) return;
  const Time now = clock_();
  if (now < next_) return;
  next_ = now + pause;
  err_ << erase_line << fmt::format("{}: {} of {} {}", shorten(path, 40), done, all, what) << std::flush;
  visible_ = true;
}

void Progress::clear() {
  if (visible_) err_ << erase_line << std::flush;
  visible_ = false;
}

}  // namespace rigor
