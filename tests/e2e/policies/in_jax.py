"""A network with random weights, compiled by JAX."""

import jax
from common import send
from jax import numpy


@jax.jit
def act(first, second, observation):
    return numpy.tanh(numpy.tanh(observation @ first) @ second)


key = jax.random.PRNGKey(0)
weights = jax.random.normal(key, (12, 32)), jax.random.normal(key, (32, 6))
send(f"jax {jax.__version__}", act(*weights, numpy.arange(12.0)))
