// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/curriculum.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/rubric_service.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet_check.h"
#include "db/connection/db_error.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "sim/scene/scene_file.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

CurriculumVersion shipped(const StudyCentre& centre, const std::string& id) {
  for (CurriculumTemplate& one : curriculumTemplates(centre.assets())) {
    if (one.id == id) {
      return one.content;
    }
  }
  throw std::runtime_error("no template " + id);
}

bool mentions(const std::vector<CurriculumProblem>& problems, const std::string& where,
              const std::string& what) {
  return std::any_of(problems.begin(), problems.end(), [&](const CurriculumProblem& problem) {
    return problem.where.str().find(where) != std::string::npos &&
           problem.what.str().find(what) != std::string::npos && !problem.remedy.empty();
  });
}

TEST(CurriculumTemplates, AllCanBePublished) {
  StudyCentre centre;
  const auto templates = curriculumTemplates(centre.assets());

  ASSERT_GE(templates.size(), 2U);
  for (const CurriculumTemplate& one : templates) {
    EXPECT_TRUE(
        curriculumProblems(one.content, centre.assets(), OccasionRepository(centre.connection()).all())
            .empty())
        << one.id;
  }
}

// The course and free practice judge an untwisting alike: the limits are those of the scenes.
TEST(CurriculumTemplates, TheCourseOfUntwistingHasTheLimitsOfItsScenes) {
  StudyCentre centre;
  for (const TrainingModule& module : shipped(centre, "volvulus").modules) {
    const SceneDescription scene = readSceneFile(centre.assets(), module.sceneId);
    const TwistPattern& pattern = scene.patterns.front().pattern;

    EXPECT_EQ(module.maxForce_N, pattern.forceLimit_N) << module.id;
    EXPECT_EQ(module.maxTorque_Nm, pattern.torqueLimit_Nm) << module.id;
  }
}

TEST(CurriculumTemplates, PaperProtocolMatchesTheStudy) {
  StudyCentre centre;

  const CurriculumVersion paper = shipped(centre, "paper-three-arms");

  // Paper section 6: 40 min virtual; 20 + 20 min; 40 min real; rest of 5 min; marks before, at 20 and at 40
  // min.
  ASSERT_EQ(paper.arms.size(), 3U);
  std::vector<std::string> kinds;
  for (const StudyArm& arm : paper.arms) {
    EXPECT_EQ(arm.restAllowance_us, 5 * kMinute_us);
    EXPECT_FALSE(arm.restSplittable);
    std::string text;
    for (const TrainingPhase& phase : arm.phases) {
      text += std::string(storedText(phase.kind)) + std::to_string(phase.duration_us / kMinute_us) + " ";
    }
    kinds.push_back(text);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"virtual20 virtual20 ", "virtual20 real20 ", "real20 real20 "}));
  ASSERT_EQ(paper.plannedOccasions.size(), 3U);
  EXPECT_EQ(paper.plannedOccasions[1].afterExposure_us, 20 * kMinute_us);
  EXPECT_EQ(paper.plannedOccasions[2].afterExposure_us, 40 * kMinute_us);
}

TEST(CurriculumContent, SurvivesARoundTripThroughText) {
  StudyCentre centre;
  for (const CurriculumTemplate& one : curriculumTemplates(centre.assets())) {
    const std::string text = curriculumJson(one.content);
    EXPECT_EQ(curriculumJson(parseCurriculum(text, one.id)), text) << one.id;
  }
}

TEST(CurriculumContent, RejectsMisspeltFieldsWithTheirPlace) {
  const Error error = testing::refusal([] {
    (void)parseCurriculum(
        R"({"format": "torsio curriculum 1", "modules": [{"code": "A", "target_degree": 5}]})", "draft");
  });
  EXPECT_EQ(error.where(), "draft, modules 1");
  EXPECT_NE(error.happened().find("target_degree"), std::string::npos);
  EXPECT_THROW((void)parseCurriculum("{", "draft"), Error);
  EXPECT_THROW((void)parseCurriculum(R"({"format": "torsio curriculum 9"})", "draft"), Error);
}

