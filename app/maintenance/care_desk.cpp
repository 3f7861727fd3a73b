// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/maintenance/care_desk.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/access/access_service.h"
#include "app/maintenance/copies.h"
#include "app/maintenance/record_privacy.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/server_roles.h"
#include "sim/base/clock.h"
#include "sim/base/clock_text.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

[[noreturn]] void refuse(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kPermission, what, where, remedy);
}

/// The record of this file, or this database of a server, is the account's own.
void requireOwner(const CareTaker& taker, Connection& connection, const std::string& owned) {
  const Locator place = parseLocator(owned);
  const bool own = place.engine == Engine::kSqlite ? taker.ownsFile(place.file) : isOwnerOfTables(connection);
  if (!own) {
    refuse(Text::tr("this record belongs to another account"), place.shown(),
           Text::tr("Run the command as its owner, or sign in with --as LOGIN"));
  }
}

void requireSignedIn(const SignInAnswer& answer, const std::string& login) {
  switch (answer.outcome) {
    case SignIn::kOk:
      return;
    case SignIn::kMustChange:
      refuse(Text::tr("the start password must be changed first"), login,
             Text::tr("Sign in once in the window, and choose a password of your own"));
    case SignIn::kWait:
      refuse(Text::tr("too many failures: wait %1", clockLeftText(answer.waitUntilUtc_us - utcNow_us())),
             login, Text::tr("Then try again"));
    default:
      refuse(Text::tr("sign-in name or password is not right, or the account is disabled"), login,
             Text::tr("Try again"));
  }
}

}  // namespace

CareDesk::CareDesk(const CareTaker& taker, const std::string& locator)
    : CareDesk(taker, openRecord(locator, OpenMode::kReadWrite), locator) {}

CareDesk::CareDesk(const CareTaker& taker, Connection opened, const std::string& owned)
    : connection_(std::move(opened)),
      session_(connection_, ids_, {.locator = owned, .station = stationName(), .actor = {}}, utcNow_us) {
  enter(taker, owned);
  for (const std::vector<Text>& closed : {closeRecordFiles(owned, {}), closeKnownCopies(connection_)}) {
    for (const Text& sentence : closed) {
      if (taker.tell) {
        taker.tell(sentence);
      }
    }
  }
}

void CareDesk::enter(const CareTaker& taker, const std::string& owned) {
  if (!taker.login.empty()) {
    requireSignedIn(signIn(session_, taker.login, taker.password()), taker.login);
    return;
  }
  if (taker.systemAccount.empty()) {
    refuse(Text::tr("nobody is signed in"), parseLocator(owned).shown(),
           Text::tr("Give --as LOGIN, or --as-system as the owner of the record"));
  }
  requireOwner(taker, connection_, owned);
  session_.setActor({.systemAccount = taker.systemAccount});
}

void CareDesk::handOver(const CareTaker& taker, const DutyWish& wish) {
  if (taker.secondLogin.empty()) {
    return;
  }
  const std::vector<OpenRequest> open = openRequests(session());
  const bool asked = std::any_of(open.begin(), open.end(), [&](const OpenRequest& one) {
    return one.request.act == wish.act && one.request.subject == wish.subject;
  });
  if (!asked) {
    (void)askSecondPerson(session(), wish);
  }
  requireSignedIn(signIn(session_, taker.secondLogin, taker.secondPassword()), taker.secondLogin);
}

}  // namespace torsio
