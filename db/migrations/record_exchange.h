// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// Ways to exchange two files, tried in this order if the file system refuses one.
enum class ExchangeBy {
  kOneStep,   ///< one atomic exchange of both names (Linux)
  kHardLink,  ///< a second name for the old file, then an atomic replacement
  kNote,      ///< two renames, and a note beside the record from which recoverRecord() completes them
};

/// Replaces the record `target` by the file `ready` and keeps the old one as `aside`, a free name, all in one
/// folder. Whenever the program is killed, a complete record has the name `target` or (kNote) is restored to
/// it by recoverRecord(). Throws std::filesystem::filesystem_error; the record is then unchanged.
void exchangeRecord(const std::filesystem::path& ready, const std::filesystem::path& target,
                    const std::filesystem::path& aside, ExchangeBy first = ExchangeBy::kOneStep);

/// Completes an exchange during which the program was killed: if `record` is missing and a note names its
/// present file, that is renamed back.
void recoverRecord(const std::filesystem::path& record);

}  // namespace torsio
