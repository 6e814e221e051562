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

bool has_content(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return !error && size > 0;
}

// Without a log of changes beside it the file does not change: SQLite then makes no file beside it either.
std::string uri_of(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : path.string()) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '/' ||
                          c == '.' || c == '_' || c == '-';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
  }
  const bool has_log = has_content(path.string() + "-wal") || has_content(path.string() + "-journal");
  return has_log ? uri : uri + "?immutable=1";
}

Database opened(const std::filesystem::path& path) {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(uri_of(path).c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  Database database(raw, &sqlite3_close);
  if (code != SQLITE_OK) throw io_error(path, fmt::format("cannot be opened: {}", sqlite3_errstr(code)));
  // The file is not trusted: no functions from its schema, and bounded memory for a value.
  sqlite3_db_config(raw, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return database;
}

[[noreturn]] void fail(const std::filesystem::path& path, sqlite3* database) {
  throw io_error(path, "expected a bag of ROS 2: " + in_quotes(sqlite3_errmsg(database)));
}

// Bounds the work of a statement by the size of its file: pages of a damaged file may refer to each other so that
// reading them takes years. A message costs some 50 instructions of SQLite's machine and has more than 10 bytes.
class WorkBound {
 public:
  WorkBound(sqlite3* database, std::uint64_t file_bytes)
      : num_left_(static_cast<std::int64_t>(kFew + file_bytes / kBytesPerStep)) {
    sqlite3_progress_handler(database, kInstructionsPerStep, &WorkBound::is_exceeded, this);
  }
  WorkBound(const WorkBound&) = delete;
  WorkBound& operator=(const WorkBound&) = delete;

 private:
  static constexpr int kInstructionsPerStep = 10000;
  static constexpr std::uint64_t kFew = 100, kBytesPerStep = 100;

  static int is_exceeded(void* self) { return --static_cast<WorkBound*>(self)->num_left_ <= 0 ? 1 : 0; }

  std::int64_t num_left_;
};

Statement prepared(const std::filesystem::path& path, sqlite3* database, const char* text) {
  sqlite3_stmt* raw = nullptr;
  const int code = sqlite3_prepare_v2(database, text, -1, &raw, nullptr);
  Statement statement(raw, &sqlite3_finalize);
  if (code != SQLITE_OK) fail(path, database);
  return statement;
}

std::string_view text_in(sqlite3_stmt* statement, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text ? std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column)))
              : std::string_view();
}

class SqliteReader : public MessageSource {
 public:
  // LEFT: a message whose topic is missing is an error, and not left out.
  SqliteReader(const std::filesystem::path& path, std::uint64_t file_bytes)
      : path_(path),
        database_(opened(path)),
        bound_(database_.get(), file_bytes),
        statement_(
            prepared(path, database_.get(),
                     "SELECT topics.name, topics.type, messages.timestamp, messages.data FROM messages "
                     "LEFT JOIN topics ON topics.id = messages.topic_id ORDER BY messages.timestamp, messages.id")) {}

  std::optional<BagMessage> next() override {
    sqlite3_stmt* const row = statement_.get();
    const int step = is_at_end_ ? SQLITE_DONE : sqlite3_step(row);
    is_at_end_ = step != SQLITE_ROW;
    if (step == SQLITE_DONE && !is_counted_) require_all();
    if (step == SQLITE_DONE) return std::nullopt;
    if (step != SQLITE_ROW) fail(path_, database_.get());
    ++num_messages_;
    require_types(row);
    type_ = plain_type(text_in(row, 1));
    const auto* data = static_cast<const char*>(sqlite3_column_blob(row, 3));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, 3));
    const std::string_view bytes = data ? std::string_view(data, size) : std::string_view();
    return BagMessage{text_in(row, 0), type_, MessageForm::Cdr, sqlite3_column_int64(row, 2), bytes};
  }

 private:
  // SQLite converts whatever is in a column to whatever is requested.
  void require_types(sqlite3_stmt* row) const {
    constexpr int kExpected[] = {SQLITE_TEXT, SQLITE_TEXT, SQLITE_INTEGER, SQLITE_BLOB};
    for (int column = 0; column < 4; ++column)
      if (sqlite3_column_type(row, column) != kExpected[column])
        throw io_error(path_, fmt::format("expected a message with a topic, a type, a stamp and bytes, found none "
                                          "in '{}'",
                                          sqlite3_column_name(row, column)));
  }

  std::int64_t count_of(const char* statement) const {
    const Statement count = prepared(path_, database_.get(), statement);
    if (sqlite3_step(count.get()) != SQLITE_ROW) fail(path_, database_.get());
    return sqlite3_column_int64(count.get(), 0);
  }

  // The order comes from an index, and a damaged one may have fewer messages than the table. Without messages the
  // topics were not read.
  void require_all() {
    count_of("SELECT sum(length(name) + length(type)) FROM topics NOT INDEXED");
    const std::int64_t num_expected = count_of("SELECT count(*) FROM messages NOT INDEXED");
    if (num_expected != num_messages_)
      throw io_error(path_, fmt::format("expected {} messages, its index has {}", num_expected, num_messages_));
    is_counted_ = true;
  }

  const std::filesystem::path path_;
  Database database_;
  WorkBound bound_;
  Statement statement_;
  std::string type_;
  bool is_at_end_ = false, is_counted_ = false;
  std::int64_t num_messages_ = 0;
};

}  // namespace

std::unique_ptr<MessageSource> open_sqlite(const std::filesystem::path& path) {
  return std::make_unique<SqliteReader>(path, FileStream(path).num_left());
}

}  // namespace augicp

#else

namespace augicp {

std::unique_ptr<MessageSource> open_sqlite(const std::filesystem::path& path) {
  throw io_error(path, "augicp was built without SQLite (libsqlite3-dev); 'ros2 bag convert' makes an .mcap of it");
}

}  // namespace augicp

#endif
