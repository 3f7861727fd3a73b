// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/access/start_password.h"
#include "app/services/access/two_people.h"
#include "app/services/base/progress.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// Returns trainees and raters without an account, ordered by code. kUserManage.
[[nodiscard]] std::vector<PersonRow> peopleWithoutAccount(SessionContext& session);

/// Creates an account for each of these people in order of their codes: the sign-in name is the code in lower
/// case (with a number if that is taken), the roles follow from the person's. Each account is stored
/// separately, since hashing a password takes about a second, and appended to `made` at once, so that none is
/// lost if `progress` or the database throws. Skips people who have an account or left. kUserManage.
void addAccounts(SessionContext& session, const std::vector<PersonId>& personIds,
                 std::vector<StartAccount>& made, const ProgressCallback& progress = {});

/// Confirms other people's requests for start passwords or roles, and appends the second half of each to
/// `made` at once, like addAccounts(). kUserManage. Throws what confirmRequest() throws.
void confirmAccounts(SessionContext& session, std::span<const OpenRequest> requests,
                     std::vector<StartAccount>& made, const ProgressCallback& progress = {});

/// Returns whose accounts these requests are about, in their order and without passwords. kUserManage.
[[nodiscard]] std::vector<StartAccount> accountsOf(SessionContext& session,
                                                   std::span<const OpenRequest> requests);

}  // namespace torsio
