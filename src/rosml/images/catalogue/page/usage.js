// The lines and files by which an image is used. docs/use.md and docs/use/dev-container.md have the same ones; a test compares them.
"use strict";

(() => {
  const r = window.rosml;
  const WORKSPACE = "/docker-ros/ws";
  const ISSUER = "https://token.actions.githubusercontent.com"; // of keyless signatures by a workflow
  const OURS = "-e DOCKER_UID=$(id -u) -e DOCKER_GID=$(id -g)";

  function hasGpu(image) {
    return "cuda" in image.promised;
  }

  function command(image) {
    return r.catalogue.distributions[image.distribution].ros === 1
      ? ["rosrun", "my_package", "detector.py"]
      : ["ros2", "run", "my_package", "detector"];
  }

  function run(image, reference) {
    return `docker run --rm -it ${hasGpu(image) ? "--gpus all " : ""}${OURS} -v "$PWD:${WORKSPACE}" ${reference}`;
  }

  const GPUS = `    deploy:
      resources:
        reservations:
          devices:
            - driver: nvidia
              count: all
              capabilities: [gpu]
`;

  const MOUNT = `    volumes:
      - .:${WORKSPACE}
`;

  /** A compose file with one service: of an image on whose workspace the folder is mounted, or of what the folder's Dockerfile builds. */
  function compose(image, reference) {
    return `services:
  detector:
    ${reference ? `image: ${reference}` : "build: ."}
    command: ${command(image).join(" ")}
    network_mode: host
    ipc: host
    environment:
      DOCKER_UID: \${DOCKER_UID:-1000}
      DOCKER_GID: \${DOCKER_GID:-1000}
${reference ? MOUNT : ""}${hasGpu(image) ? GPUS : ""}`;
  }

  /** The dev container's files: an editor enters as the user `dev`. */
  function devcontainer(image, reference) {
    const folder = `${WORKSPACE}/src/my_package`;
    const content = {
      name: "detector",
      build: { dockerfile: "Dockerfile" },
      workspaceMount: `source=\${localWorkspaceFolder},target=${folder},type=bind`,
      workspaceFolder: folder,
      ...(hasGpu(image) ? { hostRequirements: { gpu: "optional" } } : {}),
      remoteUser: "dev",
    };
    const withUser = `FROM ${reference}
RUN useradd --create-home --shell /bin/bash --uid 1000 --groups sudo,video dev \\
 && chown dev:dev ${WORKSPACE}
`;
    return {
      ".devcontainer/devcontainer.json": `${JSON.stringify(content, null, 2)}\n`,
      ".devcontainer/Dockerfile": withUser,
    };
  }

  /** A Dockerfile for one package in the folder where it lies. */
  function dockerfile(image, reference) {
    const ros1 = r.catalogue.distributions[image.distribution].ros === 1;
    const over = r.endOfLife(image).over ? " --include-eol-distros" : "";
    return `FROM ${reference}
COPY . ${WORKSPACE}/src/my_package
RUN apt-get update && rosdep update${over} && rosdep install --from-paths src --ignore-src -y && rm -rf /var/lib/apt/lists/*
RUN /entrypoint.sh ${ros1 ? "catkin_make" : "colcon build"}
CMD ${JSON.stringify(command(image)).replaceAll(",", ", ")}
`;
  }

  /** The files with which one begins, by their names. */
  function files(image, reference) {
    return {
      Dockerfile: dockerfile(image, reference),
      ".dockerignore": [".git", ".devcontainer", "build", "devel", "install", "log", ""].join("\n"),
      "compose.yaml": compose(image, ""),
      ".env": `# What rosml containerize reads, which needs no Dockerfile.
BASE_IMAGE=${reference}
COMMAND='${command(image).join(" ")}'
IMAGE_NAME=detector
`,
      ...devcontainer(image, reference),
    };
  }

  /** What checks the signatures of a build; none where nobody is known to have signed it. */
  function verify(image, build) {
    const plain = /^(?:localhost|127\.0\.0\.1|\[::1\])(?::|\/|$)/.test(r.catalogue.registry) ? " --allow-http-registry" : "";
    return build.signed.map((identity) => {
      const by = identity.startsWith("sha256:")
        ? "--key cosign.pub --insecure-ignore-tlog=true"
        : `--certificate-oidc-issuer ${ISSUER} \\\n  --certificate-identity ${identity}`;
      return `cosign verify ${by}${plain} \\\n  ${r.reference(image, build.digest)}`;
    });
  }

  Object.assign(r, { hasGpu, usage: { run, dockerfile, compose, devcontainer, files, verify } });
})();
