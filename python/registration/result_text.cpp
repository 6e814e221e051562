// SPDX-License-Identifier: MIT
#include "python/registration/result_text.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdio>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/registration/option_table.h"
#include "python/core/options.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

template <typename... Numbers>
std::string formatted(const char* format, Numbers... numbers) {
  char text[160];
  const int length = std::snprintf(text, sizeof text, format, numbers...);
  return {text, static_cast<std::size_t>(length)};
}

std::string doubts_text(const AlignResult& found) {
  std::string text;
  for (const Doubt doubt : found.doubts) text += (text.empty() ? ", doubts: " : ", ") + std::string(name_of(doubt));
  return text;
}

std::string fit_text(const AlignResult& found) {
  std::string text =
      formatted("overlap %.1f %%, %lld pairs", 100.0 * found.overlap, static_cast<long long>(found.num_pairs));
  if (!found.evidence || found.evidence->residuals.point.count == 0) return text;
  return text + formatted(", %.3g mm off the target's surface", 1000.0 * found.evidence->residuals.point.median);
}

std::string matrix_text(const Mat4d& matrix) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    text += formatted("%14.9f %14.9f %14.9f %14.9f\n", matrix(i, 0), matrix(i, 1), matrix(i, 2), matrix(i, 3));
  return text;
}

template <typename Matrix>
std::vector<std::vector<double>> rows_of(const Matrix& matrix) {
  std::vector<std::vector<double>> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    rows.emplace_back();
    for (Eigen::Index k = 0; k < matrix.cols(); ++k) rows.back().push_back(matrix(i, k));
  }
  return rows;
}

std::vector<double> list_of(const Vec3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

py::list words_of_doubts(const AlignResult& found) {
  py::list words;
  for (const Doubt doubt : found.doubts) words.append(std::string(name_of(doubt)));
  return words;
}

py::list dicts_of_motions(const AlignResult& found) {
  using py::literals::operator""_a;
  py::list motions;
  for (const FreeMotion& motion : found.free_motions)
    motions.append(py::dict("kind"_a = std::string(name_of(motion.kind)), "axis"_a = list_of(motion.axis),
                            "point"_a = list_of(motion.point), "pitch"_a = motion.pitch));
  return motions;
}

}  // namespace

std::string text_of(const Result& result) {
  const AlignResult& found = result.found;
  return "augicp.Result: " + std::string(name_of(found.status)) + " after " + std::to_string(found.iterations) +
         " iterations" + doubts_text(found) + "\n" + fit_text(found) +
         "\nT_target_source (maps source coordinates into the target frame)\n" +
         matrix_text(found.target_from_source.matrix());
}

// Words and numbers only: nothing to escape.
std::string html_of(const Result& result) {
  const AlignResult& found = result.found;
  return "<div><b>augicp.Result: " + std::string(name_of(found.status)) + "</b> after " +
         std::to_string(found.iterations) + " iterations" + doubts_text(found) + "<br>" + fit_text(found) +
         "<br><code>T_target_source</code><pre>" + matrix_text(found.target_from_source.matrix()) + "</pre></div>";
}

py::dict dict_of(const Result& result) {
  using py::literals::operator""_a;
  const AlignResult& found = result.found;
  py::dict dict("status"_a = std::string(name_of(found.status)),
                "T_target_source"_a = rows_of(found.target_from_source.matrix()), "iterations"_a = found.iterations,
                "num_pairs"_a = found.num_pairs, "overlap"_a = found.overlap, "rmse"_a = found.rmse,
                "information"_a = rows_of(found.information), "reference_point"_a = list_of(result.reference_point));
  dict["covariance"] = found.covariance ? py::cast(rows_of(*found.covariance)) : py::none();
  dict["doubts"] = words_of_doubts(found);
  dict["free_motions"] = dicts_of_motions(found);
  dict["strain"] = found.evidence ? py::cast(strain(*found.evidence)) : py::none();
  dict["options"] = values_of(result.options);
  return dict;
}

}  // namespace augicp::python
