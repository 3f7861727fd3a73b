// SPDX-License-Identifier: GPL-3.0-or-later
// The first run writes nothing before its last step, as it promises: no file, no row, no setting.

#include "app/services/access/first_run.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QObject>
#include <QSettings>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/preferences.h"
#include "assessment/domain/people/account.h"
#include "sim/core/digest.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/program_window.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/study_centre.h"

namespace torsio::gui {

namespace {

namespace fs = std::filesystem;
using testing::named;
using testing::press;
using testing::says;

/// A station with stored settings and separate folders for everything.
class UnwrittenFirstRun : public ::testing::Test {
 protected:
  UnwrittenFirstRun() {
    for (const char* variable : kFolders) {
      before_[variable] = qgetenv(variable);
      qputenv(variable, QByteArray::fromStdString(folder_.path().toStdString()));
    }
    setSettingsPath(folder_.path() + QStringLiteral("/settings"));
  }
  ~UnwrittenFirstRun() override {
    window_.reset();
    for (const auto& [variable, value] : before_) {
      value.isNull() ? qunsetenv(variable) : qputenv(variable, value);
    }
    setSettingsPath(QDir::homePath() + QStringLiteral("/.config"));
  }

  [[nodiscard]] QString file() const { return folder_.filePath(QStringLiteral("torsio.sqlite")); }
  void open(const Text& recordSetBy = "") {
    ShellSetup setup = testing::windowSetup(folder_.path().toStdString());
    setup.remember = true;
    setup.recordSetBy = recordSetBy;
    window_ = testing::openWindow(setup);
  }
  /// Returns every file of the folder with its hash.
  [[nodiscard]] std::map<std::string, std::string> written() const {
    QSettings().sync();
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path().toStdString())) {
      if (entry.is_regular_file()) {
        Digest digest;
        digest.update(std::string_view(readFile(entry.path())));
        files[entry.path().filename().string()] = digest.hex();
      }
    }
    return files;
  }
  void chooseChinese() {
    auto* language = window_->findChild<FirstRunPanel*>()->findChild<QComboBox*>();
    language->setCurrentIndex(1);
    Q_EMIT language->activated(1);
    window_->findChild<FirstRunPanel*>()->setLanguage(Language::kEnglish);
    Q_EMIT language->activated(0);
  }
  /// Goes to this step from the first one; calls `look` on each page.
  void goTo(int step, const std::function<void()>& look) {
    look();
    chooseChinese();
    look();
    if (step > 0) {
      named<QLineEdit>(*window_, QStringLiteral("Name of the centre"))
          ->setText(QStringLiteral("City hospital"));
      press(*window_, QStringLiteral("Next"));
      look();
    }
    if (step > 1) {
      named<QLineEdit>(*window_, QStringLiteral("Sign-in name"))->setText(QStringLiteral("admin"));
      for (const char* field : {"Password", "Repeat password"}) {
        named<QLineEdit>(*window_, QLatin1String(field))
            ->setText(QStringLiteral("a short sentence for the lab"));
      }
      press(*window_, QStringLiteral("Next"));
      look();
    }
    if (step > 2) {
      press(*window_, QStringLiteral("&Test the database"));
      ASSERT_TRUE(QTest::qWaitFor([this] { return says(*window_, QStringLiteral("can be used")); }, 20'000));
      look();
      press(*window_, QStringLiteral("Next"));
      look();
    }
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;

 private:
  static void setSettingsPath(const QString& path) {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path);
  }

  static constexpr const char* kFolders[] = {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME",
                                             "XDG_STATE_HOME"};
  std::map<const char*, QByteArray> before_;
};

TEST_F(UnwrittenFirstRun, ARecordThatIsSetForTheComputerIsShownAndNobodyElseChoosesIt) {
  open(Text::verbatim("torsio.conf, line 3"));
  goTo(2, [] {});
  EXPECT_TRUE(says(*window_, QStringLiteral("Set for this computer in torsio.conf, line 3.")));
  auto* path = named<QLineEdit>(*window_, QStringLiteral("Database file"));
  EXPECT_EQ(path->text(), file());
  EXPECT_FALSE(path->isEnabled());
  EXPECT_FALSE(named<QLineEdit>(*window_, QStringLiteral("Address of the server"))->isEnabled());
  press(*window_, QStringLiteral("Next"));
  press(*window_, QStringLiteral("Set up"));
  testing::waitFor(window_->background());
  EXPECT_EQ(Preferences(true).database(), file());

  Preferences(true).setDatabase(folder_.filePath(QStringLiteral("another.sqlite")));
  window_.reset();
  open(Text::verbatim("torsio.conf, line 3"));
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"))
      << "what was chosen earlier plays no part";

  window_.reset();
  fs::remove(file().toStdString());
  open(Text::verbatim("torsio.conf, line 3"));
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("trouble"))
      << "a record that vanished is not begun anew";
}

TEST_F(UnwrittenFirstRun, LeavesNoFileAndNoSettingOnAnyPageNorAfterClosing) {
  for (int step = 0; step < 4; ++step) {
    open();
    goTo(step, [this] { EXPECT_TRUE(written().empty()) << written().begin()->first; });

    EXPECT_TRUE(window_->close());
    window_.reset();

    EXPECT_TRUE(written().empty()) << step << ": " << written().begin()->first;
  }
}

TEST_F(UnwrittenFirstRun, ReturnsToItsFirstPageWithoutATrace) {
  open();
  goTo(3, [] {});
  for (int step = 3; step > 0; --step) {
    press(*window_, QStringLiteral("Back"));
    EXPECT_TRUE(written().empty()) << written().begin()->first;
  }
}

TEST_F(UnwrittenFirstRun, ReadsAnExistingRecordWithoutChangingIt) {
  {
    SessionContext office(SessionKey{file().toStdString(), "test", {}});
    office.setPasswordCost(PasswordCost::kTest);
  }
  // Readers create temporary SQLite files without content.
  const auto kept = [this] {
    std::map<std::string, std::string> files = written();
    files.erase("torsio.sqlite-shm");
    if (!fs::exists(file().toStdString() + "-wal") || fs::file_size(file().toStdString() + "-wal") == 0) {
      files.erase("torsio.sqlite-wal");
    }
    return files;
  };
  const std::map<std::string, std::string> before = kept();
  ASSERT_EQ(before.size(), 1U);
  open();
  goTo(3, [&] { EXPECT_EQ(kept(), before); });

  EXPECT_TRUE(window_->close());
  window_.reset();

  EXPECT_EQ(kept(), before);
}

TEST_F(UnwrittenFirstRun, StoresAtItsEndWhatWasChosenOnTheWay) {
  open();
  goTo(3, [] {});
  press(*window_, QStringLiteral("Set up"));
  testing::waitFor(window_->background());

  EXPECT_EQ(Preferences(true).database(), file());
  EXPECT_EQ(Preferences(true).language({}), Language::kEnglish);
  EXPECT_EQ(lookAtRecord(file().toStdString()), RecordPlace::kCentre);
  const std::map<std::string, std::string> files = written();
  EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](const auto& one) {
    return one.first.ends_with(".conf");
  })) << "where this test looks for settings there are none";
}

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
