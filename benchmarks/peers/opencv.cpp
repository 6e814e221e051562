// SPDX-License-Identifier: MIT
// OpenCV's depth odometries: the rgbd module's ICPOdometry and FastICPOdometry with every parameter at its default.
#include <Eigen/Core>
#include <opencv2/core/eigen.hpp>
#include <opencv2/core/ocl.hpp>
#include <opencv2/rgbd/depth.hpp>
#include <stdexcept>

#include "benchmarks/peers/common/pose.h"
#include "benchmarks/peers/common/run_peer.h"

namespace augicp::peers {
namespace {

using cv::rgbd::Odometry;
using cv::rgbd::OdometryFrame;

cv::Ptr<OdometryFrame> frame_of(const Input& input) {
  if (!input.image) throw std::invalid_argument("opencv registers depth images only");
  const DepthImage& image = *input.image;
  cv::Mat depth_m(image.height, image.width, CV_32F);  // NaN is no reading, here and there
  std::copy(image.depth.begin(), image.depth.end(), depth_m.begin<float>());
  return OdometryFrame::create(cv::Mat(), depth_m);
}

cv::Mat camera_matrix(const Pinhole& camera) {
  return (cv::Mat_<float>(3, 3) << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1);
}

cv::Mat matrix_of(const Rigid3& pose) {
  cv::Mat matrix;
  cv::eigen2cv(pose.matrix(), matrix);
  return matrix;
}

std::optional<Rigid3> pose_of(const cv::Mat& matrix) {
  Mat4d pose;
  cv::cv2eigen(matrix, pose);
  return rigid_or_nothing(pose);
}

Found run(const Odometry& odometry, const Pair& pair) {
  cv::Ptr<OdometryFrame> source = frame_of(pair.source), target = frame_of(pair.target);
  Found found;
  Stopwatch watch;
  odometry.prepareFrameCache(source, OdometryFrame::CACHE_SRC);
  odometry.prepareFrameCache(target, OdometryFrame::CACHE_DST);
  found.preprocess_ms = watch.lap_ms();
  cv::Mat target_from_source;
  const bool ok = odometry.compute(source, target, target_from_source, matrix_of(pair.guess));
  found.align_ms = watch.lap_ms();
  found.verdict = ok ? "true" : "false";
  // Where it returns false its matrix is not meant to be used.
  if (ok) found.target_from_source = pose_of(target_from_source);
  return found;
}

Found run_icp(const Pair& pair) {
  return run(*cv::rgbd::ICPOdometry::create(camera_matrix(pair.camera.value())), pair);
}

Found run_fast_icp(const Pair& pair) {
  return run(*cv::rgbd::FastICPOdometry::create(camera_matrix(pair.camera.value())), pair);
}

}  // namespace
}  // namespace augicp::peers

int main(int argc, char** argv) {
  using namespace augicp::peers;
  cv::setNumThreads(1);
  cv::ocl::setUseOpenCL(false);  // one core here for everybody
  return run_peer(argc, argv, {"opencv", 1, {{"ICPOdometry", run_icp}, {"FastICPOdometry", run_fast_icp}}});
}
