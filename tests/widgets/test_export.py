"""A page made of a notebook shows explorers as stills with words, not as dead widgets."""

import base64
import json
import re
from html import unescape
from pathlib import Path

import nbformat
import pytest
from nbconvert import HTMLExporter
from traitlets.config import Config

from course_lib.widgets import explorer
from course_lib.widgets.pinhole import dolly_zoom_explorer

VIEW, STATE = (f"application/vnd.jupyter.widget-{part}+json" for part in ("view", "state"))
#: What Jupyter is told where the course is installed: see pyproject.toml.
CONFIG = Config(json.loads((Path(explorer.__file__).parent / "export_config.json").read_text()))


@pytest.fixture
def executed():
    """A notebook as nbconvert executes it: with the explorer's state, but no kernel."""
    data, _ = dolly_zoom_explorer()._repr_mimebundle_()
    output = nbformat.v4.new_output("execute_result", data=data, execution_count=1)
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("", outputs=[output])])
    states = {data[VIEW]["model_id"]: {"model_name": "AnyModel", "state": {}}}
    notebook.metadata["widgets"] = {STATE: {"version_major": 2, "state": states}}
    return notebook


def test_the_still_is_shown_with_its_words(executed):
    page, _ = HTMLExporter(config=CONFIG).from_notebook_node(executed)
    (picture,) = re.findall(r'<img alt="([^"]*)" src="data:image/png;base64,([^"]*)"', page)
    assert "Letter chart 4.0 m away with 28 mm" in unescape(picture[0])
    assert base64.b64decode(picture[1]).startswith(b"\x89PNG")
    assert f'<script type="{VIEW}"' not in page


def test_without_it_the_page_would_have_a_widget_that_is_dead(executed):
    page, _ = HTMLExporter().from_notebook_node(executed)
    assert "<img alt" not in page


def test_a_widget_without_a_still_stays_a_widget(executed):
    executed.cells[0].outputs[0].data.pop("text/html")
    page, _ = HTMLExporter(config=CONFIG).from_notebook_node(executed)
    assert f'<script type="{VIEW}"' in page
