# SPDX-License-Identifier: Apache-2.0
# What every target of the project is compiled with.

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # What precompiled headers need to be cached.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
endif()

# Exactness rests on these: no fused multiply-add, IEEE doubles in SSE registers.
add_library(quoin_options INTERFACE)
target_compile_options(quoin_options INTERFACE -ffp-contract=off -fno-fast-math)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(quoin_options INTERFACE -march=x86-64-v2)
endif()

add_library(quoin_warnings INTERFACE)
target_compile_options(quoin_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Werror)
# In groups, one file's constants are around another's variables.
target_compile_options(quoin_warnings INTERFACE $<$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>:-Wshadow>)
# Fixed-width integers use the compiler's 128-bit type, which -Wpedantic rejects.
target_compile_options(quoin_warnings INTERFACE -Wno-pedantic)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms on joined std::string temporaries (GCC bug 105651).
  target_compile_options(quoin_warnings INTERFACE -Wno-restrict)
endif()

if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Signs and masks are joined without branches on purpose.
  target_compile_options(quoin_warnings INTERFACE -Wno-bitwise-instead-of-logical)
endif()

# What ccache needs where headers are precompiled.
add_library(quoin_cached_headers INTERFACE)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(quoin_cached_headers INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
else()
  target_compile_options(quoin_cached_headers INTERFACE -fpch-preprocess)
endif()

# For tests and the command, whose time is spent on large headers of others and not in their own loops.
add_library(quoin_quick_build INTERFACE)
target_link_libraries(quoin_quick_build INTERFACE quoin_cached_headers)
target_compile_options(quoin_quick_build INTERFACE $<$<CONFIG:Release>:-O1>)
# Compiling takes longer than running, where every test is compiled again.
if(QUOIN_SANITIZE)
  target_compile_options(quoin_quick_build INTERFACE -O0)
endif()

if(QUOIN_SANITIZE)
  target_compile_options(quoin_options INTERFACE
    -fsanitize=${QUOIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(QUOIN_SANITIZE MATCHES "undefined")
    # A fifth of the time of compiling, for what the address sanitizer finds at the place where memory is touched.
    target_compile_options(quoin_options INTERFACE -fno-sanitize=null,object-size,pointer-overflow,vptr)
  endif()
  target_link_options(quoin_options INTERFACE -fsanitize=${QUOIN_SANITIZE})
  if(QUOIN_SANITIZE MATCHES "address")
    # Descriptions of checks hold 700,000 addresses: to move them took a third of each start of the command.
    target_link_options(quoin_options INTERFACE -no-pie)
  endif()
  target_compile_definitions(quoin_options INTERFACE QUOIN_SANITIZED)
endif()
