// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "sim/device/haptic_device.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"

namespace torsio {

/// What a recording is for: all that must be known of it and that neither its scene nor its device can tell.
struct RecordingSpec {
  TrialId trialId{};                        ///< UUID made by the application
  std::string traineeCode{};                ///< pseudonym, never a name; empty: nobody's
  std::string phaseLabel{};                 ///< "virtual 0-20 min" ...; empty for free practice
  std::optional<double> targetAngle_rad{};  ///< none: that of the scene's pattern
  std::int64_t startedUtc_us = 0;
  bool demonstration = false;  ///< simulated people: shown as such everywhere
  TrialContext context{};      ///< where it belongs in the database: station, enrolment, module, phase
};

/// Fills in the header of a recording, whatever kind of run makes it: identity and purpose from `spec`, organ
/// and parameters from `scene`, model, limits and drive from `device`, the version of this program.
[[nodiscard]] TrialHeader headerFor(const Scene& scene, const DeviceCapabilities& device,
                                    const RecordingSpec& spec);

/// Describes the present machine for the trials that it records: name, operating system, processor with its
/// number of threads, graphics card. What the system does not tell stays empty (the graphics card is told by
/// Linux only). `root`: where the files of the system begin.
[[nodiscard]] RecordingHost thisHost(const std::filesystem::path& root = "/");

/// Returns the context of a recording of free practice: this station and this machine, nobody's training.
[[nodiscard]] TrialContext stationContext();

}  // namespace torsio
