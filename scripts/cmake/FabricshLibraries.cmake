# Libraries that come without CMake files in Debian. SuiteSparse and OpenBLAS: one target fabricsh_suitesparse.
find_path(UMFPACK_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(UMFPACK_LIBRARY umfpack REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
if(NOT TARGET fabricsh_suitesparse)
  add_library(fabricsh_suitesparse INTERFACE IMPORTED)
  set_target_properties(fabricsh_suitesparse PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${UMFPACK_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${UMFPACK_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${UMFPACK_LIBRARY};${CHOLMOD_LIBRARY};${OPENBLAS_LIBRARY}")
endif()
# dxflib reads DXF files.
find_path(DXFLIB_INCLUDE_DIR dxflib/dl_dxf.h REQUIRED)
find_library(DXFLIB_LIBRARY dxflib REQUIRED)
if(NOT TARGET fabricsh_dxflib)
  add_library(fabricsh_dxflib INTERFACE IMPORTED)
  set_target_properties(fabricsh_dxflib PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${DXFLIB_INCLUDE_DIR}"
    INTERFACE_INCLUDE_DIRECTORIES "${DXFLIB_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${DXFLIB_LIBRARY}")
endif()
