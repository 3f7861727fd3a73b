// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "sim/core/error.h"
#include "sim/core/helper_program.h"
#include "sim/geometry/apart/mesh_mail.h"
#include "sim/geometry/apart/mesh_process.h"

namespace torsio {

namespace {

[[noreturn]] void refuseReading(const std::string& where, const Text& what, const Text& remedy) {
  throw Error(ErrorCode::kFileUnreadable, what, where, remedy);
}

/// Refuses a file that the other process gave no answer to.
void requireEnded(const HelperEnd& end, const std::string& where, const std::string& program) {
  const Text again = Text::tr("Export the mesh again, or in another format");
  switch (end.kind) {
    case HelperEnd::Kind::kEnded:
      return;
    case HelperEnd::Kind::kNotStarted:
      refuseReading(where, Text::tr("M05 the program that reads meshes cannot be started: %1", program),
                    Text::tr("Install Torsio again"));
    case HelperEnd::Kind::kOutOfTime:
      refuseReading(where,
                    Text::tr("M05 the importer did not come to an end with this file within %1 s",
                             std::to_string(end.limit_s)),
                    again);
    case HelperEnd::Kind::kCrashed:
      break;
  }
  refuseReading(where,
                Text::tr("M05 the importer crashed on this file (signal %1)", std::to_string(end.signal)),
                again);
}

}  // namespace

RawMesh readMeshApart(const std::filesystem::path& file, double scale_m, const MeshReadLimits& limits) {
  const std::string where = file.string();
  requireMeshFile(file);
  HelperAnswer answer;
  if (!answer.valid()) {
    refuseReading(where, Text::tr("M05 the system gives no memory to read the file"),
                  Text::tr("Close other programs and try again"));
  }
  const std::string program = helperProgram("TORSIO_MESH_PROGRAM", "torsio-mesh");
  const HelperEnd end = runHelper({program, where, hexadecimal(scale_m), std::to_string(limits.memory_MB),
                                   std::to_string(limits.processor_s)},
                                  answer, limits);
  requireEnded(end, where, program);
  return meshOfMail(answer.bytes(), where);
}

}  // namespace torsio
