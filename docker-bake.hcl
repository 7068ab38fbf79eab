# Generated from matrix.yaml by scripts/generate_bake.py: change matrix.yaml, then run
#   make generate
#
#   docker buildx bake bookworm-core          builds an image (and what it stands on)
#   docker buildx bake bookworm-core-test     runs its structure tests inside the build
#   docker buildx bake --print <target>       shows what would be built

# where images live, without https://
variable "REGISTRY" {
  default = "localhost:5000"
}

# base image of bookworm
variable "OS_BOOKWORM" {
  default = "docker-image://docker.io/library/debian:bookworm@sha256:30482e873082e906a4908c10529180aefb6f77620aea7404b909829fadc5d168"
}

# base image of trixie
variable "OS_TRIXIE" {
  default = "docker-image://docker.io/library/debian:trixie@sha256:35b8ff74ead4880f22090b617372daff0ccae742eb5674455d542bef71ef1999"
}

# base image of ubuntu-20.04
variable "OS_UBUNTU_20_04" {
  default = "docker-image://docker.io/library/ubuntu:20.04@sha256:8feb4d8ca5354def3d8fce243717141ce31e2c428701f6682bd2fafe15388214"
}

# base image of ubuntu-22.04
variable "OS_UBUNTU_22_04" {
  default = "docker-image://docker.io/library/ubuntu:22.04@sha256:b8b6ee6aa931ecd9d0d952abc34dc0e5f7c6a30c6bb71b079fe399fde0329c02"
}

# base image of ubuntu-24.04
variable "OS_UBUNTU_24_04" {
  default = "docker-image://docker.io/library/ubuntu:24.04@sha256:69cecf4bbf72d2d44a9eef1b71fb98c7fb973d78af11399deccef19beb008ad9"
}

# base image of ubuntu-26.04
variable "OS_UBUNTU_26_04" {
  default = "docker-image://docker.io/library/ubuntu:26.04@sha256:cd21a4f68a617580279d4b091cb18e3af9fa8a87500665f0ae5f7f757d17d367"
}

# build for this platform only, such as linux/amd64; if empty, for all that a target has
variable "PLATFORM" {
  default = ""
}

# time of every file, in seconds since 1970
variable "SOURCE_DATE_EPOCH" {
  default = "1767225600"
}

# commit that is built, for a label
variable "REVISION" {
  default = ""
}

# JSON text: dependencies to take from the registry, {"torch-cu128-py311": "sha256:…"}
variable "DIGESTS" {
  default = ""
}

# JSON text: the dates of ROS's repositories, {"jazzy": "2026-11-20T21:14:09Z"}
variable "ROS_SYNC_DATES" {
  default = ""
}

# live, snapshot or final, in the place of what matrix.yaml says (make image CHANNEL=final)
variable "ROS_CHANNEL" {
  default = ""
}

# day of the snapshot where ROS_CHANNEL is snapshot: YYYY-MM-DD
variable "ROS_SNAPSHOT" {
  default = ""
}

# file with certificates that build steps trust; never part of a layer
variable "CA_BUNDLE" {
  default = ""
}

# mirror of the hosts that ros_archive names, such as http://host:3142; never part of an image
variable "ROS_APT_MIRROR" {
  default = ""
}

# mirror of the hosts that base images' apt sources name, such as http://host:3142; never part of an image
variable "OS_APT_MIRROR" {
  default = ""
}

# for build steps; never part of an image
variable "HTTP_PROXY" {
  default = ""
}

# for build steps; never part of an image
variable "HTTPS_PROXY" {
  default = ""
}

# for build steps; never part of an image
variable "NO_PROXY" {
  default = ""
}

# The digest of a dependency that is to be taken from the registry; empty if it is to be built here.
function "digest" {
  params = [name]
  result = lookup(jsondecode(DIGESTS == "" ? "{}" : DIGESTS), name, "")
}

# A dependency: built here, unless DIGESTS names it. The only place that decides.
function "dependency" {
  params = [name, repository, target]
  result = digest(name) == "" ? "target:${target}" : "docker-image://${REGISTRY}/${repository}@${digest(name)}"
}

function "image" {
  params = [repository, name]
  result = dependency(name, repository, name)
}

# A payload part, and where its files are in that context.
function "part" {
  params = [name]
  result = dependency(name, "payload", "_files-${name}")
}

function "root" {
  params = [name]
  result = digest(name) == "" ? "/out/" : "/"
}

# The name and the digest of a base image, for labels; no digest, no label.
function "image_name" {
  params = [context]
  result = trimprefix(split("@", context)[0], "docker-image://")
}

function "image_digest" {
  params = [context]
  result = try(split("@", context)[1], null)
}

function "platforms" {
  params = [all]
  result = PLATFORM == "" ? all : [PLATFORM]
}

# The date of the ROS repository of a distribution, where the caller knows it.
function "sync_date" {
  params = [distribution]
  result = lookup(jsondecode(ROS_SYNC_DATES == "" ? "{}" : ROS_SYNC_DATES), distribution, "")
}

# A fact of matrix.yaml, unless the caller says otherwise.
function "overridable" {
  params = [fact, value]
  result = value == "" ? fact : value
}

# A build argument that is left out when it is empty.
function "given" {
  params = [value]
  result = value == "" ? null : value
}

# ---- What targets have in common -----------------------------------------------------------------------------------

target "_common" {
  context = "."
  secret  = concat(CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"], ROS_APT_MIRROR == "" ? [] : ["id=ros-apt-mirror,env=ROS_APT_MIRROR"], OS_APT_MIRROR == "" ? [] : ["id=os-apt-mirror,env=OS_APT_MIRROR"])
  args = {
    SOURCE_DATE_EPOCH = SOURCE_DATE_EPOCH
    HTTP_PROXY        = given(HTTP_PROXY)
    HTTPS_PROXY       = given(HTTPS_PROXY)
    NO_PROXY          = given(NO_PROXY)
  }
}

target "_base" {
  inherits = ["_common"]
  target   = "base"
}

target "_payload" {
  inherits = ["_common"]
}

target "_image" {
  inherits = ["_common"]
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "org.opencontainers.image.revision" = given(REVISION)
    "org.opencontainers.image.created"  = timeadd("1970-01-01T00:00:00Z", "${SOURCE_DATE_EPOCH}s")
  }
}

target "_test" {
  inherits = ["_common"]
  target   = "test"
  contexts = { os = OS_BOOKWORM }
  output   = ["type=cacheonly"]
}

target "file-list" {
  description = "the files of the image that its context `listed` is"
  inherits    = ["_common"]
  target      = "file-list"
  contexts    = { os = OS_BOOKWORM }
}

# ---- Operating systems with the essentials -------------------------------------------------------------------------

target "_os-ubuntu-20-04" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-22-04" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-24-04" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-26-04" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args      = { NUMPY = ">=2.3,<2.4" }
}

target "_os-bookworm" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args      = { NUMPY = "<2" }
}

target "_os-trixie" {
  inherits  = ["_base"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args      = { NUMPY = ">=2.2,<2.3" }
}

# ---- ROS images: a chain of components -----------------------------------------------------------------------------

target "_distribution-noetic" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_20_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_20_04)
    "io.rosml.distribution"                = "noetic"
    "io.rosml.os"                          = "ubuntu-20.04"
    "io.rosml.python"                      = "3.8"
    "io.rosml.ros"                         = "1"
    "io.rosml.ros.sync"                    = given(sync_date("noetic"))
  }
}

