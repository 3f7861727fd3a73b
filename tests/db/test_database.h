// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"

namespace torsio {

/// A folder for one test, removed at the end.
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

/// A new empty database for each test: an SQLite file or, if TORSIO_DB_TEST_ENGINE is "postgresql", a schema
/// on the server TORSIO_TEST_POSTGRES (tests/support/start-postgres.sh starts one). Without a server those
/// tests are skipped.
class DatabaseTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  [[nodiscard]] static bool onPostgresql();
  [[nodiscard]] const std::string& locator() const { return locator_; }
  [[nodiscard]] Connection open(int busyTimeout_ms = kBusyTimeout_ms) const;
  /// Opens it with the complete schema.
  [[nodiscard]] Connection openWithSchema() const;
  /// The test's own connection, opened with the complete schema at the first call.
  [[nodiscard]] Connection& connection();

 private:
  std::optional<TemporaryFolder> folder_;
  std::string locator_;
  std::string schema_;
  std::optional<Connection> connection_;
};

/// Returns the number in the first column of the first row.
[[nodiscard]] std::int64_t numberFrom(Connection& connection, const std::string& sql);

/// Returns the fault with which `action` is refused; fails the test if it is not.
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

/// Error code and text with which an action is refused.
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

/// Disables every guard of a record: triggers, references, checks.
void disarm(Connection& connection);

/// Verifies rows, trail and schema; returns one sentence per finding.
[[nodiscard]] std::vector<std::string> allFindings(Connection& connection);

/// Appends an entry with a well-formed seal of every row whose seal no longer matches, as an expert attacker
/// would.
void forgeSeals(Connection& connection, AuditAction action, AuditObject object, const std::string& objectId);

/// Rewrites all seals to match the present rows, and the chain to be consistent.
void rewriteTrail(Connection& connection);

}  // namespace torsio
