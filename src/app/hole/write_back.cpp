// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/write_back.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "source/system_error.h"

namespace rigor {

std::string with_replacements(std::string text, std::vector<PlacedText> replacements) {
  std::ranges::sort(replacements,
                    [](const PlacedText& a, const PlacedText& b) { return a.span.begin > b.span.begin; });
  for (const PlacedText& each : replacements)
    text.replace(each.span.begin, each.span.end - each.span.begin, each.text);
  return text;
}

Result<void> replace_file(const std::string& path, const std::string& content) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  if (error) return tl::unexpected(error_of(error));
  const auto permissions = std::filesystem::status(target, error).permissions();
  if (error) return tl::unexpected(error_of(error));
  if ((permissions & std::filesystem::perms::owner_write) == std::filesystem::perms::none)
    return tl::unexpected(error_of(std::make_error_code(std::errc::permission_denied)));
  std::filesystem::path fresh = target;
  fresh += ".rigor-new";
  {
    errno = 0;
    std::ofstream file(fresh, std::ios::binary | std::ios::trunc);
    file << content;
    if (!file.flush()) {
      const std::error_code reason(errno != 0 ? errno : EIO, std::generic_category());
      file.close();
      std::filesystem::remove(fresh, error);
      return tl::unexpected(error_of(reason));
    }
  }
  std::filesystem::permissions(fresh, permissions, error);
  if (!error) std::filesystem::rename(fresh, target, error);
  if (!error) return {};
  const std::error_code reason = error;
  std::filesystem::remove(fresh, error);
  return tl::unexpected(error_of(reason));
}

}  // namespace rigor
