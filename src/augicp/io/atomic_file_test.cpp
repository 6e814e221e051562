// SPDX-License-Identifier: MIT
#include "augicp/io/atomic_file.h"

#include <gtest/gtest.h>

#include "augicp/io/file_bytes.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

std::size_t num_files(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(AtomicFile, HoldsWhatWasWritten) {
  const testing::TemporaryFolder folder;
  write_file(folder / "out", "first");
  write_file(folder / "out", "second");
  EXPECT_EQ(read_bytes(folder / "out").bytes, "second");
  EXPECT_EQ(num_files(folder.path()), 1u);
}

// robustness 9
TEST(AtomicFile, WithoutCommitTheOldFileStaysAndNothingIsLeft) {
  const testing::TemporaryFolder folder;
  write_file(folder / "out", "old");
  {
    AtomicFile file(folder / "out");
    file.write("half of the n");
    EXPECT_EQ(num_files(folder.path()), 2u);
  }
  EXPECT_EQ(read_bytes(folder / "out").bytes, "old");
  EXPECT_EQ(num_files(folder.path()), 1u);
}

TEST(AtomicFile, TwoWritersOfOneFolderDoNotMeet) {
  const testing::TemporaryFolder folder;
  AtomicFile first(folder / "a"), second(folder / "b");
  first.write("1");
  second.write("2");
  second.commit();
  first.commit();
  EXPECT_EQ(read_bytes(folder / "a").bytes + read_bytes(folder / "b").bytes, "12");
}

// robustness 9
TEST(AtomicFile, FailuresAreErrors) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW(write_file(folder.path(), "x"), IoError);
  EXPECT_THROW(write_file(folder / "absent" / "out", "x"), IoError);
  if (std::filesystem::exists("/dev/full")) {
    EXPECT_THROW(write_file("/dev/full", "x"), IoError);
  }
  EXPECT_EQ(num_files(folder.path()), 0u);
}

TEST(AtomicFile, ALinkStaysALink) {
  const testing::TemporaryFolder folder;
  write_file(folder / "file", "old");
  std::filesystem::create_symlink("file", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_bytes(folder / "file").bytes, "new");
}

}  // namespace
}  // namespace augicp
