"""Refuses to pack a widget without its picture."""

from pathlib import Path

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CustomBuildHook(BuildHookInterface):
    """Looks for the code of the page before the package is built."""

    def initialize(self, version, build_data):
        script = Path(self.root, "src", "bough_plant", "static", "plant.js")
        if not script.exists():
            raise FileNotFoundError(f"{script} is not built yet. In the repository's root: npm run build")
