// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// Instruction sets that the view kernels are built for. One binary carries all that its architecture knows.
/// Alone in its header: the kernel sources, compiled for wider sets, include nothing of the standard library.
enum class Isa {
  kPortable,  ///< plain C++: SSE2 on x86-64, the base instruction set elsewhere
  kAvx2,      ///< AVX2 and fused multiply-add
  kAvx512,    ///< AVX-512 F, VL, DQ
};

}  // namespace torsio
