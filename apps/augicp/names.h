// SPDX-License-Identifier: MIT
// The words of the command line for the library's choices.
#pragma once

#include <map>
#include <string>

#include "apps/augicp/progress.h"
#include "augicp/eval/evaluate.h"
#include "augicp/odometry/odometry.h"
#include "augicp/registration/options.h"

namespace augicp::app {

inline const std::map<std::string, Method> kMethods{
    {"augmented", Method::Augmented}, {"gicp", Method::Gicp}, {"plane", Method::Plane}, {"point", Method::Point}};
inline const std::map<std::string, Preset> kPresets{{"default", Preset::Default}, {"paper", Preset::Paper}};
inline const std::map<std::string, Classifier> kClassifiers{{"normals", Classifier::Normals},
                                                            {"eigenvalues", Classifier::Eigenvalues}};
inline const std::map<std::string, Association> kAssociations{
    {"auto", Association::Auto}, {"projective", Association::Projective}, {"nearest", Association::Nearest}};
inline const std::map<std::string, Alignment> kAlignments{{"none", Alignment::None},
                                                          {"origin", Alignment::Origin},
                                                          {"rigid", Alignment::Rigid},
                                                          {"similarity", Alignment::Similarity}};
inline const std::map<std::string, DeltaUnit> kDeltaUnits{
    {"frames", DeltaUnit::Frames}, {"seconds", DeltaUnit::Seconds}, {"metres", DeltaUnit::Metres}};
inline const std::map<std::string, TruthReading> kTruthReadings{{"nearest", TruthReading::Nearest},
                                                                {"interpolated", TruthReading::Interpolated}};

inline const std::map<std::string, Reference> kReferences{{"model", Reference::Model},
                                                         {"previous", Reference::PreviousFrame}};
inline const std::map<std::string, Progress> kProgress{{"auto", Progress::Auto}, {"none", Progress::None}};

template <typename Value>
std::string word_for(const std::map<std::string, Value>& words, Value value) {
  for (const auto& [word, meaning] : words)
    if (meaning == value) return word;
  return {};
}

}  // namespace augicp::app
