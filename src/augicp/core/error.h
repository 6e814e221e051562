// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace augicp {

// A file that cannot be read or written as asked. The message names the file, the line or byte, what was expected and
// what was found. Bad arguments are std::invalid_argument instead.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The caller asked for an end through a std::stop_token, and there is no result. See core/stop.h.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace augicp
