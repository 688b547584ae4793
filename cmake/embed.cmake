# Writes text files into a C++ source as constants of one namespace.
#
#   cmake -DOUTPUT=... -DNAMES="a,b" -DFILES="x.html,y.css" -P embed.cmake
#
# Pieces of a raw string stay below the length that every compiler takes.

string(REPLACE "," ";" names "${NAMES}")
string(REPLACE "," ";" files "${FILES}")
set(source "#include \"page/page_assets.h\"\n\nnamespace PlateImpact::PageAssets\n{\n")
foreach(name file IN ZIP_LISTS names files)
  file(READ "${file}" text)
  string(LENGTH "${text}" length)
  set(pieces "")
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${text}" ${begin} 16000 piece)
    string(APPEND pieces "R\"asset(${piece})asset\"\n")
    math(EXPR begin "${begin} + 16000")
  endwhile()
  string(APPEND source "const std::string_view ${name} =\n${pieces};\n")
endforeach()
string(APPEND source "}\n")
file(WRITE "${OUTPUT}" "${source}")
