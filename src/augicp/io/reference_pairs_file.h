// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "augicp/geometry/trajectory.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// Known motions between poses: `i j tx ty tz qx qy qz qw` a line, the motion that maps the frame of pose j into that of
// pose i, metres; i < j are places in the sequence, from 0. Further values of a line are ignored; '#' starts a comment.
// Throws IoError naming the line that is not of this form, and if there is no pair.
std::vector<ReferencePair> parse_reference_pairs(const FileBytes& file);
std::vector<ReferencePair> read_reference_pairs(const std::filesystem::path& path);

}  // namespace augicp
