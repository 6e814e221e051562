// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace augicp::app {

// An array of rows.
nlohmann::ordered_json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

}  // namespace augicp::app
