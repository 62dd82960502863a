# A room is a folder of src/ and one static library. Its sources are whatever stands in the folder, so that adding a
# variant is one file and one line in the room's registry.
find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(goniolux_options INTERFACE)
target_compile_options(goniolux_options INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -Wconversion -fopenmp-simd>)
# gcc 12 sees overlapping copies in std::string = "literal" that are not there (gcc bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(goniolux_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
if(GONIOLUX_WERROR)
  target_compile_options(goniolux_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(GONIOLUX_SANITIZE)
  target_compile_options(goniolux_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(goniolux_options INTERFACE -fsanitize=address,undefined)
endif()
if(GONIOLUX_FUZZ)
  target_compile_options(goniolux_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-omit-frame-pointer)
  target_link_options(goniolux_options INTERFACE -fsanitize=address,undefined)
endif()

# goniolux_room(core LIBRARIES fmt::fmt)          target goniolux_core from src/core/*.cpp
# goniolux_room(scene ROOMS core geometry)        ROOMS: the rooms below that it uses
function(goniolux_room name)
  cmake_parse_arguments(ROOM "" "" "ROOMS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  set(rooms ${ROOM_ROOMS})
  list(TRANSFORM rooms PREPEND goniolux_)
  if(sources)
    add_library(goniolux_${name} STATIC ${sources})
    target_include_directories(goniolux_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                      $<INSTALL_INTERFACE:include/goniolux>)
    target_link_libraries(goniolux_${name} PUBLIC ${rooms} ${ROOM_LIBRARIES}
                                           PRIVATE goniolux_options ${ROOM_PRIVATE_LIBRARIES})
  else()
    add_library(goniolux_${name} INTERFACE)
    target_include_directories(goniolux_${name} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                         $<INSTALL_INTERFACE:include/goniolux>)
    target_link_libraries(goniolux_${name} INTERFACE ${rooms} ${ROOM_LIBRARIES})
  endif()
endfunction()

# goniolux_tests(photometry ROOMS photometry)     one test program from the folder's *.cpp
function(goniolux_tests name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "ROOMS;LIBRARIES;LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  if(NOT sources)
    return()
  endif()
  set(rooms ${TEST_ROOMS})
  list(TRANSFORM rooms PREPEND goniolux_)
  add_executable(test_${name} ${sources})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE goniolux_options ${rooms} ${TEST_LIBRARIES} GTest::gtest_main)
  # Where the program's own data and the optional shared validation folder are; tests skip, aloud, what is absent.
  target_compile_definitions(test_${name} PRIVATE GONIOLUX_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    GONIOLUX_BINARY_DIR="${CMAKE_BINARY_DIR}")
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 300)
  endif()
  include(GoogleTest)
  gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST
    PROPERTIES TIMEOUT ${TEST_TIMEOUT} LABELS "${name};${TEST_LABELS}")
endfunction()
