# SPDX-License-Identifier: GPL-3.0-or-later
# Tests under the thread sanitizer with several threads everywhere, and a test that a race is found.
set(environment
  "OMP_NUM_THREADS=3" "OMP_DYNAMIC=false" "OMP_WAIT_POLICY=passive"
  # Uninstrumented libraries (FFTW, OpenMP itself) would be reported, because their locks are unknown.
  "TSAN_OPTIONS=ignore_noninstrumented_modules=1 halt_on_error=1")
set_tests_properties(core PROPERTIES ENVIRONMENT "${environment}")

add_executable(samcontact_race cpp/tests/threads/race.cpp)
target_compile_options(samcontact_race PRIVATE ${samcontact_warnings})
target_link_libraries(samcontact_race PRIVATE samcontact)

add_test(NAME a_race_is_found COMMAND samcontact_race --race)
set_tests_properties(a_race_is_found PROPERTIES
  ENVIRONMENT "${environment}" PASS_REGULAR_EXPRESSION "ThreadSanitizer: data race.*race.cpp")

# Loops without a race pass; Archer reports their barriers to the sanitizer.
add_test(NAME openmp_is_understood COMMAND samcontact_race)
set_tests_properties(openmp_is_understood PROPERTIES
  ENVIRONMENT "${environment};ARCHER_OPTIONS=verbose=1"
  PASS_REGULAR_EXPRESSION "Archer detected OpenMP application with TSan"
  FAIL_REGULAR_EXPRESSION "data race")
