# Writes text files into a C++ source as constants of one namespace.
#
#   cmake -DOUTPUT=... -DNAMES="a,b,b" -DFILES="x.html,y.js,z.js" -P embed.cmake
#
# Files of one name, next to each other, are one constant. Pieces of a raw string stay
# below the length that every compiler takes.

string(REPLACE "," ";" names "${NAMES}")
string(REPLACE "," ";" files "${FILES}")
set(source "#include <string_view>\n\nnamespace PlateImpact::PageAssets\n{\n")
set(last "")
foreach(name file IN ZIP_LISTS names files)
  if(NOT name STREQUAL last)
    if(last)
      string(APPEND source ";\n")
    endif()
    string(APPEND source "extern const std::string_view ${name};\nconst std::string_view ${name} =\n")
    set(last "${name}")
  endif()
  file(READ "${file}" text)
  string(LENGTH "${text}" length)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} 16000 piece)
    string(APPEND source "R\"asset(${piece})asset\"\n")
    math(EXPR begin "${begin} + 16000")
  endwhile()
endforeach()
string(APPEND source ";\n}\n")
file(WRITE "${OUTPUT}" "${source}")
