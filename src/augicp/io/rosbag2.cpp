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

}  // namespace

void visit_sqlite(const std::filesystem::path& path, const MessageVisitor& visit) {
  FileStream exists(path);
  const Database database = opened(path);
  sqlite3_stmt* raw = nullptr;
  const int code =
      sqlite3_prepare_v2(database.get(),
                         "SELECT topics.name, topics.type, messages.timestamp, messages.data FROM messages "
                         "JOIN topics ON topics.id = messages.topic_id ORDER BY messages.timestamp, messages.id",
                         -1, &raw, nullptr);
  const Statement statement(raw, &sqlite3_finalize);
  if (code != SQLITE_OK) fail(path, database.get());
  int step = SQLITE_ROW;
  while ((step = sqlite3_step(raw)) == SQLITE_ROW) {
    const std::string type = plain_type(text_in(raw, 1));
    const auto* data = static_cast<const char*>(sqlite3_column_blob(raw, 3));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(raw, 3));
    const std::string_view bytes = data ? std::string_view(data, size) : std::string_view();
    if (!visit({text_in(raw, 0), type, MessageForm::Cdr, sqlite3_column_int64(raw, 2), bytes})) return;
  }
  if (step != SQLITE_DONE) fail(path, database.get());
}

}  // namespace augicp

#else

namespace augicp {

void visit_sqlite(const std::filesystem::path& path, const MessageVisitor&) {
  throw io_error(path, "augicp was built without SQLite (libsqlite3-dev); 'ros2 bag convert' makes an .mcap of it");
}

}  // namespace augicp

#endif
