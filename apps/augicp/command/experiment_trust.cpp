// SPDX-License-Identifier: MIT
#include "apps/augicp/command/experiment_trust.h"

#include <memory>
#include <stdexcept>

#include "apps/augicp/command/choice.h"
#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/experiment_output.h"
#include "apps/augicp/command/named_families.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/trust_page.h"
#include "apps/augicp/text/trust.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

using synthetic::TrustFamily;
using synthetic::TrustHalf;

struct TrustArguments {
  std::vector<std::string> families;
  TrustHalf half = TrustHalf::Report;
  unsigned first_seed = 1;
  std::size_t num_pairs = 100;
  std::string table, roc;
  RegistrationOptions registration;
  ExperimentOutput output;
};

int run(const TrustArguments& arguments) {
  const std::vector<TrustFamily> families = named_families(synthetic::trust_families(), arguments.families);
  const auto seeds = synthetic::trust_seeds(arguments.half, arguments.first_seed, arguments.num_pairs);
  ProgressBar bar(families.size() * seeds.size(), "pairs", arguments.output.progress);
  std::vector<TrustResults> results;
  for (const TrustFamily& family : families)
    results.push_back(
        {family.name, synthetic::run_trust(family, seeds, arguments.registration, [&] { bar.advance(); })});
  if (!arguments.output.csv.empty()) write_text(arguments.output.csv, trust_csv(results));
  write_text(arguments.table.empty() ? "-" : arguments.table, trust_text(results));
  if (!arguments.roc.empty()) write_text(arguments.roc, trust_roc_csv(results));
  if (!arguments.output.page.empty()) write_text_file(arguments.output.page, trust_page(results));
  return kSuccess;
}

void add_trust_options(CLI::App& command, TrustArguments& arguments) {
  command.add_option("families,--families", arguments.families, "Names of families (default: all)")->group("Pairs");
  command.add_option("--pairs", arguments.num_pairs, "Pairs of each family")->capture_default_str()->group("Pairs");
  command
      .add_option("--half", arguments.half, "The half of the seeds: odd ones, on which limits are chosen, or even ones")
      ->transform(choice<TrustHalf>())
      ->default_str(std::string(name_of(arguments.half)))
      ->group("Pairs");
  command.add_option("--first-seed", arguments.first_seed)->capture_default_str()->group("Pairs");
  add_options(command, arguments.registration, {"preset", "method", "threads", "search", "coarse_to_fine"});
  add_experiment_output(command, arguments.output);
  command.add_option("--table", arguments.table, "Write the table to a file (default: stdout)")->group("Output");
  command.add_option("--roc", arguments.roc, "Write the results that other limits would accept and refuse, CSV")
      ->group("Output");
}

}  // namespace

void add_trust_experiment(CLI::App& experiment, int& exit_code) {
  const auto arguments = std::make_shared<TrustArguments>();
  arguments->output.csv.clear();
  CLI::App* command = experiment.add_subcommand(
      "trust", "How often each status is right: LiDAR, cameras, objects, and shapes that leave motions free");
  add_trust_options(*command, *arguments);
  command->footer(
      "The pairs are generated, each from its seed. A family's limit of a right pose is in docs/lab/trust.md.\n"
      "Examples:\n"
      "  augicp experiment trust --pairs 20 --report trust.html\n"
      "  augicp experiment trust \"lidar corridor\" \"lidar tunnel\" --pairs 50 --output pairs.csv\n"
      "  augicp experiment trust \"objects unlike\" --half choose --roc roc.csv");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace augicp::app
