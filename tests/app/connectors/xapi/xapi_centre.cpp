// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/connectors/xapi/xapi_centre.h"

#include <algorithm>

#include <QSettings>

#include "app/connectors/xapi/lrs_settings.h"
#include "app/services/recording/competence.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"

namespace torsio {

XapiCentre::XapiCentre() {
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings_.path());
  decide("T-01", true);
}

SessionContext& XapiCentre::asAdministrator() {
  const UserId id = "the administrator";
  AccessRepository access(connection(), PasswordCost::kTest);
  const auto users = access.users();
  if (std::none_of(users.begin(), users.end(), [&](const UserAccount& user) { return user.id == id; })) {
    access.addUser({.id = id, .login = "admin", .roles = {"administrator"}}, "a long enough password");
  }
  centre_.session().setActor({.userId = id, .login = "admin", .roles = {"administrator"}});
  return centre_.session();
}

void XapiCentre::turnOn() {
  setLrsSettings(asAdministrator(),
                 {.on = true, .endpoint = store_.endpoint(), .homePage = "https://skills.example.org"});
  setStationLrsKey({testing::TestLrs::kUser, testing::TestLrs::kSecret});
  centre_.become("T-01");
}

PersonId XapiCentre::person(const std::string& traineeCode) {
  for (const Trainee& trainee : PeopleRepository(connection()).trainees()) {
    if (trainee.person.code == traineeCode) {
      return trainee.person.id;
    }
  }
  return {};
}

void XapiCentre::decide(const std::string& traineeCode, bool granted) {
  PeopleRepository(connection())
      .recordConsent({.personId = person(traineeCode),
                      .purpose = kLearningConsent,
                      .granted = granted,
                      .textVersion = "1",
                      .decidedUtc_us = centre_.session().now_us(),
                      .recordedBy = "office"});
}

std::string XapiCentre::enrol(const std::string& traineeCode) {
  StudyRepository studies(connection());
  IdSource& ids = centre_.session().ids();
  const std::int64_t now_us = centre_.session().now_us();
  const CohortId cohort = ids.newUuid();
  studies.addCohort({cohort, "Spring course " + std::to_string(++cohorts_), "", now_us, false}, {});
  Enrolment enrolment;
  enrolment.id = ids.newUuid();
  enrolment.cohortId = cohort;
  enrolment.traineeId = person(traineeCode);
  enrolment.enrolledUtc_us = now_us;
  studies.enrol({&enrolment, 1});
  return enrolment.id;
}

std::string XapiCentre::run(double skill) {
  const std::string trial = centre_.attempt("first", "practice", skill);
  const auto module = CurriculumRepository(connection()).module(centre_.module("first"));
  ExerciseRules rules;
  (void)competenceOf(connection(), "T-01", *module, rules, centre_.session().now_us());
  return trial;
}

std::vector<LearningEvent> XapiCentre::outbox() {
  std::vector<LearningEvent> all;
  for (const LearningEventState state :
       {LearningEventState::kWaiting, LearningEventState::kDelivered, LearningEventState::kDead}) {
    const auto some = LearningRepository(connection()).inState(state, 1'000);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

LearningEventCounts XapiCentre::counts() {
  return LearningRepository(connection()).counts();
}

LrsDelivery XapiCentre::deliver(std::chrono::milliseconds patience) {
  const auto identity = lrsIdentity(connection());
  const auto key = stationLrsKey();
  LrsClient client(identity->settings.endpoint, *key, patience);
  return deliverLearningRecords(connection(), *identity, client,
                                [this] { return centre_.session().now_us(); });
}

}  // namespace torsio
