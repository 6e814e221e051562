// SPDX-License-Identifier: MIT
#include "apps/augicp/command/global_inputs.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "apps/augicp/command/inputs.h"
#include "apps/augicp/command/named_families.h"
#include "apps/augicp/command/output.h"
#include "augicp/core/error.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/transform_file.h"
#include "augicp/io/write_cloud.h"
#include "augicp/synthetic/global_families.h"

namespace augicp::app {
namespace {

// As one word of a list.
std::string word_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace

void read_list(const std::filesystem::path& list, GlobalInputs& inputs) {
  std::ifstream file(list);
  if (!file) throw IoError(list.string() + ": cannot be read");
  std::map<std::filesystem::path, const Cloud*> known;
  const auto cloud_of = [&](const std::filesystem::path& path) {
    const Cloud*& cloud = known[path];
    if (!cloud) cloud = &inputs.clouds.emplace_back(read_cloud(path).cloud);
    return cloud;
  };
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    std::string family, source, target, truth;
    if (!(words >> family) || family.front() == '#') continue;
    if (!(words >> source >> target >> truth))
      throw IoError(list.string() + ": line " + std::to_string(number) + ": expected family, source, target, truth");
    const auto folder = list.parent_path();
    GlobalPair pair{family, source, target, cloud_of(folder / source), cloud_of(folder / target), std::nullopt, 1.0};
    if (truth != "-") pair.target_from_source = read_transform(folder / truth);
    inputs.pairs.push_back(pair);
  }
}

void read_fragments(const std::vector<std::string>& folders, const std::vector<std::string>& cameras,
                    const FragmentOptions& options, GlobalInputs& inputs) {
  if (cameras.size() > 1 && cameras.size() != folders.size())
    throw std::invalid_argument("--camera: give none, one, or one for each sequence");
  for (std::size_t k = 0; k < folders.size(); ++k) {
    const std::string camera = cameras.empty() ? "" : cameras[cameras.size() == 1 ? 0 : k];
    const DepthSequence sequence = read_depth_sequence(folders[k]);
    const DepthCamera found = sequence_camera(sequence, folders[k], camera == "own" ? "" : camera);
    const auto& fragments = inputs.fragments.emplace_back(fragments_of(sequence, found, options));
    for (GlobalPair& pair : pairs_of_fragments("fragments", fragments, options.frames_each))
      inputs.pairs.push_back(std::move(pair));
  }
}

void add_apart(GlobalInputs& inputs) {
  for (std::size_t a = 0; a < inputs.fragments.size(); ++a)
    for (std::size_t b = a + 1; b < inputs.fragments.size(); ++b)
      for (const Fragment& target : inputs.fragments[a])
        for (const Fragment& source : inputs.fragments[b])
          inputs.pairs.push_back({"apart", std::to_string(b) + ":" + std::to_string(source.first_frame),
                                  std::to_string(a) + ":" + std::to_string(target.first_frame), &source.cloud,
                                  &target.cloud, std::nullopt, 1.0});
}

void add_generated(const GeneratedPairs& which, GlobalInputs& inputs) {
  for (const synthetic::GlobalFamily& family : named_families(synthetic::global_families(), which.families))
    for (std::size_t k = 0; k < which.count; ++k) {
      const unsigned seed = which.first_seed + static_cast<unsigned>(k);
      synthetic::DrawnPair drawn = family.draw(seed);
      const Cloud& source = inputs.clouds.emplace_back(std::move(drawn.source));
      const Cloud& target = inputs.clouds.emplace_back(std::move(drawn.target));
      const std::string name = std::to_string(seed);
      inputs.pairs.push_back(
          {family.name, name, name, &source, &target, drawn.target_from_source, family.length_scale});
    }
}

void save_pairs(const std::filesystem::path& folder, const std::vector<GlobalPair>& pairs) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw IoError(folder.string() + ": " + problem.message());
  std::map<const Cloud*, std::string> known;
  const auto name_of_cloud = [&](const Cloud* cloud) {
    std::string& name = known[cloud];
    if (!name.empty()) return name;
    name = fmt::format("cloud_{}.ply", known.size());
    write_cloud(folder / name, *cloud);
    return name;
  };
  std::string list;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const GlobalPair& pair = pairs[k];
    const std::string source = name_of_cloud(pair.source), target = name_of_cloud(pair.target);
    const std::string truth = pair.target_from_source ? fmt::format("truth_{}.txt", k + 1) : "-";
    if (pair.target_from_source) write_transform(folder / truth, *pair.target_from_source);
    list += fmt::format("{} {} {} {}\n", word_of(pair.family), source, target, truth);
  }
  write_text_file((folder / "pairs.txt").string(), list);
}

}  // namespace augicp::app
