// SPDX-License-Identifier: MIT
// Two files of points, raw to pose, on one thread and on two; reading is not timed:
//
//   augicp_two_scans SOURCE TARGET VOXEL_SIZE [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>
#include <string>

#include "augicp/io/read_cloud.h"
#include "augicp/registration/registration.h"

namespace augicp::bench {
namespace {

struct Inputs {
  Scan source, target;
  RegistrationOptions options;

  Inputs(const std::string& source_file, const std::string& target_file, const std::string& voxel_size)
      : source(scan_of(read_cloud(source_file).cloud)), target(scan_of(read_cloud(target_file).cloud)) {
    options.voxel_size = std::stod(voxel_size);
    options.search = false;
  }
};

void add_benchmark(const char* name, void (*time)(benchmark::State&, const Inputs&), const Inputs& inputs) {
  for (const int num_threads : {1, 2}) {
    auto* added = benchmark::RegisterBenchmark(name, [=, &inputs](benchmark::State& state) { time(state, inputs); });
    added->ArgName("threads")->Arg(num_threads)->Unit(benchmark::kMillisecond);
    if (num_threads > 1) added->UseRealTime();
  }
}

RegistrationOptions options_of(benchmark::State& state, const Inputs& inputs) {
  RegistrationOptions options = inputs.options;
  options.num_threads = static_cast<int>(state.range(0));
  return options;
}

void prepare_scans(benchmark::State& state, const Inputs& inputs) {
  const RegistrationOptions options = options_of(state, inputs);
  for (auto _ : state) benchmark::DoNotOptimize(prepare_pair(inputs.source, inputs.target, options));
}

void raw_to_pose(benchmark::State& state, const Inputs& inputs) {
  const RegistrationOptions options = options_of(state, inputs);
  AlignResult result;
  for (auto _ : state) result = register_scans(inputs.source, inputs.target, {}, options).result;
  state.counters["iterations"] = result.iterations;
}

}  // namespace
}  // namespace augicp::bench

int main(int argc, char** argv) {
  using namespace augicp::bench;
  benchmark::Initialize(&argc, argv);
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s SOURCE TARGET VOXEL_SIZE\n", argv[0]);
    return 2;
  }
  try {
    const Inputs inputs(argv[1], argv[2], argv[3]);
    add_benchmark("prepare_scans", prepare_scans, inputs);
    add_benchmark("raw_to_pose", raw_to_pose, inputs);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
