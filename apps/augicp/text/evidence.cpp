// SPDX-License-Identifier: MIT
#include "apps/augicp/text/evidence.h"

#include <fmt/core.h>

#include <algorithm>

namespace augicp::app {
namespace {

std::string whole_testimony_csv(const Testimony& testimony) {
  return fmt::format("{:d},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},", testimony.knows_free_space, testimony.seen(),
                     testimony.agreeing(), testimony.conflicting(), testimony.contradicting, testimony.off_planes);
}

std::string testimony_header(int side) {
  return fmt::format("free_space_{0},seen_{0},agreeing_{0},conflicting_{0},contradicting_{0},off_planes_{0},", side);
}

}  // namespace

std::string evidence_header() {
  return "strain," + testimony_header(1) + testimony_header(2) + "beyond_planes,moved,observability,outvoted";
}

std::string evidence_csv(const std::optional<Evidence>& evidence) {
  if (!evidence) {
    const std::string header = evidence_header();
    return std::string(static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')), ',');
  }
  return fmt::format("{:.4f},", strain(*evidence)) + whole_testimony_csv(evidence->source_in_target) +
         whole_testimony_csv(evidence->target_in_source) +
         fmt::format("{:.4f},{:.4f},{:.3e},{:.3f}", evidence->beyond_planes, evidence->moved, evidence->observability,
                     evidence->outvoted);
}

}  // namespace augicp::app
