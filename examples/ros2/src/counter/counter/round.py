"""Round numbers."""


def is_round(number: int) -> bool:
    """Whether a number has one digit that is not zero."""
    return len(str(abs(number)).rstrip("0")) == 1
