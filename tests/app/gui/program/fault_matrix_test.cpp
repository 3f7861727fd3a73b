// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a vendor's library may do, in the four places where one runs: free practice, a graded run,
// the device check, the monitor. What counts is the force at the motors, as seen by the fake, whichever
// process was killed.
//
// TORSIO_FAULT_MATRIX=all runs every fault in every place (minutes); without it, each fault runs in one
// place.
// TORSIO_KILLS=200 kills that many windows while they render force.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <QApplication>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/app/gui/program/fault_run.h"
#include "tests/app/gui/program/fault_scenarios.h"

namespace torsio::gui::testing {
namespace {

using fakehd::Seen;
using fakehd::SeenEvent;

constexpr std::array<const char*, 4> kPlaces{"practice", "graded", "check", "monitor"};
constexpr int kAtOnce = 6;
/// The child's watchdog, and every answer of a driver with a working library.
constexpr double kLetsGo_ms = 20.0;
/// Time to end an unresponsive device process: 20 polls of 5 ms, and the kill.
constexpr double kEnds_ms = 120.0;
/// Maximum time for which a window may be unresponsive, and take to close.
constexpr double kStandsStill_ms = 1000.0;
constexpr double kCloses_ms = 3500.0;

/// A fault in a place, with the violations found.
struct Cell {
  const FaultScenario* scenario = nullptr;
  std::string place;
  std::vector<std::string> wrong{};
  std::string figures{};
};

/// Calls `work` for 0 .. count-1, several in parallel.
void runInParallel(int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < kAtOnce; ++i) {
    threads.emplace_back([&] {
      for (int k = next++; k < count; k = next++) {
        work(k);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
}

std::string folderOf(const std::string& name) {
  return ::testing::TempDir() + "torsio_fault_" + std::to_string(getpid()) + "_" + name;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Judges one cell.
class Verdict {
 public:
  Verdict(Cell& cell, const FaultRun& run) : cell_(cell), run_(run), course_(cell.scenario->course) {}

  void judge() {
    judgeMotors();
    judgeWords();
    if (cell_.place == "practice" || cell_.place == "graded") {
      judgeWindow();
    }
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) {
      cell_.wrong.push_back(what);
    }
  }
  [[nodiscard]] bool command() const { return cell_.place == "check" || cell_.place == "monitor"; }
  [[nodiscard]] bool mayPush() const {
    return cell_.place != "monitor" && course_ != Course::kRefused && course_ != Course::kNeverOn;
  }

  void judgeMotors() {
    const auto& record = run_.record();
    const double most_N = 1e-6 * static_cast<double>(record->most_uN);
    expect(most_N <= 3.3 + 1e-6, "more than 3.3 N: " + std::to_string(most_N));
    expect(mayPush() == (most_N > 0.0), mayPush() ? "no force ever" : "a force where none may be");
    const SeenEvent* const fault = record.first(Seen::kFault);
    const std::int64_t fault_ns = fault != nullptr ? fault->time_ns.load() : 0;
    const bool inUse = course_ == Course::kLost || course_ == Course::kForceOff || course_ == Course::kEnded;
    if (inUse) {
      expect(fault != nullptr, "the fault never came");
      // The check updates its force in a normal thread, which a busy machine may delay.
      expect(fault == nullptr || command() || run_.pushedAt(fault_ns), "no force at the fault");
    }
    if (fault != nullptr && (course_ == Course::kLost || course_ == Course::kForceOff)) {
      const double rest_ms = run_.restAfter_ms(fault_ns, fault->waited_ns);
      cell_.figures += " rest " + std::to_string(rest_ms) + " ms";
      expect(rest_ms >= 0.0 && rest_ms <= cell_.scenario->restsWithin_ms,
             "force left for " + std::to_string(rest_ms) + " ms");
    }
    if (fault != nullptr && course_ == Course::kEnded) {
      const double gone_ms = 1e-6 * static_cast<double>(run_.deviceSeen_ns() - fault_ns - run_.heldUp_ns());
      cell_.figures += " gone " + std::to_string(gone_ms) + " ms";
      expect(run_.deviceGone() && gone_ms <= kEnds_ms,
             "the device process was there for " + std::to_string(gone_ms) + " ms");
    }
    expect(record->motors_uN == 0, "a force stayed at the motors");
    expect(record->process == 0 || run_.deviceGone(), "the device process stayed");
    judgeOrder();
  }

  /// Checks the order zero force, output off, stop, device off, if the library works to the end.
  void judgeOrder() {
    if (course_ != Course::kWorks && course_ != Course::kForceOff && course_ != Course::kNeverOn) {
      return;
    }
    const auto& record = run_.record();
    std::int64_t before_ns = 0;
    for (const Seen step : {Seen::kRest, Seen::kOutputOff, Seen::kStop, Seen::kUnschedule, Seen::kDisable}) {
      const SeenEvent* const event = record.last(step);
      if (event == nullptr && (step == Seen::kRest || step == Seen::kStop)) {
        continue;  // no force ever
      }
      expect(event != nullptr && event->time_ns >= before_ns, "not let go of in order");
      before_ns = event != nullptr ? event->time_ns.load() : before_ns;
    }
  }

  void judgeWords() {
    const std::string& said = run_.said();
    expect(!contains(said, "orce is off"), "claims that the force is off");
    const std::string& words = cell_.scenario->words;
    if (cell_.place == "check") {
      expect(words.empty() || contains(said, words), "does not say \"" + words + "\"");
      expect(run_.code() == (course_ == Course::kWorks ? 0 : static_cast<int>(ErrorCode::kDevice)),
             "exit code " + std::to_string(run_.code()));
    } else if (cell_.place == "monitor") {
      const bool lost = course_ == Course::kLost || course_ == Course::kEnded ||
                        course_ == Course::kRefused || contains(cell_.scenario->story, "DIE_AT_TICK=0");
      expect(run_.code() == (lost ? static_cast<int>(ErrorCode::kDevice) : 0),
             "exit code " + std::to_string(run_.code()));
    } else {
      judgeWindowWords(said);
    }
  }

  void judgeWindowWords(const std::string& said) {
    expect(run_.code() == 0, "exit code " + std::to_string(run_.code()));
    const bool graded = cell_.place == "graded";
    const bool silent = contains(cell_.scenario->story, "DIE_AT_TICK=0");
    if (cell_.scenario->impatient) {
      return;  // the reader was gone
    }
    if (course_ == Course::kRefused) {
      expect(contains(said, graded ? "the graded run did not begin" : "You practise with mouse and keyboard"),
             "does not say that the device is missing");
    } else if (course_ == Course::kLost || course_ == Course::kEnded || silent) {
      expect(contains(said, graded ? "The haptic device was disconnected: the graded run has ended"
                                   : "The haptic device was disconnected. Put it down"),
             "does not say that the device was lost");
    } else {
      expect(!contains(said, "was disconnected"), "says that the device was lost");
      expect(graded || contains(said, "The force is felt"), "does not say what is felt");
    }
  }

  void judgeWindow() {
    const std::size_t begin = run_.said().find("{\"");
    const nlohmann::json out = begin == std::string::npos
                                   ? nlohmann::json()
                                   : nlohmann::json::parse(run_.said().substr(begin), nullptr, false);
    expect(out.is_object(), "printed nothing");
    if (!out.is_object()) {
      return;
    }
    const double longest_ms = out["longest_ms"];
    const double closed_ms = out["closed_ms"];
    cell_.figures +=
        " still " + std::to_string(longest_ms) + " ms, closed " + std::to_string(closed_ms) + " ms";
    expect(longest_ms <= kStandsStill_ms, "the window stood still for " + std::to_string(longest_ms) + " ms");
    expect(closed_ms <= kCloses_ms, "the window took " + std::to_string(closed_ms) + " ms to close");
  }

  Cell& cell_;
  const FaultRun& run_;
  const Course course_;
};

std::vector<Cell> cellsToRun() {
  const char* const wanted = std::getenv("TORSIO_FAULT_MATRIX");
  const std::string which = wanted != nullptr ? wanted : "";
  std::vector<Cell> cells;
  std::size_t number = 0;
  for (const FaultScenario& scenario : faultScenarios()) {
    const std::size_t turn = number++;
    for (std::size_t place = 0; place < kPlaces.size(); ++place) {
      const bool named = !which.empty() && which != "all" && contains(scenario.name, which);
      const bool sampled = which.empty() && place == turn % kPlaces.size() && !(scenario.slow && turn > 0);
      if (which == "all" || named || sampled) {
        cells.push_back({&scenario, kPlaces[place]});
      }
    }
  }
  // Slow cells start first.
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return a.scenario->slow > b.scenario->slow; });
  return cells;
}

TEST(FaultMatrix, NoForceRemainsWhateverALibraryDoesAndTheWindowReportsIt) {
  std::vector<Cell> cells = cellsToRun();
  runInParallel(static_cast<int>(cells.size()), [&](int k) {
    Cell& cell = cells[static_cast<std::size_t>(k)];
    const std::string folder = folderOf(std::to_string(k));
    FaultRun run(cell.place, *cell.scenario, folder);
    if (!run.watch()) {
      cell.wrong.emplace_back("had to be killed");
    }
    Verdict(cell, run).judge();
    if (!cell.wrong.empty()) {
      cell.wrong.push_back("it said: " + run.said());
    }
    std::filesystem::remove_all(folder);
  });

  for (const Cell& cell : cells) {
    if (std::getenv("TORSIO_FAULT_MATRIX") != nullptr) {
      std::printf("%-40s %-9s%s\n", cell.scenario->name.c_str(), cell.place.c_str(), cell.figures.c_str());
    }
    for (const std::string& wrong : cell.wrong) {
      ADD_FAILURE() << cell.scenario->name << ", " << cell.place << ": " << wrong;
    }
  }
  RecordProperty("cells", static_cast<int>(cells.size()));
}

/// Kills a window while it renders force; returns for how long the motors kept it, ms.
double endWindow(const std::string& place, int how, double after_s, const std::string& folder) {
  static const FaultScenario kUsual{"", "", Course::kWorks};
  FaultRun run(place, kUsual, folder);
  const auto until = now_ns() + 30'000'000'000;
  while (run.record()->motors_uN == 0 && now_ns() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(std::chrono::duration<double>(after_s));
  const std::int64_t device = run.record()->process;
  const std::int64_t waited_ns =
      fakehd::waited_ns(device, device) + fakehd::waited_ns(device, run.record()->servo);
  const std::int64_t killed_ns = now_ns();
  const bool pushed = run.pushedAt(killed_ns);
  if (!pushed || device <= 0 || run.program() <= 0) {
    return -3.0;  // nothing to end; kill() with 0 or -1 affects many processes
  }
  kill(run.program(), how);
  if (how == SIGHUP) {
    kill(static_cast<pid_t>(device), SIGHUP);  // the end of a session affects all its processes
  }
  (void)run.watch();
  std::filesystem::remove_all(folder);
  return run.record().last(Seen::kDisable) == nullptr ? -2.0 : run.restAfter_ms(killed_ns, waited_ns);
}

TEST(KilledWindows, LeaveNoForceAtTheMotorsForMoreThanTwentyMilliseconds) {
  constexpr std::array kSignals{SIGKILL, SIGTERM, SIGINT, SIGHUP};
  const char* const wanted = std::getenv("TORSIO_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 8;
  std::vector<double> rest_ms(static_cast<std::size_t>(kills));
  runInParallel(kills, [&](int k) {
    Random random(static_cast<std::uint64_t>(k) + 1);
    rest_ms[static_cast<std::size_t>(k)] =
        endWindow(kPlaces[static_cast<std::size_t>(k / 4 % 2)], kSignals[static_cast<std::size_t>(k % 4)],
                  0.5 * random.uniform(), folderOf("kill_" + std::to_string(k)));
  });

  for (int k = 0; k < kills; ++k) {
    const double rest = rest_ms[static_cast<std::size_t>(k)];
    EXPECT_GT(rest, 0.0) << k;
    EXPECT_LE(rest, kLetsGo_ms) << k;
  }
  std::sort(rest_ms.begin(), rest_ms.end());
  std::printf("%d windows ended with force on: median %.2f ms, slowest %.2f ms\n", kills,
              rest_ms[rest_ms.size() / 2], rest_ms.back());
}

int run(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  const QApplication application(argc, argv);
  if (argc == 5 && std::strcmp(argv[1], kBeAPlace) == 0) {
    return beAPlace(argv[2], argv[3], std::strtod(argv[4], nullptr));
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace
}  // namespace torsio::gui::testing

int main(int argc, char** argv) {
  return torsio::gui::testing::run(argc, argv);
}
