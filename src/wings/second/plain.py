"""Section plain: format-sections.md, section 2; lemma L16. A dumbbell is a body without mass of its rod: rho = r and g = 1."""

from body import leaf
from full import COVERS, LEAVES, WITNESSES, root
