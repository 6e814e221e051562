// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

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

nlohmann::ordered_json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

// The JSON of `augicp align`; see docs/conventions.md.
nlohmann::ordered_json to_json(const AlignReport& report);

// The same for people.
std::string to_text(const AlignReport& report);

// What a status means and what to do, a sentence without its stop.
std::string advice_for(AlignStatus status);

// For the page of --report: HTML, how its status is coloured (good, warn or bad), and the options that took effect.
std::string verdict_html(const AlignResult& result);
std::string badge_class(AlignStatus status);
std::vector<std::pair<std::string, std::string>> effective_options(const AlignReport& report);

// To a file, whole or not at all, or to stdout for "-".
void write_json(const std::string& destination, const nlohmann::ordered_json& json);

}  // namespace augicp::app
