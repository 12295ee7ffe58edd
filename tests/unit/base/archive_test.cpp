// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/archive.h"

#include "catch.h"

namespace rigor {
namespace {

enum class Phase : std::uint8_t { one, two };

struct Mixture {
  bool flag = false;
  std::int32_t number = 0;
  double real = 0.0;
  Phase phase = Phase::one;
  std::string text;
  std::vector<std::string> texts;
  std::optional<std::uint64_t> maybe;
  std::array<std::uint32_t, 2> pair{};
};

template <class Archive>
void fields(Archive& archive, Mixture& mixture) {
  archive(mixture.flag, mixture.number, mixture.real);
  archive.bounded(mixture.phase, 2);
  archive(mixture.text, mixture.texts, mixture.maybe, mixture.pair);
}

std::string written(Mixture mixture) {
  ArchiveWriter writer;
  writer(mixture);
  return writer.take();
}

const Mixture example{true, -7, 0.1, Phase::two, std::string("a\0b", 3), {"", "\xff"}, 5, {1, 2}};

TEST_CASE("what is written is read back") {
  const std::string bytes = written(example);
  ArchiveReader reader(bytes);
  Mixture back;
  reader(back);
  CHECK(reader.finished());
  CHECK(written(back) == bytes);
  CHECK(back.number == -7);
  CHECK(back.text == example.text);
}

TEST_CASE("no beginning of the bytes is taken for the whole") {
  const std::string bytes = written(example);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ArchiveReader reader(std::string_view(bytes).substr(0, size));
    Mixture back;
    reader(back);
    CHECK_FALSE(reader.finished());
  }
}

TEST_CASE("bytes behind the end, lengths beyond it and values out of bounds are refused") {
  const auto is_read = [](const std::string& bytes) {
    ArchiveReader reader(bytes);
    Mixture back;
    reader(back);
    return reader.finished();
  };
  const std::string bytes = written(example);
  CHECK_FALSE(is_read(bytes + "x"));
  std::string wrong_flag = bytes;
  wrong_flag[0] = 2;
  CHECK_FALSE(is_read(wrong_flag));
  std::string wrong_phase = bytes;
  wrong_phase[19] = 2;
  CHECK_FALSE(is_read(wrong_phase));
  std::string long_text = bytes;
  long_text[20] = '\x7f';
  CHECK_FALSE(is_read(long_text));
  std::string long_number = bytes;
  long_number[10] = '\x02';  // beyond 64 bits
  CHECK_FALSE(is_read(long_number));
}

}  // namespace
}  // namespace rigor
