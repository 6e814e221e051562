// SPDX-License-Identifier: MIT
#include "apps/augicp/command/surface.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/nearest_rows.h"
#include "augicp/core/error.h"
#include "augicp/io/field_layout.h"
#include "augicp/io/write_cloud.h"
#include "augicp/registration/option_table.h"
#include "augicp/registration/registration.h"

namespace augicp::app {
namespace {

struct SurfaceArguments {
  std::string input_file, output;
  InputOptions input;
  RegistrationOptions registration;
  Progress progress = Progress::Auto;
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

// The fields of the input, and the structure as colour unless they have a colour.
PointFields output_fields(const Cloud& output, const Cloud& input, PointFields fields) {
  if (!fields.fields.empty()) fields = select(fields, nearest_rows(output, input));
  if (fields.find("red") || fields.find("rgb") || fields.find("rgba")) return fields;
  std::vector<Colour> colours(output.size(), colour_of(Structure::None));
  std::transform(output.structures.begin(), output.structures.end(), colours.begin(), colour_of);
  for (PointField& channel : colour_fields(colours)) fields.fields.push_back(std::move(channel));
  return fields;
}

// The fields of points alone: one a cell of a grid is of no use where points become fewer.
PointFields fields_of_points(Input& input) {
  if (input.las) return fields_of(*input.las);
  if (!input.grid) return std::move(input.fields);
  PointFields fields = without_empty_cells(input.fields, *input.grid);
  fields.not_kept.push_back("the grid: the output has a point a voxel");
  return fields;
}

int run_surface(const SurfaceArguments& arguments) {
  arguments.registration.check();
  require_extension(arguments.output, {".ply"});
  require_places({arguments.output});
  require_use_of(arguments.input, {arguments.input_file});
  std::optional<StepLine> line(std::in_place, arguments.quiet ? Progress::None : arguments.progress);
  line->show("reading", "reading " + arguments.input_file);
  InputOptions with_fields = arguments.input;
  with_fields.read.keep_fields = true;
  Input input = read_input(arguments.input_file, with_fields);
  PointFields fields = fields_of_points(input);
  Scan scan = std::move(input.scan);
  scan.cloud.directions.clear();  // the file's own directions are not used
  scan.cloud.structures.clear();
  const Lengths lengths = lengths_for(scan, scan, arguments.registration);
  if (!(lengths.radius > 0.0)) throw IoError(arguments.input_file + ": all points are equal, so there is no surface");
  const Cloud as_read = scan.cloud;
  line->show("surfaces", "estimating the surface");
  const Cloud cloud = prepare(std::move(scan), lengths, arguments.registration).cloud;
  line->show("output", "writing " + arguments.output);
  const auto output = output_fields(cloud, as_read, std::move(fields));
  line.reset();
  write_cloud_output(arguments.output, {cloud, std::nullopt, {}, std::nullopt, output}, arguments.quiet);
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
  command
      ->add_option("input", arguments->input_file, "A cloud, a depth image, or a message of a recording: drive.mcap#12")
      ->required();
  command->add_option("--output", arguments->output, "The .ply to write")->required()->group("Output");
  add_progress_option(*command, arguments->progress);
  command->add_flag("--quiet", arguments->quiet, "Print errors only")->group("Output");
  add_input_options(*command, arguments->input);
  add_options(*command, arguments->registration, {"preset", "radius", "voxel_size", "max_memory_gb", "threads"});
  command->footer(
      "Normals are in nx ny nz and point to the sensor if its position is known; tangents of edges are in tangent_x\n"
      "tangent_y tangent_z. Columns of the input are kept. Colours, unless the input has some: planar blue, edge "
      "orange,\n"
      "none grey.\n"
      "Examples:\n"
      "  augicp surface 000001.png --camera tum-fr1 --output extended.ply\n"
      "  augicp surface scan.ply --radius 0.05 --output extended.ply\n"
      "  augicp surface scan.ply --preset paper --output paper.ply");
  command->callback([arguments, &exit_code] { exit_code = run_surface(*arguments); });
}

}  // namespace augicp::app
