set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Equal bits on every machine: one instruction baseline, and no fused multiply-add but where it is written.
add_compile_options(-march=x86-64-v3 -mtune=generic -ffp-contract=off)
# GCC 12 turns two neighbouring doubles that are rounded to float and widened again back into themselves, where
# straight-line code is vectorised: (double)(float)x is then x (tests/deformation/test_split_points.cpp).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fno-tree-slp-vectorize)
endif()

add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(DRAPE_WARNINGS_AS_ERRORS)
  add_compile_options(-Werror)
endif()

# Positions are the state that a hash covers: asserts stay in every build type but Release.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
