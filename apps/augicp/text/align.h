// SPDX-License-Identifier: MIT
// The result of `augicp align`, as JSON and as text.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "augicp/registration/registration.h"

namespace augicp::app {

struct TimingMs {
  double read = 0.0, surface = 0.0, align = 0.0;
};

struct AlignReport {
  std::string source, target;  // as given by the user
  AlignResult result;
  Lengths lengths;
  TimingMs timing_ms;
  RegistrationOptions options;    // as given
  RegistrationOptions in_effect;  // see options_in_effect()
  bool with_history = false;
  std::array<std::size_t, 2> num_read{}, num_prepared{};  // points of source and target
  double share_of_radius = 1.0;                           // the radius, divided by that of the first registration
  std::vector<std::pair<std::string, double>> steps;      // what was done, and when it began, milliseconds
  Vec3d centre = Vec3d::Zero();                           // of the target's points, in its frame
  Vec3d reference_point = Vec3d::Zero();  // about which increments of the covariance rotate, in the target's frame
};

// Sets the points that its uncertainty refers to, from the prepared target.
void refer_to(const Cloud& target, AlignReport& report);

// A standard deviation of the pose about the centre of the target, where translation and rotation are what they seem.
// It does not depend on where the frame's zero is. Absent without a covariance.
struct Uncertainty {
  double translation = 0.0, rotation = 0.0;  // roots of the summed variances, metres and radians
};
std::optional<Uncertainty> uncertainty(const AlignReport& report);

// The JSON of `augicp align`; see docs/conventions.md.
nlohmann::ordered_json to_json(const AlignReport& report);

// The same as text.
std::string to_text(const AlignReport& report);

// The meaning of a status and the advice, a sentence without its full stop.
std::string advice_for(const AlignResult& result);

}  // namespace augicp::app
