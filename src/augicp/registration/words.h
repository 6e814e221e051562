// SPDX-License-Identifier: MIT
// Words of enumerators, for the command, its files and Python.
#pragma once

#include "augicp/core/words.h"
#include "augicp/registration/options.h"

namespace augicp {

inline const std::map<std::string, Method> kMethods{
    {"augmented", Method::Augmented}, {"gicp", Method::Gicp}, {"plane", Method::Plane}, {"point", Method::Point}};
inline const std::map<std::string, Preset> kPresets{{"default", Preset::Default}, {"paper", Preset::Paper}};
inline const std::map<std::string, Classifier> kClassifiers{{"normals", Classifier::Normals},
                                                            {"eigenvalues", Classifier::Eigenvalues}};
inline const std::map<std::string, Association> kAssociations{
    {"auto", Association::Auto}, {"projective", Association::Projective}, {"nearest", Association::Nearest}};

}  // namespace augicp
