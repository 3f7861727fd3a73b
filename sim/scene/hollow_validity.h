// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "sim/core/text.h"
#include "sim/scene/hollow_organ.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio {

/// A wrung stretch and how it is turned.
struct WrungCase {
  std::span<const WallPlace> places;  ///< as drawn, from the held to the turned end
  double length_m = 0.0;
  double shearModulus_Pa = 0.0;
  double gentLimit = 1.0;
  double restPressure_Pa = 0.0;  ///< at which it is drawn
  double pressure_Pa = 0.0;      ///< now
  double twist_rad = 0.0;        ///< by which it is wrung
  double taut_rad = 0.0;         ///< up to which its wall has no folds (WrungOrgan)
  double closing_rad = 0.0;      ///< at which its narrowest place is packed with wall
};

/// What is known of an answer of the law of the wall (docs/model.md H.6).
struct WallValidity {
  Text beyond;  ///< the limits of the law that it passes; empty: none
  /// Least and largest relative error of the torque against solid elements, as measured over cases of its
  /// kind; empty beyond the limits, and of a cord, which has no wall.
  std::optional<std::array<double, 2>> torqueError;
};
[[nodiscard]] WallValidity wallValidity(const WrungCase& wrung);

/// The same of an organ that comes twisted, over all its spans.
[[nodiscard]] WallValidity wallValidity(const HollowOrgan& organ, const OrganState& state);

/// How far an organ that comes twisted was checked.
struct ValidTurn {
  double to_rad = 0.0;  ///< turn up to which no limit is passed either way, by whole degrees
  /// What is passed beyond it, and at the largest turn with which a trial begins; empty: the organ is turned
  /// no further, by half a turn beyond that.
  Text beyond;
};
/// Returns it; of a cord, which has no wall, without a limit.
[[nodiscard]] ValidTurn validTurn(const HollowOrgan& organ);

/// Says what was checked of an organ that comes twisted: up to which turn, how far its torque is off, which
/// limit ends that. Empty of a cord.
[[nodiscard]] Text validityText(const HollowOrgan& organ);

/// How far the law of the wall of a recorded untwisting was checked.
struct RecordedValidity {
  double validTo_rad = 0.0;  ///< ValidTurn, when it was recorded
  std::string beyond;        ///< its limit in English
};
/// Returns it from TrialHeader::parametersJson; empty for another exercise, a cord, and a recording from
/// before it was stored.
[[nodiscard]] std::optional<RecordedValidity> recordedValidity(const std::string& parametersJson);

}  // namespace torsio
