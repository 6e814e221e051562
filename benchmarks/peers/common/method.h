// SPDX-License-Identifier: MIT
// What a peer is to the rest of the benchmark: a few named methods, each a function from a pair to what it found.
#pragma once

#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "augicp/geometry/rigid3.h"
#include "augicp/sensor/depth_image.h"

namespace augicp::peers {

// One of the two things to register, as augicp's readers gave it: every peer works on the same points.
struct Input {
  Cloud cloud;                      // origin zero; of a depth image what unproject() makes of it
  std::optional<DepthImage> image;  // free of its lens
};

struct Pair {
  const Input& source;
  const Input& target;
  std::string scene;              // depth, lidar, car, redkitchen or bunny: which lengths are right
  std::optional<Pinhole> camera;  // with images only
  Rigid3 guess;                   // target_from_source
};

struct Found {
  std::optional<Rigid3> target_from_source;  // nothing where the peer gives none
  std::string verdict;                       // the peer's own, in its own words; empty where it has none
  std::optional<double> score;               // likewise, see README.md for what it measures
  std::optional<int> iterations;
  double preprocess_ms = 0.0;  // what does not depend on the guess, for both inputs: thinning, normals, trees
  double align_ms = 0.0;
};

struct Method {
  std::string name;
  std::function<Found(const Pair&)> run;
};

struct Peer {
  std::string name;
  int num_threads = 1;  // as many as its methods may use
  std::vector<Method> methods;
};

// Processor time of this program: with one thread what a clock on the wall would show, were the machine not shared.
class Stopwatch {
 public:
  // Since the construction or the last call.
  double lap_ms() {
    const std::clock_t now = std::clock();
    const double lap_ms = 1e3 * static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    last_ = now;
    return lap_ms;
  }

 private:
  std::clock_t last_ = std::clock();
};

}  // namespace augicp::peers
