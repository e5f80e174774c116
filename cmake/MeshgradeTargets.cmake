# What every target of our own has in common: language level, warnings, and the
# sanitizers where the preset asks for them.

# The next compiler has new warnings, and whoever builds with it cannot mend them.
set(meshgrade_warnings_are_errors "")
if(MESHGRADE_WARNINGS_ARE_ERRORS)
  set(meshgrade_warnings_are_errors -Werror)
endif()

add_library(meshgrade_options INTERFACE)
target_compile_features(meshgrade_options INTERFACE cxx_std_20)
target_compile_options(meshgrade_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wsuggest-override
  -Wzero-as-null-pointer-constant ${meshgrade_warnings_are_errors})
# False alarms of GCC 12: `"text" + string` as a copy onto itself or beyond its end (told of the
# library's headers once they are precompiled), and with the sanitizers on, values that are never
# set.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(meshgrade_options INTERFACE
    -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
    $<$<BOOL:${MESHGRADE_SANITIZE}>:-Wno-maybe-uninitialized>)
endif()
if(MESHGRADE_FUZZ)
  target_compile_options(meshgrade_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(MESHGRADE_SANITIZE)
  target_compile_options(meshgrade_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(meshgrade_options INTERFACE -fsanitize=address,undefined)
endif()

# meshgrade_precompiled(<name> <headers...>)
#
# Headers that nearly every source of a folder includes, compiled once for its targets, which
# take them by REUSE_FROM. Each source still includes what it uses: clang-tidy reads them without.
function(meshgrade_precompiled name)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Only its precompiled headers are wanted.\n")
  add_library(${name} OBJECT "${source}")
  target_link_libraries(${name} PRIVATE nlohmann_json::nlohmann_json meshgrade_options)
  target_precompile_headers(${name} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <iostream>
    <map> <memory> <optional> <set> <sstream> <string> <string_view> <vector>
    <nlohmann/json.hpp> ${ARGN})
endfunction()

set(MESHGRADE_QUICKLY_COMPILED $<$<CONFIG:Release>:-O1>)

# meshgrade_room(<name> [FAST] SOURCES <files...> [USES <targets...>] [HEADERS <target>])
#
# FAST: it computes much, and is compiled for that. HEADERS: precompiled ones of its own.
#
# One room of the grader is one static library, so that the linker sees the
# one-way dependencies between rooms. Rooms include each other as
# "grader/<room>/<file>.h".
function(meshgrade_room name)
  cmake_parse_arguments(ROOM "FAST" "HEADERS" "SOURCES;USES" ${ARGN})
  add_library(meshgrade_${name} STATIC ${ROOM_SOURCES})
  target_include_directories(meshgrade_${name} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(meshgrade_${name} PUBLIC ${ROOM_USES} PRIVATE meshgrade_options)
  target_compile_features(meshgrade_${name} PUBLIC cxx_std_20)
  if(ROOM_HEADERS)
    target_precompile_headers(meshgrade_${name} REUSE_FROM ${ROOM_HEADERS})
  elseif(ROOM_FAST)
    target_precompile_headers(meshgrade_${name} REUSE_FROM meshgrade_fast_room_headers)
  else()
    target_precompile_headers(meshgrade_${name} REUSE_FROM meshgrade_room_headers)
    target_compile_options(meshgrade_${name} PRIVATE ${MESHGRADE_QUICKLY_COMPILED})
  endif()
  set_target_properties(meshgrade_${name} PROPERTIES
    UNITY_BUILD ${MESHGRADE_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
endfunction()
