"""From a lesson to nbgrader's source notebook and to the notebook that students open."""
