// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a test program where the process that reads scans lies, whoever starts the test.
#include <cstdlib>

namespace {

[[maybe_unused]] const int kScanProgramSet = setenv("TORSIO_SCAN_PROGRAM", TORSIO_SCAN_PROGRAM, 0);

}  // namespace
