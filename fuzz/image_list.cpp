// SPDX-License-Identifier: MIT
// The list of images of a TUM sequence: depth.txt.
#include <algorithm>
#include <cmath>

#include "augicp/io/sequence_folders.h"
#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("folder/depth.txt", data, size);
  fuzz::expect_read_or_refused(file.path, [&] {
    const std::vector<DepthFrameFile> frames = parse_image_list(file);
    for (const DepthFrameFile& frame : frames) {
      expect(std::isfinite(frame.stamp_s), "a finite stamp");
      expect(frame.path.has_filename() || frame.path.has_parent_path(), "a path");
    }
    const auto num_lines =
        1 + std::count_if(file.bytes.begin(), file.bytes.end(), [](char c) { return c == '\n' || c == '\r'; });
    expect(frames.size() <= static_cast<std::size_t>(num_lines), "a frame a line at most");
  });
  return 0;
}
