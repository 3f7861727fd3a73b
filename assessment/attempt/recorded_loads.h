// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "sim/core/live_types.h"

namespace torsio {

/// Returns the force on the tissue in one sample, N: what the model answered to the tool, whatever the device
/// could give of it. 0 where no hand led the tool: device lost, not calibrated, or at its end.
[[nodiscard]] double tissueForce_N(const Sample& sample) noexcept;

/// Tells whether the force on the tissue is known in a sample: the answer of the model was finite and in
/// time.
[[nodiscard]] bool tissueForceKnown(const Sample& sample) noexcept;

/// Largest loads over samples, none of them filtered. What a limit is held against is the first and the last.
struct RecordedLoads {
  /// On the tissue, N, from the first contact to the end of the last. Empty: nothing was touched, or the
  /// force is not known in some sample.
  std::optional<double> tissueForce_N{};
  /// Sent to the device, N: at most what it can give. Empty: nothing was touched.
  std::optional<double> deviceForce_N{};
  /// Torque that the tissue bore, N m. Empty: nothing was touched, or the force is not known in some sample.
  std::optional<double> torque_Nm{};
  friend bool operator==(const RecordedLoads&, const RecordedLoads&) = default;
};

/// Finds the largest loads of a stretch of a recording: all of it, or what belongs to one twist. Any thread.
[[nodiscard]] RecordedLoads recordedLoads(std::span<const Sample> samples) noexcept;

}  // namespace torsio
