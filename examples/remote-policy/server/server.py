"""A policy that knows nothing of ROS, in the Python that it needs: it gets a picture and the positions of joints, and answers with an action."""

import json
import threading

import numpy as np
import zenoh


def act(picture: np.ndarray, positions: list[float]) -> list[float]:
    """Your policy. This one moves all joints by the brightness of the picture, from 0 to 1."""
    return [position + picture.mean() / 255 for position in positions]


def answer(query: zenoh.Query) -> None:
    """A query without a picture of this size is an error, and the next one is answered."""
    try:
        facts = json.loads(query.attachment.to_string())
        picture = np.frombuffer(query.payload.to_bytes(), np.uint8).reshape(facts["height"], facts["width"], 3)
        query.reply(query.key_expr, json.dumps(act(picture, facts["positions"])))
    except Exception as error:
        query.reply_err(f"{type(error).__name__}: {error}")


def main() -> None:
    """Answers until somebody stops it. It waits for the node, and finds it again after a restart."""
    config = zenoh.Config()
    config.insert_json5(
        "connect", json.dumps({"endpoints": ["tcp/127.0.0.1:7448"], "timeout_ms": -1, "exit_on_failure": False})
    )
    config.insert_json5("scouting/multicast/enabled", "false")  # nobody else on the network is asked
    config.insert_json5("transport/shared_memory/enabled", "true")  # pictures are not sent through the network's stack
    with zenoh.open(config) as session, session.declare_queryable("policy/act", answer):
        print("the policy is ready", flush=True)
        threading.Event().wait()


if __name__ == "__main__":
    main()
