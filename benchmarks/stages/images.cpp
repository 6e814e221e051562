// SPDX-License-Identifier: MIT
// From a file to extended points.
#include "augicp/io/depth_png.h"
#include "augicp/surface/window_surface.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;

void decode_png(benchmark::State& state) {
  const auto file = image_files().at(0);
  std::size_t pixels = 0;
  for (auto _ : state) pixels = read_depth_png(file, 5000.0).depth.size();
  set_counters(state, {.items = static_cast<double>(pixels), .bytes = 6.0 * static_cast<double>(pixels)});
}
BENCHMARK(decode_png)->Unit(kMs);

void rectify_image(benchmark::State& state) {
  const DepthImage raw = raw_image(0);
  for (auto _ : state) benchmark::DoNotOptimize(rectify(raw, camera()));
  set_counters(state,
               {.items = static_cast<double>(raw.depth.size()), .bytes = 8.0 * static_cast<double>(raw.depth.size())});
}
BENCHMARK(rectify_image)->Unit(kMs);

void unproject_image(benchmark::State& state) {
  const int step = static_cast<int>(state.range(0));
  const DepthImage seen = image(0, step);
  const Pinhole pinhole = thinned(camera().pinhole, step);
  for (auto _ : state) benchmark::DoNotOptimize(unproject(seen, pinhole));
  const double pixels = static_cast<double>(seen.depth.size());
  // Reads a depth; writes a point, a weight and an index.
  set_counters(state, {.items = pixels, .bytes = 24.0 * pixels, .float_operations = 20.0 * pixels});
}
BENCHMARK(unproject_image)->ArgName("step")->Arg(4)->Arg(1)->Unit(kMs);

void surface_on_image(benchmark::State& state) {
  const int step = static_cast<int>(state.range(0)), num_threads = static_cast<int>(state.range(1));
  OrganizedCloud seen = points(0, step);
  WindowOptions window;
  window.radius = kRadius;
  for (auto _ : state) estimate_surface(seen.cloud, seen.index, window, {}, num_threads);
  const double pixels = static_cast<double>(seen.index.index.size());
  // Reads a point and an index; writes a direction and a structure. Arms: 4 times 2 distances of 9; sums of positions:
  // 6 products, and 3 additions in each of 2 passes for each of 10 channels, of doubles; of directions twice the same
  // for 8 channels of floats; covariance 30 doubles; two eigenvalues of 70 and vectors of 60.
  set_counters(state, {.items = pixels,
                       .bytes = 29.0 * pixels,
                       .float_operations = (72.0 + 2.0 * (6 + 60 + 30) + 2.0 * (6 + 48) + 260.0) * pixels});
}
BENCHMARK(surface_on_image)->ArgNames({"step", "threads"})->ArgsProduct({{4, 2, 1}, {1}})->Unit(kMs);
BENCHMARK(surface_on_image)->ArgNames({"step", "threads"})->ArgsProduct({{4, 2, 1}, {2}})->Unit(kMs)->UseRealTime();

}  // namespace
}  // namespace augicp::bench
