// SPDX-License-Identifier: GPL-3.0-or-later
// What the consent promises: trainees can request a copy of their record, or its erasure.
#include "app/services/people/person_requests.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

/// Signs in the user "trainee" as this person of the record.
SessionContext& asTrainee(StudyCentre& centre, const TraineeId& person) {
  SessionContext& session = centre.as("trainee");
  Actor actor = session.actor();
  actor.personId = person;
  session.setActor(actor);
  return session;
}

TEST(PersonRequests, GoFromTheTraineesPageToTheAdministratorsListAndBack) {
  StudyCentre centre;
  const std::vector<TraineeId> people = centre.addTrainees(2);

  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kExport);
  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase);
  EXPECT_THROW(requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase), Error)
      << "it waits already";
  requestAboutOwnRecord(asTrainee(centre, people[1]), PersonRequestKind::kExport);

  EXPECT_EQ(ownRequests(asTrainee(centre, people[0])).size(), 2U) << "nobody sees another one's";
  const std::vector<PersonRequest> all = personRequests(centre.as("administrator"));
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(centre.audited("person.request"), 3);
  for (const PersonRequest& one : all) {
    if (one.kind == PersonRequestKind::kErase) {
      EXPECT_EQ(one.personCode, "T-01");
      EXPECT_THROW(answerPersonRequest(centre.as("administrator"), one.id, false, ""), Error);
      answerPersonRequest(centre.as("administrator"), one.id, false, "the study still runs");
      EXPECT_THROW(answerPersonRequest(centre.as("administrator"), one.id, true, "twice"), Error);
    } else if (one.personId == people[0]) {
      answerPersonRequest(centre.as("administrator"), one.id, true, "handed over");
    } else {
      EXPECT_THROW(takeBackOwnRequest(asTrainee(centre, people[0]), one.id), Error) << "not theirs";
      takeBackOwnRequest(asTrainee(centre, people[1]), one.id);
    }
  }
  for (const PersonRequest& one : ownRequests(asTrainee(centre, people[0]))) {
    EXPECT_EQ(one.answer, one.kind == PersonRequestKind::kErase ? PersonRequestAnswer::kDeclined
                                                                : PersonRequestAnswer::kDone);
    EXPECT_FALSE(one.reason.empty());
  }
  EXPECT_EQ(ownRequests(asTrainee(centre, people[1])).at(0).answer, PersonRequestAnswer::kTakenBack);
  EXPECT_EQ(centre.audited("person.request_answer"), 3);
  requestAboutOwnRecord(asTrainee(centre, people[0]), PersonRequestKind::kErase);  // may request again
}

TEST(PersonRequests, AreForPeopleOfTheRecord) {
  StudyCentre centre;
  EXPECT_THROW(requestAboutOwnRecord(asTrainee(centre, {}), PersonRequestKind::kExport), Error);
}

}  // namespace
}  // namespace torsio
