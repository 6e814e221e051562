// SPDX-License-Identifier: MIT
// One iteration: pairs, their chi2 and the normal equations.
#include "augicp/match/matcher.h"
#include "augicp/objective/linearize.h"
#include "augicp/sensor/projection.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;
constexpr double kLever = 0.02;

// Two frames a tenth of a second apart, and the gates of a registration of them.
struct Iteration {
  explicit Iteration(int step)
      : source(extended(3, step)),
        target(extended(0, step)),
        matcher(target.cloud, target.view->index, target.view->camera) {
    gates.max_distance = 0.1;
    gates.max_angle = 1.05;
    pairs = matcher.match(source.cloud, Rigid3{}, gates, 0);
  }
  Scan source, target;
  ProjectiveMatcher matcher;
  Gates gates;
  std::vector<Correspondence> pairs;
};

void project_points(benchmark::State& state) {
  const Iteration at(static_cast<int>(state.range(0)));
  const IndexImage& index = at.target.view->index;
  for (auto _ : state)
    benchmark::DoNotOptimize(project(at.source.cloud, Rigid3{}, at.target.view->camera, index.width, index.height,
                                     static_cast<int>(state.range(1))));
  const double points = static_cast<double>(at.source.cloud.size()), pixels = static_cast<double>(index.index.size());
  // Reads points; empties an image of indices and writes it.
  set_counters(state, {.items = points, .bytes = 12.0 * points + 8.0 * pixels, .float_operations = 25.0 * points});
}
BENCHMARK(project_points)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {1}})->Unit(kMs);
BENCHMARK(project_points)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {2}})->Unit(kMs)->UseRealTime();

void match_by_projection(benchmark::State& state) {
  const Iteration at(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(at.matcher.match(at.source.cloud, Rigid3{}, at.gates, static_cast<int>(state.range(1))));
  const double points = static_cast<double>(at.source.cloud.size());
  const double pixels = static_cast<double>(at.target.view->index.index.size());
  // Beside the projection: two index images, two points, directions and structures, and the pairs.
  set_counters(
      state,
      {.items = points, .bytes = 12.0 * points + 16.0 * pixels + 58.0 * points, .float_operations = 75.0 * points});
}
BENCHMARK(match_by_projection)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {1}})->Unit(kMs);
BENCHMARK(match_by_projection)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {2}})->Unit(kMs)->UseRealTime();

// Reads a pair, two points, directions and structures, and a weight.
constexpr double kBytesPerPair = 8 + 24 + 24 + 2 + 4;

void chi2(benchmark::State& state) {
  const Iteration at(static_cast<int>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(chi2_of_pairs({at.source.cloud, at.target.cloud, at.pairs, Rigid3{}},
                                           default_information(), static_cast<int>(state.range(1))));
  const double pairs = static_cast<double>(at.pairs.size());
  // Places and their errors, 21 doubles; directions and their errors 18, chi2 32.
  set_counters(
      state, {.items = pairs, .bytes = (kBytesPerPair + 8.0) * pairs, .float_operations = (2.0 * 21.0 + 50.0) * pairs});
}
BENCHMARK(chi2)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {1}})->Unit(kMs);
BENCHMARK(chi2)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {2}})->Unit(kMs)->UseRealTime();

void linearize_pairs(benchmark::State& state, const InformationModel& model) {
  const Iteration at(static_cast<int>(state.range(0)));
  const Objective objective{with_lever(model, kLever), 0.01, 0.01};
  for (auto _ : state)
    benchmark::DoNotOptimize(
        linearize({at.source.cloud, at.target.cloud, at.pairs, Rigid3{}}, objective, static_cast<int>(state.range(1))));
  const double pairs = static_cast<double>(at.pairs.size());
  // As for chi2; two losses 60, products 150, sums 31.
  set_counters(state,
               {.items = pairs, .bytes = kBytesPerPair * pairs, .float_operations = (2.0 * 21.0 + 291.0) * pairs});
}
BENCHMARK_CAPTURE(linearize_pairs, augmented, default_information())
    ->ArgNames({"step", "threads"})
    ->ArgsProduct({{4, 1}, {1}})
    ->Unit(kMs);
BENCHMARK_CAPTURE(linearize_pairs, augmented, default_information())
    ->ArgNames({"step", "threads"})
    ->ArgsProduct({{4, 1}, {2}})
    ->Unit(kMs)
    ->UseRealTime();
// Both, as the loop does them: what one stage has read the other finds in the cache only where all of it fits.
void iteration(benchmark::State& state) {
  const Iteration at(static_cast<int>(state.range(0)));
  const int num_threads = static_cast<int>(state.range(1));
  const Objective objective{with_lever(default_information(), kLever), 0.01, 0.01};
  for (auto _ : state) {
    const auto pairs = at.matcher.match(at.source.cloud, Rigid3{}, at.gates, num_threads);
    benchmark::DoNotOptimize(linearize({at.source.cloud, at.target.cloud, pairs, Rigid3{}}, objective, num_threads));
  }
  set_counters(state, {.items = static_cast<double>(at.pairs.size())});
}
BENCHMARK(iteration)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {1}})->Unit(kMs);
BENCHMARK(iteration)->ArgNames({"step", "threads"})->ArgsProduct({{4, 1}, {2}})->Unit(kMs)->UseRealTime();

BENCHMARK_CAPTURE(linearize_pairs, gicp, gicp_information())->ArgNames({"step", "threads"})->Args({1, 1})->Unit(kMs);
BENCHMARK_CAPTURE(linearize_pairs, plane, plane_information())->ArgNames({"step", "threads"})->Args({1, 1})->Unit(kMs);
BENCHMARK_CAPTURE(linearize_pairs, point, point_information())->ArgNames({"step", "threads"})->Args({1, 1})->Unit(kMs);

}  // namespace
}  // namespace augicp::bench
