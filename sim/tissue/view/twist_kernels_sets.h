// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/view/twist_kernels.h"

// Private to the kernels: the table of each instruction set, and how a loop is said to be free of
// dependences.
#if defined(__clang__)
#define TORSIO_VECTOR_LOOP _Pragma("clang loop vectorize(enable)")
#elif defined(__GNUC__)
#define TORSIO_VECTOR_LOOP _Pragma("GCC ivdep")
#elif defined(_MSC_VER)
#define TORSIO_VECTOR_LOOP __pragma(loop(ivdep))
#else
#define TORSIO_VECTOR_LOOP
#endif

// The root of a float, as an instruction.
#if defined(__clang__) || defined(__GNUC__)
#define TORSIO_ROOT(x) __builtin_sqrtf(x)
#else
#include <math.h>
#define TORSIO_ROOT(x) sqrtf(x)
#endif

namespace torsio {

const TwistKernels& twistKernelsPortable() noexcept;
const TwistKernels& twistKernelsAvx2() noexcept;
const TwistKernels& twistKernelsAvx512() noexcept;

}  // namespace torsio
