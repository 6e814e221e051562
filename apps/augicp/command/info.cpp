// SPDX-License-Identifier: MIT
#include "apps/augicp/command/info.h"

#include <fmt/core.h>

#include <memory>
#include <type_traits>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/progress.h"
#include "augicp/io/bag.h"
#include "augicp/registration/registration.h"

namespace augicp::app {
namespace {

struct InfoArguments {
  std::string file, json;
  InputOptions input;
  Progress progress = Progress::Auto;
};

std::string type_name(ScalarType type) {
  const bool is_signed = with_type(type, [](auto zero) { return std::is_signed_v<decltype(zero)>; });
  return fmt::format("{}{}", is_floating(type) ? "float" : is_signed ? "int" : "uint", 8 * num_bytes(type));
}

// What a file has of each point beside its position and direction.
nlohmann::ordered_json columns_json(const Input& input) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const PointField& field : input.las ? fields_of(*input.las).fields : input.fields.fields)
    columns.push_back({{"name", field.name}, {"type", type_name(field.type)}, {"count", field.count}});
  return columns;
}

std::string columns_text(const nlohmann::ordered_json& columns) {
  std::string text;
  for (const auto& column : columns) {
    const auto count = column["count"].get<std::uint64_t>();
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", column["name"].get<std::string>(),
                        column["type"].get<std::string>(), count > 1 ? fmt::format(" x {}", count) : "");
  }
  return text.empty() ? "none beside positions and normals" : text;
}

nlohmann::ordered_json info_json(const std::string& file, const Input& input) {
  const Cloud& cloud = input.scan.cloud;
  const Bounds box = bounds(cloud);
  const Vec3d min = cloud.origin + box.min.cast<double>(), max = cloud.origin + box.max.cast<double>();
  const Lengths lengths = derive_lengths(input.scan, input.scan);
  return {{"file", file},
          {"format", input.report.format},
          {"num_points", cloud.size()},
          {"num_declared", input.report.num_declared},
          {"num_invalid", input.report.num_not_finite},
          {"has_normals", cloud.has_directions()},
          {"has_intensities", cloud.has_intensities()},
          {"columns", columns_json(input)},
          {"min", {min.x(), min.y(), min.z()}},
          {"max", {max.x(), max.y(), max.z()}},
          {"origin", {cloud.origin.x(), cloud.origin.y(), cloud.origin.z()}},
          {"derived_lengths",
           {{"extent", lengths.extent},
            {"radius", lengths.radius},
            {"voxel_size", lengths.voxel_size},
            {"max_distance", lengths.max_distance}}},
          {"warnings", input.report.warnings}};
}

nlohmann::ordered_json bag_json(const std::string& bag) {
  nlohmann::ordered_json topics = nlohmann::ordered_json::array();
  for (const BagTopic& topic : bag_topics(bag))
    topics.push_back({{"name", topic.name}, {"type", topic.type}, {"num_messages", topic.num_messages}});
  return {{"file", bag}, {"format", "recording"}, {"topics", topics}};
}

std::string bag_text(const nlohmann::ordered_json& info) {
  std::string text = fmt::format("file     {}\n", info["file"].get<std::string>());
  for (const auto& topic : info["topics"])
    text += fmt::format("{:8} {} {}\n", topic["num_messages"].get<std::uint64_t>(), topic["name"].get<std::string>(),
                        topic["type"].get<std::string>());
  return text;
}

std::string info_text(const nlohmann::ordered_json& info) {
  const auto triple = [&](const char* key) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", info[key][0].get<double>(), info[key][1].get<double>(),
                       info[key][2].get<double>());
  };
  const auto& lengths = info["derived_lengths"];
  return fmt::format(
      "file     {}\nformat   {}\npoints   {} ({} declared, {} without a finite position within 1e18 m)\nnormals  {}\n"
      "columns  {}\n"
      "min      {}\nmax      {}\norigin   {}\n"
      "lengths  extent {:.4g} m; align derives --radius {:.4g} --voxel-size {:.4g} --max-distance {:.4g}\n",
      info["file"].get<std::string>(), info["format"].get<std::string>(), info["num_points"].get<std::uint64_t>(),
      info["num_declared"].get<std::uint64_t>(), info["num_invalid"].get<std::uint64_t>(),
      info["has_normals"].get<bool>() ? "yes" : "no", columns_text(info["columns"]), triple("min"), triple("max"),
      triple("origin"), lengths["extent"].get<double>(), lengths["radius"].get<double>(),
      lengths["voxel_size"].get<double>(), lengths["max_distance"].get<double>());
}

int run_info(const InfoArguments& arguments) {
  InputOptions with_columns = arguments.input;
  with_columns.read.keep_fields = true;
  require_use_of(arguments.input, {arguments.file});
  const bool is_recording = is_bag(arguments.file);
  StepLine line(arguments.progress);
  line.show("reading", "reading " + arguments.file);
  const nlohmann::ordered_json info =
      is_recording ? bag_json(arguments.file) : info_json(arguments.file, read_input(arguments.file, with_columns));
  line.hide();
  if (!arguments.json.empty()) write_json(arguments.json, info);
  if (arguments.json != "-") fmt::print("{}", is_recording ? bag_text(info) : info_text(info));
  return kSuccess;
}

}  // namespace

void add_info_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* command = app.add_subcommand("info", "Show the content of a file: points, bounds, normals, invalid points");
  command
      ->add_option("file", arguments->file, "A cloud, a depth image, a recording, or a message of one: drive.mcap#12")
      ->required();
  add_input_options(*command, arguments->input);
  command->add_option("--json", arguments->json, "Write it as JSON to a file, or to stdout with -")->group("Output");
  add_progress_option(*command, arguments->progress);
  command->footer(
      "Examples:\n"
      "  augicp info scan.ply\n"
      "  augicp info 000001.png --camera tum-fr1\n"
      "  augicp info scan.pcd --json -\n"
      "  augicp info drive.mcap\n"
      "  augicp info drive.mcap#12 --topic /points");
  command->callback([arguments, &exit_code] { exit_code = run_info(*arguments); });
}

}  // namespace augicp::app
