// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/source_map.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t block_bytes = 4096;

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts{0};
  for (auto at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    starts.push_back(static_cast<std::uint32_t>(at + 1));
  return starts;
}

std::vector<std::uint32_t> count_blocks(std::string_view text) {
  std::vector<std::uint32_t> counts{0};
  for (std::size_t at = 0; at + block_bytes <= text.size(); at += block_bytes)
    counts.push_back(counts.back() +
                     static_cast<std::uint32_t>(count_code_points(text.substr(at, block_bytes))));
  return counts;
}

}  // namespace

FileId SourceMap::add(std::string path, std::string text) {
  RIGOR_CHECK(text.size() < std::numeric_limits<std::uint32_t>::max(), path, text.size());
  File file{std::move(path), std::move(text), {}, {}};
  file.line_starts = find_line_starts(file.text);
  file.code_points = count_blocks(file.text);
  files_.push_back(std::move(file));
  return static_cast<FileId>(files_.size() - 1);
}

const SourceMap::File& SourceMap::at(FileId file) const {
  static const File none{"(no file)", "", {0}, {0}};
  return file < files_.size() ? files_[file] : none;
}

const std::string& SourceMap::path(FileId file) const { return at(file).path; }

std::string_view SourceMap::text(FileId file) const { return at(file).text; }

std::string_view SourceMap::text(Span span) const {
  const std::string_view all = text(span.file);
  const std::size_t begin = std::min<std::size_t>(span.begin, all.size());
  const std::size_t end = std::clamp<std::size_t>(span.end, begin, all.size());
  return all.substr(begin, end - begin);
}

std::uint32_t SourceMap::code_points_between(const File& file, std::uint32_t begin, std::uint32_t end) {
  if (end - begin > block_bytes) return code_points_before(file, end) - code_points_before(file, begin);
  return static_cast<std::uint32_t>(
      count_code_points(std::string_view(file.text).substr(begin, end - begin)));
}

std::uint32_t SourceMap::code_points_before(const File& file, std::uint32_t offset) {
  const std::size_t block = offset / block_bytes;
  const std::size_t start = block * block_bytes;
  const auto rest = std::string_view(file.text).substr(start, offset - start);
  return file.code_points[block] + static_cast<std::uint32_t>(count_code_points(rest));
}

LineColumn SourceMap::line_column(FileId id, std::uint32_t offset) const {
  const File& file = at(id);
  offset = std::min(offset, static_cast<std::uint32_t>(file.text.size()));
  for (int back = 0; back < 3 && offset > 0 && offset < file.text.size(); ++back) {
    if (!is_continuation(file.text[offset])) break;
    --offset;
  }
  const auto next = std::ranges::upper_bound(file.line_starts, offset);
  const std::uint32_t start = *std::prev(next);
  return {static_cast<std::uint32_t>(next - file.line_starts.begin()),
          code_points_between(file, start, offset) + 1};
}

std::uint32_t SourceMap::line_start(FileId id, std::uint32_t line) const {
  const File& file = at(id);
  if (line == 0) return 0;
  if (line > file.line_starts.size()) return static_cast<std::uint32_t>(file.text.size());
  return file.line_starts[line - 1];
}

std::string_view SourceMap::line_text(FileId file, std::uint32_t line) const {
  if (line == 0 || line > line_count(file)) return {};
  std::string_view result = text(Span{file, line_start(file, line), line_start(file, line + 1)});
  if (result.ends_with('\n')) result.remove_suffix(1);
  if (result.ends_with('\r')) result.remove_suffix(1);
  return result;
}

std::uint32_t SourceMap::line_count(FileId file) const {
  return static_cast<std::uint32_t>(at(file).line_starts.size());
}

}  // namespace rigor
