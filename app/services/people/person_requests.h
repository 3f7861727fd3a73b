// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/person_request.h"

namespace torsio {

/// The actor asks for a copy of their own record, or that it be erased; whoever is in charge finds it in
/// their list. Audited. kTrialViewOwn. Throws Error{kBadParameter}: nobody of the record, or the same
/// waits already.
void requestAboutOwnRecord(SessionContext& session, PersonRequestKind kind);
/// While it waits. Audited. kTrialViewOwn. Throws Error{kBadData}: not the actor's, or answered already.
void takeBackOwnRequest(SessionContext& session, const std::string& requestId);
/// The actor's, newest first. kTrialViewOwn.
[[nodiscard]] std::vector<PersonRequest> ownRequests(SessionContext& session);

/// Everybody's, newest first. kPersonExport.
[[nodiscard]] std::vector<PersonRequest> personRequests(SessionContext& session);
/// Says what became of a request: done, or declined with a reason. Audited. kPersonExport. Throws
/// Error{kBadParameter}: declined without a reason; {kBadData}: answered already.
void answerPersonRequest(SessionContext& session, const std::string& requestId, bool done,
                         const std::string& reason);

}  // namespace torsio
