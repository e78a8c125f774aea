# The ctest test "installed package"; included by tests/CMakeLists.txt.
set(consumer_flags "")
if(SHEDLIGHT_SANITIZE)
  set(consumer_flags "-fsanitize=${SHEDLIGHT_SANITIZE}")
endif()
add_test(NAME "installed package"
  COMMAND ${CMAKE_COMMAND} -DBUILD_DIR=${PROJECT_BINARY_DIR}
          -DWORK_DIR=${CMAKE_CURRENT_BINARY_DIR}/install -DCONFIG=$<CONFIG>
          -DGENERATOR=${CMAKE_GENERATOR} -DCXX=${CMAKE_CXX_COMPILER}
          "-DCXX_FLAGS=${consumer_flags}" -P ${CMAKE_CURRENT_LIST_DIR}/consume.cmake)
set_tests_properties("installed package" PROPERTIES TIMEOUT 600)
