// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that a physician can see, on any page in any state, contains a name, group, stage or model.
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/discrepancy_review_page.h"
#include "app/gui/physician/evaluation_page.h"
#include "app/gui/physician/live_page.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/rater_calibration_page.h"
#include "app/gui/physician/review_pages.h"
#include "app/gui/physician/severity_page.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/rater_calibration.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;

QStringList gLogged;  // NOLINT: a message handler has no other place
void keepMessage(QtMsgType, const QMessageLogContext&, const QString& text) {
  gLogged << text;
}

/// Collects everything a physician can see on every page in every state.
class Gathering {
 public:
  Gathering() : before_(qInstallMessageHandler(keepMessage)) { gLogged.clear(); }
  ~Gathering() { qInstallMessageHandler(before_); }
  Gathering(const Gathering&) = delete;
  Gathering& operator=(const Gathering&) = delete;

  /// Collects the present page, and what its lists copy to the clipboard.
  void look(QWidget& page) {
    QApplication::processEvents();
    for (DataTable* table : page.findChildren<DataTable*>()) {
      table->view().selectAll();
      QTest::keyClick(&table->view(), Qt::Key_C, Qt::ControlModifier);
      found_ << QApplication::clipboard()->text();
    }
    const QStringList words = wordsOf(page);
    EXPECT_GT(words.join(QString()).size(), 40);
    EXPECT_FALSE(paintedWordsOf(page).isEmpty());
    found_ << words;
  }
  void add(const QStringList& texts) { found_ << texts; }

  /// Returns everything, with the log, stored settings and file names.
  [[nodiscard]] QStringList all(const std::filesystem::path& folder) {
    found_ << gLogged << QSettings().allKeys();
    for (const QString& key : QSettings().allKeys()) {
      found_ << QSettings().value(key).toString();
    }
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
      found_ << toQString(file.path().filename());
    }
    return found_;
  }

 private:
  QtMessageHandler before_;
  QStringList found_;
};

/// States of a case: waiting, with answers and a remark, confirming, submitted, being amended.
void visitCaseStates(DeskOf& desk, Gathering& gathering, const QString& id) {
  auto& page = desk.open<CasePage>(id);
  gathering.look(page);
  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("hand in the way"));
  gathering.look(page);
  desk.press({Qt::Key_Return, Qt::Key_B, Qt::Key_R});
  desk.type(QStringLiteral("second grip slips"));
  gathering.look(page);
  desk.press(Qt::Key_Return);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  gathering.look(page);  // confirming, but not ready
  desk.press(Qt::Key_Escape);
  scoreCase(desk, 6, 5, 7);
  auto& sealed = desk.open<CasePage>(id);
  gathering.look(sealed);
  for (QPushButton* button : sealed.findChildren<QPushButton*>()) {
    if (button->text().contains(QStringLiteral("mend")) && button->isVisibleTo(&sealed)) {
      button->click();
    }
  }
  gathering.look(sealed);
}

void visitOtherPages(DeskOf& desk, Gathering& gathering) {
  gathering.look(desk.open<QueuePage>());
  auto& calibrationPage = desk.open<RaterCalibrationPage>();
  gathering.look(calibrationPage);
  desk.press(Qt::Key_8);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  gathering.look(calibrationPage);
  auto& live = desk.open<LivePage>();
  gathering.look(live);
  for (int i = 0; i < 3; ++i) {
    desk.press({Qt::Key_6, Qt::Key_Down});
  }
  gathering.look(live);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  gathering.look(live);
  auto& discrepancies = desk.open<DiscrepancyReviewPage>();
  gathering.look(discrepancies);
  for (QPushButton* button : discrepancies.findChildren<QPushButton*>()) {
    if (button->text().contains(QStringLiteral("Move")) && button->isVisibleTo(&discrepancies)) {
      button->click();
    }
  }
  gathering.look(discrepancies);
  gathering.look(desk.open<SeverityPage>());
  auto& evaluation = desk.open<EvaluationPage>();
  gathering.look(evaluation);
  for (int i = 0; i < 9; ++i) {
    desk.press({Qt::Key_7, Qt::Key_Down});
  }
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  gathering.look(evaluation);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  gathering.look(evaluation);
}

TEST(Blinding, NothingReadableRevealsPersonGroupOrStage) {
  ReviewCentre centre({.raters = 3, .live = true});
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.0, 5, false}});
  centre.addTwoModels(false);
  for (std::size_t rater = 0; rater < 3; ++rater) {
    DeskOf scorer(centre, rater);
    scorer.open<CasePage>(inputOf(centre.caseAbout(rater, 0)));
    scoreCase(scorer, 2 + 3 * static_cast<int>(rater), 5, 2 + 3 * static_cast<int>(rater));
  }
  Gathering gathering;
  DeskOf desk(centre, 0);
  ASSERT_FALSE(discrepancyCases(desk.session()).empty());

  for (const PageEntry& entry : reviewPages()) {
    gathering.add({pageTitle(entry.id), pageText(entry.id)});
  }
  visitOtherPages(desk, gathering);
  visitCaseStates(desk, gathering, inputOf(centre.caseAbout(0, 1)));
  gathering.add(desk.notices());
  gathering.add(desk.watched().told);

  const QStringList found = gathering.all(centre.folder());
  std::vector<std::string> secrets = centre.secrets();
  secrets.insert(secrets.end(), {"FEM", "proposed-model", "finite-elements"});
  for (const std::string& secret : secrets) {
    for (const QString& text : found) {
      EXPECT_FALSE(text.contains(toQString(secret), Qt::CaseInsensitive))
          << secret << " in \"" << text.toStdString() << "\"";
    }
  }
}

TEST(Blinding, TheSearchWouldFindAName) {
  QLabel label(QStringLiteral("Zhangwei"));
  label.resize(200, 40);
  EXPECT_TRUE(paintedWordsOf(label).join(QString()).contains(QStringLiteral("Zhangwei")));
  QLabel tip;
  tip.setToolTip(QStringLiteral("40 min virtual"));
  EXPECT_TRUE(wordsOf(tip).join(QString()).contains(QStringLiteral("40 min virtual")));
}

}  // namespace
}  // namespace torsio::gui
