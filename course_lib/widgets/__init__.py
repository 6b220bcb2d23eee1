"""Explorers: sliders that move a picture. They call drawing and the mathematics."""
