# Headers that are parsed once and read by all sources: parsing the standard library and Eigen takes six of ten
# parts of the time of a source. Every source still includes what it uses; builds without (.ci/also arm64) find what
# one forgot.
set(precompiled_headers
  <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <numbers> <numeric> <optional> <set>
  <span> <sstream> <string> <string_view> <unordered_map> <utility> <variant> <vector> <Eigen/Dense>)

# fabricsh_precompile(target owner header...): the target reads what the owner precompiles, which are these headers
# and those above; the owner itself is the first to be named.
function(fabricsh_precompile target owner)
  if(NOT FABRICSH_PRECOMPILE OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # the only compiler that it was tried with
    return()
  endif()
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${precompiled_headers} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
  # GCC forgets for precompiled headers that they are the system's, and is wrong about std::string in them.
  target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds -Wno-stringop-overread)
endfunction()

# Several sources of a target are compiled as one: what they all include is parsed, and what they all instantiate is
# compiled, once for each batch. Names in unnamed namespaces must then differ within a room.
function(fabricsh_unite target)
  if(FABRICSH_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()
