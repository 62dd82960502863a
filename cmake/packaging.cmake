# What `cmake --install` and `cpack -G DEB` put where. Two packages: `goniolux` (programs, data, manual pages, completion) and
# `goniolux-dev` (the engine's libraries and headers with a CMake package). The programs find their data and helpers from
# where they stand: bin/goniolux looks in ../libexec and ../share/goniolux.
include(GNUInstallDirs)
# Installing and packing take what is built: the target `programs` is enough, tests need not be there.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

set(manual_folder ${CMAKE_BINARY_DIR}/share/man/man1)
set(completion_folder ${CMAKE_BINARY_DIR}/share/completion)
set(manual_stamp ${CMAKE_BINARY_DIR}/share/made)
# Written by the program itself from the tables that --help prints.
add_custom_command(OUTPUT ${manual_stamp}
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:goniolux> -DMANUALS=${manual_folder} -DCOMPLETIONS=${completion_folder}
          -DCHANGELOG=${PROJECT_SOURCE_DIR}/CHANGELOG.md
          -P ${PROJECT_SOURCE_DIR}/cmake/manuals.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${manual_stamp}
  DEPENDS goniolux ${PROJECT_SOURCE_DIR}/cmake/manuals.cmake ${PROJECT_SOURCE_DIR}/CHANGELOG.md VERBATIM)
add_custom_target(manuals DEPENDS ${manual_stamp})
add_dependencies(programs manuals)

set(programs goniolux)
if(TARGET goniolux-studio)
  list(APPEND programs goniolux-studio)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
if(TARGET goniolux-plot)
  install(TARGETS goniolux-plot RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR} COMPONENT programs)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/luminaires ${PROJECT_SOURCE_DIR}/materials DESTINATION ${CMAKE_INSTALL_DATADIR}/goniolux
        COMPONENT programs PATTERN "*.py" EXCLUDE PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/projects/ DESTINATION ${CMAKE_INSTALL_DATADIR}/goniolux/projects COMPONENT programs
        PATTERN "results" EXCLUDE)
install(DIRECTORY ${manual_folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs FILES_MATCHING PATTERN "*.1.gz")
install(FILES ${completion_folder}/goniolux.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME goniolux
        COMPONENT programs)
install(FILES ${completion_folder}/_goniolux DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT programs)
install(FILES ${completion_folder}/goniolux.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
if(TARGET goniolux-studio)
  install(FILES ${PROJECT_SOURCE_DIR}/data/desktop/goniolux-studio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
          COMPONENT programs)
  install(FILES ${PROJECT_SOURCE_DIR}/data/desktop/goniolux-studio.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT programs)
endif()

# Debian's own places for copyright and changelog; elsewhere they are just the documentation.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/goniolux RENAME copyright COMPONENT programs)
install(FILES ${completion_folder}/changelog.gz ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/goniolux
        COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/goniolux/docs COMPONENT programs)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/goniolux-dev RENAME copyright
        COMPONENT development)

# The engine for other programs: find_package(goniolux), target goniolux::pipeline (or a room below it).
foreach(room ${GONIOLUX_ENGINE_ROOMS})
  set_target_properties(goniolux_${room} PROPERTIES EXPORT_NAME ${room})
  install(TARGETS goniolux_${room} EXPORT goniolux ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/goniolux COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/goniolux COMPONENT development
          FILES_MATCHING PATTERN "*.h" PATTERN "vtk" EXCLUDE)
endforeach()
set_target_properties(goniolux_options PROPERTIES EXPORT_NAME options)
install(TARGETS goniolux_options EXPORT goniolux)
install(EXPORT goniolux NAMESPACE goniolux:: FILE goniolux-targets.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/goniolux
        COMPONENT development)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/goniolux-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/goniolux-config.cmake ${CMAKE_BINARY_DIR}/goniolux-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/goniolux COMPONENT development)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME goniolux)
set(CPACK_PACKAGE_CONTACT "The Goniolux founders <goniolux@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lighting-design analysis with an interval on every number")
set(CPACK_PACKAGE_DESCRIPTION "Calculates the light in a room from its geometry, its materials and the photometric
files of its luminaires: illuminance on work planes, glare, and calibrated
images. Every number comes with an interval that holds. Goniolux Studio shows
and edits the same projects.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME goniolux)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "fonts-dejavu-core, libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "weasyprint, fonts-lato")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME goniolux-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libembree-dev, libglm-dev, libopenexr-dev, libfmt-dev, libpugixml-dev, libassimp-dev, libpng-dev, libjpeg-dev, libtiff-dev, libssl-dev, libjsoncpp-dev, liblcms2-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "The engine of Goniolux as libraries, with headers and a CMake package.")
include(CPack)
