# The installed components: the program with its data; photographs, the module for them (CMakeLists.txt); the core for
# C++ users (find_package(fabricsh), component dev). `cpack` makes a Debian package of each.
include(CMakePackageConfigHelpers)
include(${CMAKE_CURRENT_LIST_DIR}/FabricshOwner.cmake)

# The installed data keeps the layout of the source tree, so that one rule finds a file in either.
foreach(folder lua share/cards share/data share/doc share/lua-ls share/python scripts meshes)
  get_filename_component(parent ${folder} DIRECTORY)
  install(DIRECTORY ${folder} DESTINATION ${FABRICSH_DATA_DIR}/${parent} COMPONENT program OPTIONAL
    PATTERN "scripts/cmake" EXCLUDE PATTERN "scripts/demo" EXCLUDE PATTERN "scripts/test" EXCLUDE PATTERN "scripts/sanitize" EXCLUDE PATTERN "scripts/site" EXCLUDE PATTERN "draw.sh" EXCLUDE
    PATTERN "scripts/lib.sh" EXCLUDE PATTERN "lua/LAYERS" EXCLUDE PATTERN "__pycache__" EXCLUDE PATTERN "*.egg-info" EXCLUDE PATTERN "share/python/build" EXCLUDE)
endforeach()
# Where Debian's Python looks, once the prefix is /usr.
install(FILES share/python/fabricsh.py DESTINATION lib/python3/dist-packages COMPONENT program)
install(FILES share/references.bib DESTINATION ${FABRICSH_DATA_DIR}/share COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
install(FILES share/man/fabricsh.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES share/completion/fabricsh.bash RENAME fabricsh
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES share/completion/_fabricsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES share/completion/fabricsh.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT program)

# The core: every room below script, as fabricsh::<room>, headers as <room>/<file>.hpp.
set(FABRICSH_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fabricsh)
set(exported fabricsh_flags)
foreach(target ${FABRICSH_ROOM_TARGETS})
  string(REPLACE "fabricsh_" "" room ${target})
  if(NOT room MATCHES "^(render|script|repl|app)$")
    list(APPEND exported ${target})
    install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fabricsh COMPONENT dev
      FILES_MATCHING PATTERN "*.hpp")
  endif()
endforeach()
foreach(header rheology/list card/laws law/laws)
  get_filename_component(room ${header} DIRECTORY)
  install(FILES ${CMAKE_BINARY_DIR}/generated/${header}.hpp
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fabricsh/${room} COMPONENT dev)
endforeach()
foreach(target ${exported})
  string(REPLACE "fabricsh_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS ${exported} EXPORT fabricshTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(EXPORT fabricshTargets NAMESPACE fabricsh:: DESTINATION ${FABRICSH_CMAKE_DIR} COMPONENT dev)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fabricshConfig.cmake.in
  ${CMAKE_BINARY_DIR}/generated/fabricshConfig.cmake INSTALL_DESTINATION ${FABRICSH_CMAKE_DIR})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/generated/fabricshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/generated/fabricshConfig.cmake ${CMAKE_BINARY_DIR}/generated/fabricshConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FabricshLibraries.cmake DESTINATION ${FABRICSH_CMAKE_DIR} COMPONENT dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fabricsh)
set(CPACK_PACKAGE_CONTACT "${FABRICSH_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${FABRICSH_HOMEPAGE}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "workbench for the mechanics of woven cloth")
set(CPACK_PACKAGE_DESCRIPTION "Pulls, shears, drapes and unloads fabric as a thin shell in finite deformation, from Lua decks or\n an interactive prompt, with a law that knows warp and weft, nonlinearity and hysteresis; reduces\n measurements to material cards.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Not those of whoever builds: with SOURCE_DATE_EPOCH set a package has the same bits each time.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program dev)
if(FABRICSH_PHOTOGRAPHS)
  list(APPEND CPACK_COMPONENTS_ALL photographs)
  set(picture_libraries ", libpng-dev, libjpeg-dev, libtiff-dev")
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fabricsh)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "fabricsh-photographs, gnuplot-nox | gnuplot, xvfb, python3-numpy")
set(CPACK_DEBIAN_PHOTOGRAPHS_PACKAGE_NAME fabricsh-photographs)
set(CPACK_DEBIAN_PHOTOGRAPHS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PHOTOGRAPHS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PHOTOGRAPHS_PACKAGE_DEPENDS "fabricsh (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libfabricsh-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev, libsuitesparse-dev, libopenblas-dev, libvtk9-dev, zlib1g-dev, libdxflib-dev, libxml2-dev${picture_libraries}")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
set(CPACK_COMPONENT_PHOTOGRAPHS_DESCRIPTION "Follows dots and speckles on photographs of cloth: fabric.lab.track and fabric.lab.correlate.")
set(CPACK_COMPONENT_DEV_DESCRIPTION "The core of fabricsh as C++ libraries with headers, for find_package(fabricsh).")
include(CPack)
