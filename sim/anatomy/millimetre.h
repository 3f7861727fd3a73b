// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

inline constexpr double kMillimetre_m = 0.001;  ///< shapes are described in millimetres and made in metres

}  // namespace torsio
