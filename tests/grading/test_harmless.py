"""What students write in words is looked at in a browser that may give points: it must not run."""

import base64
import re
from pathlib import Path

import nbformat
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from nbconvert.filters.markdown_mistune import IPythonRenderer, MarkdownWithMath
from nbconvert.filters.strings import strip_files_prefix
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_raw_cell

from course_lib.grading.harmless import AS_TYPED, as_typed, disarm, is_harmless

NOTEBOOKS = sorted(Path(__file__).parents[2].glob("notebooks/*/*.ipynb"))
DOT = base64.b64encode(b"dots").decode()
ORDINARY = [
    "Rays meet at a point, *so* `a < b` and $a<b$; see <https://example.org> & H<sub>2</sub>O.",
    "# A heading\n\n1. one\n2. two\n\n- [x] done\n\n> quoted\n\n---",
    "| a | b |\n|:-:|--:|\n| $x$ | 2 |",
    "```python\nif a<b:\n    print('<script>')\n```\n\n    <script>",
    "$$ \\frac{a}{b} < c $$\n\n\\begin{align}a&<b\\\\c\\end{align}",
    "<details>\n<summary>More</summary>\n\n- text\n</details>",
    "[link](https://example.org 'title'), [mail](mailto:a@example.org), [up](#top), ![p](p.png)",
    "a<br>b, ~~no~~, &lt;script&gt;, `<script>alert(1)</script>`",
]
HARMFUL = {
    "script": "<script>alert(1)</script>",
    "handler": "<img src=x onerror=alert(1)>",
    "svg": "<svg onload=alert(1)></svg>",
    "frame": "<iframe src='/formgrader'></iframe>",
    "style": "<style>body {display: none}</style>",
    "form": "<form action='/formgrader'><input type='submit'></form>",
    "comment": "<!-- <script>alert(1)</script> -->",
    "link": "[points](javascript:alert(1))",
    "link with a prefix that nbconvert drops": "[points](files/javascript:alert(1))",
    "link in other letters": "[points](JaVaScRiPt:alert(1))",
    "link with entities": "[points](&#106;avascript:alert(1))",
    "link defined elsewhere": "[points][1]\n\n[1]: javascript:alert(1)",
    "link in angles": "<javascript:alert(1)>",
    "page in a link": "[points](data:text/html;base64,PHNjcmlwdD4=)",
    "diagram": "```mermaid\n<script>alert(1)</script>\n```",
    "formula with a link": "$\\href{javascript:alert(1)}{x}$",
    "formula with a style": "$\\style{position:fixed}{x}$",
    "address on this server": "![a](/logout)",
    "picture that tells who looks": "![a](https://example.org/seen.png)",
    "end of the page's boxes": "</div></div></div>",
    "heading": "# <script>alert(1)</script>",
    "table": "a | b\n--|--\n<script>alert(1)</script> | 2",
    "handler on plain HTML": "<b onclick=alert(1)>bold</b>",
    "name on plain HTML": "<b id='statusmessage'>bold</b>",
    "missing picture": "![a](attachment:none.png)",
    "too long": "word " * 5000,
}


def page_of(source):
    """Return the HTML that nbgrader's pages show."""
    renderer = IPythonRenderer(escape=False)
    return strip_files_prefix(MarkdownWithMath(renderer=renderer).render(source))


def test_ordinary_markdown_stays_as_it_is():
    cells = [new_markdown_cell(source) for source in ORDINARY]
    disarm(new_notebook(cells=cells))
    assert [cell.source for cell in cells] == ORDINARY


def test_nothing_in_the_courses_own_notebooks_counts_as_harmful():
    cells = [c for path in NOTEBOOKS for c in nbformat.read(path, as_version=4).cells]
    words = [cell.source for cell in cells if cell.cell_type == "markdown"]
    assert len(words) > 300
    assert [source for source in words if not is_harmless(source)] == []


@pytest.mark.parametrize("name", HARMFUL)
def test_what_could_run_is_shown_as_it_was_typed(name):
    notebook = new_notebook(cells=[new_markdown_cell(HARMFUL[name])])
    disarm(notebook)
    (cell,) = notebook.cells
    assert cell.source == as_typed(HARMFUL[name])
    shown = page_of(cell.source)
    assert re.fullmatch(r"<p><em>[^<>]*</em></p>\s*<pre><code>[^<>]*</code></pre>\s*", shown), shown


PIECES = [
    "<script>", "</script>", "<b", ">", "`", "```", "````", "~~~", "\n", "\n\n", "    ", "$", "$$",
    "\\begin{a}", "\\end{a}", "[a](", "javascript:", "files/", ")", "![", "]: ", "onerror=x", "'",
    '"', "<!--", "-->", "|", "--|--", "&lt;", "mermaid", "\\", "# ", "> ", "- ", "a", "<details>",
]  # fmt: skip

#: Pieces in one line, and each in its own.
SOURCES = st.builds(
    lambda between, pieces: between.join(pieces),
    st.sampled_from(["", "\n"]),
    st.lists(st.sampled_from(PIECES), max_size=14),
)


@settings(max_examples=150, deadline=None)
@given(SOURCES)
def test_whatever_is_shown_as_typed_is_harmless(source):
    """Also where a student tries to end the block of code early."""
    shown = page_of(as_typed(source))
    assert re.fullmatch(r"<p><em>[^<>]*</em></p>\s*<pre><code>[^<>]*</code></pre>\s*", shown)


@settings(max_examples=150, deadline=None)
@given(SOURCES)
def test_no_tag_that_could_run_passes(source):
    page = page_of(source)
    runs = re.search(r"<(script|img[^>]*onerror|b\s*onerror)|(href|src)=.javascript:|<!--", page)
    assert not (runs and is_harmless(source))


def test_only_pictures_made_of_dots_stay_attached():
    attached = {
        "a.png": {"image/png": DOT, "image/svg+xml": "<svg onload=alert(1)>"},
        "b.svg": {"image/svg+xml": DOT},
        "c.png": {"image/png": '"><script>'},
        "d.html": {"text/html": DOT},
    }
    cell = new_markdown_cell("![a](attachment:a.png)", attachments=attached)
    disarm(new_notebook(cells=[cell]))
    assert cell.attachments == {"a.png": {"image/png": DOT}}
    assert cell.source == "![a](attachment:a.png)"
    lost = new_notebook(cells=[new_markdown_cell("![b](attachment:b.svg)", attachments=attached)])
    disarm(lost)
    assert lost.cells[0].source == as_typed("![b](attachment:b.svg)")


def test_raw_cells_and_labels_of_other_programs_do_not_stay():
    bad = "<script>alert(1)</script>"
    raw = new_raw_cell(bad, metadata={"raw_mimetype": "text/html"})
    code = new_code_cell("1", metadata={"tags": [bad], "magics_language": bad})
    empty = new_raw_cell("")
    notebook = new_notebook(cells=[raw, code, empty], metadata={"title": bad, "widgets": {bad: 1}})
    notebook.metadata["language_info"] = {"name": bad}
    disarm(notebook)
    nbformat.validate(notebook)
    assert notebook.cells[0].cell_type == "markdown"
    assert AS_TYPED in notebook.cells[0].source
    notebook.cells[0].source = ""
    assert "script" not in nbformat.writes(notebook)


def test_the_courses_own_cells_are_left_alone():
    ours = new_markdown_cell(HARMFUL["frame"], metadata={"nbgrader": {"locked": True}})
    disarm(new_notebook(cells=[ours]))
    assert ours.source == HARMFUL["frame"]
