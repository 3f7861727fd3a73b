// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/tissue_palette.h"

namespace torsio {

TissuePalette paletteOf(TissueKind kind) {
  switch (kind) {
    case TissueKind::kSkin:
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
    case TissueKind::kIntestine:
      return {{0.60F, 0.20F, 0.22F},
              0.62F,
              {0.99F, 0.86F, 0.86F},
              0.6F,
              linear({236, 200, 140}),
              linear({240, 206, 190}),
              0.03F,
              0.03F,
              0.035F,
              0.00022};
    case TissueKind::kSerosa:
      break;
  }
  return {{0.60F, 0.20F, 0.22F},
          0.62F,
          {0.99F, 0.86F, 0.86F},
          0.6F,
          linear({236, 200, 140}),
          linear({240, 206, 190}),
          0.06F,
          0.0F,
          0.035F,
          0.00030};
}

}  // namespace torsio
