// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a trainee who untwists organs: no series of twists, the task in words.
#include <QComboBox>
#include <gtest/gtest.h>

#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/data_table.h"
#include "assessment/catalogue/quantity.h"
#include "tests/app/gui/support/trainee_station.h"

namespace torsio::gui {
namespace {

using torsio::testing::TrainingCentre;

TrainingCentre::Setup untwistings() {
  TrainingCentre::Setup setup;
  setup.sceneId = "testis";
  setup.patternId = "detorse";
  setup.mastery = {{.metric = "detorse.done", .threshold = 1.0, .unit = "1"},
                   {.metric = "detorse.dose", .comparison = "at_most", .threshold = 0.9, .unit = "1"},
                   {.metric = "detorse.relapse", .comparison = "at_most", .threshold = 0.0, .unit = "1"}};
  return setup;
}

TEST(UntwistingPages, TheTrendShowsTheQuantitiesOfAnUntwisting) {
  TrainingCentre centre(untwistings());
  centre.untwist("first", "practice");
  centre.untwist("first", "practice", 1);
  Station station(centre);

  station.open(PageId::kTrend, QString::fromStdString(centre.module("first")));
  auto& page = static_cast<TrendPage&>(*station.page);
  const auto* table = page.findChild<DataTable*>();
  ASSERT_NE(table, nullptr);

  EXPECT_TRUE(table->asText().contains(QStringLiteral("Ischaemic dose")));
  EXPECT_TRUE(table->asText().contains(QStringLiteral("Not passed")));
  EXPECT_FALSE(table->asText().contains(QStringLiteral("not measured")));
  for (const QComboBox* box : page.findChildren<QComboBox*>()) {
    EXPECT_LT(box->findText(QStringLiteral("Twists on target")), 0);
  }
  page.chooseQuantity(Quantity::kUntwisted);
  EXPECT_TRUE(table->asText().contains(QStringLiteral("yes")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Not reached")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("A yes or no has no learning curve.")));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(UntwistingPages, TheNextStepShowsAYesOrNoRuleInWords) {
  TrainingCentre centre(untwistings());
  centre.untwist("first", "practice", 1);
  Station station(centre);

  station.open(PageId::kNextStep);
  const QString all = station.allText();

  EXPECT_TRUE(all.contains(QStringLiteral("Untwisted: yes"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Relapse: no"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Last time: not untwisted, ischaemic dose"))) << all.toStdString();
  EXPECT_FALSE(all.contains(QStringLiteral("Twists on target"))) << all.toStdString();
}

}  // namespace
}  // namespace torsio::gui
