// SPDX-License-Identifier: MIT
// The result of `augicp align`, as JSON and as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

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
  RegistrationOptions options;
  bool with_history = false;
};

// The options as they took effect, with the lengths that were derived.
RegistrationOptions effective_options(const AlignReport& report);

// The JSON of `augicp align`; see docs/conventions.md.
nlohmann::ordered_json to_json(const AlignReport& report);

// The same as text.
std::string to_text(const AlignReport& report);

// The meaning of a status and the advice, a sentence without its full stop.
std::string advice_for(AlignStatus status);

}  // namespace augicp::app
