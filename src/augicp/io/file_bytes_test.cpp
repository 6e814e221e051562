// SPDX-License-Identifier: MIT
#include "augicp/io/file_bytes.h"

#include <gtest/gtest.h>

#include "augicp/io/atomic_file.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

std::string message_of(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxFileBytes) {
  try {
    read_bytes(path, max_bytes);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

// robustness 9
TEST(FileBytes, ReadsPathsWithSpacesAndUtf8) {
  const testing::TemporaryFolder folder;
  const auto path = folder / "Wolke \u00fc \u70b9.xyz";
  write_file(path, std::string_view("a\0b\n", 4));
  EXPECT_EQ(read_bytes(path).bytes, std::string_view("a\0b\n", 4));
}

// robustness 9
TEST(FileBytes, ErrorsNameThePath) {
  const testing::TemporaryFolder folder;
  write_file(folder / "five", "12345");
  EXPECT_NE(message_of(folder / "absent.ply").find("absent.ply: no such file"), std::string::npos);
  EXPECT_NE(message_of(folder.path()).find("found a directory"), std::string::npos);
  EXPECT_NE(message_of("/dev/zero").find("expected a regular file"), std::string::npos);
  EXPECT_NE(message_of(folder / "five", 4).find("expected at most 4 bytes, found 5"), std::string::npos);
}

TEST(FileBytes, QuotesAreShortAndPrintable) {
  EXPECT_EQ(in_quotes("x\n\x80y"), "'x??y'");
  EXPECT_EQ(in_quotes(std::string(1000, 'a')).size(), 45u);
}

}  // namespace
}  // namespace augicp
