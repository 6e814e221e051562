// SPDX-License-Identifier: MIT
#include "benchmarks/peers/common/run_peer.h"

#include <algorithm>
#include <iostream>
#include <span>
#include <stdexcept>

#include "augicp/io/atomic_file.h"
#include "benchmarks/peers/common/input.h"
#include "benchmarks/peers/common/job.h"
#include "benchmarks/peers/common/result_line.h"

namespace augicp::peers {
namespace {

std::vector<Method> chosen(const Peer& peer, std::span<char*> names) {
  if (names.empty()) return peer.methods;
  std::vector<Method> methods;
  for (const std::string_view name : names) {
    const auto method = std::find_if(peer.methods.begin(), peer.methods.end(),
                                     [&](const Method& candidate) { return candidate.name == name; });
    if (method == peer.methods.end()) throw std::invalid_argument(peer.name + " has no method " + std::string(name));
    methods.push_back(*method);
  }
  return methods;
}

// Methods one after the other within a job, so that both files are read once.
std::string run_jobs(const Peer& peer, const std::vector<Method>& methods, const std::vector<Job>& jobs) {
  std::string lines = result_header();
  std::vector<Rigid3> previous(methods.size());
  InputReader reader;
  for (const Job& job : jobs) {
    const auto [source, target] = reader.read(job);
    const auto pinhole = job.camera ? std::optional(job.camera->pinhole) : std::nullopt;
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const Found found = methods[i].run({*source, *target, job.scene, pinhole, job.guess.value_or(previous[i])});
      previous[i] = found.target_from_source.value_or(Rigid3{});
      lines += result_line(job.pair, peer, methods[i].name, found);
    }
  }
  return lines;
}

}  // namespace

int run_peer(int argc, char** argv, const Peer& peer) {
  if (argc < 3) {
    std::cerr << "usage: " << argv[0] << " JOBS RESULTS [METHOD...]\n";
    return 2;
  }
  try {
    const std::span<char*> names(argv + 3, static_cast<std::size_t>(argc - 3));
    write_file(argv[2], run_jobs(peer, chosen(peer, names), read_jobs(argv[1])));
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace augicp::peers
