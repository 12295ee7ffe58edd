// SPDX-License-Identifier: GPL-3.0-or-later
// Values that copies share: what holds at each place of a file is kept for each place.
//
// `Shared`: a value until one of its owners writes to it. `SharedList`, `SharedIndex`, `SharedMap` and
// `SharedSet` grow without a copy: a copy costs a pointer and a number. All copies show the beginning, as
// long as they were, of one sequence; the longest one appends to it, which no other sees. One that another
// has overtaken copies its part before it appends, and so does every change but appending. References stay
// valid while lists only grow and none overtakes another. `SharedArray` and `SharedSpans` are for what is
// read all the time and grows in many copies at once: they are shared by chunks.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <deque>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace rigor {

/// A copy costs a pointer; the first `write` to one that is shared copies the value.
template <class Value>
class Shared {
 public:
  Shared() : value_(std::make_shared<Value>()) {}
  explicit Shared(Value value) : value_(std::make_shared<Value>(std::move(value))) {}

  [[nodiscard]] const Value& operator*() const { return *value_; }
  [[nodiscard]] const Value* operator->() const { return value_.get(); }
  [[nodiscard]] Value& write() {
    if (value_.use_count() > 1) value_ = std::make_shared<Value>(*value_);
    return *value_;
  }
  /// Takes away what the predicate says; nothing is copied where there is none.
  template <class Predicate>
  void erase_if(const Predicate& predicate) {
    for (const auto& each : *value_) {
      if (!predicate(each)) continue;
      std::erase_if(write(), predicate);
      return;
    }
  }

 private:
  std::shared_ptr<Value> value_;
};

/// By position, so that it stays valid while the sequence grows.
template <class Value>
class SharedListIterator {
 public:
  using value_type = Value;
  using difference_type = std::ptrdiff_t;

  SharedListIterator() = default;
  SharedListIterator(const std::deque<Value>* values, std::size_t at) : values_(values), at_(at) {}

  const Value& operator*() const { return (*values_)[at_]; }
  const Value* operator->() const { return &(*values_)[at_]; }
  SharedListIterator& operator++() {
    ++at_;
    return *this;
  }
  SharedListIterator operator++(int) { return std::exchange(*this, {values_, at_ + 1}); }
  friend bool operator==(const SharedListIterator& a, const SharedListIterator& b) { return a.at_ == b.at_; }

 private:
  const std::deque<Value>* values_ = nullptr;
  std::size_t at_ = 0;
};

template <class Value>
class SharedList {
 public:
  using value_type = Value;
  using const_iterator = SharedListIterator<Value>;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const_iterator begin() const { return {values_.get(), 0}; }
  [[nodiscard]] const_iterator end() const { return {values_.get(), size_}; }
  [[nodiscard]] const Value& operator[](std::size_t k) const { return (*values_)[k]; }
  [[nodiscard]] const Value& back() const { return (*values_)[size_ - 1]; }

  void push_back(Value value) {
    if (values_ == nullptr)
      values_ = std::make_shared<std::deque<Value>>();
    else if (values_->size() != size_ && values_.use_count() == 1)
      values_->erase(values_->begin() + static_cast<std::ptrdiff_t>(size_), values_->end());  // is of nobody
    else if (values_->size() != size_)
      copy();
    values_->push_back(std::move(value));
    ++size_;
  }
  /// To be changed.
  [[nodiscard]] Value& write(std::size_t k) {
    if (values_.use_count() > 1) copy();
    return (*values_)[k];
  }
  /// Takes away what the predicate says; nothing is copied where there is none.
  template <class Predicate>
  void erase_if(const Predicate& predicate) {
    std::size_t kept = 0;
    while (kept < size_ && !predicate((*values_)[kept])) ++kept;
    if (kept == size_) return;
    auto rest = std::make_shared<std::deque<Value>>();
    for (const Value& each : *this)
      if (!predicate(each)) rest->push_back(each);
    values_ = std::move(rest);
    size_ = values_->size();
  }

 private:
  void copy() {
    auto own = std::make_shared<std::deque<Value>>();
    for (const Value& each : *this) own->push_back(each);
    values_ = std::move(own);
  }

  std::shared_ptr<std::deque<Value>> values_;
  std::size_t size_ = 0;
};

/// A list in which no two values have the same key, in the order in which they came.
template <class Value, class KeyOf>
class SharedIndex {
 public:
  using Key = std::remove_cvref_t<std::invoke_result_t<KeyOf, const Value&>>;
  using value_type = Value;
  using const_iterator = SharedListIterator<Value>;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const_iterator begin() const { return {values(), 0}; }
  [[nodiscard]] const_iterator end() const { return {values(), size_}; }
  /// Null if there is none.
  [[nodiscard]] const Value* find(const Key& key) const {
    if (stored_ == nullptr) return nullptr;
    const auto found = stored_->places.find(key);
    return found == stored_->places.end() || found->second >= size_ ? nullptr
                                                                    : &stored_->values[found->second];
  }
  [[nodiscard]] bool contains(const Key& key) const { return find(key) != nullptr; }

