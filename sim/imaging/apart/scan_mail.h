// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/imaging/surface/scan_request.h"

namespace torsio {

/// Writes a request as words for the command line of a process of the same build.
[[nodiscard]] std::vector<std::string> wordsOf(const ScanRequest& request);

/// Reads them back; none where they are no such words.
[[nodiscard]] std::optional<ScanRequest> requestOfWords(std::span<const char* const> words);

/// Writes what became of a scan as bytes for a process of the same build on this machine.
[[nodiscard]] std::string mailOf(const ScanSurface& surface);

/// Reads it back; throws the Error that was written in place of it. Sizes are checked; bytes that are neither
/// throw Error{kFileUnreadable}, D04, at `where`.
[[nodiscard]] ScanSurface scanOfMail(std::span<const char> bytes, const std::string& where);

}  // namespace torsio
