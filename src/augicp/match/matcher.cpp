// SPDX-License-Identifier: MIT
#include "augicp/match/matcher.h"

namespace augicp {
namespace {

class PlainSession final : public MatchSession {
 public:
  PlainSession(const Cloud& source, const Matcher& matcher) : source_(source), matcher_(matcher) {}
  std::vector<Correspondence> match(const Rigid3& target_from_source, const Gates& gates, int num_threads) override {
    return matcher_.match(source_, target_from_source, gates, num_threads);
  }

 private:
  const Cloud& source_;
  const Matcher& matcher_;
};

}  // namespace

std::unique_ptr<MatchSession> Matcher::session(const Cloud& source) const {
  return std::make_unique<PlainSession>(source, *this);
}

std::vector<std::vector<Correspondence>> Matcher::match_each(const Cloud& source, std::span<const Rigid3> poses,
                                                             const Gates& gates, int num_threads) const {
  const std::unique_ptr<MatchSession> one_session = session(source);
  std::vector<std::vector<Correspondence>> pairs;
  for (const Rigid3& pose : poses) pairs.push_back(one_session->match(pose, gates, num_threads));
  return pairs;
}

}  // namespace augicp
