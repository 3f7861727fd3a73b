// SPDX-License-Identifier: GPL-3.0-or-later
// torsio-mesh FILE SCALE MEMORY_MB PROCESSOR_S: reads a mesh file for Torsio within limits and leaves it, or
// the refusal, in the file that it was given. Started by Torsio, never by hand.
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/geometry/apart/helper_process.h"
#include "sim/geometry/apart/mesh_mail.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio {
namespace {

Error tooMuchMemory(const std::string& file, const std::string& memory_MB) {
  return {ErrorCode::kFileUnreadable,
          Text::tr("M05 the importer needs more than %1 MB of memory for this file", memory_MB), file,
          Text::tr("Decimate the surface, or export the mesh again")};
}

std::string answerTo(const std::string& file, double scale_m, const std::string& memory_MB) {
  try {
    return mailOf(readMesh(file, scale_m));
  } catch (const Error& error) {
    // assimp catches what the memory refuses, and says so in these words
    const bool memory = error.happened().find("bad_alloc") != std::string::npos;
    return mailOf(memory ? tooMuchMemory(file, memory_MB) : error);
  } catch (const std::bad_alloc&) {
    return mailOf(tooMuchMemory(file, memory_MB));
  } catch (const std::exception& error) {
    return mailOf(Error(ErrorCode::kFileUnreadable,
                        Text::tr("M05 the importer failed on this file: %1", plainLine(error.what())), file,
                        Text::tr("Export the mesh again")));
  }
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  constexpr int kWords = 5;
  if (argc != kWords ||
      !torsio::bindHelper(std::strtoull(argv[3], nullptr, 10), std::strtoull(argv[4], nullptr, 10))) {
    return EXIT_FAILURE;
  }
  return torsio::leaveAnswer(torsio::answerTo(argv[1], std::strtod(argv[2], nullptr), argv[3]))
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
