// SPDX-License-Identifier: MIT
// Stages of OpenCV beside those of augicp, on the same image, in one run and on one thread.
#include <algorithm>
#include <opencv2/core/ocl.hpp>
#include <opencv2/rgbd/depth.hpp>

#include "augicp/surface/window_surface.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

constexpr auto kMs = benchmark::kMillisecond;

// One core for everybody.
void use_one_thread() {
  cv::setNumThreads(1);
  cv::ocl::setUseOpenCL(false);
}

cv::Mat depth_of(std::size_t frame) {
  const DepthImage seen = image(frame);
  cv::Mat depth_m(seen.height, seen.width, CV_32F);  // NaN is no reading, here and there
  std::copy(seen.depth.begin(), seen.depth.end(), depth_m.begin<float>());
  return depth_m;
}

cv::Mat camera_matrix() {
  const Pinhole& pinhole = camera().pinhole;
  return (cv::Mat_<float>(3, 3) << pinhole.fx, 0, pinhole.cx, 0, pinhole.fy, pinhole.cy, 0, 0, 1);
}

// From depth to directions: ours with structures, from balls of some centimetres.
void surface_augicp(benchmark::State& state) {
  const DepthImage seen = image(0);
  WindowOptions window;
  window.radius = kRadius;
  for (auto _ : state) {
    OrganizedCloud points = unproject(seen, camera().pinhole);
    estimate_surface(points.cloud, points.index, window, {}, 1);
    benchmark::DoNotOptimize(points);
  }
}
BENCHMARK(surface_augicp)->Unit(kMs);

// Theirs without, from so many pixels a side.
void normals_opencv(benchmark::State& state, cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD method) {
  use_one_thread();
  const cv::Mat depth_m = depth_of(0), camera = camera_matrix();
  const cv::rgbd::RgbdNormals normals(depth_m.rows, depth_m.cols, CV_32F, camera, static_cast<int>(state.range(0)),
                                      method);
  normals.initialize();  // once a camera
  cv::Mat points, found;
  for (auto _ : state) {
    cv::rgbd::depthTo3d(depth_m, camera, points);
    normals(points, found);
  }
}
BENCHMARK_CAPTURE(normals_opencv, fals, cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_FALS)
    ->ArgName("window")
    ->Arg(5)
    ->Arg(7)
    ->Unit(kMs);
BENCHMARK_CAPTURE(normals_opencv, sri, cv::rgbd::RgbdNormals::RGBD_NORMALS_METHOD_SRI)
    ->ArgName("window")
    ->Arg(5)
    ->Arg(7)
    ->Unit(kMs);

// From depth to pose, the target being ready.
void frame_augicp(benchmark::State& state) {
  const NewFrame frame(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(frame.registered());
}
BENCHMARK(frame_augicp)->ArgName("step")->Arg(4)->Arg(2)->Arg(1)->Unit(kMs);

template <typename Odometry>
void frame_opencv(benchmark::State& state) {
  using cv::rgbd::OdometryFrame;
  use_one_thread();
  const auto odometry = Odometry::create(camera_matrix());
  const cv::Mat depth_m = depth_of(3);
  auto target = OdometryFrame::create(cv::Mat(), depth_of(0));
  odometry->prepareFrameCache(target, OdometryFrame::CACHE_DST);
  cv::Mat target_from_source;
  for (auto _ : state) {
    auto source = OdometryFrame::create(cv::Mat(), depth_m);
    odometry->prepareFrameCache(source, OdometryFrame::CACHE_ALL);  // it is the next one's target
    odometry->compute(source, target, target_from_source);
  }
}
BENCHMARK_TEMPLATE(frame_opencv, cv::rgbd::ICPOdometry)->Unit(kMs);
BENCHMARK_TEMPLATE(frame_opencv, cv::rgbd::FastICPOdometry)->Unit(kMs);

}  // namespace
}  // namespace augicp::bench
