// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/two_people.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kRaterRole = "rater";

AccessRepository accountsOf(SessionContext& session) {
  return AccessRepository(session.connection(), session.passwordCost());
}

std::optional<UserAccount> findUser(SessionContext& session, const UserId& userId) {
  for (const UserAccount& user : accountsOf(session).users()) {
    if (user.id == userId) {
      return user;
    }
  }
  return std::nullopt;
}

/// Returns who could confirm: real administrators who may sign in.
std::vector<UserAccount> administrators(SessionContext& session) {
  std::vector<UserAccount> all = accountsOf(session).users();
  std::erase_if(all,
                [](const UserAccount& user) { return user.demonstration || !isActiveAdministrator(user); });
  return all;
}

/// Returns whether the role is that of a simulated physician, who signs nothing of the centre's
/// (signing.cpp). Every other role has access to real data.
bool isHarmless(bool demonstration, const std::string& role) {
  return demonstration && role == kRaterRole;
}

bool changesAccount(DutyAct act) {
  return act == DutyAct::kResetPassword || act == DutyAct::kGrantRoles || act == DutyAct::kInvite;
}

void requireRightTo(SessionContext& session, DutyAct act) {
  switch (act) {
    case DutyAct::kResetPassword:
    case DutyAct::kGrantRoles:
    case DutyAct::kInvite:
      return session.require(Operation::kUserManage);
    case DutyAct::kErase:
      return session.require(Operation::kPersonErase);
    case DutyAct::kRestore:
      return session.require(Operation::kDatabaseRestore);
    case DutyAct::kRevealAllocation:
      return session.requireEither(Operation::kAllocationReveal, Operation::kStudySetup);
    case DutyAct::kFreezeInterim:
      return session.require(Operation::kResultsCompute);
    case DutyAct::kOnePerson:
      return session.require(Operation::kSettingsEdit);
    case DutyAct::kEnd:
      break;
  }
  throw ContractError("no such act");
}

nlohmann::json detailOf(const DutyRequest& request) {
  return nlohmann::json::parse(request.detailJson, nullptr, false);
}

std::vector<std::string> rolesOf(const DutyRequest& request) {
  return detailOf(request).value("roles", std::vector<std::string>());
}

/// Returns whether the account gets no role that it does not have: its password stays, and its user may
/// confirm.
bool onlyTakesRoles(DutyAct act, const UserAccount& user, const std::vector<std::string>& roles) {
  return act == DutyAct::kGrantRoles && std::all_of(roles.begin(), roles.end(), [&](const std::string& role) {
           return std::find(user.roles.begin(), user.roles.end(), role) != user.roles.end();
         });
}

std::vector<DutyRequest> openIn(SessionContext& session) {
  return DutyRepository(session.connection()).open(session.now_us() - kRequestLife_us);
}

/// Returns whether nothing of a real person depends on an act; is_simulated_subject() on a server.
bool isSimulatedSubject(SessionContext& session, DutyAct act, const std::string& subject) {
  if (changesAccount(act)) {
    const std::optional<UserAccount> user = findUser(session, subject);
    return user && user->demonstration;
  }
  if (act == DutyAct::kErase) {
    const std::optional<Person> person = PeopleRepository(session.connection()).find(subject);
    return person && person->demonstration;
  }
  if (act != DutyAct::kRevealAllocation && act != DutyAct::kFreezeInterim) {
    return false;
  }
  const StudyRepository study(session.connection());
  for (const Cohort& cohort : study.cohorts()) {
    if (act == DutyAct::kFreezeInterim && cohort.id.text() == subject) {
      return cohort.demonstration;
    }
    if (act == DutyAct::kRevealAllocation) {
      for (const LockedDesign& design : study.designs(cohort.id)) {
        if (design.id.text() == subject) {
          return design.demonstration;
        }
      }
    }
  }
  return false;
}

