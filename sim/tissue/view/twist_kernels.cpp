// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/view/twist_kernels.h"

#include "sim/tissue/view/twist_kernels_sets.h"

namespace torsio {

const TwistKernels& twistKernels(Isa isa) noexcept {
#if defined(TORSIO_X86_KERNELS)
  if (isa == Isa::kAvx512) {
    return twistKernelsAvx512();
  }
  if (isa == Isa::kAvx2) {
    return twistKernelsAvx2();
  }
#else
  static_cast<void>(isa);
#endif
  return twistKernelsPortable();
}

}  // namespace torsio
