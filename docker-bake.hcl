# Generated from matrix.yaml by scripts/generate_bake.py, with src/rosml/images/bake/graph.hcl below it: change one of them, then run
#   rosml generate
#
#   PLATFORM=linux/amd64 docker buildx bake ros1-bookworm-core   builds an image, and what it stands on, for one platform
#   docker buildx bake ros1-bookworm-core-test                   runs its structure tests inside the build
#   docker buildx bake --print <target>                     shows what would be built
#   docker buildx bake --list targets                       lists all targets, --list variables what can be set

variable "REGISTRY" {
  description = "where images live, without https://"
  default     = "localhost:5000"
}

variable "OS_BOOKWORM" {
  description = "base image of bookworm"
  default     = "docker-image://docker.io/library/debian:bookworm@sha256:30482e873082e906a4908c10529180aefb6f77620aea7404b909829fadc5d168"
}

variable "OS_TRIXIE" {
  description = "base image of trixie"
  default     = "docker-image://docker.io/library/debian:trixie@sha256:35b8ff74ead4880f22090b617372daff0ccae742eb5674455d542bef71ef1999"
}

variable "OS_UBUNTU_20_04" {
  description = "base image of ubuntu-20.04"
  default     = "docker-image://docker.io/library/ubuntu:20.04@sha256:8feb4d8ca5354def3d8fce243717141ce31e2c428701f6682bd2fafe15388214"
}

variable "OS_UBUNTU_22_04" {
  description = "base image of ubuntu-22.04"
  default     = "docker-image://docker.io/library/ubuntu:22.04@sha256:b8b6ee6aa931ecd9d0d952abc34dc0e5f7c6a30c6bb71b079fe399fde0329c02"
}

variable "OS_UBUNTU_24_04" {
  description = "base image of ubuntu-24.04"
  default     = "docker-image://docker.io/library/ubuntu:24.04@sha256:69cecf4bbf72d2d44a9eef1b71fb98c7fb973d78af11399deccef19beb008ad9"
}

variable "OS_UBUNTU_26_04" {
  description = "base image of ubuntu-26.04"
  default     = "docker-image://docker.io/library/ubuntu:26.04@sha256:cd21a4f68a617580279d4b091cb18e3af9fa8a87500665f0ae5f7f757d17d367"
}

variable "PLATFORM" {
  description = "build for this platform only, such as linux/amd64; if empty, for all that a target has"
  default     = ""
}

variable "SOURCE_DATE_EPOCH" {
  description = "time of every file, in seconds since 1970"
  default     = "1767225600"
}

variable "REVISION" {
  description = "commit that is built, for a label"
  default     = ""
}

variable "DIGESTS" {
  description = "JSON text: dependencies to take from the registry, {\"torch-cu128-py311\": \"sha256:…\"}"
  default     = ""
}

variable "ROS_SYNC_DATES" {
  description = "JSON text: the dates of ROS's repositories, {\"jazzy\": \"2026-11-20T21:14:09Z\"}"
  default     = ""
}

variable "ROS_CHANNEL" {
  description = "live, testing, snapshot or final, in the place of what matrix.yaml says (ROS_CHANNEL=final rosml image)"
  default     = ""
}

variable "ROS_SNAPSHOT" {
  description = "day of the snapshot where ROS_CHANNEL is snapshot: YYYY-MM-DD"
  default     = ""
}

variable "CA_BUNDLE" {
  description = "file with certificates that build steps trust; never part of a layer"
  default     = ""
}

variable "ROS_APT_MIRROR" {
  description = "mirror of the hosts that ros_archive names, such as http://host:3142; never part of an image"
  default     = ""
}

variable "OS_APT_MIRROR" {
  description = "mirror of the hosts that base images' apt sources name, such as http://host:3142; never part of an image"
  default     = ""
}

variable "STEP_NETWORK" {
  description = "host: build steps have the network of the builder's machine; needs --allow network.host, and a builder that does"
  default     = ""
}

variable "HTTP_PROXY" {
  description = "for build steps; never part of an image"
  default     = ""
}

variable "HTTPS_PROXY" {
  description = "for build steps; never part of an image"
  default     = ""
}

variable "NO_PROXY" {
  description = "for build steps; never part of an image"
  default     = ""
}

# ---- Tables ---------------------------------------------------------------------------------------------------------