Phrase onlySimulated() {
  return Text::tr(
      "an account of the demonstration asks for and confirms only what concerns simulated people");
}

/// Returns why the actor cannot confirm the request; empty if they can.
Text hindrance(SessionContext& session, const DutyRequest& request) {
  const Actor& actor = session.actor();
  if (request.requestedBy == actor.userId) {
    return Text::tr("you asked for this yourself");
  }
  const std::optional<UserAccount> asker = findUser(session, request.requestedBy);
  const std::optional<UserAccount> self = findUser(session, actor.userId);
  if (!asker || !asker->active) {
    return Text::tr("the person who asked for this may no longer sign in");
  }
  if (!actor.personId.empty() && asker->personId == actor.personId) {
    return Text::tr("you asked for this yourself, with another account");
  }
  if ((asker->demonstration || (self && self->demonstration)) &&
      !isSimulatedSubject(session, request.act, request.subject)) {
    return onlySimulated();
  }
  if (changesAccount(request.act) && request.subject == actor.userId.text() &&
      !(self && onlyTakesRoles(request.act, *self, rolesOf(request)))) {
    return Text::tr("this is your own account");
  }
  return {};
}

/// Returns the right with which a request is confirmed.
Operation rightToConfirm(DutyAct act) {
  switch (act) {
    case DutyAct::kErase:
      return Operation::kPersonErase;
    case DutyAct::kRestore:
      return Operation::kDatabaseRestore;
    case DutyAct::kRevealAllocation:
      return Operation::kAllocationReveal;
    case DutyAct::kFreezeInterim:
      return Operation::kResultsCompute;
    case DutyAct::kOnePerson:
      return Operation::kSettingsEdit;
    default:
      return Operation::kUserManage;
  }
}

void close(SessionContext& session, const DutyRequest& request, DutyDecision decision,
           const std::string& reason) {
  DutyRepository(session.connection()).decide(request.id, decision, session.actor().userId, session.now_us());
  session.note(decision == DutyDecision::kConfirmed ? AuditAction::kDutyConfirm : AuditAction::kDutyDecline,
               AuditObject::kDutyRequest, request.id,
               {{"act", storedText(request.act)},
                {"subject", request.subject},
                {"requested_by", request.requestedBy.text()}},
               reason);
}

DutyRequest openRequest(SessionContext& session, const std::string& requestId) {
  for (DutyRequest& request : openIn(session)) {
    if (request.id == requestId) {
      return std::move(request);
    }
  }
  refuse(Text::tr("this request is not open any more"), requestId, Text::tr("Read the list again"));
}

void confirm(SessionContext& session, const DutyRequest& request) {
  if (const Text why = hindrance(session, request); !why.str().empty()) {
    throw Error(ErrorCode::kPermission, why, Text::tr("two people"),
                Text::tr("Let another administrator confirm it"));
  }
  close(session, request, DutyDecision::kConfirmed, request.reason);
}

/// Returns whether the actor is the system, which owns the record and can do anything with it.
bool oneIsEnough(SessionContext& session) {
  return !session.actor().systemAccount.empty() || !needsTwoPeople(session.connection());
}

/// Returns another person's request for this act that the actor may confirm.
std::optional<DutyRequest> confirmable(SessionContext& session, DutyAct act, const std::string& subject) {
  for (DutyRequest& request : openIn(session)) {
    if (request.act == act && request.subject == subject && hindrance(session, request).str().empty()) {
      return std::move(request);
    }
  }
  return std::nullopt;
}

