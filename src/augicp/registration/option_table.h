// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/core/option.h"
#include "augicp/registration/options.h"

namespace augicp {

namespace option_group {
inline constexpr std::string_view kMethod = "Method", kPreset = "Instead of the preset's choice",
                                  kBeyondPaper = "Beyond the paper";
}

// Every option of a registration but stop, see core/option.h.
template <OptionsOf<RegistrationOptions> Options, typename Visit>
void for_each_option(Options& options, const Visit& visit) {
  using namespace option_group;
  constexpr std::string_view derived = "derived", preset = "the preset's";
  using enum Unit;
  visit({"preset", None, kMethod, "default, or paper: the paper to the letter (Table 2)"}, options.preset);
  visit({"method", None, kMethod, "Objective"}, options.method);
  visit({"association", None, kMethod, "How pairs are found; auto: projective for depth images"}, options.association);
  visit({"radius", Metres, kMethod, "Ball for surface statistics", derived}, options.radius);
  visit({"voxel_size", Metres, kMethod, "Downsamples clouds to one point a voxel", derived}, options.voxel_size);
  visit({"max_distance", Metres, kMethod, "Farther pairs are dropped", derived}, options.max_distance);
  visit({"max_angle", Radians, kMethod, "Pairs whose directions differ by more are dropped"}, options.max_angle);
  visit({"max_iterations", None, kMethod, "Most iterations at full resolution"}, options.max_iterations);
  visit({"min_step", None, kMethod, "Smaller steps end the loop: part of the extent, radians; 0: never"},
        options.min_step);
  visit({"threads", None, kMethod, "Threads; 0: all of the machine's; the result is the same for any number"},
        options.num_threads);
  visit({"max_memory_gb", Gigabytes, kMethod, "Clouds whose surfaces would need more memory are refused beforehand",
         "half of the machine's"},
        options.max_memory_gb);
  visit(
      {"covariance", None, kMethod, "The pose's covariance is computed; a small image takes a fifth less time without"},
      options.covariance);
  visit({"classifier", None, kPreset, "Structure from normals or from the points' eigenvalues", preset},
        options.classifier);
  visit({"kernel_chi2", Chi2, kPreset, "K of Eq. (13)", preset}, options.kernel_chi2);
  visit({"lever", Metres, kPreset, "Weight of directions beside positions; 1: Table 2", preset}, options.lever);
  visit({"damping", None, kPreset, "lambda of Eq. (10), relative to H's mean diagonal", preset}, options.damping);
  visit({"search", None, kBeyondPaper, "Other guesses are tried if the given one leads nowhere convincing"},
        options.search);
  visit({"global_", None, kBeyondPaper, "The guess is ignored: the pose is searched among all"}, options.global);
  visit({"coarse_to_fine", None, kBeyondPaper, "Large images are first aligned downsampled"}, options.coarse_to_fine);
  visit({"rolling_shutter", None, kBeyondPaper, "Images bent by a rolling shutter are straightened"},
        options.rolling_shutter);
  visit({"final_pass", None, kBeyondPaper, "Clouds are aligned once more in smaller balls; kept if more certain"},
        options.final_pass);
  visit({"intensity", None, kBeyondPaper, "Brightness counts too, if both inputs have it"}, options.intensity);
}

}  // namespace augicp
