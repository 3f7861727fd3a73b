// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/live_call.h"
#include "db/connection/connection.h"

namespace torsio {

/// Who was called to the real arm, when, into which room. One call, one transaction.
class CallRepository {
 public:
  explicit CallRepository(Connection& connection) : connection_(connection) {}

  /// Throws DbError{kUnique} when another call is open in a room.
  void add(std::span<const LiveCall> calls);
  /// Once. Throws Error{kBadData} when the call is unknown or has ended already.
  void end(const LiveCallId& callId, bool cancelled, std::int64_t utc_us);
  /// Of a cohort, oldest first, cancelled ones too.
  [[nodiscard]] std::vector<LiveCall> calls(const CohortId& cohortId) const;
  /// In any cohort.
  [[nodiscard]] std::optional<LiveCall> openIn(const std::string& room) const;

  /// Tells whether the case was ever called, cancelled calls apart.
  [[nodiscard]] bool wasCalled(const EnrolmentId& enrolmentId, const std::string& occasionCode) const;
  /// The newest call of each case that a rater is asked about, cancelled calls apart, oldest first.
  [[nodiscard]] std::vector<CallNotice> noticesFor(const RaterId& raterId) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
