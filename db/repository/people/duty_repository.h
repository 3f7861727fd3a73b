// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/people/duty.h"
#include "db/connection/connection.h"

namespace torsio {

/// Requests for acts that need two people, and what became of them. Both are append-only.
class DutyRepository {
 public:
  explicit DutyRepository(Connection& connection) : connection_(connection) {}

  void add(const DutyRequest& request);
  /// Nobody has decided about them, and they were made at or after `sinceUtc_us`. Oldest first.
  [[nodiscard]] std::vector<DutyRequest> open(std::int64_t sinceUtc_us) const;
  /// Throws DbError (kUnique) when somebody was faster.
  void decide(const std::string& requestId, DutyDecision decision, const UserId& decidedBy,
              std::int64_t utc_us);

 private:
  Connection& connection_;
};

}  // namespace torsio
