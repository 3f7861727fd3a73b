// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/access/access_service.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr const char* kAdministrator = "administrator";

AccessRepository repository(SessionContext& workplace) {
  return AccessRepository(workplace.connection(), workplace.passwordCost());
}

StoredUser userOf(SessionContext& workplace, const std::string& userId) {
  for (const StoredUser& user : repository(workplace).users()) {
    if (user.id == userId) {
      return user;
    }
  }
  throw Error(ErrorCode::kBadParameter, "there is no such user", userId, "Choose one from the list");
}

bool isActiveAdministrator(const StoredUser& user) {
  return user.active && std::find(user.roles.begin(), user.roles.end(), kAdministrator) != user.roles.end();
}

/// Somebody must be left who can let others in.
void keepAnAdministrator(SessionContext& workplace, const std::string& withoutUser) {
  const std::vector<StoredUser> all = repository(workplace).users();
  const bool remains = std::any_of(all.begin(), all.end(), [&](const StoredUser& user) {
    return user.id != withoutUser && isActiveAdministrator(user);
  });
  if (remains) {
    return;
  }
  throw Error(ErrorCode::kBadParameter, "this is the last administrator who can sign in", "",
              "Make somebody else an administrator first");
}

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

/// A failure, without what was typed: an unknown login may be a password in the wrong field.
void noteFailure(SessionContext& workplace, const std::string& login, SignIn outcome, const char* with) {
  std::string userId;
  for (const StoredUser& user : repository(workplace).users()) {
    if (user.login == login) {
      userId = user.id;
    }
  }
  workplace.note({.action = "user.sign_in_failed",
                  .objectKind = "app_user",
                  .objectId = userId,
                  .newJson = nlohmann::json{{"outcome", failureName(outcome)}, {"with", with}}.dump()});
}

SignInAnswer answer(SessionContext& workplace, const std::string& login, const SignInResult& result,
                    bool practiceOnly) {
  SignInAnswer answer{result.outcome, {}, result.waitUntilUtc_us};
  if (result.outcome != SignIn::kOk && result.outcome != SignIn::kMustChange) {
    noteFailure(workplace, login, result.outcome, practiceOnly ? "pin" : "password");
    return answer;
  }
  const StoredUser user = userOf(workplace, result.userId);
  answer.actor = {user.id, user.login, user.personId, user.roles, practiceOnly};
  if (result.outcome == SignIn::kOk) {
    workplace.setActor(answer.actor);
    workplace.note({.action = practiceOnly ? "user.sign_in_practice" : "user.sign_in",
                    .objectKind = "app_user",
                    .objectId = user.id});
  }
  return answer;
}

std::string rolesJson(const std::vector<std::string>& roles) {
  return nlohmann::json{{"roles", roles}}.dump();
}

}  // namespace

bool needsFirstRun(Connection& connection) {
  return AccessRepository(connection).users().empty();
}

void setUpCentre(SessionContext& workplace, const FirstRun& first) {
  if (first.centre.empty()) {
    throw Error(ErrorCode::kBadParameter, "the centre has no name", "centre",
                "Enter the name of your centre");
  }
  if (first.login.empty()) {
    throw Error(ErrorCode::kBadParameter, "the administrator has no sign-in name", "login", "Enter one");
  }
  AccessRepository access = repository(workplace);
  const SealedSecret password = access.sealPassword(first.login, first.password);
  const std::int64_t now_us = workplace.now_us();
  Transaction transaction(workplace.connection());
  if (!needsFirstRun(workplace.connection())) {
    throw Error(ErrorCode::kPermission, "this database belongs to a centre already", "first run",
                "Sign in, or choose another database");
  }
  StudyRepository(workplace.connection()).setCentre({workplace.ids().newUuid(), first.centre, now_us, false});
  SettingRepository settings(workplace.connection());
  settings.set("language", first.language, now_us);
  const std::string userId = workplace.ids().newUuid();
  access.addUser({.id = userId, .login = first.login, .createdUtc_us = now_us, .roles = {kAdministrator}},
                 password);
  access.setPassword(userId, password, false);
  workplace.note({.action = "centre.set_up",
                  .objectKind = "app_user",
                  .objectId = userId,
                  .newJson = rolesJson({kAdministrator})});
  transaction.commit();
}

SignInAnswer signIn(SessionContext& workplace, const std::string& login, const std::string& password) {
  return answer(workplace, login, repository(workplace).signIn(login, password, workplace.now_us()), false);
}

SignInAnswer signInForPractice(SessionContext& workplace, const std::string& login, const std::string& pin) {
  return answer(workplace, login, repository(workplace).signInForPractice(login, pin, workplace.now_us()),
                true);
}

SignInAnswer changeOwnPassword(SessionContext& workplace, const std::string& login,
                               const std::string& oldPassword, const std::string& newPassword) {
  AccessRepository access = repository(workplace);
  const SignInResult old = access.signIn(login, oldPassword, workplace.now_us());
  if (old.outcome != SignIn::kOk && old.outcome != SignIn::kMustChange) {
    noteFailure(workplace, login, old.outcome, "password");
    throw Error(ErrorCode::kPermission, "the present password is not right", "password", "Try again");
  }
  if (newPassword == oldPassword) {
    throw Error(ErrorCode::kBadParameter, "the new password is the old one", "password",
                "Choose another one");
  }
  const SealedSecret password = access.sealPassword(login, newPassword);
  Transaction transaction(workplace.connection());
  access.setPassword(old.userId, password, false);
  SignInAnswer signedIn = answer(workplace, login, {SignIn::kOk, old.userId}, false);
  workplace.note({.action = "user.change_password", .objectKind = "app_user", .objectId = old.userId});
  transaction.commit();
  return signedIn;
}

