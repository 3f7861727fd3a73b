// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/curriculum_repository.h"

#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

class CurriculumRepositoryTest : public SampleTest {
 protected:
  CurriculumRepository curricula() { return CurriculumRepository(connection()); }
  /// Paper section 6, groups 1 and 2: 40 min virtual; 20 min virtual and 20 min real; marks before, between,
  /// after.
  static CurriculumVersion versionFor(Connection& connection, SampleRecord& sample) {
    const Curriculum curriculum{sample.ids.newUuid(), "Paper protocol", "", kSampleTime_us, true};
    CurriculumRepository(connection).addCurriculum(curriculum);
    CurriculumVersion version;
    version.id = sample.ids.newUuid();
    version.curriculumId = curriculum.id;
    version.note = "first";
    version.createdUtc_us = kSampleTime_us;
    TrainingModule basic{.id = sample.ids.newUuid(), .code = "basic", .title = "Turn to 30 degrees"};
    basic.targetAngle_rad = 1.0 / 3.0;
    basic.maxForce_N = 3.3;
    basic.mastery = {{"path length", "at_most", 0.25, "m", 2}, {"time", "at_most", 12.5, "s", 3}};
    TrainingModule hard{.id = sample.ids.newUuid(), .code = "hard", .title = "Turn and hold"};
    hard.mode = AttemptMode::kGraded;
    hard.attemptLimit = 5;
    hard.requires_ = {basic.id};
    version.modules = {basic, hard};
    version.arms = {{sample.ids.newUuid(), "A", "40 min virtual", 5 * kMinute_us, false, {}},
                    {sample.ids.newUuid(), "B", "20 min virtual, 20 min real", 5 * kMinute_us, true, {}}};
    version.arms[0].phases = {
        {sample.ids.newUuid(), PhaseKind::kVirtual, "virtual 0-40 min", 40 * kMinute_us, basic.id}};
    version.arms[1].phases = {
        {sample.ids.newUuid(), PhaseKind::kVirtual, "virtual 0-20 min", 20 * kMinute_us, ""},
        {sample.ids.newUuid(), PhaseKind::kReal, "real 20-40 min", 20 * kMinute_us, ""}};
    version.plannedOccasions = {{"pre", 0}, {"mid", 20 * kMinute_us}, {"post", 40 * kMinute_us}};
    return version;
  }
};

TEST_F(CurriculumRepositoryTest, ReturnsAVersionWithAllItsParts) {
  const CurriculumVersion version = versionFor(connection(), sample());

  curricula().addVersion(version, "admin");

  const CurriculumVersion stored = curricula().version(version.id).value();
  EXPECT_EQ(stored.state, CurriculumState::kDraft);
  ASSERT_EQ(stored.modules.size(), 2U);
  EXPECT_EQ(stored.modules[0].targetAngle_rad, 1.0 / 3.0);
  EXPECT_EQ(stored.modules[0].maxForce_N, 3.3);
  EXPECT_FALSE(stored.modules[0].attemptLimit.has_value());
  ASSERT_EQ(stored.modules[0].mastery.size(), 2U);
  EXPECT_EQ(stored.modules[0].mastery[1].threshold, 12.5);
  EXPECT_EQ(stored.modules[0].mastery[1].consecutive, 3);
  EXPECT_EQ(stored.modules[1].attemptLimit, 5);
  EXPECT_EQ(stored.modules[1].requires_, (std::vector<ModuleId>{version.modules[0].id}));
  ASSERT_EQ(stored.arms.size(), 2U);
  EXPECT_EQ(stored.arms[0].phases.at(0).moduleId, version.modules[0].id);
  EXPECT_TRUE(stored.arms[1].restSplittable);
  ASSERT_EQ(stored.arms[1].phases.size(), 2U);
  EXPECT_EQ(stored.arms[1].phases[1].kind, PhaseKind::kReal);
  EXPECT_EQ(stored.arms[1].phases[1].duration_us, 20 * kMinute_us);
  ASSERT_EQ(stored.plannedOccasions.size(), 3U);
  EXPECT_EQ(stored.plannedOccasions[2].code, "post");
  EXPECT_EQ(curricula().versionIds(version.curriculumId), (std::vector<CurriculumVersionId>{version.id}));
  EXPECT_EQ(curricula().curricula().at(0).name, "Paper protocol");
}

TEST_F(CurriculumRepositoryTest, RejectsCyclicPrerequisites) {
  CurriculumVersion version = versionFor(connection(), sample());
  version.modules[0].requires_ = {version.modules[1].id};
  EXPECT_EQ(refusalFrom([&] { CurriculumRepository(connection()).addVersion(version, "admin"); }).code,
            ErrorCode::kBadData);

  version.modules[0].requires_ = {"elsewhere"};
  EXPECT_EQ(refusalFrom([&] { CurriculumRepository(connection()).addVersion(version, "admin"); }).code,
            ErrorCode::kBadData);
  EXPECT_TRUE(CurriculumRepository(connection()).versionIds(version.curriculumId).empty());
}

