# Debian packages that fabricsh stands on. FabricshRooms.cmake says which room may use which.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(PkgConfig REQUIRED)
find_package(ZLIB REQUIRED)
if(FABRICSH_PHOTOGRAPHS)
  find_package(PNG REQUIRED)
  find_package(JPEG REQUIRED)
  find_package(TIFF REQUIRED)
endif()
# SVG drawings: XML, and the headers of svgpp.
find_package(LibXml2 REQUIRED)
find_path(SVGPP_INCLUDE_DIR svgpp/svgpp.hpp REQUIRED)

# Lua built as C++, so that an error raised in a binding unwinds C++ frames and runs destructors.
pkg_check_modules(LUA REQUIRED IMPORTED_TARGET lua5.4-c++)
set(FABRICSH_LUA "" CACHE FILEPATH "A static Lua library in place of the installed one (scripts/lua_checked)")
if(FABRICSH_LUA)
  set_property(TARGET PkgConfig::LUA PROPERTY INTERFACE_LINK_LIBRARIES ${FABRICSH_LUA} ${CMAKE_DL_LIBS} m)
endif()
pkg_check_modules(EDIT REQUIRED IMPORTED_TARGET libedit)

include(FabricshLibraries)

# Libraries by which the room format reads and writes, which C++ users of the core link too; and those that draw.
set(FABRICSH_VTK_FILES CommonCore CommonDataModel IOCore IOLegacy IOXML)
foreach(folder ${CMAKE_BINARY_DIR} ${CMAKE_SOURCE_DIR}/build)  # unpacked there beside ParaView: scripts/lib.sh
  if(EXISTS ${folder}/vtk/version)
    list(PREPEND CMAKE_PREFIX_PATH ${folder}/vtk/usr)
    break()
  endif()
endforeach()
find_package(VTK 9 REQUIRED COMPONENTS ${FABRICSH_VTK_FILES}
  FiltersGeometry IOImage RenderingAnnotation RenderingCore RenderingFreeType RenderingOpenGL2)
