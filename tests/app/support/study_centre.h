// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"

namespace torsio::testing {

inline constexpr std::int64_t kStudyTime_us = 1'763'712'000'000'000;  // 2025-11-21 08:00 UTC
/// Of every user here; long enough and without a known pattern.
inline constexpr const char* kStudyPassword = "four walls and a lamp";

/// An empty centre in a temporary SQLite file, or at `locator`, with one user of each role ("administrator",
/// "allocator", "statistician", "rater", "trainee"), signed in as nobody.
class StudyCentre {
 public:
  explicit StudyCentre(const std::string& locator = {});
  ~StudyCentre();
  StudyCentre(const StudyCentre&) = delete;
  StudyCentre& operator=(const StudyCentre&) = delete;

  [[nodiscard]] SessionContext& session() {
    session_->beginCall();
    return *session_;
  }
  [[nodiscard]] Connection& connection() { return *connection_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path assets() const {
    return std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  }
  /// Signs in the user of this role, or nobody for "".
  SessionContext& as(const std::string& role);
  /// Signs in the user "rater" as this rater of the record.
  SessionContext& asRater(const RaterId& raterId);
  void passTime_us(std::int64_t span_us) { now_us_ += span_us; }

  /// Stores trainees T-01 .. with sex and level, and raters of the class "chief" R-01 ..; as the
  /// administrator.
  std::vector<TraineeId> addTrainees(std::size_t count);
  std::vector<RaterId> addChiefs(std::size_t count);
  /// Stores and runs the paper's curriculum. Returns the version.
  std::string runPaperCurriculum();
  /// Stores the shipped rubric. Returns the revision.
  std::string addPaperRubric();

  /// Returns the number of rows of every table, and the hash of the last audit entry: what a refused call
  /// must not change.
  [[nodiscard]] std::map<std::string, std::int64_t> rowCounts();
  [[nodiscard]] std::int64_t audited(const std::string& action);

 private:
  std::filesystem::path folder_;
  std::unique_ptr<Connection> connection_;
  SeededIdSource ids_{7};
  std::int64_t now_us_ = kStudyTime_us;
  std::unique_ptr<SessionContext> session_;
  std::map<std::string, Actor> actors_;
};

}  // namespace torsio::testing
