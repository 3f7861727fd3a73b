// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/base/progress.h"
#include "app/services/people/people_service.h"

namespace torsio {

/// Who trains or scores and cannot sign in yet, ordered by code. kUserManage.
[[nodiscard]] std::vector<PersonRow> peopleWithoutAccount(SessionContext& session);

/// An account for each of these people, in the order of their codes: the sign-in name is the code in small
/// letters (with a number behind it when somebody has that name), the roles follow from what the person does.
/// Each account is stored by itself, since sealing a password takes about a second; every stored one is put
/// into `made` at once, so that none is lost when `progress` or the database throws. Whoever has an account,
/// or left, is passed over. kUserManage.
void addAccounts(SessionContext& session, const std::vector<PersonId>& personIds,
                 std::vector<StartAccount>& made, const ProgressCallback& progress = {});

}  // namespace torsio
