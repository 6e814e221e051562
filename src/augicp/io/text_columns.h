// SPDX-License-Identifier: MIT
// The names of the columns of points in text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace augicp {

// The names in a header or a comment, without its mark and without quotes. Colours have the names of .ply files: r g b
// become red green blue, in either case, if all three are there.
std::vector<std::string> column_names(std::string_view line);

// Whether the names are x, y and z, each once, beside others.
bool name_positions(std::span<const std::string> names);

// The columns that a comment before the first point names, as in "# r g b x y z"; empty if it names no positions, or
// another number of columns than the point has. Throws IoError if that contradicts positions in front.
std::vector<std::string> names_in_comment(const std::filesystem::path& path, std::string_view comment,
                                          std::size_t num_numbers);

// The columns that files of this extension have without naming them: normals in .xyzn, colours in .xyzrgb, and of .pts
// files that state a count intensity and colours. Empty for other extensions and numbers of columns.
std::vector<std::string> usual_names(const std::filesystem::path& path, std::size_t num_numbers, bool has_count);

}  // namespace augicp
