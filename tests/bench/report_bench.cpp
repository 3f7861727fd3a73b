// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' pages with a large record, 10,000 trials and 100,000 marks: the report is built within 3 s,
// even the first time in a program, and every list opens within 100 ms. Exit code 0: all met, 1: missed, 2:
// undecided.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

#include <QApplication>

#include "app/gui/administrator/administrator_pages.h"
#include "app/gui/base/shell_context.h"
#include "app/outputs/report/report_data.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/roster_import.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/people/retention.h"
#include "assessment/results/cohort_report.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/support/study_centre.h"
#include "tests/bench/large_study.h"

namespace torsio {
namespace {

constexpr double kReportTarget_ms = 3'000.0;
constexpr double kListTarget_ms = 100.0;
constexpr int kOpenings = 5;

/// Wall time and processor time of work.
struct WorkTime {
  double elapsed_ms = 0.0;
  double processor_ms = 0.0;
};

WorkTime milliseconds(const std::function<void()>& work) {
  const auto begun = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count(),
          1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

void print(const char* what, const WorkTime& took) {
  std::printf("%-48s %9.1f ms, processor %8.1f ms", what, took.elapsed_ms, took.processor_ms);
}

enum class Verdict { kMet, kMissed, kUndecided };

/// Returns whether other programs slow this one down: pure computation takes longer than it should.
bool machineIsBusy() {
  constexpr double kHeldUp = 1.25;
  volatile double sum = 0.0;
  const WorkTime took = milliseconds([&sum] {
    for (int i = 1; i < 20'000'000; ++i) {
      sum = sum + 1.0 / i;
    }
  });
  return took.elapsed_ms > kHeldUp * took.processor_ms;
}

/// Compares wall time with a target, because users wait for disk and server, too. Processor time alone never
/// meets a target. But if it is within the target and the machine is busy with other programs, the wall time
/// says nothing: then the result is undecided.
Verdict report(const char* what, const WorkTime& took, double target_ms) {
  Verdict verdict = Verdict::kMet;
  if (took.elapsed_ms > target_ms) {
    verdict = took.processor_ms <= target_ms && machineIsBusy() ? Verdict::kUndecided : Verdict::kMissed;
  }
  constexpr const char* kWords[] = {"met", "MISSED", "undecided: the machine is busy, run again"};
  print(what, took);
  std::printf("   target %5.0f ms   %s\n", target_ms, kWords[static_cast<std::size_t>(verdict)]);
  return verdict;
}

/// Returns the worse verdict; missed is worse than undecided.
Verdict worse(Verdict a, Verdict b) {
  if (a == Verdict::kMissed || b == Verdict::kMissed) {
    return Verdict::kMissed;
  }
  return a == Verdict::kUndecided ? a : b;
}

Verdict measureReport(testing::StudyCentre& centre, const CohortId& cohortId) {
  ReportRequest request;
  request.cohortId = cohortId;
  SessionContext& session = centre.as("statistician");
  const auto build = [&] {
    TrialDigests digests(centre.assets());  // as in a newly started program
    const ReportModel model = cohortReport(reportInputs(session, request, digests));
    if (model.sections.empty()) {
      std::abort();
    }
    return digests.measured();
  };
  std::size_t measured = 0;
  const WorkTime old = milliseconds([&] { measured = build(); });
  print("the report of a record of an older version", old);
  std::printf("   (%zu recordings measured, once)\n", measured);
  const WorkTime first = milliseconds([&] { measured = build(); });
  if (measured != 0) {
    return Verdict::kMissed;  // everything is cached beside the recordings by now
  }
  return report("the report, the first time in a program", first, kReportTarget_ms);
}

/// Makes everybody's record due for review, two days later.
void makeAllRecordsDue(testing::StudyCentre& centre) {
  setRetentionRule(centre.as("administrator"), kRetainTrainee, 1, "a rule of the bench");
  centre.passTime_us(2 * 86'400'000'000);
}

/// Returns the shortest of several openings, each with a new page: other load can only add to it.
WorkTime shortestOpening(const gui::PageEntry& entry, gui::ShellContext& shell) {
  WorkTime shortest{std::numeric_limits<double>::max(), 0.0};
  for (int opening = 0; opening < kOpenings; ++opening) {
    const std::unique_ptr<gui::Page> page(entry.make(shell));
    page->resize(1366, 768);
    const WorkTime took = milliseconds([&] {
      page->enter({});
      page->grab();
    });
    static_cast<void>(page->leave());
    if (took.elapsed_ms < shortest.elapsed_ms) {
      shortest = took;
    }
  }
  return shortest;
}

Verdict measureLists(testing::StudyCentre& centre) {
  makeAllRecordsDue(centre);
  gui::ShellContext shell(centre.session(), centre.assets(), gui::ThemeKind::kLight);
  Verdict worst = Verdict::kMet;
  for (const gui::PageEntry& entry : gui::administratorPages()) {
    if (entry.id == gui::PageId::kResults || entry.id == gui::PageId::kReports) {
      continue;  // already measured
    }
    centre.as(entry.id == gui::PageId::kAllocation ? "allocator" : "administrator");
    worst = worse(worst, report(gui::factsOf(entry.id).text, shortestOpening(entry, shell), kListTarget_ms));
  }
  return worst;
}

Verdict measureTrials(testing::StudyCentre& centre) {
  std::size_t listed = 0;
  const WorkTime took = milliseconds([&] { listed = TrialRepository(centre.connection()).list().size(); });
  if (listed == 0) {
    std::abort();
  }
  return report("trials under their codes, the newest page", took, kListTarget_ms);
}

/// Compares and then stores a roster of ten thousand people. No target: it happens once a year.
void measureRoster() {
  constexpr int kPeople = 10'000;
  testing::StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  std::string text = "external_id,full_name,sex,level\r\n";
  for (int i = 0; i < kPeople; ++i) {
    text += std::to_string(500'000 + i) + ",Person " + std::to_string(i) + ",female,intern\r\n";
  }
  const RosterFile file = parseRoster(text, "roster.csv");
  const RosterColumns columns = suggestColumns(file, RosterKind::kTrainees);
  RosterPreview preview;
  const WorkTime compared =
      milliseconds([&] { preview = previewRoster(session, file, RosterKind::kTrainees, columns); });
  const WorkTime stored = milliseconds([&] {
    static_cast<void>(importRoster(session, file, RosterKind::kTrainees, columns, preview.fingerprint,
                                   RosterMode::kCommit));
  });
  print("a roster of 10,000 is compared", compared);
  std::printf("   (%zu new)\n", preview.added);
  print("and stored, with its audit entries", stored);
  std::printf("\n");
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication application(argc, argv);
  torsio::testing::StudyCentre centre;
  torsio::CohortId cohortId;
  torsio::print("filling", torsio::milliseconds([&] { cohortId = torsio::bench::fillLargeStudy(centre); }));
  std::printf("\n");
  const torsio::Verdict report = torsio::measureReport(centre, cohortId);
  const torsio::Verdict trials = torsio::measureTrials(centre);
  const torsio::Verdict lists = torsio::measureLists(centre);
  torsio::measureRoster();
  return static_cast<int>(torsio::worse(report, torsio::worse(trials, lists)));
}
