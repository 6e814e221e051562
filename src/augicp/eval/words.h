// SPDX-License-Identifier: MIT
// Words of enumerators, for the command, its files and Python.
#pragma once

#include "augicp/core/words.h"
#include "augicp/eval/evaluate.h"

namespace augicp {

inline const std::map<std::string, Alignment> kAlignments{{"none", Alignment::None},
                                                          {"origin", Alignment::Origin},
                                                          {"rigid", Alignment::Rigid},
                                                          {"similarity", Alignment::Similarity}};
inline const std::map<std::string, DeltaUnit> kDeltaUnits{
    {"frames", DeltaUnit::Frames}, {"seconds", DeltaUnit::Seconds}, {"metres", DeltaUnit::Metres}};
inline const std::map<std::string, TruthReading> kTruthReadings{{"nearest", TruthReading::Nearest},
                                                                {"interpolated", TruthReading::Interpolated}};

}  // namespace augicp
