// SPDX-License-Identifier: GPL-3.0-or-later
// The record in real time, at the largest size of a centre (10,000 trainees, 100,000 marks) in an SQLite
// file: time to store one second of samples safely, to open the lists, and to verify everything, and the cost
// of the seals when storing a trial. The last column is the ratio to one STREAM triad over a million doubles
// on this machine.
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

#ifdef TORSIO_PROGRAM
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <QCoreApplication>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTriadDoubles = 1'000'000;
constexpr std::int64_t kSeconds = 600;
constexpr std::size_t kSecond_bytes = 16'000;  // share of each in 60 MB per hour
constexpr int kTrials = 10'000;
constexpr int kOpenings = 21;
constexpr double kInsertLimit_ms = 20.0;
constexpr double kListLimit_ms = 100.0;
constexpr double kVerifyLimit_s = 6.0;  // processor time
constexpr double kVerifyLimit_MB = 200.0;
constexpr int kStoredTrials = 10;
constexpr int kStoringTurns = 25;
constexpr std::int64_t kStoredSeconds = 60;
constexpr double kSealShare = 1.10;  // relative to the processor time without seals

double time_ms(const std::function<void()>& action) {
  const auto begun = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Returns the median time of a[i] = b[i] + s c[i].
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
    scale = a[repeat] * 0.25;  // each pass depends on the previous one
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

double processor_s(const std::function<void()>& action) {
  const std::clock_t begun = std::clock();
  action();
  return static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
}

/// Adds finished trials of one second, to list and to verify.
void addTrials(Connection& connection, SampleRecord& sample) {
  Transaction transaction(connection);
  TrialRepository trials(connection, {.station = "room 1", .enrolmentId = sample.enrolments[0].id});
  for (int i = 0; i < kTrials; ++i) {
    TrialHeader header = sampleHeader(sample.ids.newUuid(), "T-01");
    header.startedUtc_us += i;
    TrialChunk chunk = sampleChunk(0, kSecond_bytes);
    chunk.digest = chunkDigest(chunk);
    ContentHash hash(header);
    hash.add(chunk);
    trials.begin(header);
    trials.append(chunk);
    trials.finish({.samples = chunk.samples, .contentHash = hash.hex()});
  }
  transaction.commit();
}

/// Runs the whole program like a user: prints processor time and peak memory.
void verifyAll(Bench& bench, const std::string& file) {
#ifdef TORSIO_PROGRAM
  std::string words[] = {TORSIO_PROGRAM, "audit", "verify", "--database", file};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  pid_t child = -1;
  int status = 0;
  rusage used{};
  if (posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments, environ) != 0 ||
      wait4(child, &status, 0, &used) != child) {
    bench.sound = false;
    return;
  }
  const double took_s = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                        static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec) / 1e6;
  const double most_MB = static_cast<double>(used.ru_maxrss) / 1e3;
  std::printf(
      "torsio audit verify                        %8.2f s of processor, limit %.0f s; %.0f MB, limit %.0f MB;"
      " exit code %d\n",
      took_s, kVerifyLimit_s, most_MB, kVerifyLimit_MB, WEXITSTATUS(status));
  bench.sound = bench.sound && took_s <= kVerifyLimit_s && most_MB <= kVerifyLimit_MB && status == 0;
#else
  std::printf("torsio audit verify                        not measured here: %s\n", file.c_str());
  bench.sound = false;
#endif
}

/// Stores trials of a minute like the recorder, second by second.
void storeTrials(Connection& connection, SampleRecord& sample) {
  for (int i = 0; i < kStoredTrials; ++i) {
    TrialRepository trials(connection, {.station = "room 1"});
    trials.begin(sampleHeader(sample.ids.newUuid(), "T-01"));
    for (std::int64_t second = 0; second < kStoredSeconds; ++second) {
      trials.append(sampleChunk(second, kSecond_bytes));
    }
    trials.finish({});
  }
}

void compareStoring(Bench& bench, Connection& connection, SampleRecord& sample) {
  std::vector<double> sealedTurns_s;
  std::vector<double> plainTurns_s;
  for (int turn = 0; turn < kStoringTurns; ++turn) {
    sealedTurns_s.push_back(processor_s([&] { storeTrials(connection, sample); }));
    const UnsealedCopy none(connection);
    plainTurns_s.push_back(processor_s([&] { storeTrials(connection, sample); }));
  }
  const double sealed_s = quantile(sealedTurns_s, 0.5);
  const double plain_s = quantile(plainTurns_s, 0.5);
  std::printf("storing a trial of a minute                seals take %.3f of the time without, limit %.2f\n",
              sealed_s / plain_s, kSealShare);
  bench.sound = bench.sound && sealed_s / plain_s <= kSealShare;
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

/// Cost of the seals in the first report on a record whose recordings have not been measured.
void storeDigests(Connection& connection) {
  std::vector<TrialDigest> digests;
  for (const TrialListing& trial : TrialRepository(connection).list({.limit = kTrials})) {
    TrialDigest digest;
    digest.trialId = trial.trialId;
    digest.contentHash = std::string(64, 'a');
    digest.model = "twist";
    digests.push_back(digest);
  }
  const auto version = [&digests](std::int64_t number) {
    for (TrialDigest& digest : digests) {
      digest.formulaVersion = number;
    }
  };
  version(1);
  const double sealed_s = processor_s([&] { DigestRepository(connection).add(digests); });
  const UnsealedCopy none(connection);
  version(2);
  const double plain_s = processor_s([&] { DigestRepository(connection).add(digests); });
  std::printf("digests of %zu trials                     %8.2f s of processor, %.2f s without seals\n",
              digests.size(), sealed_s, plain_s);
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
  verifyAll(bench, file);
  insertSeconds(bench, connection, sample);
  compareStoring(bench, connection, sample);
  storeDigests(connection);
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
