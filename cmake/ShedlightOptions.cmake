# Flags of this project's own code, kept off its users: link shedlight_options privately.
add_library(shedlight_options INTERFACE)
target_compile_features(shedlight_options INTERFACE cxx_std_20)
# Contraction would make results depend on the instruction set.
target_compile_options(shedlight_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
                       -ffp-contract=off)

# Saves a third of compiling everything once; a build without it is what shows a missing include.
option(SHEDLIGHT_PRECOMPILE "Precompile the headers of other libraries" OFF)
if(SHEDLIGHT_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # In precompiled headers g++ 12 no longer knows the library's own code, and warns of its bounds.
  target_compile_options(shedlight_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow
                         -Wno-stringop-overread)
endif()

option(SHEDLIGHT_WERROR "Treat warnings as errors" OFF)
if(SHEDLIGHT_WERROR)
  # g++ 12 warns of overlapping copies in any "text" + std::string under -O3 (GCC bug 105651).
  target_compile_options(shedlight_options INTERFACE -Werror
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-error=restrict>)
endif()

set(SHEDLIGHT_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")
if(SHEDLIGHT_SANITIZE)
  add_compile_options(-fsanitize=${SHEDLIGHT_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${SHEDLIGHT_SANITIZE})
  # What parses and writes is not optimised then, which takes most of the time of compiling it; the
  # computing lies in evaluation and brdf.
  set(SHEDLIGHT_UNOPTIMISED -O0)
endif()

function(shedlight_precompile target)
  if(SHEDLIGHT_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
