// SPDX-License-Identifier: GPL-3.0-or-later
// What the lattice refuses, and that it says why.
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TriangleMesh bar() {
  return testing::prism(testing::circleOutline(0.03, 24), 0.2, 10);
}

Error refusal(const TriangleMesh& mesh, const LatticeOptions& options) {
  return testing::refusal([&] { const SectionLattice lattice(mesh, options); });
}

TEST(LatticeInput, RefusesTwoRidgesBecauseTheyBoundNoArea) {
  LatticeOptions options{.ridges = 2};

  const Error error = refusal(bar(), options);

  EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
  EXPECT_THAT(error.what(), HasSubstr("2 ridges"));
  EXPECT_THAT(error.what(), HasSubstr("3 to 360"));
  EXPECT_THAT(error.what(), HasSubstr("cannot bound an area"));
}

TEST(LatticeInput, RefusesCountsOutOfRange) {
  for (const int ridges : {-1, 0, 361}) {
    LatticeOptions options{.ridges = ridges};
    const Error error = refusal(bar(), options);
    EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
    EXPECT_THAT(error.what(), HasSubstr(std::to_string(ridges) + " ridges"));
  }
  for (const int sections : {-1, 1, 361}) {
    LatticeOptions options{.sections = sections};
    const Error error = refusal(bar(), options);
    EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
    EXPECT_THAT(error.what(), HasSubstr(std::to_string(sections) + " sections"));
    EXPECT_THAT(error.what(), HasSubstr("2 to 360"));
  }
}

TEST(LatticeInput, RefusesNumbersThatAreNotFinite) {
  const auto change = std::vector<std::function<void(LatticeOptions&)>>{
      [](LatticeOptions& o) { o.fixedEnd_m.x = kNaN; },
      [](LatticeOptions& o) { o.freeEnd_m.z = std::numeric_limits<double>::infinity(); },
      [](LatticeOptions& o) {
        o.freeCut = {0, 0, kNaN};
      },
      [](LatticeOptions& o) {
        o.ridgeZero = {kNaN, 0, 0};
      },
      [](LatticeOptions& o) { o.ridgeZeroFraction = kNaN; },
      [](LatticeOptions& o) { o.ridgeZeroFraction = 1.5; },
      [](LatticeOptions& o) { o.capRadius_m = kNaN; },
      [](LatticeOptions& o) { o.capRadius_m = -0.01; }};
  for (std::size_t i = 0; i < change.size(); ++i) {
    LatticeOptions options;
    change[i](options);
    EXPECT_EQ(refusal(bar(), options).code(), ErrorCode::kBadParameter) << i;
  }
}

TEST(LatticeInput, RefusesAMeshThatIsNotClosedOrNotFinite) {
  TriangleMesh open = bar();
  open.triangles.pop_back();
  EXPECT_EQ(refusal(open, {}).code(), ErrorCode::kBadMesh);
  EXPECT_THAT(refusal(open, {}).what(), HasSubstr("open"));

  TriangleMesh broken = bar();
  broken.vertices_m[7].y = kNaN;
  EXPECT_EQ(refusal(broken, {}).code(), ErrorCode::kBadMesh);
  EXPECT_THAT(refusal(broken, {}).what(), HasSubstr("vertex 7"));

  TriangleMesh dangling = bar();
  dangling.triangles[3][1] = 100000;
  EXPECT_EQ(refusal(dangling, {}).code(), ErrorCode::kBadMesh);

  EXPECT_EQ(refusal(TriangleMesh{}, {}).code(), ErrorCode::kBadMesh);
}

TEST(LatticeInput, NamesTheFirstPlaneThatCutsTwoLoopsAndTheWayOut) {
  LatticeOptions options{.mode = LatticeMode::kStraightAxis};

  const Error error = refusal(testing::jTube(0.02, 0.12, 0.04, 32, 60), options);

  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_THAT(error.what(), HasSubstr("section "));
  EXPECT_THAT(error.what(), HasSubstr(" of 25"));
  EXPECT_THAT(error.what(), HasSubstr("2 loops, exactly one is needed"));
  EXPECT_THAT(error.what(), HasSubstr("harmonic mode"));
}

TEST(LatticeInput, NamesAKinkWithItsTurnAndItsLimit) {
  constexpr double kTurn_rad = 2.6;  // 149 degrees

  const Error error = refusal(testing::kinkedTube(0.02, 0.1, kTurn_rad, 48, 40), {});

  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_THAT(error.what(), HasSubstr("kink"));
  EXPECT_THAT(error.what(), HasSubstr("degrees within one radius"));
  EXPECT_THAT(error.what(), HasSubstr("at most 90 degrees"));
}

TEST(LatticeInput, TakesABendThatIsNoKink) {
  const SectionLattice lattice(testing::kinkedTube(0.02, 0.1, 1.2, 48, 40), {});

  EXPECT_GT(lattice.length_m(), 0.17);
  EXPECT_LT(lattice.length_m(), 0.2);
}

TEST(LatticeInput, RefusesCapsThatTouch) {
  LatticeOptions options{.fixedEnd_m = {0, 0, -0.03}, .freeEnd_m = {0, 0, 0.18}, .capRadius_m = 0.2};

  const Error error = refusal(testing::capsule(0.03, 0.15, 24, 40), options);

  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_THAT(error.what(), HasSubstr("caps of the organ touch"));
}

TEST(LatticeInput, RefusesACutBeyondTheOrgan) {
  LatticeOptions options{.freeEnd_m = {0, 0, 0.5}, .freeCut = {0, 0, 1}};

  const Error error = refusal(bar(), options);

  EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
  EXPECT_THAT(error.what(), HasSubstr("free end"));
  EXPECT_THAT(error.what(), HasSubstr("nothing of the organ lies beyond"));
}

TEST(LatticeInput, RefusesACutWithoutEndPoints) {
  LatticeOptions options{.freeCut = {0, 0, 1}};

  EXPECT_EQ(refusal(bar(), options).code(), ErrorCode::kBadParameter);
}

TEST(LatticeInput, RefusesABallAlongItsPrincipalAxis) {
  LatticeOptions options{.mode = LatticeMode::kStraightAxis};

  const Error error = refusal(testing::capsule(0.05, 0.001, 32, 40), options);

  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_THAT(error.what(), HasSubstr("no longest direction"));
}

TEST(LatticeInput, RefusesPlanesOutsideTheOrgan) {
  LatticeOptions options{
      .mode = LatticeMode::kStraightAxis, .fixedEnd_m = {0, 0, 0.5}, .freeEnd_m = {0, 0, 0.7}};

  EXPECT_THAT(refusal(bar(), options).what(), Not(HasSubstr("nothing was refused")));
}

TEST(LatticeInput, RefusesAskingBeyondItsLattice) {
  const SectionLattice lattice(bar(), {});

  EXPECT_THROW(static_cast<void>(lattice.keyPoint_m(36, 0)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.sectionArc_m(-1)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.outline_m(25)), ContractError);
  EXPECT_THROW(static_cast<void>(lattice.surfacePoint({kNaN, 0.0})), ContractError);
}

}  // namespace
}  // namespace torsio