  /// Behind all others, in place of what has its key.
  void put(Value value) {
    const Key key = KeyOf{}(value);
    if (contains(key)) erase_if([&](const Value& each) { return KeyOf{}(each) == key; });
    if (stored_ == nullptr)
      stored_ = std::make_shared<Stored>();
    else if (stored_.use_count() == 1)
      drop_what_is_of_nobody();
    else if (stored_->values.size() != size_)
      *this = kept([](const Value&) { return true; });
    stored_->places.emplace(key, size_);
    stored_->values.push_back(std::move(value));
    ++size_;
  }
  template <class Predicate>
  void erase_if(const Predicate& predicate) {
    for (const Value& each : *this) {
      if (!predicate(each)) continue;
      *this = kept([&](const Value& other) { return !predicate(other); });
      return;
    }
  }
  void erase(const Key& key) {
    if (contains(key)) erase_if([&](const Value& each) { return KeyOf{}(each) == key; });
  }

 private:
  struct Stored {
    std::deque<Value> values;
    std::map<Key, std::size_t> places;
  };

  void drop_what_is_of_nobody() {
    for (; stored_->values.size() > size_; stored_->values.pop_back())
      stored_->places.erase(KeyOf{}(stored_->values.back()));
  }

  [[nodiscard]] const std::deque<Value>* values() const { return stored_ ? &stored_->values : nullptr; }

  template <class Predicate>
  [[nodiscard]] SharedIndex kept(const Predicate& predicate) const {
    SharedIndex own;
    own.stored_ = std::make_shared<Stored>();
    for (const Value& each : *this) {
      if (!predicate(each)) continue;
      own.stored_->places.emplace(KeyOf{}(each), own.size_++);
      own.stored_->values.push_back(each);
    }
    return own;
  }

  std::shared_ptr<Stored> stored_;
  std::size_t size_ = 0;
};

/// A sequence that only grows, read as fast as a vector. A copy costs a pointer for each chunk, and what
/// either appends afterwards the other does not see: the first to append goes on in the last chunk, a copy
/// takes a chunk of its own. References stay valid while it grows.
template <class Value>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(const SharedArray& other) : chunks_(other.chunks_), size_(other.size_) {}
  SharedArray(SharedArray&& other) noexcept
      : chunks_(std::move(other.chunks_)),
        size_(std::exchange(other.size_, 0)),
        owns_last_(std::exchange(other.owns_last_, false)) {}
  SharedArray& operator=(SharedArray other) noexcept {
    chunks_ = std::move(other.chunks_);
    size_ = other.size_;
    owns_last_ = other.owns_last_;
    return *this;
  }
  ~SharedArray() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Value& operator[](std::size_t k) const {
    return chunks_[k / chunk_size][k % chunk_size];
  }

  void push_back(Value value) {
    if (size_ % chunk_size == 0) {
      chunks_.push_back(std::make_shared<Value[]>(chunk_size));
    } else if (!owns_last_) {
      copy(size_ / chunk_size);
    }
    owns_last_ = true;
    chunks_.back()[size_ % chunk_size] = std::move(value);
    ++size_;
  }
  /// To be changed. References to others of its chunk may become invalid.
  [[nodiscard]] Value& write(std::size_t k) {
    if (chunks_[k / chunk_size].use_count() > 1) {
      copy(k / chunk_size);
      owns_last_ = owns_last_ || k / chunk_size == size_ / chunk_size;
    }
    return chunks_[k / chunk_size][k % chunk_size];
  }

 private:
  static constexpr std::size_t chunk_size = std::bit_floor(16'384 / sizeof(Value));

  void copy(std::size_t which) {
    auto own = std::make_shared<Value[]>(chunk_size);
    std::copy_n(&chunks_[which][0], std::min(chunk_size, size_ - which * chunk_size), &own[0]);
    chunks_[which] = std::move(own);
  }

  std::vector<std::shared_ptr<Value[]>> chunks_;
  std::size_t size_ = 0;
  bool owns_last_ = false;  // no copy has a part of the last chunk beyond this one's
};

/// Keeps runs of values where they are for as long as it or a copy lives. A copy costs a pointer for each
/// block.
template <class Value>
class SharedSpans {
 public:
  SharedSpans() = default;
  SharedSpans(const SharedSpans& other) : blocks_(other.blocks_) {}
  SharedSpans(SharedSpans&& other) noexcept
      : blocks_(std::move(other.blocks_)), room_(std::exchange(other.room_, {})) {}
  SharedSpans& operator=(SharedSpans other) noexcept {
    blocks_ = std::move(other.blocks_);
    room_ = other.room_;
    return *this;
  }
  ~SharedSpans() = default;

  [[nodiscard]] std::span<const Value> keep(std::span<const Value> values) {
    if (values.empty()) return {};
    if (room_.size() < values.size()) {
      const std::size_t size = std::max(block_size, values.size());
      blocks_.push_back(std::make_shared<Value[]>(size));
      room_ = {&blocks_.back()[0], size};
    }
    const std::span<Value> kept = room_.first(values.size());
    std::ranges::copy(values, kept.begin());
    room_ = room_.subspan(values.size());
    return kept;
  }

 private:
  static constexpr std::size_t block_size = 4'096 / sizeof(Value);

  std::vector<std::shared_ptr<Value[]>> blocks_;
  std::span<Value> room_;  // at the end of the last block; none in a copy
};

struct FirstOfPair {
  const auto& operator()(const auto& pair) const { return pair.first; }
};
template <class Key, class Value>
using SharedMap = SharedIndex<std::pair<Key, Value>, FirstOfPair>;
template <class Key>
using SharedSet = SharedIndex<Key, std::identity>;

}  // namespace rigor
