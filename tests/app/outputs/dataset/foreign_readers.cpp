// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/outputs/dataset/foreign_readers.h"

#include <cstdlib>

#include "sim/core/file_io.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio::testing {

bool hasProgram(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) ==
         0;  // NOLINT: tests have one thread
}

std::string outputOf(const std::string& command, const std::filesystem::path& folder) {
  const std::filesystem::path out = folder / "output";
  (void)!std::system((command + " > '" + out.string() + "' 2>&1").c_str());  // NOLINT: as above
  return readFile(out);
}

CohortInputs awkwardCohort() {
  CohortInputs in = demonstrationCohort();
  in.auditHead = "0123";
  in.deviations = {{1'767'600'000'000'000, in.trainees[0].code, "late", "=1+1"},
                   {1'767'686'400'000'000, in.trainees[0].code, "room", "+cmd|' /C calc'!A0"},
                   {1'767'686'400'000'000, in.trainees[1].code, "device",
                    "\xE8\xAE\xBE\xE5\xA4\x87, two\nlines; \"quoted\""}};
  return in;
}

}  // namespace torsio::testing