SignInAnswer unlock(SessionContext& workplace, const std::string& secret) {
  const Actor& actor = workplace.actor();
  if (actor.userId.empty()) {
    throw Error(ErrorCode::kPermission, "nobody is signed in", "lock", "Sign in first");
  }
  AccessRepository access = repository(workplace);
  const SignInResult result = actor.practiceOnly
                                  ? access.signInForPractice(actor.login, secret, workplace.now_us())
                                  : access.signIn(actor.login, secret, workplace.now_us());
  SignInAnswer unlocked{result.outcome, {}, result.waitUntilUtc_us};
  if (result.outcome == SignIn::kOk || result.outcome == SignIn::kMustChange) {
    unlocked.actor = actor;
    workplace.note({.action = "user.unlock", .objectKind = "app_user", .objectId = actor.userId});
  } else {
    noteFailure(workplace, actor.login, result.outcome, actor.practiceOnly ? "pin" : "password");
  }
  return unlocked;
}

void signOut(SessionContext& workplace) {
  if (!workplace.actor().userId.empty()) {
    workplace.note(
        {.action = "user.sign_out", .objectKind = "app_user", .objectId = workplace.actor().userId});
  }
  workplace.setActor({});
}

std::string addUser(SessionContext& workplace, const NewUser& user) {
  workplace.require(Operation::kUserManage);
  const std::string id = workplace.ids().newUuid();
  AccessRepository access = repository(workplace);
  const SealedSecret password = access.sealPassword(user.login, user.startPassword);
  Transaction transaction(workplace.connection());
  access.addUser({.id = id,
                  .login = user.login,
                  .personId = user.personId,
                  .createdUtc_us = workplace.now_us(),
                  .demonstration = user.demonstration,
                  .roles = user.roles},
                 password);
  workplace.note(
      {.action = "user.add", .objectKind = "app_user", .objectId = id, .newJson = rolesJson(user.roles)});
  transaction.commit();
  return id;
}

std::vector<StoredUser> users(SessionContext& workplace) {
  workplace.require(Operation::kUserManage);
  return repository(workplace).users();
}

void setUserRoles(SessionContext& workplace, const std::string& userId, const std::vector<std::string>& roles,
                  const std::string& reason) {
  workplace.require(Operation::kUserManage);
  Transaction transaction(workplace.connection());
  const StoredUser before = userOf(workplace, userId);
  const bool keepsRole = std::find(roles.begin(), roles.end(), kAdministrator) != roles.end();
  if (isActiveAdministrator(before) && !keepsRole) {
    keepAnAdministrator(workplace, userId);
  }
  repository(workplace).setRoles(userId, roles);
  workplace.note({.action = "user.set_roles",
                  .objectKind = "app_user",
                  .objectId = userId,
                  .oldJson = rolesJson(before.roles),
                  .newJson = rolesJson(roles),
                  .reason = reason});
  transaction.commit();
}

void setUserActive(SessionContext& workplace, const std::string& userId, bool active,
                   const std::string& reason) {
  workplace.require(Operation::kUserManage);
  Transaction transaction(workplace.connection());
  if (!active && isActiveAdministrator(userOf(workplace, userId))) {
    keepAnAdministrator(workplace, userId);
  }
  repository(workplace).setActive(userId, active);
  workplace.note({.action = active ? "user.enable" : "user.disable",
                  .objectKind = "app_user",
                  .objectId = userId,
                  .reason = reason});
  transaction.commit();
}

void resetPassword(SessionContext& workplace, const std::string& userId, const std::string& startPassword,
                   const std::string& reason) {
  workplace.require(Operation::kUserManage);
  AccessRepository access = repository(workplace);
  const SealedSecret password = access.sealPassword(userOf(workplace, userId).login, startPassword);
  Transaction transaction(workplace.connection());
  access.setPassword(userId, password, true);
  workplace.note(
      {.action = "user.reset_password", .objectKind = "app_user", .objectId = userId, .reason = reason});
  transaction.commit();
}

void setOwnPin(SessionContext& workplace, const std::string& pin) {
  workplace.require(Operation::kPractice);
  if (workplace.actor().practiceOnly) {
    throw Error(ErrorCode::kPermission, "you came in with the PIN", "PIN",
                "Sign in with your password to change it");
  }
  AccessRepository access = repository(workplace);
  const SealedSecret sealed = access.sealPin(pin);
  Transaction transaction(workplace.connection());
  access.setPin(workplace.actor().userId, sealed);
  workplace.note({.action = pin.empty() ? "user.remove_pin" : "user.set_pin",
                  .objectKind = "app_user",
                  .objectId = workplace.actor().userId});
  transaction.commit();
}

Home homeOf(const Actor& actor) {
  if (actor.practiceOnly) {
    return Home::kStation;
  }
  for (const char* role : {kAdministrator, "allocator", "statistician"}) {
    if (actor.hasRole(role)) {
      return Home::kOffice;
    }
  }
  return actor.hasRole("rater") ? Home::kReview : Home::kStation;
}

}  // namespace torsio
