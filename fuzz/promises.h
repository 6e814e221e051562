// SPDX-License-Identifier: MIT
// What must hold for any input, shared by the fuzz targets. A broken promise ends the program, which is how a fuzzer,
// and a test that replays its inputs, learn of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <string_view>

#include "augicp/core/error.h"
#include "augicp/geometry/trajectory.h"
#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp::fuzz {

// Ends the program where a promise does not hold.
void expect(bool holds, std::string_view promise);

// Of a cloud that was read: points finite, arrays of equal length, directions of unit length, the grid's indices within
// the cloud, and every declared point either kept or counted as dropped.
void expect_sound(const CloudFile& file);

// A unit quaternion and a finite translation.
void expect_rigid(const Rigid3& pose);

// Stamps that increase, poses that are rigid, at least one.
void expect_sound(const Trajectory& trajectory);

FileBytes file_of(const std::filesystem::path& name, const std::uint8_t* data, std::size_t size);

// Reads, and where the file is refused expects an IoError that begins with its path. What is thrown else escapes, and
// ends the program too.
template <typename Read>
void expect_read_or_refused(const std::filesystem::path& path, const Read& read) {
  try {
    read();
  } catch (const IoError& error) {
    expect(std::string_view(error.what()).starts_with(path.string() + ": "), "an error begins with the file's path");
  }
}

// All of it for a format of clouds, told by the extension of name.
void check_cloud_reader(const std::filesystem::path& name, const std::uint8_t* data, std::size_t size,
                        const ReadOptions& options = {});

}  // namespace augicp::fuzz
