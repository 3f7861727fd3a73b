// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves a centre of real people: only of those who agree, and nobody's name.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/centres/site_export.h"
#include "app/services/centres/site_package.h"
#include "app/services/people/consent_service.h"
#include "assessment/domain/study/site.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

class SiteConsentTest : public ::testing::Test {
 protected:
  SiteConsentTest() {
    study_ = centre_.addStudy(6, 2);
    centre_.allocate(study_.cohortId);
    setCentreName(centre_.as("administrator"), "Nanjing University Hospital");
    for (std::size_t i = 0; i < 4; ++i) {
      recordConsent(centre_.session(), study_.trainees[i].text(), "research", true, "1");
    }
  }

  SitePackage give() {
    return exportSite(centre_.as("administrator"), {.cohortId = study_.cohortId, .out = package()});
  }
  [[nodiscard]] std::filesystem::path package() const { return centre_.folder() / "centre.torsio-site"; }

  StudyCentre centre_;
  PaperStudy study_;
};

TEST_F(SiteConsentTest, OnlyThoseWhoAgreeLeaveTheirCentre) {
  const SitePackage made = give();

  EXPECT_EQ(made.manifest.trainees, 4);
  EXPECT_EQ(made.manifest.leftOut, 2);
  EXPECT_FALSE(made.manifest.simulated);
  EXPECT_EQ(checkSitePackage(package()).manifest.rows.at("enrolment"), 4);
}

TEST_F(SiteConsentTest, NobodysNameLeaves) {
  (void)give();

  const std::string bytes = readFile(package());
  for (const char* name : {"Trainee 1", "Chief 1", "S-1001", "C-2001", "administrator"}) {
    EXPECT_EQ(bytes.find(name), std::string::npos) << name;
  }
  EXPECT_NE(bytes.find("Nanjing University Hospital"), std::string::npos);
}

TEST_F(SiteConsentTest, AWithdrawnConsentReachesThePooledRecord) {
  const std::filesystem::path pooled = centre_.folder() / "pooled.sqlite";
  const auto pool = [&] {
    const ProgramRun run = runTorsio(
        "study pool " + package().string() + " --database " + pooled.string() + " --as-system --json",
        centre_.folder());
    EXPECT_EQ(run.code, 0) << run.err;
    return nlohmann::json::parse(run.out);
  };
  (void)give();
  EXPECT_EQ(pool().at("outcome"), "added");
  recordConsent(centre_.session(), study_.trainees[0].text(), "research", false, "1");
  // One who agreed and withdrew between two packages was never delivered.
  recordConsent(centre_.session(), study_.trainees[4].text(), "research", true, "1");
  recordConsent(centre_.session(), study_.trainees[4].text(), "research", false, "1");

  EXPECT_EQ(give().manifest.leftOut, 3);
  const nlohmann::json taken = pool();

  EXPECT_EQ(taken.at("outcome"), "added");
  EXPECT_EQ(taken.at("withdrawn").size(), 1U) << taken;
  Connection record = openDatabase(pooled.string(), OpenMode::kReadOnly);
  EXPECT_EQ(selectFirst(record, "SELECT count(*) FROM consent WHERE purpose = 'research' AND granted = FALSE",
                        {}, readInt64),
            1);
  EXPECT_EQ(selectFirst(record, "SELECT count(*) FROM trainee", {}, readInt64), 4);
  const ProgramRun listed =
      runTorsio("study centres --database " + pooled.string() + " --json", centre_.folder());
  ASSERT_EQ(listed.code, 0) << listed.err;
  EXPECT_EQ(nlohmann::json::parse(listed.out).at(0).at("withdrawn"), taken.at("withdrawn"));
}

TEST_F(SiteConsentTest, RealPeopleNeedSomebodyWhoAnswersForThem) {
  try {
    (void)exportSite(centre_.as("administrator"),
                     {.cohortId = study_.cohortId, .out = package(), .simulatedOnly = true});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kPermission);
  }
}

TEST(CentreCode, BeginsWithTheInitials) {
  EXPECT_EQ(firstCentreCode("Nanjing University Hospital", "7f3a0000"), "NUH");
  EXPECT_EQ(firstCentreCode("Skills laboratory", "7f3a0000"), "SL");
  EXPECT_EQ(firstCentreCode("H\xC3\xB4pital Saint-Louis", "7f3a0000"), "HSL");
  EXPECT_EQ(firstCentreCode("\xE5\x8D\x97\xE4\xBA\xAC", "7f3a0000"), "C7F3A");
  EXPECT_TRUE(isCentreCode("NJ-2"));
  EXPECT_FALSE(isCentreCode("nj"));
  EXPECT_FALSE(isCentreCode("N/J"));
  EXPECT_FALSE(isCentreCode("NANJING12"));
}

}  // namespace
}  // namespace torsio
