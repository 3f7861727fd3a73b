// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

class IdSource;

/// A seed from the same source as record ids: the machine's random numbers, or a test's fixed stream. Private
/// to the services that draw.
[[nodiscard]] std::uint64_t drawSeed(IdSource& ids);

/// 256 bits for a commitment (seedCommitment), from the same source.
[[nodiscard]] std::string drawSalt(IdSource& ids);

}  // namespace torsio
