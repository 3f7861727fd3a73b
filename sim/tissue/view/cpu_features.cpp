// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/view/cpu_features.h"

#include <array>
#include <cstddef>

#if defined(TORSIO_X86_KERNELS) && defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#endif

namespace torsio {

namespace {

struct UsableSets {
  std::array<Isa, 3> sets{Isa::kPortable};
  std::size_t count = 1;
};

#if !defined(TORSIO_X86_KERNELS)
bool hasAvx2() {
  return false;
}
bool hasAvx512() {
  return false;
}
#elif defined(_MSC_VER) && !defined(__clang__)
// Instruction sets count only when the operating system saves their registers (XCR0).
bool osSaves(unsigned long long mask) {
  int leaf1[4] = {};
  __cpuid(leaf1, 1);
  return (leaf1[2] & (1 << 27)) != 0 && (_xgetbv(0) & mask) == mask;
}
int leaf7ebx() {
  int leaf7[4] = {};
  __cpuidex(leaf7, 7, 0);
  return leaf7[1];
}
bool hasAvx2() {
  int leaf1[4] = {};
  __cpuid(leaf1, 1);
  return osSaves(0x6) && (leaf1[2] & (1 << 12)) != 0 && (leaf7ebx() & (1 << 5)) != 0;
}
bool hasAvx512() {
  constexpr int kFoundationDqVl = (1 << 16) | (1 << 17) | static_cast<int>(1U << 31);
  return osSaves(0xe6) && (leaf7ebx() & kFoundationDqVl) == kFoundationDqVl;
}
#else
bool hasAvx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
bool hasAvx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq");
}
#endif

UsableSets findUsableSets() {
  UsableSets usable;
  if (!hasAvx2()) {
    return usable;
  }
  usable.sets[usable.count++] = Isa::kAvx2;
  if (hasAvx512()) {
    usable.sets[usable.count++] = Isa::kAvx512;
  }
  return usable;
}

const UsableSets& found() noexcept {
  static const UsableSets usable = findUsableSets();
  return usable;
}

}  // namespace

Isa bestIsa() noexcept {
  return usableIsas().back();
}

std::span<const Isa> usableIsas() noexcept {
  return std::span<const Isa>(found().sets).first(found().count);
}

std::string_view isaName(Isa isa) noexcept {
  switch (isa) {
    case Isa::kAvx2:
      return "avx2";
    case Isa::kAvx512:
      return "avx512";
    case Isa::kPortable:
      break;
  }
  return "portable";
}

}  // namespace torsio
