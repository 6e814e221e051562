// SPDX-License-Identifier: MIT
// Aligns two images of a depth camera, with options: GICP's objective and the augmented one, with the same search for
// pairs.
#include <iostream>

#include "augicp/augicp.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: example_2_align_depth_images SOURCE.png TARGET.png\n";
    return 2;
  }
  const augicp::DepthCamera camera = *augicp::camera_by_name("tum-fr1");
  const double depth_scale = 5000.0;  // TUM: pixel value of one metre
  const augicp::Scan source = augicp::scan_of(augicp::read_depth_png(argv[1], depth_scale), camera);
  const augicp::Scan target = augicp::scan_of(augicp::read_depth_png(argv[2], depth_scale), camera);

  for (const augicp::Method method : {augicp::Method::Augmented, augicp::Method::Gicp}) {
    augicp::RegistrationOptions options;
    options.method = method;
    const augicp::AlignResult result = augicp::register_scans(source, target, augicp::Rigid3{}, options).result;
    std::cout << augicp::name_of(result.status) << " after " << result.iterations << " iterations, "
              << result.target_from_source.translation.norm() << " m moved\n";
  }
}
