// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// Kinds of copies of the record, whole or of one person.
enum class CopyKind : std::uint8_t {
  kBackup,
  kBeforeRestore,  ///< the record before a backup was restored over it
  kBeforeSchema,   ///< the record before a schema migration
  kPackage,        ///< everything about one person
  kMoved,          ///< the target of a move to another database
};
inline constexpr auto kCopyKinds = std::to_array<Term<CopyKind>>({
    {CopyKind::kBackup, "backup", Text::tr("backup")},
    {CopyKind::kBeforeRestore, "before_restore", Text::tr("record before a restore")},
    {CopyKind::kBeforeSchema, "before_schema", Text::tr("record before a new schema")},
    {CopyKind::kPackage, "package", Text::tr("package about the person")},
    {CopyKind::kMoved, "moved", Text::tr("record before or after a move")},
});
[[nodiscard]] constexpr const auto& termsOf(CopyKind) noexcept {
  return kCopyKinds;
}

[[nodiscard]] constexpr Phrase copyKindLabel(CopyKind kind) noexcept {
  return kCopyKinds[static_cast<std::size_t>(kind)].label;
}

/// A copy and where it was put.
struct RecordCopy {
  CopyKind kind = CopyKind::kBackup;
  std::string place{};    ///< file or folder; address of a server, without an account
  std::string station{};  ///< machine whose disk holds it, or that made it on a server
  PersonId personId{};    ///< empty: whole record
  std::int64_t madeUtc_us = 0;
  std::string id{};
};

}  // namespace torsio
