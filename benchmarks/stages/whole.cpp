// SPDX-License-Identifier: MIT
// What users wait for.
#include "augicp/cloud/voxel_grid.h"
#include "augicp/io/depth_png.h"
#include "augicp/odometry/odometry.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;

void one_more_frame(benchmark::State& state) {
  const NewFrame frame(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(frame.registered());
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
  for (auto _ : state) benchmark::DoNotOptimize(register_scans(scan_of(source), scan_of(target), {}, options).result);
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
