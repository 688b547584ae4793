# What `cmake --install` copies, and the Debian package of `cmake --workflow --preset package`.
include(GNUInstallDirs)
install(TARGETS plate-impact)
install(DIRECTORY prm DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY doc DESTINATION ${CMAKE_INSTALL_DOCDIR}
  FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png"
  PATTERN templates EXCLUDE PATTERN make EXCLUDE PATTERN measured EXCLUDE
  PATTERN site EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})

find_program(HELP2MAN help2man DOC "Writes the manual page, Debian package help2man")
if(HELP2MAN)
  add_custom_command(
    OUTPUT plate-impact.1
    COMMAND ${HELP2MAN} --no-info --output plate-impact.1
      --name "impact force of spheres and cylinders on plates, by adaptive finite elements"
      --include ${CMAKE_SOURCE_DIR}/cmake/manual.h2m $<TARGET_FILE:plate-impact>
    DEPENDS plate-impact cmake/manual.h2m
    COMMENT "Writing the manual page")
  add_custom_target(manual ALL DEPENDS plate-impact.1)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/plate-impact.1
    DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The plate-impact developers <plate-impact@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "impact on plates, on a mesh that adapts itself")
set(CPACK_PACKAGE_DESCRIPTION
  "The contact force between a sphere or a cylinder and a plate that it strikes at low
 velocity, with an error bar, on a finite element mesh that adapts itself. Scenes are
 parameter files; those of the course and of the paper are in the documentation.")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # libraries and their versions, by dpkg
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS libopenblas0-serial) # else the slower reference BLAS
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
include(CPack)
