// SPDX-License-Identifier: MIT
#include "apps/augicp/command/align.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <system_error>

#include "apps/augicp/command/exit_code.h"
#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/interruption.h"
#include "apps/augicp/command/output.h"
#include "apps/augicp/command/progress.h"
#include "apps/augicp/command/recording.h"
#include "apps/augicp/command/table_options.h"
#include "apps/augicp/page/align_page.h"
#include "apps/augicp/page/nearest_rows.h"
#include "apps/augicp/text/align.h"
#include "apps/augicp/text/decisions.h"
#include "augicp/core/error.h"
#include "augicp/io/transform_file.h"
#include "augicp/registration/option_table.h"
#include "augicp/registration/options_in_effect.h"

namespace augicp::app {
namespace {

struct AlignArguments {
  std::string source, target, source_image, target_image, initial, transform, output, json, page, mcap;
  InputOptions input;
  RegistrationOptions registration;
  Progress progress = Progress::Auto;
  bool trace = false, quiet = false, verbose = false;
};

Rigid3 initial_pose(const std::string& argument) {
  if (argument.empty()) return {};
  std::error_code not_a_path;  // numbers may be longer than a file name can be
  if (std::filesystem::exists(argument, not_a_path)) return read_transform(argument);
  if (argument.find_first_not_of("0123456789+-.,;eE[]() \t\n") != std::string::npos)
    throw IoError(fmt::format("--initial {}: no such file, and no pose \"tx ty tz qx qy qz qw\"", argument));
  return parse_transform(argument);
}

struct AlignRun {
  AlignReport report;
  Rigid3 initial;
  CloudFile source_as_read, target_as_read;  // empty unless an output needs them
  PreparedPair prepared;
};

struct ReadFile {
  Scan scan;
  CloudFile as_read;
};

// keep: whether the file is needed beside its scan.
ReadFile read_file(const std::string& path, InputOptions options, const std::string& image, bool keep) {
  options.read.keep_fields = keep;
  Input read = read_input(path, options, image);
  if (!keep) return {std::move(read.scan), {}};
  CloudFile as_read{read.scan.cloud, std::move(read.grid), std::move(read.report), std::move(read.las),
                    std::move(read.fields)};
  return {std::move(read.scan), std::move(as_read)};
}

PairColours seen_colours(const AlignRun& run) {
  const auto of = [](const Scan& scan, const CloudFile& file) {
    return nearest_colours(scan.cloud, file.cloud, colours_of(file));
  };
  return {of(run.prepared.source, run.source_as_read), of(run.prepared.target, run.target_as_read)};
}

// Whether hardly any point has a direction. Of few points that is said elsewhere.
bool lacks_surfaces(const Cloud& cloud) {
  constexpr std::size_t kFewPoints = 100;
  constexpr std::size_t kPointsPerDirection = 100;
  const auto& structures = cloud.structures;
  const auto num_none = std::count(structures.begin(), structures.end(), Structure::None);
  return cloud.size() > kFewPoints &&
         cloud.size() - static_cast<std::size_t>(num_none) < cloud.size() / kPointsPerDirection;
}

// Methods that compare surfaces then have nothing to compare, and the search for a start takes minutes.
void warn_of_radius(const PreparedPair& pair, const RegistrationOptions& options) {
  const bool needs_surfaces = options.method != Method::Point && options.method != Method::Ndt;
  if (!needs_surfaces || !options.radius) return;
  if (lacks_surfaces(pair.source.cloud) || lacks_surfaces(pair.target.cloud))
    fmt::print(stderr,
               "augicp: warning: hardly any point has a normal: balls of {:.4g} m hold too few points; use a larger "
               "--radius, or leave it out\n",
               pair.lengths.radius);
}

AlignRun register_files(const AlignArguments& arguments, StepLine& line) {
  AlignRun run;
  AlignReport& report = run.report;
  report.source = arguments.source;
  report.target = arguments.target;
  run.initial = initial_pose(arguments.initial);
  const Stopwatch started;
  const auto begin = [&](std::string_view word, std::string text, Turn turn = {}) {
    line.show(word, text, turn);
    report.steps.emplace_back(std::move(text), started.elapsed_ms());
  };
  report.options = arguments.registration;
  RegistrationOptions options = arguments.registration;
  options.on_stage = [&](const StageReport& stage) {
    const Turn turn{stage.done, stage.total};
    if (turn.done < turn.total) begin(name_of(stage.stage), stage_text(stage.stage, turn), turn);
  };
  begin("reading", "reading " + arguments.source + " and " + arguments.target);
  report.with_history = arguments.trace;
  const Stopwatch reading;
  const bool has_page = !arguments.page.empty(), has_mcap = !arguments.mcap.empty();
  auto [source, source_as_read] = read_file(arguments.source, arguments.input, arguments.source_image,
                                            has_page || has_mcap || !arguments.output.empty());
  auto [target, target_as_read] =
      read_file(arguments.target, arguments.input, arguments.target_image, has_page || has_mcap);
  run.source_as_read = std::move(source_as_read);
  run.target_as_read = std::move(target_as_read);
  report.timing_ms.read = reading.elapsed_ms();
  warn_of_units(source.cloud, target.cloud);
  const Stopwatch preparing;
  report.num_read = {source.cloud.size(), target.cloud.size()};
  PreparedPair prepared = prepare_pair(std::move(source), std::move(target), options);
  report.timing_ms.surface = preparing.elapsed_ms();
  const double first_radius = prepared.lengths.radius;
  warn_of_radius(prepared, options);
  const Stopwatch aligning;
  Registration registration = register_pair(std::move(prepared), run.initial, options);
  report.timing_ms.align = aligning.elapsed_ms();
  report.result = std::move(registration.result);
  report.lengths = registration.prepared.lengths;
  if (first_radius > 0.0) report.share_of_radius = report.lengths.radius / first_radius;
  run.prepared = std::move(registration.prepared);
  report.in_effect =
      options_in_effect(report.options, report.lengths, !run.prepared.source.view && !run.prepared.target.view);
  refer_to(run.prepared.target.cloud, report);
  report.num_prepared = {run.prepared.source.cloud.size(), run.prepared.target.cloud.size()};
  return run;
}

ExitCode exit_code_for(AlignStatus status) {
  switch (status) {
    case AlignStatus::Converged:
      return kSuccess;
    case AlignStatus::IterationLimit:
    case AlignStatus::Degenerate:
    case AlignStatus::Doubtful:
    case AlignStatus::Ambiguous:
      return kDoubtful;
    default:
      return kRegistrationFailed;
  }
}

// All that was asked for but the text. Large clouds take seconds.
void write_files(const AlignArguments& arguments, AlignRun& run, StepLine& line) {
  const AlignReport& report = run.report;
  const Rigid3& pose = report.result.target_from_source;
  if (!arguments.json.empty()) write_json(arguments.json, to_json(report));
  if (!arguments.transform.empty()) write_whole([&] { write_transform(arguments.transform, pose); });
  if (!arguments.page.empty()) {
    line.show("report", "writing " + arguments.page);
    write_text_file(arguments.page, align_page({report, run.initial, run.prepared, seen_colours(run)}));
  }
  if (arguments.output.empty() && arguments.mcap.empty()) return;
  run.source_as_read.cloud = transform(run.source_as_read.cloud, pose);
  if (!arguments.output.empty()) {
    line.show("output", "writing " + arguments.output);
    write_cloud_output(arguments.output, run.source_as_read, arguments.quiet);
  }
  if (!arguments.mcap.empty()) {
    line.show("mcap", "writing " + arguments.mcap);
    write_align_mcap(arguments.mcap, report, run.source_as_read, run.target_as_read);
  }
}

int run_align(const AlignArguments& arguments) {
  arguments.registration.check();
  require_extension(arguments.output, {".ply", ".pcd", ".las"});
  require_extension(arguments.mcap, {".mcap"}, "--mcap");
  require_no_input_among({arguments.json, arguments.transform, arguments.page, arguments.mcap},
                         {arguments.source, arguments.target, arguments.initial});
  require_no_input_among({arguments.output}, {arguments.target});  // the source may be moved in place
  require_use_of(arguments.input, {arguments.source, arguments.target});
  require_page_name(arguments.page);
  require_places({arguments.json, arguments.transform, arguments.output, arguments.page, arguments.mcap});
  StepLine line(arguments.quiet ? Progress::None : arguments.progress);
  AlignRun run = register_files(arguments, line);
  line.hide();
  const AlignReport& report = run.report;
  if (arguments.verbose) fmt::print(stderr, "{}", decisions_text(report));
  if (!arguments.quiet && arguments.json != "-") fmt::print("{}", to_text(report));
  write_files(arguments, run, line);
  line.hide();
  const std::string written =
      written_text({arguments.json, arguments.transform, arguments.output, arguments.mcap}, arguments.page);
  if (!arguments.quiet && arguments.json != "-" && !written.empty()) fmt::print("written  {}\n", written);
  return exit_code_for(report.result.status);
}

void add_method_options(CLI::App& command, AlignArguments& arguments) {
  command
      .add_option("--initial", arguments.initial,
                  "Guess of T_target_source: a file, or \"tx ty tz qx qy qz qw\" (default: identity)")
      ->group(std::string(option_group::kMethod));
  add_all_options(command, arguments.registration);
}

void add_output_options(CLI::App& command, AlignArguments& arguments) {
  const std::string group = "Output";
  command.add_option("--transform", arguments.transform, "Write T_target_source as 4x4 text")->group(group);
  command.add_option("--output", arguments.output, "Write the source in the target frame (.ply, .pcd or .las)")
      ->group(group);
  command.add_option("--json", arguments.json, "Write all results as JSON to a file, or to stdout with -")
      ->group(group);
  command
      .add_option("--report", arguments.page, "Write a report: one HTML file with both clouds in 3D, readable offline")
      ->group(group);
  add_mcap_option(command, arguments.mcap);
  command.add_flag("--trace", arguments.trace, "Include every iteration in the JSON")->group(group);
  add_progress_option(command, arguments.progress);
  command.add_flag("--verbose", arguments.verbose, "Explain on stderr what was derived, tried and decided")
      ->group(group);
  command.add_flag("--quiet", arguments.quiet, "Print errors only")->group(group);
}

}  // namespace

void add_align_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<AlignArguments>();
  CLI::App* command = app.add_subcommand("align", "Find the motion between two clouds or depth images");
  command
      ->add_option("source,--source", arguments->source,
                   "The moving cloud: .ply .pcd .las .xyz .txt .csv .pts .npy .bin .stl .obj .glb, a depth image, or "
                   "drive.mcap#12")
      ->required();
  command->add_option("target,--target", arguments->target, "The fixed cloud")->required();
  add_input_options(*command, arguments->input);
  command
      ->add_option("--source-image", arguments->source_image,
                   "Colour or grey .png registered to the source's depth image, for --intensity")
      ->group("Input");
  command->add_option("--target-image", arguments->target_image, "The same for the target")->group("Input");
  add_method_options(*command, *arguments);
  add_output_options(*command, *arguments);
  command->footer(
      "The result T_target_source maps source coordinates into the target frame.\n"
      "Examples:\n"
      "  augicp align scan_b.ply scan_a.ply --transform T.txt --report alignment.html\n"
      "  augicp align 000002.png 000001.png --camera tum-fr1 --json -\n"
      "  augicp align 2.png 1.png --camera tum-fr1 --intensity --source-image rgb/2.png --target-image rgb/1.png\n"
      "  augicp align drive.mcap#10 drive.mcap#0 --topic /points\n"
      "  augicp align b.pcd a.pcd --initial \"0.1 0 0 0 0 0 1\" --max-distance 0.5 --method gicp");
  command->callback([arguments, &exit_code] { exit_code = run_align(*arguments); });
}

}  // namespace augicp::app
