// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/scene/shear_map.h"
#include "sim/scene/blood_map.h"
#include "sim/tissue/twist/twist_model_tables.h"
#include "tests/sim/servo/hollow_bar.h"

namespace torsio::gui {
namespace {

using Factors = std::vector<std::array<float, 3>>;

std::shared_ptr<const Scene> twistedScene() {
  static const auto kScene = std::make_shared<const Scene>(hollowScene(twistedTube()));
  return kScene;
}

Factors factorsOf(const OrganState& state) {
  Factors factors(twistedScene()->mesh.vertices_m.size());
  BloodMap(twistedScene()).evaluate(state, factors);
  return factors;
}

// Returns the vertex whose arc length is nearest to a fraction of the length.
std::size_t vertexAt(double share) {
  const auto& vertices = twistedScene()->model.tables().vertices;
  std::size_t best = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto miss = [&](std::size_t i) {
      return std::abs(vertices[i].arc_m - share * twistedScene()->lattice().length_m());
    };
    best = miss(v) < miss(best) ? v : best;
  }
  return best;
}

TEST(BloodMap, DoesNotChangeAnOrganThatIsNotHollow) {
  EXPECT_TRUE(BloodMap(std::make_shared<const Scene>(barScene())).empty());
}

TEST(BloodMap, HealthyTissueKeepsItsColour) {
  OrganState state = twistedScene()->stateAt(0.0);
  state.hollow.saturation = 0.78;

  for (const auto& factor : factorsOf(state)) {
    for (const float channel : factor) {
      EXPECT_NEAR(channel, 1.0F, 1e-3F);
    }
  }
}

TEST(BloodMap, CongestedBloodIsPurpleOnlyBeyondTheHeldSection) {
  OrganState state = twistedScene()->stateAt(0.0);
  state.hollow.congestion = 1.0;
  state.hollow.reading.flow = 0.3;

  const Factors factors = factorsOf(state);

  const auto& twisted = factors[vertexAt(0.9)];
  EXPECT_LT(twisted[1], 0.6F * twisted[0] + 0.1F);
  EXPECT_LT(twisted[1], twisted[2]);
  EXPECT_EQ(factors[vertexAt(0.0)], (std::array<float, 3>{1.0F, 1.0F, 1.0F}));
}

TEST(BloodMap, AMarkIsDarkOnlyWhereTheJawWas) {
  const std::size_t there = vertexAt(0.5);
  const auto& vertex = twistedScene()->model.tables().vertices[there];
  OrganState state = twistedScene()->stateAt(0.0);
  const Factors before = factorsOf(state);
  state.hollow.markCount = 1;
  state.hollow.marks[0].arc_m = vertex.arc_m;
  state.hollow.marks[0].round_rad = twistedScene()->lattice().vertexCoordinates()[there].angle_rad;

  const Factors after = factorsOf(state);

  EXPECT_LT(after[there][1], 0.5F * before[there][1]);
  EXPECT_EQ(after[vertexAt(0.9)], before[vertexAt(0.9)]);
}

TEST(BloodMap, AClipIsVisibleWhereItHolds) {
  OrganState state = twistedScene()->stateAt(0.0);
  const Factors open = factorsOf(state);
  state.hollow.clipped = true;

  EXPECT_NE(factorsOf(state), open);
}

TEST(ShearMap, OfATwistedOrganEndsAtTheLargestShearOnTheWay) {
  const ShearMap map(twistedScene());

  EXPECT_GT(map.top_Pa(), twistedScene()->peakShear_Pa(twistedScene()->stateAt(radians(45.0))));
  EXPECT_LT(map.top_Pa(), 1e5);
}

}  // namespace
}  // namespace torsio::gui
