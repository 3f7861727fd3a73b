// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/sign_in_steps.h"

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/second_factor.h"
#include "db/connection/connection.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

const char* failureName(SignIn outcome) {
  switch (outcome) {
    case SignIn::kWait:
      return "too many failures";
    case SignIn::kDisabled:
      return "disabled";
    default:
      return "wrong";
  }
}

[[noreturn]] void refusePermission(const Text& what, const Text& where, const Text& remedy) {
  throw Error(ErrorCode::kPermission, what, where, remedy);
}

/// What the audit trail says beside a sign-in.
nlohmann::json factorJson(const SignInResult& result) {
  return result.hasSecondFactor
             ? nlohmann::json{{"second_factor", result.byRecoveryCode ? "recovery code" : "code"}}
             : nlohmann::json();
}

}  // namespace

AccessRepository signInAccess(SessionContext& session) {
  return AccessRepository(session.connectionWithoutRight(), session.passwordCost());
}

std::string placeOf(const SessionContext& session, const std::string& place) {
  return place.empty() ? "station " + session.station() : place;
}

std::string placeWithin(const SessionContext& session) {
  return "signed in at " + session.station();
}

void noteFailure(SessionContext& session, const std::string& login, SignIn outcome, const char* with) {
  UserId userId;
  for (const UserAccount& user : signInAccess(session).users()) {
    if (user.login == login) {
      userId = user.id;
    }
  }
  session.note(AuditAction::kUserSignInFailed, AuditObject::kAppUser, userId,
               {{"outcome", failureName(outcome)}, {"with", outcome == SignIn::kCodeWrong ? "code" : with}});
}

void refuseUnpassed(const SignInResult& result, std::int64_t now_us) {
  switch (result.outcome) {
    case SignIn::kCodeNeeded:
      refusePermission(Text::tr("the code of your second factor is missing"), Text::tr("code"),
                       Text::tr("Type the six digits that your app shows, or a recovery code"));
    case SignIn::kCodeWrong:
      refusePermission(Text::tr("the code is not right, or was used before"), Text::tr("code"),
                       Text::tr("Wait for the next one, or use a recovery code"));
    case SignIn::kWait:
      refusePermission(Text::tr("too many failures: wait %1", clockLeftText(result.waitUntilUtc_us - now_us)),
                       Text::tr("password"), Text::tr("Then try again"));
    case SignIn::kMustChange:
      refusePermission(Text::tr("the start password must be changed first"), Text::tr("password"),
                       Text::tr("Sign in, and choose a password of your own"));
    default:
      refusePermission(Text::tr("the password is not right"), Text::tr("password"), Text::tr("Try again"));
  }
}

void endServerSession(SessionContext& session, const std::string& token) {
  if (!token.empty()) {
    Connection& connection = session.connectionWithoutRight();
    tellSession(connection, token);
    AccessRepository(connection).endOwnServerSession();
  }
}

SignInAnswer answerTo(SessionContext& session, const std::string& login, const SignInResult& result,
                      SignInKind kind) {
  const bool practiceOnly = kind == SignInKind::kPractice;
  SignInAnswer answer{result.outcome, {}, result.waitUntilUtc_us};
  if (result.outcome == SignIn::kCodeNeeded) {
    return answer;  // nothing has failed yet
  }
  if (result.outcome != SignIn::kOk && result.outcome != SignIn::kMustChange) {
    noteFailure(session, login, result.outcome, practiceOnly ? "pin" : "password");
    return answer;
  }
  const UserAccount user = userOf(signInAccess(session).users(), result.userId);
  // If every signature asks for the password, the sign-in itself does not count for any.
  const bool signs = !practiceOnly && centreSetting<kSignMinutes>(session.connectionWithoutRight()) > 0;
  answer.actor = {user.id, user.login, user.personId, user.roles, practiceOnly, signs ? session.now_us() : 0};
  answer.actor.serverToken = result.serverToken;
  if (result.outcome == SignIn::kOk && kind == SignInKind::kAnew && !result.hasSecondFactor &&
      secondFactorIsAsked(session.connectionWithoutRight(), user.roles)) {
    answer.outcome = SignIn::kMustEnrol;
  } else if (result.outcome == SignIn::kOk) {
    session.setActor(answer.actor);
    session.note(practiceOnly ? AuditAction::kUserSignInPractice : AuditAction::kUserSignIn,
                 AuditObject::kAppUser, user.id, factorJson(result));
  }
  return answer;
}

}  // namespace torsio
