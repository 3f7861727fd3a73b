// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace torsio {

// For the programs that runHelper() starts.

/// Gives up what reading a file does not need: memory and processor time beyond a limit, files
/// larger than an answer, processes of its own, life after its parent. False when the system refuses.
[[nodiscard]] bool bindHelper(std::uint64_t memory_MB, std::uint64_t processor_s);

/// Leaves the answer where the parent looks for it; false when it cannot be written.
[[nodiscard]] bool leaveAnswer(const std::string& answer);

/// Tells the parent how far it is; lost when it does not listen.
void tellParent(std::span<const char> news);

}  // namespace torsio
