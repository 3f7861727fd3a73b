// SPDX-License-Identifier: GPL-3.0-or-later
// Names of organs and twists in lists: the titles of their files, in the window's language.
#include "app/gui/base/scene_titles.h"

#include <algorithm>

#include <QComboBox>
#include <QRegularExpression>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/exercise_panel.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {
namespace {

const std::filesystem::path kShipped = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

bool isChinese(const QString& text) {
  static const QRegularExpression kHan(QStringLiteral("\\p{Han}"));
  return kHan.match(text).hasMatch();
}

TEST(SceneTitles, NameAVolvulusAsInItsFileAndNotByItsId) {
  SceneTitles titles(kShipped);

  EXPECT_EQ(titles.scene("gastric-organo-axial"), QStringLiteral("Stomach, organo-axial volvulus"));
  EXPECT_EQ(titles.pattern("gastric-organo-axial", "detorse"),
            QStringLiteral("Untwist an organo-axial volvulus"));
  EXPECT_EQ(titles.pattern("midgut", "detorse"), QStringLiteral("Untwist a midgut volvulus"));
}

TEST(SceneTitles, AreChineseForEveryShippedSceneWithItsPatternsBriefingAndValidity) {
  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  SceneTitles titles(kShipped);

  std::size_t undone = 0;
  for (const std::string& id : sceneIds(kShipped)) {
    EXPECT_TRUE(isChinese(titles.scene(id))) << id;
    for (const PatternDescription& one : readSceneFile(kShipped, id).patterns) {
      EXPECT_TRUE(isChinese(titles.pattern(id, one.pattern.id))) << id << " " << one.pattern.id;
      if (one.pattern.detorsion) {
        ++undone;
        EXPECT_TRUE(isChinese(toQString(Text(one.pattern.detorsion->briefing)))) << id;
        EXPECT_TRUE(isChinese(toQString(Text(one.pattern.detorsion->validity)))) << id;
      }
    }
  }

  EXPECT_EQ(undone, 6U);  // scenes that come twisted, assets/scenes/README.md
}

TEST(SceneTitles, FallBackToTheIdOfARecordingFromElsewhere) {
  SceneTitles titles(kShipped);

  EXPECT_EQ(titles.scene("own_organ"), QStringLiteral("Own organ"));
  EXPECT_EQ(titles.pattern("own_organ", "half-turn"), QStringLiteral("Half-turn"));
  EXPECT_EQ(titles.pattern("stomach", "no_such"), QStringLiteral("No such"));
}

TEST(SceneTitles, AreShownInTheListOfOrgansAlsoAfterAChangeOfLanguage) {
  ExercisePanel panel;
  panel.setOrgans(kShipped);
  const auto boxes = panel.findChildren<QComboBox*>();
  const auto organ = std::find_if(boxes.begin(), boxes.end(), [](const QComboBox* box) {
    return box->findData(QStringLiteral("sigmoid")) >= 0;
  });
  ASSERT_NE(organ, boxes.end());
  const int row = (*organ)->findData(QStringLiteral("sigmoid"));
  EXPECT_EQ((*organ)->itemText(row), QStringLiteral("Sigmoid volvulus"));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  panel.retranslate();

  EXPECT_EQ((*organ)->itemText(row), QStringLiteral("乙状结肠扭转"));
}

}  // namespace
}  // namespace torsio::gui
