// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the path of the scan reading process for a test program, however it is started.
#include <cstdlib>

namespace {

[[maybe_unused]] const int kScanProgramSet = setenv("TORSIO_SCAN_PROGRAM", TORSIO_SCAN_PROGRAM, 0);

}  // namespace
