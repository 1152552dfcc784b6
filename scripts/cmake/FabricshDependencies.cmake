# Debian packages that fabricsh stands on. Each becomes one INTERFACE target fabricsh_dep_<name>, and
# FabricshRooms.cmake says which room may use which.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(PkgConfig REQUIRED)

# Lua built as C++, so that an error raised in a binding unwinds C++ frames and runs destructors.
pkg_check_modules(LUA REQUIRED IMPORTED_TARGET lua5.4-c++)
pkg_check_modules(EDIT REQUIRED IMPORTED_TARGET libedit)

find_path(UMFPACK_INCLUDE_DIR umfpack.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(UMFPACK_LIBRARY umfpack REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_library(OPENBLAS_LIBRARY openblas REQUIRED)
add_library(fabricsh_dep_suitesparse INTERFACE)
target_include_directories(fabricsh_dep_suitesparse SYSTEM INTERFACE ${UMFPACK_INCLUDE_DIR})
target_link_libraries(fabricsh_dep_suitesparse INTERFACE ${UMFPACK_LIBRARY} ${CHOLMOD_LIBRARY} ${OPENBLAS_LIBRARY})

find_package(VTK 9 REQUIRED COMPONENTS CommonCore CommonDataModel IOCore IOImage IOLegacy IOXML
  RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
