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

// Writers. Positions include their origin: as float if it is zero, else as double, without loss. Directions follow as
// nx ny nz, with the structure as its number, then the intensity. Throw IoError; throw std::invalid_argument for a
// cloud without points.

// Chosen by the extension, .ply or .pcd; binary.
void write_cloud(const std::filesystem::path& path, const Cloud& cloud);

// colours: empty, or one per point. PLY files have no field for the viewpoint.
void write_ply(const std::filesystem::path& path, const Cloud& cloud, std::span<const Colour> colours = {},
               FileEncoding encoding = FileEncoding::Binary);

// A viewpoint of zero is not read back: PCD files state it if they know none.
void write_pcd(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding = FileEncoding::Binary);

}  // namespace augicp
