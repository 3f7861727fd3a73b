// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/tissue/twist/twist_model_view.h"
#include "tests/sim/tissue/twist_bars.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

// Float rounding of coordinates up to 0.25 m and of angles up to a turn at 40 mm: 1e-6 of the radius and of
// the position together.
constexpr double kFloatError_m = 1.5e-7;

double worstAgainstDouble(const Bar& bar, const TwistState& state, Isa isa) {
  TwistView view(bar.model, isa);
  std::vector<float> xyz(3 * bar.mesh.vertices_m.size());
  std::vector<Vec3> expected(bar.mesh.vertices_m.size());
  view.update(state, xyz);
  bar.model.deform(state, expected);
  double worst = 0.0;
  for (std::size_t v = 0; v < expected.size(); ++v) {
    const Vec3 drawn{xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]};
    worst = std::max(worst, norm(drawn - expected[v]));
  }
  return worst;
}

struct Case {
  std::string name;
  Bar bar;
  bool fast;
};

/// Every kind of model on the same bent tube, built once.
const std::vector<Case>& everyKind() {
  struct Recipe {
    const char* name;
    TwistModelOptions options;
    bool fast;
  };
  const auto options = [](auto&& change) {
    TwistModelOptions o;
    change(o);
    return o;
  };
  std::vector<Recipe> recipes{
      {"plain", options([](auto&) {}), true},
      {"unwarped", options([](auto& o) { o.warping = false; }), true},
      {"both held", options([](auto& o) { o.ends = EndCondition::kBothHeld; }), true},
      {"foundation", options([](auto& o) { o.foundationLengths = 0.5; }), false},
      {"poynting", options([](auto& o) { o.poynting = true; }), false},
      {"shear centre", options([](auto& o) { o.centre = TwistCentre::kShearCentre; }), true},
      {"paper", options([](auto& o) { o.formulation = Formulation::kPaper; }), true},
      {"paper held",
       options([](auto& o) { o.formulation = Formulation::kPaper, o.ends = EndCondition::kBothHeld; }),
       false},
      {"paper components", options([](auto& o) {
         o.formulation = Formulation::kPaper, o.paperInterpolation = PaperInterpolation::kComponents;
       }),
       false}};
  static const std::vector<Case> cases = [&] {
    std::vector<Case> built;
    built.reserve(recipes.size());
    for (const Recipe& r : recipes) {
      built.push_back({r.name, bentBar(r.options), r.fast});
    }
    return built;
  }();
  return cases;
}

class TwistViewOf : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(EverySet, TwistViewOf, ::testing::ValuesIn(usableIsas().begin(), usableIsas().end()),
                         [](const ::testing::TestParamInfo<Isa>& set) {
                           return std::string(isaName(set.param));
                         });

TEST_P(TwistViewOf, EveryModelIsDrawnWhereTheDoublePathPutsIt) {
  for (const Case& c : everyKind()) {
    const Bar& bar = c.bar;
    EXPECT_EQ(TwistView(bar.model, GetParam()).fast(), c.fast) << c.name;
    for (const double degrees : {-90.0, 360.0}) {
      EXPECT_LT(worstAgainstDouble(bar, {0.6 * bar.length_m(), radians(degrees)}, GetParam()), kFloatError_m)
          << c.name << " " << degrees;
    }
  }
}

TEST_P(TwistViewOf, TheRadiusIsKeptToAMillionth) {
  const Bar bar = roundBar();
  TwistView view(bar.model, GetParam());
  std::vector<float> xyz(3 * bar.mesh.vertices_m.size());

  view.update({bar.length_m(), 2.0 * kPi}, xyz);

  for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); ++v) {
    EXPECT_NEAR(std::hypot(xyz[3 * v], xyz[3 * v + 1]), axisDistance(bar.mesh.vertices_m[v]),
                1e-6 * kBarRadius_m);
  }
}

TEST_P(TwistViewOf, ZeroAngleGivesTheRestPositionsBitwise) {
  const Bar bar = bentBar();
  TwistView view(bar.model, GetParam());
  std::vector<float> xyz(3 * bar.mesh.vertices_m.size());

  view.update({0.1, 0.0}, xyz);

  for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); ++v) {
    EXPECT_EQ(xyz[3 * v], static_cast<float>(bar.mesh.vertices_m[v].x));
    EXPECT_EQ(xyz[3 * v + 1], static_cast<float>(bar.mesh.vertices_m[v].y));
    EXPECT_EQ(xyz[3 * v + 2], static_cast<float>(bar.mesh.vertices_m[v].z));
  }
}

TEST_P(TwistViewOf, AFrameAllocatesNothingAndRespectsTheStride) {
  const Bar bar = bentBar();
  TwistView view(bar.model, GetParam());
  std::vector<float> wide(6 * bar.mesh.vertices_m.size(), -1.0F);
  std::vector<float> narrow(3 * bar.mesh.vertices_m.size());
  const TwistState state{0.5 * bar.length_m(), 1.0};

  const std::int64_t before = testing::allocationCount();
  view.update(state, wide, 6);
  view.update(state, narrow);
  const std::int64_t after = testing::allocationCount();

  EXPECT_EQ(after, before);
  for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(wide[6 * v + i], narrow[3 * v + i]);
      ASSERT_EQ(wide[6 * v + 3 + i], -1.0F);
    }
  }
}

// Test H.7: kriging in every frame and kriging once give the same picture.
TEST_P(TwistViewOf, LiveKrigingAndPrecomputedKrigingAgreeToAMillionthOfTheRadius) {
  TwistModelOptions options{.warping = false};
  const Bar bar = roundBar(options, 0.6);
  const SectionLattice& lattice = bar.model.lattice();
  std::vector<double> arcs;
  std::vector<double> angles;  // at the sections, for one radian at the free end
  const TwistState unit{bar.length_m(), 1.0};
  constexpr int kSamples =
      321;  // the looked-up angle is an integral: the samples must be close to say as much
  for (int j = 0; j < kSamples; ++j) {
    arcs.push_back(std::min(bar.length_m(), bar.length_m() * j / (kSamples - 1)));
    angles.push_back(bar.model.angleAt(arcs.back(), unit));
  }
  const Kriging1d live(arcs, bar.model.options().kriging);
  TwistView view(bar.model, GetParam());
  std::vector<float> xyz(3 * bar.mesh.vertices_m.size());

  view.update({bar.length_m(), kPi}, xyz);

  double worst = 0.0;
  for (std::size_t v = 0; v < bar.mesh.vertices_m.size(); ++v) {
    const Vec3& p = bar.mesh.vertices_m[v];
    const AxisFrame frame = lattice.frameAt(lattice.vertexCoordinates()[v].arc_m);
    const double angle = kPi * live.estimate(lattice.vertexCoordinates()[v].arc_m, angles);
    const Vec3 expected = frame.centre_m + rotateAbout(p - frame.centre_m, frame.tangent, angle);
    const Vec3 drawn{xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]};
    worst = std::max(worst, norm(drawn - expected));
  }
  EXPECT_LT(worst, 1e-6 * kBarRadius_m);
}

}  // namespace
}  // namespace torsio
