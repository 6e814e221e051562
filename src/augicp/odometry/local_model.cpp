// SPDX-License-Identifier: MIT
#include "augicp/odometry/local_model.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "augicp/sensor/projection.h"

namespace augicp {
namespace {

struct ExtendedPoint {
  Vec3f position, direction;
  Structure structure;
  float weight;
  std::optional<PointGaussian> gaussian;
};

// Reads the points of a cloud in another frame.
class MovedPoints {
 public:
  MovedPoints(const Cloud& cloud, const Rigid3& b_from_a) : cloud_(cloud), b_from_a_(b_from_a) {}

  ExtendedPoint operator[](std::int32_t i) const {
    ExtendedPoint point{b_from_a_ * cloud_.points[i], b_from_a_.rotation * cloud_.directions[i], cloud_.structures[i],
                        cloud_.weights.empty() ? 1.0f : cloud_.weights[i], std::nullopt};
    if (cloud_.has_gaussians()) point.gaussian = b_from_a_ * cloud_.gaussians[i];
    return point;
  }

 private:
  const Cloud& cloud_;
  Rigid3f b_from_a_;
};

void append(LocalModel& model, const ExtendedPoint& point, float weight, std::size_t pixel) {
  Cloud& cloud = model.scan.cloud;
  model.scan.view->index.index[pixel] = static_cast<std::int32_t>(cloud.size());
  cloud.points.push_back(point.position);
  cloud.directions.push_back(point.direction);
  cloud.structures.push_back(point.structure);
  cloud.weights.push_back(point.weight);
  if (point.gaussian) cloud.gaussians.push_back(*point.gaussian);
  model.weights.push_back(weight);
}

void average(LocalModel& model, std::int32_t i, ExtendedPoint seen, const MergeOptions& options) {
  Cloud& cloud = model.scan.cloud;
  if (seen.structure != cloud.structures[i]) return;
  if ((seen.position - cloud.points[i]).norm() > static_cast<float>(options.max_distance)) return;
  const float before = model.weights[i], sum = before + seen.weight;
  if (seen.structure != Structure::None) {
    float cosine = seen.direction.dot(cloud.directions[i]);
    if (seen.structure == Structure::Edge && cosine < 0.0f) {  // tangents have no sign
      seen.direction = -seen.direction;
      cosine = -cosine;
    }
    if (cosine < static_cast<float>(std::cos(options.max_angle))) return;
    cloud.directions[i] = (before * cloud.directions[i] + seen.weight * seen.direction).normalized();
  }
  cloud.points[i] = (before * cloud.points[i] + seen.weight * seen.position) / sum;
  if (seen.gaussian) {
    PointGaussian& gaussian = cloud.gaussians[i];
    gaussian.mean = (before * gaussian.mean + seen.weight * seen.gaussian->mean) / sum;
    gaussian.information = (before * gaussian.information + seen.weight * seen.gaussian->information) / sum;
  }
  model.weights[i] = std::min(sum, static_cast<float>(options.max_weight));
}

// Whether the keyframe sees this point of the old model.
bool still_seen(const ExtendedPoint& point, const Scan& keyframe, std::size_t pixel, const MergeOptions& options) {
  const bool turned_away = point.structure == Structure::Planar && point.direction.dot(point.position) > 0.0f;
  const std::int32_t i = keyframe.view->index.index[pixel];
  if (turned_away || i == IndexImage::kNone) return !turned_away;
  // Twice the distance of merging: the average corrects small errors.
  return std::abs(point.position.z() - keyframe.cloud.points[i].z()) <= 2.0f * static_cast<float>(options.max_distance);
}

}  // namespace

LocalModel model_of(const Scan& keyframe) {
  LocalModel model{keyframe, {}};
  std::vector<float>& weights = model.scan.cloud.weights;
  if (weights.empty()) weights.assign(keyframe.cloud.size(), 1.0f);
  model.weights = weights;
  model.scan.cloud.intensities.clear();  // not averaged
  model.scan.cloud.intensity_gradients.clear();
  return model;
}

void merge(LocalModel& model, const Scan& frame, const Rigid3& model_from_frame, const MergeOptions& options,
           int num_threads) {
  const IndexImage& index = model.scan.view->index;
  const IndexImage seen =
      project(frame.cloud, model_from_frame, model.scan.view->camera, index.width, index.height, num_threads);
  const MovedPoints moved(frame.cloud, model_from_frame);
  for (std::size_t pixel = 0; pixel < seen.index.size(); ++pixel) {
    if (seen.index[pixel] == IndexImage::kNone) continue;
    const ExtendedPoint point = moved[seen.index[pixel]];
    if (index.index[pixel] == IndexImage::kNone) {
      append(model, point, point.weight, pixel);
    } else {
      average(model, index.index[pixel], point, options);
    }
  }
}

LocalModel carried_over(const LocalModel& model, const Scan& keyframe, const Rigid3& keyframe_from_model,
                        const MergeOptions& options, int num_threads) {
  const Scan::View& view = *keyframe.view;
  LocalModel carried;
  carried.scan.view = Scan::View{IndexImage(view.index.width, view.index.height), view.camera};
  carried.scan.cloud.viewpoint = keyframe.cloud.viewpoint;
  const IndexImage seen =
      project(model.scan.cloud, keyframe_from_model, view.camera, view.index.width, view.index.height, num_threads);
  const MovedPoints moved(model.scan.cloud, keyframe_from_model);
  for (std::size_t pixel = 0; pixel < seen.index.size(); ++pixel) {
    const std::int32_t i = seen.index[pixel];
    if (i == IndexImage::kNone) continue;
    const ExtendedPoint point = moved[i];
    if (still_seen(point, keyframe, pixel, options)) append(carried, point, model.weights[i], pixel);
  }
  merge(carried, keyframe, Rigid3{}, options, num_threads);
  return carried;
}

}  // namespace augicp
