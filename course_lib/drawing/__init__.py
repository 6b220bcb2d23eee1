"""Arrays in, picture or Axes out: every figure of the course, and nothing that moves."""
