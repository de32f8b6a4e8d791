"""The bytes of a file, unpacked if they are compressed."""

import os
import stat
import zlib

from failure import Limit, Rejected, Unreadable

GREATEST_TEXT = 1 << 28


def read(path):
    """The bytes of a file, `-` is the standard input; no more than those that may be judged, and one."""
    try:
        # A pipe with a name would be waited for, even if nobody writes to it.
        if path != "-" and not path.startswith(("/dev/", "/proc/")) and stat.S_ISFIFO(os.stat(path).st_mode):
            raise Unreadable("a named pipe: give `-` and let the shell redirect it", 0)
        with open(0 if path == "-" else path, "rb", closefd=path != "-") as file:
            return file.read(GREATEST_TEXT + 1)
    except OSError as error:
        raise Unreadable(error.strerror or str(error), 0) from None


def unpacked(data):
    """The text, which may be one gzip member, as far as it can be had; and the failure with which it ends there, or None."""
    if data[:2] == b"\x1f\x8b":
        member, text = zlib.decompressobj(wbits=31), bytearray()
        try:
            for begin in range(0, len(data), 4096):  # so that what comes before damage is had
                text += member.decompress(data[begin:begin + 4096], GREATEST_TEXT + 1 - len(text))
                if len(text) > GREATEST_TEXT:
                    break
        except zlib.error:
            return text, Rejected(None, "gzip", "the compressed file is damaged")
        data = text
        if len(text) <= GREATEST_TEXT and not member.eof:
            return text, Rejected(None, "gzip", "the compressed file is truncated")
        if member.unused_data:
            return text, Rejected(None, "gzip", "bytes after the gzip member")
    return data, Limit(f"a text of more than {GREATEST_TEXT >> 20} MiB") if len(data) > GREATEST_TEXT else None
