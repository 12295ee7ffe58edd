// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "source/system_error.h"

namespace rigor {
namespace {

tl::unexpected<Error> system_refuses() { return tl::unexpected(error_of({errno, std::generic_category()})); }

struct Descriptor {
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number;
};

}  // namespace

Result<MappedFile> MappedFile::open(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // no wait for a pipe
  if (file.number < 0) return system_refuses();
  struct stat status {};
  if (::fstat(file.number, &status) != 0) return system_refuses();
  if (S_ISDIR(status.st_mode)) return tl::unexpected(Error{"is a directory"});
  if (!S_ISREG(status.st_mode)) return tl::unexpected(Error{"not a regular file"});
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return MappedFile({});
  void* const start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
  if (start == MAP_FAILED) return system_refuses();
  ::madvise(start, size, MADV_SEQUENTIAL);
  return MappedFile({static_cast<const char*>(start), size});
}

void MappedFile::forget(std::size_t begin, std::size_t count) const {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t first = (begin + page - 1) / page * page;
  const std::size_t end = std::min(begin + count, bytes_.size());
  if (first + page > end) return;
  ::madvise(const_cast<char*>(bytes_.data()) + first, (end - first) / page * page, MADV_DONTNEED);
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})) {}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace rigor
