// SPDX-License-Identifier: MIT
// A folder of depth images. The input lists its files: a line "@name", then the content up to the next such line.
#include <cmath>
#include <fstream>
#include <string>

#include "augicp/io/depth_sequence.h"
#include "augicp/testing/temporary_folder.h"
#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

namespace {

// A plain name, so that nothing is written elsewhere.
bool is_plain(std::string_view name) {
  return !name.empty() && name.size() < 64 && !name.starts_with('.') &&
         name.find_first_of(std::string_view("/\0", 2)) == name.npos;
}

void fill(const testing::TemporaryFolder& folder, std::string_view input) {
  while (input.starts_with('@')) {
    const std::string_view entry = input.substr(1, input.find("\n@") - 1 + (input.find("\n@") != input.npos));
    input.remove_prefix(1 + entry.size());
    const std::size_t end = std::min(entry.find('\n'), entry.size());
    const std::string_view name = entry.substr(0, end), content = entry.substr(std::min(end + 1, entry.size()));
    if (is_plain(name)) std::ofstream(folder / name, std::ios::binary) << content;
  }
}

void expect_sound_frames(const DepthSequence& sequence) {
  DepthSequenceReader reader(sequence.frames, sequence.depth_scale);
  std::size_t num_frames = 0;
  while (const auto frame = reader.next()) {
    ++num_frames;
    expect(std::isfinite(frame->stamp_s), "a finite stamp");
    expect(frame->problem.empty() != frame->image.depth.empty(), "an image, or what is wrong with it");
  }
  expect(num_frames == sequence.frames.size(), "a frame a file");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(data, data + size);
  const testing::TemporaryFolder folder;
  fill(folder, input);
  try {
    const DepthSequence sequence = read_depth_sequence(folder.path());
    expect(!sequence.frames.empty(), "a sequence that was read has frames");
    if (sequence.truth) fuzz::expect_sound(*sequence.truth);
    if (sequence.camera) sequence.camera->check();
    expect_sound_frames(sequence);
  } catch (const IoError& error) {
    expect(std::string_view(error.what()).starts_with(folder.path().string()), "an error names a file of the folder");
  }
  return 0;
}
