// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/signing.h"

#include <algorithm>
#include <charconv>

#include <nlohmann/json.hpp>

#include "app/services/access/access_service.h"
#include "app/services/access/settings_service.h"
#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/clock_text.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

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

int signMinutes(Connection& connection) {
  int minutes = -1;
  if (const auto text = SettingRepository(connection).value(kSignMinutesSetting)) {
    std::from_chars(text->data(), text->data() + text->size(), minutes);
  }
  return minutes >= 0 && minutes <= kLongestSignMinutes ? minutes : kDefaultSignMinutes;
}

void setSignMinutes(SessionContext& session, int minutes) {
  session.require(Operation::kSettingsEdit);
  if (minutes < 0 || minutes > kLongestSignMinutes) {
    throw Error(ErrorCode::kBadParameter, Text::tr("these minutes make no sense"), Text::tr("signatures"),
                Text::tr("Choose 0 to %1 minutes", kLongestSignMinutes));
  }
  setCentreSetting(session, kSignMinutesSetting, std::to_string(minutes));
}

bool passwordIsDue(SessionContext& session) {
  const std::int64_t shown_us = session.actor().passwordShownUtc_us;
  if (shown_us == kNoPasswordToShow) {
    return !AccessRepository(session.connectionWithoutRight()).isOfDemonstration(session.actor().userId);
  }
  const std::int64_t since_us = session.now_us() - shown_us;
  const int minutes = signMinutes(session.connectionWithoutRight());
  // Where each signature asks, a password that was shown is good for the act that follows at once.
  const std::int64_t good_us = (minutes == 0 ? kDefaultSignMinutes : minutes) * kMinute_us;
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
  session.note(
      {.action = AuditAction::kSignatureGive,
       .objectKind = auditObjectOf(object.kind),
       .objectId = object.objectId,
       .newJson = nlohmann::json{{"meaning", storedText(object.meaning)}, {"password_shown_utc_us", shown_us}}
                      .dump(),
       .reason = object.reason});
}

void endSigning(SessionContext& session) {
  const bool shown = session.actor().passwordShownUtc_us != kNoPasswordToShow;
  if (shown && signMinutes(session.connectionWithoutRight()) == 0) {
    session.forgetPasswordShown();
  }
}

}  // namespace torsio