# Operating systems.
systems = {
  bookworm = {
    image = OS_BOOKWORM, python = "3.11", numpy = "<2", platforms = ["linux/amd64", "linux/arm64"]
    tools = "catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  trixie = {
    image = OS_TRIXIE, python = "3.13", numpy = ">=2.2,<2.3", platforms = ["linux/amd64", "linux/arm64"]
    tools = "catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  "ubuntu-20.04" = {
    image = OS_UBUNTU_20_04, python = "3.8", numpy = "<2", platforms = ["linux/amd64", "linux/arm64"]
    tools = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  "ubuntu-22.04" = {
    image = OS_UBUNTU_22_04, python = "3.10", numpy = "<2", platforms = ["linux/amd64", "linux/arm64"]
    tools = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  "ubuntu-24.04" = {
    image = OS_UBUNTU_24_04, python = "3.12", numpy = "<2", platforms = ["linux/amd64", "linux/arm64"]
    tools = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  "ubuntu-26.04" = {
    image = OS_UBUNTU_26_04, python = "3.14", numpy = ">=2.3,<2.4", platforms = ["linux/amd64", "linux/arm64"]
    tools = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
}

# Each component with all that it is built on, the lowest first.
components = {
  core         = ["core"]
  base         = ["core", "base"]
  robot        = ["core", "base", "robot"]
  perception   = ["core", "base", "robot", "perception"]
  desktop      = ["core", "base", "robot", "perception", "desktop"]
  desktop-full = ["core", "base", "robot", "perception", "desktop", "desktop-full"]
  core-run     = ["core-run"]
  base-run     = ["core-run", "base-run"]
}

# Versions that go together. frameworks: those that can have them, the smallest first. beside: what goes with each release, in its part. gpu: what parts say of drivers and GPUs.
stacks = {
  cu128 = {
    accelerator = "cuda", frameworks = ["cuda", "torch", "tensorflow", "ml"]
    versions = { torch = "2.10.0", tensorflow = "2.20.0", cuda = "12.8.90", cudnn = "9.10.2.21", nccl = "2.27.5" }
    beside = { torch = { torchaudio = "2.10.0", torchvision = "0.25.0" }, tensorflow = {} }
    gpu = { cuda = { driver = "525" }, torch = { "torch.amd64" = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120" }, tensorflow = { "tensorflow.amd64" = "sm_60 sm_70 sm_80 sm_89 compute_90" } }
  }
  cu130 = {
    accelerator = "cuda", frameworks = ["cuda", "torch"]
    versions = { torch = "2.14.1", cuda = "13.0.96", cudnn = "9.24.0.43", nccl = "2.30.7" }
    beside = { torch = { torchaudio = "2.11.0", torchvision = "0.29.1" } }
    gpu = { cuda = { driver = "580" }, torch = { "torch.amd64" = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120", "torch.arm64" = "sm_80 sm_90 sm_100 sm_110 sm_120" } }
  }
  cu132 = {
    accelerator = "cuda", frameworks = ["cuda", "torch"]
    versions = { torch = "2.15.0", cuda = "13.2.86", cudnn = "9.26.0.51", nccl = "2.30.7" }
    beside = { torch = { torchvision = "0.29.2" } }
    gpu = { cuda = { driver = "580" }, torch = { "torch.amd64" = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120", "torch.arm64" = "sm_80 sm_90 sm_100 sm_110 sm_120" } }
  }
  cu121 = {
    accelerator = "cuda", frameworks = ["cuda", "torch"]
    versions = { torch = "2.4.1", cuda = "12.1.105", cudnn = "9.1.0.70", nccl = "2.20.5" }
    beside = { torch = { torchaudio = "2.4.1", torchvision = "0.19.1" } }
    gpu = { cuda = { driver = "525" }, torch = { "torch.amd64" = "sm_50 sm_60 sm_70 sm_75 sm_80 sm_86 sm_90" } }
  }
  cpu = {
    accelerator = "cpu", frameworks = ["torch", "tensorflow", "ml"]
    versions = { torch = "2.10.0", tensorflow = "2.21.0" }
    beside = { torch = {}, tensorflow = {} }
    gpu = {}
  }
  cpu38 = {
    accelerator = "cpu", frameworks = ["torch", "tensorflow"]
    versions = { torch = "2.4.1", tensorflow = "2.13.1" }
    beside = { torch = {}, tensorflow = {} }
    gpu = {}
  }
}

# What is built once and joined to many images. brings: whose versions labels and the environment name.
entries = {
  cuda = {
    accelerator = "cuda", any_python = true
    tested = true, compiled = true
    slot = "", shows = ""
    release = "", brings = [{ name = "cuda", short = "cuda", title = "CUDA" }, { name = "cudnn", short = "", title = "" }]
  }
  common = {
    accelerator = "", any_python = false
    tested = false, compiled = false
    slot = "01", shows = "cuda"
    release = "", brings = []
  }
  torch = {
    accelerator = "", any_python = false
    tested = true, compiled = true
    slot = "02", shows = ""
    release = "torch", brings = [{ name = "torch", short = "torch", title = "PyTorch" }]
  }
  tensorflow-cc = {
    accelerator = "", any_python = true
    tested = false, compiled = false
    slot = "", shows = ""
    release = "tensorflow", brings = [{ name = "tensorflow", short = "", title = "" }]
  }
  tensorflow = {
    accelerator = "", any_python = false
    tested = true, compiled = true
    slot = "03", shows = ""
    release = "tensorflow", brings = [{ name = "tensorflow", short = "tf", title = "TensorFlow" }]
  }
}

# What images carry. spelled: whose versions a tag names. stacks: the platforms that all of it has wheels for.
frameworks = {
  none = {
    repository = "ros", parts = []
    versions = [], spelled = []
    stacks = {}
  }
  cuda = {
    repository = "ros-cuda", parts = ["cuda"]
    versions = ["cuda", "cudnn", "nccl"], spelled = ["cuda"]
    stacks = { cu128 = ["linux/amd64"], cu130 = ["linux/amd64", "linux/arm64"], cu132 = ["linux/amd64", "linux/arm64"], cu121 = ["linux/amd64"] }
  }
  torch = {
    repository = "ros-torch", parts = ["cuda", "common", "torch"]
    versions = ["torch", "cuda", "cudnn", "nccl"], spelled = ["torch"]
    stacks = { cu128 = ["linux/amd64"], cu130 = ["linux/amd64", "linux/arm64"], cu132 = ["linux/amd64", "linux/arm64"], cu121 = ["linux/amd64"], cpu = ["linux/amd64", "linux/arm64"], cpu38 = ["linux/amd64", "linux/arm64"] }
  }
  tensorflow = {
    repository = "ros-tf", parts = ["cuda", "common", "tensorflow-cc", "tensorflow"]
    versions = ["tensorflow", "cuda", "cudnn", "nccl"], spelled = ["tensorflow"]
    stacks = { cu128 = ["linux/amd64"], cpu = ["linux/amd64", "linux/arm64"], cpu38 = ["linux/amd64", "linux/arm64"] }
  }
  ml = {
    repository = "ros-ml", parts = ["cuda", "common", "torch", "tensorflow-cc", "tensorflow"]
    versions = ["torch", "tensorflow", "cuda", "cudnn", "nccl"], spelled = ["torch", "tensorflow"]
    stacks = { cu128 = ["linux/amd64"], cpu = ["linux/amd64", "linux/arm64"] }
  }
}

# What is taken where nothing is named, and how things are called.
plain           = "none"
assembler       = "bookworm"
source          = null
short_component = "base"
releases        = ["torch", "tensorflow"]
runtimes        = ["core-run", "base-run"]

# runtime: components on which programs run that are built on another one. short: the stack of a framework's short tags. aliases: names that it had. lowest: its smallest component. carrying: what runs there what others share with it. unlocked: what has no lock yet, and why.
distributions = {
  noetic = {
    os = "ubuntu-20.04", ros = "1", ros_distro = "noetic", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["noetic"], aliases = [], experimental = false
    short = { cuda = "cu121", torch = "cu121" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-noetic-ros-core", base = "ros-noetic-ros-base", robot = "ros-noetic-robot", perception = "ros-noetic-perception", desktop = "ros-noetic-desktop", desktop-full = "ros-noetic-desktop-full", core-run = "ros-noetic-ros-core", base-run = "ros-noetic-ros-base" }
    runtime = { core = "core-run", base = "base-run", robot = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "final", ROS_SNAPSHOT = "", ROS_CODENAME = "focal", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/noetic/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros-testing/ubuntu" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu121", "cpu38"], tensorflow = ["cpu38"] }
    lowest = "core", carrying = ["none", "cuda-cu128", "cuda-cu130", "cuda-cu132", "torch-cu121", "torch-cpu38", "tensorflow-cpu38"]
    unlocked = { torch-cpu38 = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
  foxy = {
    os = "ubuntu-20.04", ros = "2", ros_distro = "foxy", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["foxy"], aliases = [], experimental = false
    short = { cuda = "cu121", torch = "cu121" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-foxy-ros-core", base = "ros-foxy-ros-base", desktop = "ros-foxy-desktop", core-run = "ros-foxy-ros-core", base-run = "ros-foxy-ros-base" }
    runtime = { core = "core-run", base = "base-run", desktop = "base-run" }
    apt = { ROS_CHANNEL = "final", ROS_SNAPSHOT = "", ROS_CODENAME = "focal", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/foxy/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu121", "cpu38"], tensorflow = ["cpu38"] }
    lowest = "core", carrying = ["none", "cuda-cu128", "cuda-cu130", "cuda-cu132", "torch-cu121", "torch-cpu38", "tensorflow-cpu38"]
    unlocked = { torch-cpu38 = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
  humble = {
    os = "ubuntu-22.04", ros = "2", ros_distro = "humble", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["humble"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-humble-ros-core", base = "ros-humble-ros-base", perception = "ros-humble-perception", desktop = "ros-humble-desktop", desktop-full = "ros-humble-desktop-full", core-run = "ros-humble-ros-core", base-run = "ros-humble-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "live", ROS_SNAPSHOT = "", ROS_CODENAME = "jammy", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/humble/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.jammy_all.deb@sha256:110b9a462d55252decb8b7c816f61c2ba0d9890ce5fb93ac504e97cae5860d76" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu132", "cuda-cu121", "torch-cu130", "ml-cu128", "ml-cpu"]
    unlocked = {}
  }
  iron = {
    os = "ubuntu-22.04", ros = "2", ros_distro = "iron", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["iron"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-iron-ros-core", base = "ros-iron-ros-base", perception = "ros-iron-perception", desktop = "ros-iron-desktop", desktop-full = "ros-iron-desktop-full", core-run = "ros-iron-ros-core", base-run = "ros-iron-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "final", ROS_SNAPSHOT = "", ROS_CODENAME = "jammy", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/iron/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.jammy_all.deb@sha256:110b9a462d55252decb8b7c816f61c2ba0d9890ce5fb93ac504e97cae5860d76" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu132", "cuda-cu121", "torch-cu130", "ml-cu128", "ml-cpu"]
    unlocked = {}
  }
  jazzy = {
    os = "ubuntu-24.04", ros = "2", ros_distro = "jazzy", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["jazzy", "latest"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-jazzy-ros-core", base = "ros-jazzy-ros-base", perception = "ros-jazzy-perception", desktop = "ros-jazzy-desktop", desktop-full = "ros-jazzy-desktop-full", core-run = "ros-jazzy-ros-core", base-run = "ros-jazzy-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "live", ROS_SNAPSHOT = "", ROS_CODENAME = "noble", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/jazzy/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.noble_all.deb@sha256:f31d84adf5054c7d60ded0e82c0f776a77ea33af53d08f40b9ad7c94cca55296" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu130", "torch-cu132", "ml-cu128", "ml-cpu"]
    unlocked = {}
  }
  kilted = {
    os = "ubuntu-24.04", ros = "2", ros_distro = "kilted", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["kilted"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-kilted-ros-core", base = "ros-kilted-ros-base", perception = "ros-kilted-perception", desktop = "ros-kilted-desktop", desktop-full = "ros-kilted-desktop-full", core-run = "ros-kilted-ros-core", base-run = "ros-kilted-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "live", ROS_SNAPSHOT = "", ROS_CODENAME = "noble", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/kilted/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.noble_all.deb@sha256:f31d84adf5054c7d60ded0e82c0f776a77ea33af53d08f40b9ad7c94cca55296" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu130", "torch-cu132", "ml-cu128", "ml-cpu"]
    unlocked = {}
  }
  lyrical = {
    os = "ubuntu-26.04", ros = "2", ros_distro = "lyrical", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["lyrical"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-lyrical-ros-core", base = "ros-lyrical-ros-base", perception = "ros-lyrical-perception", desktop = "ros-lyrical-desktop", desktop-full = "ros-lyrical-desktop-full", core-run = "ros-lyrical-ros-core", base-run = "ros-lyrical-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "live", ROS_SNAPSHOT = "", ROS_CODENAME = "resolute", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/lyrical/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.resolute_all.deb@sha256:e70bc980395f4a3b366b9c5e7f8f9b4d63a4064fb115f6ff3bc52f7faa02ef69" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu128", "torch-cu130", "torch-cu132", "torch-cpu"]
    unlocked = { torch-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
  rolling = {
    os = "ubuntu-26.04", ros = "2", ros_distro = "rolling", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["rolling"], aliases = [], experimental = false
    short = { cuda = "cu130", torch = "cu130" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "ros-rolling-ros-core", base = "ros-rolling-ros-base", perception = "ros-rolling-perception", desktop = "ros-rolling-desktop", desktop-full = "ros-rolling-desktop-full", core-run = "ros-rolling-ros-core", base-run = "ros-rolling-ros-base" }
    runtime = { core = "core-run", base = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = { ROS_CHANNEL = "live", ROS_SNAPSHOT = "", ROS_CODENAME = "resolute", ROS_LIVE_ADDRESS = "http://packages.ros.org/ros2/ubuntu", ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/rolling/{day}/ubuntu", ROS_TESTING_ADDRESS = "http://packages.ros.org/ros2-testing/ubuntu", ROS_APT_SOURCE = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.resolute_all.deb@sha256:e70bc980395f4a3b366b9c5e7f8f9b4d63a4064fb115f6ff3bc52f7faa02ef69" }
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu128", "torch-cu130", "torch-cu132", "torch-cpu"]
    unlocked = { torch-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
  ros1-bookworm = {
    os = "bookworm", ros = "1", ros_distro = "Debian", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["ros1-bookworm", "bookworm"], aliases = ["bookworm"], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "rosbash ros-core ros-core-dev ros-core-python-dev", base = "rosbash ros-base ros-base-dev ros-base-python-dev", robot = "rosbash ros-robot ros-robot-dev ros-robot-python-dev", perception = "rosbash ros-perception ros-perception-dev ros-perception-python-dev", desktop = "rosbash ros-desktop ros-desktop-dev ros-desktop-python-dev", desktop-full = "rosbash ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev", core-run = "rosbash ros-core ros-core-dev ros-core-python-dev", base-run = "rosbash ros-base ros-base-dev ros-base-python-dev" }
    runtime = { core = "core-run", base = "base-run", robot = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = null
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu130", "torch-cu132", "tensorflow-cpu", "ml-cu128", "ml-cpu"]
    unlocked = { torch-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them", ml-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
  ros1-trixie = {
    os = "trixie", ros = "1", ros_distro = "Debian", platforms = ["linux/amd64", "linux/arm64"]
    tags = ["ros1-trixie", "trixie"], aliases = ["trixie"], experimental = false
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "", tools = ""
    packages = { core = "rosbash ros-core ros-core-dev ros-core-python-dev", base = "rosbash ros-base ros-base-dev ros-base-python-dev", robot = "rosbash ros-robot ros-robot-dev ros-robot-python-dev", perception = "rosbash ros-perception ros-perception-dev ros-perception-python-dev", desktop = "rosbash ros-desktop ros-desktop-dev ros-desktop-python-dev", desktop-full = "rosbash ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev", core-run = "rosbash ros-core ros-core-dev ros-core-python-dev", base-run = "rosbash ros-base ros-base-dev ros-base-python-dev" }
    runtime = { core = "core-run", base = "base-run", robot = "base-run", perception = "base-run", desktop = "base-run", desktop-full = "base-run" }
    apt = null
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu130", "torch-cu132", "ml-cu128", "ml-cpu"]
    unlocked = {}
  }
  jazzy-wheels = {
    os = "bookworm", ros = "2", ros_distro = "jazzy", platforms = ["linux/amd64"]
    tags = [], aliases = [], experimental = true
    short = { cuda = "cu130", torch = "cu130", tensorflow = "cu128", ml = "cu128" }
    rmw = "", usual_rmw = "", wheels = "ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6", tools = "python3-rosdep2 vcstool python3-numpy python3-empy colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
    packages = { core = "" }
    runtime = {}
    apt = null
    stacks = { cuda = ["cu128", "cu130", "cu132", "cu121"], torch = ["cu128", "cu130", "cu132", "cpu"], tensorflow = ["cu128", "cpu"], ml = ["cu128", "cpu"] }
    lowest = "core", carrying = ["none", "cuda-cu121", "torch-cu130", "torch-cu132", "tensorflow-cpu", "ml-cu128", "ml-cpu"]
    unlocked = { torch-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them", ml-cpu = "cannot be built yet: no lock; run 'rosml locks' where the package indexes answer, PyTorch's own among them" }
  }
}

# What is assembled once, on a system, and joined to many images.
parts = [
  { kind = "cuda", stack = "cu128", python = "any", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "cuda", stack = "cu130", python = "any", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "cuda", stack = "cu132", python = "any", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "cuda", stack = "cu121", python = "any", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu121", python = "3.8", os = "ubuntu-20.04", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu121", python = "3.8", os = "ubuntu-20.04", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cpu38", python = "3.8", os = "ubuntu-20.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu38", python = "3.8", os = "ubuntu-20.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow-cc", stack = "cpu38", python = "any", os = "ubuntu-20.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow", stack = "cpu38", python = "3.8", os = "ubuntu-20.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu128", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu128", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64"] },
  { kind = "tensorflow-cc", stack = "cu128", python = "any", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "tensorflow", stack = "cu128", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu130", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu130", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cpu", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow-cc", stack = "cpu", python = "any", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow", stack = "cpu", python = "3.10", os = "ubuntu-22.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu128", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu128", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64"] },
  { kind = "tensorflow", stack = "cu128", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu130", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu130", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu132", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu132", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cpu", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow", stack = "cpu", python = "3.12", os = "ubuntu-24.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu128", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu128", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu130", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu130", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu132", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu132", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cpu", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu", python = "3.14", os = "ubuntu-26.04", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu128", python = "3.11", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu128", python = "3.11", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "tensorflow", stack = "cu128", python = "3.11", os = "bookworm", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu130", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu130", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu132", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu132", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cpu", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow", stack = "cpu", python = "3.11", os = "bookworm", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu128", python = "3.13", os = "trixie", platforms = ["linux/amd64"] },
  { kind = "torch", stack = "cu128", python = "3.13", os = "trixie", platforms = ["linux/amd64"] },
  { kind = "tensorflow", stack = "cu128", python = "3.13", os = "trixie", platforms = ["linux/amd64"] },
  { kind = "common", stack = "cu130", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu130", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cu132", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cu132", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "common", stack = "cpu", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "torch", stack = "cpu", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
  { kind = "tensorflow", stack = "cpu", python = "3.13", os = "trixie", platforms = ["linux/amd64", "linux/arm64"] },
]

group "default" { targets = ["ros1-bookworm-core"] }
group "noetic" { targets = having("distribution", "noetic") }
group "foxy" { targets = having("distribution", "foxy") }
group "humble" { targets = having("distribution", "humble") }
group "iron" { targets = having("distribution", "iron") }
group "jazzy" { targets = having("distribution", "jazzy") }
group "kilted" { targets = having("distribution", "kilted") }
group "lyrical" { targets = having("distribution", "lyrical") }
group "rolling" { targets = having("distribution", "rolling") }
group "ros1-bookworm" { targets = having("distribution", "ros1-bookworm") }
group "ros1-trixie" { targets = having("distribution", "ros1-trixie") }
group "jazzy-wheels" { targets = having("distribution", "jazzy-wheels") }
group "core" { targets = having("component", "core") }
group "base" { targets = having("component", "base") }
group "robot" { targets = having("component", "robot") }
group "perception" { targets = having("component", "perception") }
group "desktop" { targets = having("component", "desktop") }
group "desktop-full" { targets = having("component", "desktop-full") }
group "core-run" { targets = having("component", "core-run") }
group "base-run" { targets = having("component", "base-run") }
group "none" { targets = having("framework", "none") }
group "cuda" { targets = having("framework", "cuda") }
group "torch" { targets = having("framework", "torch") }
group "tensorflow" { targets = having("framework", "tensorflow") }
group "ml" { targets = having("framework", "ml") }
group "cu128" { targets = having("stack", "cu128") }
group "cu130" { targets = having("stack", "cu130") }
group "cu132" { targets = having("stack", "cu132") }
group "cu121" { targets = having("stack", "cu121") }
group "cpu" { targets = having("stack", "cpu") }
group "cpu38" { targets = having("stack", "cpu38") }

# ---- What follows from the tables ------------------------------------------------------------------------------------
# From here on all is written by hand, in src/rosml/images/bake/graph.hcl. src/rosml/images/bake/targets.py says the same in Python, for whoever asks what
# decides an image, and a test compares the two.

# What the caller says in JSON. An empty text says nothing.
digests    = { for name, digest in jsondecode(DIGESTS == "" ? "{}" : DIGESTS) : name => digest if digest != "" }
sync_dates = { for name, date in jsondecode(ROS_SYNC_DATES == "" ? "{}" : ROS_SYNC_DATES) : name => date if date != "" }

# A dependency: built here, unless DIGESTS names it. The only place that decides.
function "dependency" {
  params = [name, repository, target]
  result = try("docker-image://${REGISTRY}/${repository}@${digests[name]}", "target:${target}")
}

# The platforms to build for, of all that are possible.
function "platforms" {
  params = [all]
  result = PLATFORM == "" ? all : [PLATFORM]
}

# A fact of matrix.yaml, unless the caller says otherwise.
function "overridable" {
  params = [fact, value]
  result = value == "" ? fact : value
}

# How variables begin that are about a part or a version.
function "variable" {
  params = [name]
  result = upper(replace(name, "-", "_"))
}

# A value that is left out when it is empty.
function "given" {
  params = [value]
  result = value == "" ? null : value
}

# The target of an operating system, to build or only to run; bake allows no points in names.
function "os_target" {
  params = [os, runtime]
  result = "_os-${replace(os, ".", "-")}${runtime ? "-run" : ""}"
}

# A part's name: torch-cu128-py312, or cuda-cu128 where it is the same for every Python.
function "part_name" {
  params = [kind, stack, python]
  result = entries[kind].any_python ? "${kind}-${stack}" : "${kind}-${stack}-py${replace(python, ".", "")}"
}

# The parts that a framework takes of a stack, in the order in which they are joined.
function "parts_of" {
  params = [framework, stack]
  result = [
    for kind in frameworks[framework].parts : kind
    if contains(["", try(stacks[stack].accelerator, "")], entries[kind].accelerator)
  ]
}

# The part whose packages another one of a stack shows to its Python, if any.
function "shown" {
  params = [kind, stack]
  result = try(
    contains(["", stacks[stack].accelerator], entries[entries[kind].shows].accelerator) ? entries[kind].shows : "", ""
  )
}

# Whose versions labels and the environment name; of what has a title, how descriptions and tags call it.
counted = flatten([for entry in entries : [for item in entry.brings : item.name]])
called  = { for item in flatten([for entry in entries : entry.brings]) : item.name => item if item.title != "" }

# What a distribution is joined with: nothing, or a framework on a stack.
choices = { for name, row in distributions : name => concat(
  [{ framework = plain, stack = "", key = plain }],
  flatten([for framework, names in row.stacks : [for stack in names : {
    framework = framework, stack = stack, key = "${framework}-${stack}"
  }]])
) }

# The kinds of images: what those of one distribution, framework and stack have in common, whatever their component.
kinds = flatten([for name, row in distributions : [for choice in choices[name] : merge(choice, {
  distribution = name
  row          = row
  system       = systems[row.os]
  repository   = frameworks[choice.framework].repository
  carrying     = contains(row.carrying, choice.key)
  unlocked     = try(row.unlocked[choice.key], "")
  platforms = [for platform in row.platforms : platform
  if choice.stack == "" ? true : contains(frameworks[choice.framework].stacks[choice.stack], platform)]
  parts = [for kind in parts_of(choice.framework, choice.stack) : {
    kind = kind, name = part_name(kind, choice.stack, systems[row.os].python)
  }]
  gpu = flatten([for kind in parts_of(choice.framework, choice.stack) : [
    for name, value in try(stacks[choice.stack].gpu[kind], {}) : { name = name, value = value }
  ]])
  versions = [for name in frameworks[choice.framework].versions : {
    name = name, version = stacks[choice.stack].versions[name]
  } if can(stacks[choice.stack].versions[name])]
})]])

# The components of a distribution that one is built on, the lowest first.
beneath = { for name, row in distributions : name => { for component, packages in row.packages : component => [
  for other in components[component] : other if other != component && can(row.packages[other])
] } }

# All images: of each kind one for every component. ros: the one without a framework; below: the one that this stands on,
# if any; runtime: whether it is only for programs that are built; main: the tag that says what it is; spelled: the same with the versions of what it is for.
images = flatten([for kind in kinds : [for component, packages in kind.row.packages : merge(kind, {
  component = component
  chain     = concat(beneath[kind.distribution][component], [component])
  packages  = packages
  runtime   = contains(runtimes, component)
  ros       = "${kind.distribution}-${component}"
  below     = try("${kind.distribution}-${reverselist(beneath[kind.distribution][component])[0]}", "")
  target    = kind.stack == "" ? "${kind.distribution}-${component}" : "${kind.distribution}-${component}-${kind.key}"
  main      = join("-", compact([kind.distribution, component, kind.stack]))
  spelled = join("-", concat(compact([kind.distribution, component, kind.stack]), [
    for item in kind.versions : "${called[item.name].short}${item.version}"
    if contains(frameworks[kind.framework].spelled, item.name)
  ]))
})]])

# Those that can be built, since all their locks are there. Only these are in groups.
built = [for image in images : image if image.unlocked == ""]

# All tags of an image, also with the names that its distribution had. The short ones are those of one component, on the
# distribution's stack for them.
function "tags" {
  params = [image]
  result = [for tag in distinct(concat(
    flatten([for name in concat([image.distribution], image.row.aliases) : [
      for tag in [image.main, image.spelled] : "${name}${trimprefix(tag, image.distribution)}"
    ]]),
    image.component == short_component && contains(["", try(image.row.short[image.framework], "")], image.stack) ?
    image.row.tags : []
  )) : "${REGISTRY}/${image.repository}:${tag}"]
}

# What an image says of itself.
function "labels" {
  params = [image]
  result = merge({
    "org.opencontainers.image.title" = image.target
    "org.opencontainers.image.description" = join(", ", concat(
      ["ROS ${image.row.ros} ${image.component} (${image.distribution})"],
      [for item in image.versions : "${called[item.name].title} ${item.version}" if can(called[item.name])]
    ))
    "org.opencontainers.image.version"     = image.spelled
    "org.opencontainers.image.base.name"   = trimprefix(split("@", image.system.image)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", image.system.image)[1], null)
    "io.rosml.distribution"                = image.distribution
    "io.rosml.component"                   = image.component
    "io.rosml.framework"                   = image.framework
    "io.rosml.stack"                       = image.stack == "" ? null : image.stack
    "io.rosml.os"                          = image.row.os
    "io.rosml.python"                      = image.system.python
    "io.rosml.ros"                         = image.row.ros
    "io.rosml.ros.sync"                    = image.row.apt == null ? null : try(sync_dates[image.distribution], null)
    "io.rosml.experimental"                = image.row.experimental ? "true" : null
    "io.rosml.rmw"                         = image.row.usual_rmw == "" ? null : image.row.usual_rmw
    "io.rosml.runtime"                     = try(image.row.runtime[image.component], null)
    }, {
    for item in image.versions : "io.rosml.${item.name}" => item.version if contains(counted, item.name)
    }, {
    for item in image.gpu : "io.rosml.gpu.${item.name}" => item.value
  })
}

# The structure tests of an image: what depends on its own sum, and in one image of a row what others share with it.
function "tests" {
  params = [image, ros]
  result = concat(
    ["contract", image.runtime ? "runtime" : "tools"],
    image.row.wheels == "" ? [ros, "${ros}-beside"] : ["${ros}-wheels"],
    [for part in image.parts : part.kind if entries[part.kind].tested],
    image.stack != "" || image.runtime || image.row.wheels != "" ? [] : ["${ros}-${image.component}", "${ros}-components"],
    image.carrying && image.component == image.row.lowest ? concat(
      [for part in image.parts : "${part.kind}-build" if entries[part.kind].compiled],
      image.row.wheels == "" ? ["${ros}-workspace", "pip"] : ["pip"]
    ) : []
  )
}

# What these tests hold an image to.
function "expected" {
  params = [image, row]
  result = concat(
    ["os=${row.os}", "python=${image.system.python}", "ros=${row.ros}", "ros_distro=${row.ros_distro}"],
    row.rmw == "" ? [] : ["rmw=${row.rmw}"],
    row.wheels == "" ? [] : ["wheels=${row.wheels}"],
    length(releases) == 0 ? [] : ["releases=${join(",", releases)}"],
    [for component in image.chain :
      "packages_${replace(component, "-", "_")}=${replace(row.packages[component], " ", ",")}"
    if row.packages[component] != "" && !image.runtime],
    [for item in image.versions : "${item.name}=${item.version}"],
    flatten([for item in image.versions : [
      for name, version in try(stacks[image.stack].beside[item.name], {}) : "${name}=${version}"
    ]]),
    [for item in image.gpu : "gpu_${replace(replace(item.name, ".", "_"), "-", "_")}=${replace(item.value, " ", ",")}"]
  )
}

# ---- What is built ---------------------------------------------------------------------------------------------------

# What all targets have in common. Mirrors are secrets like the certificates: an argument would be in the image's history.
target "_common" {
  context = "."
  network = STEP_NETWORK == "" ? null : STEP_NETWORK
  secret = concat(
    CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"],
    ROS_APT_MIRROR == "" ? [] : ["id=ros-apt-mirror,env=ROS_APT_MIRROR"],
    OS_APT_MIRROR == "" ? [] : ["id=os-apt-mirror,env=OS_APT_MIRROR"]
  )
  args = {
    SOURCE_DATE_EPOCH = SOURCE_DATE_EPOCH
    HTTP_PROXY        = given(HTTP_PROXY)
    HTTPS_PROXY       = given(HTTPS_PROXY)
    NO_PROXY          = given(NO_PROXY)
  }
}

# What all images have in common.
target "_image" {
  inherits = ["_common"]
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "org.opencontainers.image.source"   = source
    "org.opencontainers.image.revision" = given(REVISION)
    "org.opencontainers.image.created"  = timeadd("1970-01-01T00:00:00Z", "${SOURCE_DATE_EPOCH}s")
  }
}

# What is in an image.
target "contents" {
  description = "the packages and files of the image that its context `described` is"
  inherits    = ["_common"]
  target      = "contents"
  contexts    = { os = systems[assembler].image }
}

# Operating systems with the essentials.
target "_systems" {
  matrix = { system = distinct([for image in images : { os = image.row.os, runtime = image.runtime }]) }
  name      = os_target(system.os, system.runtime)
  inherits  = ["_common"]
  target    = "base"
  platforms = platforms(systems[system.os].platforms)
  contexts  = { os = systems[system.os].image }
  args      = { NUMPY = systems[system.os].numpy, RUNTIME = system.runtime ? "true" : null }
}

# Images without a framework: each component on the one below it, the lowest on the operating system.
target "_ros" {
  matrix      = { image = [for image in images : image if image.stack == ""] }
  name        = image.target
  description = image.unlocked
  inherits    = ["_image"]
  target      = image.row.wheels == "" ? "ros" : "ros-wheels"
  platforms   = platforms(image.platforms)
  tags        = tags(image)
  labels      = labels(image)
  contexts = merge({
    parent = (
      image.below == "" ? "target:${os_target(image.row.os, image.runtime)}" :
      dependency(image.below, image.repository, image.below)
    )
  }, image.row.wheels == "" ? {} : { os = image.system.image })
  args = merge(
    { ROS_DISTRO = image.row.ros_distro, ROS_VERSION = image.row.ros, ROS_PACKAGES = given(image.packages) },
    image.below != "" ? {} : { ROS_TOOLS = given(join(" ", concat(
      image.runtime ? [] : [overridable(image.system.tools, image.row.tools)],
      [for rmw in compact(split(",", image.row.rmw)) : "ros-${image.row.ros_distro}-${replace(rmw, "_", "-")}"]
    ))) },
    image.runtime ? { RUNTIME = "true" } : {},
    image.row.wheels == "" ? {} : { ROS_ROW = image.distribution, PYTHON = image.system.python },
    image.row.apt == null ? {} : merge(image.row.apt, { ROS_SYNC_DATE = try(sync_dates[image.distribution], "") }),
    !can(image.row.apt.ROS_CHANNEL) ? {} : {
      ROS_CHANNEL  = overridable(image.row.apt.ROS_CHANNEL, ROS_CHANNEL)
      ROS_SNAPSHOT = overridable(image.row.apt.ROS_SNAPSHOT, ROS_SNAPSHOT)
    }
  )
}

# Parts: the files of a part below /out, assembled once and joined to many images.
target "_files" {
  matrix    = { part = parts }
  name      = "_files-${part_name(part.kind, part.stack, part.python)}"
  inherits  = ["_common"]
  target    = "part-files"
  platforms = platforms(part.platforms)
  contexts  = { os = systems[part.os].image }
  args = {
    PART         = part.kind
    SLOT         = given(entries[part.kind].slot)
    SHOWS        = given(shown(part.kind, part.stack))
    STACK        = part.stack
    PYTHON       = part.python
    WHEEL_PYTHON = systems[part.os].python
    ACCELERATOR  = stacks[part.stack].accelerator
  }
}

# Parts as images of their own, which say what they are and what takes them.
target "_part" {
  matrix   = { part = parts }
  name     = "part-${part_name(part.kind, part.stack, part.python)}"
  inherits = ["_files-${part_name(part.kind, part.stack, part.python)}"]
  target   = "part"
  tags     = ["${REGISTRY}/part:${part_name(part.kind, part.stack, part.python)}"]
  labels = merge({
    "org.opencontainers.image.title" = part_name(part.kind, part.stack, part.python)
    "org.opencontainers.image.description" = join(" ", [
      "part ${part.kind} of stack ${part.stack}, for",
      part.python == "any" ? "any Python" : "Python ${part.python}"
    ])
    "io.rosml.part"   = part.kind
    "io.rosml.stack"  = part.stack
    "io.rosml.python" = part.python
    "io.rosml.frameworks" = join(" ", [
      for framework in stacks[part.stack].frameworks : join("=", [framework, join(",", [
        for kind in parts_of(framework, part.stack) : entries[kind].any_python ? "${kind}*" : kind
      ])])
      if contains(frameworks[framework].parts, part.kind)
    ])
    }, {
    for item in entries[part.kind].brings : "io.rosml.${item.name}" => stacks[part.stack].versions[item.name]
    }, {
    for name, value in try(stacks[part.stack].gpu[part.kind], {}) : "io.rosml.gpu.${name}" => value
    }, length(entries[part.kind].brings) == 0 ? {} : {
    "io.rosml.brings" = join(" ", [for item in entries[part.kind].brings : "${item.name}:${item.short}:${item.title}"])
    }, entries[part.kind].release == "" ? {} : {
    "io.rosml.release" = entries[part.kind].release
  })
}

# Images with a framework: a ROS image joined with parts, by a Dockerfile that has a line for each. Nothing runs after
# the join. *_ROOT: where a part's files are: /out/ where it was assembled here, / where it is a published part.
target "_joined" {
  matrix      = { image = [for image in images : image if image.stack != ""] }
  name        = image.target
  description = image.unlocked
  inherits    = ["_image"]
  platforms   = platforms(image.platforms)
  tags        = tags(image)
  labels      = labels(image)
  contexts = merge({ ros = dependency(image.ros, frameworks[plain].repository, image.ros) }, {
    for part in image.parts : "part-${part.kind}" =>
    dependency(part.name, "part", "_files-${part.name}")
  })
  args = { for part in image.parts : "${variable(part.kind)}_ROOT" =>
  can(digests[part.name]) ? "/" : "/out/" }
  dockerfile-inline = join("\n", concat(
    ["FROM ros"],
    [for part in image.parts : format(
      "ARG %s_ROOT\nCOPY --link --from=part-%s $%s_ROOT /",
      variable(part.kind), part.kind, variable(part.kind)
    )],
    [for item in image.versions : "ENV ${variable(item.name)}_VERSION=${item.version}" if contains(counted, item.name)],
    [for item in image.versions : "ENV NVIDIA_REQUIRE_CUDA=cuda>=${split(".", item.version)[0]}.0"
    if item.name == "cuda" && contains(counted, item.name)],
    [""]
  ))
}

# The structure tests of every image, inside the build.
target "_tests" {
  matrix    = { image = images }
  name      = "${image.target}-test"
  inherits  = ["_common"]
  target    = "test"
  platforms = platforms(image.platforms)
  contexts = {
    os    = systems[assembler].image
    image = dependency(image.target, image.repository, image.target)
  }
  args = {
    TESTS  = join(" ", tests(image, "ros${image.row.ros}"))
    EXPECT = join(" ", expected(image, image.row))
  }
  output = ["type=cacheonly"]
}

# ---- Groups ----------------------------------------------------------------------------------------------------------

# The images that have a fact in common; their names alone.
function "having" {
  params = [fact, value]
  result = [for image in built : image.target if image[fact] == value]
}

group "all" { targets = [for image in built : image.target] }
group "tests" { targets = [for image in built : "${image.target}-test"] }
group "parts" {
  targets = distinct(flatten([for image in built : [for part in image.parts : "part-${part.name}"]]))
}
