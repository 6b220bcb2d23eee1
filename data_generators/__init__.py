"""Synthetic truth: targets, scenes, rendered photographs, simulated classes."""
