// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// How two files change places; each way is tried when the file system refuses the one before.
enum class ExchangeBy {
  kOneStep,   ///< the system exchanges both names at once (Linux)
  kHardLink,  ///< the old file gets its second name first, then the new one replaces it at once
  kNote,      ///< two renames, and a note beside the record from which recoverRecord() finishes them
};

/// Puts the file `ready` in place of the record `target`, which is kept as `aside`, a free name. All three
/// lie in one folder. However the program ends, a whole record stands under the name `target`, or (kNote) is
/// put back there by recoverRecord(). Throws std::filesystem::filesystem_error; then the record is as before.
void exchangeRecord(const std::filesystem::path& ready, const std::filesystem::path& target,
                    const std::filesystem::path& aside, ExchangeBy first = ExchangeBy::kOneStep);

/// Finishes an exchange in which the program was killed: when `record` is missing and a note tells where it
/// went, it gets its name back.
void recoverRecord(const std::filesystem::path& record);

}  // namespace torsio
