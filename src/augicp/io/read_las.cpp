// SPDX-License-Identifier: MIT
#include "augicp/io/read_las.h"

#include <algorithm>
#include <cmath>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/las_format.h"

namespace augicp {
namespace {

using las::number_at;

struct LasHeader {
  int minor_version = 0;
  int point_format = 0;
  std::size_t record_length = 0;
  std::uint64_t num_points = 0;
  std::size_t points_offset = 0;
  Vec3d scale, offset;

  std::size_t points_end() const { return points_offset + num_points * record_length; }
};

class HeaderReader {
 public:
  explicit HeaderReader(const FileBytes& file) : file_(file), bytes_(file.bytes) {}

  LasHeader read() {
    check_version();
    header_.point_format = point_format();
    header_.record_length = record_length();
    header_.points_offset = points_offset();
    header_.num_points = num_points();
    for (int axis = 0; axis < 3; ++axis) {
      header_.scale[axis] = number<double>(las::kScale + 8 * static_cast<std::size_t>(axis));
      header_.offset[axis] = number<double>(las::kOffset + 8 * static_cast<std::size_t>(axis));
    }
    check_places();
    check_vlrs();
    return header_;
  }

 private:
  template <typename T>
  T number(std::size_t at) const {
    return number_at<T>(bytes_, at);
  }

  [[noreturn]] void fail(std::size_t at, std::string_view what) const { throw io_error_at_byte(file_.path, at, what); }

  [[noreturn]] void fail_cut() const { fail(bytes_.size(), "expected more, the file ends here"); }

  void check_version() {
    if (!bytes_.starts_with("LASF")) fail(0, "expected 'LASF', the mark of a LAS file");
    if (bytes_.size() < las::kHeaderSizes[0]) fail_cut();
    const int major = bytes_[las::kMinorVersion - 1], minor = bytes_[las::kMinorVersion];
    if (major != 1 || minor < 0 || minor > 4)
      fail(las::kMinorVersion - 1, fmt::format("expected version 1.0 to 1.4, found {}.{}", major, minor));
    header_.minor_version = minor;
    if (bytes_.size() < las::kHeaderSizes[minor]) fail_cut();
    if (number<std::uint16_t>(las::kHeaderSize) < las::kHeaderSizes[minor])
      fail(las::kHeaderSize, fmt::format("expected a header of at least {} bytes, found {}", las::kHeaderSizes[minor],
                                         number<std::uint16_t>(las::kHeaderSize)));
  }

  int point_format() const {
    constexpr int kCompressed = 0xc0;  // the upper bits, which LASzip sets
    const int format = static_cast<std::uint8_t>(bytes_[las::kPointFormat]);
    if ((format & kCompressed) != 0)
      fail(las::kPointFormat,
           "the points are compressed (LAZ), which this reader lacks. "
           "Decompress them first, for instance with "
           "'pip install laspy[lazrs]' and 'laspy decompress'");
    if (format >= las::kNumFormats)
      fail(las::kPointFormat, fmt::format("expected a point format from 0 to 10, found {}", format));
    return format;
  }

  std::size_t record_length() const {
    const std::size_t length = number<std::uint16_t>(las::kRecordLength);
    if (length < las::kRecordSizes[header_.point_format])
      fail(las::kRecordLength, fmt::format("expected records of at least {} bytes, found {}",
                                           las::kRecordSizes[header_.point_format], length));
    return length;
  }

  std::size_t points_offset() const {
    const std::size_t offset = number<std::uint32_t>(las::kPointsOffset);
    if (offset < number<std::uint16_t>(las::kHeaderSize))
      fail(las::kPointsOffset, fmt::format("expected points behind the header, found their offset {}", offset));
    if (offset > bytes_.size()) fail_cut();
    return offset;
  }

  std::uint64_t num_points() const {
    const std::uint64_t legacy = number<std::uint32_t>(las::kLegacyNumPoints);
    const std::uint64_t count = header_.minor_version == 4 ? number<std::uint64_t>(las::kNumPoints) : legacy;
    if (header_.minor_version == 4 && legacy != 0 && legacy != count)
      fail(las::kNumPoints, fmt::format("expected the number of points twice, found {} and {}", legacy, count));
    if (count > (bytes_.size() - header_.points_offset) / header_.record_length)
      fail(bytes_.size(), fmt::format("expected {} points, the file ends here", count));
    return count;
  }

