// SPDX-License-Identifier: GPL-3.0-or-later
// A physician's desk for an untwisting: traces of the organ in step with the cursor, blinded.
#include <filesystem>
#include <string>
#include <vector>

#include <QRegularExpression>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/trace_view.h"
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
    EXPECT_TRUE(painted.contains(one)) << one.toStdString();
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

}  // namespace
}  // namespace torsio::gui
