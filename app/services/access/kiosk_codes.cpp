// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/kiosk_codes.h"

#include <QRandomGenerator>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::size_t kCodeDigits = 20;  // 66 bits: cannot be guessed

/// Uses digits, which are at the same place on every keyboard layout that a scanner may emulate.
std::string freshCode() {
  std::string code;
  for (std::size_t i = 0; i < kCodeDigits; ++i) {
    code.push_back(static_cast<char>('0' + QRandomGenerator::system()->bounded(10)));
  }
  return code;
}

std::string hashOf(const std::string& code) {
  return hashOfSecret("torsio kiosk code", code);
}

}  // namespace

std::vector<KioskCard> makeKioskCodes(SessionContext& session, std::span<const UserId> userIds) {
  session.require(Operation::kUserManage);
  if (!centreSetting<kKioskCodes>(session.connection())) {
    refuseParameter(Text::tr("the centre does not allow sign-in by code"), Text::tr("cards for the kiosk"),
                    Text::tr("Switch it on under Devices, At every station"));
  }
  if (userIds.empty()) {
    refuseParameter(Text::tr("nobody is chosen"), Text::tr("cards for the kiosk"),
                    Text::tr("Choose at least one trainee"));
  }
  Transaction transaction(session.connection());
  AccessRepository access(session.connection());
  const std::vector<UserAccount> users = access.users();
  std::vector<KioskCard> cards;
  for (const UserId& id : userIds) {
    const UserAccount user = userOf(users, id);
    if (user.roles != std::vector<std::string>{"trainee"}) {
      refuseParameter(Text::tr("a card opens a kiosk for trainees only"), user.login,
                      Text::tr("Choose users whose only role is that of a trainee"));
    }
    cards.push_back({id, user.login, freshCode()});
    access.setKioskCode(session.ids().newUuid(), id, hashOf(cards.back().code), session.now_us());
    session.note(AuditAction::kKioskCodeMake, AuditObject::kAppUser, id);
  }
  transaction.commit();
  return cards;
}

std::size_t revokeKioskCodes(SessionContext& session, std::span<const UserId> userIds,
                             const std::string& reason) {
  session.require(Operation::kUserManage);
  if (reason.empty()) {
    refuseParameter(Text::tr("revoking a code needs a reason"), Text::tr("cards for the kiosk"),
                    Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  AccessRepository access(session.connection());
  std::size_t revoked = 0;
  for (const UserId& id : userIds) {
    if (!access.revokeKioskCode(id, session.now_us())) {
      continue;
    }
    ++revoked;
    session.note(AuditAction::kKioskCodeRevoke, AuditObject::kAppUser, id, {}, reason);
  }
  transaction.commit();
  return revoked;
}

std::map<UserId, std::int64_t> kioskCodesInForce(SessionContext& session) {
  session.require(Operation::kUserManage);
  std::map<UserId, std::int64_t> since;
  for (const KioskCodeRow& row : AccessRepository(session.connection()).kioskCodes()) {
    since[row.userId] = row.madeUtc_us;
  }
  return since;
}

SignInAnswer signInWithCode(SessionContext& session, const std::string& code) {
  Connection& connection = session.connectionWithoutRight();
  AccessRepository access(connection);
  const SignInResult result = centreSetting<kKioskCodes>(connection)
                                  ? access.signInWithCode(hashOf(code), session.station(), session.now_us())
                                  : SignInResult{SignIn::kDisabled};
  SignInAnswer answer{result.outcome, {}, result.waitUntilUtc_us};
  if (result.outcome != SignIn::kOk) {
    session.note(AuditAction::kUserSignInFailed, AuditObject::kAppUser, result.userId, {{"with", "card"}});
    return answer;
  }
  const UserAccount user = userOf(access.users(), result.userId);
  answer.actor = {user.id, user.login, user.personId, user.roles, false, 0};
  answer.actor.serverToken = result.serverToken;
  session.setActor(answer.actor);
  session.note(AuditAction::kUserSignInCode, AuditObject::kAppUser, user.id);
  return answer;
}

}  // namespace torsio
