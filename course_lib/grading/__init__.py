"""A term of the course in nbgrader: its directory, its plug-ins, its secret."""
