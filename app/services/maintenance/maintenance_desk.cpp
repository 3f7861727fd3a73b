// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/maintenance_desk.h"

#include <utility>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/station_name.h"
#include "app/services/maintenance/copies.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

[[noreturn]] void refuse(const Text& what, const std::string& where, const Text& remedy) {
  throw Error(ErrorCode::kPermission, what, where, remedy);
}

/// Throws unless the account owns the record: its file, or the server's database.
void requireOwner(const Maintainer& maintainer, Connection& connection, const std::string& owned) {
  const Locator place = parseLocator(owned);
  const bool own =
      place.engine == Engine::kSqlite ? maintainer.ownsFile(place.file) : isOwnerOfTables(connection);
  if (!own) {
    refuse(Text::tr("this record belongs to another account"), place.shown(),
           Text::tr("Run the command as its owner, or sign in with --login NAME"));
  }
}

void requireSignedIn(const SignInAnswer& answer, const std::string& login) {
  switch (answer.outcome) {
    case SignIn::kOk:
      return;
    case SignIn::kMustChange:
      refuse(Text::tr("the start password must be changed first"), login,
             Text::tr("Sign in once in the window, and choose a password of your own"));
    case SignIn::kMustEnrol:
      refuse(Text::tr("the centre asks for a second factor, which this account has not"), login,
             Text::tr("Sign in once in the window or the browser, and set it up"));
    case SignIn::kCodeWrong:
    case SignIn::kCodeNeeded:
      refuse(Text::tr("the code of the second factor is not right, or was used before"), login,
             Text::tr("Wait for the next one, or use a recovery code"));
    case SignIn::kWait:
      refuse(Text::tr("too many failures: wait %1", clockLeftText(answer.waitUntilUtc_us - utcNow_us())),
             login, Text::tr("Then try again"));
    default:
      refuse(Text::tr("sign-in name or password is not right, or the account is disabled"), login,
             Text::tr("Try again"));
  }
}

/// Signs in; what follows may be signed, since the password has just been entered.
void enterAs(SessionContext& session, const std::string& login, const std::string& password,
             const std::function<std::string()>& code) {
  SignInAnswer answer = signIn(session, login, password);
  if (answer.outcome == SignIn::kCodeNeeded && code) {
    answer = signIn(session, login, password, {}, code());
  }
  requireSignedIn(answer, login);
  Actor actor = session.actor();
  actor.passwordShownUtc_us = session.now_us();
  session.setActor(actor);
}

}  // namespace

MaintenanceDesk::MaintenanceDesk(const Maintainer& maintainer, const std::string& locator)
    : MaintenanceDesk(maintainer, openRecord(locator, OpenMode::kReadWrite), locator) {}

MaintenanceDesk::MaintenanceDesk(const Maintainer& maintainer, Connection opened, const std::string& owned)
    : connection_(std::move(opened)),
      session_(connection_, ids_, {.locator = owned, .station = stationName(), .actor = {}}, utcNow_us) {
  enter(maintainer, owned);
  for (const std::vector<Text>& closed : {closeRecordFiles(owned, {}), closeKnownCopies(connection_)}) {
    for (const Text& sentence : closed) {
      if (maintainer.tell) {
        maintainer.tell(sentence);
      }
    }
  }
}

void MaintenanceDesk::enter(const Maintainer& maintainer, const std::string& owned) {
  if (!maintainer.login.empty()) {
    enterAs(session_, maintainer.login, maintainer.password(), maintainer.code);
    return;
  }
  if (maintainer.systemAccount.empty()) {
    refuse(Text::tr("nobody is signed in"), parseLocator(owned).shown(),
           Text::tr("Give --login NAME, or --as-system as the owner of the record"));
  }
  requireOwner(maintainer, connection_, owned);
  session_.setActor({.systemAccount = maintainer.systemAccount});
}

void MaintenanceDesk::handOver(const Maintainer& maintainer, const DutyWish& wish) {
  if (maintainer.secondLogin.empty()) {
    return;
  }
  if (maintainer.secondLogin == maintainer.login) {
    throw Error(ErrorCode::kPermission, Text::tr("two people are needed, and %1 is one", maintainer.login),
                "", Text::tr("Name another administrator"));
  }
  if (!isRequested(session(), wish)) {
    (void)askSecondPerson(session(), wish);
  }
  enterAs(session_, maintainer.secondLogin, maintainer.secondPassword(), maintainer.secondCode);
}

}  // namespace torsio
