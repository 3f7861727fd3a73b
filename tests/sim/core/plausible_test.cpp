// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/plausible.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/file_io.h"

namespace torsio {
namespace {

constexpr std::array kAll = {Stated::kOrganSide, Stated::kInstrumentSide, Stated::kVoxelSide,
                             Stated::kHandReach, Stated::kHandSpeed,      Stated::kPosePeriod,
                             Stated::kMarkerWay, Stated::kScaleUsed,      Stated::kAge};

TEST(Plausible, EveryRowBelievesItsRangeAndNothingElse) {
  for (const Stated quantity : kAll) {
    const PlausibleRow& row = plausible(quantity);
    EXPECT_EQ(row.quantity, quantity);
    EXPECT_LT(row.least, row.most);
    EXPECT_TRUE(isPlausible(quantity, row.least));
    EXPECT_TRUE(isPlausible(quantity, row.most));
    EXPECT_FALSE(isPlausible(quantity, std::nextafter(row.most, 1e9)));
    EXPECT_FALSE(isPlausible(quantity, std::nextafter(row.least, -1e9)));
    EXPECT_FALSE(isPlausible(quantity, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(isPlausible(quantity, std::numeric_limits<double>::infinity()));
  }
}

TEST(Plausible, TheRightUnitIsAmongThoseThatFitAValueInAnother) {
  for (const Stated quantity : kAll) {
    const PlausibleRow& row = plausible(quantity);
    const double middle = row.least > 0.0 ? std::sqrt(row.least * row.most) : 0.5 * row.most;
    for (const StatedUnit& right : row.units) {
      for (const StatedUnit& wrong : row.units) {
        const StatedValue read{quantity, middle / right.si * wrong.si};
        const std::string fitting = unitsThatFit({&read, 1}, wrong.si).str();
        const bool named = fitting.find("\"" + std::string(right.word) + "\"") != std::string::npos;
        EXPECT_EQ(named, &right != &wrong) << right.word << " read as " << wrong.word << ": " << fitting;
      }
    }
  }
}

TEST(Plausible, AllValuesHaveToFit) {
  // 200 mm of reach that were read as metres, at a speed that fits them.
  const std::array hand{StatedValue{Stated::kHandReach, 200.0}, StatedValue{Stated::kHandSpeed, 50.0}};
  EXPECT_EQ(unitsThatFit(hand, 1.0).str(), "\"cm\", \"mm\"");
  const std::array faster{hand[0], StatedValue{Stated::kHandSpeed, 500.0}};
  EXPECT_EQ(unitsThatFit(faster, 1.0).str(), "\"mm\"");
  const std::array impossible{hand[0], StatedValue{Stated::kHandSpeed, 5e6}};
  EXPECT_TRUE(unitsThatFit(impossible, 1.0).empty());
  EXPECT_FALSE(unitThatFits(impossible, 1.0));
  EXPECT_TRUE(unitsThatFit(hand, 0.0).empty()) << "no unit was stated";
}

TEST(Plausible, RangesAreToldInTheUnitOfTheReader) {
  EXPECT_EQ(plausibleRange(Stated::kOrganSide).str(), "30 to 2000 mm");
  EXPECT_EQ(plausibleRange(Stated::kAge).str(), "14 to 100");
  EXPECT_EQ(inPlausibleUnit(Stated::kVoxelSide, 0.7), "700 mm");
  EXPECT_EQ(unitWords(Stated::kHandReach), "m, cm, mm");
  EXPECT_EQ(statedUnit(Stated::kPosePeriod, "us")->si, 1e-6);
  EXPECT_FALSE(statedUnit(Stated::kPosePeriod, "min"));
}

/// docs/exchange.md has a row with the range and the units of each quantity.
TEST(Plausible, TheGuideListsEveryRow) {
  const std::string guide = readFile(std::filesystem::path(TORSIO_SOURCE_DIR) / "docs" / "exchange.md");
  for (const Stated quantity : kAll) {
    const std::string row = "| " + plausibleRange(quantity).str() + " | " + unitWords(quantity);
    EXPECT_NE(guide.find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace torsio
