# cmake -DFROM=file -DTO=file.cpp -P embed.cmake: the bytes of a file as dumbbell::page::page_template().
file(READ ${FROM} hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE ${TO} "#include \"page/data.hpp\"

namespace dumbbell::page {
namespace {

constexpr unsigned char page[] = {${bytes}};

}  // namespace

std::string_view page_template() { return {reinterpret_cast<const char*>(page), sizeof page}; }

}  // namespace dumbbell::page
")
