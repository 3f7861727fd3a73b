// SPDX-License-Identifier: GPL-3.0-or-later
// Three hospitals follow one protocol; the coordinator pools what they send, as from the command line.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/file_io.h"
#include "tests/app/centres/hospitals.h"

namespace torsio {
namespace {

TEST_F(CentresTest, ThreeHospitalsMeetInOneRecord) {
  poolAll();

  EXPECT_EQ(verify().code, 0);
  EXPECT_EQ(numberOf("SELECT count(*) FROM cohort"), 1);
  EXPECT_EQ(numberOf("SELECT count(*) FROM curriculum"), 1);
  EXPECT_EQ(numberOf("SELECT count(*) FROM training_mark"), 900 * kHospitals);
  EXPECT_EQ(numberOf("SELECT count(*) FROM person WHERE code = site_code"), 0);
  EXPECT_EQ(numberOf("SELECT count(*) FROM person WHERE code = 'D2/T-07' AND site_code = 'T-07'"), 1);
  EXPECT_EQ(numberOf("SELECT count(*) FROM trial WHERE NOT demonstration"), 0);
}

TEST_F(CentresTest, RecordingsAreThoseOfTheirHospital) {
  poolAll();

  Connection hospital = openDatabase((sites_ / "2" / "torsio.sqlite").string(), OpenMode::kReadOnly);
  const std::string chunks =
      "SELECT t.id || ' ' || e.content_hash || ' ' || sum(length(c.bytes)) || ' ' || max(c.digest) FROM "
      "trial t"
      " JOIN trial_end e ON e.trial_id = t.id JOIN trial_chunk c ON c.trial_id = t.id"
      " WHERE t.enrolment_id IN (SELECT id FROM enrolment WHERE trainee_id IN (SELECT id FROM person WHERE"
      " code = '%')) GROUP BY t.id, e.content_hash ORDER BY t.id";
  const auto of = [&](Connection& record, const std::string& code) {
    std::string select = chunks;
    select.replace(select.find('%'), 1, code);
    return selectAll(record, select, {}, readText);
  };
  Connection record = openDatabase(pooled_.string(), OpenMode::kReadOnly);
  const std::vector<std::string> here = of(record, "D2/T-01");
  const std::vector<std::string> there = of(hospital, "T-01");
  EXPECT_TRUE(std::includes(there.begin(), there.end(), here.begin(), here.end()));
  const std::string run = selectFirst(record,
                                      "SELECT t.id FROM trial t JOIN person p ON p.id = t.trainee_id"
                                      " WHERE p.code LIKE 'D3/%' ORDER BY t.id LIMIT 1",
                                      {}, readText)
                              .value_or("");
  EXPECT_EQ(runTorsio("replay " + run + " --database " + pooled_.string() + " --verify", folder_).code, 0);
}

TEST_F(CentresTest, ReportAndTablesQualifyTheCodesAndSayThatTheyAreSimulated) {
  poolAll();
  const fs::path csv = folder_ / "cohort.csv";

  const ProgramRun report =
      runTorsio("report cohort --database " + pooled_.string() + " --out " +
                    (folder_ / "cohort.pdf").string() + " --csv " + csv.string() + " --json",
                folder_);

  ASSERT_EQ(report.code, 0) << report.err;
  EXPECT_TRUE(Json::parse(report.out).at("simulated").get<bool>());
  const std::string numbers = readFile(csv);
  EXPECT_NE(numbers.find(",D1/T-07,"), std::string::npos);
  EXPECT_NE(numbers.find(",D3/T-07,"), std::string::npos);
  EXPECT_EQ(numbers.find(",T-07,"), std::string::npos);
  const ProgramRun book = runTorsio(
      "export workbook --database " + pooled_.string() + " --out " + (folder_ / "cohort.xlsx").string(),
      folder_);
  EXPECT_EQ(book.code, 0) << book.err;
}

TEST_F(CentresTest, DeliveringTwiceChangesNothing) {
  poolAll();
  const std::int64_t entries = numberOf("SELECT count(*) FROM audit_entry");

  EXPECT_EQ(outcomeOf(package(2)), "repeated");

  EXPECT_EQ(numberOf("SELECT count(*) FROM audit_entry"), entries);
  EXPECT_EQ(numberOf("SELECT count(*) FROM site_delivery"), kHospitals);
}

TEST_F(CentresTest, ADeliveryWithoutNewRowsIsRecorded) {
  poolAll();
  const fs::path again = folder_ / "again.torsio-site";
  ASSERT_EQ(exportFrom(copyOf(2), again).code, 0);
  const std::int64_t marks = numberOf("SELECT count(*) FROM training_mark");

  EXPECT_EQ(outcomeOf(again), "nothing_new");

  EXPECT_EQ(numberOf("SELECT count(*) FROM training_mark"), marks);
  EXPECT_EQ(numberOf("SELECT count(*) FROM site_delivery WHERE rows_added = 0 AND sequence = 2"), 1);
  EXPECT_EQ(verify().code, 0);
  EXPECT_EQ(outcomeOf(again), "repeated");
}

TEST_F(CentresTest, AnOlderPackageIsNoticed) {
  const fs::path newer = folder_ / "newer.torsio-site";
  ASSERT_EQ(exportFrom(copyOf(1), newer).code, 0);
  ASSERT_EQ(outcomeOf(newer), "added");

  EXPECT_EQ(outcomeOf(package(1)), "older");

  EXPECT_EQ(numberOf("SELECT count(*) FROM site_delivery"), 1);
}

TEST_F(CentresTest, AChangedByteIsRefusedWherever) {
  const std::string sound = readFile(package(1));
  const fs::path file = folder_ / "changed.torsio-site";
  for (std::size_t part = 0; part < 40; ++part) {
    std::string bytes = sound;
    const std::size_t at = 14 + (bytes.size() - 15) * part / 39;
    bytes[at] = static_cast<char>(bytes[at] ^ (part % 2 == 0 ? 1 : 0x80));
    writeFileAtomically(file, bytes);

    expectRefused(pool(file), 13, "not as its centre signed it");
    EXPECT_FALSE(fs::exists(pooled_)) << at;
  }
  writeFileAtomically(file, sound.substr(0, sound.size() / 3));
  expectRefused(pool(file), 13, "not as its centre signed it");
  writeFileAtomically(file, "nonsense");
  expectRefused(pool(file), 4, "is not a site package");
}

TEST_F(CentresTest, ASwappedSignatureIsRefused) {
  constexpr std::size_t kSignature = 128;
  const std::string one = readFile(package(1));
  const std::string other = readFile(package(2));
  const fs::path file = folder_ / "swapped.torsio-site";

  writeFileAtomically(file, one.substr(0, one.size() - kSignature) + other.substr(other.size() - kSignature));

  expectRefused(pool(file), 13, "not as its centre signed it");
}

TEST_F(CentresTest, AnotherKeyOfTheSameCentreIsRefused) {
  poolAll();
  const fs::path record = copyOf(1);
  fs::remove(folder_ / "hospital" / "torsio.sqlite.site-key");
  const fs::path file = folder_ / "forged.torsio-site";
  ASSERT_EQ(exportFrom(record, file).code, 0);

  expectRefused(pool(file), 13, "another key than the earlier packages of centre D1");
}

TEST_F(CentresTest, RowsOfAnotherCentreAreRefused) {
  poolAll();
  const fs::path record = copyOf(1);
  {
    Connection thief = openRecord(record.string(), OpenMode::kReadWrite);
    StudyRepository(thief).setCentre({"11111111-1111-4111-8111-111111111111", "Thief", 0, true});
    SettingRepository(thief).set(kCentreCode.name, "TH", 0);
  }
  const fs::path file = folder_ / "stolen.torsio-site";
  ASSERT_EQ(exportFrom(record, file).code, 0);

  expectRefused(pool(file), 13, "belongs to another centre");
  EXPECT_EQ(numberOf("SELECT count(*) FROM site"), kHospitals);
}

TEST_F(CentresTest, AnotherProtocolIsRefusedWithTheDifference) {
  ASSERT_EQ(outcomeOf(package(1)), "added");
  const fs::path record = copyOf(2);
  {
    Connection other = openRecord(record.string(), OpenMode::kReadWrite);
    other.execute("UPDATE cohort SET equivalence_margin = 0.75 WHERE name LIKE 'Twist training%'");
  }
  const fs::path file = folder_ / "other.torsio-site";
  ASSERT_EQ(exportFrom(record, file).code, 0);

  expectRefused(pool(file), 8, "equivalence_margin is 0.5 here and 0.75 in the package");
}

TEST_F(CentresTest, VerifyingNamesTheCentreOfAChange) {
  poolAll();
  {
    Connection attacker = openDatabase(pooled_.string(), OpenMode::kReadWrite);
    attacker.executeVerbatim("DROP TRIGGER training_mark_no_update");
    attacker.execute(
        "UPDATE training_mark SET score_steps = 55 WHERE id = (SELECT m.id FROM training_mark m JOIN"
        " enrolment e ON e.id = m.enrolment_id JOIN person p ON p.id = e.trainee_id WHERE"
        " p.code = 'D2/T-04' AND m.score_steps <> 55 ORDER BY m.id LIMIT 1)");
  }

  const ProgramRun run = verify();

  EXPECT_EQ(run.code, 13);
  EXPECT_NE(run.out.find("delivered by centre D2"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("delivered by centre D1"), std::string::npos) << run.out;
  expectRefused(pool(package(3)), 13, "the pooled record does not verify");
}

TEST_F(CentresTest, ARecordThatDoesNotVerifyGivesNothing) {
  const fs::path record = copyOf(3);
  {
    Connection attacker = openDatabase(record.string(), OpenMode::kReadWrite);
    attacker.executeVerbatim("DROP TRIGGER training_mark_no_update");
    attacker.execute("UPDATE training_mark SET score_steps = 55 WHERE score_steps <> 55");
  }

  expectRefused(exportFrom(record, folder_ / "x.torsio-site"), 13, "does not verify");
  EXPECT_FALSE(fs::exists(folder_ / "x.torsio-site"));
}

TEST_F(CentresTest, TheSameCodeOfTwoCentresIsToldApart) {
  ASSERT_EQ(outcomeOf(package(1)), "added");
  const fs::path record = copyOf(2);
  {
    Connection other = openRecord(record.string(), OpenMode::kReadWrite);
    SettingRepository(other).set(kCentreCode.name, "D1", 0);
  }
  const fs::path file = folder_ / "same.torsio-site";
  ASSERT_EQ(exportFrom(record, file).code, 0);

  const ProgramRun run = pool(file);

  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out).at("site").get<std::string>().substr(0, 3), "D1-");
}

TEST_F(CentresTest, ARecordWithPeopleOfItsOwnTakesNoPackage) {
  pooled_ = copyOf(2);

  expectRefused(pool(package(1)), 8, "has people of its own");
}

TEST_F(CentresTest, CheckingAPackageNeedsNoRecord) {
  const ProgramRun run = runTorsio("study check " + package(1).string() + " --json", folder_);

  ASSERT_EQ(run.code, 0) << run.err;
  const Json told = Json::parse(run.out);
  EXPECT_EQ(told.at("code"), "D1");
  EXPECT_EQ(told.at("trainees"), 30);
  EXPECT_EQ(told.at("rows").at("training_mark"), 900);
  EXPECT_FALSE(told.at("rows").contains("person_identity"));
  EXPECT_EQ(
      runTorsio("study check " + package(1).string() + " --public-key " + std::string(64, '0'), folder_).code,
      13);
}

}  // namespace
}  // namespace torsio
