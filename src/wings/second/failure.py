"""Why a file is not verified."""

# Each verdict with its exit code. Of several files the last of these counts.
VERDICTS = {"VERIFIED": 0, "UNREADABLE": 2, "OPEN": 3, "UNSUPPORTED": 3, "LIMIT": 4, "REJECTED": 1}


class Failure(Exception):
    """`line` is the number of the line that is at fault: 0 if there is none, None if it is the one read last."""

    def __init__(self, text, line=None):
        super().__init__(text)
        self.line = line


class Rejected(Failure):
    """What the format does not allow, or what is not proved; `code` is a word for it."""

    verdict = "REJECTED"

    def __init__(self, line, code, text):
        super().__init__(text, line)
        self.code = code


class Unsupported(Failure):
    """A foreign version, claim kind, scene, section or lemma set."""

    verdict = "UNSUPPORTED"


class Limit(Failure):
    """More work or memory than this program is willing to spend."""

    verdict = "LIMIT"


class Unreadable(Failure):
    """No bytes, or a question that cannot be asked of this file."""

    verdict = "UNREADABLE"
