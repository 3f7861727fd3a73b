// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/file_io.h"

#include <fstream>
#include <sstream>
#include <system_error>

#include "sim/core/database_trace.h"
#include "sim/core/error.h"
#include "sim/core/file_lock.h"

namespace torsio {

namespace fs = std::filesystem;

void refuseUnwritable(const fs::path& file) {
  throw Error(ErrorCode::kFileUnwritable, Text::tr("cannot be written"), file.string(),
              Text::tr("Check that the folder exists, is not read-only, and that the disk is not full"));
}

std::string readFile(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such file"), file.string(), Text::tr("Check the path"));
  }
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  if (fs::is_directory(file, ignored) || !in || (in.peek() != EOF && !(bytes << in.rdbuf()))) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("cannot be read"), file.string(),
                Text::tr("Check that it is a file you may read"));
  }
  return bytes.str();
}

void requireNoDatabase(const fs::path& file) {
  if (looksLikeDatabase(file)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("is a database, which is never overwritten"),
                file.string(), Text::tr("Name another file"));
  }
}

fs::path temporaryBeside(const fs::path& file) {
  fs::path temporary = file;
  temporary += ".part";
  return temporary;
}

void writeFileAtomically(const fs::path& file, const std::function<void(std::ostream&)>& write) {
  PartFile part(file);
  {
    std::ofstream out(part.path(), std::ios::binary | std::ios::trunc);
    if (out) {
      write(out);
      out.close();
    }
    if (!out) {
      refuseUnwritable(file);
    }
  }
  part.finish();
}

void writeFileAtomically(const fs::path& file, std::string_view bytes) {
  writeFileAtomically(file, [bytes](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

void ensureFolder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed || !fs::is_directory(folder, failed)) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("folder cannot be created"), folder.string(),
                Text::tr("Choose a folder in which you may write"));
  }
}

}  // namespace torsio
