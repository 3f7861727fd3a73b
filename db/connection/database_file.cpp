// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/database_file.h"

#include <system_error>

#include "sim/core/error.h"

namespace torsio {

namespace fs = std::filesystem;

void refuseReadOnly(const Text& what, const fs::path& path) {
  throw Error(ErrorCode::kFileUnwritable, what, path.string(),
              Text::tr("Choose a folder in which you may write, or open the database for reading only"));
}

namespace {

/// True if all write permissions were removed: then we do not write, even as root.
bool markedReadOnly(const fs::path& path) {
  constexpr auto kWrite = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  std::error_code failed;
  const fs::file_status status = fs::status(path, failed);
  return !failed && fs::exists(status) && (status.permissions() & kWrite) == fs::perms::none;
}

}  // namespace

void requireUsableFile(const fs::path& file, OpenMode mode) {
  std::error_code ignored;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (fs::is_directory(file, ignored)) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is a folder, not a database"), file.string(),
                Text::tr("Name a file in that folder"));
  }
  const bool exists = fs::exists(file, ignored);
  if (exists && !fs::is_regular_file(file, ignored)) {  // opening a pipe would block until somebody writes
    throw Error(ErrorCode::kFileUnreadable, Text::tr("is no file, so it is no database"), file.string(),
                Text::tr("Name a file"));
  }
  if (exists && fs::file_size(file, ignored) == 0) {
    throw Error(ErrorCode::kFileUnreadable,
                Text::tr("is empty, which no record ever is: something emptied it"), file.string(),
                Text::tr("Restore the latest backup; if there never was a record here, remove the file"));
  }
  if (!exists && fs::is_symlink(fs::symlink_status(file, ignored))) {
    throw Error(ErrorCode::kFileMissing, Text::tr("is a link to a file that is not there"), file.string(),
                Text::tr("Connect the disk that it lies on, or remove the link"));
  }
  if (!exists && mode != OpenMode::kCreate) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such database"), file.string(),
                Text::tr("Check the path"));
  }
  if (!exists && !fs::is_directory(folder, ignored)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such folder"), folder.string(),
                Text::tr("Create it, or choose another"));
  }
  if (mode == OpenMode::kReadOnly) {
    return;
  }
  if (exists && markedReadOnly(file)) {
    refuseReadOnly(Text::tr("database file is read-only"), file);
  }
  // The write-ahead log is a file beside the database, so the folder must be writable.
  if (markedReadOnly(folder)) {
    refuseReadOnly(Text::tr("folder is read-only"), folder);
  }
}

bool hasJournal(const std::string& file) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file + "-journal", failed);
  return !failed && size > 0;
}

}  // namespace torsio
