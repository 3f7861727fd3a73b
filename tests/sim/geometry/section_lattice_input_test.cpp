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
  testing::expectError(refusal(bar(), LatticeOptions{.ridges = 2}), ErrorCode::kBadParameter,
                       {"2 ridges", "3 to 360", "cannot bound an area"});
}

TEST(LatticeInput, RefusesCountsOutOfRange) {
  for (const int ridges : {-1, 0, 361}) {
    testing::expectError(refusal(bar(), LatticeOptions{.ridges = ridges}), ErrorCode::kBadParameter,
                         {std::to_string(ridges) + " ridges"});
  }
  for (const int sections : {-1, 1, 361}) {
    testing::expectError(refusal(bar(), LatticeOptions{.sections = sections}), ErrorCode::kBadParameter,
                         {std::to_string(sections) + " sections", "2 to 360"});
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

  testing::expectError(refusal(testing::jTube(0.02, 0.12, 0.04, 32, 60), options), ErrorCode::kBadMesh,
                       {"section ", " of 25", "2 loops, exactly one is needed", "harmonic mode"});
}

TEST(LatticeInput, NamesAKinkWithItsTurnAndItsLimit) {
  constexpr double kTurn_rad = 2.6;  // 149 degrees

  testing::expectError(refusal(testing::kinkedTube(0.02, 0.1, kTurn_rad, 48, 40), {}), ErrorCode::kBadMesh,
                       {"kink", "degrees within one radius", "at most 90 degrees"});
}

TEST(LatticeInput, TakesABendThatIsNoKink) {
  const SectionLattice lattice(testing::kinkedTube(0.02, 0.1, 1.2, 48, 40), {});

  EXPECT_GT(lattice.length_m(), 0.17);
  EXPECT_LT(lattice.length_m(), 0.2);
}

TEST(LatticeInput, RefusesCapsThatTouch) {
  LatticeOptions options{.fixedEnd_m = {0, 0, -0.03}, .freeEnd_m = {0, 0, 0.18}, .capRadius_m = 0.2};

  testing::expectError(refusal(testing::capsule(0.03, 0.15, 24, 40), options), ErrorCode::kBadMesh,
                       {"caps of the organ touch"});
}

TEST(LatticeInput, RefusesACutBeyondTheOrgan) {
  testing::expectError(refusal(bar(), LatticeOptions{.freeEnd_m = {0, 0, 0.5}, .freeCut = {0, 0, 1}}),
                       ErrorCode::kBadParameter, {"free end", "nothing of the organ lies beyond"});
}

TEST(LatticeInput, RefusesACutWithoutEndPoints) {
  EXPECT_EQ(refusal(bar(), LatticeOptions{.freeCut = {0, 0, 1}}).code(), ErrorCode::kBadParameter);
}

TEST(LatticeInput, RefusesABallAlongItsPrincipalAxis) {
  LatticeOptions options{.mode = LatticeMode::kStraightAxis};

  testing::expectError(refusal(testing::capsule(0.05, 0.001, 32, 40), options), ErrorCode::kBadMesh,
                       {"no longest direction"});
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
