"""How many examples the properties get."""

from __future__ import annotations

import os

from hypothesis import HealthCheck, settings

# `quick` runs with every change: the same 20 or 30 examples of each property, a fifth of them on the real matrix, which has
# hundreds of images to expand and render, the others on the small one. `thorough` looks for what nobody thought of, 1,000
# or 1,500 other ones each time:
#   HYPOTHESIS_PROFILE=thorough uv run pytest tests/unit/images/matrix/test_matrix.py tests/unit/run/test_run_words.py
settings.register_profile(
    "quick", max_examples=20, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
settings.register_profile("thorough", settings.get_profile("quick"), max_examples=1_000, derandomize=False)
PROFILE_NAME = os.environ.get("HYPOTHESIS_PROFILE", "quick")
PROFILE = settings.get_profile(PROFILE_NAME)
