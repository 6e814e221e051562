// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_basin.h"

#include <fmt/core.h>

#include <memory>
#include <stdexcept>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/experiment_charts.h"
#include "apps/augicp/page/experiment_page.h"
#include "apps/augicp/text/experiment.h"
#include "augicp/core/angles.h"
#include "augicp/core/error.h"
#include "augicp/io/transform_file.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

struct BasinArguments {
  std::string source, target, truth;
  InputOptions input;
  std::vector<double> angles_deg{5.0, 10.0, 20.0, 30.0, 45.0, 60.0};
  BasinOptions options;
  std::optional<double> limit, limit_deg;
  ExperimentOutput output;
};

Rigid3 truth_of(const Scan& source, const Scan& target, const BasinArguments& arguments) {
  if (!arguments.truth.empty()) return read_transform(arguments.truth);
  const AlignResult result = register_scans(source, target, {}, arguments.options.registration).result;
  if (result.status != AlignStatus::Converged)
    throw IoError(fmt::format("{}: from the identity the registration is {}; give --truth", arguments.source,
                              name_of(result.status)));
  return result.target_from_source;
}

int run(BasinArguments arguments) {
  BasinOptions& options = arguments.options;
  options.angles_rad = arguments.angles_deg;
  for (double& angle : options.angles_rad) angle *= kRadPerDeg;
  options.check();
  const Scan source = read_input(arguments.source, arguments.input).scan;
  const Scan target = read_input(arguments.target, arguments.input).scan;
  options.limit = basin_limit(source, target, options);
  if (arguments.limit) options.limit->translation = *arguments.limit;
  if (arguments.limit_deg) options.limit->rotation = *arguments.limit_deg * kRadPerDeg;
  const Rigid3 truth = truth_of(source, target, arguments);
  ProgressBar bar(options.angles_rad.size() * options.distances.size() * options.num_starts, "starts",
                  arguments.output.progress);
  const auto cells = run_basin(source, target, truth, options, [&] { bar.advance(); });
  write_text(arguments.output.csv, basin_csv(cells));
  fmt::print(stderr, "{}", basin_text(cells, options));
  if (!arguments.output.page.empty())
    write_text_file(arguments.output.page, experiment_page({"Basin of convergence: success from disturbed starts",
                                                            "Source: " + arguments.source,
                                                            "Target: " + arguments.target, basin_text(cells, options)},
                                                           basin_quantities(cells)));
  return kSuccess;
}

void add_basin_options(CLI::App& command, BasinArguments& arguments) {
  const std::string starts = "Starts";
  BasinOptions& options = arguments.options;
  command
      .add_option("--truth", arguments.truth,
                  "T_target_source, a file (default: the result of the registration from the identity)")
      ->group(starts);
  command.add_option("--angles-deg", arguments.angles_deg, "Rotations about the centroid of the source")
      ->delimiter(',')
      ->capture_default_str()
      ->group(starts);
  command.add_option("--distances", options.distances, "Metres")->delimiter(',')->capture_default_str()->group(starts);
  command.add_option("--starts", options.num_starts, "Per angle and distance")->capture_default_str()->group(starts);
  command.add_option("--seed", options.seed)->capture_default_str()->group(starts);
  command.add_option("--limit", arguments.limit, "Largest error of a success, metres (default: the ball radius)")
      ->group(starts);
  command.add_option("--limit-deg", arguments.limit_deg, "Largest angle of a success (default 2)")->group(starts);
  add_options(command, options.registration,
              {"preset", "method", "max_distance", "max_iterations", "threads", "search", "coarse_to_fine",
               "rolling_shutter", "intensity"});
}

}  // namespace

void add_basin_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<BasinArguments>();
  arguments->options.distances = {0.0, 0.5, 1.0, 2.0};
  CLI::App* command = experiment.add_subcommand("basin", "Basin of convergence: success from disturbed starts");
  command->add_option("source,--source", arguments->source, "The moving cloud or depth image")->required();
  command->add_option("target,--target", arguments->target, "The fixed one")->required();
  add_input_options(*command, arguments->input);
  add_basin_options(*command, *arguments);
  add_experiment_output(*command, arguments->output);
  command->footer(
      "CSV: share of successful starts, and mean iterations, per angle and distance. The mean of the "
      "share\n"
      "over the surface, linear between the cells, is printed to stderr.\n"
      "Examples:\n"
      "  augicp experiment basin scan_b.ply scan_a.ply --truth T.txt --output basin.csv\n"
      "  augicp experiment basin 000002.png 000001.png --camera tum-fr1 --distances 0,0.1,0.2 --report basin.html\n"
      "  augicp experiment basin b.ply a.ply --angles-deg 10,20 --starts 50 --seed 7");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
