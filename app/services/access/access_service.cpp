// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/access_service.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/sign_in_steps.h"
#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "app/services/base/identifiers.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/site.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

AccessRepository repository(SessionContext& session) {
  return AccessRepository(session.connection(), session.passwordCost());
}

/// Throws unless an active administrator would remain.
void requireRemainingAdministrator(SessionContext& session, const std::string& withoutUser) {
  const std::vector<UserAccount> all = repository(session).users();
  const bool remains = std::any_of(all.begin(), all.end(), [&](const UserAccount& user) {
    return user.id != withoutUser && isActiveAdministrator(user);
  });
  if (remains) {
    return;
  }
  refuseParameter(Text::tr("this is the last administrator who can sign in"), "",
                  Text::tr("Make somebody else an administrator first"));
}

/// The secret of the second factor, sealed under the new password; empty: there is none, or the old password
/// does not open it.
std::string resealedCode(Connection& connection, const PasswordChange& change, const UserId& userId,
                         PasswordCost cost) {
  const std::optional<SecondFactor> factor = SecondFactorRepository(connection).find(userId);
  const std::string secret = factor ? openedCodeSecret(factor->sealed, change.oldPassword, userId) : "";
  return secret.empty() ? "" : sealedCodeSecret(secret, change.newPassword, userId, cost);
}

/// What an audit entry says of a second factor that a new password removed.
nlohmann::json removedJson(bool removed) {
  return removed ? nlohmann::json{{"second_factor", "removed"}} : nlohmann::json();
}

nlohmann::json rolesJson(const std::vector<std::string>& roles) {
  return {{"roles", roles}};
}

/// Throws if the person already has an account: nobody gets a second one.
void requireNoAccount(SessionContext& session, const PersonId& personId) {
  const std::string login = personId.empty() ? std::string() : repository(session).loginOf(personId);
  if (!login.empty()) {
    refuse(Text::tr("this person has the account %1 already", login), Text::tr("user"),
           Text::tr("Give that account the role, or switch it on again"));
  }
}

/// Throws unless the sign-in name is readable and typeable for everybody.
void requireLegible(const std::string& login) {
  if (login.empty()) {
    refuseParameter(Text::tr("the account has no sign-in name"), Text::tr("login"), Text::tr("Enter one"));
  }
  if (const Text flaw = flawOf(login, kLongestLogin); !flaw.empty()) {
    refuseParameter(Text::tr("the sign-in name %1", flaw), Text::tr("login"), Text::tr("Type it again"));
  }
}

/// Throws if the sign-in name could be mistaken for another one in lists, reports or the audit trail.
void requireUnlikeOthers(const AccessRepository& access, const std::string& login) {
  const std::string likeness = likenessOf(login);
  for (const std::string& other : access.logins()) {
    if (other != login && likenessOf(other) == likeness) {
      refuseParameter(Text::tr("the sign-in name %1 looks like %2, but is another", login, other),
                      Text::tr("login"), Text::tr("Choose a name that cannot be confused with it"));
    }
  }
}

}  // namespace

UserAccount userOf(std::span<const UserAccount> all, const UserId& userId) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const UserAccount& user) { return user.id == userId; });
  if (found == all.end()) {
    refuseParameter(Text::tr("there is no such user"), userId, Text::tr("Choose one from the list"));
  }
  return *found;
}

bool needsFirstRun(Connection& connection) {
  return AccessRepository(connection).users().empty();
}

