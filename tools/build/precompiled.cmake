# SPDX-License-Identifier: GPL-3.0-or-later
# Precompiled headers. They only save time: each source still includes what it uses (.ci/lint compiles without them).
# A kind is used by targets whose definitions include those of the kind.

set(torsio_standard_headers
  <algorithm> <array> <charconv> <chrono> <cmath> <cstddef> <cstdint> <cstdio> <filesystem> <fstream> <functional>
  <limits> <map> <memory> <numbers> <numeric> <optional> <set> <span> <sstream> <string> <string_view> <system_error>
  <tuple> <utility> <variant> <vector>)
set(torsio_widget_headers
  <QApplication> <QBoxLayout> <QCheckBox> <QComboBox> <QDialog> <QElapsedTimer> <QEvent> <QFormLayout> <QKeyEvent>
  <QLabel> <QLineEdit> <QLocale> <QMessageBox> <QPainter> <QPlainTextEdit> <QPointer> <QPushButton> <QScrollArea>
  <QString> <QTableView> <QTimer> <QToolButton>)

# torsio_precompiled(kind HEADERS ... LINK ... [OPTIONS ...]): declares the headers of one kind.
function(torsio_precompiled kind)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK;OPTIONS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Nothing: the target exists for its precompiled header.\n" @ONLY)
  add_library(torsio_precompiled_${kind} OBJECT ${source})
  target_link_libraries(torsio_precompiled_${kind} PRIVATE torsio_flags ${ARG_LINK})
  target_compile_options(torsio_precompiled_${kind} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(torsio_precompiled_${kind} PRIVATE ${ARG_HEADERS})
  if(TORSIO_SANITIZED AND NOT kind MATCHES "tests$")
    set_target_properties(torsio_precompiled_${kind} PROPERTIES TORSIO_NOT_SANITIZED ON)
  endif()
endfunction()

# torsio_use_precompiled(target kind)
function(torsio_use_precompiled target kind)
  if(kind MATCHES "tests$")
    target_compile_options(${target} PRIVATE ${torsio_plain_code})
  endif()
  target_precompile_headers(${target} REUSE_FROM torsio_precompiled_${kind})
endfunction()

torsio_precompiled(numbers HEADERS ${torsio_standard_headers} OPTIONS ${torsio_optimised})
torsio_precompiled(plain HEADERS ${torsio_standard_headers})
torsio_precompiled(json HEADERS ${torsio_standard_headers} <nlohmann/json.hpp> LINK nlohmann_json::nlohmann_json)
if(TORSIO_BUILD_APP)
  torsio_precompiled(commands HEADERS ${torsio_standard_headers} <nlohmann/json.hpp> <CLI/CLI.hpp>
    LINK nlohmann_json::nlohmann_json CLI11::CLI11)
  torsio_precompiled(widgets HEADERS ${torsio_standard_headers} ${torsio_widget_headers} LINK Qt6::Widgets)
endif()
if(TORSIO_BUILD_TESTS)
  torsio_precompiled(tests HEADERS ${torsio_standard_headers} <gtest/gtest.h> <gmock/gmock.h> LINK GTest::gtest
    OPTIONS ${torsio_plain_code})
  if(TORSIO_BUILD_APP)
    torsio_precompiled(widget_tests LINK GTest::gtest Qt6::Widgets OPTIONS ${torsio_plain_code}
      HEADERS ${torsio_standard_headers} ${torsio_widget_headers} <gtest/gtest.h> <gmock/gmock.h>)
  endif()
endif()
