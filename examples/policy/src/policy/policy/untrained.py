"""Writes a policy that has learned nothing, as `lerobot-train` writes one that has: python -m policy.untrained FOLDER"""

import sys

import torch
from lerobot.configs.types import FeatureType, PolicyFeature
from lerobot.policies.act.configuration_act import ACTConfig
from lerobot.policies.act.modeling_act import ACTPolicy
from lerobot.policies.factory import make_pre_post_processors

JOINTS, HEIGHT, WIDTH = 6, 240, 320


def write(folder: str) -> None:
    """Writes ACT with random weights, and what it does to pictures and joints before and after."""
    torch.manual_seed(1)
    config = ACTConfig(
        input_features={
            "observation.images.front": PolicyFeature(FeatureType.VISUAL, (3, HEIGHT, WIDTH)),
            "observation.state": PolicyFeature(FeatureType.STATE, (JOINTS,)),
        },
        output_features={"action": PolicyFeature(FeatureType.ACTION, (JOINTS,))},
        pretrained_backbone_weights=None,  # of ImageNet, from the network
        device="cpu",
    )
    shapes = {"observation.images.front": (3, 1, 1), "observation.state": (JOINTS,), "action": (JOINTS,)}
    stats = {name: {"mean": torch.zeros(shape), "std": torch.ones(shape)} for name, shape in shapes.items()}
    for part in (ACTPolicy(config), *make_pre_post_processors(config, dataset_stats=stats)):
        part.save_pretrained(folder)


if __name__ == "__main__":
    write(sys.argv[1])
