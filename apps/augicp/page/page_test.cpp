// SPDX-License-Identifier: MIT
#include "apps/augicp/page/page.h"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "apps/augicp/page/base64.h"
#include "apps/augicp/page/chart.h"
#include "apps/augicp/page/html.h"
#include "apps/augicp/page/length_text.h"
#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/thinning.h"

namespace augicp::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

std::string base64_of(std::string_view text) { return base64(std::as_bytes(std::span(text))); }

// The vectors of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of("\xff\xfb\xf0"), "//vw");
}

TEST(Packing, NothingIsSomethingToo) {
  EXPECT_FALSE(packed_points({}).empty());
  EXPECT_EQ(packed_bytes({}), packed_directions({}));
}

TEST(Packing, TheSameNumbersGiveTheSameText) {
  const std::vector<Vec3f> points(3000, Vec3f(1.0f, -2.0f, 3.0f));
  EXPECT_EQ(packed_points(points), packed_points(points));
  EXPECT_LT(packed_points(points).size(), 300u);
}

TEST(Packing, SurvivesAnyNumbers) {
  const float huge = std::numeric_limits<float>::max();
  const std::vector<Vec3f> points = {{0, 0, 0}, {huge, -huge, 1.0f}, {1e30f, 1e-30f, 5.0f}};
  EXPECT_FALSE(packed_points(points).empty());
  const std::vector<float> values = {static_cast<float>(kNaN), static_cast<float>(kInf), huge, 0.0f};
  EXPECT_FALSE(packed_numbers(values).empty());
}

TEST(Thinning, KeepsAllOfFew) {
  EXPECT_THAT(thinned_indices(3, 5), ::testing::ElementsAre(0u, 1u, 2u));
  EXPECT_TRUE(thinned_indices(0, 5).empty());
  EXPECT_TRUE(thinned_indices(5, 0).empty());
}

TEST(Thinning, TakesOneOfEachStretch) {
  for (const std::size_t count : {101, 150, 1000, 307200}) {
    const auto indices = thinned_indices(count, 100);
    ASSERT_EQ(indices.size(), 100u);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      EXPECT_GE(indices[i], i * count / 100);
      EXPECT_LT(indices[i], (i + 1) * count / 100);
    }
    EXPECT_EQ(indices, thinned_indices(count, 100));
  }
}

