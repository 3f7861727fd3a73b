// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/tissue/section/polygon.h"
#include "sim/tissue/section/section_solver.h"
#include "tests/sim/tissue/section_shapes.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

using testing::refusal;

Error refusalOf(const shapes::Outline& outline, const std::vector<shapes::Outline>& holes = {}) {
  const Error error = refusal([&] { static_cast<void>(solveSection(outline, {}, holes)); });
  EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
  EXPECT_FALSE(error.remedy().empty());
  return error;
}

TEST(SectionInput, RefusesFewerThanThreePoints) {
  const Error error = refusalOf({{0, 0}, {1, 0}});

  EXPECT_THAT(error.happened(), HasSubstr("at least 3 points, this one has 2"));
  EXPECT_EQ(error.where(), "outline");
}

TEST(SectionInput, RefusesNumbersThatAreNotFiniteAndNamesThePoint) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Error error = refusalOf({{0, 0}, {1, 0}, {1, bad}, {0, 1}});

    EXPECT_THAT(error.happened(), HasSubstr("not a finite number"));
    EXPECT_EQ(error.where(), "outline, point 3");
  }
}

TEST(SectionInput, NamesTheEdgesThatCross) {
  const Error bowTie = refusalOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_THAT(bowTie.happened(), HasSubstr("edge 1 (points 1 and 2) and edge 3 (points 3 and 4)"));

  // The edge that closes the outline runs from the last point to the first.
  const Error closing = refusalOf({{0, 0}, {2, 0}, {2, 2}, {1, -1}, {0, 2}, {3, 1}});
  EXPECT_THAT(closing.happened(), HasSubstr("crosses or touches itself"));

  const Error back = refusalOf({{0, 0}, {2, 0}, {1, 0}, {1, 1}});
  EXPECT_THAT(back.happened(), HasSubstr("edge 1 (points 1 and 2) and edge 2 (points 2 and 3)"));

  const Error touching = refusalOf({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}});
  EXPECT_THAT(touching.happened(), HasSubstr("crosses or touches itself"));
}

TEST(SectionInput, RefusesSectionsWithoutArea) {
  EXPECT_THAT(refusalOf({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).happened(), HasSubstr("no area"));
  EXPECT_THAT(refusalOf({{1, 1}, {1, 1}, {1, 1}}).happened(), HasSubstr("no area"));
  EXPECT_THAT(refusalOf(shapes::rectangle(1.0, 1e-7)).happened(), HasSubstr("too thin"));
}

TEST(SectionInput, RefusesHolesThatAreNotInside) {
  const shapes::Outline square = shapes::rectangle(2, 2);
  EXPECT_THAT(refusalOf(square, {shapes::circle(16, 0.5, {0.8, 0})}).happened(),
              HasSubstr("crosses or touches the outline"));
  EXPECT_THAT(refusalOf(square, {shapes::circle(16, 0.5, {3, 0})}).happened(),
              HasSubstr("outside the outline"));
  const Error overlap = refusalOf(square, {shapes::circle(16, 0.5), shapes::circle(16, 0.2, {0.4, 0})});
  EXPECT_THAT(overlap.happened(), HasSubstr("hole 1 and hole 2"));
  const Error inside = refusalOf(square, {shapes::circle(16, 0.5), shapes::circle(16, 0.2)});
  EXPECT_THAT(inside.happened(), HasSubstr("hole 1 and hole 2"));
  EXPECT_EQ(refusalOf(square, {{{0, 0}, {0.1, 0}}}).where(), "hole 1");
}

TEST(SectionInput, RefusesOptionsOutOfRange) {
  const auto with = [](const SectionSolverOptions& options) {
    return refusal([&] { const SectionSolver solver(options); }).happened();
  };
  EXPECT_THAT(with({.outlinePoints = 2}), HasSubstr("outlinePoints"));
  EXPECT_THAT(with({.rings = 0}), HasSubstr("rings"));
  EXPECT_THAT(with({.bracket = std::numeric_limits<double>::quiet_NaN()}), HasSubstr("bracket"));
  EXPECT_THAT(with({.maxNodes = 0}), HasSubstr("maxNodes"));
}

class OutlineFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Error refusalOfText(const std::string& text) const {
    write(text);
    return refusal([this] { static_cast<void>(readOutline(file_)); });
  }

  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                (std::string("torsio_outline_") +
                                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

TEST_F(OutlineFile, ReadsPointsCommentsHeaderAndClosedOutlines) {
  const std::vector<Point2> points = readOutline(
      write("\xEF\xBB\xBF# made by hand\r\nx,y\r\n0,0\r\n 1.5 , -2e-1\r\n\r\n# half way\n+3;4\n0,0\n"));

  EXPECT_EQ(points, (std::vector<Point2>{{0, 0}, {1.5, -0.2}, {3, 4}}));
}

TEST_F(OutlineFile, NamesTheLineThatIsWrong) {
  const Error text = refusalOfText("0,0\n1,zero\n1,1\n");
  EXPECT_EQ(text.code(), ErrorCode::kBadData);
  EXPECT_THAT(text.happened(), HasSubstr("'zero' is not a number"));
  EXPECT_THAT(text.where(), HasSubstr("line 2"));

  EXPECT_THAT(refusalOfText("x,y\n0,0\n1,0,0\n").where(), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfText("0,0\n1\n").happened(), HasSubstr("expected 2 values, found 1"));
  EXPECT_THAT(refusalOfText("0,0\nnan,1\n").happened(), HasSubstr("not a finite number"));
  EXPECT_THAT(refusalOfText("0,0\n1e999,1\n").happened(), HasSubstr("not a number"));
  // Only one line of names, and only before the points.
  EXPECT_THAT(refusalOfText("x,y\nmm,mm\n0,0\n").where(), HasSubstr("line 2"));
  EXPECT_THAT(refusalOfText("0,0\nx,y\n").where(), HasSubstr("line 2"));
}

TEST_F(OutlineFile, RefusesFilesWithoutASection) {
  EXPECT_THAT(refusalOfText("").happened(), HasSubstr("this file has 0"));
  EXPECT_THAT(refusalOfText("0,0\n1,0\n0,0\n").happened(), HasSubstr("this file has 2"));
  std::filesystem::remove(file_);
  EXPECT_EQ(refusal([this] { static_cast<void>(readOutline(file_)); }).code(), ErrorCode::kFileMissing);
  EXPECT_EQ(refusal([] { static_cast<void>(readOutline(std::filesystem::temp_directory_path())); }).code(),
            ErrorCode::kFileUnreadable);
}

}  // namespace
}  // namespace torsio
