# Writes OUTPUT, a C++ source that holds the file FONT.
file(READ ${FONT} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT}
  "#include \"reports/workshop/lettering_font.hpp\"\n\nnamespace kempe::workshop {\n\n"
  "std::span<const unsigned char> lettering_font() {\n  static constexpr unsigned char bytes[] = {${bytes}};\n"
  "  return bytes;\n}\n\n}  // namespace kempe::workshop\n")
