// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/debug.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "base/utf8.h"

namespace rigor {
namespace {

constexpr auto topics = std::to_array<DebugTopicInfo>({
    {DebugTopic::time, "time", "milliseconds of each step"},
    {DebugTopic::steps, "steps", "verdict, route and uses of each step"},
    {DebugTopic::work, "work", "units of work of each step, limited by `--effort`"},
    {DebugTopic::cache, "cache", "how many decisions of each file were remembered"},
});

std::string line_of(DebugTopic topic, const Step& step) {
  if (topic == DebugTopic::time) return fmt::format("{:.3f} ms", step.milliseconds);
  if (topic == DebugTopic::work) return fmt::format("{}", step.work);
  std::string text(name_of(step.verdict));
  if (!step.route.empty()) text += "; route: " + step.route;
  if (!step.uses.empty()) text += fmt::format("; uses: {}", fmt::join(step.uses, ", "));
  return text;
}

}  // namespace

std::span<const DebugTopicInfo> debug_topic_table() { return topics; }

std::string print_debug(DebugTopic topic, const FileReport& file, const SourceMap& sources) {
  const std::string_view name = topics[static_cast<std::size_t>(topic)].name;
  if (topic == DebugTopic::cache) {
    if (!file.cache) return fmt::format("debug cache: {}: there is none\n", printable(file.path));
    return fmt::format("debug cache: {}: {} of {} decisions were remembered\n", printable(file.path),
                       file.cache->reused, file.cache->asked);
  }
  std::string text;
  for (const Step& step : file.steps) {
    const LineColumn place = sources.line_column(step.span.file, step.span.begin);
    text += fmt::format("debug {}: {}:{}:{}: {}\n", name, printable(sources.path(step.span.file)), place.line,
                        place.column, printable(line_of(topic, step)));
  }
  return text;
}

}  // namespace rigor
