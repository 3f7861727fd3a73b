// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/machine_facts.h"

#include <fstream>
#include <thread>

namespace torsio {

namespace {

std::string processorName() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

}  // namespace

MachineFacts machineFacts() {
  MachineFacts facts;
  facts.processor = processorName();
  facts.cores = static_cast<int>(std::thread::hardware_concurrency());
  std::ifstream load("/proc/loadavg");
  if (!(load >> facts.loadAverage)) {
    facts.loadAverage = -1.0;
  }
  facts.compiler = TORSIO_COMPILER;
#if defined(__OPTIMIZE__)
  facts.flags = "optimised, models -O3 -ffp-contract=off, no -march";
#else
  facts.flags = "not optimised: times mean nothing";
#endif
  return facts;
}

}  // namespace torsio
