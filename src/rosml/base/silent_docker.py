"""What to do if Docker does not answer, by the words of its client."""

from __future__ import annotations

DENIED = "permission denied"


def denies(complaint: str) -> bool:
    """Whether the daemon answers, and does not let this user in."""
    return DENIED in complaint.lower()


def remedy(complaint: str) -> str:
    if denies(complaint):
        return "sudo usermod -aG docker $USER, then log in again"
    return "start Docker (sudo systemctl start docker); 'docker context ls' and DOCKER_HOST say which one is asked"
