// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/record_copy.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// A copy with the day on which the centre's rule wants it gone. Torsio deletes no copy by itself.
struct ListedCopy {
  RecordCopy copy;
  std::int64_t dueUtc_us = 0;
};

/// Puts a copy that was made just now at this machine into the register.
void registerCopy(Connection& connection, CopyKind kind, const std::filesystem::path& place,
                  std::int64_t now_us, const PersonId& personId = {});

/// Puts both ends of a move into the register, so that the record at either of them knows the other one. What
/// becomes known as given up is taken back, unless a copy was known there before.
class RegisteredMove {
 public:
  RegisteredMove(Connection& connection, const std::string& from, const std::string& to, std::int64_t now_us);
  void giveUp(std::int64_t now_us);

 private:
  Connection& connection_;
  std::vector<std::string> fresh_;  // ids at places where nothing was known
};

/// Closes the copies of this machine that other accounts could read: files and packages that are still there.
/// Returns one sentence each.
[[nodiscard]] std::vector<Text> closeKnownCopies(Connection& connection);

/// Every place that still holds a person besides the record, newest first; those of this machine that are
/// there no more are left out and noted as gone. kPersonErase.
[[nodiscard]] std::vector<ListedCopy> copiesHolding(SessionContext& session, const PersonId& personId);
/// All copies of the record at `locator`. For the command line, where whoever may read the file may do this;
/// changes nothing. Throws Error, DbError.
[[nodiscard]] std::vector<ListedCopy> copiesOf(const std::string& locator);

/// Adds a copy to the register of a record that nobody has open in this program.
void registerCopyIn(const std::string& locator, CopyKind kind, const std::filesystem::path& place);

}  // namespace torsio
