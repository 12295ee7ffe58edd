// SPDX-License-Identifier: GPL-3.0-or-later
// `--debug TOPIC`: what went on inside, on the error stream, one line a step.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

enum class DebugTopic : std::uint8_t { time, steps, work, cache };

struct DebugTopicInfo {
  DebugTopic topic;
  std::string_view name;
  std::string_view meaning;
};

[[nodiscard]] std::span<const DebugTopicInfo> debug_topic_table();

/// `debug time: notes.md:12:3: 0.42 ms` and so on, a line for each step of the file; of the cache one line
/// for the file.
[[nodiscard]] std::string print_debug(DebugTopic topic, const FileReport& file, const SourceMap& sources);

}  // namespace rigor
