// SPDX-License-Identifier: MIT
#include "augicp/io/pcd_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr std::uint64_t kMaxCount = 1 << 16;  // far above the largest feature descriptors

constexpr std::string_view kKeywords[] = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                          "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};

constexpr std::tuple<std::string_view, std::uint64_t, ScalarType> kTypes[] = {
    {"I", 1, ScalarType::Int8},   {"I", 2, ScalarType::Int16},  {"I", 4, ScalarType::Int32},
    {"I", 8, ScalarType::Int64},  {"U", 1, ScalarType::Uint8},  {"U", 2, ScalarType::Uint16},
    {"U", 4, ScalarType::Uint32}, {"U", 8, ScalarType::Uint64}, {"F", 4, ScalarType::Float32},
    {"F", 8, ScalarType::Float64}};

// The lines of a header by keyword: the values, and the line number for messages.
struct Entry {
  std::vector<std::string_view> values;
  std::uint64_t line = 0;
};

class PcdHeaderParser {
 public:
  explicit PcdHeaderParser(const FileBytes& file) : file_(file), text_(without_bom(file.bytes)), lines_(text_) {}

  PcdHeader parse() {
    read_entries();
    PcdHeader header;
    header.fields = fields();
    std::tie(header.width, header.height, header.num_points) = size();
    header.viewpoint = viewpoint();
    header.encoding = encoding();
    header.body_offset = file_.bytes.size() - text_.size() + lines_.offset();
    header.num_lines = lines_.line();
    return header;
  }

 private:
  [[noreturn]] void fail(std::uint64_t line, std::string_view what) const {
    throw io_error_at_line(file_.path, line, what);
  }

  void read_entries() {
    while (const auto line = lines_.next()) {
      std::string_view rest = *line;
      if (trimmed(rest).starts_with('#')) continue;
      if (rest.size() > kMaxHeaderLine) fail(lines_.line(), "expected a line of at most 64 KB");
      const auto first = next_field(rest);
      if (!first) continue;
      const std::string_view keyword = *first == "COLUMNS" ? "FIELDS" : *first;  // its name before version 0.5
      if (std::find(std::begin(kKeywords), std::end(kKeywords), keyword) == std::end(kKeywords))
        fail(lines_.line(), "expected a keyword of a PCD header, found " + in_quotes(*line));
      Entry entry{{}, lines_.line()};
      while (const auto value = next_field(rest)) entry.values.push_back(*value);
      if (!entries_.emplace(keyword, std::move(entry)).second)
        fail(lines_.line(), fmt::format("expected {} once", keyword));
      if (keyword == "VERSION") check_version();
      if (keyword == "DATA") return;
    }
    fail(lines_.line(), "expected 'DATA', the file ends before it");
  }

  void check_version() const {
    const Entry& entry = entries_.find("VERSION")->second;
    constexpr std::string_view kVersions[] = {"0.7", ".7", "0.6", ".6", "0.5", ".5"};
    if (entry.values.size() != 1 ||
        std::find(std::begin(kVersions), std::end(kVersions), entry.values[0]) == std::end(kVersions))
      fail(entry.line, "expected version 0.5, 0.6 or 0.7");
  }

  const Entry& entry(std::string_view keyword) const {
    const auto found = entries_.find(keyword);
    if (found == entries_.end()) fail(lines_.line(), fmt::format("expected {} before DATA", keyword));
    return found->second;
  }

  std::uint64_t count(const Entry& entry, std::size_t index, std::string_view what) const {
    const auto value = parse_count(entry.values[index]);
    if (!value) fail(entry.line, fmt::format("expected {}, found {}", what, in_quotes(entry.values[index])));
    return *value;
  }

