// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"

namespace torsio {

/// A folder of its own for each test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// An empty database a test: an SQLite file, or, when TORSIO_DB_TEST_ENGINE is "postgresql", a schema of its
/// own on the server that TORSIO_TEST_POSTGRES names (tests/support/start-postgres.sh starts one). Without a
/// server those tests are skipped.
class DatabaseTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  [[nodiscard]] static bool onPostgresql();
  [[nodiscard]] const std::string& locator() const { return locator_; }
  [[nodiscard]] Connection open(int busyTimeout_ms = kBusyTimeout_ms) const;
  /// Opened with the whole schema.
  [[nodiscard]] Connection openWithSchema() const;

 private:
  std::optional<TemporaryFolder> folder_;
  std::string locator_;
  std::string schema_;
};

/// The number in the first column of the first row.
[[nodiscard]] std::int64_t numberFrom(Connection& connection, const std::string& sql);

/// The fault with which `action` is refused; a test failure when it is not.
template <typename Action>
DbFault faultFrom(Action&& action) {
  try {
    action();
  } catch (const DbError& error) {
    return error.fault();
  }
  ADD_FAILURE() << "nothing was refused";
  return DbFault::kOther;
}

/// The error code with which `action` is refused, and its text.
struct Refusal {
  ErrorCode code = ErrorCode::kInternal;
  std::string text;
};
template <typename Action>
Refusal refusalFrom(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

}  // namespace torsio
