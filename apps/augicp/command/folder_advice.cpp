// SPDX-License-Identifier: MIT
#include "apps/augicp/command/folder_advice.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <vector>

#include "augicp/core/error.h"
#include "augicp/io/file_bytes.h"
#include "augicp/io/scan_files.h"
#include "augicp/io/scan_sequence.h"

namespace augicp::app {
namespace {

// Files of a folder that are of a kind, and the folders below it with the most of them, whose names are the least.
struct FilesOfKind {
  std::map<std::filesystem::path, std::vector<std::filesystem::path>> by_folder;

  void add(const std::filesystem::path& path) { by_folder[path.parent_path()].push_back(path); }

  std::vector<std::filesystem::path> most() const {
    std::vector<std::filesystem::path> found;
    for (const auto& [folder, files] : by_folder)
      if (files.size() > found.size()) found = files;
    std::sort(found.begin(), found.end());
    return found;
  }
};

struct FolderContent {
  std::vector<std::filesystem::path> scans, images;  // those of the folder, at it or below, that has the most of them
};

FolderContent content_of(const std::filesystem::path& folder) {
  FilesOfKind scans, images;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string extension = lower_case_extension(entry->path());
    if (extension == ".ply" || extension == ".pcd" || extension == ".bin") scans.add(entry->path());
    if (extension == ".png") images.add(entry->path());
  }
  return {scans.most(), images.most()};
}

// How the scans or images, whichever are more, are tracked. REQUIRES: there are any.
std::string tracking_advice(const FolderContent& content) {
  const bool are_scans = content.scans.size() > content.images.size();
  const auto& found = are_scans ? content.scans : content.images;
  // TUM's list of images, and the colour images beside them, are in the folder above.
  const std::filesystem::path in = found.front().parent_path(),
                              sequence = !are_scans && in.filename() == "depth" ? in.parent_path() : in;
  return fmt::format("{} {} are tracked by: augicp odometry {}", found.size(), are_scans ? "scans" : "images",
                     sequence.string());
}

}  // namespace

std::string folder_advice(const std::filesystem::path& folder) {
  const FolderContent content = content_of(folder);
  const auto& [scans, images] = content;
  const std::string text = fmt::format("{}: is a folder, expected one cloud or depth image", folder.string());
  if (scans.empty() && images.empty()) return text + "; it has neither";
  if (scans.size() == 2 && images.size() < 2)
    return text +
           fmt::format("; its two clouds are aligned by: augicp align {} {}", scans[0].string(), scans[1].string());
  return text + "; " + tracking_advice(content);
}

void require_frames(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!find_scans(folder).empty() || std::filesystem::exists(folder / "depth.txt", ignored)) return;
  for (const std::filesystem::path& own : {folder, folder / "depth"})
    for (std::filesystem::directory_iterator entry(own, ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
      const std::string extension = lower_case_extension(entry->path());
      for (const char* const known : {".png", ".pgm", ".npy", ".pfm", ".tif", ".tiff"})
        if (extension == known) return;
    }
  const FolderContent content = content_of(folder);
  std::string text = folder.string() + ": expected scans (.bin .pcd .ply) or depth images, found no image and no scan";
  if (const std::string others = scan_files_in(folder).left_out; !others.empty())
    text += fmt::format(
        "; it has {}, which no sequence is read from: 'augicp align' takes two clouds, and augicp.LidarOdometry of the "
        "Python module takes them one after the other",
        others);
  throw IoError(content.scans.empty() && content.images.empty() ? text : text + "; " + tracking_advice(content));
}

}  // namespace augicp::app
