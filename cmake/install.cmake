# Installs the static and the shared library, public headers, a CMake package and a pkg-config file; the program, if it
# is built, with its manual page and shell completion. The components are packages: cmake/packages.cmake.
include(CMakePackageConfigHelpers)

# Before anything else, so that no half of a prefix remains.
function(thinbench_require_built component target file)
  install(CODE "
    if(NOT EXISTS \"${file}\")
      message(FATAL_ERROR \"${target} is not built; first run: cmake --build ${CMAKE_BINARY_DIR} --target ${target}\")
    endif()" COMPONENT ${component} ${ARGN})
endfunction()
thinbench_require_built(development thinbench $<TARGET_FILE:thinbench>)
thinbench_require_built(development thinbench_shared $<TARGET_FILE:thinbench_shared>)
if(TARGET thinbench_program)
  thinbench_require_built(program thinbench_program $<TARGET_FILE:thinbench_program>)
endif()
if(THINBENCH_BUILD_PYTHON)
  thinbench_require_built(python thinbench_python
                          ${PROJECT_BINARY_DIR}/python/thinbench/libthinbench${CMAKE_SHARED_LIBRARY_SUFFIX} EXCLUDE_FROM_ALL)
endif()

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
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})  # the DLL of Windows
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
if(APPLE)
  set(thinbench_private_libraries "-lc++")
elseif(WIN32)
  string(APPEND thinbench_private_libraries " -lsynchronization")
endif()
if(THINBENCH_WITH_TBB)
  string(PREPEND thinbench_private_libraries "-ltbb ")
endif()
# Relative, so that what was installed may be moved.
file(RELATIVE_PATH thinbench_prefix_from_pkgconfig ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH thinbench_includedir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(RELATIVE_PATH thinbench_libdir ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
configure_file(${PROJECT_SOURCE_DIR}/cmake/thinbench.pc.in ${PROJECT_BINARY_DIR}/thinbench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/thinbench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # the check above says what to build
  include(${PROJECT_SOURCE_DIR}/cmake/packages.cmake)
endif()
