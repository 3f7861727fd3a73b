// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_sets.h"

namespace torsio {

namespace {
#include "sim/tissue/view/twist_kernels_loops.h"
}  // namespace

const TwistKernels& twistKernelsPortable() noexcept {
  return kKernels;
}

}  // namespace torsio
