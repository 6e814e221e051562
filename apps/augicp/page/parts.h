// SPDX-License-Identifier: MIT
// Parts of the pages of all subcommands.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "apps/augicp/page/chart.h"
#include "apps/augicp/page/html.h"
#include "augicp/geometry/rigid3.h"

namespace augicp::app {

struct PageHead {
  std::string title;               // what kind of report
  std::string badge, badge_class;  // a word, and good, warn or bad; empty: none
  std::vector<std::string> lines;  // of the text below
};
std::string header_html(const PageHead& head);

std::string section_html(const std::string& title, const std::string& content);
std::string details_html(const std::string& title, const std::string& content);

// The chart with this number in charts_json(); its title above.
std::string figure_html(const Chart& chart, std::size_t number);
std::string figures_html(std::span<const Chart> charts, std::size_t first_number = 0);
nlohmann::ordered_json charts_json(std::span<const Chart> charts);

// 4x4, column by column as in WebGL; a number that is not finite becomes null in JSON.
std::vector<double> pose_numbers(const Rigid3& page_from_body);
std::vector<double> numbers(const Vec3d& vector);

// The HTML file, with the data {"kind": kind, "charts": ..., kind: data}.
std::string whole_page(const PageHead& head, const std::string& kind, const std::string& body,
                       std::span<const Chart> charts, nlohmann::ordered_json data = nullptr);

}  // namespace augicp::app
