// SPDX-License-Identifier: MIT
#include "augicp/io/point_fields.h"

namespace augicp {

double PointField::at(std::size_t row, std::size_t k) const {
  return read_scalar(values.data() + row * row_bytes() + k * num_bytes(type), type, kNativeOrder);
}

const PointField* PointFields::find(std::string_view lower_case_name) const {
  for (const PointField& field : fields)
    if (lower_case(field.name) == lower_case_name) return &field;
  return nullptr;
}

PointFields select(const PointFields& fields, const std::vector<std::uint32_t>& rows) {
  PointFields chosen{{}, fields.not_kept};
  for (const PointField& field : fields.fields) {
    PointField part{field.name, field.type, field.count, {}};
    part.values.reserve(rows.size() * field.row_bytes());
    for (const std::uint32_t row : rows) part.values.append(field.values, row * field.row_bytes(), field.row_bytes());
    chosen.fields.push_back(std::move(part));
  }
  return chosen;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');  // not tolower: it depends on the locale
  return lower;
}

}  // namespace augicp
