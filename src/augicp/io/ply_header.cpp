// SPDX-License-Identifier: MIT
#include "augicp/io/ply_header.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/parse_number.h"
#include "augicp/io/text_lines.h"

namespace augicp {
namespace {

constexpr std::pair<std::string_view, ScalarType> kTypeNames[] = {
    {"char", ScalarType::Int8},      {"int8", ScalarType::Int8},       {"uchar", ScalarType::Uint8},
    {"uint8", ScalarType::Uint8},    {"short", ScalarType::Int16},     {"int16", ScalarType::Int16},
    {"ushort", ScalarType::Uint16},  {"uint16", ScalarType::Uint16},   {"int", ScalarType::Int32},
    {"int32", ScalarType::Int32},    {"uint", ScalarType::Uint32},     {"uint32", ScalarType::Uint32},
    {"float", ScalarType::Float32},  {"float32", ScalarType::Float32}, {"double", ScalarType::Float64},
    {"float64", ScalarType::Float64}};

constexpr std::pair<std::string_view, PlyEncoding> kEncodingNames[] = {
    {"ascii", PlyEncoding::Ascii},
    {"binary_little_endian", PlyEncoding::BinaryLittleEndian},
    {"binary_big_endian", PlyEncoding::BinaryBigEndian}};

class PlyHeaderParser {
 public:
  explicit PlyHeaderParser(const FileBytes& file) : file_(file), text_(without_bom(file.bytes)), lines_(text_) {}

  PlyHeader parse() {
    if (trimmed(next_line()) != "ply") fail("expected 'ply', the mark of a PLY file");
    parse_format();
    while (parse_declaration()) {
    }
    header_.body_offset = file_.bytes.size() - text_.size() + lines_.offset();
    header_.num_lines = lines_.line();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view expected) const {
    throw io_error_at_line(file_.path, lines_.line(), fmt::format("{}, found {}", expected, in_quotes(line_)));
  }

  // The next line that is no comment.
  std::string_view next_line() {
    while (const auto line = lines_.next()) {
      line_ = *line;
      std::string_view rest = line_;
      const auto keyword = next_field(rest);
      if (keyword && (*keyword == "comment" || *keyword == "obj_info")) continue;
      if (line_.size() > kMaxHeaderLine) fail("expected a line of at most 64 KB");
      return line_;
    }
    throw io_error_at_line(file_.path, lines_.line(), "expected 'end_header', the file ends before it");
  }

  template <typename Table>
  auto look_up(const Table& table, std::string_view name, std::string_view expected) const {
    const auto entry = std::find_if(std::begin(table), std::end(table), [&](const auto& e) { return e.first == name; });
    if (entry == std::end(table)) fail(expected);
    return entry->second;
  }

  std::string_view field(std::string_view& rest, std::string_view expected) const {
    const auto found = next_field(rest);
    if (!found) fail(expected);
    return *found;
  }

  void parse_format() {
    std::string_view rest = next_line();
    constexpr std::string_view kExpected = "expected 'format ascii|binary_little_endian|binary_big_endian 1.0'";
    if (field(rest, kExpected) != "format") fail(kExpected);
    header_.encoding = look_up(kEncodingNames, field(rest, kExpected), kExpected);
    if (field(rest, kExpected) != "1.0" || next_field(rest)) fail(kExpected);
  }

  // False at the end of the header.
  bool parse_declaration() {
    std::string_view rest = next_line();
    const auto keyword = next_field(rest);
    if (!keyword) return true;
    if (*keyword == "end_header") {
      if (next_field(rest)) fail("expected nothing behind 'end_header'");
      return false;
    }
    if (*keyword == "element") {
      parse_element(rest);
    } else if (*keyword == "property") {
      parse_property(rest);
    } else {
      fail("expected 'element', 'property' or 'end_header'");
    }
    return true;
  }

  void parse_element(std::string_view rest) {
    PlyElement element;
    element.name = field(rest, "expected 'element name count'");
    const auto count = parse_count(field(rest, "expected 'element name count'"));
    if (!count || next_field(rest)) fail("expected 'element name count' with a count of digits");
    if (!element_names_.insert(element.name).second) fail("expected each element once");
    element.count = *count;
    property_names_.clear();
    header_.elements.push_back(std::move(element));
  }

  void parse_property(std::string_view rest) {
    constexpr std::string_view kExpected = "expected 'property type name' or 'property list type type name'";
    if (header_.elements.empty()) fail("expected an element before its properties");
    PlyProperty property;
    std::string_view type = field(rest, kExpected);
    if (type == "list") {
      property.list_length = look_up(kTypeNames, field(rest, kExpected), "expected a known type");
      if (*property.list_length >= ScalarType::Float32) fail("expected a list length of an integer type");
      type = field(rest, kExpected);
    }
    property.type = look_up(kTypeNames, type, "expected a known type");
    property.name = field(rest, kExpected);
    if (next_field(rest)) fail(kExpected);
    if (!property_names_.insert(property.name).second) fail("expected each property of an element once");
    header_.elements.back().properties.push_back(std::move(property));
  }

  const FileBytes& file_;
  std::string_view text_;
  TextLines lines_;
  std::string_view line_;
  PlyHeader header_;
  std::set<std::string> element_names_;
  std::set<std::string> property_names_;  // of the last element
};

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.list_length.has_value(); });
}

std::uint64_t PlyElement::stride() const {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += num_bytes(property.type);
  return bytes;
}

PlyHeader parse_ply_header(const FileBytes& file) { return PlyHeaderParser(file).parse(); }

}  // namespace augicp
