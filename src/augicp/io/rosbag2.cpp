// SPDX-License-Identifier: MIT
// Bags of ROS 2 in SQLite's files: tables topics and messages.
#include "augicp/io/bag_parts.h"

#ifdef AUGICP_HAS_SQLITE

#include <sqlite3.h>

#include "augicp/io/format.h"

namespace augicp {
namespace {

using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;
using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

Database opened(const std::filesystem::path& path) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
  Database database(raw, &sqlite3_close);
  if (code != SQLITE_OK) throw io_error(path, fmt::format("cannot be opened: {}", sqlite3_errstr(code)));
  // The file is not trusted: no functions from its schema, and bounded memory for a value.
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return database;
}

[[noreturn]] void fail(const std::filesystem::path& path, sqlite3* database) {
  throw io_error(path, fmt::format("expected a bag of ROS 2: {}", sqlite3_errmsg(database)));
}

std::string_view text_in(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text ? std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)))
              : std::string_view();
}

class SqliteReader : public MessageSource {
 public:
  explicit SqliteReader(const std::filesystem::path& path)
      : path_(path), database_(opened(path)), statement_(nullptr, &sqlite3_finalize) {
    sqlite3_stmt* raw = nullptr;
    const int code =
        sqlite3_prepare_v2(database_.get(),
                           "SELECT topics.name, topics.type, messages.timestamp, messages.data FROM messages "
                           "JOIN topics ON topics.id = messages.topic_id ORDER BY messages.timestamp, messages.id",
                           -1, &raw, nullptr);
    statement_.reset(raw);
    if (code != SQLITE_OK) fail(path_, database_.get());
  }

  std::optional<BagMessage> next() override {
    sqlite3_stmt* const row = statement_.get();
    const int step = is_at_end_ ? SQLITE_DONE : sqlite3_step(row);
    is_at_end_ = step != SQLITE_ROW;
    if (step == SQLITE_DONE) return std::nullopt;
    if (step != SQLITE_ROW) fail(path_, database_.get());
    type_ = plain_type(text_in(row, 1));
    const auto* data = static_cast<const char*>(sqlite3_column_blob(row, 3));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, 3));
    const std::string_view bytes = data ? std::string_view(data, size) : std::string_view();
    return BagMessage{text_in(row, 0), type_, MessageForm::Cdr, sqlite3_column_int64(row, 2), bytes};
  }

 private:
  const std::filesystem::path path_;
  Database database_;
  Statement statement_;
  std::string type_;
  bool is_at_end_ = false;
};

}  // namespace

std::unique_ptr<MessageSource> open_sqlite(const std::filesystem::path& path) {
  FileStream exists(path);
  return std::make_unique<SqliteReader>(path);
}

}  // namespace augicp

#else

namespace augicp {

std::unique_ptr<MessageSource> open_sqlite(const std::filesystem::path& path) {
  throw io_error(path, "augicp was built without SQLite (libsqlite3-dev); 'ros2 bag convert' makes an .mcap of it");
}

}  // namespace augicp

#endif
