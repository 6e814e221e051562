// SPDX-License-Identifier: MIT
// The C++ half of overhead.py: registers two clouds once for each line on standard input, and answers with the time it
// took, by the clock and of all threads together, in seconds, and the first number of the pose.
//
//   python_overhead_cpp SOURCE TARGET VOXEL_SIZE THREADS
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

#include "augicp/io/read_cloud.h"
#include "augicp/registration/registration.h"

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const augicp::Scan source = augicp::scan_of(augicp::read_cloud(argv[1]).cloud);
  const augicp::Scan target = augicp::scan_of(augicp::read_cloud(argv[2]).cloud);
  augicp::RegistrationOptions options;
  options.voxel_size = std::atof(argv[3]);
  options.num_threads = std::atoi(argv[4]);
  for (std::string line; std::getline(std::cin, line);) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t start_of_work = std::clock();
    const augicp::AlignResult result = augicp::register_scans(source, target, {}, options).result;
    const double work_s = static_cast<double>(std::clock() - start_of_work) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    std::printf("%.9f %.9f %.17g\n", passed.count(), work_s, result.target_from_source.matrix()(0, 3));
    std::fflush(stdout);
  }
  return 0;
}
