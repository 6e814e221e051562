// SPDX-License-Identifier: MIT
#include "augicp/io/scan_files.h"

#include <algorithm>
#include <map>

#include "augicp/io/file_bytes.h"
#include "augicp/io/format.h"
#include "augicp/io/natural_order.h"
#include "augicp/io/scan_sequence.h"

namespace augicp {
namespace {

namespace fs = std::filesystem;

// Of equally many files the first kind is read.
constexpr const char* kKinds[] = {".bin", ".pcd", ".ply"};

// Clouds that are aligned in pairs, and not read as a sequence. Texts are left out: they may be anything.
constexpr const char* kOtherClouds[] = {".las", ".laz", ".e57", ".xyz", ".pts", ".asc"};

using FilesByKind = std::map<std::string, std::vector<fs::path>>;

FilesByKind clouds_in(const fs::path& folder) {
  FilesByKind files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string kind = lower_case_extension(entry->path());
    const auto is_kind = [&](const char* known) { return kind == known; };
    if (std::any_of(std::begin(kKinds), std::end(kKinds), is_kind) ||
        std::any_of(std::begin(kOtherClouds), std::end(kOtherClouds), is_kind))
      files[kind].push_back(entry->path());
  }
  if (error) throw io_error(folder, "cannot be listed: " + error.message());
  return files;
}

// The kind with the most files; empty if there is none.
std::string most_frequent(const FilesByKind& files) {
  std::string most;
  std::size_t num_most = 0;
  for (const char* kind : kKinds)
    if (const auto of_kind = files.find(kind); of_kind != files.end() && of_kind->second.size() > num_most)
      most = kind, num_most = of_kind->second.size();
  return most;
}

// "3 .ply, 1 .las", without one kind.
std::string counts_of(const FilesByKind& files, const std::string& without = {}) {
  std::string text;
  for (const auto& [kind, paths] : files)
    if (kind != without) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", paths.size(), kind);
  return text;
}

ScanFiles most_in(const fs::path& folder) {
  FilesByKind files = clouds_in(folder);
  const std::string kind = most_frequent(files);
  if (kind.empty()) return {{}, counts_of(files)};
  ScanFiles found{std::move(files[kind]), counts_of(files, kind)};
  std::sort(found.scans.begin(), found.scans.end(), [](const fs::path& a, const fs::path& b) {
    return naturally_before(a.filename().string(), b.filename().string());
  });
  return found;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// "12 .pcd scans are read, and 3 .ply are left out: ..."
std::string in_words(const ScanFiles& files, const std::string& beside) {
  if (files.left_out.empty() && beside.empty()) return {};
  std::string others = files.left_out;
  if (!beside.empty()) others += fmt::format("{}{} outside of it", others.empty() ? "" : " and ", beside);
  return fmt::format("{} {} scans are read, and {} left out: scans of one kind in a folder of their own are all read",
                     files.scans.size(), lower_case_extension(files.scans.front()), others);
}

}  // namespace

ScanFiles scan_files_in(const fs::path& folder) {
  for (const char* inner : {"velodyne", "velodyne_points/data"}) {
    if (!is_folder(folder / inner)) continue;
    ScanFiles found = most_in(folder / inner);
    if (found.scans.empty()) continue;
    found.left_out = in_words(found, counts_of(clouds_in(folder)));
    return found;
  }
  ScanFiles found = most_in(folder);
  if (!found.scans.empty()) found.left_out = in_words(found, {});
  return found;
}

std::vector<fs::path> find_scans(const fs::path& folder) { return scan_files_in(folder).scans; }

}  // namespace augicp