TEST_F(CurriculumRepositoryTest, MovesFromDraftToRunningToClosedAndMayRunAgain) {
  const CurriculumVersion version = versionFor(connection(), sample());
  curricula().addVersion(version, "admin");
  const auto move = [&](CurriculumState state) {
    curricula().moveTo(version.id, state, "admin", kSampleTime_us);
  };

  EXPECT_EQ(refusalFrom([&] { move(CurriculumState::kClosed); }).code, ErrorCode::kBadData);
  move(CurriculumState::kRunning);
  EXPECT_EQ(refusalFrom([&] { move(CurriculumState::kDraft); }).code, ErrorCode::kBadData);
  move(CurriculumState::kClosed);
  EXPECT_EQ(refusalFrom([&] { move(CurriculumState::kDraft); }).code, ErrorCode::kBadData);
  EXPECT_EQ(curricula().version(version.id)->state, CurriculumState::kClosed);
  move(CurriculumState::kRunning);
  EXPECT_EQ(curricula().version(version.id)->state, CurriculumState::kRunning);
  move(CurriculumState::kClosed);
  EXPECT_EQ(curricula().version(version.id)->state, CurriculumState::kClosed);
}

TEST_F(CurriculumRepositoryTest, AVersionIsImmutable) {
  CurriculumRepository(connection()).addVersion(versionFor(connection(), sample()), "admin");

  for (const std::string table :
       {"curriculum_version", "curriculum_state", "module", "module_prerequisite", "mastery_rule",
        "curriculum_arm", "curriculum_phase", "curriculum_occasion"}) {
    EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM " + table); }), DbFault::kAppendOnly)
        << table;
  }
}

TEST_F(CurriculumRepositoryTest, KeepsCompetenceDesignsPermanently) {
  const CurriculumVersion version = versionFor(connection(), sample());
  CurriculumRepository(connection()).addVersion(version, "admin");
  CompetenceRepository designs(connection());
  CompetenceDesign design{.moduleId = version.modules[0].id,
                          .registeredUtc_us = kSampleTime_us,
                          .tolerance_rad = 1.0 / 3.0,
                          .source = ToleranceSource::kExperts,
                          .experts = 9,
                          .adequate = 0.05,
                          .inadequate = 0.2,
                          .attempts = 100,
                          .falsePassMost = 0.01,
                          .falseFailMost = 0.2,
                          .sessionCorrelation = 0.2,
                          .lagCorrelation = 0.0,
                          .runsPerSession = 3,
                          .dependenceRuns = 512,
                          .validDays = 365,
                          .limit = 4.79,
                          .reason = "as our experts do"};

  EXPECT_EQ(designs.add(design).version, 1);
  EXPECT_EQ(designs.add(design).version, 2);

  design.version = 2;
  EXPECT_EQ(designs.ofModule(design.moduleId).at(1), design);
  EXPECT_TRUE(designs.ofModule(version.modules[1].id).empty());
  // Of schema 1: it keeps its limit, and the dependence of runs is assumed.
  connection().executeVerbatim(
      "INSERT INTO competence_design SELECT module_id, 3, registered_utc_us, tolerance_rad, tolerance_source,"
      " experts, adequate, inadequate, attempts, false_pass_most, false_fail_most, sum_limit, reason,"
      " NULL, NULL, NULL, NULL, NULL FROM competence_design WHERE version = 2");
  const CompetenceDesign old = designs.ofModule(design.moduleId).at(2);
  EXPECT_EQ(old.limit, design.limit);
  EXPECT_EQ(old.runsPerSession, CompetenceDesign{}.runsPerSession);
  EXPECT_EQ(old.lagCorrelation, CompetenceDesign{}.lagCorrelation);
  EXPECT_EQ(old.dependenceRuns, 0);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE competence_design SET attempts = 10"); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM competence_design"); }), DbFault::kAppendOnly);
}

TEST_F(CurriculumRepositoryTest, AssignsARunningVersionToACohort) {
  const CurriculumVersion version = versionFor(connection(), sample());
  curricula().addVersion(version, "admin");
  EXPECT_EQ(refusalFrom([&] { curricula().assign(sample().cohort.id, version.id); }).code,
            ErrorCode::kBadData);
  curricula().moveTo(version.id, CurriculumState::kRunning, "admin", kSampleTime_us);

  curricula().assign(sample().cohort.id, version.id);

  EXPECT_EQ(numberFrom(connection(),
                       "SELECT count(*) FROM training_group g JOIN curriculum_arm a ON a.id = g.arm_id"
                       " WHERE a.number = g.number"),
            2);
}

TEST_F(CurriculumRepositoryTest, NeverOverwritesAnotherUsersDraft) {
  const std::string id = versionFor(connection(), sample()).curriculumId;
  EXPECT_FALSE(curricula().draft(id).has_value());
  CurriculumDraftRow draft{0, "{}", "anna", kSampleTime_us};
  EXPECT_EQ(curricula().saveDraft(id, draft), 1);

  Connection other = open();
  EXPECT_EQ(faultFrom([&] {
              CurriculumRepository(other).saveDraft(id, {0, "[]", "ben", 1});
            }),
            DbFault::kConflict);
  EXPECT_EQ(CurriculumRepository(other).saveDraft(id, {1, "[1]", "ben", 2}), 2);
  EXPECT_EQ(faultFrom([&] { curricula().saveDraft(id, {1, "{}", "anna", 3}); }), DbFault::kConflict);

  EXPECT_EQ(curricula().draft(id)->contentJson, "[1]");
  EXPECT_EQ(curricula().draft(id)->changedBy, "ben");
}

}  // namespace
}  // namespace torsio
