# dob::urdfdom, for the build and for the installed package: urdfdom's own CMake package asks for more than Debian's
# development packages bring, its libraries do not. No such target when one of them is missing.
find_library(URDFDOM_MODEL urdfdom_model)
find_library(CONSOLE_BRIDGE console_bridge)
find_library(TINYXML tinyxml)
find_path(URDFDOM_INCLUDE urdf_parser/urdf_parser.h)
mark_as_advanced(URDFDOM_MODEL CONSOLE_BRIDGE TINYXML URDFDOM_INCLUDE)
if(URDFDOM_MODEL AND CONSOLE_BRIDGE AND TINYXML AND URDFDOM_INCLUDE AND NOT TARGET dob::urdfdom)
  add_library(dob::urdfdom INTERFACE IMPORTED)
  set_target_properties(dob::urdfdom PROPERTIES
    INTERFACE_LINK_LIBRARIES "${URDFDOM_MODEL};${CONSOLE_BRIDGE};${TINYXML}"
    INTERFACE_INCLUDE_DIRECTORIES ${URDFDOM_INCLUDE})
endif()
