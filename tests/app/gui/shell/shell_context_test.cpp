// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/shell_context.h"

#include <atomic>
#include <memory>
#include <thread>

#include <QApplication>
#include <QObject>
#include <gtest/gtest.h>

#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui {
namespace {

const QString kTitle = QStringLiteral("Work");

/// A job's result that is movable and counts its copies.
struct Counted {
  Counted() = default;
  Counted(const Counted& other) : copies(other.copies + 1) {}
  Counted(Counted&&) = default;
  Counted& operator=(const Counted&) = delete;
  Counted& operator=(Counted&&) = default;
  ~Counted() = default;
  int copies = 0;
};

Error refusal() {
  return {ErrorCode::kBadData, Text::verbatim("the file is empty"), Text::verbatim("a.csv"), Text()};
}

class ShellContextJobs : public ::testing::Test {
 protected:
  torsio::testing::StudyCentre centre_;
  testing::WatchedShell watched_{centre_.session()};
  ShellContext& shell_ = watched_.shell();
  QObject owner_;
};

TEST_F(ShellContextJobs, AResultIsMovedToItsContinuation) {
  int copies = -1;
  std::thread::id worker;
  shell_.run(
      &owner_, kTitle,
      [&worker](SessionContext&, const ProgressCallback&) {
        worker = std::this_thread::get_id();
        return Counted();
      },
      [&copies](Counted result) { copies = result.copies; });
  shell_.waitForJobs();

  EXPECT_EQ(copies, 0);
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST_F(ShellContextJobs, NoContinuationRunsForADeletedOwner) {
  auto owner = std::make_unique<QObject>();
  std::atomic<bool> go{false};
  bool followed = false;
  bool worked = false;
  shell_.run(
      owner.get(), kTitle,
      [&](SessionContext&, const ProgressCallback&) {
        while (!go.load()) {
          std::this_thread::yield();
        }
        worked = true;
      },
      [&followed] { followed = true; });
  owner.reset();
  go.store(true);
  shell_.waitForJobs();

  EXPECT_TRUE(worked);
  EXPECT_FALSE(followed);
  EXPECT_FALSE(shell_.working());
}

TEST_F(ShellContextJobs, TheOwnerAloneReportsARefusal) {
  QString told;
  shell_.run(
      &owner_, kTitle, [](SessionContext&, const ProgressCallback&) -> int { throw refusal(); },
      [](int) { FAIL() << "the work was refused"; },
      [&told](const Error& error) { told = QString::fromStdString(error.where()); });
  shell_.waitForJobs();

  EXPECT_EQ(told, QStringLiteral("a.csv"));
  EXPECT_TRUE(watched_.failures.isEmpty());
}

TEST_F(ShellContextJobs, ARefusalThatTheOwnerLeavesIsReported) {
  shell_.run(
      &owner_, kTitle, [](SessionContext&, const ProgressCallback&) { throw refusal(); },
      [] { FAIL() << "the work was refused"; }, [](const Error&) { return false; });
  shell_.waitForJobs();

  EXPECT_EQ(watched_.failures.size(), 1);
}

TEST_F(ShellContextJobs, ARefusalIsReportedIfItsOwnerIsGone) {
  auto owner = std::make_unique<QObject>();
  std::atomic<bool> go{false};
  bool asked = false;
  shell_.run(
      owner.get(), kTitle,
      [&go](SessionContext&, const ProgressCallback&) {
        while (!go.load()) {
          std::this_thread::yield();
        }
        throw refusal();
      },
      [] { FAIL() << "the work was refused"; }, [&asked](const Error&) { asked = true; });
  owner.reset();
  go.store(true);
  shell_.waitForJobs();

  EXPECT_FALSE(asked);
  EXPECT_EQ(watched_.failures.size(), 1);
}

TEST_F(ShellContextJobs, CancelEndsWaitingJobsButNoLaterOnes) {
  std::atomic<bool> entered{false};
  int followed = 0;
  bool secondWorked = false;
  shell_.run(
      &owner_, kTitle,
      [&entered](SessionContext&, const ProgressCallback& progress) {
        while (true) {
          entered.store(true);
          progress({Text::verbatim("Writing"), 0.5, -1.0});
        }
      },
      [&followed] { ++followed; });
  shell_.run(
      &owner_, kTitle, [&secondWorked](SessionContext&, const ProgressCallback&) { secondWorked = true; },
      [&followed] { ++followed; });
  while (!entered.load()) {
    QApplication::processEvents();
  }
  shell_.cancelJobs();
  int after = 0;
  shell_.run(
      &owner_, kTitle, [](SessionContext&, const ProgressCallback&) { return 7; },
      [&after](int result) { after = result; });
  shell_.waitForJobs();

  EXPECT_EQ(followed, 0);
  EXPECT_FALSE(secondWorked);
  EXPECT_EQ(after, 7);
  EXPECT_TRUE(watched_.failures.isEmpty()) << "who cancels knows";
}

}  // namespace
}  // namespace torsio::gui
