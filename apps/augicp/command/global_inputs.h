// SPDX-License-Identifier: MIT
// The pairs of `augicp experiment global`, from files and from seeds, and to files.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "augicp/experiment/global.h"

namespace augicp::app {

// Clouds stay in place while pairs point to them.
struct GlobalInputs {
  std::deque<Cloud> clouds;
  std::deque<std::vector<Fragment>> fragments;
  std::vector<GlobalPair> pairs;
};

// Lines "family source target truth", paths relative to the list; truth is a file or - for clouds without common
// surface. Throws IoError.
void read_list(const std::filesystem::path& list, GlobalInputs& inputs);

// The pairs of fragments within each folder's sequence. cameras: none, one for all, or one for each folder; "own": the
// folder's. Throws IoError, and std::invalid_argument if the numbers do not match.
void read_fragments(const std::vector<std::string>& folders, const std::vector<std::string>& cameras,
                    const FragmentOptions& options, GlobalInputs& inputs);

// All pairs of fragments of different folders, as pairs without common surface.
void add_apart(GlobalInputs& inputs);

struct GeneratedPairs {
  std::vector<std::string> families;  // none: all
  std::size_t count = 0;              // of each family
  unsigned first_seed = 1;            // others follow
};

// Throws std::invalid_argument if there is no family with a name.
void add_generated(const GeneratedPairs& which, GlobalInputs& inputs);

// Writes the clouds, the true poses, and pairs.txt, a list that read_list() reads. The folder is made if there is none.
// Throws IoError.
void save_pairs(const std::filesystem::path& folder, const std::vector<GlobalPair>& pairs);

}  // namespace augicp::app
