"""What the lab says: lines that fit, in the words of a notebook."""

from course_lib.lab.words import WIDTH, say, sentence


def test_lines_are_folded_between_words(capsys):
    text = "Fine: the board is where it should be. " * 8
    say(f"one\n{text}")
    first, *rest = capsys.readouterr().out.splitlines()
    assert first == "one"
    assert max(map(len, rest)) <= WIDTH
    assert " ".join(" ".join(rest).split()) == text.strip()


def test_options_are_names_of_a_notebook():
    assert (
        sentence("is it --board 9x6? Or another --square")
        == "Is it Checkerboard(9, 6)? Or another `square`."
    )
