// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace torsio::cli {

/// Adds `torsio report`; see commands.h.
void addReport(CLI::App& program);

}  // namespace torsio::cli
