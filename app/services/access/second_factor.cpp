// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/second_factor.h"

#include <algorithm>
#include <optional>

#include <QString>
#include <QUrl>

#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/sign_in_steps.h"
#include "app/services/access/start_password.h"
#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr int kRecoveryCodes = 10;
constexpr int kRecoveryGroups = 4;
constexpr int kLettersOfAGroup = 4;

std::vector<std::string> freshRecoveryCodes() {
  std::vector<std::string> codes(kRecoveryCodes);
  for (std::string& code : codes) {
    for (int group = 0; group < kRecoveryGroups; ++group) {
      code += (group == 0 ? "" : "-") + legibleLetters(kLettersOfAGroup);
    }
  }
  return codes;
}

/// Throws unless password and code were right; audited like a failed sign-in.
void requirePassed(SessionContext& session, const std::string& login, const SignInResult& result) {
  if (result.outcome == SignIn::kOk) {
    return;
  }
  if (result.outcome != SignIn::kCodeNeeded && result.outcome != SignIn::kMustChange) {
    noteFailure(session, login, result.outcome, "password");
  }
  refuseUnpassed(result, session.now_us());
}

}  // namespace

bool secondFactorIsAsked(Connection& connection, const std::vector<std::string>& roles) {
  const std::string asked = centreSetting<kSecondFactor>(connection);
  return asked == "everybody" || (asked == "administrators" &&
                                  std::find(roles.begin(), roles.end(), kAdministratorRole) != roles.end());
}

SecondFactorOffer offerSecondFactor(SessionContext& session, const std::string& login) {
  const std::string centre = centreSign(session.connectionWithoutRight()).name;
  const auto encoded = [](const std::string& text) {
    return QUrl::toPercentEncoding(QString::fromStdString(text)).toStdString();
  };
  const std::string issuer = encoded(centre.empty() ? "Torsio" : "Torsio " + centre);
  SecondFactorOffer offer{.secret = newCodeSecret()};
  offer.uri = "otpauth://totp/" + issuer + ":" + encoded(login) + "?secret=" + offer.secret +
              "&issuer=" + issuer + "&algorithm=SHA1&digits=6&period=30";
  return offer;
}

SecondFactorStart switchOnSecondFactor(SessionContext& session, const SecondFactorWish& wish) {
  const SignInResult known =
      signInAccess(session).signIn(wish.login, wish.password, session.now_us(), placeOf(session, wish.place));
  if (known.outcome == SignIn::kCodeNeeded) {
    refuse(Text::tr("this account has a second factor already"), wish.login, Text::tr("Switch it off first"));
  }
  requirePassed(session, wish.login, known);
  std::string code = wish.code;
  std::erase(code, ' ');
  const std::optional<std::int64_t> step =
      isCodeSecret(wish.secret) ? stepOfCode(wish.secret, code, session.now_us()) : std::nullopt;
  if (!step) {
    endServerSession(session, known.serverToken);
    refuseParameter(Text::tr("this is not the code of this secret"), Text::tr("code"),
                    Text::tr("Type the code that is shown now; compare the clocks of phone and computer"));
  }
  const std::string sealed =
      sealedCodeSecret(wish.secret, wish.password, known.userId, session.passwordCost());
  SecondFactorStart start{.recoveryCodes = freshRecoveryCodes()};
  Connection& connection = session.connectionWithoutRight();
  tellSession(connection, known.serverToken);
  Transaction transaction(connection);
  SecondFactorRepository(connection).add(known.userId, sealed, *step, start.recoveryCodes, session.now_us());
  SignInResult entered = known;
  entered.hasSecondFactor = true;
  start.answer = answerTo(session, wish.login, entered, SignInKind::kAnew);
  session.note(AuditAction::kUserSwitchOnSecondFactor, AuditObject::kAppUser, known.userId);
  transaction.commit();
  return start;
}

void switchOffSecondFactor(SessionContext& session, const std::string& password, const std::string& code) {
  const Actor actor = session.actor();
  if (actor.userId.empty() || actor.practiceOnly) {
    throw Error(ErrorCode::kPermission, Text::tr("nobody is signed in"), Text::tr("second factor"),
                Text::tr("Sign in first"));
  }
  const SignInResult known =
      signInAccess(session).signIn(actor.login, password, session.now_us(), placeWithin(session), code);
  requirePassed(session, actor.login, known);
  endServerSession(session, known.serverToken);
  if (!known.hasSecondFactor) {
    refuse(Text::tr("this account has no second factor"), actor.login, Text::tr("There is nothing to do"));
  }
  Connection& connection = session.connectionWithoutRight();
  Transaction transaction(connection);
  SecondFactorRepository(connection).remove(actor.userId);
  session.note(AuditAction::kUserSwitchOffSecondFactor, AuditObject::kAppUser, actor.userId);
  transaction.commit();
}

OwnSecondFactor ownSecondFactor(SessionContext& session) {
  Connection& connection = session.connectionWithoutRight();
  const std::optional<SecondFactor> found = SecondFactorRepository(connection).find(session.actor().userId);
  return {.on = found.has_value(),
          .asked = secondFactorIsAsked(connection, session.actor().roles),
          .recoveryCodes = found ? found->recoveryCodes : 0};
}

std::set<UserId> secondFactors(SessionContext& session) {
  session.require(Operation::kUserManage);
  const std::vector<UserId> owners = SecondFactorRepository(session.connection()).owners();
  return {owners.begin(), owners.end()};
}

}  // namespace torsio
