// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "augicp/io/cloud_file.h"

namespace augicp {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

enum class FileEncoding : std::uint8_t { Binary, Ascii };  // binary is little endian

// Writers. Positions include their origin, as float if that keeps the cloud's details and else as double. Normals
// follow as nx ny nz, with the structure as its number, the tangents of edges as tangent_x tangent_y tangent_z, then
// the intensity. Throw IoError; throw std::invalid_argument for a cloud without points.

// Chosen by the extension, .ply, .pcd or .las; binary.
void write_cloud(const std::filesystem::path& path, const Cloud& cloud);

// The same with the further columns of file.fields and, in PCD, the rows of file.grid. Returns a sentence for each part
// that the format has no place for, after those of fields.not_kept.
std::vector<std::string> write_cloud(const std::filesystem::path& path, const CloudFile& file);

// colours: empty, or one per point. PLY files have no field for the viewpoint.
void write_ply(const std::filesystem::path& path, const Cloud& cloud, std::span<const Colour> colours = {},
               FileEncoding encoding = FileEncoding::Binary);

// A viewpoint of zero is not read back: PCD files state it if they know none.
void write_pcd(const std::filesystem::path& path, const Cloud& cloud, FileEncoding encoding = FileEncoding::Binary);

// The columns red, green and blue.
std::vector<PointField> colour_fields(std::span<const Colour> colours);

}  // namespace augicp
