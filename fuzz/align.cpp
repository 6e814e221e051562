// SPDX-License-Identifier: MIT
// Any bytes as two clouds, a guess and options: registration never throws for what the data are like, its pose is
// rigid, and the number of threads changes nothing.
#include <cstring>
#include <stdexcept>

#include "augicp/io/cloud_from_points.h"
#include "augicp/io/pose_numbers.h"
#include "augicp/registration/registration.h"
#include "fuzz/promises.h"

using namespace augicp;
using fuzz::expect;

namespace {

constexpr std::size_t kMaxPoints = 80;  // of both clouds: an input shall take milliseconds

// Takes numbers off the front of the input; zeros behind its end.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  template <typename Number>
  Number take() {
    Number number{};
    std::memcpy(&number, bytes_.data(), std::min(sizeof(number), bytes_.size()));
    bytes_.remove_prefix(std::min(sizeof(number), bytes_.size()));
    return number;
  }
  std::size_t num_left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

RegistrationOptions take_options(Bytes& bytes) {
  RegistrationOptions options;
  const auto flags = bytes.take<std::uint8_t>(), choices = bytes.take<std::uint8_t>();
  options.method = (flags & 128) ? Method::Ndt : static_cast<Method>(choices % 4);
  options.association = static_cast<Association>(choices / 4 % 3);
  options.preset = (flags & 1) ? Preset::Paper : Preset::Default;
  options.search = flags & 2;
  options.intensity = flags & 4;
  if (flags & 8) options.radius = bytes.take<float>();
  if (flags & 16) options.voxel_size = bytes.take<float>();
  if (flags & 32) options.max_distance = bytes.take<float>();
  if (flags & 64) options.lever = bytes.take<float>();
  options.max_iterations = choices / 16;
  return options;
}

Rigid3 take_guess(Bytes& bytes) {
  std::array<double, 7> numbers{};
  for (double& number : numbers) number = static_cast<double>(bytes.take<float>());
  return pose_of_numbers("guess", numbers);
}

// Positions as any float, or as millimetres within the few metres around zero: both of these find other code.
Cloud take_cloud(Bytes& bytes, std::size_t count, bool in_mm) {
  std::vector<Vec3d> positions;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3d& position = positions.emplace_back();
    for (double& x : position)
      x = in_mm ? 0.001 * bytes.take<std::int16_t>() : static_cast<double>(bytes.take<float>());
  }
  return cloud_from_points({positions.size(), [&](std::size_t i) { return positions[i]; }, {}, {}, {}, {}, {}}).cloud;
}

void expect_sound(const AlignResult& result) {
  fuzz::expect_rigid(result.target_from_source);
  expect(result.overlap >= 0.0 && result.overlap <= 1.0, "an overlap is a share");
  expect(result.status != AlignStatus::Converged || result.num_pairs >= 6, "no success on nothing");
}

void expect_same_with_threads(const Scan& source, const Scan& target, const Rigid3& guess, RegistrationOptions options,
                              const AlignResult& expected) {
  options.num_threads = 3;
  const AlignResult result = register_scans(source, target, guess, options).result;
  expect(result.status == expected.status && result.target_from_source.matrix() == expected.target_from_source.matrix(),
         "the same for any number of threads");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(data, data + size);
  Bytes bytes(input);
  const bool in_mm = bytes.take<std::uint8_t>() % 2 == 0;
  const std::size_t source_share = bytes.take<std::uint8_t>();
  try {
    RegistrationOptions options = take_options(bytes);
    const Rigid3 guess = take_guess(bytes);
    const std::size_t count = std::min(kMaxPoints, bytes.num_left() / (in_mm ? 6 : 12)),
                      num_source = count * source_share / 255;
    const Scan source = scan_of(take_cloud(bytes, num_source, in_mm));
    const Scan target = scan_of(take_cloud(bytes, count - num_source, in_mm));
    options.num_threads = 1;
    const AlignResult result = register_scans(source, target, guess, options).result;
    expect_sound(result);
    if (source_share % 4 == 0) expect_same_with_threads(source, target, guess, options, result);
  } catch (const std::invalid_argument&) {  // options out of their range, or a guess that is no motion
  }
  return 0;
}
