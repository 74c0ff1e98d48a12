# dob::observer_api: what an observer built as a plugin compiles and links against.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(fmt)
include(${CMAKE_CURRENT_LIST_DIR}/dobbenchTargets.cmake)
