// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/signing.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/signature_repository.h"
#include "sim/core/clock.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr int kSignWindow_min = 15;  // validity of an entered password if each signature asks

AuditObject auditObjectOf(SignedKind kind) {
  switch (kind) {
    case SignedKind::kTrainingMark:
      return AuditObject::kTrainingMark;
    case SignedKind::kEvaluationMark:
      return AuditObject::kEvaluationMark;
    case SignedKind::kFrozenDataset:
      break;
  }
  return AuditObject::kFrozenDataset;
}

}  // namespace

bool passwordIsDue(SessionContext& session) {
  const std::int64_t shown_us = session.actor().passwordShownUtc_us;
  if (shown_us == kNoPasswordToShow) {
    return !AccessRepository(session.connectionWithoutRight()).isOfDemonstration(session.actor().userId);
  }
  const std::int64_t since_us = session.now_us() - shown_us;
  const int minutes = centreSetting<kSignMinutes>(session.connectionWithoutRight());
  // If each signature asks, the entered password covers the act that follows immediately.
  const std::int64_t good_us = (minutes == 0 ? kSignWindow_min : minutes) * kMinute_us;
  return shown_us == 0 || since_us < 0 || since_us > good_us;
}

void showPassword(SessionContext& session, const std::string& password) {
  const Actor before = session.actor();
  const SignInAnswer answer = checkOwnPassword(session, password);
  if (answer.outcome == SignIn::kOk) {
    Actor actor = before;
    actor.passwordShownUtc_us = session.now_us();
    session.setActor(actor);
    return;
  }
  if (answer.outcome == SignIn::kWait) {
    throw Error(
        ErrorCode::kPermission,
        Text::tr("too many failures: wait %1", clockLeftText(answer.waitUntilUtc_us - session.now_us())),
        Text::tr("password"), Text::tr("Then try again"));
  }
  throw Error(ErrorCode::kPermission, Text::tr("the password is not right"), Text::tr("password"),
              Text::tr("Try again"));
}

PasswordDue::PasswordDue()
    : Error(ErrorCode::kPermission, Text::tr("a signature asks for your password"), Text::tr("signature"),
            Text::tr("Enter your password and submit again")) {}

void sign(SessionContext& session, const SignedObject& object) {
  if (passwordIsDue(session)) {
    throw PasswordDue();
  }
  const Actor& actor = session.actor();
  const std::int64_t shown_us = std::max<std::int64_t>(actor.passwordShownUtc_us, 0);
  if (!object.demonstration && AccessRepository(session.connection()).isOfDemonstration(actor.userId)) {
    throw Error(ErrorCode::kPermission,
                Text::tr("an account of the demonstration signs only what is simulated"),
                Text::tr("signature"), Text::tr("Let a person of the centre do it"));
  }
  SignatureRepository(session.connection())
      .add({.kind = object.kind,
            .objectId = object.objectId,
            .userId = actor.userId,
            .personId = actor.personId,
            .meaning = object.meaning,
            .reason = object.reason,
            .signedUtc_us = session.now_us(),
            .passwordShownUtc_us = shown_us,
            .demonstration = object.demonstration});
  session.note(AuditAction::kSignatureGive, auditObjectOf(object.kind), object.objectId,
               {{"meaning", storedText(object.meaning)}, {"password_shown_utc_us", shown_us}}, object.reason);
}

void endSigning(SessionContext& session) {
  const bool shown = session.actor().passwordShownUtc_us != kNoPasswordToShow;
  if (shown && centreSetting<kSignMinutes>(session.connectionWithoutRight()) == 0) {
    session.forgetPasswordShown();
  }
}

}  // namespace torsio
