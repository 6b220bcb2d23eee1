"""Blocks are shown as text wherever there is no notebook."""

import ipykernel.kernelapp

from course_lib.display import show_block


def test_a_terminal_gets_the_text_also_when_ipykernel_is_loaded(capsys):
    assert ipykernel.kernelapp is not None
    show_block("<b>html</b>", "text")
    assert capsys.readouterr().out == "text\n"
