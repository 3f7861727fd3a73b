// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/perfusion.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

// Of the way from artery to vein .6 of the resistance lies before the capillaries; .3 in them, .1 behind:
// assumed.
constexpr double kArteryShare = 0.6;
// By which the pressure in the capillaries rises where the veins are shut and the artery just still feeds
// them.
constexpr double kCongested_mmHg = 48.0;
// Saturation of rabbit testes: 36 % after 720 degrees, 78 % untwisted (Hallacoglu 2009); a flow of .06 is
// that of rat testes after 720 degrees.
constexpr double kTwistedSaturation = 0.36;
constexpr double kSoundSaturation = 0.78;
constexpr double kTwistedFlow = 0.06;
constexpr double kRecoveryTimes = 2.0;  // tau_r / tau_i: assumed

/// e^-x for x >= 0 of + - * / alone; absolute error below 5e-4 everywhere, below 1e-12 for x < 0.01.
double decay(double x) noexcept {
  const double y = 0.25 * x;
  const double root = 1.0 / (1.0 + y * (1.0 + y * (0.5 + y * (1.0 / 6.0 + y * (1.0 / 24.0)))));
  const double square = root * root;
  return square * square;
}

double saturationOf(double flow) noexcept {
  const double share = std::min(1.0, (flow - kTwistedFlow) / (1.0 - kTwistedFlow));
  return kTwistedSaturation + (kSoundSaturation - kTwistedSaturation) * share;
}

/// Dose that a flow collects in a second; 0 of one that is enough.
double doseRate(const PerfusionParameters& vessels, double flow) noexcept {
  return std::max(0.0, (vessels.enoughFlow - flow) / vessels.enoughFlow) / vessels.lossTime_s;
}

void checkRange(const char* name, double value, double least, double most) {
  if (!(value >= least && value <= most)) {
    refuseParameter(Text::verbatim("%1 is %2, but must lie between %3 and %4", name, std::to_string(value),
                                   std::to_string(least), std::to_string(most)),
                    Text::verbatim("pedicle"), Text::verbatim("Correct the number in the scene file."));
  }
}

void checkVessels(const PerfusionParameters& p) {
  checkRange("the arterial pressure in mmHg", p.arterial_mmHg, 1.0, 300.0);
  checkRange("the venous pressure in mmHg", p.venous_mmHg, 0.0, 0.9 * p.arterial_mmHg);
  checkRange("the shutting pressure of vessels turned once, in mmHg", p.shutAtTurn_mmHg, 1.0, 300.0);
  checkRange("the power of the angle", p.shutPower, 1.0, 4.0);
  checkRange("the length of the pedicle in m", p.pedicle_m, 1e-3, 1.0);
  checkRange("the reference length of the pedicle in m", p.pedicleReference_m, 1e-3, 1.0);
  checkRange("the pedicle's share of the angle", p.pedicleShare, 0.0, 1.0);
  checkRange("the lumen pressure that shuts nothing yet, in mmHg", p.lumenThreshold_mmHg, 0.0, 300.0);
  checkRange("the least flow under pressure in the lumen", p.lumenFloor, 0.0, 1.0);
  checkRange("the time of the flow in s", p.flowTime_s, 1e-3, 1e6);
  checkRange("the time to loss in s", p.lossTime_s, 1.0, 1e7);
  checkRange("the flow that is enough", p.enoughFlow, 0.01, 0.99);
}

}  // namespace

Perfusion::Perfusion(const PerfusionParameters& parameters) : parameters_(parameters) {
  checkVessels(parameters_);
  const double k = parameters_.shutPower;
  // x: turns of the pedicle, as if it had the reference length. P_c = P_1 x^k reaches the arterial pressure
  // at:
  const double shut = portableExp(portableLog(parameters_.arterial_mmHg / parameters_.shutAtTurn_mmHg) / k);
  const double turnsPerRadian =
      parameters_.pedicleShare * parameters_.pedicleReference_m / (parameters_.pedicle_m * kTurn);
  cellsPerRadian_ = static_cast<double>(kCells) * turnsPerRadian / shut;
  for (std::size_t i = 1; i <= kCells; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kCells);
    const double value = parameters_.shutAtTurn_mmHg * portableExp(k * portableLog(shut * share));
    pressure_mmHg_[i] = value;
    slope_mmHg_[i] = k * value / static_cast<double>(i);  // d/di of (i / kCells)^k
  }
  pressure_mmHg_[kCells] = parameters_.arterial_mmHg;
  slope_mmHg_[0] = k == 1.0 ? slope_mmHg_[1] : 0.0;
}

