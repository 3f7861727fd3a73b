// SPDX-License-Identifier: GPL-3.0-or-later
// A physician's program is killed while a sheet is being filled in: typed text must be there at the next
// start. The killed program is this one, started with --score.
#include <cstring>
#include <iostream>

#include <QCoreApplication>
#include <QProcess>
#include <gtest/gtest.h>

#include "app/services/review/case_sheet.h"
#include "app/services/review/sheet_editor.h"
#include "tests/app/support/review_centre.h"

namespace torsio {
namespace {

constexpr const char* kScore = "--score";
constexpr int kPatience_ms = 60'000;

/// Types into the comment endlessly; prints a line after each saved keystroke.
[[noreturn]] void scoreForever(const std::filesystem::path& folder) {
  ReviewCentre centre(folder);
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  SheetEditor editor(openSheet(*desk, id).rubric, {});
  editor.setScore("time", 70);
  std::string comment;
  for (int i = 0;; ++i) {
    comment += static_cast<char>('a' + i % 26);
    editor.setComment(comment);
    editor.saved(saveSheet(*desk, id, editor.sheet(), WatchLog(2'000'000)));
    std::cout << "key\n" << std::flush;
  }
}

TEST(KilledSheet, LosesNoSavedKeystroke) {
  ReviewCentre centre(ReviewCentre::Setup{});
  QProcess program;
  program.start(QCoreApplication::applicationFilePath(),
                {QString::fromLatin1(kScore), QString::fromStdString(centre.folder().string())});
  QByteArray said;
  while (said.count('\n') < 20 && program.waitForReadyRead(kPatience_ms)) {
    said += program.readAllStandardOutput();
  }

  program.kill();  // SIGKILL: no destructor, no flush
  ASSERT_TRUE(program.waitForFinished(kPatience_ms));
  said += program.readAllStandardOutput();

  const auto desk = centre.physician(0);
  const OpenedSheet opened = openSheet(*desk, centre.cases(0).front());
  ASSERT_GE(said.count('\n'), 20) << program.readAllStandardError().toStdString();
  EXPECT_EQ(opened.state, SheetState::kDraft);
  EXPECT_EQ(SheetEditor(opened.rubric, opened.sheet).answer("time").score_steps, 70);
  // Each reported keystroke is there, and possibly the one that was being saved.
  const auto reported = static_cast<std::size_t>(said.count('\n'));
  EXPECT_GE(opened.sheet.comment.size(), reported);
  EXPECT_LE(opened.sheet.comment.size(), reported + 1);
  for (std::size_t i = 0; i < opened.sheet.comment.size(); ++i) {
    ASSERT_EQ(opened.sheet.comment[i], static_cast<char>('a' + i % 26));
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc == 3 && std::strcmp(argv[1], torsio::kScore) == 0) {
    torsio::scoreForever(argv[2]);
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
