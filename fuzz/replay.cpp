// SPDX-License-Identifier: MIT
// A fuzz target without the fuzzer, for any compiler:
//   replay FOLDER           gives the target every file of the folder
//   replay FOLDER --cuts    and the beginning of each of them, of every length
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vector>

#include "augicp/io/file_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

// A copy of its own, so that the sanitizer sees a read behind its end.
void run(std::string_view bytes) {
  const std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(copy.data(), copy.size());
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const bool with_cuts = argc > 2 && std::string_view(argv[2]) == "--cuts";
  const std::vector<fs::path> files = files_in(argv[1]);
  for (const fs::path& path : files) {
    std::printf("%s\n", path.c_str());
    std::fflush(stdout);  // the last file named is the one that failed
    const std::string bytes = augicp::read_bytes(path).bytes;
    run(bytes);
    for (std::size_t length = 0; with_cuts && length < bytes.size(); ++length)
      run(std::string_view(bytes).substr(0, length));
  }
  return files.empty() ? 1 : 0;
}
