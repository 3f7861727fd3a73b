// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/connection.h"

namespace torsio {

/// Calls of trainees to the real arm. Each call is one transaction.
class CallRepository {
 public:
  explicit CallRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError{kUnique} if another call is open in a room.
  void add(std::span<const LiveCall> calls);
  /// Ends a call, once. Throws Error{kBadData} if it is unknown or has ended.
  void end(const LiveCallId& callId, bool cancelled, std::int64_t utc_us);
  /// Calls of a cohort, oldest first, including cancelled ones.
  [[nodiscard]] std::vector<LiveCall> calls(const CohortId& cohortId) const;
  /// The open call in a room, of any cohort.
  [[nodiscard]] std::optional<LiveCall> openIn(const std::string& room) const;

  /// True if the case was ever called; cancelled calls do not count.
  [[nodiscard]] bool wasCalled(const EnrolmentId& enrolmentId, const std::string& occasionCode) const;
  /// When a case was last called; cancelled calls do not count.
  [[nodiscard]] std::optional<std::int64_t> lastCalledUtc_us(const EnrolmentId& enrolmentId,
                                                             const std::string& occasionCode) const;
  /// The newest call of each case assigned to a rater, without cancelled ones, oldest first.
  [[nodiscard]] std::vector<CallNotice> noticesFor(const RaterId& raterId) const;
  /// Text that differs after each call, end and cancellation, of any cohort.
  [[nodiscard]] std::string stamp() const;

 private:
  Connection& connection_;
};

/// Paper sheets being typed in. Each call is one transaction.
class PaperRepository {
 public:
  explicit PaperRepository(Connection& connection) : connection_(connection) {}

  /// Replaces what the same person typed before.
  void put(const PaperEntry& entry);
  /// Entries of one sheet, oldest first.
  [[nodiscard]] std::vector<PaperEntry> of(const AssignmentId& assignmentId) const;
  /// Entries of a cohort, without rows.
  [[nodiscard]] std::vector<PaperEntry> ofCohort(const CohortId& cohortId) const;
  void remove(const AssignmentId& assignmentId);

 private:
  Connection& connection_;
};

}  // namespace torsio
