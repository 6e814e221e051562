// SPDX-License-Identifier: MIT
#include "apps/augicp/command/suggestion.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <utility>

namespace augicp::app {
namespace {

// A typing error in a short word, two or three in a long one. Beyond, most suggestions are wrong.
constexpr std::size_t kLettersPerError = 3;
constexpr std::size_t kMinPrefix = 3;

// What other programs call it, without dashes, and our word. A row counts only where our word is one of those expected.
constexpr std::array<std::pair<std::string_view, std::string_view>, 67> kWordsOfOthers = {{
    {"register", "align"},
    {"registration", "align"},
    {"icp", "align"},
    {"gicp", "align"},
    {"ndt", "align"},
    {"match", "align"},
    {"slam", "odometry"},
    {"track", "odometry"},
    {"mapping", "odometry"},
    {"ape", "evaluate"},
    {"rpe", "evaluate"},
    {"normals", "surface"},
    {"view", "info"},
    {"show", "info"},
    {"downsample", "voxel-size"},
    {"downsamplingresolution", "voxel-size"},
    {"leaf", "voxel-size"},
    {"leafsize", "voxel-size"},
    {"resolution", "voxel-size"},
    {"maxcorrespondencedistance", "max-distance"},
    {"maxcorrdistance", "max-distance"},
    {"gate", "max-distance"},
    {"iter", "max-iterations"},
    {"iters", "max-iterations"},
    {"numiterations", "max-iterations"},
    {"transformationepsilon", "min-step"},
    {"tolerance", "min-step"},
    {"minerrordiff", "min-step"},
    {"ransac", "global"},
    {"fpfh", "global"},
    {"randomsamplinglimit", "voxel-size"},
    {"init", "initial"},
    {"initialguess", "initial"},
    {"nscans", "last"},
    {"jump", "first"},
    {"skip", "first"},
    {"dataloader", "sensor"},
    {"verbosity", "verbose"},
    {"tmaxdiff", "max-difference"},
    {"toffset", "time-offset"},
    {"correctscale", "align"},
    {"alignorigin", "align"},
    {"deltaunit", "unit"},
    {"saveresults", "json"},
    {"saveplot", "report"},
    {"savetraj", "output"},
    {"voxelsize", "map-voxel"},
    {"guess", "initial"},
    {"transformation", "initial"},
    {"correspondencedistance", "max-distance"},
    {"maxcorrdist", "max-distance"},
    {"deskew", "point-times"},
    {"save", "output"},
    {"view", "report"},
    {"visualize", "report"},
    {"visualise", "report"},
    {"plot", "report"},
    {"html", "report"},
    {"intrinsics", "camera"},
    {"numthreads", "threads"},
    {"jobs", "threads"},
    {"icp", "point"},
    {"p2p", "point"},
    {"pointtopoint", "point"},
    {"p2pl", "plane"},
    {"pointtoplane", "plane"},
    {"camera", "depth"},
}};

std::string plain(std::string_view word) {
  std::string letters;
  for (const char c : word)
    if (c != '-' && c != '_') letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

std::vector<std::string> parts_of(std::string_view word) {
  std::vector<std::string> parts(1);
  for (const char c : word)
    if (c == '-' || c == '_')
      parts.emplace_back();
    else
      parts.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::erase(parts, "");
  return parts;
}

bool has_all_parts(const std::string& word, const std::string& name) {
  const std::vector<std::string> have = parts_of(word), wanted = parts_of(name);
  return wanted.size() > 1 && std::all_of(wanted.begin(), wanted.end(), [&](const std::string& part) {
           return std::find(have.begin(), have.end(), part) != have.end();
         });
}

bool is_near(const std::string& word, const std::string& name) {
  const std::string a = plain(word), b = plain(name);
  return edit_distance(a, b) <= std::max<std::size_t>(1, a.size() / kLettersPerError) ||
         (a.size() >= kMinPrefix && b.starts_with(a)) || has_all_parts(word, name);
}

std::string of_others(const std::string& word, const std::vector<std::string>& known) {
  for (const auto& [theirs, ours] : kWordsOfOthers)
    if (plain(word) == theirs && std::find(known.begin(), known.end(), ours) != known.end()) return std::string(ours);
  return {};
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);  // of the rows for prefixes of a
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

std::string closest(const std::string& word, const std::vector<std::string>& known) {
  const auto distance = [&](const std::string& name) { return edit_distance(plain(word), plain(name)); };
  std::string best = of_others(word, known);
  if (!best.empty()) return best;
  for (const std::string& name : known)
    if (is_near(word, name) && (best.empty() || distance(name) < distance(best))) best = name;
  return best;
}

}  // namespace augicp::app
