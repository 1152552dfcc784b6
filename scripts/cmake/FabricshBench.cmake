# One program per tests/bench/bench_<name>.cpp; never run as a test.
file(GLOB benches CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/bench/bench_*.cpp)
foreach(source ${benches})
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${FABRICSH_ROOM_TARGETS})
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_compile_definitions(${name} PRIVATE FABRICSH_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endforeach()
