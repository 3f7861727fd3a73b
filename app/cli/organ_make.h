// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace torsio::cli {

/// Adds `make arm`: an arm with a person's measurements.
void addOrganMake(CLI::App& organ);

}  // namespace torsio::cli
