// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "sim/tissue/view/cpu_isa.h"

namespace torsio {

/// Returns the widest instruction set that this processor and operating system can run and this binary was
/// built with.
[[nodiscard]] Isa bestIsa() noexcept;
/// Lists all instruction sets usable here, narrowest first; never empty.
[[nodiscard]] std::span<const Isa> usableIsas() noexcept;
/// Returns the name of a set in benchmark results: "portable", "avx2", "avx512".
[[nodiscard]] std::string_view isaName(Isa isa) noexcept;

}  // namespace torsio
