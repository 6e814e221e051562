// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace augicp {

// A file cannot be read or written as requested. The message names the file, the line or byte, the expected and the
// found content. Bad arguments throw std::invalid_argument instead.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A std::stop_token requested an end; there is no result. See core/stop.h.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace augicp