/// Sets the account's new start password and returns its second half, not yet shown.
std::string drawSecondHalf(SessionContext& session, const DutyRequest& request, const UserAccount& user,
                           const std::vector<std::string>* roles) {
  const std::string second = randomHalfPassword();
  AccessRepository access = accountsOf(session);
  const SealedSecret sealed =
      access.sealPassword(user.login, detailOf(request).value("first_half", "") + "-" + second);
  Transaction transaction(session.connection());
  confirm(session, request);
  const bool removed = access.setPassword(user.id, sealed, true);
  AuditNote note{.action = AuditAction::kUserResetPassword,
                 .objectKind = AuditObject::kAppUser,
                 .objectId = user.id,
                 .newJson = removed ? nlohmann::json{{"second_factor", "removed"}}.dump() : "",
                 .reason = request.reason};
  session.note(note);
  if (roles != nullptr) {
    access.setRoles(user.id, *roles);
    note.action = AuditAction::kUserSetRoles;
    note.oldJson = nlohmann::json{{"roles", user.roles}}.dump();
    note.newJson = nlohmann::json{{"roles", *roles}}.dump();
    session.note(note);
  }
  transaction.commit();
  return second;
}

void takeRoles(SessionContext& session, const DutyRequest& request, const UserAccount& user,
               const std::vector<std::string>& roles) {
  Transaction transaction(session.connection());
  confirm(session, request);
  accountsOf(session).setRoles(user.id, roles);
  session.noteChange(AuditAction::kUserSetRoles, AuditObject::kAppUser, user.id, {{"roles", user.roles}},
                     {{"roles", roles}}, request.reason);
  transaction.commit();
}

/// Creates the link for the requester's code.
std::string confirmInvitation(SessionContext& session, const DutyRequest& request, const UserAccount& user) {
  if (!user.active) {
    refuse(Text::tr("this account may not sign in"), user.login,
           Text::tr("Enable it first, or leave it out"));
  }
  Transaction transaction(session.connection());
  confirm(session, request);
  std::string secret = makeInvitation(session, user.id, detailOf(request).value("first_half", ""));
  transaction.commit();
  return secret;
}

std::string shownOf(SessionContext& session, const DutyRequest& request) {
  if (changesAccount(request.act)) {
    const std::optional<UserAccount> user = findUser(session, request.subject);
    return user ? user->login : request.subject;
  }
  if (request.act == DutyAct::kErase) {
    const std::optional<Person> person = PeopleRepository(session.connection()).find(request.subject);
    return person ? person->code : request.subject;
  }
  return detailOf(request).value("shown", "");
}

bool isOpen(SessionContext& session, const DutyWish& wish) {
  const std::vector<DutyRequest> open = openIn(session);
  return std::any_of(open.begin(), open.end(), [&](const DutyRequest& request) {
    return request.act == wish.act && request.subject == wish.subject;
  });
}

void requireAskable(SessionContext& session, const DutyWish& wish) {
  if (wish.reason.empty()) {
    refuseParameter(Text::tr("a request needs a reason"), Text::tr("two people"),
                    Text::tr("Say why, for the person who confirms it and for the audit trail"));
  }
  const std::optional<UserAccount> self = findUser(session, session.actor().userId);
  if (self && self->demonstration && !isSimulatedSubject(session, wish.act, wish.subject)) {
    throw Error(ErrorCode::kPermission, onlySimulated(), Text::tr("two people"),
                Text::tr("Sign in with your own account"));
  }
  if (changesAccount(wish.act)) {
    if (!findUser(session, wish.subject)) {
      refuse(Text::tr("there is no such user"), wish.subject, Text::tr("Choose one from the list"));
    }
    if (wish.subject == session.actor().userId.text()) {
      throw Error(ErrorCode::kPermission, Text::tr("this is your own account"), Text::tr("two people"),
                  Text::tr("Let other administrators ask for it and confirm it"));
    }
  }
  if (isOpen(session, wish)) {
    refuse(Text::tr("this is asked for already"), Text::tr("two people"),
           Text::tr("Let another administrator confirm it, or withdraw the request first"));
  }
}

}  // namespace

