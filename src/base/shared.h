// SPDX-License-Identifier: GPL-3.0-or-later
// A value that copies share until one of them is written to.
#pragma once

#include <memory>
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

}  // namespace rigor
