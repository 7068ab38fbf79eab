from lights.picture import WIDTH, brightest, picture


def test_the_light_is_found() -> None:
    assert [brightest(picture(column)) for column in range(WIDTH)] == list(range(WIDTH))
