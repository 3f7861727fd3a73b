// SPDX-License-Identifier: GPL-3.0-or-later
// How much processor time and memory five large sites take: 60 trainees, 600 recordings and 9,000 marks each.
#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/content_hash.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

constexpr int kSites = 5;
constexpr int kTrainees = 60;
constexpr int kRecordings = 600;
constexpr int kRaters = 50;  // with three occasions 9,000 marks

/// Adds people, recordings and marks to a demonstration.
void fill(const std::filesystem::path& file) {
  Connection record = openRecord(file.string(), OpenMode::kReadWrite);
  SystemIdSource ids;
  StudyRepository study(record);
  const CohortId cohort = selectFirst(record,
                                      "SELECT cohort_id FROM training_group GROUP BY cohort_id"
                                      " ORDER BY count(*) DESC LIMIT 1",
                                      {}, readText)
                              .value_or("");
  const std::vector<StudyGroup> groups = study.groups(cohort);
  const auto person = [&](const std::string& code) {
    Person one;
    one.id = ids.newUuid();
    one.code = code;
    one.createdUtc_us = 1;
    one.demonstration = true;
    return one;
  };
  std::vector<Trainee> trainees;
  std::vector<Enrolment> enrolments;
  for (int i = 0; i < kTrainees; ++i) {
    trainees.push_back({person("T-" + std::to_string(100 + i)), {}});
    Enrolment enrolment;
    enrolment.id = ids.newUuid();
    enrolment.cohortId = cohort;
    enrolment.traineeId = trainees.back().person.id.text();
    enrolment.groupId = groups[static_cast<std::size_t>(i) % groups.size()].id;
    enrolment.numberInGroup = 100 + i;
    enrolment.demonstration = true;
    enrolments.push_back(enrolment);
  }
  std::vector<Rater> raters;
  for (int i = 0; i < kRaters; ++i) {
    raters.push_back({person("R-" + std::to_string(100 + i)), "chief"});
  }
  PeopleRepository people(record);
  people.addTrainees(trainees);
  people.addRaters(raters);
  study.enrol(enrolments);
  std::vector<SubmittedMark> marks;
  for (const Enrolment& enrolment : enrolments) {
    for (const Rater& rater : raters) {
      for (const char* occasion : {"pre", "mid", "post"}) {
        SubmittedMark mark;
        mark.id = ids.newUuid();
        mark.enrolmentId = enrolment.id;
        mark.raterId = rater.person.id.text();
        mark.occasionCode = occasion;
        mark.score_steps = 40 + static_cast<std::int64_t>(marks.size() * 7 % 50);
        mark.scale = {10, 100, 10};
        mark.submittedUtc_us = 1;
        mark.demonstration = true;
        marks.push_back(mark);
      }
    }
  }
  RatingRepository(record).submit(marks);
  const TrialId shortest =
      selectFirst(record,
                  "SELECT e.trial_id FROM trial_end e JOIN trial t ON t.id = e.trial_id WHERE t.enrolment_id"
                  " IS NOT NULL ORDER BY e.sample_count LIMIT 1",
                  {}, readText)
          .value_or("");
  Trial trial = TrialLoader(record).load(shortest);
  Transaction transaction(record);
  for (int i = 0; i < kRecordings; ++i) {
    const std::size_t who = static_cast<std::size_t>(i % kTrainees);
    trial.header.trialId = ids.newUuid();
    trial.header.traineeCode = trainees[who].person.code;
    trial.summary.contentHash = contentHash(trial);
    TrialRepository trials(record);
    TrialContext context;
    context.station = "station";
    context.enrolmentId = enrolments[who].id;
    trials.setContext(std::move(context));
    trials.import(trial);
  }
  transaction.commit();
}

double spent_s(const rusage& use) {
  return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

TEST(PoolScale, FiveSitesTakeAMinuteAndAGigabyteAtMost) {
  const std::filesystem::path folder = emptyFolder("pool-scale");
  for (int site = 1; site <= kSites; ++site) {
    const std::string name = std::to_string(site);
    ASSERT_EQ(
        runTorsio("demo --out " + (folder / name).string() + " --seed " + name + " --shorten 600 --twists 0",
                  folder)
            .code,
        0);
    fill(folder / name / "torsio.sqlite");
    const ProgramRun given =
        runTorsio("study export --database " + (folder / name / "torsio.sqlite").string() + " --out " +
                      (folder / name).string() + ".torsio-site",
                  folder);
    ASSERT_EQ(given.code, 0) << given.err;
  }
  rusage before{};
  getrusage(RUSAGE_CHILDREN, &before);
  for (int site = 1; site <= kSites; ++site) {
    const ProgramRun pooled = runTorsio("study pool " + (folder / std::to_string(site)).string() +
                                            ".torsio-site --database " + (folder / "pooled.sqlite").string(),
                                        folder);
    ASSERT_EQ(pooled.code, 0) << pooled.err;
  }
  rusage after{};
  getrusage(RUSAGE_CHILDREN, &after);
  const double pooling_s = spent_s(after) - spent_s(before);
  const double memory_MB = static_cast<double>(after.ru_maxrss) / 1024.0;

  RecordProperty("pooling_s", std::to_string(pooling_s));
  std::printf("five sites: %.1f s of processor time, at most %.0f MB in any command\n", pooling_s, memory_MB);
  EXPECT_LE(pooling_s, 60.0);
  EXPECT_LE(memory_MB, 1024.0);
}

}  // namespace
}  // namespace torsio
