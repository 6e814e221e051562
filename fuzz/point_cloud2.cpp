// SPDX-License-Identifier: MIT
// The first byte chooses the form.
#include "augicp/io/point_cloud2.h"

#include "fuzz/promises.h"

using namespace augicp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const FileBytes message = fuzz::file_of("any", data + 1, size - 1);
  ReadOptions options;
  options.keep_fields = true;
  fuzz::expect_read_or_refused(message.path, [&] {
    const CloudFile read = parse_point_cloud2(message.path, message.bytes,
                                              data[0] % 2 == 0 ? MessageForm::Cdr : MessageForm::Ros1, options)
                               .file;
    fuzz::expect_sound(read);
    const std::size_t num_rows = read.grid ? read.grid->index.size() : read.cloud.size();
    for (const PointField& field : read.fields.fields)
      fuzz::expect(field.values.size() == num_rows * field.row_bytes(), "a row of each field for each point or cell");
  });
  return 0;
}
