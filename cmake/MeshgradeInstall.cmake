# What `./meshgrade package` packs, and `cmake --install`: a program that may lie anywhere and
# takes nothing but a C++ compiler. Two components: `program`, which a handout takes as well, and
# `home`, the headers, meshes and pages that a handout has at its top.
#
#   bin/meshgrade               the program
#   lib/meshgrade/              the libraries that not every system has in the same version
#   share/meshgrade/kit/        what submissions are linked with
#   share/meshgrade/...         headers, meshes, pages, reference, skeleton

include(GNUInstallDirs)
set(share "${CMAKE_INSTALL_DATAROOTDIR}/meshgrade")

install(TARGETS meshgrade RUNTIME_DEPENDENCY_SET meshgrade_libraries
        RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
# The C and C++ libraries belong to the system, and to its compiler.
install(RUNTIME_DEPENDENCY_SET meshgrade_libraries
        PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|stdc\\+\\+|gcc_s)\\.so"
        LIBRARY DESTINATION lib/meshgrade COMPONENT program)
install(DIRECTORY "${PROJECT_BINARY_DIR}/kit/" DESTINATION "${share}/kit" COMPONENT program
        USE_SOURCE_PERMISSIONS PATTERN "*.gch" EXCLUDE PATTERN "*.partial" EXCLUDE)
install(CODE "set(MESHGRADE_LIBRARIES lib/meshgrade)
              set(MESHGRADE_LICENCES \"${share}/licences\")" COMPONENT program)
install(SCRIPT "${PROJECT_SOURCE_DIR}/cmake/InstallLicences.cmake" COMPONENT program)

# What the program says about itself, for the shells and for man.
foreach(form IN ITEMS bash zsh fish man)
  set(made "${PROJECT_BINARY_DIR}/completions/${form}")
  install(CODE "file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/completions\")
    execute_process(COMMAND \"$<TARGET_FILE:meshgrade>\" completions ${form}
                    OUTPUT_FILE \"${made}\" COMMAND_ERROR_IS_FATAL ANY)" COMPONENT home)
endforeach()
set(made "${PROJECT_BINARY_DIR}/completions")
install(FILES "${made}/man" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" RENAME meshgrade.1
        COMPONENT home)
install(FILES "${made}/bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
        RENAME meshgrade COMPONENT home)
install(FILES "${made}/zsh" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions"
        RENAME _meshgrade COMPONENT home)
install(FILES "${made}/fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d"
        RENAME meshgrade.fish COMPONENT home)

install(DIRECTORY include docs meshes reference student_skeleton DESTINATION "${share}"
        COMPONENT home)
install(FILES LICENSE README.md HANDOUT.md CHANGELOG.md DESTINATION "${share}" COMPONENT home)
install(FILES viewer/dist/viewer.html DESTINATION "${share}/viewer/dist" COMPONENT home)
install(FILES grader/assignment.toml grader/polygon_meshes.toml DESTINATION "${share}/grader" COMPONENT home)
# For the packages that the program writes: handouts and autograders.
install(DIRECTORY grader/package/hosts DESTINATION "${share}/grader/package" COMPONENT home
        USE_SOURCE_PERMISSIONS)
install(PROGRAMS meshgrade DESTINATION "${share}" COMPONENT home)

set(CPACK_PACKAGE_NAME meshgrade)
set(CPACK_PACKAGE_VENDOR "Meshgrade")
set(CPACK_PACKAGE_CONTACT "Meshgrade <meshgrade@localhost>")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/package")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_GENERATOR TGZ DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_INCLUDE_TOPLEVEL_DIRECTORY ON)
set(CPACK_PACKAGE_FILE_NAME "meshgrade-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_DEB_COMPONENT_INSTALL OFF)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libc6 (>= 2.36), libstdc++6 (>= 12), g++ | clang, binutils")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "bubblewrap, gdb")
include(CPack)
