"""A pipeline of diffusers with random weights."""

import diffusers
import torch
from common import send

network = diffusers.UNet2DModel(
    sample_size=16,
    in_channels=1,
    out_channels=1,
    layers_per_block=1,
    block_out_channels=(32, 64),
    down_block_types=("DownBlock2D", "AttnDownBlock2D"),
    up_block_types=("AttnUpBlock2D", "UpBlock2D"),
)
pipeline = diffusers.DDPMPipeline(network, diffusers.DDPMScheduler(num_train_timesteps=10))
images = pipeline(num_inference_steps=3, output_type="np", generator=torch.manual_seed(0)).images
send(f"diffusers {diffusers.__version__}", images[0, :6, 0, 0])
