// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/people_repository.h"

#include <regex>

#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/id_source.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

class PeopleRepositoryTest : public SampleTest {
 protected:
  PeopleRepository people() { return PeopleRepository(connection()); }
};

TEST_F(PeopleRepositoryTest, ReturnsTraineesAsStored) {
  const SampleRecord sample(connection(), 3);

  const std::vector<Trainee> trainees = people().trainees();

  ASSERT_EQ(trainees.size(), 3U);
  const Person& person = trainees[1].person;
  EXPECT_EQ(person.id, sample.trainees[1].person.id);
  EXPECT_EQ(person.code, "T-02");
  EXPECT_EQ(person.sex, "male");
  EXPECT_EQ(person.level, "graduate");
  EXPECT_EQ(person.experience, "");
  EXPECT_EQ(person.age_years, 24);
  EXPECT_EQ(person.state, PersonState::kActive);
  EXPECT_EQ(person.createdUtc_us, kSampleTime_us);
  EXPECT_TRUE(person.demonstration);
  EXPECT_EQ(trainees[1].handedness, "right");
}

TEST_F(PeopleRepositoryTest, KeepsRatersOrderedByClass) {
  people().makeRater(sample().trainees[0].person.id, "intern");  // interns use the simulator and rate it

  const std::vector<Rater> raters = people().raters();
  ASSERT_EQ(raters.size(), 3U);
  EXPECT_EQ(raters[0].person.code, "T-01");
  EXPECT_EQ(raters[0].classCode, "intern");
  EXPECT_EQ(raters[2].person.code, "C-02");
  EXPECT_EQ(people().findRater("C-01")->classCode, "chief");
  EXPECT_FALSE(people().findRater("C-09").has_value());
  EXPECT_EQ(people().raterClasses().size(), 3U);
}

TEST_F(PeopleRepositoryTest, StoresNobodyOfARosterWithADuplicateCode) {
  std::vector<Trainee> roster(2);
  roster[0].person = {.id = sample().ids.newUuid(), .code = "T-50"};
  roster[1].person = {.id = sample().ids.newUuid(), .code = "T-01"};

  EXPECT_EQ(faultFrom([&] { people().addTrainees(roster); }), DbFault::kUnique);

  EXPECT_EQ(people().trainees().size(), 1U);
}

TEST_F(PeopleRepositoryTest, RefusesUnknownClassesAndSexes) {
  EXPECT_EQ(faultFrom([&] { people().makeRater(sample().trainees[0].person.id, "wizard"); }),
            DbFault::kForeignKey);
  std::vector<Trainee> odd(1);
  odd[0].person = {.id = sample().ids.newUuid(), .code = "T-60", .sex = "yes"};
  EXPECT_EQ(faultFrom([&] { people().addTrainees(odd); }), DbFault::kCheck);
}

TEST_F(PeopleRepositoryTest, KeepsNamesApartFromTheCodedRecord) {
  const SampleRecord sample(connection(), 2);
  const std::string id = sample.trainees[0].person.id;

  people().setIdentity({id, "Änne Müller", "", "S-123"});

  EXPECT_EQ(people().identity(id)->fullName, "Änne Müller");
  EXPECT_EQ(people().identity(id)->externalId, "S-123");
  EXPECT_FALSE(people().identity(sample.trainees[1].person.id).has_value());
  EXPECT_EQ(faultFrom([&] {
              people().setIdentity({sample.trainees[1].person.id, "Somebody", "", "S-123"});
            }),
            DbFault::kUnique);
}

TEST_F(PeopleRepositoryTest, NeverChangesAPseudonym) {
  const SampleRecord sample(connection(), 1);

  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE person SET code = ?", {"T-99"}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE person SET demonstration = ?", {false}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(connection().execute("UPDATE person SET state = ? WHERE code = ?", {"left", "T-01"}), 1);
}

TEST_F(PeopleRepositoryTest, TheNewestConsentCounts) {
  const std::string id = sample().trainees[0].person.id;
  EXPECT_FALSE(people().hasConsent(id, "video"));

  people().recordConsent({id, "video", true, "2", kSampleTime_us, "admin", true});
  EXPECT_TRUE(people().hasConsent(id, "video"));
  EXPECT_FALSE(people().hasConsent(id, "research"));
  people().recordConsent({id, "video", false, "2", kSampleTime_us + 1, "admin", true});

  EXPECT_FALSE(people().hasConsent(id, "video"));
  const std::vector<ConsentDecision> decisions = people().consents(id);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_TRUE(decisions[0].granted);
  EXPECT_EQ(decisions[1].textVersion, "2");
  EXPECT_EQ(faultFrom([&] {
              people().recordConsent({id, "selling", true, "1", 0, "admin", true});
            }),
            DbFault::kForeignKey);
  people().recordConsent(
      {id, "video", true, "3", kSampleTime_us + 2, "admin", true, ConsentForm::kPaper, kSampleTime_us - 7});
  EXPECT_EQ(people().consents(id).back().form, ConsentForm::kPaper);
  EXPECT_EQ(people().consents(id).back().signedUtc_us, kSampleTime_us - 7);
  EXPECT_EQ(people().consents(id).front().signedUtc_us, 0);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE consent SET granted = ?", {true}); }),
            DbFault::kAppendOnly);
}

/// Matches a UUID in lower case.
const std::regex kUuid("[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}");

TEST(IdSource, GeneratesVersionFourUuids) {
  SystemIdSource system;
  const std::string id = system.newUuid();
  EXPECT_TRUE(std::regex_match(id, kUuid)) << id;
  EXPECT_EQ(id[14], '4');
  EXPECT_NE(id, system.newUuid());
}

TEST(IdSource, RepeatsTheIdsForASeed) {
  SeededIdSource first(1);
  SeededIdSource again(1);
  SeededIdSource other(2);
  const std::string id = first.newUuid();
  EXPECT_TRUE(std::regex_match(id, kUuid)) << id;
  EXPECT_EQ(id, again.newUuid());
  EXPECT_NE(id, other.newUuid());
}

}  // namespace
}  // namespace torsio
