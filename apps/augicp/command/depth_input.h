// SPDX-License-Identifier: MIT
// Depth images among the inputs of a subcommand, and messages of recordings, which may be some.
#pragma once

#include <filesystem>

#include "apps/augicp/command/inputs.h"
#include "augicp/io/bag_message_name.h"

namespace augicp::app {

// An array may be a cloud too: only a camera makes it an image.
bool is_depth_image(const std::filesystem::path& path, const InputOptions& options);

// grey_path: see read_input(), which throws the same.
Input read_depth_input(const std::filesystem::path& path, const InputOptions& options,
                       const std::filesystem::path& grey_path);

// A cloud (PointCloud2), or a depth image with the camera of its recording, unless another is given. The topic is that
// of the name, or else of the options, or else the only one of clouds and depth images. Integers are millimetres unless
// the options state another scale. Throws as read_input() does.
Input read_message_input(const BagMessageName& name, const InputOptions& options,
                         const std::filesystem::path& grey_path);

}  // namespace augicp::app
