// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/core/text.h"
#include "sim/scene/hollow_organ.h"
#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio {

/// Names the limits of the law of the wall (docs/model.md H.6) that a wrung stretch passes; empty: none.
/// `twist_rad`: by which it is wrung; `closing_rad`: at which its narrowest place is packed with wall.
struct WrungCase {
  std::span<const WallPlace> places;
  double length_m = 0.0;
  double shearModulus_Pa = 0.0;
  double pressure_Pa = 0.0;  ///< the higher one of that at rest and now
  double twist_rad = 0.0;
  double closing_rad = 0.0;
};
[[nodiscard]] Text wallLimitsPassed(const WrungCase& wrung);

/// Names those that an organ that comes twisted passes in a state, of all its spans; empty: none, and of a
/// cord.
[[nodiscard]] Text wallLimitsPassed(const HollowOrgan& organ, const OrganState& state);

}  // namespace torsio
