// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/invitations.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/two_people.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

std::string proofOfInvitation(const std::string& secret, const std::string& code) {
  return hashOfSecret("torsio invitation", secret + code);
}

/// Returns whether only this machine could open a link to the address.
bool isThisMachine(const std::string& address) {
  for (const char* own : {"http://127.0.0.1", "http://localhost", "http://[::1]"}) {
    const std::string begin(own);
    const char next = address.size() > begin.size() ? address[begin.size()] : '/';
    if (address.rfind(begin, 0) == 0 && (next == ':' || next == '/')) {
      return true;
    }
  }
  return false;
}

UserAccount accountToInvite(SessionContext& session, const std::vector<UserAccount>& users,
                            const UserId& userId) {
  UserAccount found = userOf(users, userId);
  if (!found.active) {
    refuseParameter(Text::tr("this account may not sign in"), found.login,
                    Text::tr("Enable it first, or leave it out"));
  }
  if (found.id == session.actor().userId) {
    refuseParameter(Text::tr("this is your own account"), found.login,
                    Text::tr("Change your password where you are signed in"));
  }
  return found;
}

}  // namespace

std::string browserAddress(SessionContext& session) {
  session.require(Operation::kUserManage);
  return centreSetting<kBrowserAddress>(session.connection());
}

void setBrowserAddress(SessionContext& session, const std::string& address) {
  session.require(Operation::kSettingsEdit);
  std::string kept = address;
  while (!kept.empty() && kept.back() == '/') {
    kept.pop_back();
  }
  const bool plain = std::all_of(kept.begin(), kept.end(), [](char c) { return c > ' ' && c < '\x7f'; });
  const bool encrypted = kept.rfind("https://", 0) == 0 && kept.size() > 8;
  if (!plain || kept.find_first_of("#?\"<>") != std::string::npos || (!encrypted && !isThisMachine(kept))) {
    refuseParameter(Text::tr("browsers cannot reach the review desk at this address"), kept,
                    Text::tr("Write it as https://desk.example.org"));
  }
  setCentreSetting<kBrowserAddress>(session, kept);
}

std::string invitationLink(const std::string& browserAddress, const std::string& secret, bool withCode) {
  return browserAddress + "/join#" + (withCode ? "2." : "") + secret;
}

std::string makeInvitation(SessionContext& session, const UserId& userId, const std::string& code) {
  const std::string secret = randomStartPassword();
  const std::int64_t now_us = session.now_us();
  AccessRepository(session.connection())
      .addInvitation(session.ids().newUuid(), {userId, now_us, now_us + kInvitationLife_us},
                     proofOfInvitation(secret, code));
  session.note(AuditAction::kInvitationMake, AuditObject::kAppUser, userId);
  return secret;
}

std::vector<Invitation> invite(SessionContext& session, std::span<const UserId> userIds) {
  session.require(Operation::kUserManage);
  if (userIds.empty()) {
    refuseParameter(Text::tr("nobody is chosen"), Text::tr("invitations"),
                    Text::tr("Choose at least one user"));
  }
  Transaction transaction(session.connection());
  const std::vector<UserAccount> users = AccessRepository(session.connection()).users();
  std::vector<Invitation> made;
  for (const UserId& id : userIds) {
    const UserAccount user = accountToInvite(session, users, id);
    if (passwordNeedsTwo(session, user)) {
      throw SecondPersonNeeded(DutyAct::kInvite, id);
    }
    made.push_back({id, user.login, makeInvitation(session, id, ""), session.now_us() + kInvitationLife_us});
  }
  transaction.commit();
  return made;
}

std::vector<HandedInvitation> inviteOrAsk(SessionContext& session, std::span<const UserId> userIds,
                                          const std::string& reason) {
  session.require(Operation::kUserManage);
  Transaction transaction(session.connection());
  const std::vector<UserAccount> users = AccessRepository(session.connection()).users();
  std::vector<UserId> alone;
  std::vector<HandedInvitation> handed;
  for (const UserId& id : userIds) {
    const UserAccount user = accountToInvite(session, users, id);
    if (passwordNeedsTwo(session, user)) {
      const std::string code =
          askSecondPerson(session, {.act = DutyAct::kInvite, .subject = id, .reason = reason});
      handed.push_back({.userId = id, .login = user.login, .code = code});
    } else {
      alone.push_back(id);
    }
  }
  if (!alone.empty() || userIds.empty()) {
    for (const Invitation& one : invite(session, alone)) {
      handed.push_back({one.userId, one.login, one.secret, "", one.expiresUtc_us});
    }
  }
  transaction.commit();
  return handed;
}

