"""Two pictures of one scene."""