target "_ros-noetic" {
  inherits = ["_distribution-noetic"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "noetic"
    ROS_VERSION          = "1"
    ROS_CHANNEL          = overridable("final", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/noetic/{day}/ubuntu"
    ROS_CODENAME         = "focal"
    ROS_SYNC_DATE        = sync_date("noetic")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "noetic-core" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-core"]
  contexts = { parent = "target:_os-ubuntu-20-04" }
  args = {
    ROS_PACKAGES = "ros-noetic-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core"
    "org.opencontainers.image.description" = "ROS 1 core (noetic)"
    "org.opencontainers.image.version"     = "noetic-core"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-base", "${REGISTRY}/ros:noetic"]
  contexts = { parent = image("ros", "noetic-core") }
  args     = { ROS_PACKAGES = "ros-noetic-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base"
    "org.opencontainers.image.description" = "ROS 1 base (noetic)"
    "org.opencontainers.image.version"     = "noetic-base"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-robot"]
  contexts = { parent = image("ros", "noetic-base") }
  args     = { ROS_PACKAGES = "ros-noetic-robot" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic)"
    "org.opencontainers.image.version"     = "noetic-robot"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-perception"]
  contexts = { parent = image("ros", "noetic-robot") }
  args     = { ROS_PACKAGES = "ros-noetic-perception" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic)"
    "org.opencontainers.image.version"     = "noetic-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-desktop"]
  contexts = { parent = image("ros", "noetic-perception") }
  args     = { ROS_PACKAGES = "ros-noetic-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic)"
    "org.opencontainers.image.version"     = "noetic-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full" {
  inherits = ["_ros-noetic"]
  tags     = ["${REGISTRY}/ros:noetic-desktop-full"]
  contexts = { parent = image("ros", "noetic-desktop") }
  args     = { ROS_PACKAGES = "ros-noetic-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic)"
    "org.opencontainers.image.version"     = "noetic-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-foxy" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_20_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_20_04)
    "io.rosml.distribution"                = "foxy"
    "io.rosml.os"                          = "ubuntu-20.04"
    "io.rosml.python"                      = "3.8"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("foxy"))
  }
}

target "_ros-foxy" {
  inherits = ["_distribution-foxy"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "foxy"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("final", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/foxy/{day}/ubuntu"
    ROS_CODENAME         = "focal"
    ROS_SYNC_DATE        = sync_date("foxy")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "foxy-core" {
  inherits = ["_ros-foxy"]
  tags     = ["${REGISTRY}/ros:foxy-core"]
  contexts = { parent = "target:_os-ubuntu-20-04" }
  args = {
    ROS_PACKAGES = "ros-foxy-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core"
    "org.opencontainers.image.description" = "ROS 2 core (foxy)"
    "org.opencontainers.image.version"     = "foxy-core"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base" {
  inherits = ["_ros-foxy"]
  tags     = ["${REGISTRY}/ros:foxy-base", "${REGISTRY}/ros:foxy"]
  contexts = { parent = image("ros", "foxy-core") }
  args     = { ROS_PACKAGES = "ros-foxy-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base"
    "org.opencontainers.image.description" = "ROS 2 base (foxy)"
    "org.opencontainers.image.version"     = "foxy-base"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop" {
  inherits = ["_ros-foxy"]
  tags     = ["${REGISTRY}/ros:foxy-desktop"]
  contexts = { parent = image("ros", "foxy-base") }
  args     = { ROS_PACKAGES = "ros-foxy-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy)"
    "org.opencontainers.image.version"     = "foxy-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "_distribution-humble" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_22_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_22_04)
    "io.rosml.distribution"                = "humble"
    "io.rosml.os"                          = "ubuntu-22.04"
    "io.rosml.python"                      = "3.10"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("humble"))
  }
}

target "_ros-humble" {
  inherits = ["_distribution-humble"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "humble"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("live", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/humble/{day}/ubuntu"
    ROS_CODENAME         = "jammy"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.jammy_all.deb@sha256:767884cf4ed03116b9d64438930a832ed854147ae435279a7924dfdf60f94433"
    ROS_SYNC_DATE        = sync_date("humble")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "humble-core" {
  inherits = ["_ros-humble"]
  tags     = ["${REGISTRY}/ros:humble-core"]
  contexts = { parent = "target:_os-ubuntu-22-04" }
  args = {
    ROS_PACKAGES = "ros-humble-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "humble-core"
    "org.opencontainers.image.description" = "ROS 2 core (humble)"
    "org.opencontainers.image.version"     = "humble-core"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base" {
  inherits = ["_ros-humble"]
  tags     = ["${REGISTRY}/ros:humble-base", "${REGISTRY}/ros:humble"]
  contexts = { parent = image("ros", "humble-core") }
  args     = { ROS_PACKAGES = "ros-humble-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "humble-base"
    "org.opencontainers.image.description" = "ROS 2 base (humble)"
    "org.opencontainers.image.version"     = "humble-base"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception" {
  inherits = ["_ros-humble"]
  tags     = ["${REGISTRY}/ros:humble-perception"]
  contexts = { parent = image("ros", "humble-base") }
  args     = { ROS_PACKAGES = "ros-humble-perception" }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (humble)"
    "org.opencontainers.image.version"     = "humble-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop" {
  inherits = ["_ros-humble"]
  tags     = ["${REGISTRY}/ros:humble-desktop"]
  contexts = { parent = image("ros", "humble-perception") }
  args     = { ROS_PACKAGES = "ros-humble-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble)"
    "org.opencontainers.image.version"     = "humble-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full" {
  inherits = ["_ros-humble"]
  tags     = ["${REGISTRY}/ros:humble-desktop-full"]
  contexts = { parent = image("ros", "humble-desktop") }
  args     = { ROS_PACKAGES = "ros-humble-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble)"
    "org.opencontainers.image.version"     = "humble-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-iron" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_22_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_22_04)
    "io.rosml.distribution"                = "iron"
    "io.rosml.os"                          = "ubuntu-22.04"
    "io.rosml.python"                      = "3.10"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("iron"))
  }
}

target "_ros-iron" {
  inherits = ["_distribution-iron"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "iron"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("final", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/iron/{day}/ubuntu"
    ROS_CODENAME         = "jammy"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.jammy_all.deb@sha256:767884cf4ed03116b9d64438930a832ed854147ae435279a7924dfdf60f94433"
    ROS_SYNC_DATE        = sync_date("iron")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "iron-core" {
  inherits = ["_ros-iron"]
  tags     = ["${REGISTRY}/ros:iron-core"]
  contexts = { parent = "target:_os-ubuntu-22-04" }
  args = {
    ROS_PACKAGES = "ros-iron-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "iron-core"
    "org.opencontainers.image.description" = "ROS 2 core (iron)"
    "org.opencontainers.image.version"     = "iron-core"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base" {
  inherits = ["_ros-iron"]
  tags     = ["${REGISTRY}/ros:iron-base", "${REGISTRY}/ros:iron"]
  contexts = { parent = image("ros", "iron-core") }
  args     = { ROS_PACKAGES = "ros-iron-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "iron-base"
    "org.opencontainers.image.description" = "ROS 2 base (iron)"
    "org.opencontainers.image.version"     = "iron-base"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception" {
  inherits = ["_ros-iron"]
  tags     = ["${REGISTRY}/ros:iron-perception"]
  contexts = { parent = image("ros", "iron-base") }
  args     = { ROS_PACKAGES = "ros-iron-perception" }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (iron)"
    "org.opencontainers.image.version"     = "iron-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop" {
  inherits = ["_ros-iron"]
  tags     = ["${REGISTRY}/ros:iron-desktop"]
  contexts = { parent = image("ros", "iron-perception") }
  args     = { ROS_PACKAGES = "ros-iron-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron)"
    "org.opencontainers.image.version"     = "iron-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full" {
  inherits = ["_ros-iron"]
  tags     = ["${REGISTRY}/ros:iron-desktop-full"]
  contexts = { parent = image("ros", "iron-desktop") }
  args     = { ROS_PACKAGES = "ros-iron-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron)"
    "org.opencontainers.image.version"     = "iron-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-jazzy" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_24_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_24_04)
    "io.rosml.distribution"                = "jazzy"
    "io.rosml.os"                          = "ubuntu-24.04"
    "io.rosml.python"                      = "3.12"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("jazzy"))
  }
}

target "_ros-jazzy" {
  inherits = ["_distribution-jazzy"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "jazzy"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("live", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/jazzy/{day}/ubuntu"
    ROS_CODENAME         = "noble"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.noble_all.deb@sha256:0804d9b13db770eb87019be414cd78378835228ad5fa801fc88758596dd8f7e5"
    ROS_SYNC_DATE        = sync_date("jazzy")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "jazzy-core" {
  inherits = ["_ros-jazzy"]
  tags     = ["${REGISTRY}/ros:jazzy-core"]
  contexts = { parent = "target:_os-ubuntu-24-04" }
  args = {
    ROS_PACKAGES = "ros-jazzy-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-core"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base" {
  inherits = ["_ros-jazzy"]
  tags     = ["${REGISTRY}/ros:jazzy-base", "${REGISTRY}/ros:jazzy"]
  contexts = { parent = image("ros", "jazzy-core") }
  args     = { ROS_PACKAGES = "ros-jazzy-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-base"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception" {
  inherits = ["_ros-jazzy"]
  tags     = ["${REGISTRY}/ros:jazzy-perception"]
  contexts = { parent = image("ros", "jazzy-base") }
  args     = { ROS_PACKAGES = "ros-jazzy-perception" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop" {
  inherits = ["_ros-jazzy"]
  tags     = ["${REGISTRY}/ros:jazzy-desktop"]
  contexts = { parent = image("ros", "jazzy-perception") }
  args     = { ROS_PACKAGES = "ros-jazzy-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full" {
  inherits = ["_ros-jazzy"]
  tags     = ["${REGISTRY}/ros:jazzy-desktop-full"]
  contexts = { parent = image("ros", "jazzy-desktop") }
  args     = { ROS_PACKAGES = "ros-jazzy-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-kilted" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_24_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_24_04)
    "io.rosml.distribution"                = "kilted"
    "io.rosml.os"                          = "ubuntu-24.04"
    "io.rosml.python"                      = "3.12"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("kilted"))
  }
}

target "_ros-kilted" {
  inherits = ["_distribution-kilted"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "kilted"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("live", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/kilted/{day}/ubuntu"
    ROS_CODENAME         = "noble"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.noble_all.deb@sha256:0804d9b13db770eb87019be414cd78378835228ad5fa801fc88758596dd8f7e5"
    ROS_SYNC_DATE        = sync_date("kilted")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "kilted-core" {
  inherits = ["_ros-kilted"]
  tags     = ["${REGISTRY}/ros:kilted-core"]
  contexts = { parent = "target:_os-ubuntu-24-04" }
  args = {
    ROS_PACKAGES = "ros-kilted-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core"
    "org.opencontainers.image.description" = "ROS 2 core (kilted)"
    "org.opencontainers.image.version"     = "kilted-core"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base" {
  inherits = ["_ros-kilted"]
  tags     = ["${REGISTRY}/ros:kilted-base", "${REGISTRY}/ros:kilted"]
  contexts = { parent = image("ros", "kilted-core") }
  args     = { ROS_PACKAGES = "ros-kilted-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base"
    "org.opencontainers.image.description" = "ROS 2 base (kilted)"
    "org.opencontainers.image.version"     = "kilted-base"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception" {
  inherits = ["_ros-kilted"]
  tags     = ["${REGISTRY}/ros:kilted-perception"]
  contexts = { parent = image("ros", "kilted-base") }
  args     = { ROS_PACKAGES = "ros-kilted-perception" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted)"
    "org.opencontainers.image.version"     = "kilted-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop" {
  inherits = ["_ros-kilted"]
  tags     = ["${REGISTRY}/ros:kilted-desktop"]
  contexts = { parent = image("ros", "kilted-perception") }
  args     = { ROS_PACKAGES = "ros-kilted-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted)"
    "org.opencontainers.image.version"     = "kilted-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full" {
  inherits = ["_ros-kilted"]
  tags     = ["${REGISTRY}/ros:kilted-desktop-full"]
  contexts = { parent = image("ros", "kilted-desktop") }
  args     = { ROS_PACKAGES = "ros-kilted-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted)"
    "org.opencontainers.image.version"     = "kilted-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-lyrical" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_26_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_26_04)
    "io.rosml.distribution"                = "lyrical"
    "io.rosml.os"                          = "ubuntu-26.04"
    "io.rosml.python"                      = "3.14"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("lyrical"))
  }
}

target "_ros-lyrical" {
  inherits = ["_distribution-lyrical"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "lyrical"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("live", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/lyrical/{day}/ubuntu"
    ROS_CODENAME         = "resolute"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.resolute_all.deb@sha256:a275b9b819874e745a928e83e39c429fa4d607159285c4ef3ebcf75afa732ee3"
    ROS_SYNC_DATE        = sync_date("lyrical")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "lyrical-core" {
  inherits = ["_ros-lyrical"]
  tags     = ["${REGISTRY}/ros:lyrical-core"]
  contexts = { parent = "target:_os-ubuntu-26-04" }
  args = {
    ROS_PACKAGES = "ros-lyrical-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-core"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base" {
  inherits = ["_ros-lyrical"]
  tags     = ["${REGISTRY}/ros:lyrical-base", "${REGISTRY}/ros:lyrical", "${REGISTRY}/ros:latest"]
  contexts = { parent = image("ros", "lyrical-core") }
  args     = { ROS_PACKAGES = "ros-lyrical-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-base"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception" {
  inherits = ["_ros-lyrical"]
  tags     = ["${REGISTRY}/ros:lyrical-perception"]
  contexts = { parent = image("ros", "lyrical-base") }
  args     = { ROS_PACKAGES = "ros-lyrical-perception" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop" {
  inherits = ["_ros-lyrical"]
  tags     = ["${REGISTRY}/ros:lyrical-desktop"]
  contexts = { parent = image("ros", "lyrical-perception") }
  args     = { ROS_PACKAGES = "ros-lyrical-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full" {
  inherits = ["_ros-lyrical"]
  tags     = ["${REGISTRY}/ros:lyrical-desktop-full"]
  contexts = { parent = image("ros", "lyrical-desktop") }
  args     = { ROS_PACKAGES = "ros-lyrical-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-rolling" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_UBUNTU_26_04)
    "org.opencontainers.image.base.digest" = image_digest(OS_UBUNTU_26_04)
    "io.rosml.distribution"                = "rolling"
    "io.rosml.os"                          = "ubuntu-26.04"
    "io.rosml.python"                      = "3.14"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = given(sync_date("rolling"))
  }
}

target "_ros-rolling" {
  inherits = ["_distribution-rolling"]
  target   = "ros"
  args = {
    ROS_DISTRO           = "rolling"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = overridable("live", ROS_CHANNEL)
    ROS_SNAPSHOT         = overridable("", ROS_SNAPSHOT)
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/rolling/{day}/ubuntu"
    ROS_CODENAME         = "resolute"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.2.0/ros2-apt-source_1.2.0.resolute_all.deb@sha256:a275b9b819874e745a928e83e39c429fa4d607159285c4ef3ebcf75afa732ee3"
    ROS_SYNC_DATE        = sync_date("rolling")
  }
  labels = { "io.rosml.framework" = "none" }
}

target "rolling-core" {
  inherits = ["_ros-rolling"]
  tags     = ["${REGISTRY}/ros:rolling-core"]
  contexts = { parent = "target:_os-ubuntu-26-04" }
  args = {
    ROS_PACKAGES = "ros-rolling-ros-core"
    ROS_TOOLS    = "python3-colcon-common-extensions python3-rosdep python3-vcstool"
  }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core"
    "org.opencontainers.image.description" = "ROS 2 core (rolling)"
    "org.opencontainers.image.version"     = "rolling-core"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base" {
  inherits = ["_ros-rolling"]
  tags     = ["${REGISTRY}/ros:rolling-base", "${REGISTRY}/ros:rolling"]
  contexts = { parent = image("ros", "rolling-core") }
  args     = { ROS_PACKAGES = "ros-rolling-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base"
    "org.opencontainers.image.description" = "ROS 2 base (rolling)"
    "org.opencontainers.image.version"     = "rolling-base"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception" {
  inherits = ["_ros-rolling"]
  tags     = ["${REGISTRY}/ros:rolling-perception"]
  contexts = { parent = image("ros", "rolling-base") }
  args     = { ROS_PACKAGES = "ros-rolling-perception" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling)"
    "org.opencontainers.image.version"     = "rolling-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop" {
  inherits = ["_ros-rolling"]
  tags     = ["${REGISTRY}/ros:rolling-desktop"]
  contexts = { parent = image("ros", "rolling-perception") }
  args     = { ROS_PACKAGES = "ros-rolling-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling)"
    "org.opencontainers.image.version"     = "rolling-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full" {
  inherits = ["_ros-rolling"]
  tags     = ["${REGISTRY}/ros:rolling-desktop-full"]
  contexts = { parent = image("ros", "rolling-desktop") }
  args     = { ROS_PACKAGES = "ros-rolling-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling)"
    "org.opencontainers.image.version"     = "rolling-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-bookworm" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_BOOKWORM)
    "org.opencontainers.image.base.digest" = image_digest(OS_BOOKWORM)
    "io.rosml.distribution"                = "bookworm"
    "io.rosml.os"                          = "bookworm"
    "io.rosml.python"                      = "3.11"
    "io.rosml.ros"                         = "1"
  }
}

target "_ros-bookworm" {
  inherits = ["_distribution-bookworm"]
  target   = "ros"
  args = {
    ROS_DISTRO  = "Debian"
    ROS_VERSION = "1"
  }
  labels = { "io.rosml.framework" = "none" }
}

target "bookworm-core" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-core"]
  contexts = { parent = "target:_os-bookworm" }
  args = {
    ROS_PACKAGES = "ros-core ros-core-dev ros-core-python-dev"
    ROS_TOOLS    = "rosbash catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-core"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-base", "${REGISTRY}/ros:bookworm"]
  contexts = { parent = image("ros", "bookworm-core") }
  args     = { ROS_PACKAGES = "ros-base ros-base-dev ros-base-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-base"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-robot"]
  contexts = { parent = image("ros", "bookworm-base") }
  args     = { ROS_PACKAGES = "ros-robot ros-robot-dev ros-robot-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-robot"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-perception"]
  contexts = { parent = image("ros", "bookworm-robot") }
  args     = { ROS_PACKAGES = "ros-perception ros-perception-dev ros-perception-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-desktop"]
  contexts = { parent = image("ros", "bookworm-perception") }
  args     = { ROS_PACKAGES = "ros-desktop ros-desktop-dev ros-desktop-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full" {
  inherits = ["_ros-bookworm"]
  tags     = ["${REGISTRY}/ros:bookworm-desktop-full"]
  contexts = { parent = image("ros", "bookworm-desktop") }
  args     = { ROS_PACKAGES = "ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm)"
    "org.opencontainers.image.version"     = "bookworm-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-trixie" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_TRIXIE)
    "org.opencontainers.image.base.digest" = image_digest(OS_TRIXIE)
    "io.rosml.distribution"                = "trixie"
    "io.rosml.os"                          = "trixie"
    "io.rosml.python"                      = "3.13"
    "io.rosml.ros"                         = "1"
  }
}

target "_ros-trixie" {
  inherits = ["_distribution-trixie"]
  target   = "ros"
  args = {
    ROS_DISTRO  = "Debian"
    ROS_VERSION = "1"
  }
  labels = { "io.rosml.framework" = "none" }
}

target "trixie-core" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-core"]
  contexts = { parent = "target:_os-trixie" }
  args = {
    ROS_PACKAGES = "ros-core ros-core-dev ros-core-python-dev"
    ROS_TOOLS    = "rosbash catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core"
    "org.opencontainers.image.description" = "ROS 1 core (trixie)"
    "org.opencontainers.image.version"     = "trixie-core"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-base", "${REGISTRY}/ros:trixie"]
  contexts = { parent = image("ros", "trixie-core") }
  args     = { ROS_PACKAGES = "ros-base ros-base-dev ros-base-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base"
    "org.opencontainers.image.description" = "ROS 1 base (trixie)"
    "org.opencontainers.image.version"     = "trixie-base"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-robot"]
  contexts = { parent = image("ros", "trixie-base") }
  args     = { ROS_PACKAGES = "ros-robot ros-robot-dev ros-robot-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie)"
    "org.opencontainers.image.version"     = "trixie-robot"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-perception"]
  contexts = { parent = image("ros", "trixie-robot") }
  args     = { ROS_PACKAGES = "ros-perception ros-perception-dev ros-perception-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie)"
    "org.opencontainers.image.version"     = "trixie-perception"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-desktop"]
  contexts = { parent = image("ros", "trixie-perception") }
  args     = { ROS_PACKAGES = "ros-desktop ros-desktop-dev ros-desktop-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie)"
    "org.opencontainers.image.version"     = "trixie-desktop"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full" {
  inherits = ["_ros-trixie"]
  tags     = ["${REGISTRY}/ros:trixie-desktop-full"]
  contexts = { parent = image("ros", "trixie-desktop") }
  args     = { ROS_PACKAGES = "ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie)"
    "org.opencontainers.image.version"     = "trixie-desktop-full"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_distribution-jazzy-wheels" {
  inherits  = ["_image"]
  platforms = platforms(["linux/amd64"])
  labels = {
    "org.opencontainers.image.base.name"   = image_name(OS_BOOKWORM)
    "org.opencontainers.image.base.digest" = image_digest(OS_BOOKWORM)
    "io.rosml.distribution"                = "jazzy-wheels"
    "io.rosml.os"                          = "bookworm"
    "io.rosml.python"                      = "3.11"
    "io.rosml.ros"                         = "2"
    "io.rosml.experimental"                = "true"
  }
}

target "_ros-jazzy-wheels" {
  inherits = ["_distribution-jazzy-wheels"]
  target   = "ros-wheels"
  contexts = { os = OS_BOOKWORM }
  args = {
    ROS_DISTRO  = "jazzy"
    ROS_VERSION = "2"
    ROS_ROW     = "jazzy-wheels"
    PYTHON      = "3.11"
  }
  labels = { "io.rosml.framework" = "none" }
}

target "jazzy-wheels-core" {
  inherits = ["_ros-jazzy-wheels"]
  tags     = ["${REGISTRY}/ros:jazzy-wheels-core"]
  contexts = { parent = "target:_os-bookworm" }
  args = {
    ROS_TOOLS = "python3-rosdep2 vcstool python3-numpy python3-empy colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels)"
    "org.opencontainers.image.version"     = "jazzy-wheels-core"
    "io.rosml.component"                   = "core"
  }
}

# ---- Payloads: assembled once, joined to many images ---------------------------------------------------------------

target "_files-cuda-cu128" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu128"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-cuda-cu128" {
  inherits = ["_files-cuda-cu128"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:cuda-cu128"]
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu128"
    "org.opencontainers.image.description" = "part cuda of stack cu128, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "cuda=cuda torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-cuda-cu130" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu130"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-cuda-cu130" {
  inherits = ["_files-cuda-cu130"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:cuda-cu130"]
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu130"
    "org.opencontainers.image.description" = "part cuda of stack cu130, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.20.0.48"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "cuda=cuda torch=cuda,common,torch"
  }
}

target "_files-cuda-cu121" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu121"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-cuda-cu121" {
  inherits = ["_files-cuda-cu121"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:cuda-cu121"]
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu121"
    "org.opencontainers.image.description" = "part cuda of stack cu121, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "12.1.105"
    "io.rosml.cudnn"                       = "9.1.0.70"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "cuda=cuda torch=cuda,common,torch"
  }
}

target "_files-common-cu121-py38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "common"
    STACK        = "cu121"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu121-py38" {
  inherits = ["_files-common-cu121-py38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu121-py38"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu121-py38"
    "org.opencontainers.image.description" = "part common of stack cu121, for Python 3.8"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "3.8"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu121-py38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "torch"
    STACK        = "cu121"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu121-py38" {
  inherits = ["_files-torch-cu121-py38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu121-py38"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu121-py38"
    "org.opencontainers.image.description" = "part torch of stack cu121, for Python 3.8"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "3.8"
    "io.rosml.torch"                       = "2.4.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu38-py38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "common"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu38-py38" {
  inherits = ["_files-common-cpu38-py38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu38-py38"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu38-py38"
    "org.opencontainers.image.description" = "part common of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu38-py38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu38-py38" {
  inherits = ["_files-torch-cpu38-py38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu38-py38"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu38-py38"
    "org.opencontainers.image.description" = "part torch of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "io.rosml.torch"                       = "2.4.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch"
  }
}

target "_files-tensorflow-cc-cpu38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cpu38"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cc-cpu38" {
  inherits = ["_files-tensorflow-cc-cpu38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cc-cpu38"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cpu38"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cpu38, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.13.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cpu38-py38" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cpu38-py38" {
  inherits = ["_files-tensorflow-cpu38-py38"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu38-py38"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu38-py38"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "io.rosml.tensorflow"                  = "2.13.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu128-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu128-py310" {
  inherits = ["_files-common-cu128-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py310"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py310"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cu128-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu128-py310" {
  inherits = ["_files-torch-cu128-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py310"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py310"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cc-cu128" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cu128"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-tensorflow-cc-cu128" {
  inherits = ["_files-tensorflow-cc-cu128"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cc-cu128"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cu128"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cu128, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cu128-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
  }
}

target "payload-tensorflow-cu128-py310" {
  inherits = ["_files-tensorflow-cu128-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py310"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py310"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu130-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu130-py310" {
  inherits = ["_files-common-cu130-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu130-py310"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py310"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu130-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu130-py310" {
  inherits = ["_files-torch-cu130-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu130-py310"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py310"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.12.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu-py310" {
  inherits = ["_files-common-cpu-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py310"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py310"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu-py310" {
  inherits = ["_files-torch-cpu-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu-py310"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py310"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cc-cpu" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cpu"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cc-cpu" {
  inherits = ["_files-tensorflow-cc-cpu"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cc-cpu"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cpu"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cpu, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cpu-py310" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cpu-py310" {
  inherits = ["_files-tensorflow-cpu-py310"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py310"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py310"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu128-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu128-py312" {
  inherits = ["_files-common-cu128-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py312"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py312"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cu128-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu128-py312" {
  inherits = ["_files-torch-cu128-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py312"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py312"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cu128-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
  }
}

target "payload-tensorflow-cu128-py312" {
  inherits = ["_files-tensorflow-cu128-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py312"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py312"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu130-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu130-py312" {
  inherits = ["_files-common-cu130-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu130-py312"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py312"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu130-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu130-py312" {
  inherits = ["_files-torch-cu130-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu130-py312"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py312"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.12.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu-py312" {
  inherits = ["_files-common-cpu-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py312"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py312"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu-py312" {
  inherits = ["_files-torch-cpu-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu-py312"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py312"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cpu-py312" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cpu-py312" {
  inherits = ["_files-tensorflow-cpu-py312"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py312"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py312"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu128-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu128-py314" {
  inherits = ["_files-common-cu128-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py314"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py314"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cu128-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu128-py314" {
  inherits = ["_files-torch-cu128-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py314"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py314"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu130-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu130-py314" {
  inherits = ["_files-common-cu130-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu130-py314"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py314"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu130-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu130-py314" {
  inherits = ["_files-torch-cu130-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu130-py314"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py314"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.12.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu-py314" {
  inherits = ["_files-common-cpu-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py314"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py314"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu-py314" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu-py314" {
  inherits = ["_files-torch-cpu-py314"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu-py314"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py314"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu128-py311" {
  inherits = ["_files-common-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py311"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py311"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu128-py311" {
  inherits = ["_files-torch-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py311"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py311"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-tensorflow-cu128-py311" {
  inherits = ["_files-tensorflow-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py311"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py311"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu130-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu130-py311" {
  inherits = ["_files-common-cu130-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu130-py311"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py311"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu130-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu130-py311" {
  inherits = ["_files-torch-cu130-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu130-py311"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py311"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.12.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu-py311" {
  inherits = ["_files-common-cpu-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py311"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py311"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu-py311" {
  inherits = ["_files-torch-cpu-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu-py311"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py311"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cpu-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cpu-py311" {
  inherits = ["_files-tensorflow-cpu-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py311"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py311"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu128-py313" {
  inherits = ["_files-common-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py313"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py313"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu128-py313" {
  inherits = ["_files-torch-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py313"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py313"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
  }
}

target "payload-tensorflow-cu128-py313" {
  inherits = ["_files-tensorflow-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py313"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py313"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=cuda,common,tensorflow-cc,tensorflow ml=cuda,common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-common-cu130-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
  }
}

target "payload-common-cu130-py313" {
  inherits = ["_files-common-cu130-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu130-py313"]
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py313"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-torch-cu130-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
  }
}

target "payload-torch-cu130-py313" {
  inherits = ["_files-torch-cu130-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu130-py313"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py313"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.12.1"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=cuda,common,torch"
  }
}

target "_files-common-cpu-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
  }
}

target "payload-common-cpu-py313" {
  inherits = ["_files-common-cpu-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py313"]
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py313"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-torch-cpu-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
  }
}

target "payload-torch-cpu-py313" {
  inherits = ["_files-torch-cpu-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cpu-py313"]
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py313"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,torch,tensorflow-cc,tensorflow"
  }
}

target "_files-tensorflow-cpu-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
  }
}

target "payload-tensorflow-cpu-py313" {
  inherits = ["_files-tensorflow-cpu-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py313"]
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py313"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.parts"                       = "cuda,common,torch,tensorflow-cc,tensorflow"
    "io.rosml.frameworks"                  = "tensorflow=common,tensorflow-cc,tensorflow ml=common,torch,tensorflow-cc,tensorflow"
  }
}

# ---- Images with a framework: a ROS image joined with payloads -----------------------------------------------------

target "_join-cuda-cu128-ubuntu-20-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "noetic-core-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-core-cu128", "${REGISTRY}/ros-cuda:noetic-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-base-cu128", "${REGISTRY}/ros-cuda:noetic-base-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-robot-cu128", "${REGISTRY}/ros-cuda:noetic-robot-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-perception-cu128", "${REGISTRY}/ros-cuda:noetic-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-desktop-cu128", "${REGISTRY}/ros-cuda:noetic-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-cuda-cu128" {
  inherits = ["_distribution-noetic", "_join-cuda-cu128-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-ubuntu-20-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "noetic-core-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-core-cu130", "${REGISTRY}/ros-cuda:noetic-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-base-cu130", "${REGISTRY}/ros-cuda:noetic-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-robot-cu130", "${REGISTRY}/ros-cuda:noetic-robot-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-perception-cu130", "${REGISTRY}/ros-cuda:noetic-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-desktop-cu130", "${REGISTRY}/ros-cuda:noetic-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-cuda-cu130" {
  inherits = ["_distribution-noetic", "_join-cuda-cu130-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-ubuntu-20-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "noetic-core-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-core-cu121", "${REGISTRY}/ros-cuda:noetic-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-cu121",
    "${REGISTRY}/ros-cuda:noetic-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:noetic",
  ]
  contexts = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-robot-cu121", "${REGISTRY}/ros-cuda:noetic-robot-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-perception-cu121", "${REGISTRY}/ros-cuda:noetic-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:noetic-desktop-cu121", "${REGISTRY}/ros-cuda:noetic-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-cuda-cu121" {
  inherits = ["_distribution-noetic", "_join-cuda-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu121-ubuntu-20-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu121")
    part-common = part("common-cu121-py38")
    part-torch  = part("torch-cu121-py38")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    COMMON_ROOT   = root("common-cu121-py38")
    TORCH_ROOT    = root("torch-cu121-py38")
    TORCH_VERSION = "2.4.1"
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu121"
    "io.rosml.torch"     = "2.4.1"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "noetic-core-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:noetic-core-cu121", "${REGISTRY}/ros-torch:noetic-core-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-cu121-torch2.4.1"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-torch:noetic-base-cu121",
    "${REGISTRY}/ros-torch:noetic-base-cu121-torch2.4.1",
    "${REGISTRY}/ros-torch:noetic",
  ]
  contexts = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-cu121-torch2.4.1"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:noetic-robot-cu121", "${REGISTRY}/ros-torch:noetic-robot-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-robot-cu121-torch2.4.1"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:noetic-perception-cu121", "${REGISTRY}/ros-torch:noetic-perception-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-perception-cu121-torch2.4.1"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:noetic-desktop-cu121", "${REGISTRY}/ros-torch:noetic-desktop-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-torch-cu121" {
  inherits = ["_distribution-noetic", "_join-torch-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-full-cu121",
    "${REGISTRY}/ros-torch:noetic-desktop-full-cu121-torch2.4.1",
  ]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu38-ubuntu-20-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu38-py38")
    part-torch  = part("torch-cpu38-py38")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu38-py38")
    TORCH_ROOT    = root("torch-cpu38-py38")
    TORCH_VERSION = "2.4.1"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu38"
    "io.rosml.torch"     = "2.4.1"
  }
}

target "noetic-core-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:noetic-core-cpu38", "${REGISTRY}/ros-torch:noetic-core-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-core-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:noetic-base-cpu38", "${REGISTRY}/ros-torch:noetic-base-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-base-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:noetic-robot-cpu38", "${REGISTRY}/ros-torch:noetic-robot-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-robot-cpu38-torch2.4.1"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:noetic-perception-cpu38", "${REGISTRY}/ros-torch:noetic-perception-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-perception-cpu38-torch2.4.1"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:noetic-desktop-cpu38", "${REGISTRY}/ros-torch:noetic-desktop-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-desktop-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-noetic", "_join-torch-cpu38-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-full-cpu38",
    "${REGISTRY}/ros-torch:noetic-desktop-full-cpu38-torch2.4.1",
  ]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cpu38-ubuntu-20-04" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu38-py38")
    part-tensorflow-cc = part("tensorflow-cc-cpu38")
    part-tensorflow    = part("tensorflow-cpu38-py38")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu38-py38")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu38")
    TENSORFLOW_ROOT    = root("tensorflow-cpu38-py38")
    TENSORFLOW_VERSION = "2.13.1"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cpu38"
    "io.rosml.tensorflow" = "2.13.1"
  }
}

target "noetic-core-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-core-cpu38", "${REGISTRY}/ros-tf:noetic-core-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-core-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core"
  }
}

target "noetic-base-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-base-cpu38", "${REGISTRY}/ros-tf:noetic-base-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-base-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base"
  }
}

target "noetic-robot-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-robot-cpu38", "${REGISTRY}/ros-tf:noetic-robot-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-robot-cpu38-tf2.13.1"
    "io.rosml.component"                   = "robot"
  }
}

target "noetic-perception-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-perception-cpu38", "${REGISTRY}/ros-tf:noetic-perception-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-perception-cpu38-tf2.13.1"
    "io.rosml.component"                   = "perception"
  }
}

target "noetic-desktop-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-desktop-cpu38", "${REGISTRY}/ros-tf:noetic-desktop-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-desktop-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "noetic-desktop-full-tensorflow-cpu38" {
  inherits = ["_distribution-noetic", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:noetic-desktop-full-cpu38", "${REGISTRY}/ros-tf:noetic-desktop-full-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "foxy-core-cuda-cu128" {
  inherits = ["_distribution-foxy", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-core-cu128", "${REGISTRY}/ros-cuda:foxy-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-cuda-cu128" {
  inherits = ["_distribution-foxy", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-base-cu128", "${REGISTRY}/ros-cuda:foxy-base-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-cuda-cu128" {
  inherits = ["_distribution-foxy", "_join-cuda-cu128-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-desktop-cu128", "${REGISTRY}/ros-cuda:foxy-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "foxy-core-cuda-cu130" {
  inherits = ["_distribution-foxy", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-core-cu130", "${REGISTRY}/ros-cuda:foxy-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-cuda-cu130" {
  inherits = ["_distribution-foxy", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-base-cu130", "${REGISTRY}/ros-cuda:foxy-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-cuda-cu130" {
  inherits = ["_distribution-foxy", "_join-cuda-cu130-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-desktop-cu130", "${REGISTRY}/ros-cuda:foxy-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "foxy-core-cuda-cu121" {
  inherits = ["_distribution-foxy", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-core-cu121", "${REGISTRY}/ros-cuda:foxy-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-cuda-cu121" {
  inherits = ["_distribution-foxy", "_join-cuda-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-cu121",
    "${REGISTRY}/ros-cuda:foxy-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:foxy",
  ]
  contexts = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-cuda-cu121" {
  inherits = ["_distribution-foxy", "_join-cuda-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-cuda:foxy-desktop-cu121", "${REGISTRY}/ros-cuda:foxy-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "foxy-core-torch-cu121" {
  inherits = ["_distribution-foxy", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:foxy-core-cu121", "${REGISTRY}/ros-torch:foxy-core-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-cu121-torch2.4.1"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-torch-cu121" {
  inherits = ["_distribution-foxy", "_join-torch-cu121-ubuntu-20-04"]
  tags = [
    "${REGISTRY}/ros-torch:foxy-base-cu121",
    "${REGISTRY}/ros-torch:foxy-base-cu121-torch2.4.1",
    "${REGISTRY}/ros-torch:foxy",
  ]
  contexts = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-cu121-torch2.4.1"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-torch-cu121" {
  inherits = ["_distribution-foxy", "_join-torch-cu121-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-torch:foxy-desktop-cu121", "${REGISTRY}/ros-torch:foxy-desktop-cu121-torch2.4.1"]
  contexts = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-desktop-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "foxy-core-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-foxy", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:foxy-core-cpu38", "${REGISTRY}/ros-torch:foxy-core-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-core-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-foxy", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:foxy-base-cpu38", "${REGISTRY}/ros-torch:foxy-base-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-base-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-torch-cpu38" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-foxy", "_join-torch-cpu38-ubuntu-20-04"]
  tags        = ["${REGISTRY}/ros-torch:foxy-desktop-cpu38", "${REGISTRY}/ros-torch:foxy-desktop-cpu38-torch2.4.1"]
  contexts    = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-desktop-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "foxy-core-tensorflow-cpu38" {
  inherits = ["_distribution-foxy", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:foxy-core-cpu38", "${REGISTRY}/ros-tf:foxy-core-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-core-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core"
  }
}

target "foxy-base-tensorflow-cpu38" {
  inherits = ["_distribution-foxy", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:foxy-base-cpu38", "${REGISTRY}/ros-tf:foxy-base-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-base-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base"
  }
}

target "foxy-desktop-tensorflow-cpu38" {
  inherits = ["_distribution-foxy", "_join-tensorflow-cpu38-ubuntu-20-04"]
  tags     = ["${REGISTRY}/ros-tf:foxy-desktop-cpu38", "${REGISTRY}/ros-tf:foxy-desktop-cpu38-tf2.13.1"]
  contexts = { ros = image("ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-desktop-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "_join-cuda-cu128-ubuntu-22-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "humble-core-cuda-cu128" {
  inherits = ["_distribution-humble", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-core-cu128", "${REGISTRY}/ros-cuda:humble-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-cuda-cu128" {
  inherits = ["_distribution-humble", "_join-cuda-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-cu128",
    "${REGISTRY}/ros-cuda:humble-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:humble",
  ]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-cuda-cu128" {
  inherits = ["_distribution-humble", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-perception-cu128", "${REGISTRY}/ros-cuda:humble-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-cuda-cu128" {
  inherits = ["_distribution-humble", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-desktop-cu128", "${REGISTRY}/ros-cuda:humble-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-cuda-cu128" {
  inherits = ["_distribution-humble", "_join-cuda-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-ubuntu-22-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "humble-core-cuda-cu130" {
  inherits = ["_distribution-humble", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-core-cu130", "${REGISTRY}/ros-cuda:humble-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-cuda-cu130" {
  inherits = ["_distribution-humble", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-base-cu130", "${REGISTRY}/ros-cuda:humble-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-cuda-cu130" {
  inherits = ["_distribution-humble", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-perception-cu130", "${REGISTRY}/ros-cuda:humble-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-cuda-cu130" {
  inherits = ["_distribution-humble", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-desktop-cu130", "${REGISTRY}/ros-cuda:humble-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-cuda-cu130" {
  inherits = ["_distribution-humble", "_join-cuda-cu130-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-ubuntu-22-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "humble-core-cuda-cu121" {
  inherits = ["_distribution-humble", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-core-cu121", "${REGISTRY}/ros-cuda:humble-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-cuda-cu121" {
  inherits = ["_distribution-humble", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-base-cu121", "${REGISTRY}/ros-cuda:humble-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-cuda-cu121" {
  inherits = ["_distribution-humble", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-perception-cu121", "${REGISTRY}/ros-cuda:humble-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-cuda-cu121" {
  inherits = ["_distribution-humble", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:humble-desktop-cu121", "${REGISTRY}/ros-cuda:humble-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-cuda-cu121" {
  inherits = ["_distribution-humble", "_join-cuda-cu121-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu128-ubuntu-22-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu128")
    part-common = part("common-cu128-py310")
    part-torch  = part("torch-cu128-py310")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    COMMON_ROOT   = root("common-cu128-py310")
    TORCH_ROOT    = root("torch-cu128-py310")
    TORCH_VERSION = "2.10.0"
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu128"
    "io.rosml.torch"     = "2.10.0"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "humble-core-torch-cu128" {
  inherits = ["_distribution-humble", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-core-cu128", "${REGISTRY}/ros-torch:humble-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-torch-cu128" {
  inherits = ["_distribution-humble", "_join-torch-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-torch:humble-base-cu128",
    "${REGISTRY}/ros-torch:humble-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:humble",
  ]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-torch-cu128" {
  inherits = ["_distribution-humble", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-perception-cu128", "${REGISTRY}/ros-torch:humble-perception-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-torch-cu128" {
  inherits = ["_distribution-humble", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-desktop-cu128", "${REGISTRY}/ros-torch:humble-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-torch-cu128" {
  inherits = ["_distribution-humble", "_join-torch-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-full-cu128",
    "${REGISTRY}/ros-torch:humble-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu130-ubuntu-22-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-cuda   = part("cuda-cu130")
    part-common = part("common-cu130-py310")
    part-torch  = part("torch-cu130-py310")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    COMMON_ROOT   = root("common-cu130-py310")
    TORCH_ROOT    = root("torch-cu130-py310")
    TORCH_VERSION = "2.12.1"
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu130"
    "io.rosml.torch"     = "2.12.1"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "humble-core-torch-cu130" {
  inherits = ["_distribution-humble", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-core-cu130", "${REGISTRY}/ros-torch:humble-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-torch-cu130" {
  inherits = ["_distribution-humble", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-base-cu130", "${REGISTRY}/ros-torch:humble-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-torch-cu130" {
  inherits = ["_distribution-humble", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-perception-cu130", "${REGISTRY}/ros-torch:humble-perception-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-torch-cu130" {
  inherits = ["_distribution-humble", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-desktop-cu130", "${REGISTRY}/ros-torch:humble-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-torch-cu130" {
  inherits = ["_distribution-humble", "_join-torch-cu130-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-full-cu130",
    "${REGISTRY}/ros-torch:humble-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu-ubuntu-22-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu-py310")
    part-torch  = part("torch-cpu-py310")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu-py310")
    TORCH_ROOT    = root("torch-cpu-py310")
    TORCH_VERSION = "2.10.0"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu"
    "io.rosml.torch"     = "2.10.0"
  }
}

target "humble-core-torch-cpu" {
  inherits = ["_distribution-humble", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-core-cpu", "${REGISTRY}/ros-torch:humble-core-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-torch-cpu" {
  inherits = ["_distribution-humble", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-base-cpu", "${REGISTRY}/ros-torch:humble-base-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-torch-cpu" {
  inherits = ["_distribution-humble", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-perception-cpu", "${REGISTRY}/ros-torch:humble-perception-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-torch-cpu" {
  inherits = ["_distribution-humble", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-desktop-cpu", "${REGISTRY}/ros-torch:humble-desktop-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-torch-cpu" {
  inherits = ["_distribution-humble", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:humble-desktop-full-cpu", "${REGISTRY}/ros-torch:humble-desktop-full-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cu128-ubuntu-22-04" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py310")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py310")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py310")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py310")
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cu128"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "humble-core-tensorflow-cu128" {
  inherits = ["_distribution-humble", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-core-cu128", "${REGISTRY}/ros-tf:humble-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-tensorflow-cu128" {
  inherits = ["_distribution-humble", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-tf:humble-base-cu128",
    "${REGISTRY}/ros-tf:humble-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:humble",
  ]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-tensorflow-cu128" {
  inherits = ["_distribution-humble", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-perception-cu128", "${REGISTRY}/ros-tf:humble-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-tensorflow-cu128" {
  inherits = ["_distribution-humble", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-desktop-cu128", "${REGISTRY}/ros-tf:humble-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-humble", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-desktop-full-cu128", "${REGISTRY}/ros-tf:humble-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cpu-ubuntu-22-04" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py310")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py310")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py310")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py310")
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cpu"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "humble-core-tensorflow-cpu" {
  inherits = ["_distribution-humble", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-core-cpu", "${REGISTRY}/ros-tf:humble-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-tensorflow-cpu" {
  inherits = ["_distribution-humble", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-base-cpu", "${REGISTRY}/ros-tf:humble-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-tensorflow-cpu" {
  inherits = ["_distribution-humble", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-perception-cpu", "${REGISTRY}/ros-tf:humble-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-tensorflow-cpu" {
  inherits = ["_distribution-humble", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-desktop-cpu", "${REGISTRY}/ros-tf:humble-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-humble", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:humble-desktop-full-cpu", "${REGISTRY}/ros-tf:humble-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cu128-ubuntu-22-04" {
  target    = "ml"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py310")
    part-torch         = part("torch-cu128-py310")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py310")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py310")
    TORCH_ROOT         = root("torch-cu128-py310")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py310")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cu128"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "humble-core-ml-cu128" {
  inherits = ["_distribution-humble", "_join-ml-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-core-cu128", "${REGISTRY}/ros-ml:humble-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-ml-cu128" {
  inherits = ["_distribution-humble", "_join-ml-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:humble-base-cu128",
    "${REGISTRY}/ros-ml:humble-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:humble",
  ]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-ml-cu128" {
  inherits = ["_distribution-humble", "_join-ml-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:humble-perception-cu128",
    "${REGISTRY}/ros-ml:humble-perception-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-ml-cu128" {
  inherits = ["_distribution-humble", "_join-ml-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-desktop-cu128", "${REGISTRY}/ros-ml:humble-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-ml-cu128" {
  inherits = ["_distribution-humble", "_join-ml-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-full-cu128",
    "${REGISTRY}/ros-ml:humble-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cpu-ubuntu-22-04" {
  target    = "ml"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py310")
    part-torch         = part("torch-cpu-py310")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py310")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py310")
    TORCH_ROOT         = root("torch-cpu-py310")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py310")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cpu"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "humble-core-ml-cpu" {
  inherits = ["_distribution-humble", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-core-cpu", "${REGISTRY}/ros-ml:humble-core-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "humble-base-ml-cpu" {
  inherits = ["_distribution-humble", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-base-cpu", "${REGISTRY}/ros-ml:humble-base-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "humble-perception-ml-cpu" {
  inherits = ["_distribution-humble", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-perception-cpu", "${REGISTRY}/ros-ml:humble-perception-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "humble-desktop-ml-cpu" {
  inherits = ["_distribution-humble", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:humble-desktop-cpu", "${REGISTRY}/ros-ml:humble-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "humble-desktop-full-ml-cpu" {
  inherits = ["_distribution-humble", "_join-ml-cpu-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-full-cpu",
    "${REGISTRY}/ros-ml:humble-desktop-full-cpu-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-cuda-cu128" {
  inherits = ["_distribution-iron", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-core-cu128", "${REGISTRY}/ros-cuda:iron-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-cuda-cu128" {
  inherits = ["_distribution-iron", "_join-cuda-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-cu128",
    "${REGISTRY}/ros-cuda:iron-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:iron",
  ]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-cuda-cu128" {
  inherits = ["_distribution-iron", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-perception-cu128", "${REGISTRY}/ros-cuda:iron-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-cuda-cu128" {
  inherits = ["_distribution-iron", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-cu128", "${REGISTRY}/ros-cuda:iron-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-cuda-cu128" {
  inherits = ["_distribution-iron", "_join-cuda-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-full-cu128", "${REGISTRY}/ros-cuda:iron-desktop-full-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-cuda-cu130" {
  inherits = ["_distribution-iron", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-core-cu130", "${REGISTRY}/ros-cuda:iron-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-cuda-cu130" {
  inherits = ["_distribution-iron", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-base-cu130", "${REGISTRY}/ros-cuda:iron-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-cuda-cu130" {
  inherits = ["_distribution-iron", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-perception-cu130", "${REGISTRY}/ros-cuda:iron-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-cuda-cu130" {
  inherits = ["_distribution-iron", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-cu130", "${REGISTRY}/ros-cuda:iron-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-cuda-cu130" {
  inherits = ["_distribution-iron", "_join-cuda-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-full-cu130", "${REGISTRY}/ros-cuda:iron-desktop-full-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-cuda-cu121" {
  inherits = ["_distribution-iron", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-core-cu121", "${REGISTRY}/ros-cuda:iron-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-cuda-cu121" {
  inherits = ["_distribution-iron", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-base-cu121", "${REGISTRY}/ros-cuda:iron-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-cuda-cu121" {
  inherits = ["_distribution-iron", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-perception-cu121", "${REGISTRY}/ros-cuda:iron-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-cuda-cu121" {
  inherits = ["_distribution-iron", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-cu121", "${REGISTRY}/ros-cuda:iron-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-cuda-cu121" {
  inherits = ["_distribution-iron", "_join-cuda-cu121-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-cuda:iron-desktop-full-cu121", "${REGISTRY}/ros-cuda:iron-desktop-full-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-torch-cu128" {
  inherits = ["_distribution-iron", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-core-cu128", "${REGISTRY}/ros-torch:iron-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-torch-cu128" {
  inherits = ["_distribution-iron", "_join-torch-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-torch:iron-base-cu128",
    "${REGISTRY}/ros-torch:iron-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:iron",
  ]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-torch-cu128" {
  inherits = ["_distribution-iron", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-perception-cu128", "${REGISTRY}/ros-torch:iron-perception-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-torch-cu128" {
  inherits = ["_distribution-iron", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-cu128", "${REGISTRY}/ros-torch:iron-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-torch-cu128" {
  inherits = ["_distribution-iron", "_join-torch-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-full-cu128", "${REGISTRY}/ros-torch:iron-desktop-full-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-torch-cu130" {
  inherits = ["_distribution-iron", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-core-cu130", "${REGISTRY}/ros-torch:iron-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-torch-cu130" {
  inherits = ["_distribution-iron", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-base-cu130", "${REGISTRY}/ros-torch:iron-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-torch-cu130" {
  inherits = ["_distribution-iron", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-perception-cu130", "${REGISTRY}/ros-torch:iron-perception-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-torch-cu130" {
  inherits = ["_distribution-iron", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-cu130", "${REGISTRY}/ros-torch:iron-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-torch-cu130" {
  inherits = ["_distribution-iron", "_join-torch-cu130-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-full-cu130", "${REGISTRY}/ros-torch:iron-desktop-full-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-torch-cpu" {
  inherits = ["_distribution-iron", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-core-cpu", "${REGISTRY}/ros-torch:iron-core-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-torch-cpu" {
  inherits = ["_distribution-iron", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-base-cpu", "${REGISTRY}/ros-torch:iron-base-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-torch-cpu" {
  inherits = ["_distribution-iron", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-perception-cpu", "${REGISTRY}/ros-torch:iron-perception-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-torch-cpu" {
  inherits = ["_distribution-iron", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-cpu", "${REGISTRY}/ros-torch:iron-desktop-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-torch-cpu" {
  inherits = ["_distribution-iron", "_join-torch-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-torch:iron-desktop-full-cpu", "${REGISTRY}/ros-torch:iron-desktop-full-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-tensorflow-cu128" {
  inherits = ["_distribution-iron", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-core-cu128", "${REGISTRY}/ros-tf:iron-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-tensorflow-cu128" {
  inherits = ["_distribution-iron", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-tf:iron-base-cu128",
    "${REGISTRY}/ros-tf:iron-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:iron",
  ]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-tensorflow-cu128" {
  inherits = ["_distribution-iron", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-perception-cu128", "${REGISTRY}/ros-tf:iron-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-tensorflow-cu128" {
  inherits = ["_distribution-iron", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-desktop-cu128", "${REGISTRY}/ros-tf:iron-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-iron", "_join-tensorflow-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-desktop-full-cu128", "${REGISTRY}/ros-tf:iron-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-tensorflow-cpu" {
  inherits = ["_distribution-iron", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-core-cpu", "${REGISTRY}/ros-tf:iron-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-tensorflow-cpu" {
  inherits = ["_distribution-iron", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-base-cpu", "${REGISTRY}/ros-tf:iron-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-tensorflow-cpu" {
  inherits = ["_distribution-iron", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-perception-cpu", "${REGISTRY}/ros-tf:iron-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-tensorflow-cpu" {
  inherits = ["_distribution-iron", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-desktop-cpu", "${REGISTRY}/ros-tf:iron-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-iron", "_join-tensorflow-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-tf:iron-desktop-full-cpu", "${REGISTRY}/ros-tf:iron-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-ml-cu128" {
  inherits = ["_distribution-iron", "_join-ml-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-core-cu128", "${REGISTRY}/ros-ml:iron-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-ml-cu128" {
  inherits = ["_distribution-iron", "_join-ml-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:iron-base-cu128",
    "${REGISTRY}/ros-ml:iron-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:iron",
  ]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-ml-cu128" {
  inherits = ["_distribution-iron", "_join-ml-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-perception-cu128", "${REGISTRY}/ros-ml:iron-perception-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-ml-cu128" {
  inherits = ["_distribution-iron", "_join-ml-cu128-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-desktop-cu128", "${REGISTRY}/ros-ml:iron-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-ml-cu128" {
  inherits = ["_distribution-iron", "_join-ml-cu128-ubuntu-22-04"]
  tags = [
    "${REGISTRY}/ros-ml:iron-desktop-full-cu128",
    "${REGISTRY}/ros-ml:iron-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "iron-core-ml-cpu" {
  inherits = ["_distribution-iron", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-core-cpu", "${REGISTRY}/ros-ml:iron-core-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "iron-base-ml-cpu" {
  inherits = ["_distribution-iron", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-base-cpu", "${REGISTRY}/ros-ml:iron-base-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "iron-perception-ml-cpu" {
  inherits = ["_distribution-iron", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-perception-cpu", "${REGISTRY}/ros-ml:iron-perception-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "iron-desktop-ml-cpu" {
  inherits = ["_distribution-iron", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-desktop-cpu", "${REGISTRY}/ros-ml:iron-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "iron-desktop-full-ml-cpu" {
  inherits = ["_distribution-iron", "_join-ml-cpu-ubuntu-22-04"]
  tags     = ["${REGISTRY}/ros-ml:iron-desktop-full-cpu", "${REGISTRY}/ros-ml:iron-desktop-full-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu128-ubuntu-24-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "jazzy-core-cuda-cu128" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-core-cu128", "${REGISTRY}/ros-cuda:jazzy-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-cuda-cu128" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-cu128",
    "${REGISTRY}/ros-cuda:jazzy-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:jazzy",
  ]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-cuda-cu128" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-perception-cu128", "${REGISTRY}/ros-cuda:jazzy-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-cuda-cu128" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-cu128", "${REGISTRY}/ros-cuda:jazzy-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-cuda-cu128" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-full-cu128", "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-ubuntu-24-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "jazzy-core-cuda-cu130" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-core-cu130", "${REGISTRY}/ros-cuda:jazzy-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-cuda-cu130" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-base-cu130", "${REGISTRY}/ros-cuda:jazzy-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-cuda-cu130" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-perception-cu130", "${REGISTRY}/ros-cuda:jazzy-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-cuda-cu130" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-cu130", "${REGISTRY}/ros-cuda:jazzy-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-cuda-cu130" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-full-cu130", "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-ubuntu-24-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "jazzy-core-cuda-cu121" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-core-cu121", "${REGISTRY}/ros-cuda:jazzy-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-cuda-cu121" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-base-cu121", "${REGISTRY}/ros-cuda:jazzy-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-cuda-cu121" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-perception-cu121", "${REGISTRY}/ros-cuda:jazzy-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-cuda-cu121" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-cu121", "${REGISTRY}/ros-cuda:jazzy-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-cuda-cu121" {
  inherits = ["_distribution-jazzy", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:jazzy-desktop-full-cu121", "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu128-ubuntu-24-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu128")
    part-common = part("common-cu128-py312")
    part-torch  = part("torch-cu128-py312")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    COMMON_ROOT   = root("common-cu128-py312")
    TORCH_ROOT    = root("torch-cu128-py312")
    TORCH_VERSION = "2.10.0"
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu128"
    "io.rosml.torch"     = "2.10.0"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "jazzy-core-torch-cu128" {
  inherits = ["_distribution-jazzy", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-core-cu128", "${REGISTRY}/ros-torch:jazzy-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-torch-cu128" {
  inherits = ["_distribution-jazzy", "_join-torch-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-cu128",
    "${REGISTRY}/ros-torch:jazzy-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:jazzy",
  ]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-torch-cu128" {
  inherits = ["_distribution-jazzy", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-perception-cu128", "${REGISTRY}/ros-torch:jazzy-perception-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-torch-cu128" {
  inherits = ["_distribution-jazzy", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-desktop-cu128", "${REGISTRY}/ros-torch:jazzy-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-torch-cu128" {
  inherits = ["_distribution-jazzy", "_join-torch-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu130-ubuntu-24-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-cuda   = part("cuda-cu130")
    part-common = part("common-cu130-py312")
    part-torch  = part("torch-cu130-py312")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    COMMON_ROOT   = root("common-cu130-py312")
    TORCH_ROOT    = root("torch-cu130-py312")
    TORCH_VERSION = "2.12.1"
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu130"
    "io.rosml.torch"     = "2.12.1"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "jazzy-core-torch-cu130" {
  inherits = ["_distribution-jazzy", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-core-cu130", "${REGISTRY}/ros-torch:jazzy-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-torch-cu130" {
  inherits = ["_distribution-jazzy", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-base-cu130", "${REGISTRY}/ros-torch:jazzy-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-torch-cu130" {
  inherits = ["_distribution-jazzy", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-perception-cu130", "${REGISTRY}/ros-torch:jazzy-perception-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-torch-cu130" {
  inherits = ["_distribution-jazzy", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-desktop-cu130", "${REGISTRY}/ros-torch:jazzy-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-torch-cu130" {
  inherits = ["_distribution-jazzy", "_join-torch-cu130-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu130",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu-ubuntu-24-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu-py312")
    part-torch  = part("torch-cpu-py312")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu-py312")
    TORCH_ROOT    = root("torch-cpu-py312")
    TORCH_VERSION = "2.10.0"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu"
    "io.rosml.torch"     = "2.10.0"
  }
}

target "jazzy-core-torch-cpu" {
  inherits = ["_distribution-jazzy", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-core-cpu", "${REGISTRY}/ros-torch:jazzy-core-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-torch-cpu" {
  inherits = ["_distribution-jazzy", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-base-cpu", "${REGISTRY}/ros-torch:jazzy-base-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-torch-cpu" {
  inherits = ["_distribution-jazzy", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-perception-cpu", "${REGISTRY}/ros-torch:jazzy-perception-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-torch-cpu" {
  inherits = ["_distribution-jazzy", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-desktop-cpu", "${REGISTRY}/ros-torch:jazzy-desktop-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-torch-cpu" {
  inherits = ["_distribution-jazzy", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:jazzy-desktop-full-cpu", "${REGISTRY}/ros-torch:jazzy-desktop-full-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cu128-ubuntu-24-04" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py312")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py312")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py312")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py312")
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cu128"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "jazzy-core-tensorflow-cu128" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-core-cu128", "${REGISTRY}/ros-tf:jazzy-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-tensorflow-cu128" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-tf:jazzy-base-cu128",
    "${REGISTRY}/ros-tf:jazzy-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:jazzy",
  ]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-tensorflow-cu128" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-perception-cu128", "${REGISTRY}/ros-tf:jazzy-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-tensorflow-cu128" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-desktop-cu128", "${REGISTRY}/ros-tf:jazzy-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-desktop-full-cu128", "${REGISTRY}/ros-tf:jazzy-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cpu-ubuntu-24-04" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py312")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py312")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py312")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py312")
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cpu"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "jazzy-core-tensorflow-cpu" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-core-cpu", "${REGISTRY}/ros-tf:jazzy-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-tensorflow-cpu" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-base-cpu", "${REGISTRY}/ros-tf:jazzy-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-tensorflow-cpu" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-perception-cpu", "${REGISTRY}/ros-tf:jazzy-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-tensorflow-cpu" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-desktop-cpu", "${REGISTRY}/ros-tf:jazzy-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-jazzy", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:jazzy-desktop-full-cpu", "${REGISTRY}/ros-tf:jazzy-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cu128-ubuntu-24-04" {
  target    = "ml"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py312")
    part-torch         = part("torch-cu128-py312")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py312")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py312")
    TORCH_ROOT         = root("torch-cu128-py312")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py312")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cu128"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "jazzy-core-ml-cu128" {
  inherits = ["_distribution-jazzy", "_join-ml-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-core-cu128", "${REGISTRY}/ros-ml:jazzy-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-ml-cu128" {
  inherits = ["_distribution-jazzy", "_join-ml-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:jazzy-base-cu128",
    "${REGISTRY}/ros-ml:jazzy-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:jazzy",
  ]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-ml-cu128" {
  inherits = ["_distribution-jazzy", "_join-ml-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-perception-cu128", "${REGISTRY}/ros-ml:jazzy-perception-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-ml-cu128" {
  inherits = ["_distribution-jazzy", "_join-ml-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-desktop-cu128", "${REGISTRY}/ros-ml:jazzy-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-ml-cu128" {
  inherits = ["_distribution-jazzy", "_join-ml-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cpu-ubuntu-24-04" {
  target    = "ml"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py312")
    part-torch         = part("torch-cpu-py312")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py312")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py312")
    TORCH_ROOT         = root("torch-cpu-py312")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py312")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cpu"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "jazzy-core-ml-cpu" {
  inherits = ["_distribution-jazzy", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-core-cpu", "${REGISTRY}/ros-ml:jazzy-core-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-base-ml-cpu" {
  inherits = ["_distribution-jazzy", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-base-cpu", "${REGISTRY}/ros-ml:jazzy-base-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "jazzy-perception-ml-cpu" {
  inherits = ["_distribution-jazzy", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-perception-cpu", "${REGISTRY}/ros-ml:jazzy-perception-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "jazzy-desktop-ml-cpu" {
  inherits = ["_distribution-jazzy", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-desktop-cpu", "${REGISTRY}/ros-ml:jazzy-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "jazzy-desktop-full-ml-cpu" {
  inherits = ["_distribution-jazzy", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:jazzy-desktop-full-cpu", "${REGISTRY}/ros-ml:jazzy-desktop-full-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-cuda-cu128" {
  inherits = ["_distribution-kilted", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-core-cu128", "${REGISTRY}/ros-cuda:kilted-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-cuda-cu128" {
  inherits = ["_distribution-kilted", "_join-cuda-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-cu128",
    "${REGISTRY}/ros-cuda:kilted-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:kilted",
  ]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-cuda-cu128" {
  inherits = ["_distribution-kilted", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-perception-cu128", "${REGISTRY}/ros-cuda:kilted-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-cuda-cu128" {
  inherits = ["_distribution-kilted", "_join-cuda-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-desktop-cu128", "${REGISTRY}/ros-cuda:kilted-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-cuda-cu128" {
  inherits = ["_distribution-kilted", "_join-cuda-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-cuda-cu130" {
  inherits = ["_distribution-kilted", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-core-cu130", "${REGISTRY}/ros-cuda:kilted-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-cuda-cu130" {
  inherits = ["_distribution-kilted", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-base-cu130", "${REGISTRY}/ros-cuda:kilted-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-cuda-cu130" {
  inherits = ["_distribution-kilted", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-perception-cu130", "${REGISTRY}/ros-cuda:kilted-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-cuda-cu130" {
  inherits = ["_distribution-kilted", "_join-cuda-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-desktop-cu130", "${REGISTRY}/ros-cuda:kilted-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-cuda-cu130" {
  inherits = ["_distribution-kilted", "_join-cuda-cu130-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-cuda-cu121" {
  inherits = ["_distribution-kilted", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-core-cu121", "${REGISTRY}/ros-cuda:kilted-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-cuda-cu121" {
  inherits = ["_distribution-kilted", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-base-cu121", "${REGISTRY}/ros-cuda:kilted-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-cuda-cu121" {
  inherits = ["_distribution-kilted", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-perception-cu121", "${REGISTRY}/ros-cuda:kilted-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-cuda-cu121" {
  inherits = ["_distribution-kilted", "_join-cuda-cu121-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-cuda:kilted-desktop-cu121", "${REGISTRY}/ros-cuda:kilted-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-cuda-cu121" {
  inherits = ["_distribution-kilted", "_join-cuda-cu121-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-torch-cu128" {
  inherits = ["_distribution-kilted", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-core-cu128", "${REGISTRY}/ros-torch:kilted-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-torch-cu128" {
  inherits = ["_distribution-kilted", "_join-torch-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-cu128",
    "${REGISTRY}/ros-torch:kilted-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:kilted",
  ]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-torch-cu128" {
  inherits = ["_distribution-kilted", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-perception-cu128", "${REGISTRY}/ros-torch:kilted-perception-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-torch-cu128" {
  inherits = ["_distribution-kilted", "_join-torch-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-desktop-cu128", "${REGISTRY}/ros-torch:kilted-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-torch-cu128" {
  inherits = ["_distribution-kilted", "_join-torch-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-torch-cu130" {
  inherits = ["_distribution-kilted", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-core-cu130", "${REGISTRY}/ros-torch:kilted-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-torch-cu130" {
  inherits = ["_distribution-kilted", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-base-cu130", "${REGISTRY}/ros-torch:kilted-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-torch-cu130" {
  inherits = ["_distribution-kilted", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-perception-cu130", "${REGISTRY}/ros-torch:kilted-perception-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-torch-cu130" {
  inherits = ["_distribution-kilted", "_join-torch-cu130-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-desktop-cu130", "${REGISTRY}/ros-torch:kilted-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-torch-cu130" {
  inherits = ["_distribution-kilted", "_join-torch-cu130-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu130",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-torch-cpu" {
  inherits = ["_distribution-kilted", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-core-cpu", "${REGISTRY}/ros-torch:kilted-core-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-torch-cpu" {
  inherits = ["_distribution-kilted", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-base-cpu", "${REGISTRY}/ros-torch:kilted-base-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-torch-cpu" {
  inherits = ["_distribution-kilted", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-perception-cpu", "${REGISTRY}/ros-torch:kilted-perception-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-torch-cpu" {
  inherits = ["_distribution-kilted", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-desktop-cpu", "${REGISTRY}/ros-torch:kilted-desktop-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-torch-cpu" {
  inherits = ["_distribution-kilted", "_join-torch-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-torch:kilted-desktop-full-cpu", "${REGISTRY}/ros-torch:kilted-desktop-full-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-tensorflow-cu128" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-core-cu128", "${REGISTRY}/ros-tf:kilted-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-tensorflow-cu128" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-tf:kilted-base-cu128",
    "${REGISTRY}/ros-tf:kilted-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:kilted",
  ]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-tensorflow-cu128" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-perception-cu128", "${REGISTRY}/ros-tf:kilted-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-tensorflow-cu128" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-desktop-cu128", "${REGISTRY}/ros-tf:kilted-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-desktop-full-cu128", "${REGISTRY}/ros-tf:kilted-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-tensorflow-cpu" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-core-cpu", "${REGISTRY}/ros-tf:kilted-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-tensorflow-cpu" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-base-cpu", "${REGISTRY}/ros-tf:kilted-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-tensorflow-cpu" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-perception-cpu", "${REGISTRY}/ros-tf:kilted-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-tensorflow-cpu" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-desktop-cpu", "${REGISTRY}/ros-tf:kilted-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-kilted", "_join-tensorflow-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-tf:kilted-desktop-full-cpu", "${REGISTRY}/ros-tf:kilted-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-ml-cu128" {
  inherits = ["_distribution-kilted", "_join-ml-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-core-cu128", "${REGISTRY}/ros-ml:kilted-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-ml-cu128" {
  inherits = ["_distribution-kilted", "_join-ml-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:kilted-base-cu128",
    "${REGISTRY}/ros-ml:kilted-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:kilted",
  ]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-ml-cu128" {
  inherits = ["_distribution-kilted", "_join-ml-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:kilted-perception-cu128",
    "${REGISTRY}/ros-ml:kilted-perception-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-ml-cu128" {
  inherits = ["_distribution-kilted", "_join-ml-cu128-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-desktop-cu128", "${REGISTRY}/ros-ml:kilted-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-ml-cu128" {
  inherits = ["_distribution-kilted", "_join-ml-cu128-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-ml:kilted-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "kilted-core-ml-cpu" {
  inherits = ["_distribution-kilted", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-core-cpu", "${REGISTRY}/ros-ml:kilted-core-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "kilted-base-ml-cpu" {
  inherits = ["_distribution-kilted", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-base-cpu", "${REGISTRY}/ros-ml:kilted-base-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "kilted-perception-ml-cpu" {
  inherits = ["_distribution-kilted", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-perception-cpu", "${REGISTRY}/ros-ml:kilted-perception-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "kilted-desktop-ml-cpu" {
  inherits = ["_distribution-kilted", "_join-ml-cpu-ubuntu-24-04"]
  tags     = ["${REGISTRY}/ros-ml:kilted-desktop-cpu", "${REGISTRY}/ros-ml:kilted-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "kilted-desktop-full-ml-cpu" {
  inherits = ["_distribution-kilted", "_join-ml-cpu-ubuntu-24-04"]
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-full-cpu",
    "${REGISTRY}/ros-ml:kilted-desktop-full-cpu-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu128-ubuntu-26-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "lyrical-core-cuda-cu128" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-core-cu128", "${REGISTRY}/ros-cuda:lyrical-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-cuda-cu128" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-cu128",
    "${REGISTRY}/ros-cuda:lyrical-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:lyrical",
    "${REGISTRY}/ros-cuda:latest",
  ]
  contexts = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-cuda-cu128" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-perception-cu128", "${REGISTRY}/ros-cuda:lyrical-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-cuda-cu128" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-desktop-cu128", "${REGISTRY}/ros-cuda:lyrical-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-cuda-cu128" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-ubuntu-26-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "lyrical-core-cuda-cu130" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-core-cu130", "${REGISTRY}/ros-cuda:lyrical-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-cuda-cu130" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-base-cu130", "${REGISTRY}/ros-cuda:lyrical-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-cuda-cu130" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-perception-cu130", "${REGISTRY}/ros-cuda:lyrical-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-cuda-cu130" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-desktop-cu130", "${REGISTRY}/ros-cuda:lyrical-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-cuda-cu130" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-ubuntu-26-04" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "lyrical-core-cuda-cu121" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-core-cu121", "${REGISTRY}/ros-cuda:lyrical-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-cuda-cu121" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-base-cu121", "${REGISTRY}/ros-cuda:lyrical-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-cuda-cu121" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-perception-cu121", "${REGISTRY}/ros-cuda:lyrical-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-cuda-cu121" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:lyrical-desktop-cu121", "${REGISTRY}/ros-cuda:lyrical-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-cuda-cu121" {
  inherits = ["_distribution-lyrical", "_join-cuda-cu121-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu128-ubuntu-26-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu128")
    part-common = part("common-cu128-py314")
    part-torch  = part("torch-cu128-py314")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    COMMON_ROOT   = root("common-cu128-py314")
    TORCH_ROOT    = root("torch-cu128-py314")
    TORCH_VERSION = "2.10.0"
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu128"
    "io.rosml.torch"     = "2.10.0"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "lyrical-core-torch-cu128" {
  inherits = ["_distribution-lyrical", "_join-torch-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:lyrical-core-cu128", "${REGISTRY}/ros-torch:lyrical-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-torch-cu128" {
  inherits = ["_distribution-lyrical", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-cu128",
    "${REGISTRY}/ros-torch:lyrical-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:lyrical",
    "${REGISTRY}/ros-torch:latest",
  ]
  contexts = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-torch-cu128" {
  inherits = ["_distribution-lyrical", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cu128",
    "${REGISTRY}/ros-torch:lyrical-perception-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-torch-cu128" {
  inherits = ["_distribution-lyrical", "_join-torch-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:lyrical-desktop-cu128", "${REGISTRY}/ros-torch:lyrical-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-torch-cu128" {
  inherits = ["_distribution-lyrical", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu128",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu130-ubuntu-26-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-cuda   = part("cuda-cu130")
    part-common = part("common-cu130-py314")
    part-torch  = part("torch-cu130-py314")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    COMMON_ROOT   = root("common-cu130-py314")
    TORCH_ROOT    = root("torch-cu130-py314")
    TORCH_VERSION = "2.12.1"
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu130"
    "io.rosml.torch"     = "2.12.1"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "lyrical-core-torch-cu130" {
  inherits = ["_distribution-lyrical", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:lyrical-core-cu130", "${REGISTRY}/ros-torch:lyrical-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-torch-cu130" {
  inherits = ["_distribution-lyrical", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:lyrical-base-cu130", "${REGISTRY}/ros-torch:lyrical-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-torch-cu130" {
  inherits = ["_distribution-lyrical", "_join-torch-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cu130",
    "${REGISTRY}/ros-torch:lyrical-perception-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-torch-cu130" {
  inherits = ["_distribution-lyrical", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:lyrical-desktop-cu130", "${REGISTRY}/ros-torch:lyrical-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-torch-cu130" {
  inherits = ["_distribution-lyrical", "_join-torch-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu130",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu-ubuntu-26-04" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu-py314")
    part-torch  = part("torch-cpu-py314")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu-py314")
    TORCH_ROOT    = root("torch-cpu-py314")
    TORCH_VERSION = "2.10.0"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu"
    "io.rosml.torch"     = "2.10.0"
  }
}

target "lyrical-core-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-lyrical", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:lyrical-core-cpu", "${REGISTRY}/ros-torch:lyrical-core-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "lyrical-base-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-lyrical", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:lyrical-base-cpu", "${REGISTRY}/ros-torch:lyrical-base-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "lyrical-perception-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-lyrical", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:lyrical-perception-cpu", "${REGISTRY}/ros-torch:lyrical-perception-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "lyrical-desktop-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-lyrical", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:lyrical-desktop-cpu", "${REGISTRY}/ros-torch:lyrical-desktop-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "lyrical-desktop-full-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-lyrical", "_join-torch-cpu-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cpu",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cpu-torch2.10.0",
  ]
  contexts = { ros = image("ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-cuda-cu128" {
  inherits = ["_distribution-rolling", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-core-cu128", "${REGISTRY}/ros-cuda:rolling-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-cuda-cu128" {
  inherits = ["_distribution-rolling", "_join-cuda-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-cu128",
    "${REGISTRY}/ros-cuda:rolling-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:rolling",
  ]
  contexts = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-cuda-cu128" {
  inherits = ["_distribution-rolling", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-perception-cu128", "${REGISTRY}/ros-cuda:rolling-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-cuda-cu128" {
  inherits = ["_distribution-rolling", "_join-cuda-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-desktop-cu128", "${REGISTRY}/ros-cuda:rolling-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-cuda-cu128" {
  inherits = ["_distribution-rolling", "_join-cuda-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-cuda-cu130" {
  inherits = ["_distribution-rolling", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-core-cu130", "${REGISTRY}/ros-cuda:rolling-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-cuda-cu130" {
  inherits = ["_distribution-rolling", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-base-cu130", "${REGISTRY}/ros-cuda:rolling-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-cuda-cu130" {
  inherits = ["_distribution-rolling", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-perception-cu130", "${REGISTRY}/ros-cuda:rolling-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-cuda-cu130" {
  inherits = ["_distribution-rolling", "_join-cuda-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-desktop-cu130", "${REGISTRY}/ros-cuda:rolling-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-cuda-cu130" {
  inherits = ["_distribution-rolling", "_join-cuda-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-cuda-cu121" {
  inherits = ["_distribution-rolling", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-core-cu121", "${REGISTRY}/ros-cuda:rolling-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-cuda-cu121" {
  inherits = ["_distribution-rolling", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-base-cu121", "${REGISTRY}/ros-cuda:rolling-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-cuda-cu121" {
  inherits = ["_distribution-rolling", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-perception-cu121", "${REGISTRY}/ros-cuda:rolling-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-cuda-cu121" {
  inherits = ["_distribution-rolling", "_join-cuda-cu121-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-cuda:rolling-desktop-cu121", "${REGISTRY}/ros-cuda:rolling-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-cuda-cu121" {
  inherits = ["_distribution-rolling", "_join-cuda-cu121-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-torch-cu128" {
  inherits = ["_distribution-rolling", "_join-torch-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:rolling-core-cu128", "${REGISTRY}/ros-torch:rolling-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-torch-cu128" {
  inherits = ["_distribution-rolling", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-cu128",
    "${REGISTRY}/ros-torch:rolling-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:rolling",
  ]
  contexts = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-torch-cu128" {
  inherits = ["_distribution-rolling", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cu128",
    "${REGISTRY}/ros-torch:rolling-perception-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-torch-cu128" {
  inherits = ["_distribution-rolling", "_join-torch-cu128-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:rolling-desktop-cu128", "${REGISTRY}/ros-torch:rolling-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-torch-cu128" {
  inherits = ["_distribution-rolling", "_join-torch-cu128-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu128",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-torch-cu130" {
  inherits = ["_distribution-rolling", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:rolling-core-cu130", "${REGISTRY}/ros-torch:rolling-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-torch-cu130" {
  inherits = ["_distribution-rolling", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:rolling-base-cu130", "${REGISTRY}/ros-torch:rolling-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-torch-cu130" {
  inherits = ["_distribution-rolling", "_join-torch-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cu130",
    "${REGISTRY}/ros-torch:rolling-perception-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-torch-cu130" {
  inherits = ["_distribution-rolling", "_join-torch-cu130-ubuntu-26-04"]
  tags     = ["${REGISTRY}/ros-torch:rolling-desktop-cu130", "${REGISTRY}/ros-torch:rolling-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-torch-cu130" {
  inherits = ["_distribution-rolling", "_join-torch-cu130-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu130",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "rolling-core-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-rolling", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:rolling-core-cpu", "${REGISTRY}/ros-torch:rolling-core-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "rolling-base-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-rolling", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:rolling-base-cpu", "${REGISTRY}/ros-torch:rolling-base-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "rolling-perception-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-rolling", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:rolling-perception-cpu", "${REGISTRY}/ros-torch:rolling-perception-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "rolling-desktop-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-rolling", "_join-torch-cpu-ubuntu-26-04"]
  tags        = ["${REGISTRY}/ros-torch:rolling-desktop-cpu", "${REGISTRY}/ros-torch:rolling-desktop-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "rolling-desktop-full-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-rolling", "_join-torch-cpu-ubuntu-26-04"]
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cpu",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cpu-torch2.10.0",
  ]
  contexts = { ros = image("ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu128-bookworm" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "bookworm-core-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-core-cu128", "${REGISTRY}/ros-cuda:bookworm-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-base-cu128",
    "${REGISTRY}/ros-cuda:bookworm-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm",
  ]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-robot-cu128", "${REGISTRY}/ros-cuda:bookworm-robot-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-perception-cu128",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-desktop-cu128", "${REGISTRY}/ros-cuda:bookworm-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-cuda-cu128" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-bookworm" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "bookworm-core-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-core-cu130", "${REGISTRY}/ros-cuda:bookworm-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-base-cu130", "${REGISTRY}/ros-cuda:bookworm-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-robot-cu130", "${REGISTRY}/ros-cuda:bookworm-robot-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-perception-cu130",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-desktop-cu130", "${REGISTRY}/ros-cuda:bookworm-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-cuda-cu130" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu130-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-bookworm" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "bookworm-core-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-core-cu121", "${REGISTRY}/ros-cuda:bookworm-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-base-cu121", "${REGISTRY}/ros-cuda:bookworm-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-robot-cu121", "${REGISTRY}/ros-cuda:bookworm-robot-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-perception-cu121",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags     = ["${REGISTRY}/ros-cuda:bookworm-desktop-cu121", "${REGISTRY}/ros-cuda:bookworm-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-cuda-cu121" {
  inherits = ["_distribution-bookworm", "_join-cuda-cu121-bookworm"]
  tags = [
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu128-bookworm" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu128")
    part-common = part("common-cu128-py311")
    part-torch  = part("torch-cu128-py311")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    COMMON_ROOT   = root("common-cu128-py311")
    TORCH_ROOT    = root("torch-cu128-py311")
    TORCH_VERSION = "2.10.0"
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu128"
    "io.rosml.torch"     = "2.10.0"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "bookworm-core-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-core-cu128", "${REGISTRY}/ros-torch:bookworm-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-base-cu128",
    "${REGISTRY}/ros-torch:bookworm-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm",
  ]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-robot-cu128", "${REGISTRY}/ros-torch:bookworm-robot-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-robot-cu128-torch2.10.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-perception-cu128",
    "${REGISTRY}/ros-torch:bookworm-perception-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-desktop-cu128", "${REGISTRY}/ros-torch:bookworm-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-torch-cu128" {
  inherits = ["_distribution-bookworm", "_join-torch-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu130-bookworm" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-cuda   = part("cuda-cu130")
    part-common = part("common-cu130-py311")
    part-torch  = part("torch-cu130-py311")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    COMMON_ROOT   = root("common-cu130-py311")
    TORCH_ROOT    = root("torch-cu130-py311")
    TORCH_VERSION = "2.12.1"
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu130"
    "io.rosml.torch"     = "2.12.1"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "bookworm-core-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-core-cu130", "${REGISTRY}/ros-torch:bookworm-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-base-cu130", "${REGISTRY}/ros-torch:bookworm-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-robot-cu130", "${REGISTRY}/ros-torch:bookworm-robot-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-robot-cu130-torch2.12.1"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-perception-cu130",
    "${REGISTRY}/ros-torch:bookworm-perception-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags     = ["${REGISTRY}/ros-torch:bookworm-desktop-cu130", "${REGISTRY}/ros-torch:bookworm-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-torch-cu130" {
  inherits = ["_distribution-bookworm", "_join-torch-cu130-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu-bookworm" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu-py311")
    part-torch  = part("torch-cpu-py311")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu-py311")
    TORCH_ROOT    = root("torch-cpu-py311")
    TORCH_VERSION = "2.10.0"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu"
    "io.rosml.torch"     = "2.10.0"
  }
}

target "bookworm-core-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-torch:bookworm-core-cpu", "${REGISTRY}/ros-torch:bookworm-core-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-torch:bookworm-base-cpu", "${REGISTRY}/ros-torch:bookworm-base-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-torch:bookworm-robot-cpu", "${REGISTRY}/ros-torch:bookworm-robot-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-robot-cpu-torch2.10.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-torch:bookworm-perception-cpu", "${REGISTRY}/ros-torch:bookworm-perception-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-torch:bookworm-desktop-cpu", "${REGISTRY}/ros-torch:bookworm-desktop-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-torch-cpu-bookworm"]
  tags = [
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cpu-torch2.10.0",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cu128-bookworm" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py311")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py311")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py311")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py311")
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cu128"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "bookworm-core-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-core-cu128", "${REGISTRY}/ros-tf:bookworm-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-tf:bookworm-base-cu128",
    "${REGISTRY}/ros-tf:bookworm-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm",
  ]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-robot-cu128", "${REGISTRY}/ros-tf:bookworm-robot-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-robot-cu128-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-perception-cu128", "${REGISTRY}/ros-tf:bookworm-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-cu128", "${REGISTRY}/ros-tf:bookworm-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-full-cu128", "${REGISTRY}/ros-tf:bookworm-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cpu-bookworm" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py311")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py311")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py311")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py311")
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cpu"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "bookworm-core-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-core-cpu", "${REGISTRY}/ros-tf:bookworm-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-base-cpu", "${REGISTRY}/ros-tf:bookworm-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-robot-cpu", "${REGISTRY}/ros-tf:bookworm-robot-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-robot-cpu-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-perception-cpu", "${REGISTRY}/ros-tf:bookworm-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-cpu", "${REGISTRY}/ros-tf:bookworm-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-bookworm", "_join-tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-full-cpu", "${REGISTRY}/ros-tf:bookworm-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cu128-bookworm" {
  target    = "ml"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py311")
    part-torch         = part("torch-cu128-py311")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py311")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py311")
    TORCH_ROOT         = root("torch-cu128-py311")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py311")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cu128"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "bookworm-core-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-ml:bookworm-core-cu128", "${REGISTRY}/ros-ml:bookworm-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-ml:bookworm-base-cu128",
    "${REGISTRY}/ros-ml:bookworm-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm",
  ]
  contexts = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-ml:bookworm-robot-cu128", "${REGISTRY}/ros-ml:bookworm-robot-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-robot-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-ml:bookworm-perception-cu128",
    "${REGISTRY}/ros-ml:bookworm-perception-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-ml:bookworm-desktop-cu128", "${REGISTRY}/ros-ml:bookworm-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-ml-cu128" {
  inherits = ["_distribution-bookworm", "_join-ml-cu128-bookworm"]
  tags = [
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cpu-bookworm" {
  target    = "ml"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py311")
    part-torch         = part("torch-cpu-py311")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py311")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py311")
    TORCH_ROOT         = root("torch-cpu-py311")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py311")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cpu"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "bookworm-core-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-ml:bookworm-core-cpu", "${REGISTRY}/ros-ml:bookworm-core-cpu-torch2.10.0-tf2.20.0"]
  contexts    = { ros = image("ros", "bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "bookworm-base-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-ml:bookworm-base-cpu", "${REGISTRY}/ros-ml:bookworm-base-cpu-torch2.10.0-tf2.20.0"]
  contexts    = { ros = image("ros", "bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "bookworm-robot-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-ml:bookworm-robot-cpu", "${REGISTRY}/ros-ml:bookworm-robot-cpu-torch2.10.0-tf2.20.0"]
  contexts    = { ros = image("ros", "bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-robot-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-robot-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "bookworm-perception-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags = [
    "${REGISTRY}/ros-ml:bookworm-perception-cpu",
    "${REGISTRY}/ros-ml:bookworm-perception-cpu-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "bookworm-desktop-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags        = ["${REGISTRY}/ros-ml:bookworm-desktop-cpu", "${REGISTRY}/ros-ml:bookworm-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts    = { ros = image("ros", "bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "bookworm-desktop-full-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-bookworm", "_join-ml-cpu-bookworm"]
  tags = [
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cpu-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu128-trixie" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu128") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu128"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "trixie-core-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-core-cu128", "${REGISTRY}/ros-cuda:trixie-core-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-cuda:trixie-base-cu128",
    "${REGISTRY}/ros-cuda:trixie-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie",
  ]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-robot-cu128", "${REGISTRY}/ros-cuda:trixie-robot-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-perception-cu128", "${REGISTRY}/ros-cuda:trixie-perception-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-desktop-cu128", "${REGISTRY}/ros-cuda:trixie-desktop-cu128-cuda12.8.90"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-cuda-cu128" {
  inherits = ["_distribution-trixie", "_join-cuda-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu128-cuda12.8.90",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu130-trixie" {
  target    = "cuda"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { part-cuda = part("cuda-cu130") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu130"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "trixie-core-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-core-cu130", "${REGISTRY}/ros-cuda:trixie-core-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-base-cu130", "${REGISTRY}/ros-cuda:trixie-base-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-robot-cu130", "${REGISTRY}/ros-cuda:trixie-robot-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-perception-cu130", "${REGISTRY}/ros-cuda:trixie-perception-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-desktop-cu130", "${REGISTRY}/ros-cuda:trixie-desktop-cu130-cuda13.0.96"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-cuda-cu130" {
  inherits = ["_distribution-trixie", "_join-cuda-cu130-trixie"]
  tags = [
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu130-cuda13.0.96",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-cuda-cu121-trixie" {
  target    = "cuda"
  platforms = platforms(["linux/amd64"])
  contexts  = { part-cuda = part("cuda-cu121") }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu121")
    CUDA_VERSION  = "12.1.105"
    CUDNN_VERSION = "9.1.0.70"
  }
  labels = {
    "io.rosml.framework" = "cuda"
    "io.rosml.stack"     = "cu121"
    "io.rosml.cuda"      = "12.1.105"
    "io.rosml.cudnn"     = "9.1.0.70"
  }
}

target "trixie-core-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-core-cu121", "${REGISTRY}/ros-cuda:trixie-core-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-base-cu121", "${REGISTRY}/ros-cuda:trixie-base-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-robot-cu121", "${REGISTRY}/ros-cuda:trixie-robot-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-perception-cu121", "${REGISTRY}/ros-cuda:trixie-perception-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags     = ["${REGISTRY}/ros-cuda:trixie-desktop-cu121", "${REGISTRY}/ros-cuda:trixie-desktop-cu121-cuda12.1.105"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-cuda-cu121" {
  inherits = ["_distribution-trixie", "_join-cuda-cu121-trixie"]
  tags = [
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu121-cuda12.1.105",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu128-trixie" {
  target    = "torch"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda   = part("cuda-cu128")
    part-common = part("common-cu128-py313")
    part-torch  = part("torch-cu128-py313")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu128")
    COMMON_ROOT   = root("common-cu128-py313")
    TORCH_ROOT    = root("torch-cu128-py313")
    TORCH_VERSION = "2.10.0"
    CUDA_VERSION  = "12.8.90"
    CUDNN_VERSION = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu128"
    "io.rosml.torch"     = "2.10.0"
    "io.rosml.cuda"      = "12.8.90"
    "io.rosml.cudnn"     = "9.10.2.21"
  }
}

target "trixie-core-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-core-cu128", "${REGISTRY}/ros-torch:trixie-core-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-torch:trixie-base-cu128",
    "${REGISTRY}/ros-torch:trixie-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie",
  ]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-robot-cu128", "${REGISTRY}/ros-torch:trixie-robot-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-robot-cu128-torch2.10.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-perception-cu128", "${REGISTRY}/ros-torch:trixie-perception-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-desktop-cu128", "${REGISTRY}/ros-torch:trixie-desktop-cu128-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-torch-cu128" {
  inherits = ["_distribution-trixie", "_join-torch-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu128-torch2.10.0",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cu130-trixie" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-cuda   = part("cuda-cu130")
    part-common = part("common-cu130-py313")
    part-torch  = part("torch-cu130-py313")
  }
  args = {
    ACCELERATOR   = "cuda"
    CUDA_ROOT     = root("cuda-cu130")
    COMMON_ROOT   = root("common-cu130-py313")
    TORCH_ROOT    = root("torch-cu130-py313")
    TORCH_VERSION = "2.12.1"
    CUDA_VERSION  = "13.0.96"
    CUDNN_VERSION = "9.20.0.48"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cu130"
    "io.rosml.torch"     = "2.12.1"
    "io.rosml.cuda"      = "13.0.96"
    "io.rosml.cudnn"     = "9.20.0.48"
  }
}

target "trixie-core-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-core-cu130", "${REGISTRY}/ros-torch:trixie-core-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-base-cu130", "${REGISTRY}/ros-torch:trixie-base-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-base-cu130-torch2.12.1"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-robot-cu130", "${REGISTRY}/ros-torch:trixie-robot-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-robot-cu130-torch2.12.1"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-perception-cu130", "${REGISTRY}/ros-torch:trixie-perception-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-perception-cu130-torch2.12.1"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-desktop-cu130", "${REGISTRY}/ros-torch:trixie-desktop-cu130-torch2.12.1"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-desktop-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-torch-cu130" {
  inherits = ["_distribution-trixie", "_join-torch-cu130-trixie"]
  tags = [
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu130",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu130-torch2.12.1",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu130-torch2.12.1"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-torch-cpu-trixie" {
  target    = "torch"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common = part("common-cpu-py313")
    part-torch  = part("torch-cpu-py313")
  }
  args = {
    ACCELERATOR   = "cpu"
    COMMON_ROOT   = root("common-cpu-py313")
    TORCH_ROOT    = root("torch-cpu-py313")
    TORCH_VERSION = "2.10.0"
  }
  labels = {
    "io.rosml.framework" = "torch"
    "io.rosml.stack"     = "cpu"
    "io.rosml.torch"     = "2.10.0"
  }
}

target "trixie-core-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-core-cpu", "${REGISTRY}/ros-torch:trixie-core-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-base-cpu", "${REGISTRY}/ros-torch:trixie-base-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-robot-cpu", "${REGISTRY}/ros-torch:trixie-robot-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-robot-cpu-torch2.10.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-perception-cpu", "${REGISTRY}/ros-torch:trixie-perception-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-desktop-cpu", "${REGISTRY}/ros-torch:trixie-desktop-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-torch-cpu" {
  inherits = ["_distribution-trixie", "_join-torch-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-torch:trixie-desktop-full-cpu", "${REGISTRY}/ros-torch:trixie-desktop-full-cpu-torch2.10.0"]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cu128-trixie" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py313")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py313")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py313")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py313")
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cu128"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "trixie-core-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-core-cu128", "${REGISTRY}/ros-tf:trixie-core-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-tf:trixie-base-cu128",
    "${REGISTRY}/ros-tf:trixie-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie",
  ]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-robot-cu128", "${REGISTRY}/ros-tf:trixie-robot-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-robot-cu128-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-perception-cu128", "${REGISTRY}/ros-tf:trixie-perception-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-cu128", "${REGISTRY}/ros-tf:trixie-desktop-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-tensorflow-cu128" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-full-cu128", "${REGISTRY}/ros-tf:trixie-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-tensorflow-cpu-trixie" {
  target    = "tensorflow"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py313")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py313")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py313")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py313")
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "tensorflow"
    "io.rosml.stack"      = "cpu"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "trixie-core-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-core-cpu", "${REGISTRY}/ros-tf:trixie-core-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-base-cpu", "${REGISTRY}/ros-tf:trixie-base-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-base-cpu-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-robot-cpu", "${REGISTRY}/ros-tf:trixie-robot-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-robot-cpu-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-perception-cpu", "${REGISTRY}/ros-tf:trixie-perception-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-perception-cpu-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-cpu", "${REGISTRY}/ros-tf:trixie-desktop-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-desktop-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-tensorflow-cpu" {
  inherits = ["_distribution-trixie", "_join-tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-full-cpu", "${REGISTRY}/ros-tf:trixie-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cu128-trixie" {
  target    = "ml"
  platforms = platforms(["linux/amd64"])
  contexts = {
    part-cuda          = part("cuda-cu128")
    part-common        = part("common-cu128-py313")
    part-torch         = part("torch-cu128-py313")
    part-tensorflow-cc = part("tensorflow-cc-cu128")
    part-tensorflow    = part("tensorflow-cu128-py313")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py313")
    TORCH_ROOT         = root("torch-cu128-py313")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cu128")
    TENSORFLOW_ROOT    = root("tensorflow-cu128-py313")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
    CUDA_VERSION       = "12.8.90"
    CUDNN_VERSION      = "9.10.2.21"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cu128"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
    "io.rosml.cuda"       = "12.8.90"
    "io.rosml.cudnn"      = "9.10.2.21"
  }
}

target "trixie-core-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-core-cu128", "${REGISTRY}/ros-ml:trixie-core-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-ml:trixie-base-cu128",
    "${REGISTRY}/ros-ml:trixie-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie",
  ]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-robot-cu128", "${REGISTRY}/ros-ml:trixie-robot-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-robot-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-ml:trixie-perception-cu128",
    "${REGISTRY}/ros-ml:trixie-perception-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-desktop-cu128", "${REGISTRY}/ros-ml:trixie-desktop-cu128-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-ml-cu128" {
  inherits = ["_distribution-trixie", "_join-ml-cu128-trixie"]
  tags = [
    "${REGISTRY}/ros-ml:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_join-ml-cpu-trixie" {
  target    = "ml"
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts = {
    part-common        = part("common-cpu-py313")
    part-torch         = part("torch-cpu-py313")
    part-tensorflow-cc = part("tensorflow-cc-cpu")
    part-tensorflow    = part("tensorflow-cpu-py313")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py313")
    TORCH_ROOT         = root("torch-cpu-py313")
    TENSORFLOW_CC_ROOT = root("tensorflow-cc-cpu")
    TENSORFLOW_ROOT    = root("tensorflow-cpu-py313")
    TORCH_VERSION      = "2.10.0"
    TENSORFLOW_VERSION = "2.20.0"
  }
  labels = {
    "io.rosml.framework"  = "ml"
    "io.rosml.stack"      = "cpu"
    "io.rosml.torch"      = "2.10.0"
    "io.rosml.tensorflow" = "2.20.0"
  }
}

target "trixie-core-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-core-cpu", "${REGISTRY}/ros-ml:trixie-core-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "trixie-base-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-base-cpu", "${REGISTRY}/ros-ml:trixie-base-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-base-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
  }
}

target "trixie-robot-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-robot-cpu", "${REGISTRY}/ros-ml:trixie-robot-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-robot-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-robot-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
  }
}

target "trixie-perception-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-perception-cpu", "${REGISTRY}/ros-ml:trixie-perception-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-perception-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
  }
}

target "trixie-desktop-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-ml:trixie-desktop-cpu", "${REGISTRY}/ros-ml:trixie-desktop-cpu-torch2.10.0-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-desktop-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
  }
}

target "trixie-desktop-full-ml-cpu" {
  inherits = ["_distribution-trixie", "_join-ml-cpu-trixie"]
  tags = [
    "${REGISTRY}/ros-ml:trixie-desktop-full-cpu",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cpu-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "jazzy-wheels-core-cuda-cu128" {
  inherits  = ["_distribution-jazzy-wheels", "_join-cuda-cu128-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-cuda:jazzy-wheels-core-cu128", "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu128-cuda12.8.90"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-cuda-cu130" {
  inherits  = ["_distribution-jazzy-wheels", "_join-cuda-cu130-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-cuda:jazzy-wheels-core-cu130", "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu130-cuda13.0.96"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-cuda-cu121" {
  inherits  = ["_distribution-jazzy-wheels", "_join-cuda-cu121-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-cuda:jazzy-wheels-core-cu121", "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu121-cuda12.1.105"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-torch-cu128" {
  inherits  = ["_distribution-jazzy-wheels", "_join-torch-cu128-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-torch:jazzy-wheels-core-cu128", "${REGISTRY}/ros-torch:jazzy-wheels-core-cu128-torch2.10.0"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-torch-cu130" {
  inherits  = ["_distribution-jazzy-wheels", "_join-torch-cu130-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-torch:jazzy-wheels-core-cu130", "${REGISTRY}/ros-torch:jazzy-wheels-core-cu130-torch2.12.1"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.12.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu130-torch2.12.1"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-torch-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-jazzy-wheels", "_join-torch-cpu-bookworm"]
  platforms   = platforms(["linux/amd64"])
  tags        = ["${REGISTRY}/ros-torch:jazzy-wheels-core-cpu", "${REGISTRY}/ros-torch:jazzy-wheels-core-cpu-torch2.10.0"]
  contexts    = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-tensorflow-cu128" {
  inherits  = ["_distribution-jazzy-wheels", "_join-tensorflow-cu128-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-tf:jazzy-wheels-core-cu128", "${REGISTRY}/ros-tf:jazzy-wheels-core-cu128-tf2.20.0"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-tensorflow-cpu" {
  inherits  = ["_distribution-jazzy-wheels", "_join-tensorflow-cpu-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags      = ["${REGISTRY}/ros-tf:jazzy-wheels-core-cpu", "${REGISTRY}/ros-tf:jazzy-wheels-core-cpu-tf2.20.0"]
  contexts  = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-ml-cu128" {
  inherits  = ["_distribution-jazzy-wheels", "_join-ml-cu128-bookworm"]
  platforms = platforms(["linux/amd64"])
  tags = [
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cu128",
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cu128-torch2.10.0-tf2.20.0",
  ]
  contexts = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

target "jazzy-wheels-core-ml-cpu" {
  description = "cannot be built yet: no lock; run 'make locks' where the package indexes answer, PyTorch's own among them"
  inherits    = ["_distribution-jazzy-wheels", "_join-ml-cpu-bookworm"]
  platforms   = platforms(["linux/amd64"])
  tags        = ["${REGISTRY}/ros-ml:jazzy-wheels-core-cpu", "${REGISTRY}/ros-ml:jazzy-wheels-core-cpu-torch2.10.0-tf2.20.0"]
  contexts    = { ros = image("ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
  }
}

# ---- Structure tests, inside the build -----------------------------------------------------------------------------

target "noetic-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-core") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core"
  }
}

target "noetic-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-base") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base"
  }
}

target "noetic-robot-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-robot") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot"
  }
}

target "noetic-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-perception") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception"
  }
}

target "noetic-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-desktop") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop"
  }
}

target "noetic-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "noetic-desktop-full") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full"
  }
}

target "noetic-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-robot-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "noetic-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-robot-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "noetic-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-robot-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "noetic-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-core-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-core-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-base-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-base-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-robot-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-robot-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-perception-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-perception-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-desktop-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-desktop-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-desktop-full-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "noetic-desktop-full-torch-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "noetic-core-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-core-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core torch=2.4.1"
  }
}

target "noetic-base-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-base-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base torch=2.4.1"
  }
}

target "noetic-robot-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-robot-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot torch=2.4.1"
  }
}

target "noetic-perception-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-perception-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception torch=2.4.1"
  }
}

target "noetic-desktop-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-desktop-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop torch=2.4.1"
  }
}

target "noetic-desktop-full-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "noetic-desktop-full-torch-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full torch ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full torch=2.4.1"
  }
}

target "noetic-core-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-core-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core tensorflow=2.13.1"
  }
}

target "noetic-base-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-base-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base tensorflow=2.13.1"
  }
}

target "noetic-robot-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-robot-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot tensorflow=2.13.1"
  }
}

target "noetic-perception-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-perception-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception tensorflow=2.13.1"
  }
}

target "noetic-desktop-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-desktop-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop tensorflow=2.13.1"
  }
}

target "noetic-desktop-full-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "noetic-desktop-full-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full tensorflow=2.13.1"
  }
}

target "foxy-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "foxy-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core"
  }
}

target "foxy-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "foxy-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base"
  }
}

target "foxy-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "foxy-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop"
  }
}

target "foxy-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "foxy-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "foxy-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "foxy-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "foxy-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "foxy-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "foxy-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "foxy-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "foxy-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "foxy-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "foxy-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-core-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "foxy-core-torch-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-base-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "foxy-base-torch-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-desktop-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "foxy-desktop-torch-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "foxy-core-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "foxy-core-torch-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core torch=2.4.1"
  }
}

target "foxy-base-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "foxy-base-torch-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base torch=2.4.1"
  }
}

target "foxy-desktop-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "foxy-desktop-torch-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop torch=2.4.1"
  }
}

target "foxy-core-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "foxy-core-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core tensorflow ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core tensorflow=2.13.1"
  }
}

target "foxy-base-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "foxy-base-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base tensorflow ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base tensorflow=2.13.1"
  }
}

target "foxy-desktop-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "foxy-desktop-tensorflow-cpu38") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-desktop tensorflow ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop tensorflow=2.13.1"
  }
}

target "humble-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "humble-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core"
  }
}

target "humble-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "humble-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base"
  }
}

target "humble-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "humble-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception"
  }
}

target "humble-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "humble-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop"
  }
}

target "humble-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "humble-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full"
  }
}

target "humble-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "humble-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "humble-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "humble-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "humble-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "humble-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "humble-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "humble-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "humble-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "humble-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "humble-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "humble-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "humble-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "humble-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "humble-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "humble-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core torch=2.10.0"
  }
}

target "humble-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0"
  }
}

target "humble-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0"
  }
}

target "humble-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0"
  }
}

target "humble-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "humble-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0"
  }
}

target "humble-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "humble-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "humble-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "humble-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "humble-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "humble-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "humble-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core tensorflow=2.20.0"
  }
}

target "humble-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "humble-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base tensorflow=2.20.0"
  }
}

target "humble-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "humble-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception tensorflow=2.20.0"
  }
}

target "humble-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "humble-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop tensorflow=2.20.0"
  }
}

target "humble-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "humble-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full tensorflow=2.20.0"
  }
}

target "humble-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "humble-core-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "humble-base-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "humble-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "humble-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "humble-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "humble-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "humble-core-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core torch=2.10.0 tensorflow=2.20.0"
  }
}

target "humble-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "humble-base-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 tensorflow=2.20.0"
  }
}

target "humble-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "humble-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 tensorflow=2.20.0"
  }
}

target "humble-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "humble-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 tensorflow=2.20.0"
  }
}

target "humble-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "humble-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 tensorflow=2.20.0"
  }
}

target "iron-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "iron-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core"
  }
}

target "iron-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "iron-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base"
  }
}

target "iron-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "iron-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception"
  }
}

target "iron-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "iron-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop"
  }
}

target "iron-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "iron-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full"
  }
}

target "iron-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "iron-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "iron-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "iron-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "iron-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "iron-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "iron-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "iron-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "iron-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "iron-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "iron-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "iron-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "iron-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "iron-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "iron-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "iron-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core torch=2.10.0"
  }
}

target "iron-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0"
  }
}

target "iron-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0"
  }
}

target "iron-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0"
  }
}

target "iron-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "iron-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0"
  }
}

target "iron-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "iron-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "iron-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "iron-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "iron-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "iron-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "iron-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core tensorflow=2.20.0"
  }
}

target "iron-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "iron-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base tensorflow=2.20.0"
  }
}

target "iron-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "iron-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception tensorflow=2.20.0"
  }
}

target "iron-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "iron-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop tensorflow=2.20.0"
  }
}

target "iron-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "iron-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full tensorflow=2.20.0"
  }
}

target "iron-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "iron-core-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "iron-base-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "iron-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "iron-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "iron-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "iron-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "iron-core-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core torch=2.10.0 tensorflow=2.20.0"
  }
}

target "iron-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "iron-base-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 tensorflow=2.20.0"
  }
}

target "iron-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "iron-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 tensorflow=2.20.0"
  }
}

target "iron-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "iron-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 tensorflow=2.20.0"
  }
}

target "iron-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "iron-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "jazzy-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core"
  }
}

target "jazzy-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "jazzy-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base"
  }
}

target "jazzy-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "jazzy-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception"
  }
}

target "jazzy-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "jazzy-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop"
  }
}

target "jazzy-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "jazzy-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full"
  }
}

target "jazzy-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "jazzy-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "jazzy-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "jazzy-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core torch=2.10.0"
  }
}

target "jazzy-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0"
  }
}

target "jazzy-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0"
  }
}

target "jazzy-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0"
  }
}

target "jazzy-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "jazzy-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0"
  }
}

target "jazzy-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "jazzy-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core tensorflow=2.20.0"
  }
}

target "jazzy-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "jazzy-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base tensorflow=2.20.0"
  }
}

target "jazzy-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "jazzy-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception tensorflow=2.20.0"
  }
}

target "jazzy-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "jazzy-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop tensorflow=2.20.0"
  }
}

target "jazzy-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "jazzy-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full tensorflow=2.20.0"
  }
}

target "jazzy-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-core-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-base-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "jazzy-core-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "jazzy-base-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "jazzy-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "jazzy-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "jazzy-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 tensorflow=2.20.0"
  }
}

target "kilted-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "kilted-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core"
  }
}

target "kilted-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "kilted-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base"
  }
}

target "kilted-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "kilted-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception"
  }
}

target "kilted-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "kilted-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop"
  }
}

target "kilted-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "kilted-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full"
  }
}

target "kilted-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "kilted-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "kilted-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "kilted-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "kilted-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "kilted-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "kilted-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "kilted-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "kilted-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "kilted-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "kilted-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "kilted-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "kilted-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "kilted-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core torch=2.10.0"
  }
}

target "kilted-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0"
  }
}

target "kilted-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0"
  }
}

target "kilted-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0"
  }
}

target "kilted-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "kilted-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0"
  }
}

target "kilted-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "kilted-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "kilted-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "kilted-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "kilted-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "kilted-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "kilted-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core tensorflow=2.20.0"
  }
}

target "kilted-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "kilted-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base tensorflow=2.20.0"
  }
}

target "kilted-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "kilted-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception tensorflow=2.20.0"
  }
}

target "kilted-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "kilted-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop tensorflow=2.20.0"
  }
}

target "kilted-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "kilted-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full tensorflow=2.20.0"
  }
}

target "kilted-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "kilted-core-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "kilted-base-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "kilted-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "kilted-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "kilted-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "kilted-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "kilted-core-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core torch=2.10.0 tensorflow=2.20.0"
  }
}

target "kilted-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "kilted-base-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 tensorflow=2.20.0"
  }
}

target "kilted-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "kilted-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 tensorflow=2.20.0"
  }
}

target "kilted-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "kilted-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 tensorflow=2.20.0"
  }
}

target "kilted-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "kilted-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch tensorflow ml ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 tensorflow=2.20.0"
  }
}

target "lyrical-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "lyrical-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core"
  }
}

target "lyrical-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "lyrical-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base"
  }
}

target "lyrical-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "lyrical-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception"
  }
}

target "lyrical-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "lyrical-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop"
  }
}

target "lyrical-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "lyrical-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full"
  }
}

target "lyrical-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "lyrical-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "lyrical-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "lyrical-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "lyrical-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "lyrical-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "lyrical-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "lyrical-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "lyrical-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "lyrical-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "lyrical-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "lyrical-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "lyrical-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "lyrical-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "lyrical-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core torch=2.10.0"
  }
}

target "lyrical-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.10.0"
  }
}

target "lyrical-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.10.0"
  }
}

target "lyrical-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.10.0"
  }
}

target "lyrical-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "lyrical-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.10.0"
  }
}

target "rolling-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "rolling-core") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core"
  }
}

target "rolling-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "rolling-base") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base"
  }
}

target "rolling-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "rolling-perception") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception"
  }
}

target "rolling-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "rolling-desktop") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop"
  }
}

target "rolling-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "rolling-desktop-full") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full"
  }
}

target "rolling-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "rolling-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "rolling-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "rolling-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "rolling-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "rolling-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "rolling-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "rolling-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "rolling-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "rolling-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "rolling-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "rolling-base-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "rolling-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "rolling-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-base-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full cuda torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "rolling-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core torch=2.10.0"
  }
}

target "rolling-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-base-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.10.0"
  }
}

target "rolling-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.10.0"
  }
}

target "rolling-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.10.0"
  }
}

target "rolling-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "rolling-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros2 ros2-core ros2-base ros2-perception ros2-desktop ros2-desktop-full torch ros2-workspace ros2-components pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.10.0"
  }
}

target "bookworm-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-core") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev"
  }
}

target "bookworm-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-base") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev"
  }
}

target "bookworm-robot-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-robot") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev"
  }
}

target "bookworm-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-perception") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev"
  }
}

target "bookworm-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-desktop") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev"
  }
}

target "bookworm-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "bookworm-desktop-full") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev"
  }
}

target "bookworm-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-robot-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-robot-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-robot-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "bookworm-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "bookworm-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-core-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-base-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-robot-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-core-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-base-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-robot-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-robot-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "bookworm-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-core-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0"
  }
}

target "bookworm-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-base-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0"
  }
}

target "bookworm-robot-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-robot-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0"
  }
}

target "bookworm-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0"
  }
}

target "bookworm-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0"
  }
}

target "bookworm-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "bookworm-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full torch ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0"
  }
}

target "bookworm-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "bookworm-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "bookworm-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full tensorflow ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0"
  }
}

target "bookworm-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-core-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-base-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-robot-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "bookworm-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-core-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "bookworm-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-base-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "bookworm-robot-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-robot-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "bookworm-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "bookworm-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "bookworm-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "bookworm-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-core") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev"
  }
}

target "trixie-base-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-base") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev"
  }
}

target "trixie-robot-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-robot") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev"
  }
}

target "trixie-perception-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-perception") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev"
  }
}

target "trixie-desktop-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-desktop") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev"
  }
}

target "trixie-desktop-full-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros", "trixie-desktop-full") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev"
  }
}

target "trixie-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-base-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-robot-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-perception-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-base-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-robot-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-perception-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-base-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-robot-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-perception-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "trixie-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "trixie-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-core-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-base-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-robot-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-core-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-base-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-robot-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-robot-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-perception-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "trixie-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-core-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0"
  }
}

target "trixie-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-base-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0"
  }
}

target "trixie-robot-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-robot-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0"
  }
}

target "trixie-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-perception-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0"
  }
}

target "trixie-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0"
  }
}

target "trixie-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-torch", "trixie-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0"
  }
}

target "trixie-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "trixie-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0"
  }
}

target "trixie-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0"
  }
}

target "trixie-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0"
  }
}

target "trixie-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0"
  }
}

target "trixie-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0"
  }
}

target "trixie-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-tf", "trixie-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0"
  }
}

target "trixie-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-core-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-base-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-robot-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "trixie-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-core-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-base-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-robot-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-robot-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-perception-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-desktop-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "trixie-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64", "linux/arm64"])
  contexts  = { image = image("ros-ml", "trixie-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full torch tensorflow ml ros1-workspace ros1-components pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian packages_core=ros-core,ros-core-dev,ros-core-python-dev packages_base=ros-base,ros-base-dev,ros-base-python-dev packages_robot=ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0"
  }
}

target "jazzy-wheels-core-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros", "jazzy-wheels-core") }
  args = {
    TESTS  = "contract ros2-wheels pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6"
  }
}

target "jazzy-wheels-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-wheels-core-cuda-cu128") }
  args = {
    TESTS  = "contract ros2-wheels cuda pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-wheels-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-wheels-core-cuda-cu130") }
  args = {
    TESTS  = "contract ros2-wheels cuda pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-wheels-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-cuda", "jazzy-wheels-core-cuda-cu121") }
  args = {
    TESTS  = "contract ros2-wheels cuda pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5"
  }
}

target "jazzy-wheels-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-wheels-core-torch-cu128") }
  args = {
    TESTS  = "contract ros2-wheels cuda torch pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-wheels-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-wheels-core-torch-cu130") }
  args = {
    TESTS  = "contract ros2-wheels cuda torch pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 torch=2.12.1 cuda=13.0.96 cudnn=9.20.0.48 nccl=2.29.7"
  }
}

target "jazzy-wheels-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-torch", "jazzy-wheels-core-torch-cpu") }
  args = {
    TESTS  = "contract ros2-wheels torch pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 torch=2.10.0"
  }
}

target "jazzy-wheels-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-wheels-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros2-wheels cuda tensorflow pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-wheels-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-tf", "jazzy-wheels-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros2-wheels tensorflow pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 tensorflow=2.20.0"
  }
}

target "jazzy-wheels-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-wheels-core-ml-cu128") }
  args = {
    TESTS  = "contract ros2-wheels cuda torch tensorflow ml pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "jazzy-wheels-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = platforms(["linux/amd64"])
  contexts  = { image = image("ros-ml", "jazzy-wheels-core-ml-cpu") }
  args = {
    TESTS  = "contract ros2-wheels torch tensorflow ml pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 torch=2.10.0 tensorflow=2.20.0"
  }
}

# ---- Groups --------------------------------------------------------------------------------------------------------

group "default" {
  targets = ["bookworm-core"]
}

group "noetic" {
  targets = [
    "noetic-core",
    "noetic-base",
    "noetic-robot",
    "noetic-perception",
    "noetic-desktop",
    "noetic-desktop-full",
    "noetic-core-cuda-cu128",
    "noetic-base-cuda-cu128",
    "noetic-robot-cuda-cu128",
    "noetic-perception-cuda-cu128",
    "noetic-desktop-cuda-cu128",
    "noetic-desktop-full-cuda-cu128",
    "noetic-core-cuda-cu130",
    "noetic-base-cuda-cu130",
    "noetic-robot-cuda-cu130",
    "noetic-perception-cuda-cu130",
    "noetic-desktop-cuda-cu130",
    "noetic-desktop-full-cuda-cu130",
    "noetic-core-cuda-cu121",
    "noetic-base-cuda-cu121",
    "noetic-robot-cuda-cu121",
    "noetic-perception-cuda-cu121",
    "noetic-desktop-cuda-cu121",
    "noetic-desktop-full-cuda-cu121",
    "noetic-core-torch-cu121",
    "noetic-base-torch-cu121",
    "noetic-robot-torch-cu121",
    "noetic-perception-torch-cu121",
    "noetic-desktop-torch-cu121",
    "noetic-desktop-full-torch-cu121",
    "noetic-core-tensorflow-cpu38",
    "noetic-base-tensorflow-cpu38",
    "noetic-robot-tensorflow-cpu38",
    "noetic-perception-tensorflow-cpu38",
    "noetic-desktop-tensorflow-cpu38",
    "noetic-desktop-full-tensorflow-cpu38",
  ]
}

group "foxy" {
  targets = [
    "foxy-core",
    "foxy-base",
    "foxy-desktop",
    "foxy-core-cuda-cu128",
    "foxy-base-cuda-cu128",
    "foxy-desktop-cuda-cu128",
    "foxy-core-cuda-cu130",
    "foxy-base-cuda-cu130",
    "foxy-desktop-cuda-cu130",
    "foxy-core-cuda-cu121",
    "foxy-base-cuda-cu121",
    "foxy-desktop-cuda-cu121",
    "foxy-core-torch-cu121",
    "foxy-base-torch-cu121",
    "foxy-desktop-torch-cu121",
    "foxy-core-tensorflow-cpu38",
    "foxy-base-tensorflow-cpu38",
    "foxy-desktop-tensorflow-cpu38",
  ]
}

group "humble" {
  targets = [
    "humble-core",
    "humble-base",
    "humble-perception",
    "humble-desktop",
    "humble-desktop-full",
    "humble-core-cuda-cu128",
    "humble-base-cuda-cu128",
    "humble-perception-cuda-cu128",
    "humble-desktop-cuda-cu128",
    "humble-desktop-full-cuda-cu128",
    "humble-core-cuda-cu130",
    "humble-base-cuda-cu130",
    "humble-perception-cuda-cu130",
    "humble-desktop-cuda-cu130",
    "humble-desktop-full-cuda-cu130",
    "humble-core-cuda-cu121",
    "humble-base-cuda-cu121",
    "humble-perception-cuda-cu121",
    "humble-desktop-cuda-cu121",
    "humble-desktop-full-cuda-cu121",
    "humble-core-torch-cu128",
    "humble-base-torch-cu128",
    "humble-perception-torch-cu128",
    "humble-desktop-torch-cu128",
    "humble-desktop-full-torch-cu128",
    "humble-core-torch-cu130",
    "humble-base-torch-cu130",
    "humble-perception-torch-cu130",
    "humble-desktop-torch-cu130",
    "humble-desktop-full-torch-cu130",
    "humble-core-torch-cpu",
    "humble-base-torch-cpu",
    "humble-perception-torch-cpu",
    "humble-desktop-torch-cpu",
    "humble-desktop-full-torch-cpu",
    "humble-core-tensorflow-cu128",
    "humble-base-tensorflow-cu128",
    "humble-perception-tensorflow-cu128",
    "humble-desktop-tensorflow-cu128",
    "humble-desktop-full-tensorflow-cu128",
    "humble-core-tensorflow-cpu",
    "humble-base-tensorflow-cpu",
    "humble-perception-tensorflow-cpu",
    "humble-desktop-tensorflow-cpu",
    "humble-desktop-full-tensorflow-cpu",
    "humble-core-ml-cu128",
    "humble-base-ml-cu128",
    "humble-perception-ml-cu128",
    "humble-desktop-ml-cu128",
    "humble-desktop-full-ml-cu128",
    "humble-core-ml-cpu",
    "humble-base-ml-cpu",
    "humble-perception-ml-cpu",
    "humble-desktop-ml-cpu",
    "humble-desktop-full-ml-cpu",
  ]
}

group "iron" {
  targets = [
    "iron-core",
    "iron-base",
    "iron-perception",
    "iron-desktop",
    "iron-desktop-full",
    "iron-core-cuda-cu128",
    "iron-base-cuda-cu128",
    "iron-perception-cuda-cu128",
    "iron-desktop-cuda-cu128",
    "iron-desktop-full-cuda-cu128",
    "iron-core-cuda-cu130",
    "iron-base-cuda-cu130",
    "iron-perception-cuda-cu130",
    "iron-desktop-cuda-cu130",
    "iron-desktop-full-cuda-cu130",
    "iron-core-cuda-cu121",
    "iron-base-cuda-cu121",
    "iron-perception-cuda-cu121",
    "iron-desktop-cuda-cu121",
    "iron-desktop-full-cuda-cu121",
    "iron-core-torch-cu128",
    "iron-base-torch-cu128",
    "iron-perception-torch-cu128",
    "iron-desktop-torch-cu128",
    "iron-desktop-full-torch-cu128",
    "iron-core-torch-cu130",
    "iron-base-torch-cu130",
    "iron-perception-torch-cu130",
    "iron-desktop-torch-cu130",
    "iron-desktop-full-torch-cu130",
    "iron-core-torch-cpu",
    "iron-base-torch-cpu",
    "iron-perception-torch-cpu",
    "iron-desktop-torch-cpu",
    "iron-desktop-full-torch-cpu",
    "iron-core-tensorflow-cu128",
    "iron-base-tensorflow-cu128",
    "iron-perception-tensorflow-cu128",
    "iron-desktop-tensorflow-cu128",
    "iron-desktop-full-tensorflow-cu128",
    "iron-core-tensorflow-cpu",
    "iron-base-tensorflow-cpu",
    "iron-perception-tensorflow-cpu",
    "iron-desktop-tensorflow-cpu",
    "iron-desktop-full-tensorflow-cpu",
    "iron-core-ml-cu128",
    "iron-base-ml-cu128",
    "iron-perception-ml-cu128",
    "iron-desktop-ml-cu128",
    "iron-desktop-full-ml-cu128",
    "iron-core-ml-cpu",
    "iron-base-ml-cpu",
    "iron-perception-ml-cpu",
    "iron-desktop-ml-cpu",
    "iron-desktop-full-ml-cpu",
  ]
}

group "jazzy" {
  targets = [
    "jazzy-core",
    "jazzy-base",
    "jazzy-perception",
    "jazzy-desktop",
    "jazzy-desktop-full",
    "jazzy-core-cuda-cu128",
    "jazzy-base-cuda-cu128",
    "jazzy-perception-cuda-cu128",
    "jazzy-desktop-cuda-cu128",
    "jazzy-desktop-full-cuda-cu128",
    "jazzy-core-cuda-cu130",
    "jazzy-base-cuda-cu130",
    "jazzy-perception-cuda-cu130",
    "jazzy-desktop-cuda-cu130",
    "jazzy-desktop-full-cuda-cu130",
    "jazzy-core-cuda-cu121",
    "jazzy-base-cuda-cu121",
    "jazzy-perception-cuda-cu121",
    "jazzy-desktop-cuda-cu121",
    "jazzy-desktop-full-cuda-cu121",
    "jazzy-core-torch-cu128",
    "jazzy-base-torch-cu128",
    "jazzy-perception-torch-cu128",
    "jazzy-desktop-torch-cu128",
    "jazzy-desktop-full-torch-cu128",
    "jazzy-core-torch-cu130",
    "jazzy-base-torch-cu130",
    "jazzy-perception-torch-cu130",
    "jazzy-desktop-torch-cu130",
    "jazzy-desktop-full-torch-cu130",
    "jazzy-core-torch-cpu",
    "jazzy-base-torch-cpu",
    "jazzy-perception-torch-cpu",
    "jazzy-desktop-torch-cpu",
    "jazzy-desktop-full-torch-cpu",
    "jazzy-core-tensorflow-cu128",
    "jazzy-base-tensorflow-cu128",
    "jazzy-perception-tensorflow-cu128",
    "jazzy-desktop-tensorflow-cu128",
    "jazzy-desktop-full-tensorflow-cu128",
    "jazzy-core-tensorflow-cpu",
    "jazzy-base-tensorflow-cpu",
    "jazzy-perception-tensorflow-cpu",
    "jazzy-desktop-tensorflow-cpu",
    "jazzy-desktop-full-tensorflow-cpu",
    "jazzy-core-ml-cu128",
    "jazzy-base-ml-cu128",
    "jazzy-perception-ml-cu128",
    "jazzy-desktop-ml-cu128",
    "jazzy-desktop-full-ml-cu128",
    "jazzy-core-ml-cpu",
    "jazzy-base-ml-cpu",
    "jazzy-perception-ml-cpu",
    "jazzy-desktop-ml-cpu",
    "jazzy-desktop-full-ml-cpu",
  ]
}

group "kilted" {
  targets = [
    "kilted-core",
    "kilted-base",
    "kilted-perception",
    "kilted-desktop",
    "kilted-desktop-full",
    "kilted-core-cuda-cu128",
    "kilted-base-cuda-cu128",
    "kilted-perception-cuda-cu128",
    "kilted-desktop-cuda-cu128",
    "kilted-desktop-full-cuda-cu128",
    "kilted-core-cuda-cu130",
    "kilted-base-cuda-cu130",
    "kilted-perception-cuda-cu130",
    "kilted-desktop-cuda-cu130",
    "kilted-desktop-full-cuda-cu130",
    "kilted-core-cuda-cu121",
    "kilted-base-cuda-cu121",
    "kilted-perception-cuda-cu121",
    "kilted-desktop-cuda-cu121",
    "kilted-desktop-full-cuda-cu121",
    "kilted-core-torch-cu128",
    "kilted-base-torch-cu128",
    "kilted-perception-torch-cu128",
    "kilted-desktop-torch-cu128",
    "kilted-desktop-full-torch-cu128",
    "kilted-core-torch-cu130",
    "kilted-base-torch-cu130",
    "kilted-perception-torch-cu130",
    "kilted-desktop-torch-cu130",
    "kilted-desktop-full-torch-cu130",
    "kilted-core-torch-cpu",
    "kilted-base-torch-cpu",
    "kilted-perception-torch-cpu",
    "kilted-desktop-torch-cpu",
    "kilted-desktop-full-torch-cpu",
    "kilted-core-tensorflow-cu128",
    "kilted-base-tensorflow-cu128",
    "kilted-perception-tensorflow-cu128",
    "kilted-desktop-tensorflow-cu128",
    "kilted-desktop-full-tensorflow-cu128",
    "kilted-core-tensorflow-cpu",
    "kilted-base-tensorflow-cpu",
    "kilted-perception-tensorflow-cpu",
    "kilted-desktop-tensorflow-cpu",
    "kilted-desktop-full-tensorflow-cpu",
    "kilted-core-ml-cu128",
    "kilted-base-ml-cu128",
    "kilted-perception-ml-cu128",
    "kilted-desktop-ml-cu128",
    "kilted-desktop-full-ml-cu128",
    "kilted-core-ml-cpu",
    "kilted-base-ml-cpu",
    "kilted-perception-ml-cpu",
    "kilted-desktop-ml-cpu",
    "kilted-desktop-full-ml-cpu",
  ]
}

group "lyrical" {
  targets = [
    "lyrical-core",
    "lyrical-base",
    "lyrical-perception",
    "lyrical-desktop",
    "lyrical-desktop-full",
    "lyrical-core-cuda-cu128",
    "lyrical-base-cuda-cu128",
    "lyrical-perception-cuda-cu128",
    "lyrical-desktop-cuda-cu128",
    "lyrical-desktop-full-cuda-cu128",
    "lyrical-core-cuda-cu130",
    "lyrical-base-cuda-cu130",
    "lyrical-perception-cuda-cu130",
    "lyrical-desktop-cuda-cu130",
    "lyrical-desktop-full-cuda-cu130",
    "lyrical-core-cuda-cu121",
    "lyrical-base-cuda-cu121",
    "lyrical-perception-cuda-cu121",
    "lyrical-desktop-cuda-cu121",
    "lyrical-desktop-full-cuda-cu121",
    "lyrical-core-torch-cu128",
    "lyrical-base-torch-cu128",
    "lyrical-perception-torch-cu128",
    "lyrical-desktop-torch-cu128",
    "lyrical-desktop-full-torch-cu128",
    "lyrical-core-torch-cu130",
    "lyrical-base-torch-cu130",
    "lyrical-perception-torch-cu130",
    "lyrical-desktop-torch-cu130",
    "lyrical-desktop-full-torch-cu130",
  ]
}

group "rolling" {
  targets = [
    "rolling-core",
    "rolling-base",
    "rolling-perception",
    "rolling-desktop",
    "rolling-desktop-full",
    "rolling-core-cuda-cu128",
    "rolling-base-cuda-cu128",
    "rolling-perception-cuda-cu128",
    "rolling-desktop-cuda-cu128",
    "rolling-desktop-full-cuda-cu128",
    "rolling-core-cuda-cu130",
    "rolling-base-cuda-cu130",
    "rolling-perception-cuda-cu130",
    "rolling-desktop-cuda-cu130",
    "rolling-desktop-full-cuda-cu130",
    "rolling-core-cuda-cu121",
    "rolling-base-cuda-cu121",
    "rolling-perception-cuda-cu121",
    "rolling-desktop-cuda-cu121",
    "rolling-desktop-full-cuda-cu121",
    "rolling-core-torch-cu128",
    "rolling-base-torch-cu128",
    "rolling-perception-torch-cu128",
    "rolling-desktop-torch-cu128",
    "rolling-desktop-full-torch-cu128",
    "rolling-core-torch-cu130",
    "rolling-base-torch-cu130",
    "rolling-perception-torch-cu130",
    "rolling-desktop-torch-cu130",
    "rolling-desktop-full-torch-cu130",
  ]
}

group "bookworm" {
  targets = [
    "bookworm-core",
    "bookworm-base",
    "bookworm-robot",
    "bookworm-perception",
    "bookworm-desktop",
    "bookworm-desktop-full",
    "bookworm-core-cuda-cu128",
    "bookworm-base-cuda-cu128",
    "bookworm-robot-cuda-cu128",
    "bookworm-perception-cuda-cu128",
    "bookworm-desktop-cuda-cu128",
    "bookworm-desktop-full-cuda-cu128",
    "bookworm-core-cuda-cu130",
    "bookworm-base-cuda-cu130",
    "bookworm-robot-cuda-cu130",
    "bookworm-perception-cuda-cu130",
    "bookworm-desktop-cuda-cu130",
    "bookworm-desktop-full-cuda-cu130",
    "bookworm-core-cuda-cu121",
    "bookworm-base-cuda-cu121",
    "bookworm-robot-cuda-cu121",
    "bookworm-perception-cuda-cu121",
    "bookworm-desktop-cuda-cu121",
    "bookworm-desktop-full-cuda-cu121",
    "bookworm-core-torch-cu128",
    "bookworm-base-torch-cu128",
    "bookworm-robot-torch-cu128",
    "bookworm-perception-torch-cu128",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-core-torch-cu130",
    "bookworm-base-torch-cu130",
    "bookworm-robot-torch-cu130",
    "bookworm-perception-torch-cu130",
    "bookworm-desktop-torch-cu130",
    "bookworm-desktop-full-torch-cu130",
    "bookworm-core-tensorflow-cu128",
    "bookworm-base-tensorflow-cu128",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-core-tensorflow-cpu",
    "bookworm-base-tensorflow-cpu",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-full-tensorflow-cpu",
    "bookworm-core-ml-cu128",
    "bookworm-base-ml-cu128",
    "bookworm-robot-ml-cu128",
    "bookworm-perception-ml-cu128",
    "bookworm-desktop-ml-cu128",
    "bookworm-desktop-full-ml-cu128",
  ]
}

group "trixie" {
  targets = [
    "trixie-core",
    "trixie-base",
    "trixie-robot",
    "trixie-perception",
    "trixie-desktop",
    "trixie-desktop-full",
    "trixie-core-cuda-cu128",
    "trixie-base-cuda-cu128",
    "trixie-robot-cuda-cu128",
    "trixie-perception-cuda-cu128",
    "trixie-desktop-cuda-cu128",
    "trixie-desktop-full-cuda-cu128",
    "trixie-core-cuda-cu130",
    "trixie-base-cuda-cu130",
    "trixie-robot-cuda-cu130",
    "trixie-perception-cuda-cu130",
    "trixie-desktop-cuda-cu130",
    "trixie-desktop-full-cuda-cu130",
    "trixie-core-cuda-cu121",
    "trixie-base-cuda-cu121",
    "trixie-robot-cuda-cu121",
    "trixie-perception-cuda-cu121",
    "trixie-desktop-cuda-cu121",
    "trixie-desktop-full-cuda-cu121",
    "trixie-core-torch-cu128",
    "trixie-base-torch-cu128",
    "trixie-robot-torch-cu128",
    "trixie-perception-torch-cu128",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-full-torch-cu128",
    "trixie-core-torch-cu130",
    "trixie-base-torch-cu130",
    "trixie-robot-torch-cu130",
    "trixie-perception-torch-cu130",
    "trixie-desktop-torch-cu130",
    "trixie-desktop-full-torch-cu130",
    "trixie-core-torch-cpu",
    "trixie-base-torch-cpu",
    "trixie-robot-torch-cpu",
    "trixie-perception-torch-cpu",
    "trixie-desktop-torch-cpu",
    "trixie-desktop-full-torch-cpu",
    "trixie-core-tensorflow-cu128",
    "trixie-base-tensorflow-cu128",
    "trixie-robot-tensorflow-cu128",
    "trixie-perception-tensorflow-cu128",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-core-tensorflow-cpu",
    "trixie-base-tensorflow-cpu",
    "trixie-robot-tensorflow-cpu",
    "trixie-perception-tensorflow-cpu",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-full-tensorflow-cpu",
    "trixie-core-ml-cu128",
    "trixie-base-ml-cu128",
    "trixie-robot-ml-cu128",
    "trixie-perception-ml-cu128",
    "trixie-desktop-ml-cu128",
    "trixie-desktop-full-ml-cu128",
    "trixie-core-ml-cpu",
    "trixie-base-ml-cpu",
    "trixie-robot-ml-cpu",
    "trixie-perception-ml-cpu",
    "trixie-desktop-ml-cpu",
    "trixie-desktop-full-ml-cpu",
  ]
}

group "jazzy-wheels" {
  targets = [
    "jazzy-wheels-core",
    "jazzy-wheels-core-cuda-cu128",
    "jazzy-wheels-core-cuda-cu130",
    "jazzy-wheels-core-cuda-cu121",
    "jazzy-wheels-core-torch-cu128",
    "jazzy-wheels-core-torch-cu130",
    "jazzy-wheels-core-tensorflow-cu128",
    "jazzy-wheels-core-tensorflow-cpu",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "core" {
  targets = [
    "noetic-core",
    "noetic-core-cuda-cu128",
    "noetic-core-cuda-cu130",
    "noetic-core-cuda-cu121",
    "noetic-core-torch-cu121",
    "noetic-core-tensorflow-cpu38",
    "foxy-core",
    "foxy-core-cuda-cu128",
    "foxy-core-cuda-cu130",
    "foxy-core-cuda-cu121",
    "foxy-core-torch-cu121",
    "foxy-core-tensorflow-cpu38",
    "humble-core",
    "humble-core-cuda-cu128",
    "humble-core-cuda-cu130",
    "humble-core-cuda-cu121",
    "humble-core-torch-cu128",
    "humble-core-torch-cu130",
    "humble-core-torch-cpu",
    "humble-core-tensorflow-cu128",
    "humble-core-tensorflow-cpu",
    "humble-core-ml-cu128",
    "humble-core-ml-cpu",
    "iron-core",
    "iron-core-cuda-cu128",
    "iron-core-cuda-cu130",
    "iron-core-cuda-cu121",
    "iron-core-torch-cu128",
    "iron-core-torch-cu130",
    "iron-core-torch-cpu",
    "iron-core-tensorflow-cu128",
    "iron-core-tensorflow-cpu",
    "iron-core-ml-cu128",
    "iron-core-ml-cpu",
    "jazzy-core",
    "jazzy-core-cuda-cu128",
    "jazzy-core-cuda-cu130",
    "jazzy-core-cuda-cu121",
    "jazzy-core-torch-cu128",
    "jazzy-core-torch-cu130",
    "jazzy-core-torch-cpu",
    "jazzy-core-tensorflow-cu128",
    "jazzy-core-tensorflow-cpu",
    "jazzy-core-ml-cu128",
    "jazzy-core-ml-cpu",
    "kilted-core",
    "kilted-core-cuda-cu128",
    "kilted-core-cuda-cu130",
    "kilted-core-cuda-cu121",
    "kilted-core-torch-cu128",
    "kilted-core-torch-cu130",
    "kilted-core-torch-cpu",
    "kilted-core-tensorflow-cu128",
    "kilted-core-tensorflow-cpu",
    "kilted-core-ml-cu128",
    "kilted-core-ml-cpu",
    "lyrical-core",
    "lyrical-core-cuda-cu128",
    "lyrical-core-cuda-cu130",
    "lyrical-core-cuda-cu121",
    "lyrical-core-torch-cu128",
    "lyrical-core-torch-cu130",
    "rolling-core",
    "rolling-core-cuda-cu128",
    "rolling-core-cuda-cu130",
    "rolling-core-cuda-cu121",
    "rolling-core-torch-cu128",
    "rolling-core-torch-cu130",
    "bookworm-core",
    "bookworm-core-cuda-cu128",
    "bookworm-core-cuda-cu130",
    "bookworm-core-cuda-cu121",
    "bookworm-core-torch-cu128",
    "bookworm-core-torch-cu130",
    "bookworm-core-tensorflow-cu128",
    "bookworm-core-tensorflow-cpu",
    "bookworm-core-ml-cu128",
    "trixie-core",
    "trixie-core-cuda-cu128",
    "trixie-core-cuda-cu130",
    "trixie-core-cuda-cu121",
    "trixie-core-torch-cu128",
    "trixie-core-torch-cu130",
    "trixie-core-torch-cpu",
    "trixie-core-tensorflow-cu128",
    "trixie-core-tensorflow-cpu",
    "trixie-core-ml-cu128",
    "trixie-core-ml-cpu",
    "jazzy-wheels-core",
    "jazzy-wheels-core-cuda-cu128",
    "jazzy-wheels-core-cuda-cu130",
    "jazzy-wheels-core-cuda-cu121",
    "jazzy-wheels-core-torch-cu128",
    "jazzy-wheels-core-torch-cu130",
    "jazzy-wheels-core-tensorflow-cu128",
    "jazzy-wheels-core-tensorflow-cpu",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "base" {
  targets = [
    "noetic-base",
    "noetic-base-cuda-cu128",
    "noetic-base-cuda-cu130",
    "noetic-base-cuda-cu121",
    "noetic-base-torch-cu121",
    "noetic-base-tensorflow-cpu38",
    "foxy-base",
    "foxy-base-cuda-cu128",
    "foxy-base-cuda-cu130",
    "foxy-base-cuda-cu121",
    "foxy-base-torch-cu121",
    "foxy-base-tensorflow-cpu38",
    "humble-base",
    "humble-base-cuda-cu128",
    "humble-base-cuda-cu130",
    "humble-base-cuda-cu121",
    "humble-base-torch-cu128",
    "humble-base-torch-cu130",
    "humble-base-torch-cpu",
    "humble-base-tensorflow-cu128",
    "humble-base-tensorflow-cpu",
    "humble-base-ml-cu128",
    "humble-base-ml-cpu",
    "iron-base",
    "iron-base-cuda-cu128",
    "iron-base-cuda-cu130",
    "iron-base-cuda-cu121",
    "iron-base-torch-cu128",
    "iron-base-torch-cu130",
    "iron-base-torch-cpu",
    "iron-base-tensorflow-cu128",
    "iron-base-tensorflow-cpu",
    "iron-base-ml-cu128",
    "iron-base-ml-cpu",
    "jazzy-base",
    "jazzy-base-cuda-cu128",
    "jazzy-base-cuda-cu130",
    "jazzy-base-cuda-cu121",
    "jazzy-base-torch-cu128",
    "jazzy-base-torch-cu130",
    "jazzy-base-torch-cpu",
    "jazzy-base-tensorflow-cu128",
    "jazzy-base-tensorflow-cpu",
    "jazzy-base-ml-cu128",
    "jazzy-base-ml-cpu",
    "kilted-base",
    "kilted-base-cuda-cu128",
    "kilted-base-cuda-cu130",
    "kilted-base-cuda-cu121",
    "kilted-base-torch-cu128",
    "kilted-base-torch-cu130",
    "kilted-base-torch-cpu",
    "kilted-base-tensorflow-cu128",
    "kilted-base-tensorflow-cpu",
    "kilted-base-ml-cu128",
    "kilted-base-ml-cpu",
    "lyrical-base",
    "lyrical-base-cuda-cu128",
    "lyrical-base-cuda-cu130",
    "lyrical-base-cuda-cu121",
    "lyrical-base-torch-cu128",
    "lyrical-base-torch-cu130",
    "rolling-base",
    "rolling-base-cuda-cu128",
    "rolling-base-cuda-cu130",
    "rolling-base-cuda-cu121",
    "rolling-base-torch-cu128",
    "rolling-base-torch-cu130",
    "bookworm-base",
    "bookworm-base-cuda-cu128",
    "bookworm-base-cuda-cu130",
    "bookworm-base-cuda-cu121",
    "bookworm-base-torch-cu128",
    "bookworm-base-torch-cu130",
    "bookworm-base-tensorflow-cu128",
    "bookworm-base-tensorflow-cpu",
    "bookworm-base-ml-cu128",
    "trixie-base",
    "trixie-base-cuda-cu128",
    "trixie-base-cuda-cu130",
    "trixie-base-cuda-cu121",
    "trixie-base-torch-cu128",
    "trixie-base-torch-cu130",
    "trixie-base-torch-cpu",
    "trixie-base-tensorflow-cu128",
    "trixie-base-tensorflow-cpu",
    "trixie-base-ml-cu128",
    "trixie-base-ml-cpu",
  ]
}

group "robot" {
  targets = [
    "noetic-robot",
    "noetic-robot-cuda-cu128",
    "noetic-robot-cuda-cu130",
    "noetic-robot-cuda-cu121",
    "noetic-robot-torch-cu121",
    "noetic-robot-tensorflow-cpu38",
    "bookworm-robot",
    "bookworm-robot-cuda-cu128",
    "bookworm-robot-cuda-cu130",
    "bookworm-robot-cuda-cu121",
    "bookworm-robot-torch-cu128",
    "bookworm-robot-torch-cu130",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-robot-ml-cu128",
    "trixie-robot",
    "trixie-robot-cuda-cu128",
    "trixie-robot-cuda-cu130",
    "trixie-robot-cuda-cu121",
    "trixie-robot-torch-cu128",
    "trixie-robot-torch-cu130",
    "trixie-robot-torch-cpu",
    "trixie-robot-tensorflow-cu128",
    "trixie-robot-tensorflow-cpu",
    "trixie-robot-ml-cu128",
    "trixie-robot-ml-cpu",
  ]
}

group "perception" {
  targets = [
    "noetic-perception",
    "noetic-perception-cuda-cu128",
    "noetic-perception-cuda-cu130",
    "noetic-perception-cuda-cu121",
    "noetic-perception-torch-cu121",
    "noetic-perception-tensorflow-cpu38",
    "humble-perception",
    "humble-perception-cuda-cu128",
    "humble-perception-cuda-cu130",
    "humble-perception-cuda-cu121",
    "humble-perception-torch-cu128",
    "humble-perception-torch-cu130",
    "humble-perception-torch-cpu",
    "humble-perception-tensorflow-cu128",
    "humble-perception-tensorflow-cpu",
    "humble-perception-ml-cu128",
    "humble-perception-ml-cpu",
    "iron-perception",
    "iron-perception-cuda-cu128",
    "iron-perception-cuda-cu130",
    "iron-perception-cuda-cu121",
    "iron-perception-torch-cu128",
    "iron-perception-torch-cu130",
    "iron-perception-torch-cpu",
    "iron-perception-tensorflow-cu128",
    "iron-perception-tensorflow-cpu",
    "iron-perception-ml-cu128",
    "iron-perception-ml-cpu",
    "jazzy-perception",
    "jazzy-perception-cuda-cu128",
    "jazzy-perception-cuda-cu130",
    "jazzy-perception-cuda-cu121",
    "jazzy-perception-torch-cu128",
    "jazzy-perception-torch-cu130",
    "jazzy-perception-torch-cpu",
    "jazzy-perception-tensorflow-cu128",
    "jazzy-perception-tensorflow-cpu",
    "jazzy-perception-ml-cu128",
    "jazzy-perception-ml-cpu",
    "kilted-perception",
    "kilted-perception-cuda-cu128",
    "kilted-perception-cuda-cu130",
    "kilted-perception-cuda-cu121",
    "kilted-perception-torch-cu128",
    "kilted-perception-torch-cu130",
    "kilted-perception-torch-cpu",
    "kilted-perception-tensorflow-cu128",
    "kilted-perception-tensorflow-cpu",
    "kilted-perception-ml-cu128",
    "kilted-perception-ml-cpu",
    "lyrical-perception",
    "lyrical-perception-cuda-cu128",
    "lyrical-perception-cuda-cu130",
    "lyrical-perception-cuda-cu121",
    "lyrical-perception-torch-cu128",
    "lyrical-perception-torch-cu130",
    "rolling-perception",
    "rolling-perception-cuda-cu128",
    "rolling-perception-cuda-cu130",
    "rolling-perception-cuda-cu121",
    "rolling-perception-torch-cu128",
    "rolling-perception-torch-cu130",
    "bookworm-perception",
    "bookworm-perception-cuda-cu128",
    "bookworm-perception-cuda-cu130",
    "bookworm-perception-cuda-cu121",
    "bookworm-perception-torch-cu128",
    "bookworm-perception-torch-cu130",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-perception-ml-cu128",
    "trixie-perception",
    "trixie-perception-cuda-cu128",
    "trixie-perception-cuda-cu130",
    "trixie-perception-cuda-cu121",
    "trixie-perception-torch-cu128",
    "trixie-perception-torch-cu130",
    "trixie-perception-torch-cpu",
    "trixie-perception-tensorflow-cu128",
    "trixie-perception-tensorflow-cpu",
    "trixie-perception-ml-cu128",
    "trixie-perception-ml-cpu",
  ]
}

group "desktop" {
  targets = [
    "noetic-desktop",
    "noetic-desktop-cuda-cu128",
    "noetic-desktop-cuda-cu130",
    "noetic-desktop-cuda-cu121",
    "noetic-desktop-torch-cu121",
    "noetic-desktop-tensorflow-cpu38",
    "foxy-desktop",
    "foxy-desktop-cuda-cu128",
    "foxy-desktop-cuda-cu130",
    "foxy-desktop-cuda-cu121",
    "foxy-desktop-torch-cu121",
    "foxy-desktop-tensorflow-cpu38",
    "humble-desktop",
    "humble-desktop-cuda-cu128",
    "humble-desktop-cuda-cu130",
    "humble-desktop-cuda-cu121",
    "humble-desktop-torch-cu128",
    "humble-desktop-torch-cu130",
    "humble-desktop-torch-cpu",
    "humble-desktop-tensorflow-cu128",
    "humble-desktop-tensorflow-cpu",
    "humble-desktop-ml-cu128",
    "humble-desktop-ml-cpu",
    "iron-desktop",
    "iron-desktop-cuda-cu128",
    "iron-desktop-cuda-cu130",
    "iron-desktop-cuda-cu121",
    "iron-desktop-torch-cu128",
    "iron-desktop-torch-cu130",
    "iron-desktop-torch-cpu",
    "iron-desktop-tensorflow-cu128",
    "iron-desktop-tensorflow-cpu",
    "iron-desktop-ml-cu128",
    "iron-desktop-ml-cpu",
    "jazzy-desktop",
    "jazzy-desktop-cuda-cu128",
    "jazzy-desktop-cuda-cu130",
    "jazzy-desktop-cuda-cu121",
    "jazzy-desktop-torch-cu128",
    "jazzy-desktop-torch-cu130",
    "jazzy-desktop-torch-cpu",
    "jazzy-desktop-tensorflow-cu128",
    "jazzy-desktop-tensorflow-cpu",
    "jazzy-desktop-ml-cu128",
    "jazzy-desktop-ml-cpu",
    "kilted-desktop",
    "kilted-desktop-cuda-cu128",
    "kilted-desktop-cuda-cu130",
    "kilted-desktop-cuda-cu121",
    "kilted-desktop-torch-cu128",
    "kilted-desktop-torch-cu130",
    "kilted-desktop-torch-cpu",
    "kilted-desktop-tensorflow-cu128",
    "kilted-desktop-tensorflow-cpu",
    "kilted-desktop-ml-cu128",
    "kilted-desktop-ml-cpu",
    "lyrical-desktop",
    "lyrical-desktop-cuda-cu128",
    "lyrical-desktop-cuda-cu130",
    "lyrical-desktop-cuda-cu121",
    "lyrical-desktop-torch-cu128",
    "lyrical-desktop-torch-cu130",
    "rolling-desktop",
    "rolling-desktop-cuda-cu128",
    "rolling-desktop-cuda-cu130",
    "rolling-desktop-cuda-cu121",
    "rolling-desktop-torch-cu128",
    "rolling-desktop-torch-cu130",
    "bookworm-desktop",
    "bookworm-desktop-cuda-cu128",
    "bookworm-desktop-cuda-cu130",
    "bookworm-desktop-cuda-cu121",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-torch-cu130",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-ml-cu128",
    "trixie-desktop",
    "trixie-desktop-cuda-cu128",
    "trixie-desktop-cuda-cu130",
    "trixie-desktop-cuda-cu121",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-torch-cu130",
    "trixie-desktop-torch-cpu",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-ml-cu128",
    "trixie-desktop-ml-cpu",
  ]
}

group "desktop-full" {
  targets = [
    "noetic-desktop-full",
    "noetic-desktop-full-cuda-cu128",
    "noetic-desktop-full-cuda-cu130",
    "noetic-desktop-full-cuda-cu121",
    "noetic-desktop-full-torch-cu121",
    "noetic-desktop-full-tensorflow-cpu38",
    "humble-desktop-full",
    "humble-desktop-full-cuda-cu128",
    "humble-desktop-full-cuda-cu130",
    "humble-desktop-full-cuda-cu121",
    "humble-desktop-full-torch-cu128",
    "humble-desktop-full-torch-cu130",
    "humble-desktop-full-torch-cpu",
    "humble-desktop-full-tensorflow-cu128",
    "humble-desktop-full-tensorflow-cpu",
    "humble-desktop-full-ml-cu128",
    "humble-desktop-full-ml-cpu",
    "iron-desktop-full",
    "iron-desktop-full-cuda-cu128",
    "iron-desktop-full-cuda-cu130",
    "iron-desktop-full-cuda-cu121",
    "iron-desktop-full-torch-cu128",
    "iron-desktop-full-torch-cu130",
    "iron-desktop-full-torch-cpu",
    "iron-desktop-full-tensorflow-cu128",
    "iron-desktop-full-tensorflow-cpu",
    "iron-desktop-full-ml-cu128",
    "iron-desktop-full-ml-cpu",
    "jazzy-desktop-full",
    "jazzy-desktop-full-cuda-cu128",
    "jazzy-desktop-full-cuda-cu130",
    "jazzy-desktop-full-cuda-cu121",
    "jazzy-desktop-full-torch-cu128",
    "jazzy-desktop-full-torch-cu130",
    "jazzy-desktop-full-torch-cpu",
    "jazzy-desktop-full-tensorflow-cu128",
    "jazzy-desktop-full-tensorflow-cpu",
    "jazzy-desktop-full-ml-cu128",
    "jazzy-desktop-full-ml-cpu",
    "kilted-desktop-full",
    "kilted-desktop-full-cuda-cu128",
    "kilted-desktop-full-cuda-cu130",
    "kilted-desktop-full-cuda-cu121",
    "kilted-desktop-full-torch-cu128",
    "kilted-desktop-full-torch-cu130",
    "kilted-desktop-full-torch-cpu",
    "kilted-desktop-full-tensorflow-cu128",
    "kilted-desktop-full-tensorflow-cpu",
    "kilted-desktop-full-ml-cu128",
    "kilted-desktop-full-ml-cpu",
    "lyrical-desktop-full",
    "lyrical-desktop-full-cuda-cu128",
    "lyrical-desktop-full-cuda-cu130",
    "lyrical-desktop-full-cuda-cu121",
    "lyrical-desktop-full-torch-cu128",
    "lyrical-desktop-full-torch-cu130",
    "rolling-desktop-full",
    "rolling-desktop-full-cuda-cu128",
    "rolling-desktop-full-cuda-cu130",
    "rolling-desktop-full-cuda-cu121",
    "rolling-desktop-full-torch-cu128",
    "rolling-desktop-full-torch-cu130",
    "bookworm-desktop-full",
    "bookworm-desktop-full-cuda-cu128",
    "bookworm-desktop-full-cuda-cu130",
    "bookworm-desktop-full-cuda-cu121",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-desktop-full-torch-cu130",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cpu",
    "bookworm-desktop-full-ml-cu128",
    "trixie-desktop-full",
    "trixie-desktop-full-cuda-cu128",
    "trixie-desktop-full-cuda-cu130",
    "trixie-desktop-full-cuda-cu121",
    "trixie-desktop-full-torch-cu128",
    "trixie-desktop-full-torch-cu130",
    "trixie-desktop-full-torch-cpu",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cpu",
    "trixie-desktop-full-ml-cu128",
    "trixie-desktop-full-ml-cpu",
  ]
}

group "none" {
  targets = [
    "noetic-core",
    "noetic-base",
    "noetic-robot",
    "noetic-perception",
    "noetic-desktop",
    "noetic-desktop-full",
    "foxy-core",
    "foxy-base",
    "foxy-desktop",
    "humble-core",
    "humble-base",
    "humble-perception",
    "humble-desktop",
    "humble-desktop-full",
    "iron-core",
    "iron-base",
    "iron-perception",
    "iron-desktop",
    "iron-desktop-full",
    "jazzy-core",
    "jazzy-base",
    "jazzy-perception",
    "jazzy-desktop",
    "jazzy-desktop-full",
    "kilted-core",
    "kilted-base",
    "kilted-perception",
    "kilted-desktop",
    "kilted-desktop-full",
    "lyrical-core",
    "lyrical-base",
    "lyrical-perception",
    "lyrical-desktop",
    "lyrical-desktop-full",
    "rolling-core",
    "rolling-base",
    "rolling-perception",
    "rolling-desktop",
    "rolling-desktop-full",
    "bookworm-core",
    "bookworm-base",
    "bookworm-robot",
    "bookworm-perception",
    "bookworm-desktop",
    "bookworm-desktop-full",
    "trixie-core",
    "trixie-base",
    "trixie-robot",
    "trixie-perception",
    "trixie-desktop",
    "trixie-desktop-full",
    "jazzy-wheels-core",
  ]
}

group "cuda" {
  targets = [
    "noetic-core-cuda-cu128",
    "noetic-base-cuda-cu128",
    "noetic-robot-cuda-cu128",
    "noetic-perception-cuda-cu128",
    "noetic-desktop-cuda-cu128",
    "noetic-desktop-full-cuda-cu128",
    "noetic-core-cuda-cu130",
    "noetic-base-cuda-cu130",
    "noetic-robot-cuda-cu130",
    "noetic-perception-cuda-cu130",
    "noetic-desktop-cuda-cu130",
    "noetic-desktop-full-cuda-cu130",
    "noetic-core-cuda-cu121",
    "noetic-base-cuda-cu121",
    "noetic-robot-cuda-cu121",
    "noetic-perception-cuda-cu121",
    "noetic-desktop-cuda-cu121",
    "noetic-desktop-full-cuda-cu121",
    "foxy-core-cuda-cu128",
    "foxy-base-cuda-cu128",
    "foxy-desktop-cuda-cu128",
    "foxy-core-cuda-cu130",
    "foxy-base-cuda-cu130",
    "foxy-desktop-cuda-cu130",
    "foxy-core-cuda-cu121",
    "foxy-base-cuda-cu121",
    "foxy-desktop-cuda-cu121",
    "humble-core-cuda-cu128",
    "humble-base-cuda-cu128",
    "humble-perception-cuda-cu128",
    "humble-desktop-cuda-cu128",
    "humble-desktop-full-cuda-cu128",
    "humble-core-cuda-cu130",
    "humble-base-cuda-cu130",
    "humble-perception-cuda-cu130",
    "humble-desktop-cuda-cu130",
    "humble-desktop-full-cuda-cu130",
    "humble-core-cuda-cu121",
    "humble-base-cuda-cu121",
    "humble-perception-cuda-cu121",
    "humble-desktop-cuda-cu121",
    "humble-desktop-full-cuda-cu121",
    "iron-core-cuda-cu128",
    "iron-base-cuda-cu128",
    "iron-perception-cuda-cu128",
    "iron-desktop-cuda-cu128",
    "iron-desktop-full-cuda-cu128",
    "iron-core-cuda-cu130",
    "iron-base-cuda-cu130",
    "iron-perception-cuda-cu130",
    "iron-desktop-cuda-cu130",
    "iron-desktop-full-cuda-cu130",
    "iron-core-cuda-cu121",
    "iron-base-cuda-cu121",
    "iron-perception-cuda-cu121",
    "iron-desktop-cuda-cu121",
    "iron-desktop-full-cuda-cu121",
    "jazzy-core-cuda-cu128",
    "jazzy-base-cuda-cu128",
    "jazzy-perception-cuda-cu128",
    "jazzy-desktop-cuda-cu128",
    "jazzy-desktop-full-cuda-cu128",
    "jazzy-core-cuda-cu130",
    "jazzy-base-cuda-cu130",
    "jazzy-perception-cuda-cu130",
    "jazzy-desktop-cuda-cu130",
    "jazzy-desktop-full-cuda-cu130",
    "jazzy-core-cuda-cu121",
    "jazzy-base-cuda-cu121",
    "jazzy-perception-cuda-cu121",
    "jazzy-desktop-cuda-cu121",
    "jazzy-desktop-full-cuda-cu121",
    "kilted-core-cuda-cu128",
    "kilted-base-cuda-cu128",
    "kilted-perception-cuda-cu128",
    "kilted-desktop-cuda-cu128",
    "kilted-desktop-full-cuda-cu128",
    "kilted-core-cuda-cu130",
    "kilted-base-cuda-cu130",
    "kilted-perception-cuda-cu130",
    "kilted-desktop-cuda-cu130",
    "kilted-desktop-full-cuda-cu130",
    "kilted-core-cuda-cu121",
    "kilted-base-cuda-cu121",
    "kilted-perception-cuda-cu121",
    "kilted-desktop-cuda-cu121",
    "kilted-desktop-full-cuda-cu121",
    "lyrical-core-cuda-cu128",
    "lyrical-base-cuda-cu128",
    "lyrical-perception-cuda-cu128",
    "lyrical-desktop-cuda-cu128",
    "lyrical-desktop-full-cuda-cu128",
    "lyrical-core-cuda-cu130",
    "lyrical-base-cuda-cu130",
    "lyrical-perception-cuda-cu130",
    "lyrical-desktop-cuda-cu130",
    "lyrical-desktop-full-cuda-cu130",
    "lyrical-core-cuda-cu121",
    "lyrical-base-cuda-cu121",
    "lyrical-perception-cuda-cu121",
    "lyrical-desktop-cuda-cu121",
    "lyrical-desktop-full-cuda-cu121",
    "rolling-core-cuda-cu128",
    "rolling-base-cuda-cu128",
    "rolling-perception-cuda-cu128",
    "rolling-desktop-cuda-cu128",
    "rolling-desktop-full-cuda-cu128",
    "rolling-core-cuda-cu130",
    "rolling-base-cuda-cu130",
    "rolling-perception-cuda-cu130",
    "rolling-desktop-cuda-cu130",
    "rolling-desktop-full-cuda-cu130",
    "rolling-core-cuda-cu121",
    "rolling-base-cuda-cu121",
    "rolling-perception-cuda-cu121",
    "rolling-desktop-cuda-cu121",
    "rolling-desktop-full-cuda-cu121",
    "bookworm-core-cuda-cu128",
    "bookworm-base-cuda-cu128",
    "bookworm-robot-cuda-cu128",
    "bookworm-perception-cuda-cu128",
    "bookworm-desktop-cuda-cu128",
    "bookworm-desktop-full-cuda-cu128",
    "bookworm-core-cuda-cu130",
    "bookworm-base-cuda-cu130",
    "bookworm-robot-cuda-cu130",
    "bookworm-perception-cuda-cu130",
    "bookworm-desktop-cuda-cu130",
    "bookworm-desktop-full-cuda-cu130",
    "bookworm-core-cuda-cu121",
    "bookworm-base-cuda-cu121",
    "bookworm-robot-cuda-cu121",
    "bookworm-perception-cuda-cu121",
    "bookworm-desktop-cuda-cu121",
    "bookworm-desktop-full-cuda-cu121",
    "trixie-core-cuda-cu128",
    "trixie-base-cuda-cu128",
    "trixie-robot-cuda-cu128",
    "trixie-perception-cuda-cu128",
    "trixie-desktop-cuda-cu128",
    "trixie-desktop-full-cuda-cu128",
    "trixie-core-cuda-cu130",
    "trixie-base-cuda-cu130",
    "trixie-robot-cuda-cu130",
    "trixie-perception-cuda-cu130",
    "trixie-desktop-cuda-cu130",
    "trixie-desktop-full-cuda-cu130",
    "trixie-core-cuda-cu121",
    "trixie-base-cuda-cu121",
    "trixie-robot-cuda-cu121",
    "trixie-perception-cuda-cu121",
    "trixie-desktop-cuda-cu121",
    "trixie-desktop-full-cuda-cu121",
    "jazzy-wheels-core-cuda-cu128",
    "jazzy-wheels-core-cuda-cu130",
    "jazzy-wheels-core-cuda-cu121",
  ]
}

group "torch" {
  targets = [
    "noetic-core-torch-cu121",
    "noetic-base-torch-cu121",
    "noetic-robot-torch-cu121",
    "noetic-perception-torch-cu121",
    "noetic-desktop-torch-cu121",
    "noetic-desktop-full-torch-cu121",
    "foxy-core-torch-cu121",
    "foxy-base-torch-cu121",
    "foxy-desktop-torch-cu121",
    "humble-core-torch-cu128",
    "humble-base-torch-cu128",
    "humble-perception-torch-cu128",
    "humble-desktop-torch-cu128",
    "humble-desktop-full-torch-cu128",
    "humble-core-torch-cu130",
    "humble-base-torch-cu130",
    "humble-perception-torch-cu130",
    "humble-desktop-torch-cu130",
    "humble-desktop-full-torch-cu130",
    "humble-core-torch-cpu",
    "humble-base-torch-cpu",
    "humble-perception-torch-cpu",
    "humble-desktop-torch-cpu",
    "humble-desktop-full-torch-cpu",
    "iron-core-torch-cu128",
    "iron-base-torch-cu128",
    "iron-perception-torch-cu128",
    "iron-desktop-torch-cu128",
    "iron-desktop-full-torch-cu128",
    "iron-core-torch-cu130",
    "iron-base-torch-cu130",
    "iron-perception-torch-cu130",
    "iron-desktop-torch-cu130",
    "iron-desktop-full-torch-cu130",
    "iron-core-torch-cpu",
    "iron-base-torch-cpu",
    "iron-perception-torch-cpu",
    "iron-desktop-torch-cpu",
    "iron-desktop-full-torch-cpu",
    "jazzy-core-torch-cu128",
    "jazzy-base-torch-cu128",
    "jazzy-perception-torch-cu128",
    "jazzy-desktop-torch-cu128",
    "jazzy-desktop-full-torch-cu128",
    "jazzy-core-torch-cu130",
    "jazzy-base-torch-cu130",
    "jazzy-perception-torch-cu130",
    "jazzy-desktop-torch-cu130",
    "jazzy-desktop-full-torch-cu130",
    "jazzy-core-torch-cpu",
    "jazzy-base-torch-cpu",
    "jazzy-perception-torch-cpu",
    "jazzy-desktop-torch-cpu",
    "jazzy-desktop-full-torch-cpu",
    "kilted-core-torch-cu128",
    "kilted-base-torch-cu128",
    "kilted-perception-torch-cu128",
    "kilted-desktop-torch-cu128",
    "kilted-desktop-full-torch-cu128",
    "kilted-core-torch-cu130",
    "kilted-base-torch-cu130",
    "kilted-perception-torch-cu130",
    "kilted-desktop-torch-cu130",
    "kilted-desktop-full-torch-cu130",
    "kilted-core-torch-cpu",
    "kilted-base-torch-cpu",
    "kilted-perception-torch-cpu",
    "kilted-desktop-torch-cpu",
    "kilted-desktop-full-torch-cpu",
    "lyrical-core-torch-cu128",
    "lyrical-base-torch-cu128",
    "lyrical-perception-torch-cu128",
    "lyrical-desktop-torch-cu128",
    "lyrical-desktop-full-torch-cu128",
    "lyrical-core-torch-cu130",
    "lyrical-base-torch-cu130",
    "lyrical-perception-torch-cu130",
    "lyrical-desktop-torch-cu130",
    "lyrical-desktop-full-torch-cu130",
    "rolling-core-torch-cu128",
    "rolling-base-torch-cu128",
    "rolling-perception-torch-cu128",
    "rolling-desktop-torch-cu128",
    "rolling-desktop-full-torch-cu128",
    "rolling-core-torch-cu130",
    "rolling-base-torch-cu130",
    "rolling-perception-torch-cu130",
    "rolling-desktop-torch-cu130",
    "rolling-desktop-full-torch-cu130",
    "bookworm-core-torch-cu128",
    "bookworm-base-torch-cu128",
    "bookworm-robot-torch-cu128",
    "bookworm-perception-torch-cu128",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-core-torch-cu130",
    "bookworm-base-torch-cu130",
    "bookworm-robot-torch-cu130",
    "bookworm-perception-torch-cu130",
    "bookworm-desktop-torch-cu130",
    "bookworm-desktop-full-torch-cu130",
    "trixie-core-torch-cu128",
    "trixie-base-torch-cu128",
    "trixie-robot-torch-cu128",
    "trixie-perception-torch-cu128",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-full-torch-cu128",
    "trixie-core-torch-cu130",
    "trixie-base-torch-cu130",
    "trixie-robot-torch-cu130",
    "trixie-perception-torch-cu130",
    "trixie-desktop-torch-cu130",
    "trixie-desktop-full-torch-cu130",
    "trixie-core-torch-cpu",
    "trixie-base-torch-cpu",
    "trixie-robot-torch-cpu",
    "trixie-perception-torch-cpu",
    "trixie-desktop-torch-cpu",
    "trixie-desktop-full-torch-cpu",
    "jazzy-wheels-core-torch-cu128",
    "jazzy-wheels-core-torch-cu130",
  ]
}

group "tensorflow" {
  targets = [
    "noetic-core-tensorflow-cpu38",
    "noetic-base-tensorflow-cpu38",
    "noetic-robot-tensorflow-cpu38",
    "noetic-perception-tensorflow-cpu38",
    "noetic-desktop-tensorflow-cpu38",
    "noetic-desktop-full-tensorflow-cpu38",
    "foxy-core-tensorflow-cpu38",
    "foxy-base-tensorflow-cpu38",
    "foxy-desktop-tensorflow-cpu38",
    "humble-core-tensorflow-cu128",
    "humble-base-tensorflow-cu128",
    "humble-perception-tensorflow-cu128",
    "humble-desktop-tensorflow-cu128",
    "humble-desktop-full-tensorflow-cu128",
    "humble-core-tensorflow-cpu",
    "humble-base-tensorflow-cpu",
    "humble-perception-tensorflow-cpu",
    "humble-desktop-tensorflow-cpu",
    "humble-desktop-full-tensorflow-cpu",
    "iron-core-tensorflow-cu128",
    "iron-base-tensorflow-cu128",
    "iron-perception-tensorflow-cu128",
    "iron-desktop-tensorflow-cu128",
    "iron-desktop-full-tensorflow-cu128",
    "iron-core-tensorflow-cpu",
    "iron-base-tensorflow-cpu",
    "iron-perception-tensorflow-cpu",
    "iron-desktop-tensorflow-cpu",
    "iron-desktop-full-tensorflow-cpu",
    "jazzy-core-tensorflow-cu128",
    "jazzy-base-tensorflow-cu128",
    "jazzy-perception-tensorflow-cu128",
    "jazzy-desktop-tensorflow-cu128",
    "jazzy-desktop-full-tensorflow-cu128",
    "jazzy-core-tensorflow-cpu",
    "jazzy-base-tensorflow-cpu",
    "jazzy-perception-tensorflow-cpu",
    "jazzy-desktop-tensorflow-cpu",
    "jazzy-desktop-full-tensorflow-cpu",
    "kilted-core-tensorflow-cu128",
    "kilted-base-tensorflow-cu128",
    "kilted-perception-tensorflow-cu128",
    "kilted-desktop-tensorflow-cu128",
    "kilted-desktop-full-tensorflow-cu128",
    "kilted-core-tensorflow-cpu",
    "kilted-base-tensorflow-cpu",
    "kilted-perception-tensorflow-cpu",
    "kilted-desktop-tensorflow-cpu",
    "kilted-desktop-full-tensorflow-cpu",
    "bookworm-core-tensorflow-cu128",
    "bookworm-base-tensorflow-cu128",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-core-tensorflow-cpu",
    "bookworm-base-tensorflow-cpu",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-full-tensorflow-cpu",
    "trixie-core-tensorflow-cu128",
    "trixie-base-tensorflow-cu128",
    "trixie-robot-tensorflow-cu128",
    "trixie-perception-tensorflow-cu128",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-core-tensorflow-cpu",
    "trixie-base-tensorflow-cpu",
    "trixie-robot-tensorflow-cpu",
    "trixie-perception-tensorflow-cpu",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-full-tensorflow-cpu",
    "jazzy-wheels-core-tensorflow-cu128",
    "jazzy-wheels-core-tensorflow-cpu",
  ]
}

group "ml" {
  targets = [
    "humble-core-ml-cu128",
    "humble-base-ml-cu128",
    "humble-perception-ml-cu128",
    "humble-desktop-ml-cu128",
    "humble-desktop-full-ml-cu128",
    "humble-core-ml-cpu",
    "humble-base-ml-cpu",
    "humble-perception-ml-cpu",
    "humble-desktop-ml-cpu",
    "humble-desktop-full-ml-cpu",
    "iron-core-ml-cu128",
    "iron-base-ml-cu128",
    "iron-perception-ml-cu128",
    "iron-desktop-ml-cu128",
    "iron-desktop-full-ml-cu128",
    "iron-core-ml-cpu",
    "iron-base-ml-cpu",
    "iron-perception-ml-cpu",
    "iron-desktop-ml-cpu",
    "iron-desktop-full-ml-cpu",
    "jazzy-core-ml-cu128",
    "jazzy-base-ml-cu128",
    "jazzy-perception-ml-cu128",
    "jazzy-desktop-ml-cu128",
    "jazzy-desktop-full-ml-cu128",
    "jazzy-core-ml-cpu",
    "jazzy-base-ml-cpu",
    "jazzy-perception-ml-cpu",
    "jazzy-desktop-ml-cpu",
    "jazzy-desktop-full-ml-cpu",
    "kilted-core-ml-cu128",
    "kilted-base-ml-cu128",
    "kilted-perception-ml-cu128",
    "kilted-desktop-ml-cu128",
    "kilted-desktop-full-ml-cu128",
    "kilted-core-ml-cpu",
    "kilted-base-ml-cpu",
    "kilted-perception-ml-cpu",
    "kilted-desktop-ml-cpu",
    "kilted-desktop-full-ml-cpu",
    "bookworm-core-ml-cu128",
    "bookworm-base-ml-cu128",
    "bookworm-robot-ml-cu128",
    "bookworm-perception-ml-cu128",
    "bookworm-desktop-ml-cu128",
    "bookworm-desktop-full-ml-cu128",
    "trixie-core-ml-cu128",
    "trixie-base-ml-cu128",
    "trixie-robot-ml-cu128",
    "trixie-perception-ml-cu128",
    "trixie-desktop-ml-cu128",
    "trixie-desktop-full-ml-cu128",
    "trixie-core-ml-cpu",
    "trixie-base-ml-cpu",
    "trixie-robot-ml-cpu",
    "trixie-perception-ml-cpu",
    "trixie-desktop-ml-cpu",
    "trixie-desktop-full-ml-cpu",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "cu128" {
  targets = [
    "noetic-core-cuda-cu128",
    "noetic-base-cuda-cu128",
    "noetic-robot-cuda-cu128",
    "noetic-perception-cuda-cu128",
    "noetic-desktop-cuda-cu128",
    "noetic-desktop-full-cuda-cu128",
    "foxy-core-cuda-cu128",
    "foxy-base-cuda-cu128",
    "foxy-desktop-cuda-cu128",
    "humble-core-cuda-cu128",
    "humble-base-cuda-cu128",
    "humble-perception-cuda-cu128",
    "humble-desktop-cuda-cu128",
    "humble-desktop-full-cuda-cu128",
    "humble-core-torch-cu128",
    "humble-base-torch-cu128",
    "humble-perception-torch-cu128",
    "humble-desktop-torch-cu128",
    "humble-desktop-full-torch-cu128",
    "humble-core-tensorflow-cu128",
    "humble-base-tensorflow-cu128",
    "humble-perception-tensorflow-cu128",
    "humble-desktop-tensorflow-cu128",
    "humble-desktop-full-tensorflow-cu128",
    "humble-core-ml-cu128",
    "humble-base-ml-cu128",
    "humble-perception-ml-cu128",
    "humble-desktop-ml-cu128",
    "humble-desktop-full-ml-cu128",
    "iron-core-cuda-cu128",
    "iron-base-cuda-cu128",
    "iron-perception-cuda-cu128",
    "iron-desktop-cuda-cu128",
    "iron-desktop-full-cuda-cu128",
    "iron-core-torch-cu128",
    "iron-base-torch-cu128",
    "iron-perception-torch-cu128",
    "iron-desktop-torch-cu128",
    "iron-desktop-full-torch-cu128",
    "iron-core-tensorflow-cu128",
    "iron-base-tensorflow-cu128",
    "iron-perception-tensorflow-cu128",
    "iron-desktop-tensorflow-cu128",
    "iron-desktop-full-tensorflow-cu128",
    "iron-core-ml-cu128",
    "iron-base-ml-cu128",
    "iron-perception-ml-cu128",
    "iron-desktop-ml-cu128",
    "iron-desktop-full-ml-cu128",
    "jazzy-core-cuda-cu128",
    "jazzy-base-cuda-cu128",
    "jazzy-perception-cuda-cu128",
    "jazzy-desktop-cuda-cu128",
    "jazzy-desktop-full-cuda-cu128",
    "jazzy-core-torch-cu128",
    "jazzy-base-torch-cu128",
    "jazzy-perception-torch-cu128",
    "jazzy-desktop-torch-cu128",
    "jazzy-desktop-full-torch-cu128",
    "jazzy-core-tensorflow-cu128",
    "jazzy-base-tensorflow-cu128",
    "jazzy-perception-tensorflow-cu128",
    "jazzy-desktop-tensorflow-cu128",
    "jazzy-desktop-full-tensorflow-cu128",
    "jazzy-core-ml-cu128",
    "jazzy-base-ml-cu128",
    "jazzy-perception-ml-cu128",
    "jazzy-desktop-ml-cu128",
    "jazzy-desktop-full-ml-cu128",
    "kilted-core-cuda-cu128",
    "kilted-base-cuda-cu128",
    "kilted-perception-cuda-cu128",
    "kilted-desktop-cuda-cu128",
    "kilted-desktop-full-cuda-cu128",
    "kilted-core-torch-cu128",
    "kilted-base-torch-cu128",
    "kilted-perception-torch-cu128",
    "kilted-desktop-torch-cu128",
    "kilted-desktop-full-torch-cu128",
    "kilted-core-tensorflow-cu128",
    "kilted-base-tensorflow-cu128",
    "kilted-perception-tensorflow-cu128",
    "kilted-desktop-tensorflow-cu128",
    "kilted-desktop-full-tensorflow-cu128",
    "kilted-core-ml-cu128",
    "kilted-base-ml-cu128",
    "kilted-perception-ml-cu128",
    "kilted-desktop-ml-cu128",
    "kilted-desktop-full-ml-cu128",
    "lyrical-core-cuda-cu128",
    "lyrical-base-cuda-cu128",
    "lyrical-perception-cuda-cu128",
    "lyrical-desktop-cuda-cu128",
    "lyrical-desktop-full-cuda-cu128",
    "lyrical-core-torch-cu128",
    "lyrical-base-torch-cu128",
    "lyrical-perception-torch-cu128",
    "lyrical-desktop-torch-cu128",
    "lyrical-desktop-full-torch-cu128",
    "rolling-core-cuda-cu128",
    "rolling-base-cuda-cu128",
    "rolling-perception-cuda-cu128",
    "rolling-desktop-cuda-cu128",
    "rolling-desktop-full-cuda-cu128",
    "rolling-core-torch-cu128",
    "rolling-base-torch-cu128",
    "rolling-perception-torch-cu128",
    "rolling-desktop-torch-cu128",
    "rolling-desktop-full-torch-cu128",
    "bookworm-core-cuda-cu128",
    "bookworm-base-cuda-cu128",
    "bookworm-robot-cuda-cu128",
    "bookworm-perception-cuda-cu128",
    "bookworm-desktop-cuda-cu128",
    "bookworm-desktop-full-cuda-cu128",
    "bookworm-core-torch-cu128",
    "bookworm-base-torch-cu128",
    "bookworm-robot-torch-cu128",
    "bookworm-perception-torch-cu128",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-core-tensorflow-cu128",
    "bookworm-base-tensorflow-cu128",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-core-ml-cu128",
    "bookworm-base-ml-cu128",
    "bookworm-robot-ml-cu128",
    "bookworm-perception-ml-cu128",
    "bookworm-desktop-ml-cu128",
    "bookworm-desktop-full-ml-cu128",
    "trixie-core-cuda-cu128",
    "trixie-base-cuda-cu128",
    "trixie-robot-cuda-cu128",
    "trixie-perception-cuda-cu128",
    "trixie-desktop-cuda-cu128",
    "trixie-desktop-full-cuda-cu128",
    "trixie-core-torch-cu128",
    "trixie-base-torch-cu128",
    "trixie-robot-torch-cu128",
    "trixie-perception-torch-cu128",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-full-torch-cu128",
    "trixie-core-tensorflow-cu128",
    "trixie-base-tensorflow-cu128",
    "trixie-robot-tensorflow-cu128",
    "trixie-perception-tensorflow-cu128",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-core-ml-cu128",
    "trixie-base-ml-cu128",
    "trixie-robot-ml-cu128",
    "trixie-perception-ml-cu128",
    "trixie-desktop-ml-cu128",
    "trixie-desktop-full-ml-cu128",
    "jazzy-wheels-core-cuda-cu128",
    "jazzy-wheels-core-torch-cu128",
    "jazzy-wheels-core-tensorflow-cu128",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "cu130" {
  targets = [
    "noetic-core-cuda-cu130",
    "noetic-base-cuda-cu130",
    "noetic-robot-cuda-cu130",
    "noetic-perception-cuda-cu130",
    "noetic-desktop-cuda-cu130",
    "noetic-desktop-full-cuda-cu130",
    "foxy-core-cuda-cu130",
    "foxy-base-cuda-cu130",
    "foxy-desktop-cuda-cu130",
    "humble-core-cuda-cu130",
    "humble-base-cuda-cu130",
    "humble-perception-cuda-cu130",
    "humble-desktop-cuda-cu130",
    "humble-desktop-full-cuda-cu130",
    "humble-core-torch-cu130",
    "humble-base-torch-cu130",
    "humble-perception-torch-cu130",
    "humble-desktop-torch-cu130",
    "humble-desktop-full-torch-cu130",
    "iron-core-cuda-cu130",
    "iron-base-cuda-cu130",
    "iron-perception-cuda-cu130",
    "iron-desktop-cuda-cu130",
    "iron-desktop-full-cuda-cu130",
    "iron-core-torch-cu130",
    "iron-base-torch-cu130",
    "iron-perception-torch-cu130",
    "iron-desktop-torch-cu130",
    "iron-desktop-full-torch-cu130",
    "jazzy-core-cuda-cu130",
    "jazzy-base-cuda-cu130",
    "jazzy-perception-cuda-cu130",
    "jazzy-desktop-cuda-cu130",
    "jazzy-desktop-full-cuda-cu130",
    "jazzy-core-torch-cu130",
    "jazzy-base-torch-cu130",
    "jazzy-perception-torch-cu130",
    "jazzy-desktop-torch-cu130",
    "jazzy-desktop-full-torch-cu130",
    "kilted-core-cuda-cu130",
    "kilted-base-cuda-cu130",
    "kilted-perception-cuda-cu130",
    "kilted-desktop-cuda-cu130",
    "kilted-desktop-full-cuda-cu130",
    "kilted-core-torch-cu130",
    "kilted-base-torch-cu130",
    "kilted-perception-torch-cu130",
    "kilted-desktop-torch-cu130",
    "kilted-desktop-full-torch-cu130",
    "lyrical-core-cuda-cu130",
    "lyrical-base-cuda-cu130",
    "lyrical-perception-cuda-cu130",
    "lyrical-desktop-cuda-cu130",
    "lyrical-desktop-full-cuda-cu130",
    "lyrical-core-torch-cu130",
    "lyrical-base-torch-cu130",
    "lyrical-perception-torch-cu130",
    "lyrical-desktop-torch-cu130",
    "lyrical-desktop-full-torch-cu130",
    "rolling-core-cuda-cu130",
    "rolling-base-cuda-cu130",
    "rolling-perception-cuda-cu130",
    "rolling-desktop-cuda-cu130",
    "rolling-desktop-full-cuda-cu130",
    "rolling-core-torch-cu130",
    "rolling-base-torch-cu130",
    "rolling-perception-torch-cu130",
    "rolling-desktop-torch-cu130",
    "rolling-desktop-full-torch-cu130",
    "bookworm-core-cuda-cu130",
    "bookworm-base-cuda-cu130",
    "bookworm-robot-cuda-cu130",
    "bookworm-perception-cuda-cu130",
    "bookworm-desktop-cuda-cu130",
    "bookworm-desktop-full-cuda-cu130",
    "bookworm-core-torch-cu130",
    "bookworm-base-torch-cu130",
    "bookworm-robot-torch-cu130",
    "bookworm-perception-torch-cu130",
    "bookworm-desktop-torch-cu130",
    "bookworm-desktop-full-torch-cu130",
    "trixie-core-cuda-cu130",
    "trixie-base-cuda-cu130",
    "trixie-robot-cuda-cu130",
    "trixie-perception-cuda-cu130",
    "trixie-desktop-cuda-cu130",
    "trixie-desktop-full-cuda-cu130",
    "trixie-core-torch-cu130",
    "trixie-base-torch-cu130",
    "trixie-robot-torch-cu130",
    "trixie-perception-torch-cu130",
    "trixie-desktop-torch-cu130",
    "trixie-desktop-full-torch-cu130",
    "jazzy-wheels-core-cuda-cu130",
    "jazzy-wheels-core-torch-cu130",
  ]
}

group "cu121" {
  targets = [
    "noetic-core-cuda-cu121",
    "noetic-base-cuda-cu121",
    "noetic-robot-cuda-cu121",
    "noetic-perception-cuda-cu121",
    "noetic-desktop-cuda-cu121",
    "noetic-desktop-full-cuda-cu121",
    "noetic-core-torch-cu121",
    "noetic-base-torch-cu121",
    "noetic-robot-torch-cu121",
    "noetic-perception-torch-cu121",
    "noetic-desktop-torch-cu121",
    "noetic-desktop-full-torch-cu121",
    "foxy-core-cuda-cu121",
    "foxy-base-cuda-cu121",
    "foxy-desktop-cuda-cu121",
    "foxy-core-torch-cu121",
    "foxy-base-torch-cu121",
    "foxy-desktop-torch-cu121",
    "humble-core-cuda-cu121",
    "humble-base-cuda-cu121",
    "humble-perception-cuda-cu121",
    "humble-desktop-cuda-cu121",
    "humble-desktop-full-cuda-cu121",
    "iron-core-cuda-cu121",
    "iron-base-cuda-cu121",
    "iron-perception-cuda-cu121",
    "iron-desktop-cuda-cu121",
    "iron-desktop-full-cuda-cu121",
    "jazzy-core-cuda-cu121",
    "jazzy-base-cuda-cu121",
    "jazzy-perception-cuda-cu121",
    "jazzy-desktop-cuda-cu121",
    "jazzy-desktop-full-cuda-cu121",
    "kilted-core-cuda-cu121",
    "kilted-base-cuda-cu121",
    "kilted-perception-cuda-cu121",
    "kilted-desktop-cuda-cu121",
    "kilted-desktop-full-cuda-cu121",
    "lyrical-core-cuda-cu121",
    "lyrical-base-cuda-cu121",
    "lyrical-perception-cuda-cu121",
    "lyrical-desktop-cuda-cu121",
    "lyrical-desktop-full-cuda-cu121",
    "rolling-core-cuda-cu121",
    "rolling-base-cuda-cu121",
    "rolling-perception-cuda-cu121",
    "rolling-desktop-cuda-cu121",
    "rolling-desktop-full-cuda-cu121",
    "bookworm-core-cuda-cu121",
    "bookworm-base-cuda-cu121",
    "bookworm-robot-cuda-cu121",
    "bookworm-perception-cuda-cu121",
    "bookworm-desktop-cuda-cu121",
    "bookworm-desktop-full-cuda-cu121",
    "trixie-core-cuda-cu121",
    "trixie-base-cuda-cu121",
    "trixie-robot-cuda-cu121",
    "trixie-perception-cuda-cu121",
    "trixie-desktop-cuda-cu121",
    "trixie-desktop-full-cuda-cu121",
    "jazzy-wheels-core-cuda-cu121",
  ]
}

group "cpu" {
  targets = [
    "humble-core-torch-cpu",
    "humble-base-torch-cpu",
    "humble-perception-torch-cpu",
    "humble-desktop-torch-cpu",
    "humble-desktop-full-torch-cpu",
    "humble-core-tensorflow-cpu",
    "humble-base-tensorflow-cpu",
    "humble-perception-tensorflow-cpu",
    "humble-desktop-tensorflow-cpu",
    "humble-desktop-full-tensorflow-cpu",
    "humble-core-ml-cpu",
    "humble-base-ml-cpu",
    "humble-perception-ml-cpu",
    "humble-desktop-ml-cpu",
    "humble-desktop-full-ml-cpu",
    "iron-core-torch-cpu",
    "iron-base-torch-cpu",
    "iron-perception-torch-cpu",
    "iron-desktop-torch-cpu",
    "iron-desktop-full-torch-cpu",
    "iron-core-tensorflow-cpu",
    "iron-base-tensorflow-cpu",
    "iron-perception-tensorflow-cpu",
    "iron-desktop-tensorflow-cpu",
    "iron-desktop-full-tensorflow-cpu",
    "iron-core-ml-cpu",
    "iron-base-ml-cpu",
    "iron-perception-ml-cpu",
    "iron-desktop-ml-cpu",
    "iron-desktop-full-ml-cpu",
    "jazzy-core-torch-cpu",
    "jazzy-base-torch-cpu",
    "jazzy-perception-torch-cpu",
    "jazzy-desktop-torch-cpu",
    "jazzy-desktop-full-torch-cpu",
    "jazzy-core-tensorflow-cpu",
    "jazzy-base-tensorflow-cpu",
    "jazzy-perception-tensorflow-cpu",
    "jazzy-desktop-tensorflow-cpu",
    "jazzy-desktop-full-tensorflow-cpu",
    "jazzy-core-ml-cpu",
    "jazzy-base-ml-cpu",
    "jazzy-perception-ml-cpu",
    "jazzy-desktop-ml-cpu",
    "jazzy-desktop-full-ml-cpu",
    "kilted-core-torch-cpu",
    "kilted-base-torch-cpu",
    "kilted-perception-torch-cpu",
    "kilted-desktop-torch-cpu",
    "kilted-desktop-full-torch-cpu",
    "kilted-core-tensorflow-cpu",
    "kilted-base-tensorflow-cpu",
    "kilted-perception-tensorflow-cpu",
    "kilted-desktop-tensorflow-cpu",
    "kilted-desktop-full-tensorflow-cpu",
    "kilted-core-ml-cpu",
    "kilted-base-ml-cpu",
    "kilted-perception-ml-cpu",
    "kilted-desktop-ml-cpu",
    "kilted-desktop-full-ml-cpu",
    "bookworm-core-tensorflow-cpu",
    "bookworm-base-tensorflow-cpu",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-full-tensorflow-cpu",
    "trixie-core-torch-cpu",
    "trixie-base-torch-cpu",
    "trixie-robot-torch-cpu",
    "trixie-perception-torch-cpu",
    "trixie-desktop-torch-cpu",
    "trixie-desktop-full-torch-cpu",
    "trixie-core-tensorflow-cpu",
    "trixie-base-tensorflow-cpu",
    "trixie-robot-tensorflow-cpu",
    "trixie-perception-tensorflow-cpu",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-full-tensorflow-cpu",
    "trixie-core-ml-cpu",
    "trixie-base-ml-cpu",
    "trixie-robot-ml-cpu",
    "trixie-perception-ml-cpu",
    "trixie-desktop-ml-cpu",
    "trixie-desktop-full-ml-cpu",
    "jazzy-wheels-core-tensorflow-cpu",
  ]
}

group "cpu38" {
  targets = [
    "noetic-core-tensorflow-cpu38",
    "noetic-base-tensorflow-cpu38",
    "noetic-robot-tensorflow-cpu38",
    "noetic-perception-tensorflow-cpu38",
    "noetic-desktop-tensorflow-cpu38",
    "noetic-desktop-full-tensorflow-cpu38",
    "foxy-core-tensorflow-cpu38",
    "foxy-base-tensorflow-cpu38",
    "foxy-desktop-tensorflow-cpu38",
  ]
}

group "all" {
  targets = [
    "noetic-core",
    "noetic-base",
    "noetic-robot",
    "noetic-perception",
    "noetic-desktop",
    "noetic-desktop-full",
    "noetic-core-cuda-cu128",
    "noetic-base-cuda-cu128",
    "noetic-robot-cuda-cu128",
    "noetic-perception-cuda-cu128",
    "noetic-desktop-cuda-cu128",
    "noetic-desktop-full-cuda-cu128",
    "noetic-core-cuda-cu130",
    "noetic-base-cuda-cu130",
    "noetic-robot-cuda-cu130",
    "noetic-perception-cuda-cu130",
    "noetic-desktop-cuda-cu130",
    "noetic-desktop-full-cuda-cu130",
    "noetic-core-cuda-cu121",
    "noetic-base-cuda-cu121",
    "noetic-robot-cuda-cu121",
    "noetic-perception-cuda-cu121",
    "noetic-desktop-cuda-cu121",
    "noetic-desktop-full-cuda-cu121",
    "noetic-core-torch-cu121",
    "noetic-base-torch-cu121",
    "noetic-robot-torch-cu121",
    "noetic-perception-torch-cu121",
    "noetic-desktop-torch-cu121",
    "noetic-desktop-full-torch-cu121",
    "noetic-core-tensorflow-cpu38",
    "noetic-base-tensorflow-cpu38",
    "noetic-robot-tensorflow-cpu38",
    "noetic-perception-tensorflow-cpu38",
    "noetic-desktop-tensorflow-cpu38",
    "noetic-desktop-full-tensorflow-cpu38",
    "foxy-core",
    "foxy-base",
    "foxy-desktop",
    "foxy-core-cuda-cu128",
    "foxy-base-cuda-cu128",
    "foxy-desktop-cuda-cu128",
    "foxy-core-cuda-cu130",
    "foxy-base-cuda-cu130",
    "foxy-desktop-cuda-cu130",
    "foxy-core-cuda-cu121",
    "foxy-base-cuda-cu121",
    "foxy-desktop-cuda-cu121",
    "foxy-core-torch-cu121",
    "foxy-base-torch-cu121",
    "foxy-desktop-torch-cu121",
    "foxy-core-tensorflow-cpu38",
    "foxy-base-tensorflow-cpu38",
    "foxy-desktop-tensorflow-cpu38",
    "humble-core",
    "humble-base",
    "humble-perception",
    "humble-desktop",
    "humble-desktop-full",
    "humble-core-cuda-cu128",
    "humble-base-cuda-cu128",
    "humble-perception-cuda-cu128",
    "humble-desktop-cuda-cu128",
    "humble-desktop-full-cuda-cu128",
    "humble-core-cuda-cu130",
    "humble-base-cuda-cu130",
    "humble-perception-cuda-cu130",
    "humble-desktop-cuda-cu130",
    "humble-desktop-full-cuda-cu130",
    "humble-core-cuda-cu121",
    "humble-base-cuda-cu121",
    "humble-perception-cuda-cu121",
    "humble-desktop-cuda-cu121",
    "humble-desktop-full-cuda-cu121",
    "humble-core-torch-cu128",
    "humble-base-torch-cu128",
    "humble-perception-torch-cu128",
    "humble-desktop-torch-cu128",
    "humble-desktop-full-torch-cu128",
    "humble-core-torch-cu130",
    "humble-base-torch-cu130",
    "humble-perception-torch-cu130",
    "humble-desktop-torch-cu130",
    "humble-desktop-full-torch-cu130",
    "humble-core-torch-cpu",
    "humble-base-torch-cpu",
    "humble-perception-torch-cpu",
    "humble-desktop-torch-cpu",
    "humble-desktop-full-torch-cpu",
    "humble-core-tensorflow-cu128",
    "humble-base-tensorflow-cu128",
    "humble-perception-tensorflow-cu128",
    "humble-desktop-tensorflow-cu128",
    "humble-desktop-full-tensorflow-cu128",
    "humble-core-tensorflow-cpu",
    "humble-base-tensorflow-cpu",
    "humble-perception-tensorflow-cpu",
    "humble-desktop-tensorflow-cpu",
    "humble-desktop-full-tensorflow-cpu",
    "humble-core-ml-cu128",
    "humble-base-ml-cu128",
    "humble-perception-ml-cu128",
    "humble-desktop-ml-cu128",
    "humble-desktop-full-ml-cu128",
    "humble-core-ml-cpu",
    "humble-base-ml-cpu",
    "humble-perception-ml-cpu",
    "humble-desktop-ml-cpu",
    "humble-desktop-full-ml-cpu",
    "iron-core",
    "iron-base",
    "iron-perception",
    "iron-desktop",
    "iron-desktop-full",
    "iron-core-cuda-cu128",
    "iron-base-cuda-cu128",
    "iron-perception-cuda-cu128",
    "iron-desktop-cuda-cu128",
    "iron-desktop-full-cuda-cu128",
    "iron-core-cuda-cu130",
    "iron-base-cuda-cu130",
    "iron-perception-cuda-cu130",
    "iron-desktop-cuda-cu130",
    "iron-desktop-full-cuda-cu130",
    "iron-core-cuda-cu121",
    "iron-base-cuda-cu121",
    "iron-perception-cuda-cu121",
    "iron-desktop-cuda-cu121",
    "iron-desktop-full-cuda-cu121",
    "iron-core-torch-cu128",
    "iron-base-torch-cu128",
    "iron-perception-torch-cu128",
    "iron-desktop-torch-cu128",
    "iron-desktop-full-torch-cu128",
    "iron-core-torch-cu130",
    "iron-base-torch-cu130",
    "iron-perception-torch-cu130",
    "iron-desktop-torch-cu130",
    "iron-desktop-full-torch-cu130",
    "iron-core-torch-cpu",
    "iron-base-torch-cpu",
    "iron-perception-torch-cpu",
    "iron-desktop-torch-cpu",
    "iron-desktop-full-torch-cpu",
    "iron-core-tensorflow-cu128",
    "iron-base-tensorflow-cu128",
    "iron-perception-tensorflow-cu128",
    "iron-desktop-tensorflow-cu128",
    "iron-desktop-full-tensorflow-cu128",
    "iron-core-tensorflow-cpu",
    "iron-base-tensorflow-cpu",
    "iron-perception-tensorflow-cpu",
    "iron-desktop-tensorflow-cpu",
    "iron-desktop-full-tensorflow-cpu",
    "iron-core-ml-cu128",
    "iron-base-ml-cu128",
    "iron-perception-ml-cu128",
    "iron-desktop-ml-cu128",
    "iron-desktop-full-ml-cu128",
    "iron-core-ml-cpu",
    "iron-base-ml-cpu",
    "iron-perception-ml-cpu",
    "iron-desktop-ml-cpu",
    "iron-desktop-full-ml-cpu",
    "jazzy-core",
    "jazzy-base",
    "jazzy-perception",
    "jazzy-desktop",
    "jazzy-desktop-full",
    "jazzy-core-cuda-cu128",
    "jazzy-base-cuda-cu128",
    "jazzy-perception-cuda-cu128",
    "jazzy-desktop-cuda-cu128",
    "jazzy-desktop-full-cuda-cu128",
    "jazzy-core-cuda-cu130",
    "jazzy-base-cuda-cu130",
    "jazzy-perception-cuda-cu130",
    "jazzy-desktop-cuda-cu130",
    "jazzy-desktop-full-cuda-cu130",
    "jazzy-core-cuda-cu121",
    "jazzy-base-cuda-cu121",
    "jazzy-perception-cuda-cu121",
    "jazzy-desktop-cuda-cu121",
    "jazzy-desktop-full-cuda-cu121",
    "jazzy-core-torch-cu128",
    "jazzy-base-torch-cu128",
    "jazzy-perception-torch-cu128",
    "jazzy-desktop-torch-cu128",
    "jazzy-desktop-full-torch-cu128",
    "jazzy-core-torch-cu130",
    "jazzy-base-torch-cu130",
    "jazzy-perception-torch-cu130",
    "jazzy-desktop-torch-cu130",
    "jazzy-desktop-full-torch-cu130",
    "jazzy-core-torch-cpu",
    "jazzy-base-torch-cpu",
    "jazzy-perception-torch-cpu",
    "jazzy-desktop-torch-cpu",
    "jazzy-desktop-full-torch-cpu",
    "jazzy-core-tensorflow-cu128",
    "jazzy-base-tensorflow-cu128",
    "jazzy-perception-tensorflow-cu128",
    "jazzy-desktop-tensorflow-cu128",
    "jazzy-desktop-full-tensorflow-cu128",
    "jazzy-core-tensorflow-cpu",
    "jazzy-base-tensorflow-cpu",
    "jazzy-perception-tensorflow-cpu",
    "jazzy-desktop-tensorflow-cpu",
    "jazzy-desktop-full-tensorflow-cpu",
    "jazzy-core-ml-cu128",
    "jazzy-base-ml-cu128",
    "jazzy-perception-ml-cu128",
    "jazzy-desktop-ml-cu128",
    "jazzy-desktop-full-ml-cu128",
    "jazzy-core-ml-cpu",
    "jazzy-base-ml-cpu",
    "jazzy-perception-ml-cpu",
    "jazzy-desktop-ml-cpu",
    "jazzy-desktop-full-ml-cpu",
    "kilted-core",
    "kilted-base",
    "kilted-perception",
    "kilted-desktop",
    "kilted-desktop-full",
    "kilted-core-cuda-cu128",
    "kilted-base-cuda-cu128",
    "kilted-perception-cuda-cu128",
    "kilted-desktop-cuda-cu128",
    "kilted-desktop-full-cuda-cu128",
    "kilted-core-cuda-cu130",
    "kilted-base-cuda-cu130",
    "kilted-perception-cuda-cu130",
    "kilted-desktop-cuda-cu130",
    "kilted-desktop-full-cuda-cu130",
    "kilted-core-cuda-cu121",
    "kilted-base-cuda-cu121",
    "kilted-perception-cuda-cu121",
    "kilted-desktop-cuda-cu121",
    "kilted-desktop-full-cuda-cu121",
    "kilted-core-torch-cu128",
    "kilted-base-torch-cu128",
    "kilted-perception-torch-cu128",
    "kilted-desktop-torch-cu128",
    "kilted-desktop-full-torch-cu128",
    "kilted-core-torch-cu130",
    "kilted-base-torch-cu130",
    "kilted-perception-torch-cu130",
    "kilted-desktop-torch-cu130",
    "kilted-desktop-full-torch-cu130",
    "kilted-core-torch-cpu",
    "kilted-base-torch-cpu",
    "kilted-perception-torch-cpu",
    "kilted-desktop-torch-cpu",
    "kilted-desktop-full-torch-cpu",
    "kilted-core-tensorflow-cu128",
    "kilted-base-tensorflow-cu128",
    "kilted-perception-tensorflow-cu128",
    "kilted-desktop-tensorflow-cu128",
    "kilted-desktop-full-tensorflow-cu128",
    "kilted-core-tensorflow-cpu",
    "kilted-base-tensorflow-cpu",
    "kilted-perception-tensorflow-cpu",
    "kilted-desktop-tensorflow-cpu",
    "kilted-desktop-full-tensorflow-cpu",
    "kilted-core-ml-cu128",
    "kilted-base-ml-cu128",
    "kilted-perception-ml-cu128",
    "kilted-desktop-ml-cu128",
    "kilted-desktop-full-ml-cu128",
    "kilted-core-ml-cpu",
    "kilted-base-ml-cpu",
    "kilted-perception-ml-cpu",
    "kilted-desktop-ml-cpu",
    "kilted-desktop-full-ml-cpu",
    "lyrical-core",
    "lyrical-base",
    "lyrical-perception",
    "lyrical-desktop",
    "lyrical-desktop-full",
    "lyrical-core-cuda-cu128",
    "lyrical-base-cuda-cu128",
    "lyrical-perception-cuda-cu128",
    "lyrical-desktop-cuda-cu128",
    "lyrical-desktop-full-cuda-cu128",
    "lyrical-core-cuda-cu130",
    "lyrical-base-cuda-cu130",
    "lyrical-perception-cuda-cu130",
    "lyrical-desktop-cuda-cu130",
    "lyrical-desktop-full-cuda-cu130",
    "lyrical-core-cuda-cu121",
    "lyrical-base-cuda-cu121",
    "lyrical-perception-cuda-cu121",
    "lyrical-desktop-cuda-cu121",
    "lyrical-desktop-full-cuda-cu121",
    "lyrical-core-torch-cu128",
    "lyrical-base-torch-cu128",
    "lyrical-perception-torch-cu128",
    "lyrical-desktop-torch-cu128",
    "lyrical-desktop-full-torch-cu128",
    "lyrical-core-torch-cu130",
    "lyrical-base-torch-cu130",
    "lyrical-perception-torch-cu130",
    "lyrical-desktop-torch-cu130",
    "lyrical-desktop-full-torch-cu130",
    "rolling-core",
    "rolling-base",
    "rolling-perception",
    "rolling-desktop",
    "rolling-desktop-full",
    "rolling-core-cuda-cu128",
    "rolling-base-cuda-cu128",
    "rolling-perception-cuda-cu128",
    "rolling-desktop-cuda-cu128",
    "rolling-desktop-full-cuda-cu128",
    "rolling-core-cuda-cu130",
    "rolling-base-cuda-cu130",
    "rolling-perception-cuda-cu130",
    "rolling-desktop-cuda-cu130",
    "rolling-desktop-full-cuda-cu130",
    "rolling-core-cuda-cu121",
    "rolling-base-cuda-cu121",
    "rolling-perception-cuda-cu121",
    "rolling-desktop-cuda-cu121",
    "rolling-desktop-full-cuda-cu121",
    "rolling-core-torch-cu128",
    "rolling-base-torch-cu128",
    "rolling-perception-torch-cu128",
    "rolling-desktop-torch-cu128",
    "rolling-desktop-full-torch-cu128",
    "rolling-core-torch-cu130",
    "rolling-base-torch-cu130",
    "rolling-perception-torch-cu130",
    "rolling-desktop-torch-cu130",
    "rolling-desktop-full-torch-cu130",
    "bookworm-core",
    "bookworm-base",
    "bookworm-robot",
    "bookworm-perception",
    "bookworm-desktop",
    "bookworm-desktop-full",
    "bookworm-core-cuda-cu128",
    "bookworm-base-cuda-cu128",
    "bookworm-robot-cuda-cu128",
    "bookworm-perception-cuda-cu128",
    "bookworm-desktop-cuda-cu128",
    "bookworm-desktop-full-cuda-cu128",
    "bookworm-core-cuda-cu130",
    "bookworm-base-cuda-cu130",
    "bookworm-robot-cuda-cu130",
    "bookworm-perception-cuda-cu130",
    "bookworm-desktop-cuda-cu130",
    "bookworm-desktop-full-cuda-cu130",
    "bookworm-core-cuda-cu121",
    "bookworm-base-cuda-cu121",
    "bookworm-robot-cuda-cu121",
    "bookworm-perception-cuda-cu121",
    "bookworm-desktop-cuda-cu121",
    "bookworm-desktop-full-cuda-cu121",
    "bookworm-core-torch-cu128",
    "bookworm-base-torch-cu128",
    "bookworm-robot-torch-cu128",
    "bookworm-perception-torch-cu128",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-core-torch-cu130",
    "bookworm-base-torch-cu130",
    "bookworm-robot-torch-cu130",
    "bookworm-perception-torch-cu130",
    "bookworm-desktop-torch-cu130",
    "bookworm-desktop-full-torch-cu130",
    "bookworm-core-tensorflow-cu128",
    "bookworm-base-tensorflow-cu128",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-core-tensorflow-cpu",
    "bookworm-base-tensorflow-cpu",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-full-tensorflow-cpu",
    "bookworm-core-ml-cu128",
    "bookworm-base-ml-cu128",
    "bookworm-robot-ml-cu128",
    "bookworm-perception-ml-cu128",
    "bookworm-desktop-ml-cu128",
    "bookworm-desktop-full-ml-cu128",
    "trixie-core",
    "trixie-base",
    "trixie-robot",
    "trixie-perception",
    "trixie-desktop",
    "trixie-desktop-full",
    "trixie-core-cuda-cu128",
    "trixie-base-cuda-cu128",
    "trixie-robot-cuda-cu128",
    "trixie-perception-cuda-cu128",
    "trixie-desktop-cuda-cu128",
    "trixie-desktop-full-cuda-cu128",
    "trixie-core-cuda-cu130",
    "trixie-base-cuda-cu130",
    "trixie-robot-cuda-cu130",
    "trixie-perception-cuda-cu130",
    "trixie-desktop-cuda-cu130",
    "trixie-desktop-full-cuda-cu130",
    "trixie-core-cuda-cu121",
    "trixie-base-cuda-cu121",
    "trixie-robot-cuda-cu121",
    "trixie-perception-cuda-cu121",
    "trixie-desktop-cuda-cu121",
    "trixie-desktop-full-cuda-cu121",
    "trixie-core-torch-cu128",
    "trixie-base-torch-cu128",
    "trixie-robot-torch-cu128",
    "trixie-perception-torch-cu128",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-full-torch-cu128",
    "trixie-core-torch-cu130",
    "trixie-base-torch-cu130",
    "trixie-robot-torch-cu130",
    "trixie-perception-torch-cu130",
    "trixie-desktop-torch-cu130",
    "trixie-desktop-full-torch-cu130",
    "trixie-core-torch-cpu",
    "trixie-base-torch-cpu",
    "trixie-robot-torch-cpu",
    "trixie-perception-torch-cpu",
    "trixie-desktop-torch-cpu",
    "trixie-desktop-full-torch-cpu",
    "trixie-core-tensorflow-cu128",
    "trixie-base-tensorflow-cu128",
    "trixie-robot-tensorflow-cu128",
    "trixie-perception-tensorflow-cu128",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-core-tensorflow-cpu",
    "trixie-base-tensorflow-cpu",
    "trixie-robot-tensorflow-cpu",
    "trixie-perception-tensorflow-cpu",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-full-tensorflow-cpu",
    "trixie-core-ml-cu128",
    "trixie-base-ml-cu128",
    "trixie-robot-ml-cu128",
    "trixie-perception-ml-cu128",
    "trixie-desktop-ml-cu128",
    "trixie-desktop-full-ml-cu128",
    "trixie-core-ml-cpu",
    "trixie-base-ml-cpu",
    "trixie-robot-ml-cpu",
    "trixie-perception-ml-cpu",
    "trixie-desktop-ml-cpu",
    "trixie-desktop-full-ml-cpu",
    "jazzy-wheels-core",
    "jazzy-wheels-core-cuda-cu128",
    "jazzy-wheels-core-cuda-cu130",
    "jazzy-wheels-core-cuda-cu121",
    "jazzy-wheels-core-torch-cu128",
    "jazzy-wheels-core-torch-cu130",
    "jazzy-wheels-core-tensorflow-cu128",
    "jazzy-wheels-core-tensorflow-cpu",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "payloads" {
  targets = [
    "payload-cuda-cu128",
    "payload-cuda-cu130",
    "payload-cuda-cu121",
    "payload-common-cu121-py38",
    "payload-torch-cu121-py38",
    "payload-common-cpu38-py38",
    "payload-tensorflow-cc-cpu38",
    "payload-tensorflow-cpu38-py38",
    "payload-common-cu128-py310",
    "payload-torch-cu128-py310",
    "payload-tensorflow-cc-cu128",
    "payload-tensorflow-cu128-py310",
    "payload-common-cu130-py310",
    "payload-torch-cu130-py310",
    "payload-common-cpu-py310",
    "payload-torch-cpu-py310",
    "payload-tensorflow-cc-cpu",
    "payload-tensorflow-cpu-py310",
    "payload-common-cu128-py312",
    "payload-torch-cu128-py312",
    "payload-tensorflow-cu128-py312",
    "payload-common-cu130-py312",
    "payload-torch-cu130-py312",
    "payload-common-cpu-py312",
    "payload-torch-cpu-py312",
    "payload-tensorflow-cpu-py312",
    "payload-common-cu128-py314",
    "payload-torch-cu128-py314",
    "payload-common-cu130-py314",
    "payload-torch-cu130-py314",
    "payload-common-cu128-py311",
    "payload-torch-cu128-py311",
    "payload-tensorflow-cu128-py311",
    "payload-common-cu130-py311",
    "payload-torch-cu130-py311",
    "payload-common-cpu-py311",
    "payload-tensorflow-cpu-py311",
    "payload-common-cu128-py313",
    "payload-torch-cu128-py313",
    "payload-tensorflow-cu128-py313",
    "payload-common-cu130-py313",
    "payload-torch-cu130-py313",
    "payload-common-cpu-py313",
    "payload-torch-cpu-py313",
    "payload-tensorflow-cpu-py313",
  ]
}

group "tests" {
  targets = [
    "noetic-core-test",
    "noetic-base-test",
    "noetic-robot-test",
    "noetic-perception-test",
    "noetic-desktop-test",
    "noetic-desktop-full-test",
    "noetic-core-cuda-cu128-test",
    "noetic-base-cuda-cu128-test",
    "noetic-robot-cuda-cu128-test",
    "noetic-perception-cuda-cu128-test",
    "noetic-desktop-cuda-cu128-test",
    "noetic-desktop-full-cuda-cu128-test",
    "noetic-core-cuda-cu130-test",
    "noetic-base-cuda-cu130-test",
    "noetic-robot-cuda-cu130-test",
    "noetic-perception-cuda-cu130-test",
    "noetic-desktop-cuda-cu130-test",
    "noetic-desktop-full-cuda-cu130-test",
    "noetic-core-cuda-cu121-test",
    "noetic-base-cuda-cu121-test",
    "noetic-robot-cuda-cu121-test",
    "noetic-perception-cuda-cu121-test",
    "noetic-desktop-cuda-cu121-test",
    "noetic-desktop-full-cuda-cu121-test",
    "noetic-core-torch-cu121-test",
    "noetic-base-torch-cu121-test",
    "noetic-robot-torch-cu121-test",
    "noetic-perception-torch-cu121-test",
    "noetic-desktop-torch-cu121-test",
    "noetic-desktop-full-torch-cu121-test",
    "noetic-core-tensorflow-cpu38-test",
    "noetic-base-tensorflow-cpu38-test",
    "noetic-robot-tensorflow-cpu38-test",
    "noetic-perception-tensorflow-cpu38-test",
    "noetic-desktop-tensorflow-cpu38-test",
    "noetic-desktop-full-tensorflow-cpu38-test",
    "foxy-core-test",
    "foxy-base-test",
    "foxy-desktop-test",
    "foxy-core-cuda-cu128-test",
    "foxy-base-cuda-cu128-test",
    "foxy-desktop-cuda-cu128-test",
    "foxy-core-cuda-cu130-test",
    "foxy-base-cuda-cu130-test",
    "foxy-desktop-cuda-cu130-test",
    "foxy-core-cuda-cu121-test",
    "foxy-base-cuda-cu121-test",
    "foxy-desktop-cuda-cu121-test",
    "foxy-core-torch-cu121-test",
    "foxy-base-torch-cu121-test",
    "foxy-desktop-torch-cu121-test",
    "foxy-core-tensorflow-cpu38-test",
    "foxy-base-tensorflow-cpu38-test",
    "foxy-desktop-tensorflow-cpu38-test",
    "humble-core-test",
    "humble-base-test",
    "humble-perception-test",
    "humble-desktop-test",
    "humble-desktop-full-test",
    "humble-core-cuda-cu128-test",
    "humble-base-cuda-cu128-test",
    "humble-perception-cuda-cu128-test",
    "humble-desktop-cuda-cu128-test",
    "humble-desktop-full-cuda-cu128-test",
    "humble-core-cuda-cu130-test",
    "humble-base-cuda-cu130-test",
    "humble-perception-cuda-cu130-test",
    "humble-desktop-cuda-cu130-test",
    "humble-desktop-full-cuda-cu130-test",
    "humble-core-cuda-cu121-test",
    "humble-base-cuda-cu121-test",
    "humble-perception-cuda-cu121-test",
    "humble-desktop-cuda-cu121-test",
    "humble-desktop-full-cuda-cu121-test",
    "humble-core-torch-cu128-test",
    "humble-base-torch-cu128-test",
    "humble-perception-torch-cu128-test",
    "humble-desktop-torch-cu128-test",
    "humble-desktop-full-torch-cu128-test",
    "humble-core-torch-cu130-test",
    "humble-base-torch-cu130-test",
    "humble-perception-torch-cu130-test",
    "humble-desktop-torch-cu130-test",
    "humble-desktop-full-torch-cu130-test",
    "humble-core-torch-cpu-test",
    "humble-base-torch-cpu-test",
    "humble-perception-torch-cpu-test",
    "humble-desktop-torch-cpu-test",
    "humble-desktop-full-torch-cpu-test",
    "humble-core-tensorflow-cu128-test",
    "humble-base-tensorflow-cu128-test",
    "humble-perception-tensorflow-cu128-test",
    "humble-desktop-tensorflow-cu128-test",
    "humble-desktop-full-tensorflow-cu128-test",
    "humble-core-tensorflow-cpu-test",
    "humble-base-tensorflow-cpu-test",
    "humble-perception-tensorflow-cpu-test",
    "humble-desktop-tensorflow-cpu-test",
    "humble-desktop-full-tensorflow-cpu-test",
    "humble-core-ml-cu128-test",
    "humble-base-ml-cu128-test",
    "humble-perception-ml-cu128-test",
    "humble-desktop-ml-cu128-test",
    "humble-desktop-full-ml-cu128-test",
    "humble-core-ml-cpu-test",
    "humble-base-ml-cpu-test",
    "humble-perception-ml-cpu-test",
    "humble-desktop-ml-cpu-test",
    "humble-desktop-full-ml-cpu-test",
    "iron-core-test",
    "iron-base-test",
    "iron-perception-test",
    "iron-desktop-test",
    "iron-desktop-full-test",
    "iron-core-cuda-cu128-test",
    "iron-base-cuda-cu128-test",
    "iron-perception-cuda-cu128-test",
    "iron-desktop-cuda-cu128-test",
    "iron-desktop-full-cuda-cu128-test",
    "iron-core-cuda-cu130-test",
    "iron-base-cuda-cu130-test",
    "iron-perception-cuda-cu130-test",
    "iron-desktop-cuda-cu130-test",
    "iron-desktop-full-cuda-cu130-test",
    "iron-core-cuda-cu121-test",
    "iron-base-cuda-cu121-test",
    "iron-perception-cuda-cu121-test",
    "iron-desktop-cuda-cu121-test",
    "iron-desktop-full-cuda-cu121-test",
    "iron-core-torch-cu128-test",
    "iron-base-torch-cu128-test",
    "iron-perception-torch-cu128-test",
    "iron-desktop-torch-cu128-test",
    "iron-desktop-full-torch-cu128-test",
    "iron-core-torch-cu130-test",
    "iron-base-torch-cu130-test",
    "iron-perception-torch-cu130-test",
    "iron-desktop-torch-cu130-test",
    "iron-desktop-full-torch-cu130-test",
    "iron-core-torch-cpu-test",
    "iron-base-torch-cpu-test",
    "iron-perception-torch-cpu-test",
    "iron-desktop-torch-cpu-test",
    "iron-desktop-full-torch-cpu-test",
    "iron-core-tensorflow-cu128-test",
    "iron-base-tensorflow-cu128-test",
    "iron-perception-tensorflow-cu128-test",
    "iron-desktop-tensorflow-cu128-test",
    "iron-desktop-full-tensorflow-cu128-test",
    "iron-core-tensorflow-cpu-test",
    "iron-base-tensorflow-cpu-test",
    "iron-perception-tensorflow-cpu-test",
    "iron-desktop-tensorflow-cpu-test",
    "iron-desktop-full-tensorflow-cpu-test",
    "iron-core-ml-cu128-test",
    "iron-base-ml-cu128-test",
    "iron-perception-ml-cu128-test",
    "iron-desktop-ml-cu128-test",
    "iron-desktop-full-ml-cu128-test",
    "iron-core-ml-cpu-test",
    "iron-base-ml-cpu-test",
    "iron-perception-ml-cpu-test",
    "iron-desktop-ml-cpu-test",
    "iron-desktop-full-ml-cpu-test",
    "jazzy-core-test",
    "jazzy-base-test",
    "jazzy-perception-test",
    "jazzy-desktop-test",
    "jazzy-desktop-full-test",
    "jazzy-core-cuda-cu128-test",
    "jazzy-base-cuda-cu128-test",
    "jazzy-perception-cuda-cu128-test",
    "jazzy-desktop-cuda-cu128-test",
    "jazzy-desktop-full-cuda-cu128-test",
    "jazzy-core-cuda-cu130-test",
    "jazzy-base-cuda-cu130-test",
    "jazzy-perception-cuda-cu130-test",
    "jazzy-desktop-cuda-cu130-test",
    "jazzy-desktop-full-cuda-cu130-test",
    "jazzy-core-cuda-cu121-test",
    "jazzy-base-cuda-cu121-test",
    "jazzy-perception-cuda-cu121-test",
    "jazzy-desktop-cuda-cu121-test",
    "jazzy-desktop-full-cuda-cu121-test",
    "jazzy-core-torch-cu128-test",
    "jazzy-base-torch-cu128-test",
    "jazzy-perception-torch-cu128-test",
    "jazzy-desktop-torch-cu128-test",
    "jazzy-desktop-full-torch-cu128-test",
    "jazzy-core-torch-cu130-test",
    "jazzy-base-torch-cu130-test",
    "jazzy-perception-torch-cu130-test",
    "jazzy-desktop-torch-cu130-test",
    "jazzy-desktop-full-torch-cu130-test",
    "jazzy-core-torch-cpu-test",
    "jazzy-base-torch-cpu-test",
    "jazzy-perception-torch-cpu-test",
    "jazzy-desktop-torch-cpu-test",
    "jazzy-desktop-full-torch-cpu-test",
    "jazzy-core-tensorflow-cu128-test",
    "jazzy-base-tensorflow-cu128-test",
    "jazzy-perception-tensorflow-cu128-test",
    "jazzy-desktop-tensorflow-cu128-test",
    "jazzy-desktop-full-tensorflow-cu128-test",
    "jazzy-core-tensorflow-cpu-test",
    "jazzy-base-tensorflow-cpu-test",
    "jazzy-perception-tensorflow-cpu-test",
    "jazzy-desktop-tensorflow-cpu-test",
    "jazzy-desktop-full-tensorflow-cpu-test",
    "jazzy-core-ml-cu128-test",
    "jazzy-base-ml-cu128-test",
    "jazzy-perception-ml-cu128-test",
    "jazzy-desktop-ml-cu128-test",
    "jazzy-desktop-full-ml-cu128-test",
    "jazzy-core-ml-cpu-test",
    "jazzy-base-ml-cpu-test",
    "jazzy-perception-ml-cpu-test",
    "jazzy-desktop-ml-cpu-test",
    "jazzy-desktop-full-ml-cpu-test",
    "kilted-core-test",
    "kilted-base-test",
    "kilted-perception-test",
    "kilted-desktop-test",
    "kilted-desktop-full-test",
    "kilted-core-cuda-cu128-test",
    "kilted-base-cuda-cu128-test",
    "kilted-perception-cuda-cu128-test",
    "kilted-desktop-cuda-cu128-test",
    "kilted-desktop-full-cuda-cu128-test",
    "kilted-core-cuda-cu130-test",
    "kilted-base-cuda-cu130-test",
    "kilted-perception-cuda-cu130-test",
    "kilted-desktop-cuda-cu130-test",
    "kilted-desktop-full-cuda-cu130-test",
    "kilted-core-cuda-cu121-test",
    "kilted-base-cuda-cu121-test",
    "kilted-perception-cuda-cu121-test",
    "kilted-desktop-cuda-cu121-test",
    "kilted-desktop-full-cuda-cu121-test",
    "kilted-core-torch-cu128-test",
    "kilted-base-torch-cu128-test",
    "kilted-perception-torch-cu128-test",
    "kilted-desktop-torch-cu128-test",
    "kilted-desktop-full-torch-cu128-test",
    "kilted-core-torch-cu130-test",
    "kilted-base-torch-cu130-test",
    "kilted-perception-torch-cu130-test",
    "kilted-desktop-torch-cu130-test",
    "kilted-desktop-full-torch-cu130-test",
    "kilted-core-torch-cpu-test",
    "kilted-base-torch-cpu-test",
    "kilted-perception-torch-cpu-test",
    "kilted-desktop-torch-cpu-test",
    "kilted-desktop-full-torch-cpu-test",
    "kilted-core-tensorflow-cu128-test",
    "kilted-base-tensorflow-cu128-test",
    "kilted-perception-tensorflow-cu128-test",
    "kilted-desktop-tensorflow-cu128-test",
    "kilted-desktop-full-tensorflow-cu128-test",
    "kilted-core-tensorflow-cpu-test",
    "kilted-base-tensorflow-cpu-test",
    "kilted-perception-tensorflow-cpu-test",
    "kilted-desktop-tensorflow-cpu-test",
    "kilted-desktop-full-tensorflow-cpu-test",
    "kilted-core-ml-cu128-test",
    "kilted-base-ml-cu128-test",
    "kilted-perception-ml-cu128-test",
    "kilted-desktop-ml-cu128-test",
    "kilted-desktop-full-ml-cu128-test",
    "kilted-core-ml-cpu-test",
    "kilted-base-ml-cpu-test",
    "kilted-perception-ml-cpu-test",
    "kilted-desktop-ml-cpu-test",
    "kilted-desktop-full-ml-cpu-test",
    "lyrical-core-test",
    "lyrical-base-test",
    "lyrical-perception-test",
    "lyrical-desktop-test",
    "lyrical-desktop-full-test",
    "lyrical-core-cuda-cu128-test",
    "lyrical-base-cuda-cu128-test",
    "lyrical-perception-cuda-cu128-test",
    "lyrical-desktop-cuda-cu128-test",
    "lyrical-desktop-full-cuda-cu128-test",
    "lyrical-core-cuda-cu130-test",
    "lyrical-base-cuda-cu130-test",
    "lyrical-perception-cuda-cu130-test",
    "lyrical-desktop-cuda-cu130-test",
    "lyrical-desktop-full-cuda-cu130-test",
    "lyrical-core-cuda-cu121-test",
    "lyrical-base-cuda-cu121-test",
    "lyrical-perception-cuda-cu121-test",
    "lyrical-desktop-cuda-cu121-test",
    "lyrical-desktop-full-cuda-cu121-test",
    "lyrical-core-torch-cu128-test",
    "lyrical-base-torch-cu128-test",
    "lyrical-perception-torch-cu128-test",
    "lyrical-desktop-torch-cu128-test",
    "lyrical-desktop-full-torch-cu128-test",
    "lyrical-core-torch-cu130-test",
    "lyrical-base-torch-cu130-test",
    "lyrical-perception-torch-cu130-test",
    "lyrical-desktop-torch-cu130-test",
    "lyrical-desktop-full-torch-cu130-test",
    "rolling-core-test",
    "rolling-base-test",
    "rolling-perception-test",
    "rolling-desktop-test",
    "rolling-desktop-full-test",
    "rolling-core-cuda-cu128-test",
    "rolling-base-cuda-cu128-test",
    "rolling-perception-cuda-cu128-test",
    "rolling-desktop-cuda-cu128-test",
    "rolling-desktop-full-cuda-cu128-test",
    "rolling-core-cuda-cu130-test",
    "rolling-base-cuda-cu130-test",
    "rolling-perception-cuda-cu130-test",
    "rolling-desktop-cuda-cu130-test",
    "rolling-desktop-full-cuda-cu130-test",
    "rolling-core-cuda-cu121-test",
    "rolling-base-cuda-cu121-test",
    "rolling-perception-cuda-cu121-test",
    "rolling-desktop-cuda-cu121-test",
    "rolling-desktop-full-cuda-cu121-test",
    "rolling-core-torch-cu128-test",
    "rolling-base-torch-cu128-test",
    "rolling-perception-torch-cu128-test",
    "rolling-desktop-torch-cu128-test",
    "rolling-desktop-full-torch-cu128-test",
    "rolling-core-torch-cu130-test",
    "rolling-base-torch-cu130-test",
    "rolling-perception-torch-cu130-test",
    "rolling-desktop-torch-cu130-test",
    "rolling-desktop-full-torch-cu130-test",
    "bookworm-core-test",
    "bookworm-base-test",
    "bookworm-robot-test",
    "bookworm-perception-test",
    "bookworm-desktop-test",
    "bookworm-desktop-full-test",
    "bookworm-core-cuda-cu128-test",
    "bookworm-base-cuda-cu128-test",
    "bookworm-robot-cuda-cu128-test",
    "bookworm-perception-cuda-cu128-test",
    "bookworm-desktop-cuda-cu128-test",
    "bookworm-desktop-full-cuda-cu128-test",
    "bookworm-core-cuda-cu130-test",
    "bookworm-base-cuda-cu130-test",
    "bookworm-robot-cuda-cu130-test",
    "bookworm-perception-cuda-cu130-test",
    "bookworm-desktop-cuda-cu130-test",
    "bookworm-desktop-full-cuda-cu130-test",
    "bookworm-core-cuda-cu121-test",
    "bookworm-base-cuda-cu121-test",
    "bookworm-robot-cuda-cu121-test",
    "bookworm-perception-cuda-cu121-test",
    "bookworm-desktop-cuda-cu121-test",
    "bookworm-desktop-full-cuda-cu121-test",
    "bookworm-core-torch-cu128-test",
    "bookworm-base-torch-cu128-test",
    "bookworm-robot-torch-cu128-test",
    "bookworm-perception-torch-cu128-test",
    "bookworm-desktop-torch-cu128-test",
    "bookworm-desktop-full-torch-cu128-test",
    "bookworm-core-torch-cu130-test",
    "bookworm-base-torch-cu130-test",
    "bookworm-robot-torch-cu130-test",
    "bookworm-perception-torch-cu130-test",
    "bookworm-desktop-torch-cu130-test",
    "bookworm-desktop-full-torch-cu130-test",
    "bookworm-core-tensorflow-cu128-test",
    "bookworm-base-tensorflow-cu128-test",
    "bookworm-robot-tensorflow-cu128-test",
    "bookworm-perception-tensorflow-cu128-test",
    "bookworm-desktop-tensorflow-cu128-test",
    "bookworm-desktop-full-tensorflow-cu128-test",
    "bookworm-core-tensorflow-cpu-test",
    "bookworm-base-tensorflow-cpu-test",
    "bookworm-robot-tensorflow-cpu-test",
    "bookworm-perception-tensorflow-cpu-test",
    "bookworm-desktop-tensorflow-cpu-test",
    "bookworm-desktop-full-tensorflow-cpu-test",
    "bookworm-core-ml-cu128-test",
    "bookworm-base-ml-cu128-test",
    "bookworm-robot-ml-cu128-test",
    "bookworm-perception-ml-cu128-test",
    "bookworm-desktop-ml-cu128-test",
    "bookworm-desktop-full-ml-cu128-test",
    "trixie-core-test",
    "trixie-base-test",
    "trixie-robot-test",
    "trixie-perception-test",
    "trixie-desktop-test",
    "trixie-desktop-full-test",
    "trixie-core-cuda-cu128-test",
    "trixie-base-cuda-cu128-test",
    "trixie-robot-cuda-cu128-test",
    "trixie-perception-cuda-cu128-test",
    "trixie-desktop-cuda-cu128-test",
    "trixie-desktop-full-cuda-cu128-test",
    "trixie-core-cuda-cu130-test",
    "trixie-base-cuda-cu130-test",
    "trixie-robot-cuda-cu130-test",
    "trixie-perception-cuda-cu130-test",
    "trixie-desktop-cuda-cu130-test",
    "trixie-desktop-full-cuda-cu130-test",
    "trixie-core-cuda-cu121-test",
    "trixie-base-cuda-cu121-test",
    "trixie-robot-cuda-cu121-test",
    "trixie-perception-cuda-cu121-test",
    "trixie-desktop-cuda-cu121-test",
    "trixie-desktop-full-cuda-cu121-test",
    "trixie-core-torch-cu128-test",
    "trixie-base-torch-cu128-test",
    "trixie-robot-torch-cu128-test",
    "trixie-perception-torch-cu128-test",
    "trixie-desktop-torch-cu128-test",
    "trixie-desktop-full-torch-cu128-test",
    "trixie-core-torch-cu130-test",
    "trixie-base-torch-cu130-test",
    "trixie-robot-torch-cu130-test",
    "trixie-perception-torch-cu130-test",
    "trixie-desktop-torch-cu130-test",
    "trixie-desktop-full-torch-cu130-test",
    "trixie-core-torch-cpu-test",
    "trixie-base-torch-cpu-test",
    "trixie-robot-torch-cpu-test",
    "trixie-perception-torch-cpu-test",
    "trixie-desktop-torch-cpu-test",
    "trixie-desktop-full-torch-cpu-test",
    "trixie-core-tensorflow-cu128-test",
    "trixie-base-tensorflow-cu128-test",
    "trixie-robot-tensorflow-cu128-test",
    "trixie-perception-tensorflow-cu128-test",
    "trixie-desktop-tensorflow-cu128-test",
    "trixie-desktop-full-tensorflow-cu128-test",
    "trixie-core-tensorflow-cpu-test",
    "trixie-base-tensorflow-cpu-test",
    "trixie-robot-tensorflow-cpu-test",
    "trixie-perception-tensorflow-cpu-test",
    "trixie-desktop-tensorflow-cpu-test",
    "trixie-desktop-full-tensorflow-cpu-test",
    "trixie-core-ml-cu128-test",
    "trixie-base-ml-cu128-test",
    "trixie-robot-ml-cu128-test",
    "trixie-perception-ml-cu128-test",
    "trixie-desktop-ml-cu128-test",
    "trixie-desktop-full-ml-cu128-test",
    "trixie-core-ml-cpu-test",
    "trixie-base-ml-cpu-test",
    "trixie-robot-ml-cpu-test",
    "trixie-perception-ml-cpu-test",
    "trixie-desktop-ml-cpu-test",
    "trixie-desktop-full-ml-cpu-test",
    "jazzy-wheels-core-test",
    "jazzy-wheels-core-cuda-cu128-test",
    "jazzy-wheels-core-cuda-cu130-test",
    "jazzy-wheels-core-cuda-cu121-test",
    "jazzy-wheels-core-torch-cu128-test",
    "jazzy-wheels-core-torch-cu130-test",
    "jazzy-wheels-core-tensorflow-cu128-test",
    "jazzy-wheels-core-tensorflow-cpu-test",
    "jazzy-wheels-core-ml-cu128-test",
  ]
}
