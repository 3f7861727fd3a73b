// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/catalogue/quantity.h"

#include <set>

#include <gtest/gtest.h>

#include "sim/core/angle.h"

namespace torsio {
namespace {

TEST(QuantityCatalogue, IdsAndNamesAreUniqueAndFound) {
  std::set<std::string_view> ids;
  std::set<std::string_view> names;
  for (const QuantityRow& row : quantityRows()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_TRUE(names.insert(row.name.english()).second) << row.name.english();
    EXPECT_EQ(quantityOf(row.id), row.quantity);
    EXPECT_EQ(&rowOf(row.quantity), &row);
  }
  EXPECT_FALSE(quantityOf("twist.of_another_version").has_value());
  EXPECT_FALSE(quantityOf("").has_value());
}

TEST(QuantityCatalogue, ScalesConvertTheStoredUnitToTheShownOne) {
  for (const QuantityRow& row : quantityRows()) {
    const bool angle = row.unit == "rad";
    EXPECT_EQ(angle, row.shown.unit == "\u00b0") << row.id;
    EXPECT_EQ(angle, row.shown.scale == kDegreesPerRadian) << row.id;
    if (row.shown.unit == row.unit || row.shown.unit.empty()) {
      EXPECT_EQ(row.shown.scale, 1.0) << row.id;
    }
    if (row.traits.kind != QuantityKind::kMeasure) {
      EXPECT_EQ(row.shown.decimals, 0) << row.id;
    }
  }
}

TEST(QuantityCatalogue, AskedForQuantitiesHaveADirection) {
  for (const QuantityRow& row : quantityRows()) {
    EXPECT_TRUE(!row.traits.asked || row.direction != Direction::kNeither) << row.id;
    EXPECT_TRUE(row.traits.merit.weight == 0.0 || !row.traits.advice.empty()) << row.id;
  }
}

TEST(QuantityCatalogue, ValuesAreShownInTheUnitOfTheWard) {
  EXPECT_EQ(shownValue(Quantity::kOvershoot, radians(3.14)).str(), "3.1\u00b0");
  EXPECT_EQ(shownValue(Quantity::kTime, 12.44).str(), "12.4 s");
  EXPECT_EQ(shownValue(Quantity::kOnTarget, 0.625).str(), "62 %");
  EXPECT_EQ(shownValue(Quantity::kSparc, -1.6).str(), "\u22121.60");
  EXPECT_EQ(shownValue(Quantity::kPeakJaw, 123'400.0).str(), "123 kPa");
  EXPECT_EQ(shownValue(Quantity::kUntwisted, 1.0).str(), "yes");
  EXPECT_EQ(shownValue(Quantity::kResidual, radians(42.0)).str(), "42\u00b0");
  EXPECT_EQ(shownValue(Quantity::kTimeToFlow, std::nullopt).str(), "blood did not come back");
  EXPECT_EQ(shownValue(Quantity::kSettling, std::nullopt).str(), "not measured");
  EXPECT_EQ(shownNumber(Quantity::kPeakForce, 3.3049, 1), "3.305");
  EXPECT_EQ(titleWithUnit(Quantity::kPeakTorque).str(), "Peak torque (N m)");
  EXPECT_EQ(titleWithUnit(Quantity::kRegrips).str(), "Re-grips");
}

}  // namespace
}  // namespace torsio
