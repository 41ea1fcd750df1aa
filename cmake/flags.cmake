# SPDX-FileCopyrightText: 2026 The Grainproof authors
# SPDX-License-Identifier: BSD-3-Clause
# Flags that every target of ours has. No contraction: the engines are compared bit by bit, so the
# compiler may not fuse a multiplication and an addition where the source does not.
add_library(grainproof_flags INTERFACE)
target_include_directories(grainproof_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(grainproof_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off)
if(GRAINPROOF_SANITIZE)
  target_compile_options(grainproof_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(grainproof_flags INTERFACE -fsanitize=address,undefined)
endif()

# One static library a folder: grainproof_library(NAME SOURCES … LINK … HEADERS a set of precompiled ones of its own)
function(grainproof_library name)
  cmake_parse_arguments(arg "" "HEADERS" "SOURCES;LINK" ${ARGN})
  if(NOT arg_HEADERS)
    set(arg_HEADERS grainproof_precompiled_common)
  endif()
  add_library(grainproof_${name} STATIC ${arg_SOURCES})
  target_link_libraries(grainproof_${name} PUBLIC grainproof_flags ${arg_LINK})
  target_precompile_headers(grainproof_${name} REUSE_FROM ${arg_HEADERS})
endfunction()
