// SPDX-License-Identifier: MIT
#include <cmath>

#include "augicp/io/camera_file.h"
#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

namespace {

// So that no file of the machine is read.
bool is_no_path(const std::string& text) { return text.size() < 256 && text.find_first_of("./") == text.npos; }

// What a user may give instead of a file: a name or numbers.
void expect_camera_or_error(const std::string& text) {
  try {
    read_camera(text).check();
  } catch (const IoError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileBytes file = fuzz::file_of("any.json", data, size);
  fuzz::expect_read_or_refused(file.path, [&] {
    const DepthCamera camera = parse_camera(file);
    const Pinhole& pinhole = camera.pinhole;
    expect(pinhole.fx > 0.0 && pinhole.fy > 0.0, "focal lengths above 0");
    expect(std::isfinite(pinhole.cx) && std::isfinite(pinhole.cy), "a finite centre");
    expect(pinhole.width >= 0 && pinhole.height >= 0, "no negative size");
    expect(camera.distortion({0.5, 0.5}).allFinite(), "a lens that sends rays somewhere");
    expect(camera.readout_s >= 0.0 && camera.readout_s <= 1.0, "a readout of at most a second");
  });
  if (is_no_path(file.bytes)) expect_camera_or_error(file.bytes);
  return 0;
}
