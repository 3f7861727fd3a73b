// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/db/test_database.h"

#include <algorithm>
#include <cstdlib>

#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

std::string uniqueName() {
  std::string name = "t_" + SystemIdSource().newUuid();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

const char* server() {
  return std::getenv("TORSIO_TEST_POSTGRES");
}

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(fs::temp_directory_path() / ("torsio_" + uniqueName())) {
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  fs::remove_all(path_, ignored);
}

bool DatabaseTest::onPostgresql() {
  const char* engine = std::getenv("TORSIO_DB_TEST_ENGINE");
  return engine != nullptr && std::string(engine) == "postgresql";
}

void DatabaseTest::SetUp() {
  if (!onPostgresql()) {
    folder_.emplace();
    locator_ = (folder_->path() / "record.sqlite").string();
    return;
  }
  if (server() == nullptr) {
    GTEST_SKIP()
        << "no PostgreSQL server: export TORSIO_TEST_POSTGRES=$(tests/support/start-postgres.sh start)";
  }
  schema_ = uniqueName();
  locator_ = std::string(server()) + "?schema=" + schema_;
  openDatabase(server(), OpenMode::kReadWrite).executeVerbatim("CREATE SCHEMA " + schema_);
}

void DatabaseTest::TearDown() {
  connection_.reset();
  if (schema_.empty()) {
    return;
  }
  Connection connection = openDatabase(server(), OpenMode::kReadWrite);
  connection.executeVerbatim("SET client_min_messages = warning");
  connection.executeVerbatim("DROP SCHEMA " + schema_ + " CASCADE");
}

Connection DatabaseTest::open(int busyTimeout_ms) const {
  return openDatabase(locator_, OpenMode::kCreate, busyTimeout_ms);
}

Connection DatabaseTest::openWithSchema() const {
  return openRecord(locator_, OpenMode::kCreate, {.softwareVersion = "test"});
}

Connection& DatabaseTest::connection() {
  return connection_ ? *connection_ : connection_.emplace(openWithSchema());
}

std::int64_t numberFrom(Connection& connection, const std::string& sql) {
  Statement row = connection.prepare(sql);
  row.execute();
  return row.step() ? row.int64(0) : -1;
}

}  // namespace torsio
