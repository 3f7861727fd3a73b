// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/study_repository.h"

#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "sim/core/error.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

class StudyRepositoryTest : public SampleTest {
 protected:
  StudyRepository study() { return StudyRepository(connection()); }
  LockedDesign lockedDesign(SampleRecord& sample) {
    LockedDesign design{.id = sample.ids.newUuid(),
                        .cohortId = sample.cohort.id,
                        .algorithm = "complete",
                        .algorithmVersion = "1",
                        .parametersJson = R"({"arms":2})",
                        .generator = "mt19937_64",
                        .seedCommitment = "c0ffee",
                        .seed = "20240601",
                        .lockedUtc_us = kSampleTime_us,
                        .demonstration = true};
    study().lockDesign(design);
    return design;
  }
  /// Allocates trainees to the two groups alternately.
  static std::vector<AllocationEntry> allocationsFor(SampleRecord& sample, const DesignId& designId) {
    std::vector<AllocationEntry> records;
    for (std::size_t i = 0; i < sample.enrolments.size(); ++i) {
      AllocationEntry record;
      record.id = sample.ids.newUuid();
      record.designId = designId;
      record.sequence = static_cast<std::int64_t>(i) + 1;
      record.enrolmentId = sample.enrolments[i].id;
      record.groupId = sample.groups[i % 2].id;
      record.numberInGroup = static_cast<std::int64_t>(i / 2) + 1;
      record.covariatesJson = R"({"sex":"female"})";
      record.countsBeforeJson = "[0,0]";
      record.drawBefore = static_cast<std::int64_t>(i);
      record.drawAfter = static_cast<std::int64_t>(i) + 1;
      record.enrolledBy = "admin";
      record.allocatedBy = "torsio";
      record.softwareVersion = "0.1.0";
      record.allocatedUtc_us = kSampleTime_us;
      record.demonstration = true;
      records.push_back(record);
    }
    return records;
  }
};

TEST_F(StudyRepositoryTest, KeepsTheCentre) {
  EXPECT_FALSE(study().centre().has_value());

  study().setCentre({"id", "Skills Laboratory", kSampleTime_us, true});
  study().setCentre({"id", "Surgical Skills Laboratory", kSampleTime_us, true});

  EXPECT_EQ(study().centre()->name, "Surgical Skills Laboratory");
  EXPECT_TRUE(study().centre()->demonstration);
}

TEST_F(StudyRepositoryTest, KeepsCohortsWithTheirGroups) {
  const std::vector<StudyGroup> groups = study().groups(sample().cohort.id);
  ASSERT_EQ(study().cohorts().size(), 1U);
  EXPECT_EQ(study().cohorts()[0].name, "Autumn");
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[1].code, "G2");
  EXPECT_EQ(groups[1].label, "20 min virtual, 20 min real");
}

TEST_F(StudyRepositoryTest, EnrolsATraineeOncePerCohort) {
  Enrolment again = sample().enrolments[0];
  again.id = sample().ids.newUuid();

  EXPECT_EQ(faultFrom([&] { StudyRepository(connection()).enrol(std::vector<Enrolment>{again}); }),
            DbFault::kUnique);
}

TEST_F(StudyRepositoryTest, AllocatesAndListsByGroupAndNumber) {
  SampleRecord sample(connection(), 4);
  const LockedDesign design = lockedDesign(sample);
  EXPECT_EQ(study().enrolments(sample.cohort.id)[0].groupCode, "");

  study().allocate(allocationsFor(sample, design.id));

  const std::vector<Enrolment> enrolments = study().enrolments(sample.cohort.id);
  ASSERT_EQ(enrolments.size(), 4U);
  const std::vector<std::string> codes{enrolments[0].traineeCode, enrolments[1].traineeCode,
                                       enrolments[2].traineeCode, enrolments[3].traineeCode};
  EXPECT_EQ(codes, (std::vector<std::string>{"T-01", "T-03", "T-02", "T-04"}));
  EXPECT_EQ(enrolments[1].groupCode, "G1");
  EXPECT_EQ(enrolments[1].numberInGroup, 2);
}

