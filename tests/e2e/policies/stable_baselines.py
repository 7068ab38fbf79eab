"""PPO of stable-baselines3, after a few steps of learning."""

import gymnasium
import stable_baselines3
from common import send

pendulum = gymnasium.make("Pendulum-v1")
policy = stable_baselines3.PPO("MlpPolicy", pendulum, n_steps=64, batch_size=32, device="cpu").learn(128)
send(f"stable-baselines3 {stable_baselines3.__version__}", policy.predict(pendulum.reset(seed=1)[0])[0])
