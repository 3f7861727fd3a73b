# SPDX-License-Identifier: GPL-3.0-or-later
# The Debian packages torsio and torsio-doc (tools/package/make). What the program loads while it runs is named here:
# dpkg-shlibdeps sees only what it links.
set(TORSIO_MAINTAINER "The Torsio contributors <torsio@packages.invalid>" CACHE STRING "who built the packages")
set(torsio_system ${PROJECT_SOURCE_DIR}/assets/system)

install(FILES ${torsio_system}/torsio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT torsio)
install(FILES ${torsio_system}/torsio.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo
  RENAME org.torsio.Torsio.metainfo.xml COMPONENT torsio)
install(FILES ${torsio_system}/torsio-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME torsio.xml COMPONENT torsio)
install(FILES ${PROJECT_SOURCE_DIR}/assets/icons/application.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
  RENAME torsio.svg COMPONENT torsio)
install(FILES ${torsio_system}/torsio-haptics.rules DESTINATION lib/udev/rules.d RENAME 60-torsio-haptics.rules COMPONENT torsio)
install(FILES ${torsio_system}/torsio-serve.service ${torsio_system}/torsio-backup.service ${torsio_system}/torsio-backup.timer
  ${torsio_system}/torsio-drill.service ${torsio_system}/torsio-drill.timer DESTINATION lib/systemd/system COMPONENT torsio)
install(FILES ${torsio_system}/torsio-limits.conf DESTINATION /etc/security/limits.d RENAME torsio.conf COMPONENT torsio)
install(FILES ${torsio_system}/torsio.conf DESTINATION /etc/torsio COMPONENT torsio)
install(FILES ${torsio_system}/torsio-serve.default DESTINATION /etc/default RENAME torsio-serve COMPONENT torsio)
foreach(part torsio doc)
  set(package torsio)
  if(part STREQUAL doc)
    set(package torsio-doc)
  endif()
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${part})
  install(FILES ${PROJECT_BINARY_DIR}/package/changelog.gz ${PROJECT_BINARY_DIR}/package/NEWS.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${part})
endforeach()
# Without the time and the name of the file inside, so that two builds are equal.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
string(TIMESTAMP torsio_built "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH
file(WRITE ${PROJECT_BINARY_DIR}/package/changelog "torsio (${PROJECT_VERSION}) bookworm; urgency=medium

  * What changed is in NEWS.gz.

 -- ${TORSIO_MAINTAINER}  ${torsio_built}
")
execute_process(COMMAND gzip -9nf ${PROJECT_BINARY_DIR}/package/changelog)
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md OUTPUT_FILE ${PROJECT_BINARY_DIR}/package/NEWS.gz)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME torsio)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "training and assessment of surgical twist skills")
set(CPACK_PACKAGE_VENDOR "The Torsio contributors")
set(CPACK_PACKAGE_CONTACT "${TORSIO_MAINTAINER}")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL torsio doc)
set(CPACK_STRIP_FILES ON)
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_TORSIO_PACKAGE_NAME torsio)
set(CPACK_COMPONENT_TORSIO_DESCRIPTION "Trainees grip and twist a virtual stomach, forearm or small intestine with a
haptic device or a mouse. Every run is recorded and can be replayed bit for
bit. Physicians score the recordings without knowing whose they are. The
evaluation, the training study and the report of a cohort are computed from
their marks, and every number can be traced back to a recording.

This package has the window, the command line and the review desk in a
browser. The record is a SQLite file, or a PostgreSQL server for several
stations.")
set(CPACK_DEBIAN_TORSIO_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TORSIO_PACKAGE_DEPENDS "libqt6sql6-sqlite, libqt6sql6-psql, qml6-module-qtquick, qml6-module-qtqml, qml6-module-qtqml-workerscript, qml6-module-qtquick-window, qml6-module-quick3d, libgl1-mesa-dri, libglx-mesa0, fonts-noto-core, fonts-noto-cjk, fonts-dejavu-core, ca-certificates, adduser")
set(CPACK_DEBIAN_TORSIO_PACKAGE_SUGGESTS "torsio-doc, postgresql, postgresql-client")
set(CPACK_DEBIAN_TORSIO_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_LIST_DIR}/postinst;${CMAKE_CURRENT_LIST_DIR}/prerm;${CMAKE_CURRENT_LIST_DIR}/postrm;${CMAKE_CURRENT_LIST_DIR}/conffiles")

set(CPACK_DEBIAN_DOC_PACKAGE_NAME torsio-doc)
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DOC_PACKAGE_SECTION doc)
set(CPACK_COMPONENT_DOC_DESCRIPTION "Guides for trainees, physicians and administrators, the description of the
model, the assessment and the record, and what the people who run the
computers need.

This package has the documents of torsio.")
include(CPack)
