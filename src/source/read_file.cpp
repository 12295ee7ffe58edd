// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/read_file.h"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "source/latin1.h"
#include "source/system_error.h"

namespace rigor {
namespace {

constexpr std::size_t largest_file = std::size_t{64} << 20U;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// What there is to say about the bytes of one sort: where the first is, and how many there are.
struct Bytes {
  std::size_t first = 0;
  std::size_t count = 0;
  unsigned char value = 0;

  void add(std::size_t offset, char byte) {
    if (count++ != 0) return;
    first = offset;
    value = static_cast<unsigned char>(byte);
  }
  [[nodiscard]] Span span(FileId file) const {
    const auto begin = static_cast<std::uint32_t>(first);
    return {file, begin, begin + 1};
  }
};

constexpr char substitute = '\x1A';  // ASCII's own; shown as `?`, and no sign of any notation

bool looks_like_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
}

Bytes replace_invalid(std::string& text) {
  Bytes invalid;
  char* const begin = text.data();
  char* const end = begin + text.size();
  for (char* at = begin; (at = utf8::find_invalid(at, end)) != end; ++at) {
    invalid.add(static_cast<std::size_t>(at - begin), *at);
    *at = substitute;
  }
  return invalid;
}

Bytes replace_nul(std::string& text) {
  Bytes nul;
  for (auto at = text.find('\0'); at != text.npos; at = text.find('\0', at + 1)) {
    nul.add(at, '\0');
    text[at] = substitute;
  }
  return nul;
}

/// A carriage return alone ends a line, as for TeX; before a line feed it is a blank.
void end_lines(std::string& text) {
  for (auto at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1))
    if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (status.type() == std::filesystem::file_type::not_found)
    return tl::unexpected(error_of(std::make_error_code(std::errc::no_such_file_or_directory)));
  if (code) return tl::unexpected(error_of(code));
  if (std::filesystem::is_directory(status)) return tl::unexpected(Error{"is a directory"});
  if (!std::filesystem::is_regular_file(status)) return tl::unexpected(Error{"not a regular file"});

  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) return tl::unexpected(error_of({errno, std::generic_category()}));
  std::string text;
  std::array<char, 1U << 16U> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    if (text.size() + count > largest_file) return tl::unexpected(Error{"larger than 64 MiB"});
    text.append(block.data(), count);
  }
  if (std::ferror(file.get()) != 0) return tl::unexpected(error_of({errno, std::generic_category()}));
  return text;
}

Diagnostics mend_text(std::string& text, FileId file) {
  const bool utf16 = looks_like_utf16(text);
  if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");
  end_lines(text);
  const Bytes invalid = replace_invalid(text);
  const Bytes nul = replace_nul(text);

  Diagnostics found;
  if (invalid.count > 0) {
    std::string message = fmt::format("byte `0x{:02X}` is not UTF-8", invalid.value);
    if (invalid.count > 1) message += fmt::format("; the text has {} such bytes", invalid.count);
    found.push_back({DiagnosticKind::invalid_utf8, invalid.span(file), message, {}, {}});
    found.back().help.emplace_back(utf16 ? "the text seems to be UTF-16; save it as UTF-8"
                                         : "save the file as UTF-8");
  }
  if (nul.count > 0) {
    std::string message = "a NUL byte";
    if (nul.count > 1) message = fmt::format("the first of {} NUL bytes", nul.count);
    found.push_back({DiagnosticKind::nul_byte, nul.span(file), message, {}, {}});
  }
  std::ranges::stable_sort(
      found, [](const Diagnostic& a, const Diagnostic& b) { return a.span.begin < b.span.begin; });
  return found;
}

Diagnostics mend_notes(std::string& text, FileId file) {
  Diagnostics found = decode_latin1(text, file);
  const Diagnostics mended = mend_text(text, file);
  found.insert(found.end(), mended.begin(), mended.end());
  return found;
}

}  // namespace rigor
