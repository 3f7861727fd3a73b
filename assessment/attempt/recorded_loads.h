// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "sim/core/live_types.h"

namespace torsio {

/// Returns the force on the tissue in a sample, N: the model's result, whatever the device could render. 0 if
/// no hand led the tool: device lost, not calibrated, or at its end.
[[nodiscard]] double tissueForce_N(const Sample& sample) noexcept;

/// Returns whether the force on the tissue is known in a sample: the model's result was finite and in time.
[[nodiscard]] bool tissueForceKnown(const Sample& sample) noexcept;

/// Maximum loads over samples, unfiltered. Limits apply to the first and the last.
struct RecordedLoads {
  /// On the tissue, N, from the first contact to the end of the last. Empty: nothing was touched, or the
  /// force is unknown in some sample.
  std::optional<double> tissueForce_N{};
  /// Sent to the device, N, limited to what it can render. Empty: nothing was touched.
  std::optional<double> deviceForce_N{};
  /// On the tissue, N m. Empty: nothing was touched, or the force is unknown in some sample.
  std::optional<double> torque_Nm{};
  friend bool operator==(const RecordedLoads&, const RecordedLoads&) = default;
};

/// Finds the maximum loads of a recording, or of the part for one twist. Any thread.
[[nodiscard]] RecordedLoads recordedLoads(std::span<const Sample> samples) noexcept;

}  // namespace torsio