SecondPersonNeeded::SecondPersonNeeded(DutyAct act, std::string subject)
    : Error(ErrorCode::kPermission, Text::tr("this needs two people: one asks for it, another confirms it"),
            Text::tr("two people"),
            Text::tr("Ask for it, and let another administrator confirm it under Requests; a small centre "
                     "can switch this off in its settings")),
      act_(act),
      subject_(std::move(subject)) {}

bool needsTwoPeople(Connection& connection) {
  return centreSetting<kTwoPeople>(connection);
}

bool isGuardedRole(const std::string& role) {
  return role != "trainee";
}

bool givesGuardedRole(SessionContext& session, bool demonstration, const std::vector<std::string>& before,
                      const std::vector<std::string>& after) {
  if (!needsTwoPeople(session.connection())) {
    return false;
  }
  bool guarded = false;
  for (const std::string& role : after) {
    const bool given = std::find(before.begin(), before.end(), role) == before.end();
    const bool second = role == kAdministratorRole && administrators(session).size() < 2;
    guarded = guarded || (given && isGuardedRole(role) && !second && !isHarmless(demonstration, role));
  }
  return guarded;
}

bool takesAdministrator(SessionContext& session, const UserAccount& before,
                        const std::vector<std::string>& after) {
  return !before.demonstration && isActiveAdministrator(before) &&
         std::find(after.begin(), after.end(), kAdministratorRole) == after.end() && !oneIsEnough(session);
}

std::string askSecondPerson(SessionContext& session, const DutyWish& wish) {
  requireRightTo(session, wish.act);
  requireAskable(session, wish);
  nlohmann::json detail{{"shown", wish.shown}};
  std::string half;
  const std::optional<UserAccount> user = findUser(session, wish.subject);
  if (changesAccount(wish.act) && !(user && onlyTakesRoles(wish.act, *user, wish.roles))) {
    half = randomHalfPassword();
    detail["first_half"] = half;
  }
  if (wish.act == DutyAct::kGrantRoles) {
    detail["roles"] = wish.roles;
  }
  const DutyRequest request{.id = session.ids().newUuid(),
                            .act = wish.act,
                            .subject = wish.subject,
                            .detailJson = detail.dump(),
                            .reason = wish.reason,
                            .requestedBy = session.actor().userId,
                            .requestedUtc_us = session.now_us()};
  Transaction transaction(session.connection());
  DutyRepository(session.connection()).add(request);
  detail.erase("first_half");
  detail["act"] = storedText(wish.act);
  detail["subject"] = wish.subject;
  session.note(AuditAction::kDutyRequest, AuditObject::kDutyRequest, request.id, detail, wish.reason);
  transaction.commit();
  return half;
}

std::vector<OpenRequest> openRequests(SessionContext& session) {
  session.requireEither(Operation::kAllocationReveal, Operation::kUserManage);
  std::vector<OpenRequest> open;
  for (const DutyRequest& request : openIn(session)) {
    const std::optional<UserAccount> asker = findUser(session, request.requestedBy);
    open.push_back({.request = request,
                    .requestedBy = asker ? asker->login : std::string(request.requestedBy.text()),
                    .shown = shownOf(session, request),
                    .roles = rolesOf(request),
                    .own = request.requestedBy == session.actor().userId,
                    .mayConfirm = session.may(rightToConfirm(request.act)) &&
                                  hindrance(session, request).str().empty()});
    open.back().request.detailJson.clear();  // half of a password is not shown again
  }
  return open;
}

std::vector<UserAccount> otherAdministrators(SessionContext& session) {
  session.require(Operation::kUserManage);
  std::vector<UserAccount> others = administrators(session);
  const Actor& actor = session.actor();
  std::erase_if(others, [&actor](const UserAccount& user) {
    return user.id == actor.userId || (!user.personId.empty() && user.personId == actor.personId);
  });
  return others;
}

