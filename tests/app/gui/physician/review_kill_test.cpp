// SPDX-License-Identifier: GPL-3.0-or-later
// Kills a physician's program while a form is filled in: the real case page, operated by keys. The program
// killed is this one, started with --score.
#include <cstring>
#include <iostream>

#include <QApplication>
#include <QPlainTextEdit>
#include <QProcess>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/outputs/charts/typeface.h"
#include "tests/app/gui/physician/desk_of.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;

constexpr const char* kScore = "--score";
constexpr int kPatience_ms = 60'000;
constexpr int kKeys = 30;

/// Presses keys forever; prints a line after each.
[[noreturn]] void pressForever(const std::filesystem::path& folder) {
  ReviewCentre centre(folder);
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  const auto tell = [] { std::cout << "key\n" << std::flush; };
  desk.press(Qt::Key_7);
  tell();
  desk.press({Qt::Key_Down, Qt::Key_4});
  tell();
  child<QPlainTextEdit>(page, "comment").setFocus();
  for (int i = 0;; ++i) {
    desk.type(QString(QLatin1Char(static_cast<char>('a' + i % 26))));
    tell();
  }
}

TEST(KilledCasePage, LosesAtMostOneKeystroke) {
  ReviewCentre centre(ReviewCentre::Setup{});
  QProcess program;
  program.start(QCoreApplication::applicationFilePath(),
                {QString::fromLatin1(kScore), toQString(centre.folder())});
  QByteArray said;
  while (said.count('\n') < kKeys && program.waitForReadyRead(kPatience_ms)) {
    said += program.readAllStandardOutput();
  }

  program.kill();  // SIGKILL: no leave(), no destructor, no flush
  ASSERT_TRUE(program.waitForFinished(kPatience_ms));
  said += program.readAllStandardOutput();

  const auto pressed = static_cast<std::size_t>(said.count('\n'));
  ASSERT_GE(pressed, static_cast<std::size_t>(kKeys)) << program.readAllStandardError().toStdString();
  DeskOf again(centre, 0);
  const auto& page = again.open<CasePage>(inputOf(centre.cases(0).front()));
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 40);
  // Two of the keys were scores; the others are in the comment, possibly with the interrupted one.
  const std::string comment = editorOf(page)->sheet().comment;
  EXPECT_GE(comment.size(), pressed - 2);
  EXPECT_LE(comment.size(), pressed - 1);
  for (std::size_t i = 0; i < comment.size(); ++i) {
    ASSERT_EQ(comment[i], static_cast<char>('a' + i % 26));
  }
}

}  // namespace

int run(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  QApplication application(argc, argv);
  useTypeface(application);
  if (argc == 3 && std::strcmp(argv[1], kScore) == 0) {
    pressForever(argv[2]);
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace torsio::gui

int main(int argc, char** argv) {
  return torsio::gui::run(argc, argv);
}