void setUpCentre(SessionContext& session, const FirstRun& first) {
  if (first.centre.empty()) {
    refuseParameter(Text::tr("the centre has no name"), Text::tr("centre"),
                    Text::tr("Enter the name of your centre"));
  }
  if (first.login.empty()) {
    refuseParameter(Text::tr("the administrator has no sign-in name"), Text::tr("login"),
                    Text::tr("Enter one"));
  }
  requireLegible(first.login);
  AccessRepository access = signInAccess(session);
  const SealedSecret password = access.sealPassword(first.login, first.password);
  const std::int64_t now_us = session.now_us();
  Transaction transaction(session.connectionWithoutRight());
  if (!needsFirstRun(session.connectionWithoutRight())) {
    throw Error(ErrorCode::kPermission, Text::tr("this database belongs to a centre already"),
                Text::tr("first run"), Text::tr("Sign in, or choose another database"));
  }
  const Centre centre{session.ids().newUuid(), first.centre, now_us, false};
  StudyRepository(session.connectionWithoutRight()).setCentre(centre);
  SettingRepository settings(session.connectionWithoutRight());
  settings.set(kCentreCode.name, firstCentreCode(centre.name, centre.id), now_us);
  settings.set(kLanguage.name, first.language, now_us);
  const UserId userId = session.ids().newUuid();
  access.addUser({.id = userId, .login = first.login, .createdUtc_us = now_us, .roles = {kAdministratorRole}},
                 password);
  access.setPassword(userId, password, false);
  session.note(AuditAction::kCentreSetUp, AuditObject::kAppUser, userId, rolesJson({kAdministratorRole}));
  transaction.commit();
}

SignInAnswer signIn(SessionContext& session, const std::string& login, const std::string& password,
                    const std::string& place, const std::string& code) {
  const SignInAnswer answer =
      answerTo(session, login,
               signInAccess(session).signIn(login, password, session.now_us(), placeOf(session, place), code),
               SignInKind::kAnew);
  if (answer.outcome == SignIn::kMustEnrol) {
    endServerSession(session, answer.actor.serverToken);
  }
  return answer;
}

SignInAnswer signInAgain(SessionContext& session, const std::string& login, const std::string& password) {
  return answerTo(session, login,
                  signInAccess(session).signInAgain(login, password, session.now_us(), placeOf(session, {})),
                  SignInKind::kAgain);
}

SignInAnswer signInForPractice(SessionContext& session, const std::string& login, const std::string& pin) {
  return answerTo(session, login,
                  signInAccess(session).signInForPractice(login, pin, session.now_us(), placeOf(session, {})),
                  SignInKind::kPractice);
}

SignInAnswer changeOwnPassword(SessionContext& session, const PasswordChange& change,
                               const std::string& place) {
  AccessRepository access = signInAccess(session);
  SignInResult known =
      access.signIn(change.login, change.oldPassword, session.now_us(), placeOf(session, place), change.code);
  if (known.outcome != SignIn::kOk && known.outcome != SignIn::kMustChange) {
    if (known.outcome == SignIn::kCodeNeeded) {
      refuseUnpassed(known, session.now_us());
    }
    noteFailure(session, change.login, known.outcome, "password");
    if (known.outcome == SignIn::kCodeWrong) {
      refuseUnpassed(known, session.now_us());
    }
    throw Error(ErrorCode::kPermission, Text::tr("the present password is not right"), Text::tr("password"),
                Text::tr("Try again"));
  }
  if (change.newPassword == change.oldPassword) {
    refuseParameter(Text::tr("the new password is the old one"), Text::tr("password"),
                    Text::tr("Choose another one"));
  }
  const SealedSecret password = access.sealPassword(change.login, change.newPassword);
  Connection& connection = session.connectionWithoutRight();
  tellSession(connection, known.serverToken);
  const std::string code = known.hasSecondFactor
                               ? resealedCode(connection, change, known.userId, session.passwordCost())
                               : std::string();
  Transaction transaction(connection);
  if (known.hasSecondFactor && code.empty()) {
    access.setPassword(known.userId, password, false);  // a secret that nothing opens is of no use
  } else {
    access.changePassword(known.userId, password, code);
  }
  known.outcome = SignIn::kOk;
  known.hasSecondFactor = !code.empty();
  const SignInAnswer signedIn = answerTo(session, change.login, known, SignInKind::kAnew);
  session.note(AuditAction::kUserChangePassword, AuditObject::kAppUser, known.userId);
  transaction.commit();
  if (signedIn.outcome == SignIn::kMustEnrol) {
    endServerSession(session, signedIn.actor.serverToken);
  }
  return signedIn;
}

