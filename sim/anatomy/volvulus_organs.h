// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/anatomy/stomach.h"

namespace torsio {

/// Draws a left testis of 50 x 30 x 20 mm (Prader's and sonographic means of adults, rounded) that hangs on a
/// straight cord of 60 mm length and 12 mm width; the epididymis is relief on its back edge. The fixed end is
/// the upper end of the cord. `edges`, here and below: as for makeIntestine().
[[nodiscard]] TubeOrgan makeTestis(double edges = 1.0);

/// Draws an omega loop of sigmoid colon: two limbs of 200 mm on a root of 40 mm between their feet, 30 to
/// 40 mm in radius where it is wide, with haustra and three taeniae as relief. Sizes of a dilated loop,
/// assumed. The fixed end is the foot towards the descending colon.
[[nodiscard]] TubeOrgan makeSigmoid(double edges = 1.0);

/// Draws a loop of small bowel, 26 mm wide and about 350 mm long, whose feet lie side by side on a narrow
/// root, as of a closed loop; it is bowed to the front. Sizes assumed. The fixed end is its left foot.
[[nodiscard]] TubeOrgan makeBowelLoop(double edges = 1.0);

/// Draws a pack of small-bowel coils, as relief on one body of 124 x 70 x 104 mm, to the right of a stalk of
/// 60 mm length and 16 mm width that comes down and forward, and beside the stalk the jejunal limb, from the
/// pack up to the root. Sizes assumed. The fixed end is the root of the stalk.
[[nodiscard]] TubeOrgan makeMidgut(double edges = 1.0);

/// The same as it was drawn before: without the limb, on a stalk that comes straight forward.
[[nodiscard]] TubeOrgan makeFormerMidgut();

}  // namespace torsio
