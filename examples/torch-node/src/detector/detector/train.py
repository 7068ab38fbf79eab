"""Teaches the network with pictures that are made here, and writes its weights: python3 -m detector.train FILE"""

import sys

import torch
from torch import Tensor
from torch.nn.functional import cross_entropy

from detector.model import PLACES, network


def picture(place: int, height: int = 24, width: int = 36) -> Tensor:
    """Noise, and a bright square in the third that is wanted."""
    made = torch.rand(3, height, width) * 0.3
    third = width // len(PLACES)
    top, left = int(torch.randint(height - 8, ())), place * third + int(torch.randint(third - 8, ()))
    made[:, top : top + 8, left : left + 8] = 1.0
    return made


def train(steps: int = 150) -> dict[str, Tensor]:
    """The weights after some steps, on the GPU if there is one."""
    torch.manual_seed(1)
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    model = network().to(device)
    optimizer = torch.optim.Adam(model.parameters(), lr=0.02)
    for _ in range(steps):
        wanted = torch.randint(len(PLACES), (32,))
        pictures = torch.stack([picture(int(place)) for place in wanted])
        optimizer.zero_grad()
        cross_entropy(model(pictures.to(device)), wanted.to(device)).backward()
        optimizer.step()
    return model.state_dict()


if __name__ == "__main__":
    torch.save(train(), sys.argv[1])
