// SPDX-License-Identifier: MIT
#include "augicp/io/field_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>

#include "augicp/io/parse_number.h"

namespace augicp {
namespace {

template <typename T>
void append_bytes(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

// The whole number if all of text is one that the type has.
template <typename T>
std::optional<T> parse_whole(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || text.empty() || error != std::errc{}) return std::nullopt;
  return value;
}

// Casting a double that the type has not is undefined.
template <typename T>
T nearest(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    if (std::isnan(value)) return T{};
    if (value <= static_cast<double>(std::numeric_limits<T>::min())) return std::numeric_limits<T>::min();
    if (value >= static_cast<double>(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
    return static_cast<T>(value);
  }
}

// The column of whole numbers as doubles.
void make_floating(PointField& field) {
  std::string values;
  values.reserve(field.values.size());
  const std::size_t count = field.values.size() / sizeof(std::int64_t);
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t whole = 0;
    std::memcpy(&whole, field.values.data() + i * sizeof(whole), sizeof(whole));
    append_bytes(values, static_cast<double>(whole));
  }
  field.type = ScalarType::Float64;
  field.values = std::move(values);
}

template <typename T>
bool has_all(std::int64_t min, std::int64_t max) {
  return min >= std::int64_t{std::numeric_limits<T>::min()} && max <= std::int64_t{std::numeric_limits<T>::max()};
}

ScalarType smallest_type(std::int64_t min, std::int64_t max) {
  if (has_all<std::uint8_t>(min, max)) return ScalarType::Uint8;
  if (has_all<std::int16_t>(min, max)) return ScalarType::Int16;
  if (has_all<std::uint16_t>(min, max)) return ScalarType::Uint16;
  if (has_all<std::int32_t>(min, max)) return ScalarType::Int32;
  if (has_all<std::uint32_t>(min, max)) return ScalarType::Uint32;
  return ScalarType::Int64;
}

}  // namespace

bool append_number(PointField& field, std::string_view text) {
  return with_type(field.type, [&](auto zero) {
    using T = decltype(zero);
    if constexpr (!std::is_floating_point_v<T>) {
      if (const auto whole = parse_whole<T>(text)) {
        append_bytes(field.values, *whole);
        return true;
      }
    }
    const auto value = parse_double(text);
    if (value) append_bytes(field.values, nearest<T>(*value));
    return value.has_value();
  });
}

bool append_untyped_number(PointField& field, std::string_view text) {
  if (field.type == ScalarType::Int64) {
    if (const auto whole = parse_whole<std::int64_t>(text)) {
      append_bytes(field.values, *whole);
      return true;
    }
  }
  const auto value = text.empty() ? std::numeric_limits<double>::quiet_NaN() : parse_double(text);
  if (!value) return false;
  if (field.type == ScalarType::Int64) make_floating(field);
  append_bytes(field.values, *value);
  return true;
}

PointField narrowed(PointField field) {
  if (field.type != ScalarType::Int64 || field.values.empty()) return field;
  std::int64_t min = std::numeric_limits<std::int64_t>::max(), max = std::numeric_limits<std::int64_t>::min();
  const auto value_at = [&](std::size_t i) {
    std::int64_t value = 0;
    std::memcpy(&value, field.values.data() + i * sizeof(value), sizeof(value));
    return value;
  };
  const std::size_t count = field.values.size() / sizeof(std::int64_t);
  for (std::size_t i = 0; i < count; ++i) {
    min = std::min(min, value_at(i));
    max = std::max(max, value_at(i));
  }
  PointField small{field.name, smallest_type(min, max), field.count, {}};
  small.values.reserve(count * num_bytes(small.type));
  with_type(small.type, [&](auto zero) {
    for (std::size_t i = 0; i < count; ++i) append_bytes(small.values, static_cast<decltype(zero)>(value_at(i)));
  });
  return small;
}

}  // namespace augicp
