// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/program_identity.h"

#include <fmt/format.h>
#include <link.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/md5.h"
#include "base/version.h"

namespace rigor {
namespace {

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// The identifier among the notes of a segment; empty if it is not there.
std::string build_identifier(const char* notes, std::size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) header;
    std::memcpy(&header, notes, sizeof header);
    const std::size_t name = padded(header.n_namesz);
    const std::size_t whole = sizeof header + name + padded(header.n_descsz);
    if (whole > size) break;
    const std::string_view owner(notes + sizeof header, std::min<std::size_t>(header.n_namesz, 4));
    if (header.n_type == NT_GNU_BUILD_ID && owner == std::string_view("GNU\0", 4))
      return {notes + sizeof header + name, header.n_descsz};
    notes += whole;
    size -= whole;
  }
  return "";
}

std::string identity_of_file(const std::string& path) {
  struct stat about {};
  if (::stat(path.empty() ? "/proc/self/exe" : path.c_str(), &about) != 0) return path;
  return fmt::format("{} {} {}.{}", path, about.st_size, about.st_mtim.tv_sec, about.st_mtim.tv_nsec);
}

int add_object(dl_phdr_info* object, std::size_t, void* identities) {
  const std::string path = object->dlpi_name;
  if (path.starts_with("linux-vdso")) return 0;  // of the kernel
  std::string identity;
  for (std::size_t k = 0; k < object->dlpi_phnum && identity.empty(); ++k) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[k];
    const auto* begin = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    if (segment.p_type == PT_NOTE) identity = build_identifier(begin, segment.p_memsz);
  }
  if (identity.empty()) identity = identity_of_file(path);
  static_cast<std::vector<std::string>*>(identities)->push_back(identity);
  return 0;
}

}  // namespace

std::string program_identity() {
  std::vector<std::string> identities;
  ::dl_iterate_phdr(add_object, &identities);
  std::ranges::sort(identities);
  std::string all;
  for (const std::string& identity : identities) all += fmt::format("{}:{}", identity.size(), identity);
  return fmt::format("rigor {} {}", version, md5(all));
}

}  // namespace rigor
