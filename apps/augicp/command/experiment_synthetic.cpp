// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_synthetic.h"

#include <algorithm>
#include <memory>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/page/experiment_charts.h"
#include "apps/augicp/page/experiment_page.h"
#include "apps/augicp/text/experiment.h"
#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

struct SyntheticArguments {
  SyntheticOptions options;
  std::vector<double> outliers_percent{0.0, 50.0, 90.0}, normal_noises_deg{0.0, 5.0, 20.0};
  ExperimentOutput output;
};

int run(SyntheticArguments arguments) {
  SyntheticOptions& options = arguments.options;
  options.outlier_shares = arguments.outliers_percent;
  for (double& share : options.outlier_shares) share /= 100.0;
  options.normal_noises_rad = arguments.normal_noises_deg;
  for (double& angle : options.normal_noises_rad) angle *= kRadPerDeg;
  options.check();
  ProgressBar bar(num_runs(options), "scenes", arguments.output.progress);
  const std::vector<SyntheticRow> rows = run_synthetic(options, [&] { bar.advance(); });
  write_text(arguments.output.csv, synthetic_csv(rows));
  if (!arguments.output.page.empty())
    write_text_file(
        arguments.output.page,
        experiment_page({"Known pairs, a share of them false: mean error over the seeds, with its 95 % interval"},
                        synthetic_quantities(rows)));
  return kSuccess;
}

void add_synthetic_options(CLI::App& command, SyntheticArguments& arguments) {
  SyntheticOptions& options = arguments.options;
  const std::string scene = "Scene", method = "Method";
  command.add_option("--points", options.num_points)->capture_default_str()->group(scene);
  command.add_option("--outliers-percent", arguments.outliers_percent, "Share of false pairs")
      ->delimiter(',')
      ->capture_default_str()
      ->group(scene);
  command.add_option("--point-noise", options.point_noises, "Standard deviation of each coordinate, metres")
      ->delimiter(',')
      ->capture_default_str()
      ->group(scene);
  command.add_option("--normal-noise-deg", arguments.normal_noises_deg, "Standard deviation of directions")
      ->delimiter(',')
      ->capture_default_str()
      ->group(scene);
  command.add_option("--seeds", options.num_seeds, "Number of scenes and motions")->capture_default_str()->group(scene);
  command.add_option("--seed", options.first_seed, "The first seed")->capture_default_str()->group(scene);
  command.add_option("--methods", options.methods, "Any of augmented,gicp,plane,point,ndt (default all but ndt)")
      ->delimiter(',')
      ->transform(choice<Method>())
      ->group(method);
  command.add_option("--preset", options.preset, "paper or default (default paper)")
      ->transform(choice<Preset>())
      ->group(method);
  command
      .add_option("--kernel", options.kernel_chi2,
                  "K of Eq. (13), in units of chi2 (default: the preset's; the paper's is 1)")
      ->group(method);
  command.add_option("--iterations", options.iterations)->capture_default_str()->group(method);
  command.add_option("--threads", options.num_threads, "0: all; the result is bit-identical for any number")
      ->capture_default_str()
      ->group(method);
}

}  // namespace

void add_synthetic_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<SyntheticArguments>();
  CLI::App* command =
      experiment.add_subcommand("synthetic", "Known pairs, a share of them false (the paper's Table 4)");
  add_synthetic_options(*command, *arguments);
  add_experiment_output(*command, arguments->output);
  command->footer(
      "A room of 10 x 8 x 3 m, 30 degrees and 1 m away. CSV: mean error of each iteration over\n"
      "the seeds, and half the width of its 95 % interval.\n"
      "Examples:\n"
      "  augicp experiment synthetic --output table4.csv --report table4.html\n"
      "  augicp experiment synthetic --points 20000 --outliers-percent 90 --normal-noise-deg 20 --kernel 1000\n"
      "  augicp experiment synthetic --methods gicp,augmented --seeds 20 --seed 100");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
