// SPDX-License-Identifier: GPL-3.0-or-later
// Values as bytes and back, for another process of the same program or a later run of it. A struct says once
// which fields it has, for both ways:
//
//   template <class Archive> void fields(Archive& archive, Point& point) { archive(point.x, point.y); }
//
// Numbers have 8 bytes, least significant first; what has a length begins with it. Enumerations are read back
// only below the bound that `bounded` gives.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rigor {

class ArchiveWriter {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }
  template <class Enumeration>
  void bounded(Enumeration& value, std::size_t) {
    put_number(static_cast<std::uint64_t>(value));
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  void put_number(std::uint64_t value) {
    for (int k = 0; k < 8; ++k) bytes_ += static_cast<char>((value >> (8 * k)) & 0xFFU);
  }
  void put(std::string& text) {
    put_number(text.size());
    bytes_ += text;
  }
  void put(double& value) { put_number(std::bit_cast<std::uint64_t>(value)); }
  template <class Value>
  void put(std::vector<Value>& values) {
    put_number(values.size());
    for (Value& value : values) put(value);
  }
  template <class Value, std::size_t N>
  void put(std::array<Value, N>& values) {
    for (Value& value : values) put(value);
  }
  template <class Value>
  void put(std::optional<Value>& value) {
    put_number(value.has_value() ? 1 : 0);
    if (value) put(*value);
  }
  template <class Value>
  void put(Value& value) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
      put_number(static_cast<std::uint64_t>(value));
    else
      fields(*this, value);
  }

  std::string bytes_;
};

/// Never reads beyond the bytes: after the first thing that does not fit, all is zero or empty, and `ok` is
/// false for good.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }
  template <class Enumeration>
  void bounded(Enumeration& value, std::size_t count) {
    const std::uint64_t number = get_number();
    if (number >= count) fail();
    value = static_cast<Enumeration>(ok_ ? number : 0);
  }
  [[nodiscard]] bool ok() const { return ok_; }
  /// All was read, and it fitted.
  [[nodiscard]] bool finished() const { return ok_ && bytes_.empty(); }

 private:
  void fail() {
    ok_ = false;
    bytes_ = {};
  }
  std::uint64_t get_number() {
    if (bytes_.size() < 8) fail();
    if (!ok_) return 0;
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 8; ++k)
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[k])) << (8 * k);
    bytes_.remove_prefix(8);
    return value;
  }
  /// Of things that have at least a byte each.
  std::size_t get_length() {
    const std::uint64_t length = get_number();
    if (length > bytes_.size()) fail();
    return ok_ ? static_cast<std::size_t>(length) : 0;
  }
  void get(std::string& text) {
    const std::size_t length = get_length();
    text = bytes_.substr(0, length);
    bytes_.remove_prefix(length);
  }
  void get(double& value) { value = std::bit_cast<double>(get_number()); }
  template <class Value>
  void get(std::vector<Value>& values) {
    values.clear();
    for (std::size_t left = get_length(); left > 0 && ok_; --left) get(values.emplace_back());
  }
  template <class Value, std::size_t N>
  void get(std::array<Value, N>& values) {
    for (Value& value : values) get(value);
  }
  template <class Value>
  void get(std::optional<Value>& value) {
    const std::uint64_t there = get_number();
    if (there > 1) fail();
    value.reset();
    if (ok_ && there == 1) get(value.emplace());
  }
  template <class Value>
  void get(Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      const std::uint64_t number = get_number();
      if (number > 1) fail();
      value = number == 1;
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      value = static_cast<Value>(get_number());
    } else {
      fields(*this, value);
    }
  }

  std::string_view bytes_;
  bool ok_ = true;
};

}  // namespace rigor