TEST(CurriculumContent, ListsEveryProblemWithItsPlaceAndRemedy) {
  StudyCentre centre;
  CurriculumVersion broken = shipped(centre, "first-steps");
  broken.modules[0].sceneId = "liver";
  broken.modules[1].patternId = "loop";
  broken.modules[1].targetAngle_rad = 0.0;
  broken.modules[2].code = broken.modules[1].code;
  broken.modules[3].requires_ = {"Z9"};
  broken.modules[4].mastery[0].metric = "beauty";
  broken.modules[5].mastery[0].unit = "kg";
  broken.arms.push_back({"", "G1", "", 0, false, {{"", PhaseKind::kVirtual, "", 0, "Z9"}}});
  broken.plannedOccasions = {{"mid", 4}, {"pre", 5}, {"later", 1}};

  const auto problems =
      curriculumProblems(broken, centre.assets(), OccasionRepository(centre.connection()).all());

  EXPECT_TRUE(mentions(problems, "module A1", "unknown scene \"liver\""));
  EXPECT_TRUE(mentions(problems, "module A2", "lacks"));
  EXPECT_TRUE(mentions(problems, "module A2", "target of 0"));
  EXPECT_TRUE(mentions(problems, "module A2", "code of another module"));
  EXPECT_TRUE(mentions(problems, "module I1", "not a module of this curriculum"));
  EXPECT_TRUE(mentions(problems, "mastery beauty", "measured by nothing"));
  EXPECT_TRUE(mentions(problems, "module S1", "given in \"kg\""));
  EXPECT_TRUE(mentions(problems, "arm G1, phase 1", "takes no time"));
  EXPECT_TRUE(mentions(problems, "occasion mid", "comes before"));
  EXPECT_TRUE(mentions(problems, "occasion \"later\"", "not known"));
}

TEST(CurriculumContent, RejectsATurnThatTheOrganCannotMake) {
  StudyCentre centre;
  CurriculumVersion far = shipped(centre, "first-steps");
  TrainingModule partial = far.modules[0];
  partial.requires_.clear();
  partial.sceneId = "stomach";
  partial.patternId = "partial";
  partial.targetAngle_rad = radians(-200.0);
  far.modules = {partial, partial};
  far.modules[0].code = "P1";
  far.modules[1].code = "P2";
  far.modules[1].targetAngle_rad = radians(300.0);

  const auto problems =
      curriculumProblems(far, centre.assets(), OccasionRepository(centre.connection()).all());

  EXPECT_FALSE(mentions(problems, "module P1", "degrees"));
  EXPECT_TRUE(mentions(problems, "module P2", "300 degrees"));
}

TEST(CurriculumContent, FindsCyclesOfPrerequisites) {
  StudyCentre centre;
  CurriculumVersion circle = shipped(centre, "first-steps");
  circle.modules[0].requires_ = {"A3"};

  EXPECT_TRUE(
      mentions(curriculumProblems(circle, centre.assets(), OccasionRepository(centre.connection()).all()),
               "A1", "require each other"));
}

TEST(CurriculumService, ADraftBecomesAVersionThatRunsAndCloses) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const CurriculumId id = addCurriculum(session, "Twists", "", shipped(centre, "first-steps"));
  const CurriculumVersionId version = publishCurriculum(session, id, "first", centre.assets());

  const auto stored = CurriculumRepository(session.connectionWithoutRight()).version(version);
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->state, CurriculumState::kDraft);
  EXPECT_EQ(stored->modules.size(), 9U);
  EXPECT_NE(stored->modules[0].id, stored->modules[0].code);
  EXPECT_EQ(stored->modules[1].requires_, std::vector<ModuleId>{stored->modules[0].id});
  EXPECT_THROW(closeCurriculum(session, version, "too early"), Error);
  runCurriculum(session, version);
  closeCurriculum(session, version, "replaced");

  EXPECT_EQ(curricula(session).at(0).versions.at(0).state, CurriculumState::kClosed);
  runCurriculum(session, version, "needed after all");
  EXPECT_EQ(curricula(session).at(0).versions.at(0).state, CurriculumState::kRunning);
  closeCurriculum(session, version, "no more");
  EXPECT_EQ(centre.audited("curriculum.publish"), 1);
  EXPECT_EQ(centre.audited("curriculum.running"), 2);
  EXPECT_EQ(centre.audited("curriculum.closed"), 2);
}

