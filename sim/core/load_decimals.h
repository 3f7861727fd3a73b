// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

// The one home of how finely people are told a load: on every screen, in a browser (assets/web/numbers.js)
// and in reports. Axes take round steps; files keep what was measured.

inline constexpr int kForceDecimals = 2;   ///< of N
inline constexpr int kTorqueDecimals = 3;  ///< of N m
/// Of N m, where models are set against each other under one torque: that of an organ at rest in a hand.
inline constexpr int kModelTorqueDecimals = 5;

}  // namespace torsio
