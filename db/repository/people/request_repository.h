// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/people/person_request.h"
#include "db/connection/connection.h"

namespace torsio {

/// People's requests about their own records. Each call is one transaction.
class RequestRepository {
 public:
  explicit RequestRepository(Connection& connection) : connection_(connection) {}

  void add(const PersonRequest& request);
  /// Throws Error{kBadData} if it was already answered.
  void answer(const std::string& requestId, PersonRequestAnswer answer, const std::string& reason,
              std::int64_t utc_us);
  /// Newest first.
  [[nodiscard]] std::vector<PersonRequest> all() const;

 private:
  Connection& connection_;
};

}  // namespace torsio
