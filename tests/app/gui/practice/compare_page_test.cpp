// SPDX-License-Identifier: GPL-3.0-or-later
// Two tissue models side by side, with the shipped stomach.
#include "app/gui/practice/compare_page.h"

#include <cmath>

#include <QLabel>
#include <QRegularExpression>
#include <gtest/gtest.h>

#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

/// Returns the numbers behind `word` on the page, the left model's first.
std::vector<double> numbersOf(const ComparePage& page, const QString& word) {
  const QRegularExpression line(QStringLiteral("^%1\\s+(-?[0-9.,]+)").arg(word));
  std::vector<double> numbers;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    if (const auto found = line.match(label->text()); found.hasMatch()) {
      numbers.push_back(QLocale(QLocale::C).toDouble(found.captured(1)));
    }
  }
  return numbers;
}

TEST(ComparePage, AnswersOneTorqueWithTwoModelsAndTheirTimes) {
  testing::AdministratorDesk office;
  auto page = office.open<ComparePage>("trainee");
  ASSERT_TRUE(page->loaded());

  page->setTorque(0.02);
  const std::vector<double> small_deg = numbersOf(*page, QStringLiteral("Angle"));
  page->setTorque(0.04);
  const std::vector<double> large_deg = numbersOf(*page, QStringLiteral("Angle"));

  ASSERT_EQ(small_deg.size(), 2U);
  ASSERT_EQ(large_deg.size(), 2U);
  constexpr double kShown_deg = 0.15;  // one decimal is displayed, and twice the small value is compared
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_GT(std::abs(small_deg[side]), 1.0);
    EXPECT_NEAR(large_deg[side], 2.0 * small_deg[side], kShown_deg);  // both models are linear in the torque
  }
  EXPECT_GT(std::abs(large_deg[0] - large_deg[1]), 0.1 * std::abs(large_deg[1]));  // two models, two answers
  const std::vector<double> shear_kPa = numbersOf(*page, QStringLiteral("Largest shear"));
  ASSERT_EQ(shear_kPa.size(), 2U);
  EXPECT_GT(shear_kPa[0], 0.0);
  EXPECT_GT(shear_kPa[1], 0.0);
  const std::vector<double> time_us = numbersOf(*page, QStringLiteral("Computed in"));
  ASSERT_EQ(time_us.size(), 2U);
  EXPECT_GT(time_us[0], 0.0);
  EXPECT_GT(time_us[1], 0.0);
}

}  // namespace
}  // namespace torsio::gui
