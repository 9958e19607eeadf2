# Installs the static and the shared library, public headers, a CMake package and a pkg-config file; the program, if it
# is built, with its manual page and shell completion. The components are packages: cmake/packages.cmake.
include(CMakePackageConfigHelpers)

# Before anything else, so that no half of a prefix remains.
set(thinbench_installed thinbench thinbench_shared)
if(TARGET thinbench_program)
  list(APPEND thinbench_installed thinbench_program)
endif()
list(JOIN thinbench_installed " " thinbench_installed_text)
foreach(target ${thinbench_installed})
  install(CODE "
    if(NOT EXISTS \"$<TARGET_FILE:${target}>\")
      message(FATAL_ERROR \"${target} is not built; first run: cmake --build ${PROJECT_BINARY_DIR} --target ${thinbench_installed_text}\")
    endif()" ALL_COMPONENTS)
endforeach()

# As Debian expects it.
function(thinbench_install_license component package)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE COMPONENT ${component} RENAME copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} ${ARGN})
endfunction()

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
thinbench_install_license(development libthinbench-dev)
if(TARGET thinbench_program)
  thinbench_install_license(program thinbench)
  install(TARGETS thinbench_program COMPONENT program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(FILES ${PROJECT_SOURCE_DIR}/tools/manual/thinbench.1 COMPONENT program DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${PROJECT_SOURCE_DIR}/tools/manual/thinbench.bash-completion COMPONENT program RENAME thinbench
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()
if(THINBENCH_BUILD_PYTHON)
  # Only as a package; everyone else takes the wheel.
  thinbench_install_license(python python3-thinbench EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/thinbench COMPONENT python EXCLUDE_FROM_ALL
          DESTINATION lib/python3/dist-packages PATTERN __pycache__ EXCLUDE)
endif()

set(thinbench_package ${CMAKE_INSTALL_LIBDIR}/cmake/thinbench)
install(TARGETS thinbench thinbench_shared EXPORT thinbench
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernels/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT thinbench NAMESPACE thinbench:: FILE thinbenchTargets.cmake DESTINATION ${thinbench_package})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/thinbenchConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/thinbenchConfig.cmake
                              INSTALL_DESTINATION ${thinbench_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/thinbenchConfigVersion.cmake
                                 COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/thinbenchConfig.cmake ${PROJECT_BINARY_DIR}/thinbenchConfigVersion.cmake
        DESTINATION ${thinbench_package})

set(thinbench_private_libraries "-lstdc++ -lm -pthread")
if(THINBENCH_WITH_TBB)
  set(thinbench_private_libraries "-ltbb -lstdc++ -lm -pthread")
endif()
file(RELATIVE_PATH thinbench_prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/thinbench.pc.in ${PROJECT_BINARY_DIR}/thinbench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/thinbench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the check above says what to build
  include(${PROJECT_SOURCE_DIR}/cmake/packages.cmake)
endif()
