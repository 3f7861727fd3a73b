// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

// Decimals of forces and torques on every screen, in browsers (assets/web/numbers.js) and in reports. Axes
// use round steps; files keep full precision.

inline constexpr int kForceDecimals = 2;   ///< of N
inline constexpr int kTorqueDecimals = 3;  ///< of N m
/// Of N m, where models are compared under one torque, which is small.
inline constexpr int kModelTorqueDecimals = 5;

}  // namespace torsio
