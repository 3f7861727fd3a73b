// SPDX-License-Identifier: GPL-3.0-or-later
// Round trip of a data set: exported, imported into an empty record and exported again, the files are the
// same.
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/connectors/foreign/foreign_import.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/station_anchor.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/study/study_statements.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/results/cohort_report.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using testing::OwnFolder;

/// Two seconds: grip, turn to 30 degrees, release.
Trial twistedTrial(std::size_t number, const std::string& trainee, const TrainingModule& module,
                   bool simulated) {
  std::vector<Sample> samples(2'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / 1'000.0;
    DeviceReading reading;
    reading.time_us = static_cast<std::int64_t>(i) * 1'000;
    reading.pose.position_m = {0.1 * t, -0.02 / static_cast<double>(number), 1.0 / 3.0};
    reading.pose.orientation = {0.6, 0.0, 0.8, 0.1 * t};
    samples[i].tick = static_cast<std::int64_t>(i);
    samples[i].device = quantize(reading, {});
    samples[i].phase = i < 200     ? ExercisePhase::kContact
                       : i < 1'500 ? ExercisePhase::kTwisting
                                   : ExercisePhase::kReleased;
    samples[i].contact = kContactJaw;
    samples[i].response.angle_rad = i < 1'500 ? radians(15.0 * t) : 0.0;
    samples[i].response.torque_Nm = 0.01 * t;
  }
  Trial trial;
  TrialHeader& header = trial.header;
  header.trialId = "00000000-0000-4000-8000-00000000000" + std::to_string(number);
  header.traineeCode = trainee;
  header.sceneId = module.sceneId;
  header.patternId = module.patternId;
  header.organHash = "0f";
  header.parameterHash = "ab12";
  header.parametersJson = "{\"shear_modulus_Pa\": 3000}";
  header.deviceModel = "scripted hand";
  header.softwareVersion = "0.1";
  header.demonstration = simulated;
  header.phaseLabel = "virtual 0-20 min";
  header.targetAngle_rad = radians(22.0);
  header.startedUtc_us = kStudyTime_us + static_cast<std::int64_t>(number) * 1'000'000;
  trial.chunks.push_back(encodeChunk(0, std::span(samples).first(1'000)));
  trial.chunks.push_back(encodeChunk(1, std::span(samples).subspan(1'000)));
  trial.summary.samples = 2'000;
  trial.summary.contentHash = contentHash(trial);
  return trial;
}

/// A study with everything that a data set can restore.
CohortId studyIn(StudyCentre& centre, bool simulated = false) {
  const std::vector<TraineeId> trainees = centre.addTrainees(6);
  const std::vector<RaterId> raters = centre.addChiefs(2);
  const std::string version = centre.runPaperCurriculum();
  const CohortId cohort = addCohort(centre.session(), {.name = "Study, \"first\"",
                                                       .description = "of\ntwo lines",
                                                       .curriculumVersionId = version,
                                                       .demonstration = simulated});
  enrolTrainees(centre.session(), cohort, trainees);
  centre.allocate(cohort);
  centre.as("administrator");
  const std::vector<Enrolment> enrolments = StudyRepository(centre.connection()).enrolments(cohort);
  reportDeviation(centre.session(), {.cohortId = cohort,
                                     .enrolmentId = enrolments[1].id,
                                     .kind = "late",
                                     .description = "by \"ten\" minutes",
                                     .happenedUtc_us = kStudyTime_us});
  const auto curriculum = CurriculumRepository(centre.connection()).version(version);
  std::vector<SubmittedMark> marks;
  std::size_t number = 0;
  for (const Enrolment& enrolment : enrolments) {
    for (const char* occasion : {"pre", "post"}) {
      for (const RaterId& rater : raters) {
        SubmittedMark mark;
        mark.id = centre.session().key().station + std::to_string(++number);
        mark.enrolmentId = enrolment.id;
        mark.raterId = rater;
        mark.occasionCode = occasion;
        mark.score_steps = 30 + static_cast<std::int64_t>(7 * number % 50);
        mark.submittedUtc_us = kStudyTime_us;
        marks.push_back(mark);
      }
    }
  }
  RatingRepository(centre.connection()).submit(marks);
  for (std::size_t i = 1; i <= 4; ++i) {
    const Enrolment& enrolment = enrolments[i];
    TrialContext context;
    context.station = "one";
    context.enrolmentId = enrolment.id;
    context.moduleId = curriculum->modules.front().id;
    context.attemptMode = AttemptMode::kGraded;
    TrialRepository(centre.connection(), context)
        .import(twistedTrial(i, enrolment.traineeCode, curriculum->modules.front(), simulated));
  }
  return cohort;
}

/// The owner of the record's file sees single marks under codes.
SessionContext& asOwner(StudyCentre& centre) {
  SessionContext& session = centre.as("administrator");
  session.setActor({.systemAccount = "owner"});
  return session;
}

ExchangeFiles exportWhole(StudyCentre& centre, const CohortId& cohort, const fs::path& folder) {
  TrialDigests digests(centre.assets());
  SessionContext& owner = asOwner(centre);
  const ExchangeData data = exchangeData(owner, {.cohortId = cohort}, digests);
  DatasetRequest request;
  request.about.title = "Twists";
  request.about.licence = "CC-BY-4.0";
  request.rate_Hz = 1'000;
  request.whole = true;
  owner.beginCall();
  return exportDataset(owner, data, request, folder);
}

/// Paths of files that differ between two folders or exist in only one.
std::set<std::string> differing(const fs::path& one, const fs::path& other) {
  std::set<std::string> found;
  for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
    for (const auto& entry : fs::recursive_directory_iterator(from)) {
      const fs::path name = fs::relative(entry.path(), from);
      if (entry.is_regular_file() &&
          (!fs::exists(to / name) || readFile(entry.path()) != readFile(to / name))) {
        found.insert(name.generic_string());
      }
    }
  }
  return found;
}

TEST(DatasetImport, RestoresTheSameFiles) {
  const OwnFolder own;
  StudyCentre first;
  const CohortId cohort = studyIn(first);
  const ExchangeFiles out = exportWhole(first, cohort, own.path() / "first");
  ASSERT_TRUE(
      fs::exists(own.path() / "first" / "recordings" / "00000000-0000-4000-8000-000000000004.torsio"));

  StudyCentre second;
  const DatasetOutcome done =
      importDataset(second.as("administrator"), own.path() / "first", second.assets(), "moved house");
  EXPECT_EQ(done.trials, 4U);
  EXPECT_EQ(done.marks, 24U);
  const AuditEntry entry = AuditRepository(second.connection()).entries({.limit = 1}).at(0);
  EXPECT_EQ(entry.action, "trial.import");
  EXPECT_EQ(entry.reason, "moved house");
  const ExchangeFiles again = exportWhole(second, done.landed.cohortId, own.path() / "second");
  // These describe the record itself: head of its trail, times of enrolment and of marks, where it came from.
  EXPECT_THAT(
      differing(own.path() / "first", own.path() / "second"),
      ::testing::AllOf(::testing::Contains("data/numbers.csv"),
                       ::testing::IsSubsetOf({"README.md", "data/agreement.csv", "data/comparison.csv",
                                              "data/marks.csv", "data/numbers.csv", "data/participants.csv",
                                              "datapackage.json", "study.json"})));
  EXPECT_THAT(readFile(own.path() / "second" / "README.md"),
              ::testing::HasSubstr("Imported from first (Torsio, hash "));
  EXPECT_THAT(readFile(own.path() / "first" / "README.md"), ::testing::Not(::testing::HasSubstr("Imported")));
  EXPECT_EQ(out.files.size(), again.files.size());
  EXPECT_TRUE(verifyAuditTrail(second.connection()).empty());
}

CohortInputs reportOf(StudyCentre& centre, const CohortId& cohort) {
  TrialDigests digests(centre.assets());
  return reportInputs(asOwner(centre), {.cohortId = cohort}, digests);
}

TEST(DatasetImport, AnImportedStudyIsCalledImported) {
  const OwnFolder own;
  StudyCentre first;
  const CohortId cohort = studyIn(first);
  exportWhole(first, cohort, own.path() / "set");
  EXPECT_FALSE(reportOf(first, cohort).imported.has_value());
  StudyCentre second;
  const DatasetOutcome done =
      importDataset(second.as("administrator"), own.path() / "set", second.assets(), "");
  const CohortInputs in = reportOf(second, done.landed.cohortId);
  ASSERT_TRUE(in.imported.has_value());
  EXPECT_EQ(in.imported->layout, "Torsio");
  EXPECT_EQ(in.imported->source, "set");
  EXPECT_EQ(in.imported->contentHash, done.contentHash);
  EXPECT_EQ(in.imported->importedBy, "administrator");
  EXPECT_EQ(in.imported->marks, 24);
  EXPECT_EQ(in.imported->recordings, 4);
  EXPECT_FALSE(in.demonstration);
  const ReportModel report = cohortReport(in);
  std::string said;
  for (const ReportParagraph& paragraph : report.sections.front().paragraphs) {
    said += paragraph.str() + "\n";
  }
  EXPECT_THAT(said, ::testing::HasSubstr("This study was imported: from set (Torsio, hash "));
}

TEST(DatasetImport, TheOriginTravelsOnAndIsSigned) {
  const OwnFolder own;
  StudyCentre first;
  const CohortId cohort = studyIn(first);
  setStudyStatements(first.as("administrator"), cohort, {{StudyItem::kEthics, "board, 12/26"}});
  const std::string key = makeAnchorKey(own.path() / "key");
  setStationAnchor({.key = own.path() / "key"});
  exportWhole(first, cohort, own.path() / "first");
  StudyCentre second;
  const CohortId there =
      importDataset(second.as("administrator"), own.path() / "first", second.assets(), "").landed.cohortId;
  setStationAnchor({});
  exportWhole(second, there, own.path() / "second");
  StudyCentre third;
  const CohortId last =
      importDataset(third.as("administrator"), own.path() / "second", third.assets(), "").landed.cohortId;

  EXPECT_EQ(reportOf(second, there).imported->signedBy, key);
  const CohortInputs in = reportOf(third, last);
  EXPECT_TRUE(in.imported->signedBy.empty());
  EXPECT_EQ(in.imported->earlier, std::vector<std::string>{"first (Torsio)"});
  EXPECT_EQ(in.statements, (StudyStatements{{StudyItem::kEthics, "board, 12/26"}}));
  for (const SubmittedMark& mark : RatingRepository(third.connection()).marks(last)) {
    EXPECT_FALSE(mark.importId.empty());
  }
  const fs::path study = own.path() / "first" / "study.json";
  writeFileAtomically(study, readFile(study) + " ");
  StudyCentre fourth;
  try {
    importDataset(fourth.as("administrator"), own.path() / "first", fourth.assets(), "");
    ADD_FAILURE() << "a changed study was imported";
  } catch (const Error& error) {
    EXPECT_EQ(error.happened(), "the study was changed after it was signed");
  }
}

TEST(DatasetImport, AnImportedMarkIsNotChanged) {
  const OwnFolder own;
  StudyCentre first;
  const CohortId cohort = studyIn(first);
  exportWhole(first, cohort, own.path() / "set");
  StudyCentre second;
  const CohortId there =
      importDataset(second.as("administrator"), own.path() / "set", second.assets(), "").landed.cohortId;
  const std::string rubric = second.addPaperRubric();
  const SubmittedMark mark = RatingRepository(second.connection()).marks(there).front();
  createAssignments(
      second.as("administrator"),
      {.cohortId = there, .occasionCodes = {"pre"}, .raterIds = {mark.raterId}, .rubricRevisionId = rubric});
  SheetRepository sheets(second.connection());
  const AssignmentId asked = sheets.queue(mark.raterId).front().assignmentId;
  const RubricRevision revision = RubricRepository(second.connection()).revision(rubric).value();

  try {
    sheets.submit(asked, "m-1", evenSheet(revision, 70, 70), "", kStudyTime_us);
    ADD_FAILURE() << "an imported mark was changed";
  } catch (const Error& error) {
    EXPECT_EQ(error.happened(), "the mark of this case was imported and cannot be changed");
  }
}

TEST(DatasetImport, ASimulatedStudyStaysSimulated) {
  const OwnFolder own;
  StudyCentre first;
  const CohortId cohort = studyIn(first, true);
  exportWhole(first, cohort, own.path() / "set");
  EXPECT_THAT(readFile(own.path() / "set" / "README.md"), ::testing::HasSubstr("**Simulated: people"));
  // Not even a study that denies it is believed: the recordings say so in what their hashes cover.
  const fs::path file = own.path() / "set" / "study.json";
  std::string study = readFile(file);
  const std::size_t at = study.find("\"simulated\": true");
  ASSERT_NE(at, std::string::npos);
  writeFileAtomically(file, study.replace(at, 17, "\"simulated\": false"));
  StudyCentre second;
  const DatasetOutcome done =
      importDataset(second.as("administrator"), own.path() / "set", second.assets(), "");
  const CohortInputs in = reportOf(second, done.landed.cohortId);
  EXPECT_TRUE(in.demonstration);
  EXPECT_TRUE(cohortReport(in).demonstration);
  for (const SubmittedMark& mark : RatingRepository(second.connection()).marks(done.landed.cohortId)) {
    EXPECT_TRUE(mark.demonstration);
  }
  for (const Enrolment& one : StudyRepository(second.connection()).enrolments(done.landed.cohortId)) {
    EXPECT_TRUE(one.demonstration);
  }
}

TEST(DatasetImport, RejectsExistingChangedAndForeignData) {
  const OwnFolder own;
  StudyCentre centre;
  const CohortId cohort = studyIn(centre);
  const fs::path set = own.path() / "set";
  exportWhole(centre, cohort, set);
  auto before = centre.rowCounts();
  const auto refusal = [&](StudyCentre& into) -> std::string {
    try {
      importDataset(into.as("administrator"), set, into.assets(), "");
    } catch (const Error& error) {
      return error.happened();
    }
    return "imported";
  };
  EXPECT_NE(refusal(centre), "imported");  // its own people exist already
  EXPECT_EQ(centre.rowCounts(), before);

  StudyCentre empty;
  before = empty.as("administrator").may(Operation::kStudySetup) ? empty.rowCounts() : before;
  const fs::path recording = set / "recordings" / "00000000-0000-4000-8000-000000000003.torsio";
  std::string bytes = readFile(recording);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  writeFileAtomically(recording, bytes);
  EXPECT_NE(refusal(empty), "imported");
  fs::remove(recording);
  EXPECT_NE(refusal(empty), "imported");
  writeFileAtomically(set / "study.json", "{\"format\": \"torsio study 1\", \"cohort\": {}}");
  EXPECT_EQ(refusal(empty), "the study of the data set is damaged");
  writeFileAtomically(set / "study.json", "[1]");
  EXPECT_EQ(refusal(empty), "not a study of a data set of Torsio");
  EXPECT_EQ(empty.rowCounts(), before);
}

TEST(DatasetImport, RequiresCodesAndAPackage) {
  const OwnFolder own;
  StudyCentre centre;
  const CohortId cohort = studyIn(centre);
  TrialDigests digests(centre.assets());
  DatasetRequest request;
  request.about.title = "Twists";
  request.about.licence = "CC-BY-4.0";
  request.whole = true;
  const ExchangeData opaque =
      exchangeData(centre.as("administrator"), {.cohortId = cohort, .pseudonymised = true}, digests);
  EXPECT_THROW(exportDataset(asOwner(centre), opaque, request, own.path() / "a"), Error);
  const ExchangeData without = exchangeData(centre.as("administrator"), {.cohortId = cohort}, digests);
  EXPECT_THROW(exportDataset(centre.as("administrator"), without, request, own.path() / "a"), Error);
  request.layout = DatasetLayout::kBids;
  const ExchangeData coded = exchangeData(asOwner(centre), {.cohortId = cohort}, digests);
  EXPECT_THROW(exportDataset(asOwner(centre), coded, request, own.path() / "b"), Error);
  EXPECT_FALSE(fs::exists(own.path() / "a"));
  EXPECT_FALSE(fs::exists(own.path() / "b"));
}

}  // namespace
}  // namespace torsio
