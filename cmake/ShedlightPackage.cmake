# `cpack` makes a Debian package of the program, its manual and the libraries for development.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME shedlight)
set(CPACK_PACKAGE_VENDOR "Shedlight")
set(CPACK_PACKAGE_CONTACT "The Shedlight developers <shedlight@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Evaluates height fields, synthetic or measured by AFM: the response over viewing angle and
wavelength, its peaks, the period of the grating, colours and pictures, each with its error.
The libraries and headers for find_package(shedlight) are in it.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Pictures are drawn by gnuplot, and files of microscopes' makers are read through Gwyddion.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gwyddion")
include(CPack)
