"""Measured, not remembered: ours and a peer in the same run, on the same machine."""
