// SPDX-License-Identifier: MIT
#include "benchmarks/peers/common/result_line.h"

#include "augicp/io/format.h"

namespace augicp::peers {
namespace {

std::string pose_fields(const std::optional<Rigid3>& pose) {
  if (!pose) return ",,,,,,";
  const Vec3d& t = pose->translation;
  const Eigen::Quaterniond& q = pose->rotation;
  return fmt::format("{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}", t.x(), t.y(), t.z(), q.x(), q.y(),
                     q.z(), q.w());
}

template <typename Value>
std::string field(const std::optional<Value>& value) {
  return value ? fmt::format("{}", *value) : "";
}

}  // namespace

std::string result_header() {
  return "pair,peer,method,verdict,score,tx,ty,tz,qx,qy,qz,qw,preprocess_ms,align_ms,iterations,threads\n";
}

std::string result_line(const std::string& pair, const Peer& peer, const std::string& method, const Found& found) {
  return fmt::format("{},{},{},{},{},{},{:.3f},{:.3f},{},{}\n", pair, peer.name, method, found.verdict,
                     field(found.score), pose_fields(found.target_from_source), found.preprocess_ms, found.align_ms,
                     field(found.iterations), peer.num_threads);
}

}  // namespace augicp::peers
