// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/imaging/surface/scan_preview.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio {

/// What the other process is to answer with.
enum class ScanAnswer {
  kSurface,  ///< the organ's surface
  kSlices,   ///< the scan, small enough to look at
  kOrgan,    ///< the scan, small enough to look at, with the organ's voxels
  kTool,     ///< an instrument, of a ToolRequest
};

/// Writes a request as words for the command line of a process of the same build.
[[nodiscard]] std::vector<std::string> wordsOf(const ScanRequest& request);

[[nodiscard]] std::vector<std::string> wordsOf(const ToolRequest& request);

/// Reads them back; none if they are malformed, or more than a process is started with.
[[nodiscard]] std::optional<ScanRequest> requestOfWords(std::span<const char* const> words);

[[nodiscard]] std::optional<ToolRequest> toolRequestOfWords(std::span<const char* const> words);

/// Writes what became of a scan as bytes for a process of the same build on this machine.
[[nodiscard]] std::string mailOf(const ScanSurface& surface);

[[nodiscard]] std::string mailOf(const ScanPreview& preview);
[[nodiscard]] std::string mailOf(const ToolSurface& tool);

/// Reads it back; throws the Error that was written in place of it. Sizes are checked; bytes that are neither
/// throw Error{kFileUnreadable}, D04, at `where`.
[[nodiscard]] ScanSurface scanOfMail(std::span<const char> bytes, const std::string& where);
[[nodiscard]] ScanPreview previewOfMail(std::span<const char> bytes, const std::string& where);
[[nodiscard]] ToolSurface toolOfMail(std::span<const char> bytes, const std::string& where);

}  // namespace torsio
