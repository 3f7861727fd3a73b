// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/people/person_request.h"
#include "db/connection/connection.h"

namespace torsio {

/// What people asked for about their own records. One call, one transaction.
class RequestRepository {
 public:
  explicit RequestRepository(Connection& connection) : connection_(connection) {}

  void add(const PersonRequest& request);
  /// Throws Error{kBadData} when it was answered already.
  void answer(const std::string& requestId, PersonRequestAnswer answer, const std::string& reason,
              std::int64_t utc_us);
  /// Newest first.
  [[nodiscard]] std::vector<PersonRequest> all() const;

 private:
  Connection& connection_;
};

}  // namespace torsio
