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

# file with certificates that build steps trust; never part of a layer
variable "CA_BUNDLE" {
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

# A build argument that is left out when it is empty.
function "given" {
  params = [value]
  result = value == "" ? null : value
}

# ---- What targets have in common -----------------------------------------------------------------------------------

target "_common" {
  context = "."
  secret  = CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"]
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
  }
}

target "_test" {
  inherits = ["_common"]
  target   = "test"
  contexts = { os = OS_BOOKWORM }
  output   = ["type=cacheonly"]
}

# ---- Operating systems with the essentials -------------------------------------------------------------------------

target "_os-bookworm" {
  inherits  = ["_base"]
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
}

target "_os-trixie" {
  inherits  = ["_base"]
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
}

# ---- ROS images: a chain of components -----------------------------------------------------------------------------

target "_distribution-bookworm" {
  inherits  = ["_image"]
  platforms = ["linux/amd64"]
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
    ROS_TOOLS    = "rosbash catkin colcon python3-colcon-ros python3-colcon-cmake python3-rosdep2 vcstool"
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
  platforms = ["linux/amd64"]
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
    ROS_TOOLS    = "rosbash catkin colcon python3-colcon-ros python3-colcon-cmake python3-rosdep2 vcstool"
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

# ---- Payloads: assembled once, joined to many images ---------------------------------------------------------------

target "_files-cuda-cu128" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "cuda"
    STACK       = "cu128"
    PYTHON      = "any"
    ACCELERATOR = "cuda"
  }
}

target "payload-cuda-cu128" {
  inherits = ["_files-cuda-cu128"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:cuda-cu128"]
}

target "_files-common-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "common"
    STACK       = "cu128"
    PYTHON      = "3.11"
    ACCELERATOR = "cuda"
  }
}

target "payload-common-cu128-py311" {
  inherits = ["_files-common-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py311"]
}

target "_files-torch-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "torch"
    STACK       = "cu128"
    PYTHON      = "3.11"
    ACCELERATOR = "cuda"
  }
}

target "payload-torch-cu128-py311" {
  inherits = ["_files-torch-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py311"]
}

target "_files-tensorflow-cu128-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "tensorflow"
    STACK       = "cu128"
    PYTHON      = "3.11"
    ACCELERATOR = "cuda"
  }
}

target "payload-tensorflow-cu128-py311" {
  inherits = ["_files-tensorflow-cu128-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py311"]
}

target "_files-common-cpu-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "common"
    STACK       = "cpu"
    PYTHON      = "3.11"
    ACCELERATOR = "cpu"
  }
}

target "payload-common-cpu-py311" {
  inherits = ["_files-common-cpu-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py311"]
}

target "_files-tensorflow-cpu-py311" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART        = "tensorflow"
    STACK       = "cpu"
    PYTHON      = "3.11"
    ACCELERATOR = "cpu"
  }
}

target "payload-tensorflow-cpu-py311" {
  inherits = ["_files-tensorflow-cpu-py311"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py311"]
}

target "_files-common-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART        = "common"
    STACK       = "cu128"
    PYTHON      = "3.13"
    ACCELERATOR = "cuda"
  }
}

target "payload-common-cu128-py313" {
  inherits = ["_files-common-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cu128-py313"]
}

target "_files-torch-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART        = "torch"
    STACK       = "cu128"
    PYTHON      = "3.13"
    ACCELERATOR = "cuda"
  }
}

target "payload-torch-cu128-py313" {
  inherits = ["_files-torch-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:torch-cu128-py313"]
}

target "_files-tensorflow-cu128-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART        = "tensorflow"
    STACK       = "cu128"
    PYTHON      = "3.13"
    ACCELERATOR = "cuda"
  }
}

target "payload-tensorflow-cu128-py313" {
  inherits = ["_files-tensorflow-cu128-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cu128-py313"]
}

