// SPDX-License-Identifier: MIT
#include "augicp/io/sequence_folders.h"

#include <gtest/gtest.h>

#include "augicp/io/atomic_file.h"
#include "augicp/testing/temporary_folder.h"

namespace augicp {
namespace {

TEST(NumberedImages, OneKindIsReadAndTheOthersAreCounted) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"1.pgm", "2.PGM", "1.tif", "2.tif", "3.tif", "mask.png", "mean.pgm", "notes.txt"})
    write_file(folder / name, "");
  const NumberedImages found = numbered_images(folder.path(), 10.0);
  ASSERT_EQ(found.frames.size(), 2u);
  EXPECT_EQ(found.frames[1].path.filename(), "2.PGM");
  EXPECT_EQ(found.left_out,
            "2 .pgm images are read, and left out are 1 .png without a number at the end of the name, 1 .pgm without a "
            "number at the end of the name, 3 .tif");
}

TEST(NumberedImages, WhatIsReadWholeLeavesNothingOut) {
  const testing::TemporaryFolder folder;
  for (const char* name : {"1.npy", "2.npy", "camera.txt"}) write_file(folder / name, "");
  const NumberedImages found = numbered_images(folder.path(), 10.0);
  EXPECT_EQ(found.frames.size(), 2u);
  EXPECT_EQ(found.left_out, "");
}

}  // namespace
}  // namespace augicp
