// SPDX-License-Identifier: MIT
// Aligns two scans from files in one call.
#include <iostream>

#include "augicp/augicp.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: example_1_align_scans SOURCE TARGET\n";
    return 2;
  }
  const augicp::Scan source = augicp::scan_of(augicp::read_cloud(argv[1]).cloud);
  const augicp::Scan target = augicp::scan_of(augicp::read_cloud(argv[2]).cloud);
  const augicp::AlignResult result = augicp::register_scans(source, target).result;
  std::cout << augicp::name_of(result.status) << " after " << result.iterations << " iterations\n"
            << result.target_from_source.matrix() << "\n";
  return result.status == augicp::AlignStatus::Converged ? 0 : 1;
}
