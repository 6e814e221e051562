// SPDX-License-Identifier: MIT
// Trees, and surfaces on clouds.
#include "augicp/cloud/voxel_grid.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/estimate_surface.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;

void build_tree(benchmark::State& state) {
  const Cloud cloud = cloud_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(KdTree(cloud));
  set_counters(state, {.items = static_cast<double>(cloud.size())});
}
BENCHMARK(build_tree)->ArgName("points")->Arg(10000)->Arg(100000)->Arg(300000)->Arg(1000000)->Unit(kMs);

void query_tree(benchmark::State& state) {
  const Cloud cloud = cloud_of(static_cast<std::size_t>(state.range(0)));
  const auto count = static_cast<std::size_t>(state.range(1));
  const int num_threads = static_cast<int>(state.range(2));
  const KdTree tree(cloud);
  const Vec3f shift(0.004f, -0.003f, 0.005f);
  for (auto _ : state)
    for_each_block(cloud.size(), num_threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (count == 1)
          benchmark::DoNotOptimize(tree.nearest(cloud.points[i] + shift, 1.0f));
        else
          benchmark::DoNotOptimize(tree.nearest_k(cloud.points[i] + shift, count));
      }
    });
  set_counters(state, {.items = static_cast<double>(cloud.size())});
}
BENCHMARK(query_tree)
    ->ArgNames({"points", "neighbours", "threads"})
    ->ArgsProduct({{10000, 300000}, {1, 20}, {1}})
    ->Unit(kMs);
BENCHMARK(query_tree)
    ->ArgNames({"points", "neighbours", "threads"})
    ->ArgsProduct({{10000, 300000}, {1, 20}, {2}})
    ->Unit(kMs)
    ->UseRealTime();

void thin_cloud(benchmark::State& state) {
  const Cloud cloud = cloud_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(downsample(cloud, kRadius / 4.0));
  set_counters(state, {.items = static_cast<double>(cloud.size())});
}
BENCHMARK(thin_cloud)->ArgName("points")->Arg(100000)->Arg(1000000)->Unit(kMs);

// Balls of some 50 points, as registration makes them.
void surface_on_cloud(benchmark::State& state) {
  Cloud cloud = downsample(cloud_of(static_cast<std::size_t>(state.range(0))), kRadius / 4.0);
  const int num_threads = static_cast<int>(state.range(1));
  for (auto _ : state)
    estimate_surface(cloud, BallNeighbourhood(cloud, {kRadius, 10, 3.0 * kRadius}, num_threads), {}, num_threads);
  set_counters(state, {.items = static_cast<double>(cloud.size())});
}
BENCHMARK(surface_on_cloud)->ArgNames({"points", "threads"})->ArgsProduct({{100000, 1000000}, {1}})->Unit(kMs);
BENCHMARK(surface_on_cloud)
    ->ArgNames({"points", "threads"})
    ->ArgsProduct({{100000, 1000000}, {2}})
    ->Unit(kMs)
    ->UseRealTime();

}  // namespace
}  // namespace augicp::bench
