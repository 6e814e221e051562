// SPDX-License-Identifier: MIT
#include "apps/augicp/command/surface.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/table_options.h"
#include "augicp/core/error.h"
#include "augicp/io/write_cloud.h"
#include "augicp/registration/option_table.h"
#include "augicp/registration/registration.h"

namespace augicp::app {
namespace {

struct SurfaceArguments {
  std::string input_file, output;
  InputOptions input;
  RegistrationOptions registration;
  bool quiet = false;
};

// Distinguishable for people with any colour vision (Okabe and Ito): planar blue, edge orange, none grey.
Colour colour_of(Structure structure) {
  switch (structure) {
    case Structure::Planar:
      return {86, 180, 233};
    case Structure::Edge:
      return {230, 159, 0};
    case Structure::None:
      break;
  }
  return {90, 90, 90};
}

double percent(const Cloud& cloud, Structure structure) {
  const auto count = std::count(cloud.structures.begin(), cloud.structures.end(), structure);
  return cloud.empty() ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(cloud.size());
}

int run_surface(const SurfaceArguments& arguments) {
  arguments.registration.check();
  require_extension(arguments.output, {".ply"});
  Scan scan = read_input(arguments.input_file, arguments.input).scan;
  scan.cloud.directions.clear();  // the file's own directions are not used
  scan.cloud.structures.clear();
  const Lengths lengths = lengths_for(scan, scan, arguments.registration);
  if (!(lengths.radius > 0.0)) throw IoError(arguments.input_file + ": all points are equal, so there is no surface");
  const Cloud cloud = prepare(std::move(scan), lengths, arguments.registration).cloud;
  std::vector<Colour> colours(cloud.size(), colour_of(Structure::None));
  std::transform(cloud.structures.begin(), cloud.structures.end(), colours.begin(), colour_of);
  write_whole([&] { write_ply(arguments.output, cloud, colours); });
  if (!arguments.quiet)
    fmt::print("points   {}, ball radius {:.4g} m\nplanar   {:.1f} %\nedge     {:.1f} %\nnone     {:.1f} %\n",
               cloud.size(), lengths.radius, percent(cloud, Structure::Planar), percent(cloud, Structure::Edge),
               percent(cloud, Structure::None));
  return kSuccess;
}

}  // namespace

void add_surface_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<SurfaceArguments>();
  CLI::App* command =
      app.add_subcommand("surface", "Write the extended points: normals, tangents, structure as colour");
  command->add_option("input", arguments->input_file, "A cloud or a depth image")->required();
  command->add_option("--output", arguments->output, "The .ply to write")->required()->group("Output");
  command->add_flag("--quiet", arguments->quiet, "Print errors only")->group("Output");
  add_input_options(*command, arguments->input);
  add_options(*command, arguments->registration, {"preset", "radius", "voxel_size", "threads"});
  command->footer(
      "Colours: planar blue, edge orange, none grey. Normals point to the sensor if its position is known.\n"
      "Examples:\n"
      "  augicp surface 000001.png --camera tum-fr1 --output extended.ply\n"
      "  augicp surface scan.ply --radius 0.05 --output extended.ply\n"
      "  augicp surface scan.ply --preset paper --output paper.ply");
  command->callback([arguments, &exit_code] { exit_code = run_surface(*arguments); });
}

}  // namespace augicp::app
