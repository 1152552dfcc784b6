# generated/fabricsh_config.hpp: version, and how the program finds its data from where it stands.
set(FABRICSH_DATA_DIR ${CMAKE_INSTALL_DATADIR}/fabricsh)
file(RELATIVE_PATH FABRICSH_DATA_FROM_PROGRAM
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/fabricsh)
set(FABRICSH_MODULE_DIR ${CMAKE_INSTALL_LIBDIR}/fabricsh)
file(RELATIVE_PATH FABRICSH_MODULES_FROM_PROGRAM
  ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/fabricsh)
configure_file(${CMAKE_CURRENT_LIST_DIR}/fabricsh_config.hpp.in ${CMAKE_BINARY_DIR}/generated/fabricsh_config.hpp @ONLY)
# A program that still stands in the build folder (or in a folder of it) finds the source tree by this file.
file(WRITE ${CMAKE_BINARY_DIR}/fabricsh.home ${CMAKE_SOURCE_DIR})
