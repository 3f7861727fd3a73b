// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace torsio::cli {

void addOrganReconstruct(CLI::App& organ);

}  // namespace torsio::cli
