// SPDX-License-Identifier: GPL-3.0-or-later
// What a report is made from, who may take it out, and what is kept about it.
#include <gtest/gtest.h>

#include "app/session/reporting/report_export.h"
#include "app/session/study/allocation_service.h"
#include "app/session/study/cohort_service.h"
#include "app/session/study/frozen_data.h"
#include "db/repository/audit_repository.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "tests/app/session/office_centre.h"

namespace torsio {
namespace {

using testing::OfficeCentre;

/// Six trainees in three groups, nobody marked yet.
struct SmallStudy {
  OfficeCentre centre;
  ReportRequest request;
  TrialDigests digests{centre.assets()};

  SmallStudy() {
    const std::vector<std::string> trainees = centre.addTrainees(6);
    const std::string version = centre.runPaperCurriculum();
    request.cohortId = addCohort(centre.workplace(), {.name = "Study", .curriculumVersionId = version});
    enrolTrainees(centre.workplace(), request.cohortId, trainees);
    AllocationPlan plan;
    plan.cohortId = request.cohortId;
    lockAllocation(centre.as("allocator"), plan);
    allocateAll(centre.workplace(), request.cohortId);
  }
};

TEST(ReportInputs, AreForThoseWhoMayComputeResults) {
  SmallStudy study;
  for (const char* role : {"trainee", "rater", "allocator", ""})
    EXPECT_THROW((void)reportInputs(study.centre.as(role), study.request, study.digests), Error) << role;

  const CohortInputs inputs = reportInputs(study.centre.as("administrator"), study.request, study.digests);

  EXPECT_EQ(inputs.trainees.size(), 6U);
  EXPECT_TRUE(inputs.allocation.sealed);
  EXPECT_FALSE(inputs.singleMarks);  // the role matrix keeps marks from the administrator
  EXPECT_EQ(inputs.occasions.at(1), "after 20 min");
  EXPECT_TRUE(reportInputs(study.centre.as("statistician"), study.request, study.digests).singleMarks);
}

TEST(ReportInputs, NameTraineesOnlyForWhoMaySeeNames) {
  SmallStudy study;
  study.request.identity = ReportIdentity::kNamed;

  EXPECT_THROW((void)reportInputs(study.centre.as("statistician"), study.request, study.digests), Error);
  const CohortInputs inputs = reportInputs(study.centre.as("administrator"), study.request, study.digests);

  for (const CohortTrainee& trainee : inputs.trainees)
    EXPECT_NE(trainee.code.find(" Trainee "), std::string::npos) << trainee.code;
}

TEST(ReportInputs, SayWhetherTheRecordIsStillWhatWasFrozen) {
  SmallStudy study;
  Workplace& workplace = study.centre.as("administrator");
  study.request.frozenId = freezeData(workplace, study.request.cohortId, "first").id;
  EXPECT_TRUE(reportInputs(workplace, study.request, study.digests).freeze->unchanged);

  reportDeviation(workplace,
                  {.cohortId = study.request.cohortId, .kind = "late", .description = "by ten minutes"});

  const CohortInputs inputs = reportInputs(workplace, study.request, study.digests);
  EXPECT_FALSE(inputs.freeze->unchanged);
  EXPECT_EQ(inputs.deviations.at(0).description, "by ten minutes");
}

TEST(ReportExport, KeepsWhoTookOutWhatWithTheHashOfTheFileAndNoName) {
  SmallStudy study;
  Workplace& workplace = study.centre.as("administrator");
  study.request.identity = ReportIdentity::kNamed;
  const CohortInputs inputs = reportInputs(workplace, study.request, study.digests);
  const std::filesystem::path file = study.centre.folder() / "named.csv";

  EXPECT_THROW(exportReport(study.centre.as("statistician"), study.request, inputs, ReportFormat::kCsv, file),
               Error);
  EXPECT_FALSE(std::filesystem::exists(file));
  const ReportExport done =
      exportReport(study.centre.as("administrator"), study.request, inputs, ReportFormat::kCsv, file);

  Digest digest;
  digest.update(readFile(file));
  EXPECT_EQ(done.contentHash, digest.hex());
  const AuditEntry entry = AuditRepository(study.centre.connection()).entries({.limit = 1}).at(0);
  EXPECT_EQ(entry.action, "report.export_named");
  EXPECT_NE(entry.newJson.find(done.contentHash), std::string::npos);
  EXPECT_EQ(entry.newJson.find("Trainee"), std::string::npos);
}

}  // namespace
}  // namespace torsio
