// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/access/session_context.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/progress.h"
#include "app/services/people/people_service.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// Whom a roster lists.
enum class RosterKind { kTrainees, kRaters };

/// What a column of a roster may mean.
enum class RosterField {
  kExternalId,  ///< staff or student number: required, by it a person is recognised
  kFullName,    ///< required
  kEmail,
  kSex,
  kLevel,
  kExperience,
  kAge,
  kHandedness,  ///< trainees
  kRaterClass,  ///< raters: required
};
inline constexpr std::size_t kRosterFields = 9;

/// "external_id", "full_name" ...: also the header of the template.
[[nodiscard]] std::string_view rosterFieldCode(RosterField field) noexcept;
/// "Staff or student number", "Full name" ...
[[nodiscard]] Phrase rosterFieldLabel(RosterField field) noexcept;
/// Fields that a roster of this kind may have, in the order in which they are shown; required ones first.
[[nodiscard]] std::vector<RosterField> rosterFields(RosterKind kind);
[[nodiscard]] bool isRequired(RosterField field, RosterKind kind) noexcept;
/// A file with the header and one made-up line, to fill in.
[[nodiscard]] std::string rosterTemplate(RosterKind kind);

/// A roster as it was read: what the column map is chosen on.
struct RosterFile {
  std::string name{};      ///< of the file, for messages
  std::string encoding{};  ///< as it was saved: "UTF-8"; another one was guessed
  char separator = ',';
  std::vector<std::string> header{};
  std::vector<CsvRecord> rows{};
  std::string contentHash{};
};

/// Reads comma-, semicolon- or tab-separated text in one of the encodings of decodeRosterText(); lines of
/// separators alone are skipped. Throws Error{kFileMissing, kFileUnreadable, kBadData}: no such encoding,
/// empty, no header, a column named twice, no rows.
[[nodiscard]] RosterFile readRoster(const std::filesystem::path& file);
[[nodiscard]] RosterFile parseRoster(std::string_view bytes, const std::string& name);

/// Which column holds what: position in RosterFile::header, empty for "not in this file".
using RosterColumns = std::array<std::optional<std::size_t>, kRosterFields>;
/// As far as the headers tell; English and Chinese names are known. The user may change it.
[[nodiscard]] RosterColumns suggestColumns(const RosterFile& file, RosterKind kind);

/// What will be done with one line.
enum class RosterStatus {
  kNew,      ///< nobody has this number: a person is added
  kSame,     ///< known, and everything is as it is
  kChanges,  ///< known, and some fields differ
  kError,    ///< cannot be taken: `problem` says why and `remedy` what to mend
};
struct RosterChange {
  RosterField field = RosterField::kFullName;
  std::string from{};
  std::string to{};
};
struct RosterRow {
  std::size_t line = 0;
  RosterStatus status = RosterStatus::kError;
  std::array<std::string, kRosterFields> values{};  ///< as understood: "female" for "F"
  PersonId personId{};                              ///< of a known person
  std::string code{};                               ///< of a known person
  std::vector<RosterChange> changes{};
  Text problem{};
  Text remedy{};
  Text hint{};  ///< something to look at that does not stop the import
};

struct RosterPreview {
  RosterKind kind = RosterKind::kTrainees;
  std::vector<RosterRow> rows{};
  std::size_t added = 0;
  std::size_t changed = 0;
  std::size_t same = 0;
  std::size_t errors = 0;
  /// Over rows and what they were compared with: an import that would do something else is refused.
  std::string fingerprint{};
  [[nodiscard]] bool importable() const noexcept { return errors == 0 && added + changed > 0; }
};

/// What an import would do, line by line. Blank cells keep what is known. People are recognised by their
/// number alone; an e-mail address that somebody else has is a hint. Changes nothing. kPersonEdit and
/// kPersonViewIdentity. Throws Error{kBadParameter} when a required field has no column, or two fields share
/// one.
[[nodiscard]] RosterPreview previewRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                                          const RosterColumns& columns,
                                          const ProgressCallback& progress = {});

/// What an import did.
struct RosterOutcome {
  std::size_t added = 0;
  std::size_t changed = 0;
  std::vector<std::string> newCodes{};  ///< in order
};

enum class RosterMode {
  kDryRun,  ///< does all of it and takes it back: proves that the database would accept it
  kCommit,
};

/// All lines or none, in one transaction; codes are given in an order that does not follow the roster.
/// Audited: one entry a person and one for the import, without names. The same operations. Throws
/// Error{kBadData} when a line cannot be taken, or when the record has changed since the preview with this
/// fingerprint. What `progress` throws stops it, and then nothing is stored.
RosterOutcome importRoster(SessionContext& session, const RosterFile& file, RosterKind kind,
                           const RosterColumns& columns, const std::string& fingerprint, RosterMode mode,
                           const ProgressCallback& progress = {});

/// Who trains or scores and cannot sign in yet, ordered by code. kUserManage.
[[nodiscard]] std::vector<PersonRow> peopleWithoutAccount(SessionContext& session);

/// An account for each of these people, in the order of their codes: the sign-in name is the code in small
/// letters (with a number behind it when somebody has that name), the roles follow from what the person does.
/// Each account is stored by itself, since sealing a password takes about a second; every stored one is put
/// into `made` at once, so that none is lost when `progress` or the database throws. Whoever has an account,
/// or left, is passed over. kUserManage.
void addAccounts(SessionContext& session, const std::vector<PersonId>& personIds,
                 std::vector<StartAccount>& made, const ProgressCallback& progress = {});

}  // namespace torsio
