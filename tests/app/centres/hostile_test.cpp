// SPDX-License-Identifier: GPL-3.0-or-later
// Packages that somebody wrote to do harm, and packages that meet a broken computer.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/centres/site_package.h"
#include "app/services/maintenance/signing_key.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/system/site_tables.h"
#include "sim/core/file_io.h"
#include "tests/app/centres/hospitals.h"

namespace torsio {
namespace {

constexpr const char* kStranger = "11111111-1111-4111-8111-111111111111";

struct Rows {
  std::string table;
  std::vector<std::string> columns;
  std::vector<std::vector<Value>> rows;
};

class HostileTest : public CentresTest {
 protected:
  /// Writes a package of a centre that nobody knows, sound but for what it says.
  [[nodiscard]] fs::path crafted(const std::vector<Rows>& given,
                                 const std::string& centre = kStranger) const {
    SiteManifest manifest = checkSitePackage(package(1)).manifest;
    manifest.centreId = centre;
    manifest.centreCode = "EV";
    const SecretKey key = drawKey();
    manifest.publicKey = publicOf(key);
    SiteSealer sealer;
    for (const Rows& one : given) {
      for (const std::vector<Value>& row : one.rows) {
        sealer.add(one.table, one.columns, row);
      }
    }
    const fs::path file = folder_ / "crafted.torsio-site";
    std::ofstream out(file, std::ios::binary);
    SitePackageWriter writer(out);
    for (const Rows& one : given) {
      writer.beginTable(one.table, one.columns);
      const auto seals = sealer.seals(one.table);
      for (const std::vector<Value>& row : one.rows) {
        const auto seal = seals.find(sealer.keyOf(one.table, one.columns, row));
        writer.add(seal == seals.end() ? std::string() : seal->second, row);
      }
    }
    (void)writer.finish(manifest, [&](const std::string& text) { return signedWith(key, text); });
    return file;
  }
  [[nodiscard]] std::string textIn(const std::string& select) const {
    Connection record = openDatabase(pooled_.string(), OpenMode::kReadOnly);
    return selectFirst(record, select, {}, readText).value_or("");
  }
  /// Writes an unsigned file with this text in the place of the manifest.
  [[nodiscard]] fs::path unsignedWith(const std::string& manifest) const {
    std::string bytes = "torsio-site 1\nM";
    for (int i = 0; i < 4; ++i) {
      bytes += static_cast<char>((manifest.size() >> (8 * i)) & 0xFFU);
    }
    const fs::path file = folder_ / "unsigned.torsio-site";
    writeFileAtomically(file, bytes + manifest + "S" + std::string("\x80\0\0\0", 4) + std::string(128, '0'));
    return file;
  }
};

TEST_F(HostileTest, RowsThatReferToThoseOfAnotherCentreAreRefused) {
  poolAll();
  const std::string assignment = textIn("SELECT id FROM assignment ORDER BY id LIMIT 1");
  const std::string enrolment = textIn("SELECT id FROM enrolment ORDER BY id LIMIT 1");
  const std::string person = textIn("SELECT person_id FROM trainee ORDER BY person_id LIMIT 1");
  const std::string trial = textIn("SELECT id FROM trial ORDER BY id LIMIT 1");
  const std::string cohort = textIn("SELECT cohort_id FROM enrolment ORDER BY id LIMIT 1");
  const std::vector<Rows> attacks{
      {"assignment_withdrawal",
       {"assignment_id", "sequence", "withdrawn", "reason", "decided_by", "decided_utc_us"},
       {{assignment, 9, true, "centre", "centre", 1}}},
      {"consent",
       {"person_id", "purpose", "sequence", "granted", "text_version", "decided_utc_us", "recorded_by",
        "demonstration", "form", "signed_utc_us"},
       {{person, "research", 9, false, "1", 1, "centre", true, "paper", 1}}},
      {"run_excuse", {"trial_id", "excused_by", "excused_utc_us", "reason"}, {{trial, "centre", 1, Value()}}},
      {"deviation",
       {"id", "cohort_id", "enrolment_id", "kind", "description", "happened_utc_us", "reported_by",
        "reported_utc_us", "demonstration"},
       {{"22222222-2222-4222-8222-222222222222", cohort, enrolment, "other", Value(), 1, "centre", 1, true}}},
      {"trial_chunk",
       {"trial_id", "chunk_index", "first_tick", "sample_count", "digest", "output_digest", "stored_utc_us",
        "bytes"},
       {{trial, 999, 0, 0, "x", "x", 1, Blob{}}}},
  };
  const std::int64_t before = numberOf("SELECT count(*) FROM audit_entry");
  for (const Rows& attack : attacks) {
    const fs::path file = crafted({attack});
    ASSERT_NO_THROW((void)checkSitePackage(file)) << attack.table;

    expectRefused(pool(file), 13, "a row of another centre");
  }
  EXPECT_EQ(numberOf("SELECT count(*) FROM audit_entry"), before);
  EXPECT_EQ(numberOf("SELECT count(*) FROM site"), kHospitals);
}

TEST_F(HostileTest, RowsOfAPlanThatTheirProtocolDoesNotTellOfAreRefused) {
  ASSERT_EQ(outcomeOf(package(1)), "added");
  const std::string cohort = textIn("SELECT cohort_id FROM enrolment LIMIT 1");

  const fs::path file =
      crafted({{"training_group",
                {"id", "cohort_id", "number", "code", "label", "arm_id"},
                {{"55555555-5555-4555-8555-555555555555", cohort, 99, "G99", "Ninety-nine", Value()}}}});

  expectRefused(pool(file), 8, "follows another protocol");
  EXPECT_EQ(numberOf("SELECT count(*) FROM training_group WHERE number = 99"), 0);
}

TEST_F(HostileTest, ATableThatComesTwiceIsRefused) {
  const Rows once{"rater_class", {"code", "label", "position"}, {{"zz", "Z", 90}}};
  const fs::path file = crafted({once, once});

  EXPECT_EQ(runTorsio("study check " + file.string(), folder_).code, 13);
}

TEST_F(HostileTest, NestedOrHugeTextsAreRefusedBeforeTheyAreRead) {
  constexpr std::size_t kDeep = 400'000;
  const std::string deep =
      R"({"centre":{"id":"x","code":"X","name":"X","public_key":")" + std::string(64, '0') +
      R"("},"software":"","made_utc_us":1,"trail":{"length":1,"hash":""},"cohort":"","evaluation":"",)"
      R"("simulated":true,"trainees":0,"left_out":0,"sealed_rows":0,"other_rows":0,"protocol":{"a":)" +
      std::string(kDeep, '[') + std::string(kDeep, ']') + R"(},"rows":{},"content_hash":""})";
  const fs::path file = unsignedWith(deep);
  expectRefused(runTorsio("study check " + file.string(), folder_), 8, "does not follow the rules");
  expectRefused(pool(file), 8, "does not follow the rules");
  expectRefused(pool(unsignedWith(std::string(40'000'000, ' '))), 13, "not as its centre signed it");
}

