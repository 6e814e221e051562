// SPDX-License-Identifier: MIT
// What users wait for.
#include "augicp/cloud/voxel_grid.h"
#include "augicp/io/depth_png.h"
#include "augicp/odometry/odometry.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;

RegistrationOptions options_with(int num_threads, int max_iterations) {
  RegistrationOptions options = iterations_alone();
  options.num_threads = num_threads;
  options.max_iterations = max_iterations;
  options.min_step = 0.0;
  return options;
}

// A new image to extended points, and ten iterations to the frame before.
void one_more_frame(benchmark::State& state) {
  const int step = static_cast<int>(state.range(0));
  RegistrationOptions options = options_with(static_cast<int>(state.range(1)), 10);
  options.covariance = false;  // as in odometry, and as peers have none
  const DepthImage seen = image(3, step);
  const Pinhole pinhole = thinned(camera().pinhole, step);
  const Scan target = extended(0, step);
  const Lengths lengths = derive_lengths(target, target);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        register_prepared(prepare(scan_of(seen, pinhole), lengths, options), target, {}, lengths, options));
  set_counters(state, {.items = 1.0});
}
BENCHMARK(one_more_frame)->ArgNames({"step", "threads"})->ArgsProduct({{4, 2, 1}, {1}})->Unit(kMs);
BENCHMARK(one_more_frame)->ArgNames({"step", "threads"})->ArgsProduct({{4, 2, 1}, {2}})->Unit(kMs)->UseRealTime();

// Two clouds, raw to pose, as registration does it by itself.
void two_clouds(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  RegistrationOptions options;
  options.num_threads = static_cast<int>(state.range(1));
  const Cloud target = cloud_of(count);
  const Rigid3 motion{Eigen::Quaterniond(Eigen::AngleAxisd(0.03, Vec3d::UnitY())), Vec3d(0.02, 0.01, -0.02)};
  const Cloud source = transform(target, motion);
  for (auto _ : state) benchmark::DoNotOptimize(register_scans(scan_of(source), scan_of(target), {}, options));
  set_counters(state, {.items = static_cast<double>(count)});
}
BENCHMARK(two_clouds)->ArgNames({"points", "threads"})->ArgsProduct({{70000}, {1}})->Unit(kMs);
BENCHMARK(two_clouds)->ArgNames({"points", "threads"})->ArgsProduct({{70000}, {2}})->Unit(kMs)->UseRealTime();

// File to pose, the mean over the sample.
void odometry_frame(benchmark::State& state) {
  OdometryOptions options;
  options.registration.num_threads = static_cast<int>(state.range(0));
  const auto files = image_files();
  for (auto _ : state) {
    Odometry odometry(options, camera().readout_s);
    for (std::size_t k = 0; k < files.size(); ++k)
      benchmark::DoNotOptimize(odometry.add(static_cast<double>(k) / 30.0,
                                            prepare_frame(read_depth_png(files[k], 5000.0), camera(), options)));
  }
  set_counters(state, {.items = static_cast<double>(files.size())});
}
BENCHMARK(odometry_frame)->ArgName("threads")->Arg(1)->Unit(kMs);
BENCHMARK(odometry_frame)->ArgName("threads")->Arg(2)->Unit(kMs)->UseRealTime();

}  // namespace
}  // namespace augicp::bench
