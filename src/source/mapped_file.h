// SPDX-License-Identifier: GPL-3.0-or-later
// A file of any size, read where the system keeps it: nothing is copied.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace rigor {

/// The bytes of a regular file, from the start of a page, for as long as the object lives. The file must not
/// shrink meanwhile.
class MappedFile {
 public:
  /// A missing file, a directory, a device… is an error.
  [[nodiscard]] static Result<MappedFile> open(const std::string& path);

  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&&) = delete;
  ~MappedFile();

  [[nodiscard]] std::string_view bytes() const { return bytes_; }
  /// Takes the whole pages of these bytes out of memory; they are read again where they are looked at.
  void forget(std::size_t begin, std::size_t count) const;

 private:
  explicit MappedFile(std::string_view bytes) : bytes_(bytes) {}

  std::string_view bytes_;
};

}  // namespace rigor