  // Positions below 1e18 m, whatever the integers are.
  void check_places() const {
    constexpr double kLargest = 2147483648.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double reach = std::abs(header_.scale[axis]) * kLargest + std::abs(header_.offset[axis]);
      if (header_.scale[axis] == 0.0 || !(reach < 1e18))
        fail(las::kScale, fmt::format("expected a finite scale and offset, found {} and {}", header_.scale[axis],
                                      header_.offset[axis]));
    }
  }

  void check_vlrs() const {
    std::size_t at = number<std::uint16_t>(las::kHeaderSize);
    for (std::uint32_t i = 0; i < number<std::uint32_t>(las::kNumVlrs); ++i) {
      if (las::kVlrHeader > header_.points_offset - at) fail(at, "expected a variable length record before the points");
      at += las::kVlrHeader;
      const std::size_t length = number<std::uint16_t>(at - las::kVlrHeader + 20);
      if (length > header_.points_offset - at)
        fail(at, fmt::format("expected a record of {} bytes before the points", length));
      at += length;
    }
  }

  const FileBytes& file_;
  std::string_view bytes_;
  LasHeader header_;
};

// The end of the extended records that begin at `at`. Throws IoError if one is not within the file.
std::size_t end_of_records(const FileBytes& file, std::uint64_t at, std::uint64_t count, std::size_t points_end) {
  if (at < points_end || at > file.bytes.size())
    throw io_error_at_byte(file.path, las::kEvlrs,
                           fmt::format("expected records behind the points, found their offset {}", at));
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t left = file.bytes.size() - at;
    const bool has_header = left >= las::kEvlrHeader;
    const std::uint64_t length = has_header ? number_at<std::uint64_t>(file.bytes, at + 20) : 0;
    if (!has_header || length > left - las::kEvlrHeader)
      throw io_error_at_byte(file.path, file.bytes.size(), "expected an extended record, the file ends here");
    at += las::kEvlrHeader + length;
  }
  return at;
}

// The end of what the header declares: points, extended records, and waveforms, which are one such record.
std::size_t declared_end(const FileBytes& file, const LasHeader& header) {
  std::size_t end = header.points_end();
  if (header.minor_version < 3) return end;
  const bool is_inside = number_at<std::uint16_t>(file.bytes, 6) & 2;  // global encoding: waveforms in this file
  const auto waveforms = number_at<std::uint64_t>(file.bytes, las::kWaveforms);
  if (is_inside && waveforms != 0) end = std::max(end, end_of_records(file, waveforms, 1, header.points_end()));
  if (header.minor_version < 4) return end;
  const auto count = number_at<std::uint32_t>(file.bytes, las::kNumEvlrs);
  const auto records = number_at<std::uint64_t>(file.bytes, las::kEvlrs);
  return count == 0 ? end : std::max(end, end_of_records(file, records, count, header.points_end()));
}

void add_points(const FileBytes& file, const LasHeader& header, CloudBuilder& builder) {
  constexpr std::size_t kIntensity = 12;
  PointValues values{};
  for (std::size_t at = header.points_offset; at < header.points_end(); at += header.record_length) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      values[axis] = number_at<std::int32_t>(file.bytes, at + 4 * axis) * header.scale[axis] + header.offset[axis];
    values[7] = number_at<std::uint16_t>(file.bytes, at + kIntensity);
    builder.add(values);
  }
}

}  // namespace

CloudFile parse_las(const FileBytes& file, const ReadOptions& options) {
  const LasHeader header = HeaderReader(file).read();
  check_num_points(file.path, header.num_points, options);
  const std::size_t end = declared_end(file, header);
  PointTable table;
  table.format = fmt::format("las 1.{} point format {}", header.minor_version, header.point_format);
  table.num_points = header.num_points;
  table.has_intensities = true;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_points(file, header, builder); });
  if (options.keep_fields)
    read.las = LasRecords{file.bytes.substr(0, header.points_offset),
                          file.bytes.substr(header.points_offset, header.num_points * header.record_length),
                          file.bytes.substr(header.points_end()),
                          header.record_length,
                          header.point_format,
                          header.scale,
                          header.offset};
  if (end < file.bytes.size())
    read.report.warnings.push_back(
        fmt::format("{} bytes after the declared content were not read", file.bytes.size() - end));
  return read;
}

}  // namespace augicp
