// SPDX-License-Identifier: MIT
// What a registration is doing, for callers who show it.
#pragma once

#include <cstddef>
#include <functional>

#include "augicp/core/words.h"

namespace augicp {

enum class Stage {
  Surfaces,     // both scans are downsampled, and their surfaces estimated
  Indexing,     // trees are built for the search of correspondences
  Search,       // rotations of the guess are tried on few points
  Descriptors,  // poses are proposed by points that look alike, without a guess
  Coarse,       // depth images are aligned at a coarse resolution
  Aligning,     // the iterations at full resolution
  Verdict,      // what both scans say of the pose
  Rivals,       // other poses that may fit as well, in scenes with symmetries
  FinerBalls,   // both scans are prepared again in balls half as wide
  FinalPass,    // once more in smaller balls
};
template <>
inline constexpr auto kWords<Stage> = std::to_array<Word<Stage>>({{Stage::Surfaces, "surfaces"},
                                                                  {Stage::Indexing, "indexing"},
                                                                  {Stage::Search, "search"},
                                                                  {Stage::Descriptors, "descriptors"},
                                                                  {Stage::Coarse, "coarse"},
                                                                  {Stage::Aligning, "aligning"},
                                                                  {Stage::Verdict, "verdict"},
                                                                  {Stage::Rivals, "rivals"},
                                                                  {Stage::FinerBalls, "finer_balls"},
                                                                  {Stage::FinalPass, "final_pass"}});

// An item of a stage begins if done is below total; else the last one has ended. Several starts are aligned and judged
// one after the other: these stages then alternate.
struct StageReport {
  Stage stage = Stage::Surfaces;
  std::size_t done = 0;
  std::size_t total = 1;  // items that are known so far
};

using StageListener = std::function<void(const StageReport&)>;

// The place of a start among those that are led on.
struct Turn {
  std::size_t done = 0;
  std::size_t total = 1;
};

// work(), between the reports that it begins and that it has ended.
template <typename Work>
auto reported(const StageListener& on_stage, Stage stage, const Work& work, Turn turn = {}) {
  if (on_stage) on_stage({stage, turn.done, turn.total});
  auto result = work();
  if (on_stage) on_stage({stage, turn.done + 1, turn.total});
  return result;
}

}  // namespace augicp
