// SPDX-License-Identifier: GPL-3.0-or-later
// Large exports and imports: 10,000 trials and 100,000 marks as a workbook within 10 s and 500 MB and as
// tables within 5 s; an hour of foreign motion at 1 kHz within 10 s. Processor time. Exit code 0: all met, 1:
// missed.
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <sys/resource.h>

#include <QCoreApplication>
#include <nlohmann/json.hpp>

#include "app/connectors/foreign/foreign_import.h"
#include "app/outputs/dataset/cohort_exchange.h"
#include "tests/app/support/study_centre.h"
#include "tests/bench/large_study.h"

namespace torsio::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kBookTarget_s = 10.0;
constexpr double kTablesTarget_s = 5.0;
constexpr double kImportTarget_s = 10.0;
constexpr double kMemoryTarget_MB = 500.0;
constexpr int kHour_ms = 3'600'000;

/// Returns the peak memory of this program.
double peakMemory_MB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1'024.0;
}

/// Runs work and prints its time; returns whether it met its target (0: none).
bool meetsTarget(const char* what, double target_s, const std::function<void()>& work) {
  const std::clock_t begun = std::clock();
  work();
  const double took_s = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  const bool met = target_s == 0.0 || took_s <= target_s;
  std::printf("%-40s %6.2f s of the processor, target %4.0f s, memory up to %6.1f MB   %s\n", what, took_s,
              target_s, peakMemory_MB(), met ? "met" : "MISSED");
  std::fflush(stdout);
  return met;
}

/// Writes an hour at 1 kHz as a table, with its map.
fs::path writeHour(const fs::path& folder) {
  std::ofstream out(folder / "hour.csv");
  out << "t,x,y,z,qw,qx,qy,qz,jaw\n";
  for (int ms = 0; ms < kHour_ms; ++ms) {
    const double angle = 0.001 * ms;
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), "%d,%.9g,%.9g,%.9g,%.9g,0,0,%.9g,%.4f\n", ms,
                  0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.05, std::cos(0.5 * angle),
                  std::sin(0.5 * angle), 0.5 + 0.5 * std::sin(0.1 * angle));
    out << line.data();
  }
  const nlohmann::json map{{"cohort", "An hour"},
                           {"source", "made for a benchmark"},
                           {"frame", "the table"},
                           {"unit", "m"},
                           {"rotation", "quaternion wxyz"},
                           {"rotation_columns", {"qw", "qx", "qy", "qz"}},
                           {"position", {"x", "y", "z"}},
                           {"time", {{"column", "t"}, {"unit", "ms"}}},
                           {"grip", {{"column", "jaw"}, {"open", 0.0}, {"closed", 1.0}}},
                           {"groups", {{{"code", "A"}, {"label", "all"}}}},
                           {"people", {{{"name", "one"}, {"group", "A"}}}},
                           {"recordings", {{{"file", "hour.csv"}, {"person", "one"}, {"task", "circles"}}}}};
  std::ofstream(folder / "map.json") << map.dump();
  return folder / "map.json";
}

bool measureOut(testing::StudyCentre& centre) {
  CohortId cohort;
  meetsTarget("filling", 0.0, [&] { cohort = fillLargeStudy(centre); });
  TrialDigests digests(centre.assets());
  meetsTarget("measuring the recordings, once", 0.0, [&] {
    static_cast<void>(exchangeData(centre.as("statistician"), {.cohortId = cohort}, digests));
  });
  const auto all = [&] { return exchangeData(centre.as("statistician"), {.cohortId = cohort}, digests); };
  bool met = meetsTarget("tables (.csv)", kTablesTarget_s, [&] {
    exportTables(centre.as("statistician"), all(), TableFormat::kCsv, centre.folder() / "csv");
  });
  met = meetsTarget("tables (.sav)", kTablesTarget_s,
                    [&] {
                      exportTables(centre.as("statistician"), all(), TableFormat::kSpss,
                                   centre.folder() / "spss");
                    }) &&
        met;
  met = meetsTarget("workbook", kBookTarget_s,
                    [&] {
                      exportWorkbook(
                          centre.as("statistician"), all(), [](const Text& text) { return text.str(); },
                          centre.folder() / "book.xlsx");
                    }) &&
        met;
  if (peakMemory_MB() > kMemoryTarget_MB) {
    std::printf("memory: MISSED\n");
    met = false;
  }
  return met;
}

}  // namespace
}  // namespace torsio::bench

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  torsio::testing::StudyCentre centre;
  const bool out = torsio::bench::measureOut(centre);
  const std::filesystem::path map = torsio::bench::writeHour(centre.folder());
  const bool in = torsio::bench::meetsTarget(
      "an hour of foreign motion at 1 kHz", torsio::bench::kImportTarget_s,
      [&] { torsio::importForeign(centre.as("administrator"), torsio::ForeignLayout::kCsv, map, ""); });
  return out && in ? 0 : 1;
}
