// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include "augicp/cloud/cloud.h"

namespace augicp {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

enum class FileEncoding : std::uint8_t { Binary, Ascii };  // binary is little endian

// Writers. Positions are written with their origin: as float where that is zero, else as double, so that nothing is
// lost. Directions follow as nx ny nz, with the structure as its number, then the
// intensity. Throw IoError, and std::invalid_argument for a
// cloud without points.

// By extension, .ply or .pcd, binary.
void write_cloud(const std::filesystem::path& path, const Cloud& cloud);

// colours: none, or one a point. A PLY file has no place for the viewpoint.
void write_ply(const std::filesystem::path& path, const Cloud& cloud, std::span<const Colour> colours = {},
               FileEncoding encoding = FileEncoding::Binary);

// A viewpoint of zero is what PCD files state when they know none: it is not read back.
void write_pcd(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding = FileEncoding::Binary);

}  // namespace augicp
