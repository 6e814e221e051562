// SPDX-License-Identifier: MIT
#include "python/registration/report.h"

#include <stdexcept>

#include "apps/augicp/page/align_page.h"
#include "apps/augicp/page/nearest_rows.h"
#include "augicp/io/atomic_file.h"
#include "augicp/registration/registration.h"
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

std::string page_of(const Result& result, const ResultInputs& inputs, const std::stop_token& stop) {
  RegistrationOptions options = result.options;
  options.stop = stop;
  // The result does not keep the prepared scans: they are larger than the clouds, and few results are reported. Its
  // options have their lengths.
  const PreparedPair prepared = prepare_pair(*inputs.source, *inputs.target, options);
  app::AlignReport report;
  report.source = inputs.source_name;
  report.target = inputs.target_name;
  report.result = result.found;
  report.lengths = prepared.lengths;
  report.options = report.in_effect = result.options;
  app::refer_to(prepared.target.cloud, report);
  const auto colours = [](const Scan& scan, const ColouredScan& given) {
    return app::nearest_colours(scan.cloud, given.cloud, given.colours);
  };
  return app::align_page({report,
                          inputs.initial,
                          prepared,
                          {colours(prepared.source, *inputs.source), colours(prepared.target, *inputs.target)}});
}

}  // namespace

std::string name_in_report(const py::object& given, const ColouredScan& scan) {
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__")) return py::str(given).cast<std::string>();
  return std::to_string(scan.cloud.size()) + " points";
}

void write_report(const Result& result, const std::filesystem::path& path) {
  const std::shared_ptr<const ResultInputs> inputs = result.inputs;
  if (!inputs) throw std::invalid_argument("report: a result that was copied or pickled has no clouds to draw");
  without_gil([&](const std::stop_token& stop) { write_file(path, page_of(result, *inputs, stop)); });
}

}  // namespace augicp::python
