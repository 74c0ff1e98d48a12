# What is installed, and the package that finds it. Components of `cmake --install`: program (dobbench, its data, manual
# page, completion), observer_api (what an observer's author needs), development (the rooms).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/dob)
configure_package_config_file(cmake/dobConfig.cmake.in ${PROJECT_BINARY_DIR}/dobConfig.cmake INSTALL_DESTINATION ${package_dir})
foreach(name dob dobbench)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/${name}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/dobConfig.cmake ${PROJECT_BINARY_DIR}/dobConfigVersion.cmake cmake/urdfdom.cmake
        DESTINATION ${package_dir} COMPONENT observer_api)
install(FILES cmake/dobbenchConfig.cmake ${PROJECT_BINARY_DIR}/dobbenchConfigVersion.cmake
        DESTINATION ${package_dir}bench COMPONENT observer_api)

# Every room as a package component of its own, so that each asks only for the libraries that it uses.
install(EXPORT dob_observer_api NAMESPACE dob:: FILE dob-observer_api.cmake DESTINATION ${package_dir}
        COMPONENT observer_api)
foreach(room robot observers controller sim scenarios results bench)
  install(TARGETS dob_${room} EXPORT dob_${room} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT dob_${room} NAMESPACE dob:: FILE dob-${room}.cmake DESTINATION ${package_dir} COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/dobbench/${room}
          COMPONENT development FILES_MATCHING PATTERN "*.h" REGEX "/${room}/[^/.]+$" EXCLUDE
          REGEX "/bench/(command.*|completion|manual)\\.h$" EXCLUDE)  # of the program, not of the room
endforeach()

# The program; its data as in the source tree (scenarios/data_root.h).
set(data_dir ${CMAKE_INSTALL_DATADIR}/dobbench)
install(TARGETS dobbench RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY scenarios/ DESTINATION ${data_dir}/scenarios COMPONENT program FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY robot/ DESTINATION ${data_dir}/robot COMPONENT program FILES_MATCHING PATTERN "*.urdf")
install(FILES results/paper_claims.toml results/paper_figures.toml DESTINATION ${data_dir}/results COMPONENT program)
install(FILES results/report/template.html DESTINATION ${data_dir}/results/report COMPONENT program)
install(FILES LICENSE NOTICE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# What is written by the program itself. (A program under a sanitizer is not installed.)
if(NOT DOB_SANITIZE)
  set(help_dir ${PROJECT_BINARY_DIR}/help)
  file(MAKE_DIRECTORY ${help_dir})
  add_custom_command(OUTPUT ${help_dir}/dobbench.1.gz ${help_dir}/dobbench ${help_dir}/_dobbench
    COMMAND dobbench manual | gzip -9n > ${help_dir}/dobbench.1.gz
    COMMAND dobbench completion bash > ${help_dir}/dobbench
    COMMAND dobbench completion zsh > ${help_dir}/_dobbench
    DEPENDS dobbench VERBATIM)
  add_custom_target(dob_help ALL DEPENDS ${help_dir}/dobbench.1.gz)
  install(FILES ${help_dir}/dobbench.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${help_dir}/dobbench DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  install(FILES ${help_dir}/_dobbench DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
endif()
