// SPDX-License-Identifier: GPL-3.0-or-later
// Values as bytes and back, for another process of the same program or a later run of it. A struct says once
// which fields it has, for both ways:
//
//   template <class Archive> void fields(Archive& archive, Point& point) { archive(point.x, point.y); }
//
// A whole number takes seven bits a byte, least significant first; all bytes but the last have the highest
// bit set. A real one takes its 8 bytes. What has a length begins with it. Enumerations are read back only
// below the bound that `bounded` gives.
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
    for (; value >= 0x80U; value >>= 7U) bytes_ += static_cast<char>(value | 0x80U);
    bytes_ += static_cast<char>(value);
  }
  void put(std::string& text) {
    put_number(text.size());
    bytes_ += text;
  }
  void put(double& value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned k = 0; k < 64; k += 8) bytes_ += static_cast<char>((bits >> k) & 0xFFU);
  }
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
  /// What is not read yet.
  [[nodiscard]] std::string_view rest() const { return bytes_; }
  /// All was read, and it fitted.
  [[nodiscard]] bool finished() const { return ok_ && bytes_.empty(); }

 private:
  void fail() {
    ok_ = false;
    bytes_ = {};
  }
  std::uint64_t get_byte() {
    if (bytes_.empty()) fail();
    if (!ok_) return 0;
    const auto byte = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }
  std::uint64_t get_number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const std::uint64_t byte = get_byte();
      if (shift == 63 && byte > 1) fail();
      if (!ok_) return 0;
      value |= (byte & 0x7FU) << shift;
      if (byte < 0x80U) return value;
    }
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
  void get(double& value) {
    std::uint64_t bits = 0;
    for (unsigned k = 0; k < 64; k += 8) bits |= get_byte() << k;
    value = std::bit_cast<double>(bits);
  }
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
