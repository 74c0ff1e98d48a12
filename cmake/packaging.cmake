# Debian packages, by `make package`: dobbench (the program, its data, manual page, completion) and dobbench-dev (headers,
# archives and CMake package for those who write observers or use the rooms).
set(DOB_MAINTAINER "dobbench maintainers <maintainers@dobbench.example>" CACHE STRING "Maintainer of the Debian packages")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME dobbench)
set(CPACK_PACKAGE_CONTACT ${DOB_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME dobbench)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "dobbench runs disturbance observers on a torque-controlled quadruped that
trots in the Open Dynamics Engine, in closed loop with a whole-body
controller that compensates what they estimate, and prints the comparison:
CoM and foot errors, force tracking, falls.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME dobbench-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "dobbench (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "cmake, g++, libode-dev, libfmt-dev, liburdfdom-dev, liburdfdom-headers-dev, libconsole-bridge-dev, libtinyxml-dev, libtomlplusplus-dev, libsqlitecpp-dev, libsqlite3-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Headers and archives: what an observer written elsewhere compiles and links
against (CMake package dob, target dob::observer_api), and the rooms of
dobbench: robot model, observers, controller, simulation, scenarios, results.")
# Licences and changes where Debian looks for them.
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/changelog.gz DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md VERBATIM
  COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${PROJECT_BINARY_DIR}/changelog.gz)
add_custom_target(dob_changelog ALL DEPENDS ${PROJECT_BINARY_DIR}/changelog.gz)
foreach(package_and_component dobbench:program dobbench-dev:development)
  string(REPLACE ":" ";" pair ${package_and_component})
  list(GET pair 0 package)
  list(GET pair 1 component)
  install(FILES cmake/debian-copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright
          COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
          COMPONENT ${component})
endforeach()

include(CPack)
cpack_add_component_group(program)
cpack_add_component_group(dev)
cpack_add_component(program GROUP program)
cpack_add_component(observer_api GROUP dev)
cpack_add_component(development GROUP dev)