TEST_F(StudyRepositoryTest, ChainsTheAllocationRecords) {
  SampleRecord sample(connection(), 3);
  const LockedDesign design = lockedDesign(sample);

  const std::vector<AllocationEntry> stored = study().allocate(allocationsFor(sample, design.id));

  EXPECT_EQ(stored[0].previousHash, "");
  EXPECT_EQ(stored[1].previousHash, stored[0].recordHash);
  EXPECT_FALSE(study().firstBrokenAllocation(design.id).has_value());
  const std::vector<AllocationEntry> read = study().allocations(design.id);
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[2].recordHash, stored[2].recordHash);
  EXPECT_EQ(read[2].drawAfter, 3);
  EXPECT_EQ(read[2].covariatesJson, R"({"sex":"female"})");
}

TEST_F(StudyRepositoryTest, DetectsATamperedRecord) {
  SampleRecord sample(connection(), 3);
  const LockedDesign design = lockedDesign(sample);
  study().allocate(allocationsFor(sample, design.id));

  // The gate of an erase is the only way past the triggers; the chain still reveals the change.
  connection().execute("INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (?, ?, ?)", {"x", "", 0});
  connection().execute("UPDATE allocation SET group_id = ? WHERE sequence = ?", {sample.groups[0].id, 2});

  EXPECT_EQ(study().firstBrokenAllocation(design.id), 2);
}

TEST_F(StudyRepositoryTest, RejectsAllocationsOutOfSequence) {
  SampleRecord sample(connection(), 2);
  const LockedDesign design = lockedDesign(sample);
  std::vector<AllocationEntry> records = allocationsFor(sample, design.id);
  records[1].sequence = 3;

  EXPECT_EQ(refusalFrom([&] { study().allocate(records); }).code, ErrorCode::kBadData);
  EXPECT_TRUE(study().allocations(design.id).empty());
}

TEST_F(StudyRepositoryTest, HidesTheSeedUntilItIsRevealed) {
  const LockedDesign design = lockedDesign(sample());
  EXPECT_EQ(study().designs(sample().cohort.id).at(0).seed, "");
  EXPECT_EQ(study().designs(sample().cohort.id).at(0).seedCommitment, "c0ffee");

  study().revealSeed(design.id, kSampleTime_us + 1);

  EXPECT_EQ(study().designs(sample().cohort.id).at(0).seed, "20240601");
}

TEST_F(StudyRepositoryTest, AllocationsAreImmutable) {
  const LockedDesign design = lockedDesign(sample());
  study().allocate(allocationsFor(sample(), design.id));

  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE allocation SET draw_after = ?", {9}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM allocation"); }), DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE allocation_seed SET seed = ?", {"1"}); }),
            DbFault::kAppendOnly);
}

TEST_F(StudyRepositoryTest, StoresExposureRestAndDeviations) {
  const std::string enrolment = sample().enrolments[0].id;

  study().addExposures(std::vector<Exposure>{{sample().ids.newUuid(), enrolment, "", ExposureKind::kVirtual,
                                              kSampleTime_us, 600'000'000, "station-1", true},
                                             {sample().ids.newUuid(), enrolment, "", ExposureKind::kRest,
                                              kSampleTime_us + 1, 300'000'000, "station-1", true}});
  study().addDeviation({sample().ids.newUuid(), sample().cohort.id, enrolment, "device failed", "cable",
                        kSampleTime_us, "admin", kSampleTime_us + 5, true});

  const std::vector<Exposure> exposures = study().exposures(sample().cohort.id);
  ASSERT_EQ(exposures.size(), 2U);
  EXPECT_EQ(exposures[1].kind, ExposureKind::kRest);
  EXPECT_EQ(exposures[1].duration_us, 300'000'000);
  const std::vector<ProtocolDeviation> deviations = study().deviations(sample().cohort.id);
  ASSERT_EQ(deviations.size(), 1U);
  EXPECT_EQ(deviations[0].description, "cable");
  EXPECT_EQ(deviations[0].enrolmentId, enrolment);
}

}  // namespace
}  // namespace torsio
