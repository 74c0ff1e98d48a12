# The package under the program's name: find_package(dobbench) is find_package(dob).
set(dob_FIND_COMPONENTS ${dobbench_FIND_COMPONENTS})
foreach(_dobbench_component IN LISTS dobbench_FIND_COMPONENTS)
  set(dob_FIND_REQUIRED_${_dobbench_component} ${dobbench_FIND_REQUIRED_${_dobbench_component}})
endforeach()
include("${CMAKE_CURRENT_LIST_DIR}/../dob/dobConfig.cmake")
set(dobbench_FOUND ${dob_FOUND})
set(dobbench_NOT_FOUND_MESSAGE "${dob_NOT_FOUND_MESSAGE}")
