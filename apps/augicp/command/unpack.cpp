// SPDX-License-Identifier: MIT
#include "apps/augicp/command/unpack.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/progress.h"
#include "augicp/core/error.h"
#include "augicp/io/atomic_file.h"
#include "augicp/io/bag_message_name.h"
#include "augicp/io/bag_topics.h"
#include "augicp/io/point_cloud2.h"
#include "augicp/io/write_cloud.h"

namespace augicp::app {
namespace {

namespace fs = std::filesystem;

struct UnpackArguments {
  std::string bag, topic, output;
  Progress progress = Progress::Auto;
  bool quiet = false;
};

fs::path made_folder(const UnpackArguments& arguments) {
  const fs::path bag = fs::path(arguments.bag).lexically_normal();
  const fs::path name = bag.has_filename() ? bag.filename() : bag.parent_path().filename();
  const fs::path folder =
      arguments.output.empty() ? fs::path(name.stem().string() + "_scans") : fs::path(arguments.output);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder.string() + ": cannot be made: " + error.message());
  if (!fs::is_empty(folder, error) || error) throw IoError(folder.string() + ": expected an empty folder");
  return folder;
}

int run_unpack(const UnpackArguments& arguments) {
  const std::string clouds[] = {kPointCloud2};
  const StampedTopic chosen = chosen_topic(arguments.bag, arguments.topic, clouds);
  const std::string& topic = chosen.name;
  const fs::path folder = made_folder(arguments);
  ReadOptions options;
  options.keep_fields = true;
  std::string times;
  std::size_t num_messages = 0, num_written = 0;
  std::optional<ProgressBar> bar(std::in_place, chosen.stamps_s.size(), "clouds",
                                 arguments.quiet ? Progress::None : arguments.progress);
  visit_messages(arguments.bag, [&](const BagMessage& message) {
    if (message.topic != topic) return true;
    bar->advance();
    const fs::path source = BagMessageName{arguments.bag, topic, num_messages++}.text();
    try {
      const PointCloud2 read = parse_point_cloud2(source, message.data, message.form, options);
      const fs::path path = folder / fmt::format("{:06}.pcd", num_written);
      write_whole([&] { write_cloud(path, read.file); });
      times += fmt::format("{:.9f}\n", stamp_s(message));
      ++num_written;
    } catch (const IoError& error) {
      fmt::print(stderr, "augicp: warning: {}\n", error.what());  // an empty scan, for instance
    }
    return true;
  });
  bar.reset();
  if (num_written == 0) throw IoError(fmt::format("{}: no message of {} has points", arguments.bag, topic));
  write_whole([&] { write_file(folder / "times.txt", times); });
  if (!arguments.quiet)
    fmt::print("{} of {} clouds of {} are in {}\nnow: augicp odometry {}\n", num_written, num_messages, topic,
               folder.string(), folder.string());
  return kSuccess;
}

}  // namespace

void add_unpack_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<UnpackArguments>();
  CLI::App* command = app.add_subcommand("unpack", "Write the clouds of a robot's recording as a folder of scans");
  command->add_option("bag", arguments->bag, "A bag: .bag (ROS 1), .db3 or .mcap (ROS 2), or a folder of rosbag2")
      ->required();
  command->add_option("--topic", arguments->topic, "Which PointCloud2 (default: the only one; augicp info lists them)")
      ->group("Input");
  command->add_option("--output", arguments->output, "New or empty folder for scans and times.txt (default: BAG_scans)")
      ->group("Output");
  add_progress_option(*command, arguments->progress);
  command->add_flag("--quiet", arguments->quiet, "Print errors only")->group("Output");
  command->footer(
      "Every scan becomes a .pcd with all its fields; times.txt has their stamps in seconds.\n"
      "Examples:\n"
      "  augicp info drive.mcap\n"
      "  augicp unpack drive.mcap --topic /lidar/points --output scans\n"
      "  augicp odometry scans");
  command->callback([arguments, &exit_code] { exit_code = run_unpack(*arguments); });
}

}  // namespace augicp::app