TEST(CurriculumService, NobodyOverwritesADraftOfSomebodyElse) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const CurriculumId id = addCurriculum(session, "Twists", "");
  CurriculumDraft mine = curriculumDraft(session, id);
  const CurriculumDraft theirs = mine;
  mine.content = shipped(centre, "paper-three-arms");
  saveCurriculumDraft(session, id, mine);

  EXPECT_THROW(saveCurriculumDraft(session, id, theirs), DbError);

  EXPECT_EQ(curriculumDraft(session, id).content.arms.size(), 3U);
}

TEST(CurriculumService, AnEmptyDraftIsSavedButNotPublished) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  const CurriculumId id = addCurriculum(session, "Twists", "");

  EXPECT_THROW((void)publishCurriculum(session, id, "", centre.assets()), Error);

  EXPECT_TRUE(curricula(session).at(0).hasDraft);
  EXPECT_TRUE(curricula(session).at(0).versions.empty());
}

TEST(RubricService, ShippedRubricHasThePapersCriteriaFromOneToTen) {
  StudyCentre centre;

  const RubricTemplate rubric = rubricTemplates(centre.assets()).at(0);

  // Paper section 6: training time, proficiency, operational accuracy; marks from 1 to 10.
  ASSERT_EQ(rubric.revision.rows.size(), 3U);
  EXPECT_EQ(rubric.revision.overall.lo, 10);
  EXPECT_EQ(rubric.revision.overall.hi, 100);
  EXPECT_EQ(rubric.revision.overall.stepsPerPoint, 10);
  EXPECT_EQ(rubric.revision.rows[0].code, "training_time");
  EXPECT_EQ(rubric.revision.rows[2].anchors.size(), 4U);
}

TEST(RubricService, RevisionsAreKeptAndInvalidOnesRejected) {
  StudyCentre centre;
  const std::string first = centre.addPaperRubric();
  SessionContext& session = centre.session();
  const RubricRow stored = rubrics(session).at(0);
  RubricRevision next = stored.revisions.at(0);
  next.rows.pop_back();

  const std::string second = reviseRubric(session, stored.id, next, "two criteria are enough");

  EXPECT_NE(first, second);
  EXPECT_EQ(rubrics(session).at(0).revisions.size(), 2U);
  EXPECT_EQ(rubrics(session).at(0).revisions[0].rows.size(), 3U);
  next.rows[0].anchors.push_back({1000, "beyond"});
  EXPECT_THROW(reviseRubric(session, stored.id, next, ""), Error);
  EXPECT_THROW(reviseRubric(session, "nothing", stored.revisions.at(0), ""), Error);
}

/// Care from 0 to 5 has twice the weight of time from 1 to 10.
RubricRevision twoRows() {
  RubricRevision rubric{.overall = {10, 100, 10}};
  rubric.rows = {{"time", "Time", {10, 100, 10}, {{10, "slow"}, {100, "brisk"}}, 1000},
                 {"care", "Care", {0, 5, 1}, {}, 2000}};
  return rubric;
}

TEST(RubricText, SurvivesARoundTrip) {
  RubricRevision rubric = twoRows();
  rubric.rows[0].anchors[0].meaning = "\u6162, \"slow\"";
  rubric.rows.push_back({"hold", "Hold", {-4, 6, 4}, {{-3, "below"}}, 0});

  const RubricTemplate read = parseRubric(rubricText("My sheet", rubric), "file");

  EXPECT_EQ(read.title, "My sheet");
  EXPECT_EQ(rubricText("My sheet", read.revision), rubricText("My sheet", rubric));
  ASSERT_EQ(read.revision.rows.size(), 3U);
  EXPECT_EQ(read.revision.rows[2].scale.lo, -4);
  EXPECT_EQ(read.revision.rows[2].anchors.at(0).score_steps, -3);
  EXPECT_EQ(read.revision.rows[1].weight_milli, 2000);
  EXPECT_EQ(read.revision.rows[2].weight_milli, 0);
}

