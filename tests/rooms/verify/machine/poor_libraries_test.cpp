// A program of its own, because its zlib gets no memory.
#include "catch.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "verify/input/bytes.hpp"

using namespace dumbbell_verify;

extern "C" int inflate(z_streamp /*stream*/, int /*flush*/) { return Z_MEM_ERROR; }

TEST_CASE("a compressed file is not called damaged where there is no memory to unpack it") {
    const make::File file(make::gzipped("dumbbell-certificate 1\n"));
    Bytes bytes(file.path());
    CHECK_THROWS_AS(bytes.next(1), std::bad_alloc);
}
