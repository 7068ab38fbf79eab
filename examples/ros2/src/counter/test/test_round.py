from counter.round import is_round


def test_round() -> None:
    assert [number for number in range(1, 31) if is_round(number)] == [*range(1, 11), 20, 30]
