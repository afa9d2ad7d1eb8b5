"""The widget as Python sees it. What happens in the page is tried in a real JupyterLab: npm run soak -- --only course."""

import json
from pathlib import Path

import pytest
import traitlets

import bough_plant
from bough_plant import Plant


def test_it_has_the_version_of_the_repository():
    manifest = json.loads((Path(__file__).parents[2] / "package.json").read_text())
    assert bough_plant.__version__ == manifest["version"]


def test_what_is_set_is_sent_to_the_page():
    plant = Plant(preset="figure-13c", params={"loads": {"gravity": 3}}, fields=["loads.gravity"])
    sent = plant.get_state()
    assert sent["preset"] == "figure-13c"
    assert sent["params"] == {"loads": {"gravity": 3}}
    assert sent["fields"] == ["loads.gravity"]
    assert sent["step"] is None
    assert sent["shown"] == {}


def test_the_code_of_the_page_is_one_module_without_imports():
    code = Plant()._esm
    assert "bough-plant" in str(code)
    assert "export" in str(code)
    assert 'from"' not in str(code)


@pytest.mark.parametrize(
    ("trait", "value"),
    [("view", "above"), ("controls", "many"), ("drawing", "sketch"), ("theme", "sepia"), ("step", 0), ("fields", [1])],
)
def test_what_cannot_be_is_refused_at_once(trait, value):
    with pytest.raises(traitlets.TraitError):
        Plant(**{trait: value})


def test_no_plant_shares_what_another_holds():
    one, other = Plant(), Plant()
    one.params = {"loads": {"gravity": 3}}
    assert other.params == {}
