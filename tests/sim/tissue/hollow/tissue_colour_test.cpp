// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/tissue_colour.h"

#include <gtest/gtest.h>

#include "sim/core/angle.h"

namespace torsio {
namespace {

TissueColour settledAt(double angle_deg) {
  PerfusionState state = Perfusion{PerfusionParameters{}}.after(radians(angle_deg), 0.0, 3600.0);
  state.dose = 0.0;
  return colourOf(state);
}

TEST(TissueColour, ASoundOrganIsPink) {
  EXPECT_EQ(colourOf(PerfusionState{}), kSerosaPink);
}

TEST(TissueColour, ATurnMakesItDarkerAndPurpler) {
  TissueColour before = settledAt(0.0);
  for (const double angle_deg : {180.0, 360.0, 540.0, 720.0}) {
    const TissueColour now = settledAt(angle_deg);

    EXPECT_LT(now.red + now.green + now.blue, before.red + before.green + before.blue) << angle_deg;
    EXPECT_GT(now.blue / now.red, before.blue / before.red) << angle_deg;
    before = now;
  }
}

// 270 degrees: flow 0.77, a quarter of the largest congestion. The vein shuts first: purple though fed.
TEST(TissueColour, ATurnThatHardlyStarvesIsPurpleAllTheSame) {
  const TissueColour dammed = settledAt(270.0);

  EXPECT_NEAR(purpleShare(0.25), 0.372, 1e-3);
  EXPECT_EQ(purpleShare(0.0), 0.0);
  EXPECT_EQ(purpleShare(1.0), kMaxPurple);
  EXPECT_LT(dammed.green, 0.70 * kSerosaPink.green);
  EXPECT_GT(dammed.blue, 1.10 * dammed.green);
}

TEST(TissueColour, AShutArteryLeavesItPaleNotPurple) {
  const TissueColour purple = settledAt(720.0);
  const TissueColour pale = settledAt(760.0);

  EXPECT_NEAR(pale.red, kSerosaPale.red, 1e-9);
  EXPECT_NEAR(pale.blue, kSerosaPale.blue, 1e-9);
  EXPECT_GT(pale.green, purple.green + 0.4);
}

TEST(TissueColour, ADoseBelowSevenTenthsDoesNotShowAndOneAndAFifthIsBlack) {
  EXPECT_EQ(colourOf({.dose = 0.7}), kSerosaPink);
  EXPECT_EQ(blackShare(0.95), 0.5);  // half-way of the smoothstep
  EXPECT_EQ(colourOf({.dose = 1.2}), kSerosaBlack);
  EXPECT_EQ(colourOf({.dose = 3.0}), kSerosaBlack);
}

}  // namespace
}  // namespace torsio