SignInAnswer checkOwnPassword(SessionContext& session, const std::string& password) {
  const std::string login = session.actor().login;
  const SignInResult result =
      signInAccess(session).signInAgain(login, password, session.now_us(), placeWithin(session));
  if (result.outcome != SignIn::kOk) {
    noteFailure(session, login, result.outcome, "password");
  }
  endServerSession(session, result.serverToken);
  return {result.outcome, {}, result.waitUntilUtc_us};
}

Actor simulatedPerson(SessionContext& session, SimulatedRole role) {
  session.require(Operation::kUserManage);
  const bool physician = role == SimulatedRole::kPhysician;
  const std::vector<std::string> wanted{physician ? "rater" : "trainee"};
  for (const UserAccount& user : repository(session).users()) {
    if (!user.demonstration || !user.active || user.roles != wanted) {
      continue;
    }
    session.note(AuditAction::kUserSignIn, AuditObject::kAppUser, user.id, {},
                 physician ? "an administrator entered as a simulated physician"
                           : "an administrator entered as a simulated trainee");
    return {.userId = user.id,
            .login = user.login,
            .personId = user.personId,
            .roles = user.roles,
            .passwordShownUtc_us = kNoPasswordToShow,
            .serverToken = repository(session).openSimulatedSession(user.id)};
  }
  refuseParameter(physician ? Text::tr("there is no simulated physician here")
                            : Text::tr("there is no simulated trainee here"),
                  Text::tr("people"),
                  Text::tr("Set up a centre with a demonstration cohort, or explore with sample data before "
                           "the first set-up"));
}

void signOut(SessionContext& session) {
  if (!session.actor().userId.empty()) {
    session.note(AuditAction::kUserSignOut, AuditObject::kAppUser, session.actor().userId);
    endServerSession(session, session.actor().serverToken);
  }
  session.setActor({});
}

UserId addUser(SessionContext& session, const NewUser& user) {
  session.require(Operation::kUserManage);
  requireNoAccount(session, user.personId);
  const bool opens = !user.startPassword.empty();
  const UserAccount account{
      .personId = user.personId, .demonstration = user.demonstration, .roles = user.roles};
  if (givesGuardedRole(session, user.demonstration, {}, user.roles) ||
      (opens && passwordNeedsTwo(session, account))) {
    throw SecondPersonNeeded(DutyAct::kGrantRoles, user.login);
  }
  requireLegible(user.login);
  const UserId id = session.ids().newUuid();
  AccessRepository access = repository(session);
  requireUnlikeOthers(access, user.login);
  const SealedSecret password = opens ? access.sealPassword(user.login, user.startPassword) : SealedSecret();
  Transaction transaction(session.connection());
  access.addUser({.id = id,
                  .login = user.login,
                  .personId = user.personId,
                  .createdUtc_us = session.now_us(),
                  .demonstration = user.demonstration,
                  .roles = user.roles},
                 password);
  session.note(AuditAction::kUserAdd, AuditObject::kAppUser, id, rolesJson(user.roles));
  transaction.commit();
  return id;
}

std::vector<UserAccount> users(SessionContext& session) {
  session.require(Operation::kUserManage);
  return repository(session).users();
}

