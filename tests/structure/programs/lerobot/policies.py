#!/usr/bin/env python3
"""Policies of LeRobot with random weights choose an action from a picture and the positions of joints."""

import torch
from lerobot.configs.types import FeatureType, PolicyFeature
from lerobot.policies.factory import get_policy_class, make_policy_config

JOINTS, SIZE = 6, 96
CAMERA, STATE = "observation.images.front", "observation.state"
INPUTS = {
    CAMERA: PolicyFeature(FeatureType.VISUAL, (3, SIZE, SIZE)),
    STATE: PolicyFeature(FeatureType.STATE, (JOINTS,)),
}
OUTPUTS = {"action": PolicyFeature(FeatureType.ACTION, (JOINTS,))}
SMALL = {
    "act": {"dim_model": 64, "dim_feedforward": 64},
    "diffusion": {"down_dims": (32, 64, 128), "num_inference_steps": 2},
}

torch.manual_seed(1)
for name, sizes in SMALL.items():
    # The usual weights of the cameras' network are ImageNet's, from the network.
    common = {
        "input_features": INPUTS,
        "output_features": OUTPUTS,
        "pretrained_backbone_weights": None,
        "device": "cpu",
    }
    policy = get_policy_class(name)(make_policy_config(name, **common, **sizes)).eval()
    policy.reset()
    with torch.inference_mode():
        action = policy.select_action({CAMERA: torch.rand(1, 3, SIZE, SIZE), STATE: torch.zeros(1, JOINTS)})
    assert action.shape == (1, JOINTS) and action.isfinite().all(), (name, action)
    print(f"{name}: {action.shape[1]} joints")
