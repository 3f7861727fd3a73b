// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"
#include "sim/core/text.h"

namespace torsio {

/// Returns "Other accounts of this computer could read FILE; now only yours can".
[[nodiscard]] Text othersCouldRead(const std::filesystem::path& file);

/// Removes other accounts' access to the record at `locator`, to the copies of its name next to it (backups
/// before a restore, copies before a migration), to Torsio's own data folder if the record is there (a folder
/// chosen by the user keeps its mode), and to `folder` with its contents unless it is empty. Returns one
/// sentence per file that others could read before. A record on a server has no files.
[[nodiscard]] std::vector<Text> closeRecordFiles(const std::string& locator,
                                                 const std::filesystem::path& folder);

class Connection;

/// A copy with the date by which the centre's rule wants it deleted. Torsio deletes no copy by itself.
struct ListedCopy {
  RecordCopy copy;
  std::int64_t dueUtc_us = 0;
};

/// Registers a copy just made on this machine.
void registerCopy(Connection& connection, CopyKind kind, const std::filesystem::path& place,
                  std::int64_t now_us, const PersonId& personId = {});

/// Registers both ends of a move, so that the record at either end knows the other. giveUp() removes the new
/// entries again, but not copies that were known before.
class RegisteredMove {
 public:
  RegisteredMove(Connection& connection, const std::string& from, const std::string& to, std::int64_t now_us);
  void giveUp(std::int64_t now_us);

 private:
  Connection& connection_;
  std::vector<std::string> fresh_;  // ids of entries that did not exist before
};

/// Removes other accounts' access to copies on this machine: existing files and packages. Returns one
/// sentence each.
[[nodiscard]] std::vector<Text> closeKnownCopies(Connection& connection);

/// Returns every place besides the record that still holds data of a person, latest first; copies missing
/// from this machine are noted as gone and omitted. kPersonErase.
[[nodiscard]] std::vector<ListedCopy> copiesHolding(SessionContext& session, const PersonId& personId);
/// Returns all copies of the record at `locator`, without changing anything. For the command line, where
/// reading the file is permission enough. Throws Error, DbError.
[[nodiscard]] std::vector<ListedCopy> copiesOf(const std::string& locator);

/// Registers a copy in a record that this program does not have open.
void registerCopyIn(const std::string& locator, CopyKind kind, const std::filesystem::path& place);

}  // namespace torsio
