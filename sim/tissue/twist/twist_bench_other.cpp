// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_bench_platform.h"

namespace torsio {

struct CorePin::Saved {};
CorePin::CorePin() = default;
CorePin::~CorePin() = default;

double loadAverage() {
  return -1.0;
}

}  // namespace torsio
