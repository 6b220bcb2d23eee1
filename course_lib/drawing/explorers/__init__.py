"""What the explorers show: pure functions from the positions of the controls to a frame."""
