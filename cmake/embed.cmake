# cmake -DFROM=file -DTO=file.cpp -DHEADER=header.hpp -DSPACE=namespace -DFUNCTION=name -P embed.cmake: the bytes of a file as
# the function that the header declares.
file(READ ${FROM} hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE ${TO} "#include \"${HEADER}\"

namespace ${SPACE} {
namespace {

constexpr unsigned char ${FUNCTION}_bytes[] = {${bytes}};

}  // namespace

std::string_view ${FUNCTION}() {
    return {reinterpret_cast<const char*>(${FUNCTION}_bytes), sizeof ${FUNCTION}_bytes};
}

}  // namespace ${SPACE}
")
