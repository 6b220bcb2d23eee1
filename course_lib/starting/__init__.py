"""From a fresh folder to an open course: the environment, the work folder, JupyterLab.

This runs before any package is installed, so it imports the standard library only, and
nothing else of the course.
"""
