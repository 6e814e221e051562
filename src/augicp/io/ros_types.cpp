// SPDX-License-Identifier: MIT
// Definitions of the types of ROS 2 that are written. A definition ends with those of the types within, each behind a
// line of 80 '=' and its name.
#include "augicp/io/ros_messages.h"

namespace augicp {
namespace {

constexpr const char* kTime = "int32 sec\nuint32 nanosec\n";
constexpr const char* kHeaderFields = "builtin_interfaces/Time stamp\nstring frame_id\n";
constexpr const char* kVector3 = "float64 x\nfloat64 y\nfloat64 z\n";
constexpr const char* kQuaternion = "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n";
constexpr const char* kPointField =
    "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\nuint8 UINT32=6\nuint8 FLOAT32=7\n"
    "uint8 FLOAT64=8\nstring name\nuint32 offset\nuint8 datatype\nuint32 count\n";

std::string within(const std::string& name, const std::string& definition) {
  return std::string(80, '=') + "\nMSG: " + name + "\n" + definition;
}

std::string header_types() {
  return within("std_msgs/Header", kHeaderFields) + within("builtin_interfaces/Time", kTime);
}

}  // namespace

RosType point_cloud2_type() {
  return {"sensor_msgs/msg/PointCloud2",
          "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\n"
          "uint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n" +
              header_types() + within("sensor_msgs/PointField", kPointField)};
}

RosType tf_type() {
  return {
      "tf2_msgs/msg/TFMessage",
      "geometry_msgs/TransformStamped[] transforms\n" +
          within("geometry_msgs/TransformStamped",
                 "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n") +
          header_types() +
          within("geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n") +
          within("geometry_msgs/Vector3", kVector3) + within("geometry_msgs/Quaternion", kQuaternion)};
}

RosType odometry_type() {
  return {"nav_msgs/msg/Odometry",
          "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
          "geometry_msgs/TwistWithCovariance twist\n" +
              header_types() +
              within("geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n") +
              within("geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n") +
              within("geometry_msgs/Point", kVector3) + within("geometry_msgs/Quaternion", kQuaternion) +
              within("geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n") +
              within("geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n") +
              within("geometry_msgs/Vector3", kVector3)};
}

}  // namespace augicp