TEST(RubricText, TheShippedSheetHasEqualWeights) {
  StudyCentre centre;

  for (const RubricTemplate& shipped : rubricTemplates(centre.assets())) {
    for (const RubricLine& row : shipped.revision.rows) {
      EXPECT_EQ(row.weight_milli, kDefaultWeight_milli) << shipped.id << ", " << row.code;
    }
  }
}

TEST(Rubric, StoresItsWeightsInTheRecord) {
  StudyCentre centre;
  centre.addPaperRubric();
  SessionContext& session = centre.as("administrator");
  const RubricRow before = rubrics(session).at(0);

  reviseRubric(session, before.id, twoRows(), "care counts twice");

  const RubricRow after = rubrics(session).at(0);
  ASSERT_EQ(after.revisions.size(), 2U);
  EXPECT_EQ(after.revisions[0].rows.at(0).weight_milli, 1000);
  EXPECT_EQ(after.revisions[1].rows.at(1).weight_milli, 2000);
  EXPECT_EQ(after.revisions[1].note, "care counts twice");
}

TEST(Rubric, RejectsASheetThatNobodyCanFillIn) {
  const auto refused = [](const std::function<void(RubricRevision&)>& spoil) {
    RubricRevision rubric = twoRows();
    spoil(rubric);
    EXPECT_THROW(checkRubric(rubric), Error);
  };
  EXPECT_NO_THROW(checkRubric(twoRows()));

  refused([](RubricRevision& r) { r.rows.clear(); });
  refused([](RubricRevision& r) { r.rows[0].label.clear(); });
  refused([](RubricRevision& r) { r.rows[1].code = r.rows[0].code; });
  refused([](RubricRevision& r) { r.rows[0].scale.hi = r.rows[0].scale.lo; });
  refused([](RubricRevision& r) { r.rows[0].anchors[0].score_steps = 101; });
  refused([](RubricRevision& r) { r.rows[0].anchors[1].score_steps = 10; });
  refused([](RubricRevision& r) { r.rows[0].anchors[0].meaning.clear(); });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = r.rows[1].weight_milli = 0; });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = -1; });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = 100'001; });
}

TEST(Rubric, CreatesAUniqueCodeForEachCriterion) {
  const RubricRevision rubric = twoRows();

  EXPECT_EQ(codeForCriterion(rubric, "Grip, of the organ!"), "grip_of_the_organ");
  EXPECT_EQ(codeForCriterion(rubric, "TIME"), "time_2");
  EXPECT_EQ(codeForCriterion(rubric, "\u65f6\u95f4"), "criterion");
}

TEST(CriteriaMean, WeighsEachCriterionOnItsOwnScale) {
  const RubricRevision rubric = twoRows();

  // Time 5.5 of 1..10 is 0.5 of it, care 4 of 0..5 is 0.8: (0.5 + 2 * 0.8) / 3 = 0.7; 1 + 9 * 0.7 = 7.3
  const std::optional<double> mean =
      criteriaMean(rubric, std::vector<SheetRow>{{"time", 55, ""}, {"care", 4, ""}});

  ASSERT_TRUE(mean);
  EXPECT_NEAR(*mean, 7.3, 1e-12);
}

TEST(CriteriaMean, IsEmptyIfAWeightedCriterionWasNotScored) {
  RubricRevision rubric = twoRows();
  const std::vector<SheetRow> careMissing{{"time", 55, ""}, {"care", std::nullopt, "not seen"}};

  EXPECT_FALSE(criteriaMean(rubric, careMissing));
  EXPECT_FALSE(criteriaMean(rubric, std::vector<SheetRow>{{"time", 55, ""}}));
  rubric.rows[1].weight_milli = 0;
  EXPECT_DOUBLE_EQ(criteriaMean(rubric, careMissing).value(), 5.5);
}

}  // namespace
}  // namespace torsio
