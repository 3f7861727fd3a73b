// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/person_request.h"

namespace torsio {

/// Requests a copy of the actor's own record, or its erasure; administrators see it in their list. Audited.
/// kTrialViewOwn. Throws Error{kBadParameter} if the actor is not a person of the record, or the same request
/// is pending.
void requestAboutOwnRecord(SessionContext& session, PersonRequestKind kind);
/// Withdraws a pending request. Audited. kTrialViewOwn. Throws Error{kBadData} if it is not the actor's, or
/// answered already.
void takeBackOwnRequest(SessionContext& session, const std::string& requestId);
/// Returns the actor's requests, latest first. kTrialViewOwn.
[[nodiscard]] std::vector<PersonRequest> ownRequests(SessionContext& session);

/// Returns everybody's requests, latest first. kPersonExport.
[[nodiscard]] std::vector<PersonRequest> personRequests(SessionContext& session);
/// Marks a request as done, or declined with a reason. Audited. kPersonExport. Throws Error{kBadParameter}:
/// declined without a reason; {kBadData}: answered already.
void answerPersonRequest(SessionContext& session, const std::string& requestId, bool done,
                         const std::string& reason);

}  // namespace torsio
