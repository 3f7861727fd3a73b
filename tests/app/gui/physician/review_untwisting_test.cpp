// SPDX-License-Identifier: GPL-3.0-or-later
// A physician's desk for an untwisting: traces of the organ in step with the cursor, blinded. Nothing that
// a physician can see, on any page in any state, contains a name, group, stage or model.

#include <filesystem>
#include <string>
#include <vector>

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
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
#include "app/gui/physician/trace_view.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/centre_settings.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/rater_calibration.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"

namespace torsio::gui {

namespace {

using torsio::testing::ReviewCentre;

/// Two seconds at 1 kHz: an angle falling from 90 degrees, and the organ's condition.
TraceData tracesOf(std::uint32_t rules, const HollowReading& first, const HollowReading& last) {
  TraceCollector collector(2001);
  std::vector<Sample> samples(2001);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Sample& sample = samples[i];
    const double share = static_cast<double>(i) / 2000.0;
    sample.tick = static_cast<std::int64_t>(i);
    sample.device.time_us = 1000 * sample.tick;
    sample.rules = rules;
    sample.response.angle_rad = radians(90.0 * (1.0 - share));
    sample.response.torque_Nm = 0.05;
    sample.response.force_N = {0.0, 3.0, 4.0};
    sample.force_N = {0.0, 0.6, 0.8};  // the device's maximum
    sample.hollow = share < 0.5 ? first : last;
  }
  collector.add(samples);
  return collector.finish();
}

/// Pressures of 5 and 20 mmHg; a dose of .95 is half way between .7 and 1.2, so half of it is black.
TraceData untwisted() {
  constexpr double kMmHg_Pa = 133.322387415;
  return tracesOf(kRulesOfDetorsion,
                  {.pressure_Pa = 20.0 * kMmHg_Pa, .patency = 0.1, .flow = 0.25, .dose = 0.5},
                  {.pressure_Pa = 5.0 * kMmHg_Pa, .patency = 0.9, .flow = 0.75, .dose = 0.95});
}

TEST(TracesOfATwist, AreAngleTorqueAndForce) {
  const TraceData data = tracesOf(kRulesOfStoredEnergy, {}, {});
  TraceView view;
  const int before = view.sizeHint().height();

  view.setData(&data);

  EXPECT_EQ(view.laneTexts(),
            (QStringList{QStringLiteral("Angle 0…90°"), QStringLiteral("Torque 0…0.050 N m"),
                         QStringLiteral("Force 0…5.00 N")}));
  EXPECT_EQ(view.accessibleName(), QStringLiteral("Traces of angle, torque and force"));
  EXPECT_EQ(view.accessibleDescription(),
            QStringLiteral(
                "0:02.0 long; greatest angle 90 degrees, torque 0.050 newton metres, force 5.00 newtons; "
                "bookmarks: 0"));
  EXPECT_EQ(view.sizeHint().height(), before);
}

TEST(TracesOfATwist, ShowTheirValuesAtTheCursorNotTheirExtremes) {
  const TraceData data = tracesOf(kRulesOfStoredEnergy, {}, {});
  TraceView view;
  view.setData(&data);

  view.setPosition_us(400'000);  // a fifth of 2 s: 90 - 18 degrees
  const QStringList early = view.readings();
  view.setPosition_us(1'000'000);
  const QStringList middle = view.readings();

  EXPECT_EQ(early,
            (QStringList{QStringLiteral("72°"), QStringLiteral("0.050 N m"), QStringLiteral("5.00 N")}));
  EXPECT_EQ(middle.front(), QStringLiteral("45°"));
}

TEST(TracesOfATwist, ShowTargetToleranceAndLimitsWithinTheirScales) {
  TraceData data = tracesOf(kRulesOfStoredEnergy, {}, {});
  data.marks =
      TraceMarks{.target_deg = 120.0F, .tolerance_deg = 10.0F, .torqueLimit_Nm = 0.2F, .forceLimit_N = 10.0F};
  TraceView view;
  view.setData(&data);

  EXPECT_EQ(view.laneTexts(),
            (QStringList{QStringLiteral("Angle 0…130°"), QStringLiteral("Torque 0…0.210 N m"),
                         QStringLiteral("Force 0…10.50 N")}));
  EXPECT_TRUE(view.toolTip().contains(QStringLiteral("tolerance")));
  EXPECT_TRUE(view.toolTip().contains(QStringLiteral("limit")));

  data.marks->target_deg = -60.0F;  // opposite direction: the band is below zero
  view.setData(&data);
  EXPECT_EQ(view.laneTexts().front(), QStringLiteral("Angle −70…90°"));
}

TEST(TracesOfAnUntwisting, NameEachScaleWithItsUnit) {
  const TraceData data = untwisted();
  TraceView view;

  view.setData(&data);

  EXPECT_EQ(view.laneTexts(),
            (QStringList{QStringLiteral("Angle 0…90°"), QStringLiteral("Torque 0…50 mN m"),
                         QStringLiteral("Force 0…5.00 N"), QStringLiteral("Blood flow 0…100 %"),
                         QStringLiteral("Ischaemic dose 0…1.00"), QStringLiteral("Black share 0…100 %"),
                         QStringLiteral("Lumen 0…100 %"), QStringLiteral("Pressure 0…20 mmHg")}));
  EXPECT_TRUE(view.accessibleDescription().contains(QStringLiteral("Blood flow 0…100 %")));
  EXPECT_EQ(view.accessibleName(), QStringLiteral("Traces of an untwisting"));
}

TEST(TracesOfAnUntwisting, ShowTheirValuesAtTheCursor) {
  const TraceData data = untwisted();
  TraceView view;
  view.setData(&data);

  view.setPosition_us(400'000);  // a fifth of 2 s: 90 - 18 degrees
  const QStringList early = view.readings();
  view.setPosition_us(2'000'000);
  const QStringList late = view.readings();

  EXPECT_EQ(early, (QStringList{QStringLiteral("72°"), QStringLiteral("50 mN m"), QStringLiteral("5.00 N"),
                                QStringLiteral("25 %"), QStringLiteral("0.50"), QStringLiteral("0 %"),
                                QStringLiteral("10 %"), QStringLiteral("20 mmHg")}));
  EXPECT_EQ(late, (QStringList{QStringLiteral("0°"), QStringLiteral("50 mN m"), QStringLiteral("5.00 N"),
                               QStringLiteral("75 %"), QStringLiteral("0.95"), QStringLiteral("50 %"),
                               QStringLiteral("90 %"), QStringLiteral("5 mmHg")}));
}

TEST(TracesOfAnUntwisting, OmitTheLumenForAnOrganWithoutOne) {
  const TraceData data = tracesOf(kRulesOfDetorsion, {.flow = 0.2, .dose = 0.1}, {.flow = 0.9, .dose = 0.3});
  TraceView view;

  view.setData(&data);

  ASSERT_EQ(view.laneTexts().size(), 6);
  EXPECT_EQ(view.laneTexts().back(), QStringLiteral("Black share 0…100 %"));
}

/// A desk with the recording of a shipped loop that came twisted and was untwisted.
class DeskOfAnUntwisting : public ::testing::Test {
 protected:
  static Scene scene() {
    SceneRequest request;
    request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    request.id = "small-bowel-loop";
    request.pattern = "detorse";
    return loadScene(request);
  }
  static ReviewCentre::Setup setup(const Scene& organ) {
    ReviewCentre::Setup made;
    made.raters = 1;
    made.trainees = 1;
    made.scene = &organ;
    return made;
  }
  [[nodiscard]] Trial trial() { return TrialRepository(centre_.connection()).load(centre_.trialIds()[0]); }

  Scene organ_ = scene();
  ReviewCentre centre_{setup(organ_)};
  DeskOf desk_{centre_, 0};
  CasePage& page_ = desk_.open<CasePage>(inputOf(centre_.caseAbout(0, 0)));
  ReplayPanel& replay_ = child<ReplayPanel>(page_, "replay");
  TraceView& traces_ = *replay_.findChild<TraceView*>();
};

TEST_F(DeskOfAnUntwisting, ShowsTheOrgansConditionInStepWithTheReplay) {
  const Sample last = decodeChunk(trial().chunks.back()).back();

  replay_.seek_us(replay_.recording()->playback.duration_us());

  const QStringList told = traces_.readings();
  const QStringList painted = paintedWordsOf(page_);
  ASSERT_EQ(told.size(), 8);
  EXPECT_EQ(told[3], QStringLiteral("%1 %").arg(100.0 * last.hollow.flow, 0, 'f', 0));
  EXPECT_EQ(told[4], QString::number(last.hollow.dose, 'f', 2));
  EXPECT_EQ(told[6], QStringLiteral("%1 %").arg(100.0 * last.hollow.patency, 0, 'f', 0));
  for (const QString& one : told) {
    // A minus sign of another font is painted by itself.
    const QString digits = one.startsWith(QChar(0x2212)) ? one.mid(1) : one;
    EXPECT_TRUE(painted.contains(one) || painted.contains(digits)) << one.toStdString();
  }
}

TEST_F(DeskOfAnUntwisting, RevealsNeitherPersonTimeNorSeed) {
  const Trial recorded = trial();
  const std::uint64_t seed = detorsionSeed(recorded.header.trialId);
  std::vector<std::string> secrets = centre_.secrets();
  for (const std::string& one :
       {std::to_string(seed), QString::number(seed, 16).toStdString(), recorded.summary.contentHash,
        recorded.header.organHash, recorded.header.parameterHash, std::string("seed")}) {
    secrets.push_back(one);
  }
  QStringList found = wordsOf(page_) + traces_.laneTexts() + traces_.readings();
  replay_.seek_us(replay_.recording()->playback.duration_us() / 2);
  found << wordsOf(page_) << traces_.readings() << desk_.notices() << desk_.watched().told;

  EXPECT_TRUE(found.contains(QStringLiteral("Black share 0…100 %")));
  const QRegularExpression occasion(QStringLiteral("\\b(mid|post|stage|group)\\b"));
  EXPECT_TRUE(found.filter(occasion).isEmpty())
      << found.filter(occasion).join(QLatin1Char('|')).toStdString();
  for (const std::string& secret : secrets) {
    for (const QString& text : found) {
      EXPECT_FALSE(text.contains(toQString(secret), Qt::CaseInsensitive))
          << secret << " in \"" << text.toStdString() << "\"";
    }
  }
}

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
  setCentreSetting<kPanelWaits>(*centre.administrator(), false);  // their queues are longer
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
