// SPDX-License-Identifier: GPL-3.0-or-later
// Values that copies share: what holds at each place of a file is kept for each place.
//
// `Shared`: a value until one of its owners writes to it. `SharedList`, `SharedIndex`, `SharedMap` and
// `SharedSet` grow without a copy: a copy costs a pointer and a number. All copies show the beginning, as
// long as they were, of one sequence; the longest one appends to it, which no other sees. One that another
// has overtaken copies its part before it appends, and so does every change but appending. References stay
// valid while lists only grow and none overtakes another.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>

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

struct FirstOfPair {
  const auto& operator()(const auto& pair) const { return pair.first; }
};
template <class Key, class Value>
using SharedMap = SharedIndex<std::pair<Key, Value>, FirstOfPair>;
template <class Key>
using SharedSet = SharedIndex<Key, std::identity>;

}  // namespace rigor
