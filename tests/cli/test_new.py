def fill(folder):
    case = folder / "case.toml"
    text = case.read_text()
    for blank, filled in (
        ('title     = ""', 'title     = "A mass in free fall"'),
        ('reference = ""', 'reference = "Galilei, G. (1638). Discorsi."'),
        ('because = ""', 'because = "the error budget"'),
    ):
        assert blank in text
        text = text.replace(blank, filled)
    case.write_text(text)


def test_a_new_case_is_accepted_once_it_is_filled_in(here, vm):
    code, printed, _ = vm("new", "MY-01")
    assert code == 0
    assert "cases/MY-01/deck.k" in printed
    code, printed, _ = vm("check", "MY-01")
    assert code == 4
    assert "title" in printed

    fill(here / "cases" / "MY-01")
    code, printed, _ = vm("check", "MY-01")
    assert (code, "MY-01: ok" in printed) == (0, True)
    assert "doubtful" not in printed
    code, printed, _ = vm("run", "MY-01")
    assert code == 0
    assert "1 pass" in printed
    assert (here / "reports" / "MY-01" / "README.md").read_text().startswith("# MY-01: A mass in free fall")


def test_a_new_case_notices_its_faults(here, vm):
    vm("new", "MY-01")
    fill(here / "cases" / "MY-01")
    deck = here / "cases" / "MY-01" / "deck.k"
    deck.write_text(deck.read_text().replace("RG             9.81", "RG            9.811"))
    assert vm("run", "MY-01")[0] == 1


def test_a_folder_that_exists_is_left_alone(here, vm):
    (here / "cases" / "MY-01").mkdir()
    code, _, complaint = vm("new", "MY-01")
    assert code == 4
    assert "exists already" in complaint
    assert not any((here / "cases" / "MY-01").iterdir())


def test_an_id_is_a_plain_name(here, vm):
    for id in ("../x", "a b", ""):
        assert vm("new", id)[0] == 4
