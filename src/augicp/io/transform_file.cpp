// SPDX-License-Identifier: MIT
#include "augicp/io/transform_file.h"

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "augicp/io/atomic_file.h"
#include "augicp/io/format.h"
#include "augicp/io/json_numbers.h"
#include "augicp/io/number_list.h"
#include "augicp/io/pose_numbers.h"

namespace augicp {
namespace {

constexpr const char* kJsonKey = "T_target_source";

Rigid3 from_rows(const std::vector<double>& numbers) {
  Mat4d matrix = Mat4d::Identity();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    matrix(static_cast<int>(i / 4), static_cast<int>(i % 4)) = numbers[i];
  return rigid3_from_matrix(matrix);
}

Rigid3 from_json(std::string_view text) {
  const auto numbers = json_numbers("transform", text, kJsonKey);
  if (!numbers) throw std::invalid_argument(fmt::format("transform: expected the key \"{}\" in the JSON", kJsonKey));
  if (numbers->size() != 16)
    throw std::invalid_argument(
        fmt::format("transform: expected 16 numbers in \"{}\", found {}", kJsonKey, numbers->size()));
  return from_rows(*numbers);
}

}  // namespace

Rigid3 parse_transform(std::string_view text) {
  if (starts_like_json(text)) return from_json(text);
  const std::vector<double> numbers = parse_number_list("transform", text, /*max_count=*/16);
  if (numbers.size() == 7) return pose_of_numbers("transform", std::span<const double>(numbers).first<7>());
  if (numbers.size() == 12 || numbers.size() == 16) return from_rows(numbers);
  throw std::invalid_argument(fmt::format(
      "transform: expected 16 or 12 numbers of a matrix, or tx ty tz qx qy qz qw, found {} numbers", numbers.size()));
}

Rigid3 read_transform(const std::filesystem::path& path) {
  constexpr std::uint64_t kMaxBytes = 16 << 20;  // a result file may contain a whole trace beside the matrix
  const FileBytes file = read_bytes(path, kMaxBytes);
  try {
    return parse_transform(file.bytes);
  } catch (const std::invalid_argument& error) {
    throw io_error(path, error.what());
  }
}

void write_transform(const std::filesystem::path& path, const Rigid3& target_from_source) {
  const Mat4d m = target_from_source.matrix();
  std::string text = "# T_target_source maps source coordinates into the target frame\n";
  for (int row = 0; row < 4; ++row)
    text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", m(row, 0), m(row, 1), m(row, 2), m(row, 3));
  write_file(path, text);
}

}  // namespace augicp