TEST(Html, TextStaysText) {
  EXPECT_EQ(escaped_html("<script>alert('1\"&2')</script>"),
            "&lt;script&gt;alert(&#39;1&quot;&amp;2&#39;)&lt;/script&gt;");
  EXPECT_EQ(escaped_html(std::string_view("a\0b\x1b", 4)),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd");
  EXPECT_THAT(html_list({{"<b>", "</dd>"}}), HasSubstr("<dt>&lt;b&gt;</dt><dd>&lt;/dd&gt;</dd>"));
  EXPECT_THAT(html_table({"<i>"}, {{"<u>", "<s>"}}), HasSubstr("<th scope=\"row\">&lt;u&gt;</th><td>&lt;s&gt;</td>"));
}

TEST(Html, AFactHasItsMeaningWithIt) {
  EXPECT_THAT(html_facts({{"<b>", "</dd>", "<i>"}}),
              AllOf(HasSubstr("&lt;b&gt;<span"), HasSubstr(">&lt;i&gt;</span>"), HasSubstr("<dd>&lt;/dd&gt;</dd>")));
  EXPECT_EQ(html_explained("a & b", ""), "a &amp; b");
}

TEST(LengthText, HasTheUnitInWhichTheNumberIsAtLeastOne) {
  for (const auto& [length_m, text] : std::vector<std::pair<double, std::string>>{{1234.5, "1.23 km"},
                                                                                  {1.0, "1 m"},
                                                                                  {0.999, "99.9 cm"},
                                                                                  {-0.0123, "-1.23 cm"},
                                                                                  {0.0042, "4.2 mm"},
                                                                                  {2e-6, "2 µm"},
                                                                                  {3e-9, "0.003 µm"},
                                                                                  {0.0, "0 m"}}) {
    std::string plain = length_text(length_m);
    plain.replace(plain.find("\xc2\xa0"), 2, " ");
    EXPECT_EQ(plain, text);
  }
}

TEST(Charts, LinearAxesIncludeZeroAndOthersSayTheyDoNot) {
  Chart chart{"t", "x", "count"};
  chart.series = {{"s", {90.0, 100.0}}};
  EXPECT_EQ(y_range_of(chart).low, 0.0);
  EXPECT_EQ(y_label_of(chart), "count");
  chart.series = {{"s", {-90.0, -80.0}}};
  EXPECT_EQ(y_range_of(chart).high, 0.0);
  chart.log_y = true;
  chart.series = {{"s", {90.0, 1000.0}}};
  EXPECT_EQ(y_range_of(chart).low, 90.0);
  EXPECT_EQ(y_label_of(chart), "count, logarithmic");
}

TEST(Html, JsonCannotLeaveItsElementAndSaysTheSame) {
  const std::string text = "</script><!--<script>\xe2\x80\xa8\xe2\x80\xa9 & \xe2\x80\xa6";
  const std::string json = nlohmann::json(text).dump();
  const std::string inside = json_in_html(json);
  for (const char* forbidden : {"<", ">", "&", "\xe2\x80\xa8", "\xe2\x80\xa9"})
    EXPECT_THAT(inside, Not(HasSubstr(forbidden)));
  EXPECT_EQ(nlohmann::json::parse(inside), nlohmann::json::parse(json));
}

TEST(AxisTicks, AreRoundAndWithin) {
  EXPECT_THAT(axis_ticks({0.0, 10.0}, false, 5), ::testing::ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(axis_ticks({0.02, 2000.0}, true, 10), ::testing::ElementsAre(0.1, 1, 10, 100, 1000));
  EXPECT_THAT(axis_ticks({2.0, 6.0}, true, 4), ::testing::ElementsAre(2, 3, 4, 5, 6));
}

TEST(AxisTicks, RangesLeaveOutWhatHasNoPlace) {
  EXPECT_EQ(range_of({kNaN, 1.0, kInf, 3.0}, false).high, 3.0);
  EXPECT_EQ(range_of({0.0, -1.0, 0.1, 5.0}, true).low, 0.1);
  for (const double value : {0.0, 7.0, -1e300, 1e-300}) {
    const AxisRange range = range_of({value}, false);
    EXPECT_LT(range.low, range.high) << value;
  }
  EXPECT_LT(range_of({}, true).low, range_of({}, true).high);
}

TEST(Chart, DrawsHolesWhereValuesAreNotFinite) {
  const Chart chart{"t<", "x, s", "y, m", false, {0, 1, 2, 3, 4}, {{"a", {1, 2, kNaN, 3, kInf}}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, HasSubstr("aria-label=\"t&lt;\""));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  const std::size_t first = svg.find("curve s0");
  EXPECT_EQ(std::count(svg.begin() + static_cast<std::ptrdiff_t>(first), svg.end(), 'M'), 2);
}

TEST(Chart, IsLogarithmicWhereThatShowsMore) {
  Chart chart{"", "", "", true, {1, 2}, {{"", {2.0, 3.0}}}};
  choose_scale(chart);
  EXPECT_FALSE(chart.log_y);
  chart.series[0].y = {1e-6, 3.0};
  choose_scale(chart);
  EXPECT_TRUE(chart.log_y);
  chart.series[0].y = {0.0, 0.0};
  choose_scale(chart);
  EXPECT_FALSE(chart.log_y);
}

TEST(Chart, CountsInWholeNumbers) {
  EXPECT_THAT(chart_svg({"", "", "", false, {1, 2, 3}, {{"", {10, 20, 30}}}}), Not(HasSubstr(">2.5<")));
  EXPECT_THAT(chart_svg({"", "", "", false, {1, 2.1, 3}, {{"", {10, 20, 30}}}}), HasSubstr(">2.5<"));
}

TEST(Chart, SurvivesAnyNumbers) {
  const std::vector<double> odd{kNaN, kInf, -kInf, 0.0, -1.0, 1e308, -1e308, 1e-320};
  for (const bool log_y : {false, true}) {
    const std::string svg = chart_svg({"", "", "", log_y, odd, {{"", odd, odd, odd}}});
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_LT(svg.size(), 20000u);
  }
  EXPECT_THAT(paths_svg("", "", "", {{"", {{kNaN, 0.0}, {1e308, 1e308}}}, {"empty", {}}}), HasSubstr("<svg"));
}

TEST(Page, RunsOneScriptOnly) {
  const Page page{"<title>", "<p>body</p>", R"({"name":"</script>"})"};
  const std::string plain = to_html(page, {"p{}", "", ""});
  EXPECT_THAT(plain, Not(HasSubstr("<script")));
  EXPECT_THAT(plain, HasSubstr("default-src 'none'"));
  EXPECT_THAT(plain, HasSubstr("<title>&lt;title&gt;</title>"));
  const std::string live = to_html(page, {"p{}", "run()", "abc="});
  EXPECT_THAT(live, HasSubstr("script-src 'sha256-abc='"));
  EXPECT_THAT(live, HasSubstr(R"({"name":"\u003c/script\u003e"})"));
  EXPECT_THAT(live, HasSubstr("<script>run()</script>"));
}

TEST(Chart, ALegendNamesEveryCurveAndEscapesIt) {
  const std::string html = legend_html({"point", "a<b>"});
  EXPECT_LT(html.find("s0"), html.find("point"));
  EXPECT_LT(html.find("point"), html.find("s1"));
  EXPECT_THAT(html, HasSubstr("a&lt;b&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("a<b>")));
}

}  // namespace
}  // namespace augicp::app