void setUserRoles(SessionContext& session, const UserId& userId, const std::vector<std::string>& roles,
                  const std::string& reason) {
  session.require(Operation::kUserManage);
  Transaction transaction(session.connection());
  const UserAccount before = userOf(repository(session).users(), userId);
  const bool keepsRole = std::find(roles.begin(), roles.end(), kAdministratorRole) != roles.end();
  if (isActiveAdministrator(before) && !keepsRole) {
    requireRemainingAdministrator(session, userId);
  }
  if (givesGuardedRole(session, before.demonstration, before.roles, roles) ||
      takesAdministrator(session, before, roles)) {
    throw SecondPersonNeeded(DutyAct::kGrantRoles, userId);
  }
  repository(session).setRoles(userId, roles);
  session.noteChange(AuditAction::kUserSetRoles, AuditObject::kAppUser, userId, rolesJson(before.roles),
                     rolesJson(roles), reason);
  transaction.commit();
}

void setUserActive(SessionContext& session, const UserId& userId, bool active, const std::string& reason) {
  session.require(Operation::kUserManage);
  Transaction transaction(session.connection());
  const UserAccount before = userOf(repository(session).users(), userId);
  if (!active && isActiveAdministrator(before)) {
    requireRemainingAdministrator(session, userId);
  }
  if (!active && takesAdministrator(session, before, {})) {
    throw Error(ErrorCode::kPermission, Text::tr("nobody disables an administrator alone"), before.login,
                Text::tr("Change the roles first: two people take that of an administrator away"));
  }
  repository(session).setActive(userId, active);
  session.note(active ? AuditAction::kUserEnable : AuditAction::kUserDisable, AuditObject::kAppUser, userId,
               {}, reason);
  transaction.commit();
}

void resetPassword(SessionContext& session, const UserId& userId, const std::string& startPassword,
                   const std::string& reason) {
  session.require(Operation::kUserManage);
  AccessRepository access = repository(session);
  const UserAccount user = userOf(access.users(), userId);
  if (passwordNeedsTwo(session, user)) {
    throw SecondPersonNeeded(DutyAct::kResetPassword, userId);
  }
  const SealedSecret password = access.sealPassword(user.login, startPassword);
  Transaction transaction(session.connection());
  const bool removed = access.setPassword(userId, password, true);
  session.note(AuditAction::kUserResetPassword, AuditObject::kAppUser, userId, removedJson(removed), reason);
  transaction.commit();
}

void setOwnPin(SessionContext& session, const std::string& pin) {
  session.require(Operation::kPractice);
  if (session.actor().practiceOnly) {
    throw Error(ErrorCode::kPermission, Text::tr("you signed in with the PIN"), Text::tr("PIN"),
                Text::tr("Sign in with your password to change it"));
  }
  AccessRepository access = repository(session);
  const SealedSecret sealed = access.sealPin(pin);
  Transaction transaction(session.connection());
  access.setPin(session.actor().userId, sealed);
  session.note(pin.empty() ? AuditAction::kUserRemovePin : AuditAction::kUserSetPin, AuditObject::kAppUser,
               session.actor().userId);
  transaction.commit();
}

Home homeOf(const Actor& actor) {
  if (actor.practiceOnly) {
    return Home::kStation;
  }
  for (const char* role : {kAdministratorRole, "allocator", "statistician"}) {
    if (actor.hasRole(role)) {
      return Home::kAdministrator;
    }
  }
  return actor.hasRole("rater") ? Home::kReview : Home::kStation;
}

std::string passwordStamp(SessionContext& session, const UserId& userId) {
  return AccessRepository(session.connectionWithoutRight()).passwordStamp(userId);
}

void requireSessionsOfOthers(SessionContext& session) {
  session.require(Operation::kUserManage);
}

void endBrowserSessions(SessionContext& session, const UserId& userId) {
  session.require(Operation::kUserManage);
  Transaction transaction(session.connection());
  AccessRepository(session.connection()).endSessions(userId);
  noteEndedSessions(session, userId);
  transaction.commit();
}

void noteEndedSessions(SessionContext& session, const UserId& userId) {
  session.require(Operation::kUserManage);
  session.note(AuditAction::kUserEndSessions, AuditObject::kAppUser, userId);
}

}  // namespace torsio
