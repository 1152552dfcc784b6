# One static library fabricsh_<room> per line of src/LAYERS, linked to the rooms that the line names.
add_library(fabricsh_flags INTERFACE)
target_include_directories(fabricsh_flags INTERFACE
  $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/src> $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/generated>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/fabricsh>)
target_compile_features(fabricsh_flags INTERFACE cxx_std_20)
# GNU: a constructor may name its arguments as its members; -Wrestrict is wrong about std::string in GCC 12.
set(own_options -Wall -Wextra -Wpedantic -Wno-psabi -fno-math-errno
  "$<IF:$<CXX_COMPILER_ID:GNU>,-Wshadow=local;-Wno-restrict,-Wshadow>"
  $<$<BOOL:${FABRICSH_WERROR}>:-Werror>
  "$<$<BOOL:${FABRICSH_SANITIZE}>:-fsanitize=address,undefined;-fno-omit-frame-pointer>"
  "$<$<BOOL:${FABRICSH_FUZZ}>:-fsanitize=fuzzer-no-link,address,undefined;-fno-sanitize-recover=undefined;-fno-omit-frame-pointer>")
target_compile_options(fabricsh_flags INTERFACE "$<BUILD_INTERFACE:${own_options}>")
# Sums are rounded as written, the same on every machine; the kernels of an instruction set with fused
# multiply-add use it.
target_compile_options(fabricsh_flags INTERFACE
  "$<BUILD_INTERFACE:$<$<NOT:$<BOOL:$<TARGET_PROPERTY:FABRICSH_FUSED>>>:-ffp-contract=off>>")
target_link_options(fabricsh_flags INTERFACE
  $<BUILD_INTERFACE:$<$<OR:$<BOOL:${FABRICSH_SANITIZE}>,$<BOOL:${FABRICSH_FUZZ}>>:-fsanitize=address,undefined>>)
target_link_libraries(fabricsh_flags INTERFACE Eigen3::Eigen OpenMP::OpenMP_CXX)

# Sources named *_isa.cpp hold the batch kernels: compiled once per instruction set, each into its own
# namespace (FABRICSH_ISA), and chosen at run time by simd/isa.hpp.
function(fabricsh_isa_sources target)
  foreach(source ${ARGN})
    get_filename_component(stem ${source} NAME_WE)
    set(sets baseline)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
      list(APPEND sets avx2 avx512)
    endif()
    foreach(isa ${sets})
      set(lib ${target}_${stem}_${isa})
      add_library(${lib} OBJECT ${source})
      target_link_libraries(${lib} PRIVATE fabricsh_flags)
      target_compile_definitions(${lib} PRIVATE FABRICSH_ISA=${isa})
      if(isa STREQUAL "avx2")
        target_compile_options(${lib} PRIVATE -mavx2 -mfma)
      elseif(isa STREQUAL "avx512")
        target_compile_options(${lib} PRIVATE -mavx512f -mavx512dq -mavx512vl -mavx512bw -mfma -mprefer-vector-width=512)
      endif()
      # Those of contact give the bits of a single pair, which is computed elsewhere.
      if(NOT isa STREQUAL "baseline" AND NOT target STREQUAL "fabricsh_contact")
        target_compile_options(${lib} PRIVATE -ffp-contract=fast)
        set_target_properties(${lib} PROPERTIES FABRICSH_FUSED ON)
      endif()
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${lib}>)
      set_property(GLOBAL APPEND PROPERTY FABRICSH_KERNELS_${isa} ${lib})
    endforeach()
  endforeach()
endfunction()