  std::vector<PcdField> fields() const {
    const Entry &names = entry("FIELDS"), &sizes = entry("SIZE"), &types = entry("TYPE");
    const Entry* const counts = entries_.contains("COUNT") ? &entry("COUNT") : nullptr;
    for (const Entry* values : {&sizes, &types, counts ? counts : &sizes})
      if (values->values.size() != names.values.size())
        fail(values->line,
             fmt::format("expected {} values, one a field, found {}", names.values.size(), values->values.size()));
    std::vector<PcdField> fields;
    for (std::size_t i = 0; i < names.values.size(); ++i) {
      PcdField field{std::string(names.values[i]), type(types, sizes, i)};
      if (counts) field.count = count(*counts, i, "a count");
      const std::uint64_t least = field.is_padding() ? 0 : 1;  // some writers pad with nothing
      if (field.count < least || field.count > kMaxCount)
        fail(counts->line, fmt::format("expected a count from 1 to {}, found {}", kMaxCount, field.count));
      fields.push_back(std::move(field));
    }
    return fields;
  }

  ScalarType type(const Entry& types, const Entry& sizes, std::size_t i) const {
    const std::uint64_t size = count(sizes, i, "a size");
    for (const auto& [name, bytes, type] : kTypes)
      if (name == types.values[i] && bytes == size) return type;
    fail(sizes.line, fmt::format("expected type I or U of size 1, 2, 4 or 8, or F of 4 or 8; found {} of {}",
                                 in_quotes(types.values[i]), size));
  }

  std::optional<std::uint64_t> optional_count(std::string_view keyword) const {
    if (!entries_.contains(keyword)) return std::nullopt;
    const Entry& found = entry(keyword);
    if (found.values.size() != 1) fail(found.line, fmt::format("expected one number of {}", keyword));
    return count(found, 0, "a count");
  }

  // Width, height and number of points; each may be missing.
  std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> size() const {
    const auto points = optional_count("POINTS"), stated_width = optional_count("WIDTH");
    const std::uint64_t height = optional_count("HEIGHT").value_or(1);
    if (!points && !stated_width) fail(lines_.line(), "expected WIDTH or POINTS before DATA");
    const std::uint64_t width = stated_width ? *stated_width : *points;
    const bool overflows = width != 0 && height > ~std::uint64_t{0} / width;
    if (overflows || (points && *points != width * height))
      fail(entry(points ? "POINTS" : "WIDTH").line,
           fmt::format("expected POINTS to be WIDTH * HEIGHT = {} * {}", width, height));
    return {width, height, width * height};
  }

  std::optional<Vec3d> viewpoint() const {
    if (!entries_.contains("VIEWPOINT")) return std::nullopt;
    const Entry& found = entry("VIEWPOINT");
    std::array<double, 7> pose{};
    if (found.values.size() != pose.size()) fail(found.line, "expected VIEWPOINT tx ty tz qw qx qy qz");
    for (std::size_t i = 0; i < pose.size(); ++i) {
      const auto value = parse_double(found.values[i]);
      if (!value || !std::isfinite(*value))
        fail(found.line, "expected a finite number, found " + in_quotes(found.values[i]));
      pose[i] = *value;
    }
    if (pose == std::array<double, 7>{0, 0, 0, 1, 0, 0, 0}) return std::nullopt;
    return Vec3d(pose[0], pose[1], pose[2]);  // the orientation is not needed: points are in the same frame
  }

  PcdEncoding encoding() const {
    const Entry& data = entry("DATA");
    const std::string_view name = data.values.size() == 1 ? data.values[0] : "";
    if (name == "ascii") return PcdEncoding::Ascii;
    if (name == "binary") return PcdEncoding::Binary;
    if (name == "binary_compressed") return PcdEncoding::BinaryCompressed;
    fail(data.line, "expected 'DATA ascii|binary|binary_compressed', found " + in_quotes(name));
  }

  const FileBytes& file_;
  std::string_view text_;
  TextLines lines_;
  std::map<std::string_view, Entry> entries_;
};

}  // namespace

PcdHeader parse_pcd_header(const FileBytes& file) { return PcdHeaderParser(file).parse(); }

}  // namespace augicp
