// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/write_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "source/system_error.h"

namespace rigor {
namespace {

Error last_error() { return error_of(std::error_code(errno, std::generic_category())); }

}  // namespace

Result<void> write_file(const std::string& path, std::string_view text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return tl::make_unexpected(last_error());
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const Error reason = last_error();
  if (std::fclose(file) != 0) return tl::make_unexpected(last_error());
  if (!written) return tl::make_unexpected(reason);
  return {};
}

Result<void> replace_file(const std::string& path, std::string_view text) {
  const std::string beside = path + "." + std::to_string(::getpid()) + ".new";
  Result<void> written = write_file(beside, text);
  std::error_code error;
  if (written) {
    std::filesystem::rename(beside, path, error);
    if (error) written = tl::make_unexpected(error_of(error));
  }
  if (!written) std::filesystem::remove(beside, error);
  return written;
}

}  // namespace rigor