void declineRequest(SessionContext& session, const std::string& requestId, const std::string& reason) {
  session.requireEither(Operation::kAllocationReveal, Operation::kUserManage);
  const DutyRequest request = openRequest(session, requestId);
  Transaction transaction(session.connection());
  close(session, request,
        request.requestedBy == session.actor().userId ? DutyDecision::kWithdrawn : DutyDecision::kRefused,
        reason);
  transaction.commit();
}

std::string confirmRequest(SessionContext& session, const std::string& requestId) {
  session.require(Operation::kUserManage);
  const DutyRequest request = openRequest(session, requestId);
  if (request.act == DutyAct::kOnePerson) {
    requireRightTo(session, request.act);
    Transaction transaction(session.connection());
    confirm(session, request);
    keepCentreSetting(session, kTwoPeople, "no", request.reason);
    transaction.commit();
    return {};
  }
  TORSIO_EXPECTS(changesAccount(request.act));
  const std::optional<UserAccount> user = findUser(session, request.subject);
  if (!user) {
    refuse(Text::tr("there is no such user"), request.subject, Text::tr("Withdraw the request"));
  }
  if (request.act == DutyAct::kInvite) {
    return confirmInvitation(session, request, *user);
  }
  if (request.act == DutyAct::kResetPassword) {
    return drawSecondHalf(session, request, *user, nullptr);
  }
  const std::vector<std::string> roles = rolesOf(request);
  if (onlyTakesRoles(request.act, *user, roles)) {
    takeRoles(session, request, *user, roles);
    return {};
  }
  return drawSecondHalf(session, request, *user, &roles);
}

UserId requireSecondPerson(SessionContext& session, DutyAct act, const std::string& subject, bool always) {
  if (!always && oneIsEnough(session)) {
    return {};
  }
  const std::optional<DutyRequest> request = confirmable(session, act, subject);
  if (!request) {
    throw SecondPersonNeeded(act, subject);
  }
  close(session, *request, DutyDecision::kConfirmed, request->reason);
  return request->requestedBy;
}

bool isRequested(SessionContext& session, const DutyWish& wish) {
  requireRightTo(session, wish.act);
  return isOpen(session, wish);
}

bool secondPersonIsThere(SessionContext& session, DutyAct act, const std::string& subject, bool always) {
  return (!always && oneIsEnough(session)) || confirmable(session, act, subject);
}

bool passwordNeedsTwo(SessionContext& session, const UserAccount& user) {
  session.require(Operation::kUserManage);
  if (givesGuardedRole(session, user.demonstration, {}, user.roles)) {
    return true;
  }
  // Otherwise, removing the role first would allow signing in as a rater's person.
  const std::vector<Rater> raters = PeopleRepository(session.connection()).raters();
  return needsTwoPeople(session.connection()) && !user.demonstration && !user.personId.empty() &&
         std::any_of(raters.begin(), raters.end(),
                     [&](const Rater& rater) { return rater.person.id == user.personId; });
}

bool mayDropTheRule(SessionContext& session) {
  return administrators(session).size() < 2;
}

MadeUser makeUser(SessionContext& session, NewUser user) {
  session.require(Operation::kUserManage);
  const std::vector<std::string> wanted = user.roles;
  const UserAccount account{.personId = user.personId, .demonstration = user.demonstration, .roles = wanted};
  const bool grants = givesGuardedRole(session, user.demonstration, {}, wanted);
  if (!grants && !passwordNeedsTwo(session, account)) {
    return {addUser(session, user), user.startPassword};
  }
  if (grants) {
    std::erase_if(user.roles, isGuardedRole);
  }
  user.startPassword.clear();  // the two draw one
  Transaction transaction(session.connection());
  MadeUser made{.id = addUser(session, user), .awaitsSecond = true};
  made.startPassword =
      askSecondPerson(session, {.act = grants ? DutyAct::kGrantRoles : DutyAct::kResetPassword,
                                .subject = made.id,
                                .roles = wanted,
                                .reason = "new account"});
  transaction.commit();
  return made;
}

}  // namespace torsio