HandedInvitation confirmInvitation(SessionContext& session, const std::string& requestId) {
  session.require(Operation::kUserManage);
  for (const OpenRequest& open : openRequests(session)) {
    if (open.request.id == requestId && open.request.act == DutyAct::kInvite) {
      return {.userId = UserId(open.request.subject),
              .login = open.shown,
              .secret = confirmRequest(session, requestId),
              .expiresUtc_us = session.now_us() + kInvitationLife_us};
    }
  }
  refuseParameter(Text::tr("the request for this invitation no longer exists"), "",
                  Text::tr("Read the list again"));
}

Text invitationSubject(const std::string& centre) {
  return centre.empty() ? Text::tr("Invitation to Torsio") : Text::tr("Invitation to Torsio at %1", centre);
}

Text invitationWords(const std::string& centre, const std::string& login, const std::string& link,
                     const std::string& until) {
  if (centre.empty()) {
    return Text::tr(
        "You are invited to use Torsio, in the browser of any computer. Open this link and choose a "
        "password:\n%1\nYour sign-in name is %2. The link works once, until %3, and is for you alone: please "
        "do not pass it on.",
        link, login, until);
  }
  return Text::tr(
      "You are invited to use Torsio at %1, in the browser of any computer. Open this link and choose a "
      "password:\n%2\nYour sign-in name is %3. The link works once, until %4, and is for you alone: please "
      "do not pass it on.",
      centre, link, login, until);
}

Text invitationCodeWords(const std::string& centre, const std::string& code) {
  if (centre.empty()) {
    return Text::tr("The code for your invitation to Torsio is %1. The link is sent separately.", code);
  }
  return Text::tr("The code for your invitation to Torsio at %1 is %2. The link is sent separately.", centre,
                  code);
}

std::size_t revokeInvitations(SessionContext& session, std::span<const UserId> userIds,
                              const std::string& reason) {
  session.require(Operation::kUserManage);
  if (reason.empty()) {
    refuseParameter(Text::tr("revoking an invitation needs a reason"), Text::tr("invitations"),
                    Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  AccessRepository access(session.connection());
  std::size_t revoked = 0;
  for (const UserId& id : userIds) {
    if (!access.revokeInvitation(id)) {
      continue;
    }
    ++revoked;
    session.note(AuditAction::kInvitationRevoke, AuditObject::kAppUser, id, {}, reason);
  }
  transaction.commit();
  return revoked;
}

std::map<UserId, std::int64_t> invitationsInForce(SessionContext& session) {
  session.require(Operation::kUserManage);
  std::map<UserId, std::int64_t> until;
  for (const InvitationRow& row : AccessRepository(session.connection()).openInvitations()) {
    if (row.expiresUtc_us > session.now_us()) {
      until[row.userId] = row.expiresUtc_us;
    }
  }
  return until;
}

SignInAnswer acceptInvitation(SessionContext& session, const std::string& secret, const std::string& code,
                              const std::string& newPassword) {
  Connection& connection = session.connectionWithoutRight();
  AccessRepository access(connection, session.passwordCost());
  const std::string proof = proofOfInvitation(secret, code);
  const auto refused = [&] {
    session.note(AuditAction::kUserSignInFailed, AuditObject::kAppUser, {}, {{"with", "invitation"}});
    return SignInAnswer{SignIn::kWrong};
  };
  const std::string serverToken = access.openInvitedSession(proof);
  if (!serverToken.empty()) {
    tellSession(connection, serverToken);
  }
  const auto leave = [&] {
    if (!serverToken.empty()) {
      access.endOwnServerSession();
    }
  };
  const std::optional<UserId> userId = access.invited(proof, session.now_us());
  if (!userId) {
    leave();
    return refused();
  }
  std::string login;
  for (const UserAccount& user : access.users()) {
    login = user.id == *userId ? user.login : login;
  }
  const SealedSecret password = access.sealPassword(login, newPassword);
  bool used = false;
  {
    Transaction transaction(connection);
    used = access.useInvitation(proof, session.now_us());
    if (used) {
      const bool removed = access.setPassword(*userId, password, false);
      session.note(AuditAction::kInvitationUse, AuditObject::kAppUser, *userId,
                   removed ? nlohmann::json{{"second_factor", "removed"}} : nlohmann::json());
      transaction.commit();
    }
  }
  leave();
  if (!used) {
    return refused();  // somebody else used the same link first
  }
  return signIn(session, login, newPassword);
}

}  // namespace torsio
