// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace torsio {

/// Returns whether pages that are packed in this way are read: as they are (0), Snappy (1), gzip (2) or zstd
/// (6), as Parquet numbers them.
[[nodiscard]] bool isReadCodec(std::int64_t codec) noexcept;
/// Returns "Snappy" or "BROTLI" for Parquet's number of a packing.
[[nodiscard]] std::string codecName(std::int64_t codec);

/// Unpacks a page, which must have `size` bytes afterwards; empty if it has not, or is damaged. Takes `size`
/// bytes of memory whatever is packed. `codec`: isReadCodec().
[[nodiscard]] std::optional<std::string> unpackedPage(std::int64_t codec, std::string_view packed,
                                                      std::size_t size);

/// Returns the checksum (CRC-32) of a page.
[[nodiscard]] std::uint32_t pageChecksum(std::string_view page) noexcept;

}  // namespace torsio
