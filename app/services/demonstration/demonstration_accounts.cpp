// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_accounts.h"

#include <algorithm>
#include <string>

#include "app/services/demonstration/demonstration.h"
#include "app/services/demonstration/demonstration_desk.h"
#include "app/services/demonstration/demonstration_station.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "db/repository/people/people_repository.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr double kDesksAt = 0.97;  // of the whole work

/// Whose accounts are worth signing in with: their pages hold something.
struct DemonstrationUsers {
  TraineeId traineeId;
  RaterId raterId;
};

DemonstrationUsers fillWithPeople(SessionContext& session, const std::filesystem::path& assets,
                                  const ProgressCallback& progress) {
  DemonstrationOptions options;
  options.training.assets = assets;
  options.training.id = "forearm";
  options.example.assets = assets;
  options.example.id = "stomach";
  options.fewestTwists = kDemonstrationTwists;
  options.progress = progress;
  static_cast<void>(fillDemonstration(options, session.connectionWithoutRight()));
  // What the trainee and the physician of the demonstration find when they sign in.
  if (progress) {
    progress({Text::tr("Laying out the desks"), kDesksAt, -1.0});
  }
  const DemonstrationStation station =
      storeDemonstrationStation(session.connectionWithoutRight(), session.ids(), assets, session.now_us());
  const DemonstrationDesk desk =
      storeDemonstrationDesk(session.connectionWithoutRight(), session.ids(), loadScene(options.training),
                             {.seed = options.seed, .utc_us = session.now_us()});
  return {station.personId, desk.raterIds.front()};
}

StartAccount account(SessionContext& session, const std::string& login, const std::string& role,
                     const Person& person) {
  StartAccount made{login, role, person.code, randomStartPassword()};
  addUser(session, {.login = login,
                    .personId = person.id,
                    .roles = {role},
                    .startPassword = made.startPassword,
                    .demonstration = true});
  return made;
}

std::vector<StartAccount> accountsOf(SessionContext& session, const DemonstrationUsers& users) {
  PeopleRepository people(session.connectionWithoutRight());
  const std::vector<Trainee> trainees = people.trainees();
  const std::vector<Rater> raters = people.raters();
  const auto trainee = std::find_if(trainees.begin(), trainees.end(), [&](const Trainee& candidate) {
    return candidate.person.id == users.traineeId;
  });
  const auto rater = std::find_if(raters.begin(), raters.end(), [&](const Rater& candidate) {
    return candidate.person.id == users.raterId;
  });
  TORSIO_EXPECTS(trainee != trainees.end() && rater != raters.end());
  return {account(session, "demo.trainee", "trainee", trainee->person),
          account(session, "demo.physician", "rater", rater->person)};
}

}  // namespace

std::vector<StartAccount> addDemonstration(SessionContext& session, const std::filesystem::path& assets,
                                           const ProgressCallback& progress) {
  return accountsOf(session, fillWithPeople(session, assets, progress));
}

}  // namespace torsio
