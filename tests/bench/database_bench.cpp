// SPDX-License-Identifier: GPL-3.0-or-later
// The record on the real clock, as large as a centre ever gets (10,000 trainees, 100,000 marks) in an SQLite
// file: how long one second of samples takes to be safe on the disk, and how long the lists take to open. The
// last column is the ratio to one STREAM triad over a million doubles on this machine.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QCoreApplication>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/ids.h"
#include "tests/db/large_record.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTriadDoubles = 1'000'000;
constexpr std::int64_t kSeconds = 600;
constexpr std::size_t kSecond_bytes = 16'000;  // what an hour of 60 MB leaves for each
constexpr int kTrials = 2'000;
constexpr int kOpenings = 21;
constexpr double kInsertLimit_ms = 20.0;
constexpr double kListLimit_ms = 100.0;

double time_ms(const std::function<void()>& action) {
  const auto begun = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Median time of a[i] = b[i] + s c[i].
double triad_ms() {
  std::vector<double> a(kTriadDoubles, 0.0);
  const std::vector<double> b(kTriadDoubles, 1.0);
  const std::vector<double> c(kTriadDoubles, 2.0);
  std::vector<double> times_ms;
  double scale = 0.5;
  for (std::size_t repeat = 0; repeat < 41; ++repeat) {
    times_ms.push_back(time_ms([&] {
      for (std::size_t i = 0; i < kTriadDoubles; ++i) {
        a[i] = b[i] + scale * c[i];
      }
    }));
    scale = a[repeat] * 0.25;  // each pass needs the one before
  }
  return quantile(times_ms, 0.5);
}

struct Bench {
  double triad_ms;
  bool sound = true;

  void print(const char* name, const std::vector<double>& times_ms, double share, double limit_ms) {
    const double median_ms = quantile(times_ms, 0.5);
    const double judged_ms = quantile(times_ms, share);
    std::printf("%-42s p50 %8.3f ms  p99 %8.3f ms  limit %5.0f ms  median / triad %.2f\n", name, median_ms,
                quantile(times_ms, 0.99), limit_ms, median_ms / triad_ms);
    sound = sound && judged_ms <= limit_ms;
  }

  void list(const char* name, const std::function<void()>& open) {
    std::vector<double> times_ms;
    for (int i = 0; i < kOpenings; ++i) {
      times_ms.push_back(time_ms(open));
    }
    print(name, times_ms, 0.5, kListLimit_ms);
  }
};

/// Finished trials without samples, for the lists.
void addTrials(Connection& connection, SampleRecord& sample) {
  Transaction transaction(connection);
  TrialRepository trials(connection, {.station = "room 1", .enrolmentId = sample.enrolments[0].id});
  for (int i = 0; i < kTrials; ++i) {
    TrialHeader header = sampleHeader(sample.ids.newUuid(), "T-01");
    header.startedUtc_us += i;
    trials.begin(header);
    trials.finish({});
  }
  transaction.commit();
}

void insertSeconds(Bench& bench, Connection& connection, SampleRecord& sample) {
  TrialRepository trials(connection, {.station = "room 1"});
  trials.begin(sampleHeader(sample.ids.newUuid(), "T-01"));
  std::vector<double> times_ms;
  for (std::int64_t i = 0; i < kSeconds; ++i) {
    const TrialChunk chunk = sampleChunk(i, kSecond_bytes);
    times_ms.push_back(time_ms([&] { trials.append(chunk); }));
  }
  bench.print("a second of samples, safe on the disk", times_ms, 0.99, kInsertLimit_ms);
}

bool run(const std::string& file) {
  Bench bench{.triad_ms = triad_ms()};
  std::printf("triad over a million doubles: %.3f ms\n", bench.triad_ms);
  Connection connection = openRecord(file, OpenMode::kCreate, {.softwareVersion = "bench"});
  SampleRecord sample(connection, 1);
  CohortId cohortId;
  const std::clock_t begun = std::clock();
  const double fill_ms = time_ms([&] { cohortId = fillLargeRecord(connection, sample); });
  addTrials(connection, sample);
  std::printf("record of %d trainees, %d marks, %d trials: %.1f MB, made in %.1f s (%.1f s of processor)\n",
              kManyTrainees, kManyMarks, kTrials, static_cast<double>(fs::file_size(file)) / 1e6,
              fill_ms / 1e3, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
  bench.list("all trainees", [&] { (void)PeopleRepository(connection).trainees(); });
  bench.list("cohorts", [&] { (void)StudyRepository(connection).cohorts(); });
  bench.list("enrolments of a cohort", [&] { (void)StudyRepository(connection).enrolments(cohortId); });
  bench.list("marks of a cohort", [&] { (void)RatingRepository(connection).marks(cohortId); });
  bench.list("newest 200 trials", [&] { (void)TrialRepository(connection).list(); });
  bench.list("trials of a trainee", [&] { (void)TrialRepository(connection).list({.traineeCode = "T-01"}); });
  bench.list("queue of a rater",
             [&] { (void)SheetRepository(connection).queue(sample.chiefs[0].person.id); });
  bench.list("audit trail of trials",
             [&] { (void)AuditRepository(connection).entries({.objectKind = AuditObject::kTrial}); });
  insertSeconds(bench, connection, sample);
  return bench.sound;
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("torsio-bench-" + torsio::SystemIdSource().newUuid());
  std::filesystem::create_directories(folder);
  const bool sound = torsio::run((folder / "record.sqlite").string());
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  if (!sound) {
    std::printf("too slow: see the limits above\n");
  }
  return sound ? 0 : 1;
}
