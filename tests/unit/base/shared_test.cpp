// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shared.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/splitmix.h"
#include "catch.h"

namespace rigor {
namespace {

template <class List>
std::vector<typename List::value_type> values_of(const List& list) {
  return {list.begin(), list.end()};
}

TEST_CASE("a copy of a list does not see what the other one takes in later") {
  SharedList<int> list;
  list.push_back(1);
  const SharedList<int> before = list;
  list.push_back(2);
  SharedList<int> other = before;
  other.push_back(3);  // where `list` has 2
  CHECK(values_of(before) == std::vector{1});
  CHECK(values_of(list) == std::vector{1, 2});
  CHECK(values_of(other) == std::vector{1, 3});
  other.write(0) = 4;
  CHECK(values_of(other) == std::vector{4, 3});
  CHECK(values_of(before) == std::vector{1});
}

TEST_CASE("appending to what is shared copies nothing, and moves nothing") {
  SharedList<int> list;
  list.push_back(1);
  const SharedList<int> before = list;
  const int* first = &before[0];
  for (int k = 0; k < 1000; ++k) list.push_back(k);
  CHECK(&list[0] == first);
  CHECK(&before[0] == first);
}

TEST_CASE("a list that a copy overtook stays where it is when that copy is gone") {
  SharedList<int> list;
  list.push_back(1);
  const int* first = &list[0];
  {
    SharedList<int> trial = list;
    trial.push_back(2);
  }
  list.push_back(3);
  CHECK(&list[0] == first);
  CHECK(values_of(list) == std::vector{1, 3});
}

TEST_CASE("a map finds its own entries only") {
  SharedMap<std::string, int> map;
  map.put({"a", 1});
  const SharedMap<std::string, int> before = map;
  map.put({"b", 2});
  SharedMap<std::string, int> other = before;
  other.put({"b", 3});
  map.put({"a", 4});
  CHECK(before.find("b") == nullptr);
  CHECK(before.find("a")->second == 1);
  CHECK(other.find("b")->second == 3);
  CHECK(map.find("a")->second == 4);
  CHECK(map.size() == 2);
  CHECK(values_of(map).back().first == "a");  // put again: the last
  map.erase("b");
  CHECK_FALSE(map.contains("b"));
  CHECK(other.contains("b"));
  CHECK(SharedMap<std::string, int>().find("a") == nullptr);
}

TEST_CASE("copies that change in any order are what copies of vectors would be") {
  SplitMix bits(1);
  std::vector<SharedSet<int>> sets(1);
  std::vector<std::vector<int>> plain(1);
  for (int n = 0; n < 20'000; ++n) {
    const std::size_t k = bits.below(sets.size());
    const int value = static_cast<int>(bits.below(30));
    switch (bits.below(4)) {
      case 0:
        if (sets.size() < 20) {
          sets.push_back(sets[k]);
          plain.push_back(plain[k]);
        } else {
          const std::size_t into = bits.below(sets.size());
          sets[into] = sets[k];
          plain[into] = plain[k];
        }
        break;
      case 1:
        sets[k].erase(value);
        std::erase(plain[k], value);
        break;
      default:
        sets[k].put(value);
        std::erase(plain[k], value);
        plain[k].push_back(value);
    }
    const std::size_t seen = bits.below(sets.size());
    REQUIRE(values_of(sets[seen]) == plain[seen]);
    REQUIRE(sets[seen].contains(value) == (std::ranges::count(plain[seen], value) > 0));
  }
}

/// Copies of arrays that grow and change in any order, against copies of vectors.
TEST_CASE("copies of an array go their own ways") {
  SplitMix bits(2);
  std::vector<SharedArray<std::string>> arrays(1);
  std::vector<std::vector<std::string>> plain(1);
  for (int round = 0; round < 20'000; ++round) {
    const std::size_t which = bits.below(arrays.size());
    const std::string value = std::to_string(round);
    const auto what = bits.below(40);
    if (what == 0 && arrays.size() < 8) {
      arrays.push_back(SharedArray(arrays[which]));
      plain.push_back(std::vector(plain[which]));
    } else if (what == 1) {
      const std::size_t other = bits.below(arrays.size());
      arrays[which] = arrays[other];
      plain[which] = plain[other];
    } else if (what < 10 && !plain[which].empty()) {
      const std::size_t at = bits.below(plain[which].size());
      arrays[which].write(at) = value;
      plain[which][at] = value;
    } else {
      arrays[which].push_back(value);
      plain[which].push_back(value);
    }
  }
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    REQUIRE(arrays[k].size() == plain[k].size());
    for (std::size_t at = 0; at < plain[k].size(); ++at) REQUIRE(arrays[k][at] == plain[k][at]);
  }
}

TEST_CASE("what an array holds stays where it is, in its copies, too") {
  SharedArray<int> array;
  array.push_back(1);
  const int* first = &array[0];
  for (int k = 0; k < 10'000; ++k) array.push_back(k);
  const SharedArray<int> copy = array;
  array.push_back(7);
  CHECK(&array[0] == first);
  CHECK(&copy[0] == first);
  const SharedArray<int> moved = std::move(array);
  CHECK(&moved[0] == first);
  CHECK(moved.size() == copy.size() + 1);
}

TEST_CASE("spans live as long as any copy of what keeps them") {
  const auto all_of = [](std::span<const int> span) { return std::vector(span.begin(), span.end()); };
  std::span<const int> early;
  std::span<const int> late;
  SharedSpans<int> copy;
  {
    SharedSpans<int> spans;
    early = spans.keep(std::vector{1, 2, 3});
    copy = spans;
    late = copy.keep(std::vector{4, 5});
    CHECK(all_of(spans.keep(std::vector{6})) == std::vector{6});  // in the room behind `early`
    const std::vector<int> long_one(100'000, 8);
    CHECK(all_of(spans.keep(long_one)) == long_one);
  }
  CHECK(all_of(early) == std::vector{1, 2, 3});
  CHECK(all_of(late) == std::vector{4, 5});
  CHECK(copy.keep({}).empty());
}

}  // namespace
}  // namespace rigor
