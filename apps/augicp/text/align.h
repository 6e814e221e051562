// SPDX-License-Identifier: MIT
// What `augicp align` found, as JSON and as text for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "augicp/registration/registration.h"

namespace augicp::app {

struct TimingMs {
  double read = 0.0, surface = 0.0, align = 0.0;
};

struct AlignReport {
  std::string source, target;  // as the user named them
  AlignResult result;
  Lengths lengths;
  TimingMs timing_ms;
  RegistrationOptions options;
  bool with_history = false;
};

// The options as they took effect, with the lengths that were derived.
RegistrationOptions effective_options(const AlignReport& report);

// The JSON of `augicp align`; see docs/conventions.md.
nlohmann::ordered_json to_json(const AlignReport& report);

// The same for people.
std::string to_text(const AlignReport& report);

// What a status means and what to do, a sentence without its stop.
std::string advice_for(AlignStatus status);

}  // namespace augicp::app
