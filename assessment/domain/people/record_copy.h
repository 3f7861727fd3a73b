// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// What holds the record, or a person of it, besides the record itself.
enum class CopyKind : std::uint8_t {
  kBackup,
  kBeforeRestore,  ///< the record as it was before a backup took its place
  kBeforeSchema,   ///< the record as it was before a step of the schema
  kPackage,        ///< all about one person
  kMoved,          ///< the record at the other end of a move to another database
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

/// "backup"
[[nodiscard]] constexpr Phrase copyKindLabel(CopyKind kind) noexcept {
  return kCopyKinds[static_cast<std::size_t>(kind)].label;
}

/// One place where a copy was put.
struct RecordCopy {
  CopyKind kind = CopyKind::kBackup;
  std::string place{};    ///< file or folder; address of a server, without an account
  std::string station{};  ///< machine whose disk it is, or that made it on a server
  PersonId personId{};    ///< empty: everybody
  std::int64_t madeUtc_us = 0;
  std::string id{};
};

}  // namespace torsio
