// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/tissue_palette.h"

namespace torsio {

TissuePalette paletteOf(TissueKind kind) {
  if (kind == TissueKind::kSkin) {
    return {{0.74F, 0.90F, 0.98F},
            0.55F,
            {0.95F, 0.98F, 1.0F},
            0.5F,
            {1, 1, 1},
            {1, 1, 1},
            0.0F,
            0.0F,
            0.035F,
            0.0016};
  }
  const bool intestine = kind == TissueKind::kIntestine;
  return {.vessel = {0.60F, 0.20F, 0.22F},
          .vesselShare = 0.62F,
          .blush = {0.99F, 0.86F, 0.86F},
          .blushShare = 0.6F,
          .fat = linear({236, 200, 140}),
          .band = linear({240, 206, 190}),
          .fibres = intestine ? 0.03F : 0.06F,
          .folds = intestine ? 0.03F : 0.0F,
          .grain = 0.035F,
          .softness_m = intestine ? 0.00022 : 0.00030};
}

}  // namespace torsio
