"""The stylesheet and the script of the explorers keep to the rest of the course."""

import re

from course_lib.drawing import style
from course_lib.widgets import explorer

CSS = (explorer.HERE / "explorer.css").read_text(encoding="utf-8")
SCRIPT = str(explorer.Explorer._esm)


def declared(block):
    return dict(re.findall(r"--ce-([\w-]+): (#\w{6});", block))


def luminance(colour):
    """Relative luminance, WCAG 2.2."""
    channels = [c / 255 for c in style.rgb(colour)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return sum(w * c for w, c in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def contrast(one, other):
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


LIGHT, DARK = (declared(block) for block in re.findall(r"\{[^}]*--ce-camera:[^}]*\}", CSS))


def test_a_role_has_its_colour_of_the_course():
    assert {role: LIGHT[role].upper() for role in style.ROLES} == style.ROLES


def test_both_themes_declare_the_same_colours():
    assert set(LIGHT) == set(DARK)


def test_text_is_legible_in_both_themes():
    for theme in (LIGHT, DARK):
        words = [f"{role}-text" for role in (*style.ROLES, "ink")]
        for text in ("quiet", "alarm", *words):
            for ground in ("paper", "panel"):
                assert contrast(theme[text], theme[ground]) >= 4.5, (text, ground)


def test_lines_are_visible_in_the_dark_theme():
    for role in style.ROLES:
        assert contrast(DARK[role], DARK["paper"]) >= 3, role


def test_the_page_loads_nothing_from_elsewhere():
    for text in (CSS, SCRIPT):
        assert not re.search(r"https?:|@import|\bimport\s*\(|\bfetch\(", text)


def test_no_formula_of_the_course_is_in_the_script():
    assert not re.search(r"Math\.(tan|atan|sin|cos|acos|sqrt|hypot|PI|log|exp|pow)", SCRIPT)
