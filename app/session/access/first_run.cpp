// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/access/first_run.h"

#include <algorithm>
#include <string_view>

#include <QRandomGenerator>

#include "app/session/build_info.h"
#include "app/session/demonstration.h"
#include "db/migrations/migrations.h"
#include "db/repository/people_repository.h"
#include "db/repository/setting_repository.h"
#include "db/repository/study_repository.h"
#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::string_view kLegible = "abcdefghijkmnpqrstuvwxyz23456789";  // no l and 1, no o and 0
constexpr int kGroups = 4;
constexpr int kLettersInGroup = 5;
constexpr const char* kChief = "chief";

void fillWithPeople(Workplace& workplace, const std::filesystem::path& assets,
                    const ProgressCallback& progress) {
  DemonstrationOptions options;
  options.training.assets = assets;
  options.training.id = "arm";
  options.example.assets = assets;
  options.example.id = "stomach";
  options.progress = progress;
  static_cast<void>(fillDemonstration(options, workplace.connection()));
}

StartAccount account(Workplace& workplace, const std::string& login, const std::string& role,
                     const StoredPerson& person) {
  StartAccount made{login, role, person.code, randomStartPassword()};
  addUser(workplace, {.login = login,
                      .personId = person.id,
                      .roles = {role},
                      .startPassword = made.startPassword,
                      .demonstration = true});
  return made;
}

std::vector<StartAccount> demonstrationAccounts(Workplace& workplace) {
  PeopleRepository people(workplace.connection());
  const std::vector<StoredTrainee> trainees = people.trainees();
  const std::vector<StoredRater> raters = people.raters();
  const auto chief = std::find_if(raters.begin(), raters.end(),
                                  [](const StoredRater& rater) { return rater.classCode == kChief; });
  TORSIO_EXPECTS(!trainees.empty() && chief != raters.end());
  return {account(workplace, "demo.trainee", "trainee", trainees.front().person),
          account(workplace, "demo.physician", "rater", chief->person)};
}

}  // namespace

CentreSign centreSign(Connection& connection) {
  CentreSign sign;
  if (const auto centre = StudyRepository(connection).centre()) sign.name = centre->name;
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
    if (group > 0) password += '-';
    for (int i = 0; i < kLettersInGroup; ++i) {
      password += kLegible[QRandomGenerator::system()->bounded(static_cast<quint32>(kLegible.size()))];
    }
  }
  return password;
}

std::vector<StartAccount> performFirstRun(Workplace& workplace, const FirstRun& first,
                                          const std::filesystem::path& assets,
                                          const ProgressCallback& progress) {
  std::vector<StartAccount> accounts;
  Transaction transaction(workplace.connection());
  try {
    setUpCentre(workplace, first);
    const SignInAnswer answer = signIn(workplace, first.login, first.password);
    TORSIO_EXPECTS(answer.outcome == SignIn::kOk);
    if (first.demonstration) {
      fillWithPeople(workplace, assets, progress);
      accounts = demonstrationAccounts(workplace);
    }
    transaction.commit();
  } catch (...) {
    workplace.setActor({});  // nothing was kept, nobody is signed in
    throw;
  }
  return accounts;
}

}  // namespace torsio
