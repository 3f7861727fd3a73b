// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what the services say as a source that lupdate reads (assets/translations/README.md).
#include <iostream>

#include "tests/support/service_texts.h"

namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
    }
    out += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return out;
}

}  // namespace

int main() {
  std::cout << "static const char* const kTexts[] = {\n";
  for (const std::string& pattern : torsio::readServiceTexts(TORSIO_SOURCE_DIR).patterns) {
    std::cout << "    QT_TRANSLATE_NOOP(\"Services\", \"" << escaped(pattern) << "\"),\n";
  }
  std::cout << "};\n";
  return 0;
}
