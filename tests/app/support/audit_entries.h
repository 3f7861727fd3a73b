// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"

namespace torsio {

/// Runs a change and expects that the latest audit entry is `action` by `userId`.
template <typename Change>
void expectAudited(Connection& connection, const UserId& userId, const std::string& action,
                   const Change& change) {
  AuditRepository audit(connection);
  const std::int64_t before = audit.length();

  change();

  EXPECT_GT(audit.length(), before) << action;
  const std::vector<AuditEntry> newest = audit.entries({.limit = 1});
  ASSERT_EQ(newest.size(), 1U) << action;
  EXPECT_EQ(newest.front().action, action);
  EXPECT_EQ(newest.front().actor, userId) << action;
}

}  // namespace torsio
