# Installs the static and the shared library, public headers, a CMake package and a pkg-config file.
include(CMakePackageConfigHelpers)

set(thinbench_package ${CMAKE_INSTALL_LIBDIR}/cmake/thinbench)
install(TARGETS thinbench thinbench_shared EXPORT thinbench
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernels/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT thinbench NAMESPACE thinbench:: FILE thinbenchTargets.cmake DESTINATION ${thinbench_package})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/thinbenchConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/thinbenchConfig.cmake
                              INSTALL_DESTINATION ${thinbench_package})
# Before 1.0 another minor version may be incompatible.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/thinbenchConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/thinbenchConfig.cmake ${PROJECT_BINARY_DIR}/thinbenchConfigVersion.cmake
        DESTINATION ${thinbench_package})

set(thinbench_private_libraries "-lstdc++ -pthread")
if(THINBENCH_WITH_TBB)
  set(thinbench_private_libraries "-ltbb -lstdc++ -pthread")
endif()
file(RELATIVE_PATH thinbench_prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${PROJECT_SOURCE_DIR}/cmake/thinbench.pc.in ${PROJECT_BINARY_DIR}/thinbench.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/thinbench.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