TEST_F(HostileTest, AnUnsignedTextIsNotReadFurtherThanItsKey) {
  const fs::path file = unsignedWith(R"({"centre":{"public_key":")" + std::string(64, '0') + R"("}})");

  expectRefused(pool(file), 13, "not as its centre signed it");
}

TEST_F(HostileTest, ACentreHasAWholeId) {
  expectRefused(pool(crafted({}, "abcd")), 8, "does not follow the rules");
}

TEST_F(HostileTest, PeopleWhoAreRealAmongSimulatedOnesAreRefused) {
  const Rows people{
      "person",
      {"id", "code", "sex", "level", "experience", "age_years", "state", "created_utc_us", "demonstration"},
      {{"33333333-3333-4333-8333-333333333333", "T-01", Value(), Value(), Value(), Value(), "active", 1,
        false}}};

  expectRefused(pool(crafted({people})), 8, "simulated");
}

TEST_F(HostileTest, ADiskThatIsFullIsNotTheFaultOfTheCentre) {
  ASSERT_EQ(outcomeOf(package(1)), "added");

  const ProgramRun run = runTorsio("study pool " + package(2).string() + " --database " + pooled_.string(),
                                   folder_, "prlimit --fsize=262144 env --ignore-signal=XFSZ");

  EXPECT_NE(run.code, 0);
  EXPECT_EQ(run.err.find("export it again"), std::string::npos) << run.err;
  EXPECT_EQ(numberOf("SELECT count(*) FROM site"), 1);
}

TEST_F(HostileTest, APublicKeyMayBeWrittenInCapitalsAndMustBeOne) {
  const std::string key = checkSitePackage(package(1)).manifest.publicKey;
  std::string capitals = key;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](char c) { return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c); });
  const std::string check = "study check " + package(1).string() + " --public-key ";

  EXPECT_EQ(runTorsio(check + capitals, folder_).code, 0);
  expectRefused(runTorsio(check + key.substr(1), folder_), 2, "64 hexadecimal digits");
}

TEST_F(HostileTest, AFreeTextStaysAtItsCentre) {
  const fs::path record = copyOf(1);
  {
    Connection own = openRecord(record.string(), OpenMode::kReadWrite);
    own.execute("UPDATE cohort SET description = 'Secret of the cohort'");
    own.execute("UPDATE curriculum SET description = 'Secret of the plan'");
    own.execute(
        "INSERT INTO training_mark (id, enrolment_id, rater_id, occasion, version, score_steps, "
        "scale_lo_steps,"
        " scale_hi_steps, steps_per_point, not_assessable_reason, amend_reason, submitted_utc_us,"
        " demonstration, assignment_id) SELECT '44444444-4444-4444-8444-444444444444', enrolment_id, "
        "rater_id,"
        " occasion, version + 1, NULL, scale_lo_steps, scale_hi_steps, steps_per_point, 'Secret of the "
        "camera',"
        " 'Secret of the rater', submitted_utc_us + 1, demonstration, assignment_id FROM training_mark ORDER "
        "BY"
        " id LIMIT 1");
  }
  const fs::path file = folder_ / "texts.torsio-site";
  const ProgramRun given = exportFrom(record, file);
  ASSERT_EQ(given.code, 0) << given.err;

  EXPECT_EQ(readFile(file).find("Secret"), std::string::npos);
  EXPECT_EQ(outcomeOf(file), "added");
  EXPECT_EQ(numberOf("SELECT count(*) FROM training_mark WHERE amend_reason = 'centre'"), 1);
  EXPECT_EQ(numberOf("SELECT count(*) FROM training_mark WHERE not_assessable_reason = 'centre'"), 1);
}

TEST_F(HostileTest, AFirstLineThatWasChangedIsNoPackage) {
  std::string bytes = readFile(package(1));
  bytes[3] = 'X';
  const fs::path file = folder_ / "magic.torsio-site";
  writeFileAtomically(file, bytes);

  expectRefused(pool(file), 4, "is not a site package");
}

TEST_F(HostileTest, ASimulatedCentreIsCalledSoOnce) {
  ASSERT_EQ(outcomeOf(package(1)), "added");

  const std::string listed = runTorsio("study centres --database " + pooled_.string(), folder_).out;

  EXPECT_NE(listed.find("(simulated)"), std::string::npos) << listed;
  EXPECT_EQ(listed.find("(simulated) (simulated)"), std::string::npos) << listed;
}

}  // namespace
}  // namespace torsio
