// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"

namespace torsio {

inline constexpr std::int64_t kRecordTime_us = 1'763'712'000'000'000;  // 2025-11-21 08:00 UTC

/// A record in a temporary folder with a clock and ids of its own, and people and accounts to put into it:
/// what the centres of the tests are built on.
class TestRecord {
 public:
  TestRecord(const TestRecord&) = delete;
  TestRecord& operator=(const TestRecord&) = delete;

  [[nodiscard]] Connection& connection() { return *connection_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::string& locator() const { return locator_; }
  void passTime_us(std::int64_t span_us) { now_us_ += span_us; }
  [[nodiscard]] std::int64_t now_us() const { return now_us_; }
  /// Returns the user with this login, who has just entered the password; nobody if there is none.
  [[nodiscard]] Actor actorOf(const std::string& login);

 protected:
  /// Creates a record, at `locator` or in a file, with ids from `seed`.
  explicit TestRecord(std::uint64_t seed, const std::string& locator = {});
  /// Opens an existing record in `folder`, like another program.
  explicit TestRecord(const std::filesystem::path& folder);
  ~TestRecord();

  [[nodiscard]] IdSource& ids() { return *ids_; }
  /// Returns a session on the shared connection.
  [[nodiscard]] std::unique_ptr<SessionContext> sessionOf(const std::string& station, const Actor& actor);
  PersonId addTrainee(const std::string& code, bool demonstration = false);
  /// Stores a rater of the class "chief"; addChiefClass() before.
  PersonId addChief(const std::string& code);
  void addChiefClass(const std::string& label);
  /// Stores a user who need not change the password.
  UserId addUser(const std::string& login, const PersonId& personId, const std::string& role,
                 const std::string& password);

 private:
  void open();
  /// With TORSIO_TEST_AS_STATION, a record without a locator is on the server of TORSIO_TEST_POSTGRES: the
  /// owner fills it, and sessions use the account of the stations.
  void openOnServer();

  bool owner_ = true;
  std::string schema_;  ///< on the server; empty: a file
  std::unique_ptr<Connection> station_;
  std::filesystem::path folder_;
  std::string locator_;
  std::int64_t now_us_ = kRecordTime_us;
  std::unique_ptr<IdSource> ids_;
  std::unique_ptr<Connection> connection_;
};

}  // namespace torsio
