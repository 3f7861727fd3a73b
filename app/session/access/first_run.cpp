// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/access/first_run.h"

#include <algorithm>
#include <string_view>

#include <QRandomGenerator>

#include "app/session/build_info.h"
#include "app/session/demonstration.h"
#include "app/session/review/demonstration_desk.h"
#include "app/session/training/demonstration_station.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::string_view kLegible = "abcdefghijkmnpqrstuvwxyz23456789";  // no l and 1, no o and 0
constexpr int kGroups = 4;
constexpr int kLettersInGroup = 5;
constexpr double kDesksAt = 0.97;  // of the whole work

/// Whose accounts are worth signing in with: their pages hold something.
struct DemonstrationUsers {
  std::string traineeId;
  std::string raterId;
};

DemonstrationUsers fillWithPeople(Workplace& workplace, const std::filesystem::path& assets,
                                  const ProgressCallback& progress) {
  DemonstrationOptions options;
  options.training.assets = assets;
  options.training.id = "arm";
  options.example.assets = assets;
  options.example.id = "stomach";
  options.progress = progress;
  static_cast<void>(fillDemonstration(options, workplace.connection()));
  // What the trainee and the physician of the demonstration find when they sign in.
  if (progress) progress({"Laying out the desks", kDesksAt, -1.0});
  const DemonstrationStation station =
      storeDemonstrationStation(workplace.connection(), workplace.ids(), assets, workplace.now_us());
  const DemonstrationDesk desk =
      storeDemonstrationDesk(workplace.connection(), workplace.ids(), loadScene(options.training),
                             {.seed = options.seed, .utc_us = workplace.now_us()});
  return {station.personId, desk.raterIds.front()};
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

std::vector<StartAccount> demonstrationAccounts(Workplace& workplace, const DemonstrationUsers& users) {
  PeopleRepository people(workplace.connection());
  const std::vector<StoredTrainee> trainees = people.trainees();
  const std::vector<StoredRater> raters = people.raters();
  const auto trainee = std::find_if(trainees.begin(), trainees.end(), [&](const StoredTrainee& candidate) {
    return candidate.person.id == users.traineeId;
  });
  const auto rater = std::find_if(raters.begin(), raters.end(), [&](const StoredRater& candidate) {
    return candidate.person.id == users.raterId;
  });
  TORSIO_EXPECTS(trainee != trainees.end() && rater != raters.end());
  return {account(workplace, "demo.trainee", "trainee", trainee->person),
          account(workplace, "demo.physician", "rater", rater->person)};
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
      accounts = demonstrationAccounts(workplace, fillWithPeople(workplace, assets, progress));
    }
    transaction.commit();
  } catch (...) {
    workplace.setActor({});  // nothing was kept, nobody is signed in
    throw;
  }
  return accounts;
}

}  // namespace torsio
