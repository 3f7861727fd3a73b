// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/progress.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// People listed by a roster.
enum class RosterKind { kTrainees, kRaters };

/// Meaning of a roster's column.
enum class RosterField {
  kExternalId,  ///< staff or student number: required, identifies the person
  kFullName,    ///< required
  kEmail,
  kSex,
  kLevel,
  kExperience,
  kAge,
  kHandedness,  ///< trainees
  kRaterClass,  ///< raters only, required
};
inline constexpr std::size_t kRosterFields = 9;

/// Returns "external_id", "full_name" ..., also the header of the template.
[[nodiscard]] std::string_view rosterFieldCode(RosterField field) noexcept;
/// Returns "Staff or student number", "Full name" ...
[[nodiscard]] Phrase rosterFieldLabel(RosterField field) noexcept;
/// Returns the fields of this kind of roster in display order; required ones first.
[[nodiscard]] std::vector<RosterField> rosterFields(RosterKind kind);
[[nodiscard]] bool isRequired(RosterField field, RosterKind kind) noexcept;
/// Returns a file to fill in, with the header and one invented line.
[[nodiscard]] std::string rosterTemplate(RosterKind kind);

/// A roster as read, for choosing the columns.
struct RosterFile {
  std::string name{};      ///< file name, for messages
  std::string encoding{};  ///< detected: "UTF-8"; others are guesses
  char separator = ',';
  std::vector<std::string> header{};
  std::vector<CsvRecord> rows{};
  std::string contentHash{};
};

/// Reads comma-, semicolon- or tab-separated text in one of the encodings of decodeRosterText(); skips lines
/// with only separators. Throws Error{kFileMissing, kFileUnreadable, kBadData}: unknown encoding, empty file,
/// no header, duplicate column, no rows.
[[nodiscard]] RosterFile readRoster(const std::filesystem::path& file);
[[nodiscard]] RosterFile parseRoster(std::string_view bytes, const std::string& name);

/// Column of each field: position in RosterFile::header, empty for "not in this file".
using RosterColumns = std::array<std::optional<std::size_t>, kRosterFields>;
/// Suggests columns from the headers, in English and Chinese. The user may change them.
[[nodiscard]] RosterColumns suggestColumns(const RosterFile& file, RosterKind kind);

/// Effect of importing a line.
enum class RosterStatus {
  kNew,      ///< unknown number: a person is added
  kSame,     ///< known, without differences
  kChanges,  ///< known, with differences
  kError,    ///< rejected; see `problem` and `remedy`
};
struct RosterChange {
  RosterField field = RosterField::kFullName;
  std::string from{};
  std::string to{};
};
struct RosterRow {
  std::size_t line = 0;
  RosterStatus status = RosterStatus::kError;
  std::array<std::string, kRosterFields> values{};  ///< parsed: "female" for "F"
  PersonId personId{};                              ///< of a known person
  std::string code{};                               ///< of a known person
  std::vector<RosterChange> changes{};
  Text problem{};
  Text remedy{};
  Text hint{};  ///< a warning that does not stop the import
};

struct RosterPreview {
  RosterKind kind = RosterKind::kTrainees;
  std::vector<RosterRow> rows{};
  std::size_t added = 0;
  std::size_t changed = 0;
  std::size_t same = 0;
  std::size_t errors = 0;
  /// Hash of the rows and the data that they were compared with; importRoster() checks it.
  std::string fingerprint{};
  [[nodiscard]] bool importable() const noexcept { return errors == 0 && added + changed > 0; }
};

/// Returns what an import would do with each line, without changing anything. Empty cells keep existing
/// values. People are identified by their number alone; an e-mail address of somebody else is a hint.
/// kPersonEdit and kPersonViewIdentity. Throws Error{kBadParameter} if a required field has no column, or two
/// fields share one.
[[nodiscard]] RosterPreview previewRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                                          const RosterColumns& columns,
                                          const ProgressCallback& progress = {});

/// Result of an import.
struct RosterOutcome {
  std::size_t added = 0;
  std::size_t changed = 0;
  std::vector<std::string> newCodes{};  ///< in order
};

enum class RosterMode {
  kDryRun,  ///< does everything and rolls back: proves that the database would accept it
  kCommit,
};

/// Imports all lines or none, in one transaction; the order of codes is independent of the roster. Audited:
/// one entry per person and one for the import, without names. kPersonEdit and kPersonViewIdentity. Throws
/// Error{kBadData} if a line is rejected, or the record has changed since the preview with this fingerprint.
/// If `progress` throws, nothing is stored.
RosterOutcome importRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                           const RosterColumns& columns, const std::string& fingerprint, RosterMode mode,
                           const ProgressCallback& progress = {});

}  // namespace torsio
