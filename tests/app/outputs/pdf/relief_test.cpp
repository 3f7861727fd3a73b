// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies drawn for a report.
#include "app/outputs/charts/relief.h"

#include <memory>

#include <gtest/gtest.h>

namespace torsio {
namespace {

/// Two squares, seen from the front: a large one, and behind its left half a smaller one.
ReportRelief squares() {
  ReportRelief relief;
  relief.triangles = std::make_shared<const std::vector<std::array<std::uint32_t, 3>>>(
      std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  relief.places = {{0, 0, 0},  {4, 0, 0},  {4, 4, 0},  {0, 4, 0},
                   {1, 1, -1}, {2, 1, -1}, {2, 2, -1}, {1, 2, -1}};
  return relief;
}

TEST(Relief, FillsTheBodyAndLeavesTheGround) {
  const DrawnRelief drawn = drawRelief(squares(), QRectF(-4.0, -4.0, 12.0, 12.0), 120);

  ASSERT_EQ(drawn.image.size(), QSize(120, 120));
  EXPECT_EQ(drawn.image.pixelColor(5, 5), QColor(Qt::white));
  const QColor inside = drawn.image.pixelColor(60, 60);
  EXPECT_NE(inside, QColor(Qt::white));
  EXPECT_GT(inside.red(), inside.blue());
  EXPECT_EQ(drawn.image.pixelColor(45, 45), inside) << "flat";
}

TEST(Relief, HidesWhatLiesBehind) {
  ReportRelief relief = squares();
  relief.marks = {{"1", {1.5F, 1.5F, -1.0F}}, {"2", {3.0F, 3.0F, 0.0F}}};
  relief.lines = {{{1.0F, 1.5F, -1.0F}, {2.0F, 1.5F, -1.0F}}, {{0.5F, 3.0F, 0.0F}, {3.5F, 3.0F, 0.0F}}};

  const DrawnRelief drawn = drawRelief(relief, QRectF(-4.0, -4.0, 12.0, 12.0), 120);

  EXPECT_EQ(drawn.seen, (std::vector<bool>{false, true}));
  EXPECT_EQ(drawn.marks[1], QPointF(70.0, 50.0));
  const QColor inside = drawn.image.pixelColor(60, 60);
  EXPECT_EQ(drawn.image.pixelColor(55, 65), inside) << "the line behind it";
  EXPECT_NE(drawn.image.pixelColor(60, 50), inside) << "the line on it";
}

TEST(Relief, KeepsAllBodiesInItsBox) {
  ReportRelief other = squares();
  other.places[0] = {-3, 0, 0};
  const QRectF box = reliefBox({squares(), other});
  EXPECT_LT(box.left(), -3.0);
  EXPECT_GT(box.right(), 4.0);
  EXPECT_GT(box.bottom(), 4.0);
}

}  // namespace
}  // namespace torsio