double Perfusion::shutPressure_mmHg(double angle_rad) const noexcept {
  const double place = std::abs(angle_rad) * cellsPerRadian_;
  if (!(place < static_cast<double>(kCells))) {
    return pressure_mmHg_[kCells];
  }
  const auto cell = static_cast<std::size_t>(place);
  const double u = place - static_cast<double>(cell);
  const double v = 1.0 - u;
  return pressure_mmHg_[cell] * v * v * (1.0 + 2.0 * u) + pressure_mmHg_[cell + 1] * u * u * (1.0 + 2.0 * v) +
         (slope_mmHg_[cell] * v - slope_mmHg_[cell + 1] * u) * u * v;
}

Perfusion::Settled Perfusion::settled(double angle_rad, double lumenPressure_mmHg) const noexcept {
  const double artery = parameters_.arterial_mmHg;
  const double vein = parameters_.venous_mmHg;
  const double shut = shutPressure_mmHg(angle_rad);
  if (shut >= artery) {
    return {0.0, 0.0};  // nothing flows in either: pale
  }
  const double span = artery - vein;
  const double twisted = (artery - std::max(vein, shut)) / span;
  const double pressed =
      (artery - std::max(vein, lumenPressure_mmHg - parameters_.lumenThreshold_mmHg)) / span;
  const double flow = std::min(twisted, std::max(parameters_.lumenFloor, pressed));
  const double capillaryRise = kArteryShare * span * (1.0 - flow);
  return {flow, std::min(1.0, capillaryRise / kCongested_mmHg)};
}

double Perfusion::steadyFlow(double angle_rad, double lumenPressure_mmHg) const noexcept {
  return settled(angle_rad, lumenPressure_mmHg).flow;
}

PerfusionState Perfusion::after(double angle_rad, double lumenPressure_mmHg, double since_s) const noexcept {
  const auto [flow, congestion] = settled(angle_rad, lumenPressure_mmHg);
  const double tau_s = parameters_.flowTime_s;
  const double left = portableExp(-since_s / tau_s);
  PerfusionState state;
  state.flow = flow + (1.0 - flow) * left;
  state.congestion = congestion * (1.0 - left);
  state.saturation = saturationOf(state.flow);
  if (state.flow < parameters_.enoughFlow) {
    // Since the flow fell below what is enough: at t, e^(-t / tau) = (q_c - Q) / (1 - Q).
    const double scarce = parameters_.enoughFlow - flow;
    const double share = scarce / (1.0 - flow);
    const double scarce_s = since_s + tau_s * portableLog(share);
    const double collected_s = scarce * scarce_s - tau_s * (1.0 - flow) * (share - left);
    state.dose = std::max(0.0, collected_s / (parameters_.enoughFlow * parameters_.lossTime_s));
  }
  return state;
}

void Perfusion::step(PerfusionState& state, double angle_rad, double lumenPressure_mmHg,
                     double duration_s) const noexcept {
  const auto [flow, congestion] = settled(angle_rad, lumenPressure_mmHg);
  const double left = decay(duration_s / parameters_.flowTime_s);
  const double before = doseRate(parameters_, state.flow);
  state.flow = flow + (state.flow - flow) * left;
  state.congestion = congestion + (state.congestion - congestion) * left;
  state.saturation = saturationOf(state.flow);
  state.dose += 0.5 * (before + doseRate(parameters_, state.flow)) * duration_s;
  if (state.flow > parameters_.enoughFlow && state.dose < 1.0) {
    state.dose *= decay(duration_s / (kRecoveryTimes * parameters_.lossTime_s));
  }
}

}  // namespace torsio
