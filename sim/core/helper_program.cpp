// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/helper_program.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace torsio {

std::string helperProgram(const char* variable, const std::string& name) {
  if (const char* const named = std::getenv(variable); named != nullptr && *named != '\0') {
    return named;
  }
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  const std::filesystem::path beside = self.parent_path() / name;
  const std::filesystem::path installed = self.parent_path().parent_path() / "libexec/torsio" / name;
  return (std::filesystem::exists(beside, failed) ? beside : installed).string();
}

}  // namespace torsio
