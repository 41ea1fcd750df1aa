# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Headers of other libraries that nearly every file reads, compiled once: two thirds of a build's time went into them.
# Every file still includes what it uses, and a build with ccache, which keeps results instead, does without.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(common_headers <Eigen/Dense> <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory>
  <numbers> <optional> <span> <sstream> <string> <variant> <vector>)

# grainproof_precompiled(NAME LINK … HEADERS … OPTIONS …): a set that targets take by
# target_precompile_headers(… REUSE_FROM NAME); a target with other options of the compiler needs a set with the same.
function(grainproof_precompiled name)
  cmake_parse_arguments(arg "" "" "LINK;HEADERS;OPTIONS" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(${name} PRIVATE grainproof_flags Eigen3::Eigen ${arg_LINK})
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${common_headers} ${arg_HEADERS})
endfunction()

grainproof_precompiled(grainproof_precompiled_common)
