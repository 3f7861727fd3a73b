// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/access/first_run.h"

#include <string_view>

#include <QRandomGenerator>

#include "app/base/build_info.h"
#include "assessment/people/account.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::string_view kLegible = "abcdefghijkmnpqrstuvwxyz23456789";  // no l and 1, no o and 0
constexpr int kGroups = 4;
constexpr int kLettersInGroup = 5;

}  // namespace

CentreSign centreSign(Connection& connection) {
  CentreSign sign;
  if (const auto centre = StudyRepository(connection).centre()) {
    sign.name = centre->name;
  }
  sign.language = SettingRepository(connection).value("language").value_or("");
  return sign;
}

bool recordHasUsers(const std::string& locator) {
  MigrationOptions options;
  options.softwareVersion = softwareVersion();
  Connection connection = openRecord(locator, OpenMode::kCreate, options);
  return !needsFirstRun(connection);
}

std::string randomStartPassword() {
  std::string password;
  for (int group = 0; group < kGroups; ++group) {
    if (group > 0) {
      password += '-';
    }
    for (int i = 0; i < kLettersInGroup; ++i) {
      password += kLegible[QRandomGenerator::system()->bounded(static_cast<quint32>(kLegible.size()))];
    }
  }
  return password;
}

std::vector<StartAccount> performFirstRun(SessionContext& session, const FirstRun& first,
                                          const AddPeople& addPeople) {
  std::vector<StartAccount> accounts;
  Transaction transaction(session.connectionWithoutRight());
  try {
    setUpCentre(session, first);
    const SignInAnswer answer = signIn(session, first.login, first.password);
    TORSIO_EXPECTS(answer.outcome == SignIn::kOk);
    if (first.demonstration) {
      accounts = addPeople(session);
    }
    transaction.commit();
  } catch (...) {
    session.setActor({});  // nothing was kept, nobody is signed in
    throw;
  }
  return accounts;
}

}  // namespace torsio
