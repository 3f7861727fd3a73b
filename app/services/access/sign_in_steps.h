// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/access_service.h"
#include "db/repository/people/access_repository.h"

namespace torsio {

// Steps that signing in, a change of password and a second factor have in common.

/// Opens accounts for sign-in: the secret being checked is the authorisation.
[[nodiscard]] AccessRepository signInAccess(SessionContext& session);
/// Returns where a secret is tried; without a place this station.
[[nodiscard]] std::string placeOf(const SessionContext& session, const std::string& place);
/// Returns the place of somebody who is signed in: whoever is not cannot make this one wait.
[[nodiscard]] std::string placeWithin(const SessionContext& session);
/// Audits a failure without the typed text: an unknown login may be a password typed into the wrong field.
/// `with`: "password", "pin".
void noteFailure(SessionContext& session, const std::string& login, SignIn outcome, const char* with);
/// Throws Error{kPermission} that says what an outcome other than kOk lacks; for whoever is known already.
[[noreturn]] void refuseUnpassed(const SignInResult& result, std::int64_t now_us);
/// Ends a session that a server opened only to compare a password.
void endServerSession(SessionContext& session, const std::string& token);
/// kAgain: past the lock, where no second factor is asked for.
enum class SignInKind { kAnew, kAgain, kPractice };
/// Says what a checked secret opens, audited; for kOk the session then belongs to the actor. kOk of kAnew
/// becomes kMustEnrol if the centre asks the account for a second factor that it has not.
[[nodiscard]] SignInAnswer answerTo(SessionContext& session, const std::string& login,
                                    const SignInResult& result, SignInKind kind);

}  // namespace torsio