target "_files-common-cpu-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART        = "common"
    STACK       = "cpu"
    PYTHON      = "3.13"
    ACCELERATOR = "cpu"
  }
}

target "payload-common-cpu-py313" {
  inherits = ["_files-common-cpu-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:common-cpu-py313"]
}

target "_files-tensorflow-cpu-py313" {
  inherits  = ["_payload"]
  target    = "payload-files"
  platforms = ["linux/amd64"]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART        = "tensorflow"
    STACK       = "cpu"
    PYTHON      = "3.13"
    ACCELERATOR = "cpu"
  }
}

target "payload-tensorflow-cpu-py313" {
  inherits = ["_files-tensorflow-cpu-py313"]
  target   = "payload"
  tags     = ["${REGISTRY}/payload:tensorflow-cpu-py313"]
}

# ---- Images with a framework: a ROS image joined with payloads -----------------------------------------------------

target "_torch-cu128-bookworm" {
  target    = "torch"
  platforms = ["linux/amd64"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_torch-cu128-bookworm"]
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

target "_tensorflow-cu128-bookworm" {
  target    = "tensorflow"
  platforms = ["linux/amd64"]
  contexts = {
    part-cuda       = part("cuda-cu128")
    part-common     = part("common-cu128-py311")
    part-tensorflow = part("tensorflow-cu128-py311")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py311")
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cu128-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-full-cu128", "${REGISTRY}/ros-tf:bookworm-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_tensorflow-cpu-bookworm" {
  target    = "tensorflow"
  platforms = ["linux/amd64"]
  contexts = {
    part-common     = part("common-cpu-py311")
    part-tensorflow = part("tensorflow-cpu-py311")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py311")
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
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
  inherits = ["_distribution-bookworm", "_tensorflow-cpu-bookworm"]
  tags     = ["${REGISTRY}/ros-tf:bookworm-desktop-full-cpu", "${REGISTRY}/ros-tf:bookworm-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "bookworm-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (bookworm), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "bookworm-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_ml-cu128-bookworm" {
  target    = "ml"
  platforms = ["linux/amd64"]
  contexts = {
    part-cuda       = part("cuda-cu128")
    part-common     = part("common-cu128-py311")
    part-torch      = part("torch-cu128-py311")
    part-tensorflow = part("tensorflow-cu128-py311")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py311")
    TORCH_ROOT         = root("torch-cu128-py311")
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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
  inherits = ["_distribution-bookworm", "_ml-cu128-bookworm"]
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

target "_torch-cu128-trixie" {
  target    = "torch"
  platforms = ["linux/amd64"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_torch-cu128-trixie"]
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

target "_tensorflow-cu128-trixie" {
  target    = "tensorflow"
  platforms = ["linux/amd64"]
  contexts = {
    part-cuda       = part("cuda-cu128")
    part-common     = part("common-cu128-py313")
    part-tensorflow = part("tensorflow-cu128-py313")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py313")
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cu128-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-full-cu128", "${REGISTRY}/ros-tf:trixie-desktop-full-cu128-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_tensorflow-cpu-trixie" {
  target    = "tensorflow"
  platforms = ["linux/amd64"]
  contexts = {
    part-common     = part("common-cpu-py313")
    part-tensorflow = part("tensorflow-cpu-py313")
  }
  args = {
    ACCELERATOR        = "cpu"
    COMMON_ROOT        = root("common-cpu-py313")
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
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
  inherits = ["_distribution-trixie", "_tensorflow-cpu-trixie"]
  tags     = ["${REGISTRY}/ros-tf:trixie-desktop-full-cpu", "${REGISTRY}/ros-tf:trixie-desktop-full-cpu-tf2.20.0"]
  contexts = { ros = image("ros", "trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "trixie-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (trixie), TensorFlow 2.20.0"
    "org.opencontainers.image.version"     = "trixie-desktop-full-cpu-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
  }
}

target "_ml-cu128-trixie" {
  target    = "ml"
  platforms = ["linux/amd64"]
  contexts = {
    part-cuda       = part("cuda-cu128")
    part-common     = part("common-cu128-py313")
    part-torch      = part("torch-cu128-py313")
    part-tensorflow = part("tensorflow-cu128-py313")
  }
  args = {
    ACCELERATOR        = "cuda"
    CUDA_ROOT          = root("cuda-cu128")
    COMMON_ROOT        = root("common-cu128-py313")
    TORCH_ROOT         = root("torch-cu128-py313")
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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
  inherits = ["_distribution-trixie", "_ml-cu128-trixie"]
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

# ---- Structure tests, inside the build -----------------------------------------------------------------------------

target "bookworm-core-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-core") }
  args = {
    TESTS  = "contract ros1 ros1-core"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-base-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-base") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-robot-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-robot") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-perception-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-perception") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-desktop-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-desktop") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-desktop-full-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "bookworm-desktop-full") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian"
  }
}

target "bookworm-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-core-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-base-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-robot-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "bookworm-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "bookworm-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "bookworm-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-core-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-base-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-robot-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "bookworm-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "bookworm-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch tensorflow ml"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-core") }
  args = {
    TESTS  = "contract ros1 ros1-core"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-base-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-base") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-robot-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-robot") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-perception-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-perception") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-desktop-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-desktop") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-desktop-full-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros", "trixie-desktop-full") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian"
  }
}

target "trixie-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-core-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-base-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-robot-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-perception-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-desktop-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-torch", "trixie-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-tf", "trixie-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian tensorflow=2.20.0"
  }
}

target "trixie-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-core-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-base-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-robot-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-perception-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-desktop-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

target "trixie-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = ["linux/amd64"]
  contexts  = { image = image("ros-ml", "trixie-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract ros1 ros1-core ros1-base ros1-robot ros1-perception ros1-desktop ros1-desktop-full cuda torch tensorflow ml"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5"
  }
}

# ---- Groups --------------------------------------------------------------------------------------------------------

group "default" {
  targets = ["bookworm-core"]
}

group "bookworm" {
  targets = [
    "bookworm-core",
    "bookworm-base",
    "bookworm-robot",
    "bookworm-perception",
    "bookworm-desktop",
    "bookworm-desktop-full",
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
  ]
}

group "core" {
  targets = [
    "bookworm-core",
    "bookworm-core-torch-cu128",
    "bookworm-core-tensorflow-cu128",
    "bookworm-core-tensorflow-cpu",
    "bookworm-core-ml-cu128",
    "trixie-core",
    "trixie-core-torch-cu128",
    "trixie-core-tensorflow-cu128",
    "trixie-core-tensorflow-cpu",
    "trixie-core-ml-cu128",
  ]
}

group "base" {
  targets = [
    "bookworm-base",
    "bookworm-base-torch-cu128",
    "bookworm-base-tensorflow-cu128",
    "bookworm-base-tensorflow-cpu",
    "bookworm-base-ml-cu128",
    "trixie-base",
    "trixie-base-torch-cu128",
    "trixie-base-tensorflow-cu128",
    "trixie-base-tensorflow-cpu",
    "trixie-base-ml-cu128",
  ]
}

group "robot" {
  targets = [
    "bookworm-robot",
    "bookworm-robot-torch-cu128",
    "bookworm-robot-tensorflow-cu128",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-robot-ml-cu128",
    "trixie-robot",
    "trixie-robot-torch-cu128",
    "trixie-robot-tensorflow-cu128",
    "trixie-robot-tensorflow-cpu",
    "trixie-robot-ml-cu128",
  ]
}

group "perception" {
  targets = [
    "bookworm-perception",
    "bookworm-perception-torch-cu128",
    "bookworm-perception-tensorflow-cu128",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-perception-ml-cu128",
    "trixie-perception",
    "trixie-perception-torch-cu128",
    "trixie-perception-tensorflow-cu128",
    "trixie-perception-tensorflow-cpu",
    "trixie-perception-ml-cu128",
  ]
}

group "desktop" {
  targets = [
    "bookworm-desktop",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-tensorflow-cu128",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-ml-cu128",
    "trixie-desktop",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-tensorflow-cu128",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-ml-cu128",
  ]
}

group "desktop-full" {
  targets = [
    "bookworm-desktop-full",
    "bookworm-desktop-full-torch-cu128",
    "bookworm-desktop-full-tensorflow-cu128",
    "bookworm-desktop-full-tensorflow-cpu",
    "bookworm-desktop-full-ml-cu128",
    "trixie-desktop-full",
    "trixie-desktop-full-torch-cu128",
    "trixie-desktop-full-tensorflow-cu128",
    "trixie-desktop-full-tensorflow-cpu",
    "trixie-desktop-full-ml-cu128",
  ]
}

group "none" {
  targets = [
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
  ]
}

group "torch" {
  targets = [
    "bookworm-core-torch-cu128",
    "bookworm-base-torch-cu128",
    "bookworm-robot-torch-cu128",
    "bookworm-perception-torch-cu128",
    "bookworm-desktop-torch-cu128",
    "bookworm-desktop-full-torch-cu128",
    "trixie-core-torch-cu128",
    "trixie-base-torch-cu128",
    "trixie-robot-torch-cu128",
    "trixie-perception-torch-cu128",
    "trixie-desktop-torch-cu128",
    "trixie-desktop-full-torch-cu128",
  ]
}

group "tensorflow" {
  targets = [
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
  ]
}

group "ml" {
  targets = [
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
  ]
}

group "cu128" {
  targets = [
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
  ]
}

group "cpu" {
  targets = [
    "bookworm-core-tensorflow-cpu",
    "bookworm-base-tensorflow-cpu",
    "bookworm-robot-tensorflow-cpu",
    "bookworm-perception-tensorflow-cpu",
    "bookworm-desktop-tensorflow-cpu",
    "bookworm-desktop-full-tensorflow-cpu",
    "trixie-core-tensorflow-cpu",
    "trixie-base-tensorflow-cpu",
    "trixie-robot-tensorflow-cpu",
    "trixie-perception-tensorflow-cpu",
    "trixie-desktop-tensorflow-cpu",
    "trixie-desktop-full-tensorflow-cpu",
  ]
}

group "all" {
  targets = [
    "bookworm-core",
    "bookworm-base",
    "bookworm-robot",
    "bookworm-perception",
    "bookworm-desktop",
    "bookworm-desktop-full",
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
  ]
}

group "payloads" {
  targets = [
    "payload-cuda-cu128",
    "payload-common-cu128-py311",
    "payload-torch-cu128-py311",
    "payload-tensorflow-cu128-py311",
    "payload-common-cpu-py311",
    "payload-tensorflow-cpu-py311",
    "payload-common-cu128-py313",
    "payload-torch-cu128-py313",
    "payload-tensorflow-cu128-py313",
    "payload-common-cpu-py313",
    "payload-tensorflow-cpu-py313",
  ]
}

group "tests" {
  targets = [
    "bookworm-core-test",
    "bookworm-base-test",
    "bookworm-robot-test",
    "bookworm-perception-test",
    "bookworm-desktop-test",
    "bookworm-desktop-full-test",
    "bookworm-core-torch-cu128-test",
    "bookworm-base-torch-cu128-test",
    "bookworm-robot-torch-cu128-test",
    "bookworm-perception-torch-cu128-test",
    "bookworm-desktop-torch-cu128-test",
    "bookworm-desktop-full-torch-cu128-test",
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
    "trixie-core-torch-cu128-test",
    "trixie-base-torch-cu128-test",
    "trixie-robot-torch-cu128-test",
    "trixie-perception-torch-cu128-test",
    "trixie-desktop-torch-cu128-test",
    "trixie-desktop-full-torch-cu128-test",
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
  ]
}
