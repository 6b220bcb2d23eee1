"""How cameras see: the mathematics, exercises, figures and widgets of the course.

The mathematics (`camera`, `optics`, `transforms`, …) is plain functions on NumPy arrays and
imports nothing else. Conventions: camera frame x right, y down, z forward; poses map world to
camera; pixel ``(0, 0)`` is the centre of the top-left pixel; points are rows.
"""