# The folders NAME of a room that hold a header NAME/NAME.hpp: `includes`, a line for each, and `names`, X(NAME) for each.
function(fabricsh_folders room)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/src/${room} src/${room}/*/*.hpp)
  set(includes)
  set(names)
  foreach(header ${headers})
    get_filename_component(name ${header} NAME_WE)
    if(header STREQUAL "${name}/${name}.hpp")
      string(APPEND includes "#include \"${room}/${header}\"\n")
      string(APPEND names " X(${name})")
    endif()
  endforeach()
  set(includes "${includes}" PARENT_SCOPE)
  set(names "${names}" PARENT_SCOPE)
endfunction()

# generated/mechanics/loads.hpp: the loads of a model that have a file of their own.
function(fabricsh_loads)
  file(GLOB files CONFIGURE_DEPENDS src/mechanics/terms/loads/*.cpp)
  set(names)
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    string(APPEND names " X(${name})")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/mechanics/loads.hpp CONTENT
    "// The files of terms/loads, by the build.\n#pragma once\n#define FABRICSH_LOADS(X)${names}\n" @ONLY)
endfunction()

# generated/rheology/list.hpp: the rheological elements, one in each folder of the room. generated/card/laws.hpp:
# the names of the laws that take the woven card, one in each folder of the room law; generated/law/laws.hpp: the
# laws themselves.
function(fabricsh_material_folders)
  fabricsh_folders(rheology)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/rheology/list.hpp CONTENT
    "// The folders of the room rheology, by the build.\n#pragma once\n${includes}#define FABRICSH_RHEOLOGY(X)${names}\n" @ONLY)
  fabricsh_folders(law)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/card/laws.hpp CONTENT
    "// The folders of the room law, by the build.\n#pragma once\n#define FABRICSH_WOVEN_LAWS(X)${names}\n" @ONLY)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/law/laws.hpp CONTENT
    "// The folders of the room law, by the build.\n#pragma once\n#include \"card/laws.hpp\"\n${includes}" @ONLY)
endfunction()

# Rooms that no run waits for: declarations, tables of options, files, the border to Lua, the prompt, figures. They
# are compiled with -O1; bits are the same, since sums are rounded as written. GCC keeps the options of a precompiled header, so that they
# have one of their own.
set(calm card model format plot script repl app)

function(fabricsh_rooms layers)
  set(targets)
  file(STRINGS ${layers} lines REGEX "^[a-z]+:")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${layers})
  foreach(line ${lines})
    string(REGEX MATCH "^([a-z]+):(.*)$" _ "${line}")
    set(room ${CMAKE_MATCH_1})
    separate_arguments(needs UNIX_COMMAND "${CMAKE_MATCH_2}")
    if(room STREQUAL "photograph" AND NOT FABRICSH_PHOTOGRAPHS)
      continue()
    endif()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/${room}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "main\\.cpp$")
    set(kernels ${sources})
    list(FILTER kernels INCLUDE REGEX "_isa\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "_isa\\.cpp$")
    if(sources OR kernels)
      add_library(fabricsh_${room} STATIC ${sources})
      set_target_properties(fabricsh_${room} PROPERTIES LINKER_LANGUAGE CXX)
      if(NOT room STREQUAL "render")  # its names for points are those of the libraries that it draws with
        fabricsh_unite(fabricsh_${room})
      endif()
      target_link_libraries(fabricsh_${room} PUBLIC fabricsh_flags)
      if(room IN_LIST calm AND CMAKE_BUILD_TYPE STREQUAL "Release")
        target_compile_options(fabricsh_${room} PRIVATE -O1)
        list(APPEND calm_targets fabricsh_${room})
      elseif(sources)
        fabricsh_precompile(fabricsh_${room} fabricsh_base)
      endif()
      fabricsh_isa_sources(fabricsh_${room} ${kernels})
      set(kind PUBLIC)
    else()
      add_library(fabricsh_${room} INTERFACE)
      target_link_libraries(fabricsh_${room} INTERFACE fabricsh_flags)
      set(kind INTERFACE)
    endif()
    foreach(need ${needs})
      target_link_libraries(fabricsh_${room} ${kind} fabricsh_${need})
    endforeach()
    list(APPEND targets fabricsh_${room})
  endforeach()
  foreach(target ${calm_targets})
    fabricsh_precompile(${target} fabricsh_plot)  # which has no definitions of libraries
  endforeach()
  set(FABRICSH_ROOM_TARGETS ${targets} PARENT_SCOPE)
  # The only rooms that may see a third-party library.
  fabricsh_room_uses(linear PRIVATE fabricsh_suitesparse)
  fabricsh_room_uses(format PRIVATE VTK::CommonCore VTK::CommonDataModel VTK::IOCore VTK::IOXML ZLIB::ZLIB
    fabricsh_dxflib LibXml2::LibXml2)
  fabricsh_room_uses(lab PRIVATE ${CMAKE_DL_LIBS})
  if(TARGET fabricsh_photograph)
    fabricsh_room_uses(photograph PRIVATE PNG::PNG JPEG::JPEG TIFF::TIFF)
  endif()
  fabricsh_room_uses(render PRIVATE VTK::CommonCore VTK::CommonDataModel VTK::IOImage VTK::IOXML
    VTK::FiltersGeometry VTK::RenderingAnnotation VTK::RenderingCore VTK::RenderingFreeType VTK::RenderingOpenGL2)
  fabricsh_room_uses(script PUBLIC PkgConfig::LUA)
  fabricsh_room_uses(repl PRIVATE PkgConfig::EDIT)
endfunction()

function(fabricsh_room_uses room visibility)
  get_target_property(type fabricsh_${room} TYPE)
  if(NOT type STREQUAL "INTERFACE_LIBRARY")
    target_link_libraries(fabricsh_${room} ${visibility} ${ARGN})
  endif()
endfunction()
