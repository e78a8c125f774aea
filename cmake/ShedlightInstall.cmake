include(CMakePackageConfigHelpers)

install(TARGETS shedlight_brdf shedlight_kernels shedlight_evaluation EXPORT shedlightTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/shedlight)
if(TARGET shedlight)
  install(TARGETS shedlight RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(EXPORT shedlightTargets NAMESPACE shedlight::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shedlight)

configure_package_config_file(cmake/shedlightConfig.cmake.in
        ${CMAKE_CURRENT_BINARY_DIR}/shedlightConfig.cmake
        INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shedlight)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/shedlightConfigVersion.cmake
        COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/shedlightConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/shedlightConfigVersion.cmake
              cmake/FindFFTW3.cmake
              cmake/FindLibZip.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/shedlight)
