# Generated from matrix.yaml: change that, then run
#   rosml generate
#
#   PLATFORM=linux/amd64 docker buildx bake ros1-bookworm-core   builds an image, and what it stands on, for one platform
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
  description = "live, testing, snapshot or final, instead of matrix.yaml's channel (ROS_CHANNEL=final rosml image)"
  default     = ""
}

variable "ROS_SNAPSHOT" {
  description = "day of the snapshot if ROS_CHANNEL is snapshot: YYYY-MM-DD"
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

# What the caller says in JSON. An empty text says nothing.
digests    = { for name, digest in jsondecode(DIGESTS == "" ? "{}" : DIGESTS) : name => digest if digest != "" }
sync_dates = { for name, date in jsondecode(ROS_SYNC_DATES == "" ? "{}" : ROS_SYNC_DATES) : name => date if date != "" }

# A dependency: built here, unless DIGESTS names it. The only place that decides.
function "dependency" {
  params = [name, repository, target]
  result = try("docker-image://${REGISTRY}/${repository}@${digests[name]}", "target:${target}")
}

# ---- What others inherit, and operating systems ---------------------------------------------------------------------

target "_every" {
  args = {
    SOURCE_DATE_EPOCH = SOURCE_DATE_EPOCH
    HTTP_PROXY        = HTTP_PROXY == "" ? null : HTTP_PROXY
    HTTPS_PROXY       = HTTPS_PROXY == "" ? null : HTTPS_PROXY
    NO_PROXY          = NO_PROXY == "" ? null : NO_PROXY
  }
  context = "."
  network = STEP_NETWORK == "" ? null : STEP_NETWORK
  secret  = concat(
    CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"],
    ROS_APT_MIRROR == "" ? [] : ["id=ros-apt-mirror,env=ROS_APT_MIRROR"],
    OS_APT_MIRROR == "" ? [] : ["id=os-apt-mirror,env=OS_APT_MIRROR"]
  )
}

target "contents" {
  inherits    = ["_every"]
  description = "the packages and files of the image that its context `described` is"
  target      = "contents"
  contexts    = { os = OS_BOOKWORM }
}

target "_os-ubuntu-20-04" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-20-04-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    NUMPY   = "<2"
    RUNTIME = "true"
  }
}

target "_os-ubuntu-22-04" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-22-04-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    NUMPY   = "<2"
    RUNTIME = "true"
  }
}

target "_os-ubuntu-24-04" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args      = { NUMPY = "<2" }
}

target "_os-ubuntu-24-04-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    NUMPY   = "<2"
    RUNTIME = "true"
  }
}

target "_os-ubuntu-26-04" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args      = { NUMPY = ">=2.3,<2.4" }
}

target "_os-ubuntu-26-04-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    NUMPY   = ">=2.3,<2.4"
    RUNTIME = "true"
  }
}

target "_os-bookworm" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args      = { NUMPY = "<2" }
}

target "_os-bookworm-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    NUMPY   = "<2"
    RUNTIME = "true"
  }
}

target "_os-trixie" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args      = { NUMPY = ">=2.2,<2.3" }
}

target "_os-trixie-run" {
  inherits  = ["_every"]
  target    = "base"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    NUMPY   = ">=2.2,<2.3"
    RUNTIME = "true"
  }
}

target "_image" {
  inherits = ["_every"]
  labels = {
    "org.opencontainers.image.revision" = REVISION == "" ? null : REVISION
    "org.opencontainers.image.created"  = timeadd("1970-01-01T00:00:00Z", "${SOURCE_DATE_EPOCH}s")
  }
}

# ---- Parts: the files below /out, and the part as an image of its own -----------------------------------------------

target "_files" {
  inherits = ["_every"]
  target   = "part-files"
}

target "_files-cuda-cu128" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu128"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-cuda-cu128" {
  inherits = ["_files-cuda-cu128"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu128"
    "org.opencontainers.image.description" = "part cuda of stack cu128, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "io.rosml.brings"                      = "cuda:cuda:CUDA cudnn::"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.frameworks"                  = "cuda=cuda* torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:cuda-cu128"
  ]
}

target "_files-cuda-cu130" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu130"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-cuda-cu130" {
  inherits = ["_files-cuda-cu130"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu130"
    "org.opencontainers.image.description" = "part cuda of stack cu130, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "io.rosml.brings"                      = "cuda:cuda:CUDA cudnn::"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.frameworks"                  = "cuda=cuda* torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:cuda-cu130"
  ]
}

target "_files-cuda-cu132" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu132"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-cuda-cu132" {
  inherits = ["_files-cuda-cu132"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu132"
    "org.opencontainers.image.description" = "part cuda of stack cu132, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "io.rosml.brings"                      = "cuda:cuda:CUDA cudnn::"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.frameworks"                  = "cuda=cuda* torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:cuda-cu132"
  ]
}

target "_files-cuda-cu121" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "cuda"
    STACK        = "cu121"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-cuda-cu121" {
  inherits = ["_files-cuda-cu121"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "cuda-cu121"
    "org.opencontainers.image.description" = "part cuda of stack cu121, for any Python"
    "io.rosml.part"                        = "cuda"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "any"
    "io.rosml.cuda"                        = "12.1.105"
    "io.rosml.cudnn"                       = "9.1.0.70"
    "io.rosml.gpu.driver"                  = "525"
    "io.rosml.brings"                      = "cuda:cuda:CUDA cudnn::"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.frameworks"                  = "cuda=cuda* torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:cuda-cu121"
  ]
}

target "_files-common-cu121-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "common"
    STACK        = "cu121"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu121-py38" {
  inherits = ["_files-common-cu121-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu121-py38"
    "org.opencontainers.image.description" = "part common of stack cu121, for Python 3.8"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "3.8"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu121-py38"
  ]
}

target "_files-torch-cu121-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "torch"
    STACK        = "cu121"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu121-py38" {
  inherits = ["_files-torch-cu121-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu121-py38"
    "org.opencontainers.image.description" = "part torch of stack cu121, for Python 3.8"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu121"
    "io.rosml.python"                      = "3.8"
    "io.rosml.torch"                       = "2.4.1"
    "io.rosml.gpu.torch.amd64"             = "sm_50 sm_60 sm_70 sm_75 sm_80 sm_86 sm_90"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu121-py38"
  ]
}

target "_files-common-cpu38-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "common"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu38-py38" {
  inherits = ["_files-common-cpu38-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu38-py38"
    "org.opencontainers.image.description" = "part common of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu38-py38"
  ]
}

target "_files-torch-cpu38-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu38-py38" {
  inherits = ["_files-torch-cpu38-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu38-py38"
    "org.opencontainers.image.description" = "part torch of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "io.rosml.torch"                       = "2.4.1"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu38-py38"
  ]
}

target "_files-grpc-cpu38-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "grpc"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu38-py38" {
  inherits = ["_files-grpc-cpu38-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu38-py38"
    "org.opencontainers.image.description" = "part grpc of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu38-py38"
  ]
}

target "_files-tensorflow-cc-cpu38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cpu38"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
  }
}

target "part-tensorflow-cc-cpu38" {
  inherits = ["_files-tensorflow-cc-cpu38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cpu38"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cpu38, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.13.1"
    "io.rosml.brings"                      = "tensorflow::"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cc-cpu38"
  ]
}

target "_files-tensorflow-cpu38-py38" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_20_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu38"
    PYTHON       = "3.8"
    WHEEL_PYTHON = "3.8"
    ACCELERATOR  = "cpu"
    SLOT         = "03"
  }
}

target "part-tensorflow-cpu38-py38" {
  inherits = ["_files-tensorflow-cpu38-py38"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu38-py38"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu38, for Python 3.8"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu38"
    "io.rosml.python"                      = "3.8"
    "io.rosml.tensorflow"                  = "2.13.1"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cpu38-py38"
  ]
}

target "_files-common-cu128-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu128-py310" {
  inherits = ["_files-common-cu128-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py310"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cu128-py310"
  ]
}

target "_files-torch-cu128-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu128-py310" {
  inherits = ["_files-torch-cu128-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py310"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.gpu.torch.amd64"             = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cu128-py310"
  ]
}

target "_files-grpc-cu128-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu128-py310" {
  inherits = ["_files-grpc-cu128-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu128-py310"
    "org.opencontainers.image.description" = "part grpc of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cu128-py310"
  ]
}

target "_files-tensorflow-cc-cu128" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cu128"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-tensorflow-cc-cu128" {
  inherits = ["_files-tensorflow-cc-cu128"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cu128"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cu128, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.brings"                      = "tensorflow::"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cc-cu128"
  ]
}

target "_files-tensorflow-cu128-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "03"
  }
}

target "part-tensorflow-cu128-py310" {
  inherits = ["_files-tensorflow-cu128-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py310"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.gpu.tensorflow.amd64"        = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cu128-py310"
  ]
}

target "_files-tritonclient-cu128-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu128"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu128-py310" {
  inherits = ["_files-tritonclient-cu128-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu128-py310"
    "org.opencontainers.image.description" = "part tritonclient of stack cu128, for Python 3.10"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu128-py310"
  ]
}

target "_files-common-cu130-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu130-py310" {
  inherits = ["_files-common-cu130-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py310"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu130-py310"
  ]
}

target "_files-torch-cu130-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu130-py310" {
  inherits = ["_files-torch-cu130-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py310"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.14.1"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu130-py310"
  ]
}

target "_files-grpc-cu130-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu130-py310" {
  inherits = ["_files-grpc-cu130-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu130-py310"
    "org.opencontainers.image.description" = "part grpc of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu130-py310"
  ]
}

target "_files-tritonclient-cu130-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu130-py310" {
  inherits = ["_files-tritonclient-cu130-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu130-py310"
    "org.opencontainers.image.description" = "part tritonclient of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu130-py310"
  ]
}

target "_files-tensorrt-rtx-cc-cu130" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorrt-rtx-cc"
    STACK        = "cu130"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-tensorrt-rtx-cc-cu130" {
  inherits = ["_files-tensorrt-rtx-cc-cu130"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cc-cu130"
    "org.opencontainers.image.description" = "part tensorrt-rtx-cc of stack cu130, for any Python"
    "io.rosml.part"                        = "tensorrt-rtx-cc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "any"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cc-cu130"
  ]
}

target "_files-tensorrt-rtx-cu130-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu130"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu130-py310" {
  inherits = ["_files-tensorrt-rtx-cu130-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu130-py310"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu130, for Python 3.10"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu130-py310"
  ]
}

target "_files-common-cu132-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cu132"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu132-py310" {
  inherits = ["_files-common-cu132-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu132-py310"
    "org.opencontainers.image.description" = "part common of stack cu132, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu132-py310"
  ]
}

target "_files-grpc-cu132-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu132"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu132-py310" {
  inherits = ["_files-grpc-cu132-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu132-py310"
    "org.opencontainers.image.description" = "part grpc of stack cu132, for Python 3.10"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu132-py310"
  ]
}

target "_files-tritonclient-cu132-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu132"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu132-py310" {
  inherits = ["_files-tritonclient-cu132-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu132-py310"
    "org.opencontainers.image.description" = "part tritonclient of stack cu132, for Python 3.10"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu132-py310"
  ]
}

target "_files-tensorrt-rtx-cc-cu132" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorrt-rtx-cc"
    STACK        = "cu132"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
  }
}

target "part-tensorrt-rtx-cc-cu132" {
  inherits = ["_files-tensorrt-rtx-cc-cu132"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cc-cu132"
    "org.opencontainers.image.description" = "part tensorrt-rtx-cc of stack cu132, for any Python"
    "io.rosml.part"                        = "tensorrt-rtx-cc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "any"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cc-cu132"
  ]
}

target "_files-tensorrt-rtx-cu132-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu132"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu132-py310" {
  inherits = ["_files-tensorrt-rtx-cu132-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu132-py310"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu132, for Python 3.10"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu132-py310"
  ]
}

target "_files-common-cpu-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu-py310" {
  inherits = ["_files-common-cpu-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py310"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu-py310"
  ]
}

target "_files-torch-cpu-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu-py310" {
  inherits = ["_files-torch-cpu-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py310"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu-py310"
  ]
}

target "_files-grpc-cpu-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "grpc"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu-py310" {
  inherits = ["_files-grpc-cpu-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu-py310"
    "org.opencontainers.image.description" = "part grpc of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu-py310"
  ]
}

target "_files-tensorflow-cc-cpu" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow-cc"
    STACK        = "cpu"
    PYTHON       = "any"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
  }
}

target "part-tensorflow-cc-cpu" {
  inherits = ["_files-tensorflow-cc-cpu"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cc-cpu"
    "org.opencontainers.image.description" = "part tensorflow-cc of stack cpu, for any Python"
    "io.rosml.part"                        = "tensorflow-cc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "any"
    "io.rosml.tensorflow"                  = "2.21.0"
    "io.rosml.brings"                      = "tensorflow::"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cc-cpu"
  ]
}

target "_files-tensorflow-cpu-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
    SLOT         = "03"
  }
}

target "part-tensorflow-cpu-py310" {
  inherits = ["_files-tensorflow-cpu-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py310"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tensorflow"                  = "2.21.0"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cpu-py310"
  ]
}

target "_files-tritonclient-cpu-py310" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_22_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cpu"
    PYTHON       = "3.10"
    WHEEL_PYTHON = "3.10"
    ACCELERATOR  = "cpu"
    SLOT         = "09"
  }
}

target "part-tritonclient-cpu-py310" {
  inherits = ["_files-tritonclient-cpu-py310"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cpu-py310"
    "org.opencontainers.image.description" = "part tritonclient of stack cpu, for Python 3.10"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.10"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cpu-py310"
  ]
}

target "_files-common-cu128-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu128-py312" {
  inherits = ["_files-common-cu128-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py312"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cu128-py312"
  ]
}

target "_files-torch-cu128-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu128-py312" {
  inherits = ["_files-torch-cu128-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py312"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.gpu.torch.amd64"             = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cu128-py312"
  ]
}

target "_files-grpc-cu128-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu128-py312" {
  inherits = ["_files-grpc-cu128-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu128-py312"
    "org.opencontainers.image.description" = "part grpc of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cu128-py312"
  ]
}

target "_files-tensorflow-cu128-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "03"
  }
}

target "part-tensorflow-cu128-py312" {
  inherits = ["_files-tensorflow-cu128-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py312"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.gpu.tensorflow.amd64"        = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cu128-py312"
  ]
}

target "_files-tritonclient-cu128-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu128"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu128-py312" {
  inherits = ["_files-tritonclient-cu128-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu128-py312"
    "org.opencontainers.image.description" = "part tritonclient of stack cu128, for Python 3.12"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu128-py312"
  ]
}

target "_files-common-cu130-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu130-py312" {
  inherits = ["_files-common-cu130-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py312"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu130-py312"
  ]
}

target "_files-torch-cu130-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu130-py312" {
  inherits = ["_files-torch-cu130-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py312"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.14.1"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu130-py312"
  ]
}

target "_files-grpc-cu130-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu130-py312" {
  inherits = ["_files-grpc-cu130-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu130-py312"
    "org.opencontainers.image.description" = "part grpc of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu130-py312"
  ]
}

target "_files-tritonclient-cu130-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu130-py312" {
  inherits = ["_files-tritonclient-cu130-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu130-py312"
    "org.opencontainers.image.description" = "part tritonclient of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu130-py312"
  ]
}

target "_files-tensorrt-rtx-cu130-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu130"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu130-py312" {
  inherits = ["_files-tensorrt-rtx-cu130-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu130-py312"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu130, for Python 3.12"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu130-py312"
  ]
}

target "_files-common-cu132-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cu132"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu132-py312" {
  inherits = ["_files-common-cu132-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu132-py312"
    "org.opencontainers.image.description" = "part common of stack cu132, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu132-py312"
  ]
}

target "_files-torch-cu132-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cu132"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu132-py312" {
  inherits = ["_files-torch-cu132-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu132-py312"
    "org.opencontainers.image.description" = "part torch of stack cu132, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.15.0"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu132-py312"
  ]
}

target "_files-grpc-cu132-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu132"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu132-py312" {
  inherits = ["_files-grpc-cu132-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu132-py312"
    "org.opencontainers.image.description" = "part grpc of stack cu132, for Python 3.12"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu132-py312"
  ]
}

target "_files-tritonclient-cu132-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu132"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu132-py312" {
  inherits = ["_files-tritonclient-cu132-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu132-py312"
    "org.opencontainers.image.description" = "part tritonclient of stack cu132, for Python 3.12"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu132-py312"
  ]
}

target "_files-tensorrt-rtx-cu132-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu132"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu132-py312" {
  inherits = ["_files-tensorrt-rtx-cu132-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu132-py312"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu132, for Python 3.12"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu132-py312"
  ]
}

target "_files-common-cpu-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu-py312" {
  inherits = ["_files-common-cpu-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py312"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu-py312"
  ]
}

target "_files-torch-cpu-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu-py312" {
  inherits = ["_files-torch-cpu-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py312"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu-py312"
  ]
}

target "_files-grpc-cpu-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "grpc"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu-py312" {
  inherits = ["_files-grpc-cpu-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu-py312"
    "org.opencontainers.image.description" = "part grpc of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu-py312"
  ]
}

target "_files-tensorflow-cpu-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
    SLOT         = "03"
  }
}

target "part-tensorflow-cpu-py312" {
  inherits = ["_files-tensorflow-cpu-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py312"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tensorflow"                  = "2.21.0"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cpu-py312"
  ]
}

target "_files-tritonclient-cpu-py312" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_24_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cpu"
    PYTHON       = "3.12"
    WHEEL_PYTHON = "3.12"
    ACCELERATOR  = "cpu"
    SLOT         = "09"
  }
}

target "part-tritonclient-cpu-py312" {
  inherits = ["_files-tritonclient-cpu-py312"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cpu-py312"
    "org.opencontainers.image.description" = "part tritonclient of stack cpu, for Python 3.12"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.12"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cpu-py312"
  ]
}

target "_files-common-cu128-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu128-py314" {
  inherits = ["_files-common-cu128-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py314"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cu128-py314"
  ]
}

target "_files-torch-cu128-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu128-py314" {
  inherits = ["_files-torch-cu128-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py314"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.gpu.torch.amd64"             = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cu128-py314"
  ]
}

target "_files-grpc-cu128-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu128-py314" {
  inherits = ["_files-grpc-cu128-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu128-py314"
    "org.opencontainers.image.description" = "part grpc of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cu128-py314"
  ]
}

target "_files-tritonclient-cu128-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu128"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu128-py314" {
  inherits = ["_files-tritonclient-cu128-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu128-py314"
    "org.opencontainers.image.description" = "part tritonclient of stack cu128, for Python 3.14"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu128-py314"
  ]
}

target "_files-common-cu130-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu130-py314" {
  inherits = ["_files-common-cu130-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py314"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu130-py314"
  ]
}

target "_files-torch-cu130-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu130-py314" {
  inherits = ["_files-torch-cu130-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py314"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.14.1"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu130-py314"
  ]
}

target "_files-grpc-cu130-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu130-py314" {
  inherits = ["_files-grpc-cu130-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu130-py314"
    "org.opencontainers.image.description" = "part grpc of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu130-py314"
  ]
}

target "_files-tritonclient-cu130-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu130-py314" {
  inherits = ["_files-tritonclient-cu130-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu130-py314"
    "org.opencontainers.image.description" = "part tritonclient of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu130-py314"
  ]
}

target "_files-tensorrt-rtx-cu130-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu130"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu130-py314" {
  inherits = ["_files-tensorrt-rtx-cu130-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu130-py314"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu130, for Python 3.14"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu130-py314"
  ]
}

target "_files-common-cu132-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cu132"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu132-py314" {
  inherits = ["_files-common-cu132-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu132-py314"
    "org.opencontainers.image.description" = "part common of stack cu132, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu132-py314"
  ]
}

target "_files-torch-cu132-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cu132"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu132-py314" {
  inherits = ["_files-torch-cu132-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu132-py314"
    "org.opencontainers.image.description" = "part torch of stack cu132, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.15.0"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu132-py314"
  ]
}

target "_files-grpc-cu132-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "grpc"
    STACK        = "cu132"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu132-py314" {
  inherits = ["_files-grpc-cu132-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu132-py314"
    "org.opencontainers.image.description" = "part grpc of stack cu132, for Python 3.14"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu132-py314"
  ]
}

target "_files-tritonclient-cu132-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cu132"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu132-py314" {
  inherits = ["_files-tritonclient-cu132-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu132-py314"
    "org.opencontainers.image.description" = "part tritonclient of stack cu132, for Python 3.14"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu132-py314"
  ]
}

target "_files-tensorrt-rtx-cu132-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu132"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu132-py314" {
  inherits = ["_files-tensorrt-rtx-cu132-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu132-py314"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu132, for Python 3.14"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu132-py314"
  ]
}

target "_files-common-cpu-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu-py314" {
  inherits = ["_files-common-cpu-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py314"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu-py314"
  ]
}

target "_files-torch-cpu-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu-py314" {
  inherits = ["_files-torch-cpu-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py314"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu-py314"
  ]
}

target "_files-grpc-cpu-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "grpc"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu-py314" {
  inherits = ["_files-grpc-cpu-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu-py314"
    "org.opencontainers.image.description" = "part grpc of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu-py314"
  ]
}

target "_files-tritonclient-cpu-py314" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_UBUNTU_26_04 }
  args = {
    PART         = "tritonclient"
    STACK        = "cpu"
    PYTHON       = "3.14"
    WHEEL_PYTHON = "3.14"
    ACCELERATOR  = "cpu"
    SLOT         = "09"
  }
}

target "part-tritonclient-cpu-py314" {
  inherits = ["_files-tritonclient-cpu-py314"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cpu-py314"
    "org.opencontainers.image.description" = "part tritonclient of stack cpu, for Python 3.14"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.14"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cpu-py314"
  ]
}

target "_files-common-cu128-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu128-py311" {
  inherits = ["_files-common-cu128-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py311"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cu128-py311"
  ]
}

target "_files-torch-cu128-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu128-py311" {
  inherits = ["_files-torch-cu128-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py311"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.gpu.torch.amd64"             = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cu128-py311"
  ]
}

target "_files-grpc-cu128-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "grpc"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu128-py311" {
  inherits = ["_files-grpc-cu128-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu128-py311"
    "org.opencontainers.image.description" = "part grpc of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cu128-py311"
  ]
}

target "_files-tensorflow-cu128-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "03"
  }
}

target "part-tensorflow-cu128-py311" {
  inherits = ["_files-tensorflow-cu128-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py311"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.gpu.tensorflow.amd64"        = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cu128-py311"
  ]
}

target "_files-tritonclient-cu128-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tritonclient"
    STACK        = "cu128"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu128-py311" {
  inherits = ["_files-tritonclient-cu128-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu128-py311"
    "org.opencontainers.image.description" = "part tritonclient of stack cu128, for Python 3.11"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu128-py311"
  ]
}

target "_files-common-cu130-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu130-py311" {
  inherits = ["_files-common-cu130-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py311"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu130-py311"
  ]
}

target "_files-torch-cu130-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu130-py311" {
  inherits = ["_files-torch-cu130-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py311"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.14.1"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu130-py311"
  ]
}

target "_files-grpc-cu130-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "grpc"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu130-py311" {
  inherits = ["_files-grpc-cu130-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu130-py311"
    "org.opencontainers.image.description" = "part grpc of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu130-py311"
  ]
}

target "_files-tritonclient-cu130-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tritonclient"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu130-py311" {
  inherits = ["_files-tritonclient-cu130-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu130-py311"
    "org.opencontainers.image.description" = "part tritonclient of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu130-py311"
  ]
}

target "_files-tensorrt-rtx-cu130-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu130"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu130-py311" {
  inherits = ["_files-tensorrt-rtx-cu130-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu130-py311"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu130, for Python 3.11"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu130-py311"
  ]
}

target "_files-common-cu132-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cu132"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu132-py311" {
  inherits = ["_files-common-cu132-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu132-py311"
    "org.opencontainers.image.description" = "part common of stack cu132, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu132-py311"
  ]
}

target "_files-torch-cu132-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cu132"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu132-py311" {
  inherits = ["_files-torch-cu132-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu132-py311"
    "org.opencontainers.image.description" = "part torch of stack cu132, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.15.0"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu132-py311"
  ]
}

target "_files-grpc-cu132-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "grpc"
    STACK        = "cu132"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu132-py311" {
  inherits = ["_files-grpc-cu132-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu132-py311"
    "org.opencontainers.image.description" = "part grpc of stack cu132, for Python 3.11"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu132-py311"
  ]
}

target "_files-tritonclient-cu132-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tritonclient"
    STACK        = "cu132"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu132-py311" {
  inherits = ["_files-tritonclient-cu132-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu132-py311"
    "org.opencontainers.image.description" = "part tritonclient of stack cu132, for Python 3.11"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu132-py311"
  ]
}

target "_files-tensorrt-rtx-cu132-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu132"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu132-py311" {
  inherits = ["_files-tensorrt-rtx-cu132-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu132-py311"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu132, for Python 3.11"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu132-py311"
  ]
}

target "_files-common-cpu-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu-py311" {
  inherits = ["_files-common-cpu-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py311"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu-py311"
  ]
}

target "_files-torch-cpu-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu-py311" {
  inherits = ["_files-torch-cpu-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py311"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu-py311"
  ]
}

target "_files-grpc-cpu-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "grpc"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu-py311" {
  inherits = ["_files-grpc-cpu-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu-py311"
    "org.opencontainers.image.description" = "part grpc of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu-py311"
  ]
}

target "_files-tensorflow-cpu-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
    SLOT         = "03"
  }
}

target "part-tensorflow-cpu-py311" {
  inherits = ["_files-tensorflow-cpu-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py311"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tensorflow"                  = "2.21.0"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cpu-py311"
  ]
}

target "_files-tritonclient-cpu-py311" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_BOOKWORM }
  args = {
    PART         = "tritonclient"
    STACK        = "cpu"
    PYTHON       = "3.11"
    WHEEL_PYTHON = "3.11"
    ACCELERATOR  = "cpu"
    SLOT         = "09"
  }
}

target "part-tritonclient-cpu-py311" {
  inherits = ["_files-tritonclient-cpu-py311"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cpu-py311"
    "org.opencontainers.image.description" = "part tritonclient of stack cpu, for Python 3.11"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.11"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cpu-py311"
  ]
}

target "_files-common-cu128-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu128-py313" {
  inherits = ["_files-common-cu128-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu128-py313"
    "org.opencontainers.image.description" = "part common of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cu128-py313"
  ]
}

target "_files-torch-cu128-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu128-py313" {
  inherits = ["_files-torch-cu128-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu128-py313"
    "org.opencontainers.image.description" = "part torch of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.gpu.torch.amd64"             = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cu128-py313"
  ]
}

target "_files-grpc-cu128-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "grpc"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu128-py313" {
  inherits = ["_files-grpc-cu128-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu128-py313"
    "org.opencontainers.image.description" = "part grpc of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cu128-py313"
  ]
}

target "_files-tensorflow-cu128-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorflow"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "03"
  }
}

target "part-tensorflow-cu128-py313" {
  inherits = ["_files-tensorflow-cu128-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cu128-py313"
    "org.opencontainers.image.description" = "part tensorflow of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorflow"                  = "2.20.0"
    "io.rosml.gpu.tensorflow.amd64"        = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=cuda*,common,grpc,tensorflow-cc*,tensorflow ml=cuda*,common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cu128-py313"
  ]
}

target "_files-tritonclient-cu128-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tritonclient"
    STACK        = "cu128"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu128-py313" {
  inherits = ["_files-tritonclient-cu128-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu128-py313"
    "org.opencontainers.image.description" = "part tritonclient of stack cu128, for Python 3.13"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu128-py313"
  ]
}

target "_files-common-cu130-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu130-py313" {
  inherits = ["_files-common-cu130-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu130-py313"
    "org.opencontainers.image.description" = "part common of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu130-py313"
  ]
}

target "_files-torch-cu130-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu130-py313" {
  inherits = ["_files-torch-cu130-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu130-py313"
    "org.opencontainers.image.description" = "part torch of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.14.1"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu130-py313"
  ]
}

target "_files-grpc-cu130-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "grpc"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu130-py313" {
  inherits = ["_files-grpc-cu130-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu130-py313"
    "org.opencontainers.image.description" = "part grpc of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu130-py313"
  ]
}

target "_files-tritonclient-cu130-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tritonclient"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu130-py313" {
  inherits = ["_files-tritonclient-cu130-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu130-py313"
    "org.opencontainers.image.description" = "part tritonclient of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu130-py313"
  ]
}

target "_files-tensorrt-rtx-cu130-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu130"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu130-py313" {
  inherits = ["_files-tensorrt-rtx-cu130-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu130-py313"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu130, for Python 3.13"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu130-py313"
  ]
}

target "_files-common-cu132-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cu132"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "01"
    SHOWS        = "cuda"
  }
}

target "part-common-cu132-py313" {
  inherits = ["_files-common-cu132-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cu132-py313"
    "org.opencontainers.image.description" = "part common of stack cu132, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:common-cu132-py313"
  ]
}

target "_files-torch-cu132-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cu132"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "02"
  }
}

target "part-torch-cu132-py313" {
  inherits = ["_files-torch-cu132-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cu132-py313"
    "org.opencontainers.image.description" = "part torch of stack cu132, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.15.0"
    "io.rosml.gpu.torch.amd64"             = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"             = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=cuda*,common,torch"
  }
  tags = [
    "${REGISTRY}/part:torch-cu132-py313"
  ]
}

target "_files-grpc-cu132-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "grpc"
    STACK        = "cu132"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "08"
  }
}

target "part-grpc-cu132-py313" {
  inherits = ["_files-grpc-cu132-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cu132-py313"
    "org.opencontainers.image.description" = "part grpc of stack cu132, for Python 3.13"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
  }
  tags = [
    "${REGISTRY}/part:grpc-cu132-py313"
  ]
}

target "_files-tritonclient-cu132-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tritonclient"
    STACK        = "cu132"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "09"
  }
}

target "part-tritonclient-cu132-py313" {
  inherits = ["_files-tritonclient-cu132-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cu132-py313"
    "org.opencontainers.image.description" = "part tritonclient of stack cu132, for Python 3.13"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=cuda*,common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cu132-py313"
  ]
}

target "_files-tensorrt-rtx-cu132-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorrt-rtx"
    STACK        = "cu132"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cuda"
    SLOT         = "10"
    SHOWS        = "tensorrt-rtx-cc"
  }
}

target "part-tensorrt-rtx-cu132-py313" {
  inherits = ["_files-tensorrt-rtx-cu132-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorrt-rtx-cu132-py313"
    "org.opencontainers.image.description" = "part tensorrt-rtx of stack cu132, for Python 3.13"
    "io.rosml.part"                        = "tensorrt-rtx"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.brings"                      = "tensorrt-rtx:tensorrt-rtx:TensorRT-RTX"
    "io.rosml.release"                     = "tensorrt-rtx"
    "org.opencontainers.image.licenses"    = "LicenseRef-NVIDIA-Proprietary"
    "io.rosml.restricted"                  = "tensorrt-rtx"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "tensorrt-rtx=cuda*,common,tensorrt-rtx-cc*,tensorrt-rtx"
  }
  tags = [
    "${REGISTRY}/part:tensorrt-rtx-cu132-py313"
  ]
}

target "_files-common-cpu-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "common"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
    SLOT         = "01"
  }
}

target "part-common-cpu-py313" {
  inherits = ["_files-common-cpu-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "common-cpu-py313"
    "org.opencontainers.image.description" = "part common of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "common"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:common-cpu-py313"
  ]
}

target "_files-torch-cpu-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "torch"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
    SLOT         = "02"
  }
}

target "part-torch-cpu-py313" {
  inherits = ["_files-torch-cpu-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "torch-cpu-py313"
    "org.opencontainers.image.description" = "part torch of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "torch"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.torch"                       = "2.10.0"
    "io.rosml.brings"                      = "torch:torch:PyTorch"
    "io.rosml.release"                     = "torch"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSD-3-Clause AND BSL-1.0 AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.frameworks"                  = "torch=common,torch ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:torch-cpu-py313"
  ]
}

target "_files-grpc-cpu-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "grpc"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
    SLOT         = "08"
  }
}

target "part-grpc-cpu-py313" {
  inherits = ["_files-grpc-cpu-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "grpc-cpu-py313"
    "org.opencontainers.image.description" = "part grpc of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "grpc"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:grpc-cpu-py313"
  ]
}

target "_files-tensorflow-cpu-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tensorflow"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
    SLOT         = "03"
  }
}

target "part-tensorflow-cpu-py313" {
  inherits = ["_files-tensorflow-cpu-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tensorflow-cpu-py313"
    "org.opencontainers.image.description" = "part tensorflow of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "tensorflow"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tensorflow"                  = "2.21.0"
    "io.rosml.brings"                      = "tensorflow:tf:TensorFlow"
    "io.rosml.release"                     = "tensorflow"
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-2-Clause AND BSD-3-Clause AND MIT AND MPL-2.0 AND PSF-2.0"
    "io.rosml.frameworks"                  = "tensorflow=common,grpc,tensorflow-cc*,tensorflow ml=common,grpc,torch,tensorflow-cc*,tensorflow"
  }
  tags = [
    "${REGISTRY}/part:tensorflow-cpu-py313"
  ]
}

target "_files-tritonclient-cpu-py313" {
  inherits  = ["_files"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { os = OS_TRIXIE }
  args = {
    PART         = "tritonclient"
    STACK        = "cpu"
    PYTHON       = "3.13"
    WHEEL_PYTHON = "3.13"
    ACCELERATOR  = "cpu"
    SLOT         = "09"
  }
}

target "part-tritonclient-cpu-py313" {
  inherits = ["_files-tritonclient-cpu-py313"]
  target   = "part"
  labels = {
    "org.opencontainers.image.title"       = "tritonclient-cpu-py313"
    "org.opencontainers.image.description" = "part tritonclient of stack cpu, for Python 3.13"
    "io.rosml.part"                        = "tritonclient"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.python"                      = "3.13"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.brings"                      = "tritonclient:tritonclient:tritonclient"
    "io.rosml.release"                     = "tritonclient"
    "org.opencontainers.image.licenses"    = "BSD-3-Clause AND MIT"
    "io.rosml.frameworks"                  = ""
    "io.rosml.addons"                      = "triton=common,grpc,tritonclient"
  }
  tags = [
    "${REGISTRY}/part:tritonclient-cpu-py313"
  ]
}

# ---- What images with the same framework, stack and Python have in common -------------------------------------------

target "_cuda-cu128-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args      = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args      = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu121-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu121", "part", "_files-cuda-cu121")
    part-common = dependency("common-cu121-py38", "part", "_files-common-cu121-py38")
    part-torch  = dependency("torch-cu121-py38", "part", "_files-torch-cu121-py38")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu121"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu121-py38"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu121-py38"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.4.1"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_50 sm_60 sm_70 sm_75 sm_80 sm_86 sm_90"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.4.1
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cpu38-py38" {
  description = "cannot be built yet: no lock; run 'rosml locks' on a machine that reaches the package indexes, PyTorch's own among them"
  platforms   = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common = dependency("common-cpu38-py38", "part", "_files-common-cpu38-py38")
    part-torch  = dependency("torch-cpu38-py38", "part", "_files-torch-cpu38-py38")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu38-py38"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu38-py38"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.4.1"
    "io.rosml.stack"                    = "cpu38"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.4.1
  EOT
}

target "_tensorflow-cpu38-py38" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu38-py38", "part", "_files-common-cpu38-py38")
    part-grpc          = dependency("grpc-cpu38-py38", "part", "_files-grpc-cpu38-py38")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu38", "part", "_files-tensorflow-cc-cpu38")
    part-tensorflow    = dependency("tensorflow-cpu38-py38", "part", "_files-tensorflow-cpu38-py38")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu38-py38"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu38-py38"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu38"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu38-py38"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.13.1"
    "io.rosml.stack"                    = "cpu38"
    "io.rosml.parts"                    = "common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.13.1
  EOT
}

target "_cuda-cu128-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args      = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args      = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu128-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common = dependency("common-cu128-py310", "part", "_files-common-cu128-py310")
    part-torch  = dependency("torch-cu128-py310", "part", "_files-torch-cu128-py310")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu128-py310"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu128-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu130-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common = dependency("common-cu130-py310", "part", "_files-common-cu130-py310")
    part-torch  = dependency("torch-cu130-py310", "part", "_files-torch-cu130-py310")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu130-py310"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu130-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.14.1"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.14.1
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cpu-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common = dependency("common-cpu-py310", "part", "_files-common-cpu-py310")
    part-torch  = dependency("torch-cpu-py310", "part", "_files-torch-cpu-py310")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu-py310"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
  EOT
}

target "_tensorflow-cu128-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py310", "part", "_files-common-cu128-py310")
    part-grpc          = dependency("grpc-cu128-py310", "part", "_files-grpc-cu128-py310")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py310", "part", "_files-tensorflow-cu128-py310")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py310"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py310"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_tensorflow-cpu-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py310", "part", "_files-common-cpu-py310")
    part-grpc          = dependency("grpc-cpu-py310", "part", "_files-grpc-cpu-py310")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py310", "part", "_files-tensorflow-cpu-py310")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py310"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py310"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_ml-cu128-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py310", "part", "_files-common-cu128-py310")
    part-grpc          = dependency("grpc-cu128-py310", "part", "_files-grpc-cu128-py310")
    part-torch         = dependency("torch-cu128-py310", "part", "_files-torch-cu128-py310")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py310", "part", "_files-tensorflow-cu128-py310")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py310"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py310"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cu128-py310"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_ml-cpu-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py310", "part", "_files-common-cpu-py310")
    part-grpc          = dependency("grpc-cpu-py310", "part", "_files-grpc-cpu-py310")
    part-torch         = dependency("torch-cpu-py310", "part", "_files-torch-cpu-py310")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py310", "part", "_files-tensorflow-cpu-py310")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py310"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py310"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cpu-py310"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_cuda-cu128-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args      = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args      = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu128-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common = dependency("common-cu128-py312", "part", "_files-common-cu128-py312")
    part-torch  = dependency("torch-cu128-py312", "part", "_files-torch-cu128-py312")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu128-py312"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu128-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu130-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common = dependency("common-cu130-py312", "part", "_files-common-cu130-py312")
    part-torch  = dependency("torch-cu130-py312", "part", "_files-torch-cu130-py312")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu130-py312"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu130-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.14.1"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.14.1
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cu132-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common = dependency("common-cu132-py312", "part", "_files-common-cu132-py312")
    part-torch  = dependency("torch-cu132-py312", "part", "_files-torch-cu132-py312")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu132-py312"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu132-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.15.0"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.15.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cpu-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common = dependency("common-cpu-py312", "part", "_files-common-cpu-py312")
    part-torch  = dependency("torch-cpu-py312", "part", "_files-torch-cpu-py312")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu-py312"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
  EOT
}

target "_tensorflow-cu128-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py312", "part", "_files-common-cu128-py312")
    part-grpc          = dependency("grpc-cu128-py312", "part", "_files-grpc-cu128-py312")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py312", "part", "_files-tensorflow-cu128-py312")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py312"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py312"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_tensorflow-cpu-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py312", "part", "_files-common-cpu-py312")
    part-grpc          = dependency("grpc-cpu-py312", "part", "_files-grpc-cpu-py312")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py312", "part", "_files-tensorflow-cpu-py312")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py312"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py312"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_ml-cu128-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py312", "part", "_files-common-cu128-py312")
    part-grpc          = dependency("grpc-cu128-py312", "part", "_files-grpc-cu128-py312")
    part-torch         = dependency("torch-cu128-py312", "part", "_files-torch-cu128-py312")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py312", "part", "_files-tensorflow-cu128-py312")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py312"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py312"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cu128-py312"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_ml-cpu-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py312", "part", "_files-common-cpu-py312")
    part-grpc          = dependency("grpc-cpu-py312", "part", "_files-grpc-cpu-py312")
    part-torch         = dependency("torch-cpu-py312", "part", "_files-torch-cpu-py312")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py312", "part", "_files-tensorflow-cpu-py312")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py312"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py312"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cpu-py312"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_cuda-cu128-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args      = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args      = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu128-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common = dependency("common-cu128-py314", "part", "_files-common-cu128-py314")
    part-torch  = dependency("torch-cu128-py314", "part", "_files-torch-cu128-py314")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu128-py314"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu128-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu130-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common = dependency("common-cu130-py314", "part", "_files-common-cu130-py314")
    part-torch  = dependency("torch-cu130-py314", "part", "_files-torch-cu130-py314")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu130-py314"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu130-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.14.1"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.14.1
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cu132-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common = dependency("common-cu132-py314", "part", "_files-common-cu132-py314")
    part-torch  = dependency("torch-cu132-py314", "part", "_files-torch-cu132-py314")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu132-py314"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu132-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.15.0"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.15.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cpu-py314" {
  description = "cannot be built yet: no lock; run 'rosml locks' on a machine that reaches the package indexes, PyTorch's own among them"
  platforms   = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common = dependency("common-cpu-py314", "part", "_files-common-cpu-py314")
    part-torch  = dependency("torch-cpu-py314", "part", "_files-torch-cpu-py314")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu-py314"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
  EOT
}

target "_cuda-cu128-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py311" {
  contexts = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args     = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py311" {
  contexts = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args     = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu128-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common = dependency("common-cu128-py311", "part", "_files-common-cu128-py311")
    part-torch  = dependency("torch-cu128-py311", "part", "_files-torch-cu128-py311")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu128-py311"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu128-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu130-py311" {
  contexts = {
    part-cuda   = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common = dependency("common-cu130-py311", "part", "_files-common-cu130-py311")
    part-torch  = dependency("torch-cu130-py311", "part", "_files-torch-cu130-py311")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu130-py311"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu130-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.14.1"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.14.1
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cu132-py311" {
  contexts = {
    part-cuda   = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common = dependency("common-cu132-py311", "part", "_files-common-cu132-py311")
    part-torch  = dependency("torch-cu132-py311", "part", "_files-torch-cu132-py311")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu132-py311"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu132-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.15.0"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.15.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cpu-py311" {
  description = "cannot be built yet: no lock; run 'rosml locks' on a machine that reaches the package indexes, PyTorch's own among them"
  contexts = {
    part-common = dependency("common-cpu-py311", "part", "_files-common-cpu-py311")
    part-torch  = dependency("torch-cpu-py311", "part", "_files-torch-cpu-py311")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu-py311"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
  EOT
}

target "_tensorflow-cu128-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py311", "part", "_files-common-cu128-py311")
    part-grpc          = dependency("grpc-cu128-py311", "part", "_files-grpc-cu128-py311")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py311", "part", "_files-tensorflow-cu128-py311")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py311"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py311"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_tensorflow-cpu-py311" {
  contexts = {
    part-common        = dependency("common-cpu-py311", "part", "_files-common-cpu-py311")
    part-grpc          = dependency("grpc-cpu-py311", "part", "_files-grpc-cpu-py311")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py311", "part", "_files-tensorflow-cpu-py311")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py311"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py311"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_ml-cu128-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py311", "part", "_files-common-cu128-py311")
    part-grpc          = dependency("grpc-cu128-py311", "part", "_files-grpc-cu128-py311")
    part-torch         = dependency("torch-cu128-py311", "part", "_files-torch-cu128-py311")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py311", "part", "_files-tensorflow-cu128-py311")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py311"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py311"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cu128-py311"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_ml-cpu-py311" {
  description = "cannot be built yet: no lock; run 'rosml locks' on a machine that reaches the package indexes, PyTorch's own among them"
  contexts = {
    part-common        = dependency("common-cpu-py311", "part", "_files-common-cpu-py311")
    part-grpc          = dependency("grpc-cpu-py311", "part", "_files-grpc-cpu-py311")
    part-torch         = dependency("torch-cpu-py311", "part", "_files-torch-cpu-py311")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py311", "part", "_files-tensorflow-cpu-py311")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py311"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py311"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cpu-py311"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_cuda-cu128-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu128", "part", "_files-cuda-cu128") }
  args      = { CUDA_ROOT = can(digests["cuda-cu128"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_cuda-cu130-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu130", "part", "_files-cuda-cu130") }
  args      = { CUDA_ROOT = can(digests["cuda-cu130"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu132-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu132", "part", "_files-cuda-cu132") }
  args      = { CUDA_ROOT = can(digests["cuda-cu132"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_cuda-cu121-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { part-cuda = dependency("cuda-cu121", "part", "_files-cuda-cu121") }
  args      = { CUDA_ROOT = can(digests["cuda-cu121"]) ? "/" : "/out/" }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary"
    "io.rosml.framework"                = "cuda"
    "io.rosml.cuda"                     = "12.1.105"
    "io.rosml.cudnn"                    = "9.1.0.70"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.stack"                    = "cu121"
    "io.rosml.parts"                    = "cuda"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ENV CUDA_VERSION=12.1.105
    ENV CUDNN_VERSION=9.1.0.70
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu128-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common = dependency("common-cu128-py313", "part", "_files-common-cu128-py313")
    part-torch  = dependency("torch-cu128-py313", "part", "_files-torch-cu128-py313")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu128-py313"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu128-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_torch-cu130-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common = dependency("common-cu130-py313", "part", "_files-common-cu130-py313")
    part-torch  = dependency("torch-cu130-py313", "part", "_files-torch-cu130-py313")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu130-py313"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu130-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.14.1"
    "io.rosml.cuda"                     = "13.0.96"
    "io.rosml.cudnn"                    = "9.24.0.43"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu130"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.14.1
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cu132-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-cuda   = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common = dependency("common-cu132-py313", "part", "_files-common-cu132-py313")
    part-torch  = dependency("torch-cu132-py313", "part", "_files-torch-cu132-py313")
  }
  args = {
    CUDA_ROOT   = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT = can(digests["common-cu132-py313"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cu132-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.15.0"
    "io.rosml.cuda"                     = "13.2.86"
    "io.rosml.cudnn"                    = "9.26.0.51"
    "io.rosml.gpu.driver"               = "580"
    "io.rosml.gpu.torch.amd64"          = "sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.torch.arm64"          = "sm_80 sm_90 sm_100 sm_110 sm_120"
    "io.rosml.stack"                    = "cu132"
    "io.rosml.parts"                    = "cuda common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.15.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_torch-cpu-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common = dependency("common-cpu-py313", "part", "_files-common-cpu-py313")
    part-torch  = dependency("torch-cpu-py313", "part", "_files-torch-cpu-py313")
  }
  args = {
    COMMON_ROOT = can(digests["common-cpu-py313"]) ? "/" : "/out/"
    TORCH_ROOT  = can(digests["torch-cpu-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0"
    "io.rosml.framework"                = "torch"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common torch"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ENV TORCH_VERSION=2.10.0
  EOT
}

target "_tensorflow-cu128-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py313", "part", "_files-common-cu128-py313")
    part-grpc          = dependency("grpc-cu128-py313", "part", "_files-grpc-cu128-py313")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py313", "part", "_files-tensorflow-cu128-py313")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py313"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py313"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_tensorflow-cpu-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py313", "part", "_files-common-cpu-py313")
    part-grpc          = dependency("grpc-cpu-py313", "part", "_files-grpc-cpu-py313")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py313", "part", "_files-tensorflow-cpu-py313")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py313"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py313"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND BSD-2-Clause AND MPL-2.0"
    "io.rosml.framework"                = "tensorflow"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_ml-cu128-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    part-cuda          = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common        = dependency("common-cu128-py313", "part", "_files-common-cu128-py313")
    part-grpc          = dependency("grpc-cu128-py313", "part", "_files-grpc-cu128-py313")
    part-torch         = dependency("torch-cu128-py313", "part", "_files-torch-cu128-py313")
    part-tensorflow-cc = dependency("tensorflow-cc-cu128", "part", "_files-tensorflow-cc-cu128")
    part-tensorflow    = dependency("tensorflow-cu128-py313", "part", "_files-tensorflow-cu128-py313")
  }
  args = {
    CUDA_ROOT          = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT        = can(digests["common-cu128-py313"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cu128-py313"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cu128-py313"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cu128"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cu128-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.20.0"
    "io.rosml.cuda"                     = "12.8.90"
    "io.rosml.cudnn"                    = "9.10.2.21"
    "io.rosml.gpu.driver"               = "525"
    "io.rosml.gpu.torch.amd64"          = "sm_70 sm_75 sm_80 sm_86 sm_90 sm_100 sm_120"
    "io.rosml.gpu.tensorflow.amd64"     = "sm_60 sm_70 sm_80 sm_89 compute_90"
    "io.rosml.stack"                    = "cu128"
    "io.rosml.parts"                    = "cuda common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.20.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_ml-cpu-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    part-common        = dependency("common-cpu-py313", "part", "_files-common-cpu-py313")
    part-grpc          = dependency("grpc-cpu-py313", "part", "_files-grpc-cpu-py313")
    part-torch         = dependency("torch-cpu-py313", "part", "_files-torch-cpu-py313")
    part-tensorflow-cc = dependency("tensorflow-cc-cpu", "part", "_files-tensorflow-cc-cpu")
    part-tensorflow    = dependency("tensorflow-cpu-py313", "part", "_files-tensorflow-cpu-py313")
  }
  args = {
    COMMON_ROOT        = can(digests["common-cpu-py313"]) ? "/" : "/out/"
    GRPC_ROOT          = can(digests["grpc-cpu-py313"]) ? "/" : "/out/"
    TORCH_ROOT         = can(digests["torch-cpu-py313"]) ? "/" : "/out/"
    TENSORFLOW_CC_ROOT = can(digests["tensorflow-cc-cpu"]) ? "/" : "/out/"
    TENSORFLOW_ROOT    = can(digests["tensorflow-cpu-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0 AND Apache-2.0 WITH LLVM-exception AND BSD-2-Clause AND BSL-1.0 AND MPL-2.0"
    "io.rosml.framework"                = "ml"
    "io.rosml.torch"                    = "2.10.0"
    "io.rosml.tensorflow"               = "2.21.0"
    "io.rosml.stack"                    = "cpu"
    "io.rosml.parts"                    = "common grpc torch tensorflow-cc tensorflow"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TORCH_ROOT
    COPY --link --from=part-torch $TORCH_ROOT /
    ARG TENSORFLOW_CC_ROOT
    COPY --link --from=part-tensorflow-cc $TENSORFLOW_CC_ROOT /
    ARG TENSORFLOW_ROOT
    COPY --link --from=part-tensorflow $TENSORFLOW_ROOT /
    ENV TORCH_VERSION=2.10.0
    ENV TENSORFLOW_VERSION=2.21.0
  EOT
}

target "_none-triton-cu128-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros               = dependency("humble-core", "ros", "humble-core")
    part-cuda         = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common       = dependency("common-cu128-py310", "part", "_files-common-cu128-py310")
    part-grpc         = dependency("grpc-cu128-py310", "part", "_files-grpc-cu128-py310")
    part-tritonclient = dependency("tritonclient-cu128-py310", "part", "_files-tritonclient-cu128-py310")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu128-py310"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu128-py310"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu128-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "org.opencontainers.image.title"       = "humble-core-triton-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), tritonclient 2.73.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_none-triton-cu128-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros               = dependency("jazzy-core", "ros", "jazzy-core")
    part-cuda         = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common       = dependency("common-cu128-py312", "part", "_files-common-cu128-py312")
    part-grpc         = dependency("grpc-cu128-py312", "part", "_files-grpc-cu128-py312")
    part-tritonclient = dependency("tritonclient-cu128-py312", "part", "_files-tritonclient-cu128-py312")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu128-py312"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu128-py312"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu128-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "org.opencontainers.image.title"       = "jazzy-core-triton-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), tritonclient 2.73.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_none-triton-cu128-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros               = dependency("lyrical-core", "ros", "lyrical-core")
    part-cuda         = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common       = dependency("common-cu128-py314", "part", "_files-common-cu128-py314")
    part-grpc         = dependency("grpc-cu128-py314", "part", "_files-grpc-cu128-py314")
    part-tritonclient = dependency("tritonclient-cu128-py314", "part", "_files-tritonclient-cu128-py314")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu128-py314"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu128-py314"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu128-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "org.opencontainers.image.title"       = "lyrical-core-triton-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), tritonclient 2.73.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-cu128-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_none-triton-cu128-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-cuda         = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common       = dependency("common-cu128-py311", "part", "_files-common-cu128-py311")
    part-grpc         = dependency("grpc-cu128-py311", "part", "_files-grpc-cu128-py311")
    part-tritonclient = dependency("tritonclient-cu128-py311", "part", "_files-tritonclient-cu128-py311")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu128-py311"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu128-py311"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu128-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-triton-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), tritonclient 2.73.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu128-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_none-triton-cu128-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-cuda         = dependency("cuda-cu128", "part", "_files-cuda-cu128")
    part-common       = dependency("common-cu128-py313", "part", "_files-common-cu128-py313")
    part-grpc         = dependency("grpc-cu128-py313", "part", "_files-grpc-cu128-py313")
    part-tritonclient = dependency("tritonclient-cu128-py313", "part", "_files-tritonclient-cu128-py313")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu128"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu128-py313"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu128-py313"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu128-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "12.8.90"
    "io.rosml.cudnn"                       = "9.10.2.21"
    "io.rosml.gpu.driver"                  = "525"
    "org.opencontainers.image.title"       = "ros1-trixie-core-triton-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), tritonclient 2.73.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu128-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu128"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=12.8.90
    ENV CUDNN_VERSION=9.10.2.21
    ENV NVIDIA_REQUIRE_CUDA=cuda>=12.0
  EOT
}

target "_none-triton-cu130-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("humble-core", "ros", "humble-core")
    part-cuda         = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common       = dependency("common-cu130-py310", "part", "_files-common-cu130-py310")
    part-grpc         = dependency("grpc-cu130-py310", "part", "_files-grpc-cu130-py310")
    part-tritonclient = dependency("tritonclient-cu130-py310", "part", "_files-tritonclient-cu130-py310")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu130-py310"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu130-py310"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu130-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "humble-core-triton-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), tritonclient 2.73.0, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu130-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("jazzy-core", "ros", "jazzy-core")
    part-cuda         = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common       = dependency("common-cu130-py312", "part", "_files-common-cu130-py312")
    part-grpc         = dependency("grpc-cu130-py312", "part", "_files-grpc-cu130-py312")
    part-tritonclient = dependency("tritonclient-cu130-py312", "part", "_files-tritonclient-cu130-py312")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu130-py312"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu130-py312"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu130-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "jazzy-core-triton-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), tritonclient 2.73.0, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu130-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("lyrical-core", "ros", "lyrical-core")
    part-cuda         = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common       = dependency("common-cu130-py314", "part", "_files-common-cu130-py314")
    part-grpc         = dependency("grpc-cu130-py314", "part", "_files-grpc-cu130-py314")
    part-tritonclient = dependency("tritonclient-cu130-py314", "part", "_files-tritonclient-cu130-py314")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu130-py314"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu130-py314"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu130-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "lyrical-core-triton-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), tritonclient 2.73.0, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu130-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-cuda         = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common       = dependency("common-cu130-py311", "part", "_files-common-cu130-py311")
    part-grpc         = dependency("grpc-cu130-py311", "part", "_files-grpc-cu130-py311")
    part-tritonclient = dependency("tritonclient-cu130-py311", "part", "_files-tritonclient-cu130-py311")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu130-py311"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu130-py311"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu130-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-triton-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), tritonclient 2.73.0, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu130-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu130-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-cuda         = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common       = dependency("common-cu130-py313", "part", "_files-common-cu130-py313")
    part-grpc         = dependency("grpc-cu130-py313", "part", "_files-grpc-cu130-py313")
    part-tritonclient = dependency("tritonclient-cu130-py313", "part", "_files-tritonclient-cu130-py313")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu130-py313"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu130-py313"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu130-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-trixie-core-triton-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), tritonclient 2.73.0, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu130-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu132-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("humble-core", "ros", "humble-core")
    part-cuda         = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common       = dependency("common-cu132-py310", "part", "_files-common-cu132-py310")
    part-grpc         = dependency("grpc-cu132-py310", "part", "_files-grpc-cu132-py310")
    part-tritonclient = dependency("tritonclient-cu132-py310", "part", "_files-tritonclient-cu132-py310")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu132-py310"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu132-py310"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu132-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "humble-core-triton-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (humble), tritonclient 2.73.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-core-cu132-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu132-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("jazzy-core", "ros", "jazzy-core")
    part-cuda         = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common       = dependency("common-cu132-py312", "part", "_files-common-cu132-py312")
    part-grpc         = dependency("grpc-cu132-py312", "part", "_files-grpc-cu132-py312")
    part-tritonclient = dependency("tritonclient-cu132-py312", "part", "_files-tritonclient-cu132-py312")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu132-py312"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu132-py312"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu132-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "jazzy-core-triton-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), tritonclient 2.73.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-cu132-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu132-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("lyrical-core", "ros", "lyrical-core")
    part-cuda         = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common       = dependency("common-cu132-py314", "part", "_files-common-cu132-py314")
    part-grpc         = dependency("grpc-cu132-py314", "part", "_files-grpc-cu132-py314")
    part-tritonclient = dependency("tritonclient-cu132-py314", "part", "_files-tritonclient-cu132-py314")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu132-py314"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu132-py314"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu132-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "lyrical-core-triton-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), tritonclient 2.73.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-cu132-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu132-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-cuda         = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common       = dependency("common-cu132-py311", "part", "_files-common-cu132-py311")
    part-grpc         = dependency("grpc-cu132-py311", "part", "_files-grpc-cu132-py311")
    part-tritonclient = dependency("tritonclient-cu132-py311", "part", "_files-tritonclient-cu132-py311")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu132-py311"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu132-py311"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu132-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-triton-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), tritonclient 2.73.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu132-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cu132-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-cuda         = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common       = dependency("common-cu132-py313", "part", "_files-common-cu132-py313")
    part-grpc         = dependency("grpc-cu132-py313", "part", "_files-grpc-cu132-py313")
    part-tritonclient = dependency("tritonclient-cu132-py313", "part", "_files-tritonclient-cu132-py313")
  }
  args = {
    CUDA_ROOT         = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT       = can(digests["common-cu132-py313"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cu132-py313"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cu132-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-trixie-core-triton-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), tritonclient 2.73.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu132-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-triton-cpu-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("humble-core", "ros", "humble-core")
    part-common       = dependency("common-cpu-py310", "part", "_files-common-cpu-py310")
    part-grpc         = dependency("grpc-cpu-py310", "part", "_files-grpc-cpu-py310")
    part-tritonclient = dependency("tritonclient-cpu-py310", "part", "_files-tritonclient-cpu-py310")
  }
  args = {
    COMMON_ROOT       = can(digests["common-cpu-py310"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cpu-py310"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cpu-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "org.opencontainers.image.title"       = "humble-core-triton-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), tritonclient 2.73.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.parts"                       = "common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
  EOT
}

target "_none-triton-cpu-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("jazzy-core", "ros", "jazzy-core")
    part-common       = dependency("common-cpu-py312", "part", "_files-common-cpu-py312")
    part-grpc         = dependency("grpc-cpu-py312", "part", "_files-grpc-cpu-py312")
    part-tritonclient = dependency("tritonclient-cpu-py312", "part", "_files-tritonclient-cpu-py312")
  }
  args = {
    COMMON_ROOT       = can(digests["common-cpu-py312"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cpu-py312"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cpu-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "org.opencontainers.image.title"       = "jazzy-core-triton-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), tritonclient 2.73.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.parts"                       = "common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
  EOT
}

target "_none-triton-cpu-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("lyrical-core", "ros", "lyrical-core")
    part-common       = dependency("common-cpu-py314", "part", "_files-common-cpu-py314")
    part-grpc         = dependency("grpc-cpu-py314", "part", "_files-grpc-cpu-py314")
    part-tritonclient = dependency("tritonclient-cpu-py314", "part", "_files-tritonclient-cpu-py314")
  }
  args = {
    COMMON_ROOT       = can(digests["common-cpu-py314"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cpu-py314"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cpu-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "org.opencontainers.image.title"       = "lyrical-core-triton-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), tritonclient 2.73.0"
    "org.opencontainers.image.version"     = "lyrical-core-cpu-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.parts"                       = "common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
  EOT
}

target "_none-triton-cpu-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-common       = dependency("common-cpu-py311", "part", "_files-common-cpu-py311")
    part-grpc         = dependency("grpc-cpu-py311", "part", "_files-grpc-cpu-py311")
    part-tritonclient = dependency("tritonclient-cpu-py311", "part", "_files-tritonclient-cpu-py311")
  }
  args = {
    COMMON_ROOT       = can(digests["common-cpu-py311"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cpu-py311"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cpu-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-triton-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), tritonclient 2.73.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cpu-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.parts"                       = "common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
  EOT
}

target "_none-triton-cpu-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts = {
    ros               = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-common       = dependency("common-cpu-py313", "part", "_files-common-cpu-py313")
    part-grpc         = dependency("grpc-cpu-py313", "part", "_files-grpc-cpu-py313")
    part-tritonclient = dependency("tritonclient-cpu-py313", "part", "_files-tritonclient-cpu-py313")
  }
  args = {
    COMMON_ROOT       = can(digests["common-cpu-py313"]) ? "/" : "/out/"
    GRPC_ROOT         = can(digests["grpc-cpu-py313"]) ? "/" : "/out/"
    TRITONCLIENT_ROOT = can(digests["tritonclient-cpu-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.framework"                   = "none"
    "io.rosml.tritonclient"                = "2.73.0"
    "org.opencontainers.image.title"       = "ros1-trixie-core-triton-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), tritonclient 2.73.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cpu-tritonclient2.73.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cpu"
    "io.rosml.parts"                       = "common grpc tritonclient"
    "io.rosml.addons"                      = "triton"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG GRPC_ROOT
    COPY --link --from=part-grpc $GRPC_ROOT /
    ARG TRITONCLIENT_ROOT
    COPY --link --from=part-tritonclient $TRITONCLIENT_ROOT /
    ENV TRITONCLIENT_VERSION=2.73.0
  EOT
}

target "_none-tensorrt-rtx-cu130-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("humble-core", "ros", "humble-core")
    part-cuda            = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common          = dependency("common-cu130-py310", "part", "_files-common-cu130-py310")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu130", "part", "_files-tensorrt-rtx-cc-cu130")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu130-py310", "part", "_files-tensorrt-rtx-cu130-py310")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu130-py310"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu130"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu130-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "humble-core-tensorrt-rtx-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorRT-RTX 1.7.1.116, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu130-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("jazzy-core", "ros", "jazzy-core")
    part-cuda            = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common          = dependency("common-cu130-py312", "part", "_files-common-cu130-py312")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu130", "part", "_files-tensorrt-rtx-cc-cu130")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu130-py312", "part", "_files-tensorrt-rtx-cu130-py312")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu130-py312"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu130"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu130-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "jazzy-core-tensorrt-rtx-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorRT-RTX 1.7.1.116, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu130-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("lyrical-core", "ros", "lyrical-core")
    part-cuda            = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common          = dependency("common-cu130-py314", "part", "_files-common-cu130-py314")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu130", "part", "_files-tensorrt-rtx-cc-cu130")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu130-py314", "part", "_files-tensorrt-rtx-cu130-py314")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu130-py314"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu130"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu130-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "lyrical-core-tensorrt-rtx-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), TensorRT-RTX 1.7.1.116, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu130-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-cuda            = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common          = dependency("common-cu130-py311", "part", "_files-common-cu130-py311")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu130", "part", "_files-tensorrt-rtx-cc-cu130")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu130-py311", "part", "_files-tensorrt-rtx-cu130-py311")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu130-py311"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu130"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu130-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-tensorrt-rtx-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), TensorRT-RTX 1.7.1.116, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu130-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu130-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-cuda            = dependency("cuda-cu130", "part", "_files-cuda-cu130")
    part-common          = dependency("common-cu130-py313", "part", "_files-common-cu130-py313")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu130", "part", "_files-tensorrt-rtx-cc-cu130")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu130-py313", "part", "_files-tensorrt-rtx-cu130-py313")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu130"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu130-py313"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu130"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu130-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.0.96"
    "io.rosml.cudnn"                       = "9.24.0.43"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-trixie-core-tensorrt-rtx-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), TensorRT-RTX 1.7.1.116, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu130-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu130"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.0.96
    ENV CUDNN_VERSION=9.24.0.43
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu132-py310" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("humble-core", "ros", "humble-core")
    part-cuda            = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common          = dependency("common-cu132-py310", "part", "_files-common-cu132-py310")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu132", "part", "_files-tensorrt-rtx-cc-cu132")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu132-py310", "part", "_files-tensorrt-rtx-cu132-py310")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu132-py310"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu132"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu132-py310"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "humble-core-tensorrt-rtx-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorRT-RTX 1.7.1.116, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-core-cu132-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu132-py312" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("jazzy-core", "ros", "jazzy-core")
    part-cuda            = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common          = dependency("common-cu132-py312", "part", "_files-common-cu132-py312")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu132", "part", "_files-tensorrt-rtx-cc-cu132")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu132-py312", "part", "_files-tensorrt-rtx-cu132-py312")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu132-py312"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu132"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu132-py312"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "jazzy-core-tensorrt-rtx-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorRT-RTX 1.7.1.116, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-cu132-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu132-py314" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("lyrical-core", "ros", "lyrical-core")
    part-cuda            = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common          = dependency("common-cu132-py314", "part", "_files-common-cu132-py314")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu132", "part", "_files-tensorrt-rtx-cc-cu132")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu132-py314", "part", "_files-tensorrt-rtx-cu132-py314")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu132-py314"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu132"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu132-py314"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "lyrical-core-tensorrt-rtx-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), TensorRT-RTX 1.7.1.116, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-cu132-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu132-py311" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core")
    part-cuda            = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common          = dependency("common-cu132-py311", "part", "_files-common-cu132-py311")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu132", "part", "_files-tensorrt-rtx-cc-cu132")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu132-py311", "part", "_files-tensorrt-rtx-cu132-py311")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu132-py311"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu132"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu132-py311"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-bookworm-core-tensorrt-rtx-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), TensorRT-RTX 1.7.1.116, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu132-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

target "_none-tensorrt-rtx-cu132-py313" {
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts = {
    ros                  = dependency("ros1-trixie-core", "ros", "ros1-trixie-core")
    part-cuda            = dependency("cuda-cu132", "part", "_files-cuda-cu132")
    part-common          = dependency("common-cu132-py313", "part", "_files-common-cu132-py313")
    part-tensorrt-rtx-cc = dependency("tensorrt-rtx-cc-cu132", "part", "_files-tensorrt-rtx-cc-cu132")
    part-tensorrt-rtx    = dependency("tensorrt-rtx-cu132-py313", "part", "_files-tensorrt-rtx-cu132-py313")
  }
  args = {
    CUDA_ROOT            = can(digests["cuda-cu132"]) ? "/" : "/out/"
    COMMON_ROOT          = can(digests["common-cu132-py313"]) ? "/" : "/out/"
    TENSORRT_RTX_CC_ROOT = can(digests["tensorrt-rtx-cc-cu132"]) ? "/" : "/out/"
    TENSORRT_RTX_ROOT    = can(digests["tensorrt-rtx-cu132-py313"]) ? "/" : "/out/"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0 AND LicenseRef-NVIDIA-Proprietary AND BSD-3-Clause AND MIT AND MIT-CMU AND PSF-2.0"
    "io.rosml.restricted"                  = "tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.framework"                   = "none"
    "io.rosml.tensorrt-rtx"                = "1.7.1.116"
    "io.rosml.cuda"                        = "13.2.86"
    "io.rosml.cudnn"                       = "9.26.0.51"
    "io.rosml.gpu.driver"                  = "580"
    "org.opencontainers.image.title"       = "ros1-trixie-core-tensorrt-rtx-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), TensorRT-RTX 1.7.1.116, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu132-tensorrt-rtx1.7.1.116"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
    "io.rosml.stack"                       = "cu132"
    "io.rosml.parts"                       = "cuda common tensorrt-rtx-cc tensorrt-rtx"
    "io.rosml.addons"                      = "tensorrt-rtx"
  }
  dockerfile-inline = <<-EOT
    FROM ros
    ARG CUDA_ROOT
    COPY --link --from=part-cuda $CUDA_ROOT /
    ARG COMMON_ROOT
    COPY --link --from=part-common $COMMON_ROOT /
    ARG TENSORRT_RTX_CC_ROOT
    COPY --link --from=part-tensorrt-rtx-cc $TENSORRT_RTX_CC_ROOT /
    ARG TENSORRT_RTX_ROOT
    COPY --link --from=part-tensorrt-rtx $TENSORRT_RTX_ROOT /
    ENV TENSORRT_RTX_VERSION=1.7.1.116
    ENV CUDA_VERSION=13.2.86
    ENV CUDNN_VERSION=9.26.0.51
    ENV NVIDIA_REQUIRE_CUDA=cuda>=13.0
  EOT
}

# ---- noetic ---------------------------------------------------------------------------------------------------------

target "_noetic" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_20_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_20_04)[1], null)
    "io.rosml.distribution"                = "noetic"
    "io.rosml.os"                          = "ubuntu-20.04"
    "io.rosml.python"                      = "3.8"
    "io.rosml.ros"                         = "1"
    "io.rosml.ros.sync"                    = try(sync_dates["noetic"], null)
  }
}

target "_noetic-ros" {
  inherits  = ["_noetic"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "noetic"
    ROS_VERSION          = "1"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "final" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "focal"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/noetic/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros-testing/ubuntu"
    ROS_SYNC_DATE        = try(sync_dates["noetic"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "noetic-core" {
  inherits = ["_noetic-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-core"
  ]
}

target "noetic-base" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-core", "ros", "noetic-core") }
  args     = { ROS_PACKAGES = "ros-noetic-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base"
    "org.opencontainers.image.description" = "ROS 1 base (noetic)"
    "org.opencontainers.image.version"     = "noetic-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-base",
    "${REGISTRY}/ros:noetic"
  ]
}

target "noetic-robot" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-base", "ros", "noetic-base") }
  args     = { ROS_PACKAGES = "ros-noetic-robot" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic)"
    "org.opencontainers.image.version"     = "noetic-robot"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-robot"
  ]
}

target "noetic-perception" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-robot", "ros", "noetic-robot") }
  args     = { ROS_PACKAGES = "ros-noetic-perception" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic)"
    "org.opencontainers.image.version"     = "noetic-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-perception"
  ]
}

target "noetic-desktop" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-perception", "ros", "noetic-perception") }
  args     = { ROS_PACKAGES = "ros-noetic-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic)"
    "org.opencontainers.image.version"     = "noetic-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-desktop"
  ]
}

target "noetic-desktop-full" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-desktop", "ros", "noetic-desktop") }
  args     = { ROS_PACKAGES = "ros-noetic-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic)"
    "org.opencontainers.image.version"     = "noetic-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-desktop-full"
  ]
}

target "noetic-core-run" {
  inherits = ["_noetic-ros"]
  contexts = { parent = "target:_os-ubuntu-20-04-run" }
  args = {
    ROS_PACKAGES = "ros-noetic-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic)"
    "org.opencontainers.image.version"     = "noetic-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-core-run"
  ]
}

target "noetic-base-run" {
  inherits = ["_noetic-ros"]
  contexts = { parent = dependency("noetic-core-run", "ros", "noetic-core-run") }
  args = {
    ROS_PACKAGES = "ros-noetic-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic)"
    "org.opencontainers.image.version"     = "noetic-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:noetic-base-run"
  ]
}

target "noetic-core-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-cu128",
    "${REGISTRY}/ros-cuda:noetic-core-cu128-cuda12.8.90"
  ]
}

target "noetic-base-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-cu128",
    "${REGISTRY}/ros-cuda:noetic-base-cu128-cuda12.8.90"
  ]
}

target "noetic-robot-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-robot-cu128",
    "${REGISTRY}/ros-cuda:noetic-robot-cu128-cuda12.8.90"
  ]
}

target "noetic-perception-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-perception-cu128",
    "${REGISTRY}/ros-cuda:noetic-perception-cu128-cuda12.8.90"
  ]
}

target "noetic-desktop-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-cu128",
    "${REGISTRY}/ros-cuda:noetic-desktop-cu128-cuda12.8.90"
  ]
}

target "noetic-desktop-full-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu128-cuda12.8.90"
  ]
}

target "noetic-core-run-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-run-cu128",
    "${REGISTRY}/ros-cuda:noetic-core-run-cu128-cuda12.8.90"
  ]
}

target "noetic-base-run-cuda-cu128" {
  inherits = ["_noetic", "_cuda-cu128-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "noetic-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-run-cu128",
    "${REGISTRY}/ros-cuda:noetic-base-run-cu128-cuda12.8.90"
  ]
}

target "noetic-core-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-cu130",
    "${REGISTRY}/ros-cuda:noetic-core-cu130-cuda13.0.96"
  ]
}

target "noetic-base-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-cu130",
    "${REGISTRY}/ros-cuda:noetic-base-cu130-cuda13.0.96"
  ]
}

target "noetic-robot-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-robot-cu130",
    "${REGISTRY}/ros-cuda:noetic-robot-cu130-cuda13.0.96"
  ]
}

target "noetic-perception-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-perception-cu130",
    "${REGISTRY}/ros-cuda:noetic-perception-cu130-cuda13.0.96"
  ]
}

target "noetic-desktop-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-cu130",
    "${REGISTRY}/ros-cuda:noetic-desktop-cu130-cuda13.0.96"
  ]
}

target "noetic-desktop-full-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu130-cuda13.0.96"
  ]
}

target "noetic-core-run-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-run-cu130",
    "${REGISTRY}/ros-cuda:noetic-core-run-cu130-cuda13.0.96"
  ]
}

target "noetic-base-run-cuda-cu130" {
  inherits = ["_noetic", "_cuda-cu130-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "noetic-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-run-cu130",
    "${REGISTRY}/ros-cuda:noetic-base-run-cu130-cuda13.0.96"
  ]
}

target "noetic-core-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-cu132",
    "${REGISTRY}/ros-cuda:noetic-core-cu132-cuda13.2.86"
  ]
}

target "noetic-base-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-cu132",
    "${REGISTRY}/ros-cuda:noetic-base-cu132-cuda13.2.86"
  ]
}

target "noetic-robot-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-robot-cu132-cuda13.2.86"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-robot-cu132",
    "${REGISTRY}/ros-cuda:noetic-robot-cu132-cuda13.2.86"
  ]
}

target "noetic-perception-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-perception-cu132",
    "${REGISTRY}/ros-cuda:noetic-perception-cu132-cuda13.2.86"
  ]
}

target "noetic-desktop-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-cu132",
    "${REGISTRY}/ros-cuda:noetic-desktop-cu132-cuda13.2.86"
  ]
}

target "noetic-desktop-full-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu132-cuda13.2.86"
  ]
}

target "noetic-core-run-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-run-cu132",
    "${REGISTRY}/ros-cuda:noetic-core-run-cu132-cuda13.2.86"
  ]
}

target "noetic-base-run-cuda-cu132" {
  inherits = ["_noetic", "_cuda-cu132-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "noetic-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-run-cu132",
    "${REGISTRY}/ros-cuda:noetic-base-run-cu132-cuda13.2.86"
  ]
}

target "noetic-core-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-cu121",
    "${REGISTRY}/ros-cuda:noetic-core-cu121-cuda12.1.105"
  ]
}

target "noetic-base-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-cu121",
    "${REGISTRY}/ros-cuda:noetic-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:noetic"
  ]
}

target "noetic-robot-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-robot-cu121",
    "${REGISTRY}/ros-cuda:noetic-robot-cu121-cuda12.1.105"
  ]
}

target "noetic-perception-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-perception-cu121",
    "${REGISTRY}/ros-cuda:noetic-perception-cu121-cuda12.1.105"
  ]
}

target "noetic-desktop-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-cu121",
    "${REGISTRY}/ros-cuda:noetic-desktop-cu121-cuda12.1.105"
  ]
}

target "noetic-desktop-full-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:noetic-desktop-full-cu121-cuda12.1.105"
  ]
}

target "noetic-core-run-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-core-run-cu121",
    "${REGISTRY}/ros-cuda:noetic-core-run-cu121-cuda12.1.105"
  ]
}

target "noetic-base-run-cuda-cu121" {
  inherits = ["_noetic", "_cuda-cu121-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:noetic-base-run-cu121",
    "${REGISTRY}/ros-cuda:noetic-base-run-cu121-cuda12.1.105"
  ]
}

target "noetic-core-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-cu121-torch2.4.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-core-cu121",
    "${REGISTRY}/ros-torch:noetic-core-cu121-torch2.4.1"
  ]
}

target "noetic-base-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-cu121-torch2.4.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-base-cu121",
    "${REGISTRY}/ros-torch:noetic-base-cu121-torch2.4.1",
    "${REGISTRY}/ros-torch:noetic"
  ]
}

target "noetic-robot-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-robot-cu121-torch2.4.1"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-robot-cu121",
    "${REGISTRY}/ros-torch:noetic-robot-cu121-torch2.4.1"
  ]
}

target "noetic-perception-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-perception-cu121-torch2.4.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-perception-cu121",
    "${REGISTRY}/ros-torch:noetic-perception-cu121-torch2.4.1"
  ]
}

target "noetic-desktop-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-cu121",
    "${REGISTRY}/ros-torch:noetic-desktop-cu121-torch2.4.1"
  ]
}

target "noetic-desktop-full-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-full-cu121",
    "${REGISTRY}/ros-torch:noetic-desktop-full-cu121-torch2.4.1"
  ]
}

target "noetic-core-run-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-core-run-cu121-torch2.4.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-core-run-cu121",
    "${REGISTRY}/ros-torch:noetic-core-run-cu121-torch2.4.1"
  ]
}

target "noetic-base-run-torch-cu121" {
  inherits = ["_noetic", "_torch-cu121-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-torch-cu121"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "noetic-base-run-cu121-torch2.4.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-base-run-cu121",
    "${REGISTRY}/ros-torch:noetic-base-run-cu121-torch2.4.1"
  ]
}

target "noetic-core-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-core-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-core-cpu38",
    "${REGISTRY}/ros-torch:noetic-core-cpu38-torch2.4.1"
  ]
}

target "noetic-base-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-base-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-base-cpu38",
    "${REGISTRY}/ros-torch:noetic-base-cpu38-torch2.4.1"
  ]
}

target "noetic-robot-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-robot-cpu38-torch2.4.1"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-robot-cpu38",
    "${REGISTRY}/ros-torch:noetic-robot-cpu38-torch2.4.1"
  ]
}

target "noetic-perception-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-perception-cpu38-torch2.4.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-perception-cpu38",
    "${REGISTRY}/ros-torch:noetic-perception-cpu38-torch2.4.1"
  ]
}

target "noetic-desktop-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-desktop-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-cpu38",
    "${REGISTRY}/ros-torch:noetic-desktop-cpu38-torch2.4.1"
  ]
}

target "noetic-desktop-full-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-desktop-full-cpu38",
    "${REGISTRY}/ros-torch:noetic-desktop-full-cpu38-torch2.4.1"
  ]
}

target "noetic-core-run-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-core-run-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-core-run-cpu38",
    "${REGISTRY}/ros-torch:noetic-core-run-cpu38-torch2.4.1"
  ]
}

target "noetic-base-run-torch-cpu38" {
  inherits = ["_noetic", "_torch-cpu38-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "noetic-base-run-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:noetic-base-run-cpu38",
    "${REGISTRY}/ros-torch:noetic-base-run-cpu38-torch2.4.1"
  ]
}

target "noetic-core-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-core", "ros", "noetic-core") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-core-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-core-cpu38",
    "${REGISTRY}/ros-tf:noetic-core-cpu38-tf2.13.1"
  ]
}

target "noetic-base-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-base", "ros", "noetic-base") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-base-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-base-cpu38",
    "${REGISTRY}/ros-tf:noetic-base-cpu38-tf2.13.1"
  ]
}

target "noetic-robot-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-robot", "ros", "noetic-robot") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-robot-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 robot (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-robot-cpu38-tf2.13.1"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-robot-cpu38",
    "${REGISTRY}/ros-tf:noetic-robot-cpu38-tf2.13.1"
  ]
}

target "noetic-perception-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-perception", "ros", "noetic-perception") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-perception-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 perception (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-perception-cpu38-tf2.13.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-perception-cpu38",
    "${REGISTRY}/ros-tf:noetic-perception-cpu38-tf2.13.1"
  ]
}

target "noetic-desktop-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-desktop", "ros", "noetic-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-desktop-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-desktop-cpu38",
    "${REGISTRY}/ros-tf:noetic-desktop-cpu38-tf2.13.1"
  ]
}

target "noetic-desktop-full-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-desktop-full-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-desktop-full-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-desktop-full-cpu38",
    "${REGISTRY}/ros-tf:noetic-desktop-full-cpu38-tf2.13.1"
  ]
}

target "noetic-core-run-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-core-run", "ros", "noetic-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-core-run-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 core-run (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-core-run-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-core-run-cpu38",
    "${REGISTRY}/ros-tf:noetic-core-run-cpu38-tf2.13.1"
  ]
}

target "noetic-base-run-tensorflow-cpu38" {
  inherits = ["_noetic", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("noetic-base-run", "ros", "noetic-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "noetic-base-run-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 1 base-run (noetic), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "noetic-base-run-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:noetic-base-run-cpu38",
    "${REGISTRY}/ros-tf:noetic-base-run-cpu38-tf2.13.1"
  ]
}

# ---- foxy -----------------------------------------------------------------------------------------------------------

target "_foxy" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_20_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_20_04)[1], null)
    "io.rosml.distribution"                = "foxy"
    "io.rosml.os"                          = "ubuntu-20.04"
    "io.rosml.python"                      = "3.8"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["foxy"], null)
  }
}

target "_foxy-ros" {
  inherits  = ["_foxy"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "foxy"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "final" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "focal"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/foxy/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_SYNC_DATE        = try(sync_dates["foxy"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "foxy-core" {
  inherits = ["_foxy-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:foxy-core"
  ]
}

target "foxy-base" {
  inherits = ["_foxy-ros"]
  contexts = { parent = dependency("foxy-core", "ros", "foxy-core") }
  args     = { ROS_PACKAGES = "ros-foxy-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base"
    "org.opencontainers.image.description" = "ROS 2 base (foxy)"
    "org.opencontainers.image.version"     = "foxy-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:foxy-base",
    "${REGISTRY}/ros:foxy"
  ]
}

target "foxy-desktop" {
  inherits = ["_foxy-ros"]
  contexts = { parent = dependency("foxy-base", "ros", "foxy-base") }
  args     = { ROS_PACKAGES = "ros-foxy-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy)"
    "org.opencontainers.image.version"     = "foxy-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:foxy-desktop"
  ]
}

target "foxy-core-run" {
  inherits = ["_foxy-ros"]
  contexts = { parent = "target:_os-ubuntu-20-04-run" }
  args = {
    ROS_PACKAGES = "ros-foxy-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy)"
    "org.opencontainers.image.version"     = "foxy-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:foxy-core-run"
  ]
}

target "foxy-base-run" {
  inherits = ["_foxy-ros"]
  contexts = { parent = dependency("foxy-core-run", "ros", "foxy-core-run") }
  args = {
    ROS_PACKAGES = "ros-foxy-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy)"
    "org.opencontainers.image.version"     = "foxy-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:foxy-base-run"
  ]
}

target "foxy-core-cuda-cu128" {
  inherits = ["_foxy", "_cuda-cu128-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-cu128",
    "${REGISTRY}/ros-cuda:foxy-core-cu128-cuda12.8.90"
  ]
}

target "foxy-base-cuda-cu128" {
  inherits = ["_foxy", "_cuda-cu128-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-cu128",
    "${REGISTRY}/ros-cuda:foxy-base-cu128-cuda12.8.90"
  ]
}

target "foxy-desktop-cuda-cu128" {
  inherits = ["_foxy", "_cuda-cu128-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-desktop-cu128",
    "${REGISTRY}/ros-cuda:foxy-desktop-cu128-cuda12.8.90"
  ]
}

target "foxy-core-run-cuda-cu128" {
  inherits = ["_foxy", "_cuda-cu128-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-run-cu128",
    "${REGISTRY}/ros-cuda:foxy-core-run-cu128-cuda12.8.90"
  ]
}

target "foxy-base-run-cuda-cu128" {
  inherits = ["_foxy", "_cuda-cu128-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "foxy-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-run-cu128",
    "${REGISTRY}/ros-cuda:foxy-base-run-cu128-cuda12.8.90"
  ]
}

target "foxy-core-cuda-cu130" {
  inherits = ["_foxy", "_cuda-cu130-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-cu130",
    "${REGISTRY}/ros-cuda:foxy-core-cu130-cuda13.0.96"
  ]
}

target "foxy-base-cuda-cu130" {
  inherits = ["_foxy", "_cuda-cu130-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-cu130",
    "${REGISTRY}/ros-cuda:foxy-base-cu130-cuda13.0.96"
  ]
}

target "foxy-desktop-cuda-cu130" {
  inherits = ["_foxy", "_cuda-cu130-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-desktop-cu130",
    "${REGISTRY}/ros-cuda:foxy-desktop-cu130-cuda13.0.96"
  ]
}

target "foxy-core-run-cuda-cu130" {
  inherits = ["_foxy", "_cuda-cu130-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-run-cu130",
    "${REGISTRY}/ros-cuda:foxy-core-run-cu130-cuda13.0.96"
  ]
}

target "foxy-base-run-cuda-cu130" {
  inherits = ["_foxy", "_cuda-cu130-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "foxy-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-run-cu130",
    "${REGISTRY}/ros-cuda:foxy-base-run-cu130-cuda13.0.96"
  ]
}

target "foxy-core-cuda-cu132" {
  inherits = ["_foxy", "_cuda-cu132-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "foxy-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-cu132",
    "${REGISTRY}/ros-cuda:foxy-core-cu132-cuda13.2.86"
  ]
}

target "foxy-base-cuda-cu132" {
  inherits = ["_foxy", "_cuda-cu132-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "foxy-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-cu132",
    "${REGISTRY}/ros-cuda:foxy-base-cu132-cuda13.2.86"
  ]
}

target "foxy-desktop-cuda-cu132" {
  inherits = ["_foxy", "_cuda-cu132-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "foxy-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-desktop-cu132",
    "${REGISTRY}/ros-cuda:foxy-desktop-cu132-cuda13.2.86"
  ]
}

target "foxy-core-run-cuda-cu132" {
  inherits = ["_foxy", "_cuda-cu132-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "foxy-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-run-cu132",
    "${REGISTRY}/ros-cuda:foxy-core-run-cu132-cuda13.2.86"
  ]
}

target "foxy-base-run-cuda-cu132" {
  inherits = ["_foxy", "_cuda-cu132-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "foxy-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-run-cu132",
    "${REGISTRY}/ros-cuda:foxy-base-run-cu132-cuda13.2.86"
  ]
}

target "foxy-core-cuda-cu121" {
  inherits = ["_foxy", "_cuda-cu121-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-cu121",
    "${REGISTRY}/ros-cuda:foxy-core-cu121-cuda12.1.105"
  ]
}

target "foxy-base-cuda-cu121" {
  inherits = ["_foxy", "_cuda-cu121-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-cu121",
    "${REGISTRY}/ros-cuda:foxy-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:foxy"
  ]
}

target "foxy-desktop-cuda-cu121" {
  inherits = ["_foxy", "_cuda-cu121-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-desktop-cu121",
    "${REGISTRY}/ros-cuda:foxy-desktop-cu121-cuda12.1.105"
  ]
}

target "foxy-core-run-cuda-cu121" {
  inherits = ["_foxy", "_cuda-cu121-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-core-run-cu121",
    "${REGISTRY}/ros-cuda:foxy-core-run-cu121-cuda12.1.105"
  ]
}

target "foxy-base-run-cuda-cu121" {
  inherits = ["_foxy", "_cuda-cu121-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:foxy-base-run-cu121",
    "${REGISTRY}/ros-cuda:foxy-base-run-cu121-cuda12.1.105"
  ]
}

target "foxy-core-torch-cu121" {
  inherits = ["_foxy", "_torch-cu121-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-cu121-torch2.4.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-core-cu121",
    "${REGISTRY}/ros-torch:foxy-core-cu121-torch2.4.1"
  ]
}

target "foxy-base-torch-cu121" {
  inherits = ["_foxy", "_torch-cu121-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-cu121-torch2.4.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-base-cu121",
    "${REGISTRY}/ros-torch:foxy-base-cu121-torch2.4.1",
    "${REGISTRY}/ros-torch:foxy"
  ]
}

target "foxy-desktop-torch-cu121" {
  inherits = ["_foxy", "_torch-cu121-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-desktop-cu121-torch2.4.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-desktop-cu121",
    "${REGISTRY}/ros-torch:foxy-desktop-cu121-torch2.4.1"
  ]
}

target "foxy-core-run-torch-cu121" {
  inherits = ["_foxy", "_torch-cu121-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-core-run-cu121-torch2.4.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-core-run-cu121",
    "${REGISTRY}/ros-torch:foxy-core-run-cu121-torch2.4.1"
  ]
}

target "foxy-base-run-torch-cu121" {
  inherits = ["_foxy", "_torch-cu121-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-torch-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), PyTorch 2.4.1, CUDA 12.1.105"
    "org.opencontainers.image.version"     = "foxy-base-run-cu121-torch2.4.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-base-run-cu121",
    "${REGISTRY}/ros-torch:foxy-base-run-cu121-torch2.4.1"
  ]
}

target "foxy-core-torch-cpu38" {
  inherits = ["_foxy", "_torch-cpu38-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-core-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-core-cpu38",
    "${REGISTRY}/ros-torch:foxy-core-cpu38-torch2.4.1"
  ]
}

target "foxy-base-torch-cpu38" {
  inherits = ["_foxy", "_torch-cpu38-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-base-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-base-cpu38",
    "${REGISTRY}/ros-torch:foxy-base-cpu38-torch2.4.1"
  ]
}

target "foxy-desktop-torch-cpu38" {
  inherits = ["_foxy", "_torch-cpu38-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-desktop-cpu38-torch2.4.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-desktop-cpu38",
    "${REGISTRY}/ros-torch:foxy-desktop-cpu38-torch2.4.1"
  ]
}

target "foxy-core-run-torch-cpu38" {
  inherits = ["_foxy", "_torch-cpu38-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-core-run-cpu38-torch2.4.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-core-run-cpu38",
    "${REGISTRY}/ros-torch:foxy-core-run-cpu38-torch2.4.1"
  ]
}

target "foxy-base-run-torch-cpu38" {
  inherits = ["_foxy", "_torch-cpu38-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-torch-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), PyTorch 2.4.1"
    "org.opencontainers.image.version"     = "foxy-base-run-cpu38-torch2.4.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:foxy-base-run-cpu38",
    "${REGISTRY}/ros-torch:foxy-base-run-cpu38-torch2.4.1"
  ]
}

target "foxy-core-tensorflow-cpu38" {
  inherits = ["_foxy", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("foxy-core", "ros", "foxy-core") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-core-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:foxy-core-cpu38",
    "${REGISTRY}/ros-tf:foxy-core-cpu38-tf2.13.1"
  ]
}

target "foxy-base-tensorflow-cpu38" {
  inherits = ["_foxy", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("foxy-base", "ros", "foxy-base") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-base-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:foxy-base-cpu38",
    "${REGISTRY}/ros-tf:foxy-base-cpu38-tf2.13.1"
  ]
}

target "foxy-desktop-tensorflow-cpu38" {
  inherits = ["_foxy", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("foxy-desktop", "ros", "foxy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-desktop-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 desktop (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-desktop-cpu38-tf2.13.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:foxy-desktop-cpu38",
    "${REGISTRY}/ros-tf:foxy-desktop-cpu38-tf2.13.1"
  ]
}

target "foxy-core-run-tensorflow-cpu38" {
  inherits = ["_foxy", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("foxy-core-run", "ros", "foxy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-core-run-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 core-run (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-core-run-cpu38-tf2.13.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:foxy-core-run-cpu38",
    "${REGISTRY}/ros-tf:foxy-core-run-cpu38-tf2.13.1"
  ]
}

target "foxy-base-run-tensorflow-cpu38" {
  inherits = ["_foxy", "_tensorflow-cpu38-py38"]
  contexts = { ros = dependency("foxy-base-run", "ros", "foxy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "foxy-base-run-tensorflow-cpu38"
    "org.opencontainers.image.description" = "ROS 2 base-run (foxy), TensorFlow 2.13.1"
    "org.opencontainers.image.version"     = "foxy-base-run-cpu38-tf2.13.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:foxy-base-run-cpu38",
    "${REGISTRY}/ros-tf:foxy-base-run-cpu38-tf2.13.1"
  ]
}

# ---- humble ---------------------------------------------------------------------------------------------------------

target "_humble" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_22_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_22_04)[1], null)
    "io.rosml.distribution"                = "humble"
    "io.rosml.os"                          = "ubuntu-22.04"
    "io.rosml.python"                      = "3.10"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["humble"], null)
  }
}

target "_humble-ros" {
  inherits  = ["_humble"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "humble"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "live" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "jammy"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/humble/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.jammy_all.deb@sha256:110b9a462d55252decb8b7c816f61c2ba0d9890ce5fb93ac504e97cae5860d76"
    ROS_SYNC_DATE        = try(sync_dates["humble"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "humble-core" {
  inherits = ["_humble-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-core"
  ]
}

target "humble-base" {
  inherits = ["_humble-ros"]
  contexts = { parent = dependency("humble-core", "ros", "humble-core") }
  args     = { ROS_PACKAGES = "ros-humble-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "humble-base"
    "org.opencontainers.image.description" = "ROS 2 base (humble)"
    "org.opencontainers.image.version"     = "humble-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-base",
    "${REGISTRY}/ros:humble"
  ]
}

target "humble-perception" {
  inherits = ["_humble-ros"]
  contexts = { parent = dependency("humble-base", "ros", "humble-base") }
  args     = { ROS_PACKAGES = "ros-humble-perception" }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (humble)"
    "org.opencontainers.image.version"     = "humble-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-perception"
  ]
}

target "humble-desktop" {
  inherits = ["_humble-ros"]
  contexts = { parent = dependency("humble-perception", "ros", "humble-perception") }
  args     = { ROS_PACKAGES = "ros-humble-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble)"
    "org.opencontainers.image.version"     = "humble-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-desktop"
  ]
}

target "humble-desktop-full" {
  inherits = ["_humble-ros"]
  contexts = { parent = dependency("humble-desktop", "ros", "humble-desktop") }
  args     = { ROS_PACKAGES = "ros-humble-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble)"
    "org.opencontainers.image.version"     = "humble-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-desktop-full"
  ]
}

target "humble-core-run" {
  inherits = ["_humble-ros"]
  contexts = { parent = "target:_os-ubuntu-22-04-run" }
  args = {
    ROS_PACKAGES = "ros-humble-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble)"
    "org.opencontainers.image.version"     = "humble-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-core-run"
  ]
}

target "humble-base-run" {
  inherits = ["_humble-ros"]
  contexts = { parent = dependency("humble-core-run", "ros", "humble-core-run") }
  args = {
    ROS_PACKAGES = "ros-humble-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble)"
    "org.opencontainers.image.version"     = "humble-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:humble-base-run"
  ]
}

target "humble-core-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-cu128",
    "${REGISTRY}/ros-cuda:humble-core-cu128-cuda12.8.90"
  ]
}

target "humble-base-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-cu128",
    "${REGISTRY}/ros-cuda:humble-base-cu128-cuda12.8.90"
  ]
}

target "humble-perception-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-perception-cu128",
    "${REGISTRY}/ros-cuda:humble-perception-cu128-cuda12.8.90"
  ]
}

target "humble-desktop-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-cu128",
    "${REGISTRY}/ros-cuda:humble-desktop-cu128-cuda12.8.90"
  ]
}

target "humble-desktop-full-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu128-cuda12.8.90"
  ]
}

target "humble-core-run-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-run-cu128",
    "${REGISTRY}/ros-cuda:humble-core-run-cu128-cuda12.8.90"
  ]
}

target "humble-base-run-cuda-cu128" {
  inherits = ["_humble", "_cuda-cu128-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-run-cu128",
    "${REGISTRY}/ros-cuda:humble-base-run-cu128-cuda12.8.90"
  ]
}

target "humble-core-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-cu130",
    "${REGISTRY}/ros-cuda:humble-core-cu130-cuda13.0.96"
  ]
}

target "humble-base-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-cu130",
    "${REGISTRY}/ros-cuda:humble-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:humble"
  ]
}

target "humble-perception-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-perception-cu130",
    "${REGISTRY}/ros-cuda:humble-perception-cu130-cuda13.0.96"
  ]
}

target "humble-desktop-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-cu130",
    "${REGISTRY}/ros-cuda:humble-desktop-cu130-cuda13.0.96"
  ]
}

target "humble-desktop-full-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu130-cuda13.0.96"
  ]
}

target "humble-core-run-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-run-cu130",
    "${REGISTRY}/ros-cuda:humble-core-run-cu130-cuda13.0.96"
  ]
}

target "humble-base-run-cuda-cu130" {
  inherits = ["_humble", "_cuda-cu130-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-run-cu130",
    "${REGISTRY}/ros-cuda:humble-base-run-cu130-cuda13.0.96"
  ]
}

target "humble-core-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-cu132",
    "${REGISTRY}/ros-cuda:humble-core-cu132-cuda13.2.86"
  ]
}

target "humble-base-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-cu132",
    "${REGISTRY}/ros-cuda:humble-base-cu132-cuda13.2.86"
  ]
}

target "humble-perception-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-perception-cu132",
    "${REGISTRY}/ros-cuda:humble-perception-cu132-cuda13.2.86"
  ]
}

target "humble-desktop-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-cu132",
    "${REGISTRY}/ros-cuda:humble-desktop-cu132-cuda13.2.86"
  ]
}

target "humble-desktop-full-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu132-cuda13.2.86"
  ]
}

target "humble-core-run-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-run-cu132",
    "${REGISTRY}/ros-cuda:humble-core-run-cu132-cuda13.2.86"
  ]
}

target "humble-base-run-cuda-cu132" {
  inherits = ["_humble", "_cuda-cu132-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "humble-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-run-cu132",
    "${REGISTRY}/ros-cuda:humble-base-run-cu132-cuda13.2.86"
  ]
}

target "humble-core-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-cu121",
    "${REGISTRY}/ros-cuda:humble-core-cu121-cuda12.1.105"
  ]
}

target "humble-base-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-cu121",
    "${REGISTRY}/ros-cuda:humble-base-cu121-cuda12.1.105"
  ]
}

target "humble-perception-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-perception-cu121",
    "${REGISTRY}/ros-cuda:humble-perception-cu121-cuda12.1.105"
  ]
}

target "humble-desktop-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-cu121",
    "${REGISTRY}/ros-cuda:humble-desktop-cu121-cuda12.1.105"
  ]
}

target "humble-desktop-full-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:humble-desktop-full-cu121-cuda12.1.105"
  ]
}

target "humble-core-run-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-core-run-cu121",
    "${REGISTRY}/ros-cuda:humble-core-run-cu121-cuda12.1.105"
  ]
}

target "humble-base-run-cuda-cu121" {
  inherits = ["_humble", "_cuda-cu121-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "humble-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:humble-base-run-cu121",
    "${REGISTRY}/ros-cuda:humble-base-run-cu121-cuda12.1.105"
  ]
}

target "humble-core-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-cu128",
    "${REGISTRY}/ros-torch:humble-core-cu128-torch2.10.0"
  ]
}

target "humble-base-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-cu128",
    "${REGISTRY}/ros-torch:humble-base-cu128-torch2.10.0"
  ]
}

target "humble-perception-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-perception-cu128",
    "${REGISTRY}/ros-torch:humble-perception-cu128-torch2.10.0"
  ]
}

target "humble-desktop-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-cu128",
    "${REGISTRY}/ros-torch:humble-desktop-cu128-torch2.10.0"
  ]
}

target "humble-desktop-full-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-full-cu128",
    "${REGISTRY}/ros-torch:humble-desktop-full-cu128-torch2.10.0"
  ]
}

target "humble-core-run-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-run-cu128",
    "${REGISTRY}/ros-torch:humble-core-run-cu128-torch2.10.0"
  ]
}

target "humble-base-run-torch-cu128" {
  inherits = ["_humble", "_torch-cu128-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-run-cu128",
    "${REGISTRY}/ros-torch:humble-base-run-cu128-torch2.10.0"
  ]
}

target "humble-core-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-cu130",
    "${REGISTRY}/ros-torch:humble-core-cu130-torch2.14.1"
  ]
}

target "humble-base-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-cu130",
    "${REGISTRY}/ros-torch:humble-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:humble"
  ]
}

target "humble-perception-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-perception-cu130",
    "${REGISTRY}/ros-torch:humble-perception-cu130-torch2.14.1"
  ]
}

target "humble-desktop-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-cu130",
    "${REGISTRY}/ros-torch:humble-desktop-cu130-torch2.14.1"
  ]
}

target "humble-desktop-full-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-full-cu130",
    "${REGISTRY}/ros-torch:humble-desktop-full-cu130-torch2.14.1"
  ]
}

target "humble-core-run-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-run-cu130",
    "${REGISTRY}/ros-torch:humble-core-run-cu130-torch2.14.1"
  ]
}

target "humble-base-run-torch-cu130" {
  inherits = ["_humble", "_torch-cu130-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "humble-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-run-cu130",
    "${REGISTRY}/ros-torch:humble-base-run-cu130-torch2.14.1"
  ]
}

target "humble-core-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-cpu",
    "${REGISTRY}/ros-torch:humble-core-cpu-torch2.10.0"
  ]
}

target "humble-base-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-cpu",
    "${REGISTRY}/ros-torch:humble-base-cpu-torch2.10.0"
  ]
}

target "humble-perception-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-perception-cpu",
    "${REGISTRY}/ros-torch:humble-perception-cpu-torch2.10.0"
  ]
}

target "humble-desktop-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-cpu",
    "${REGISTRY}/ros-torch:humble-desktop-cpu-torch2.10.0"
  ]
}

target "humble-desktop-full-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-desktop-full-cpu",
    "${REGISTRY}/ros-torch:humble-desktop-full-cpu-torch2.10.0"
  ]
}

target "humble-core-run-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-core-run-cpu",
    "${REGISTRY}/ros-torch:humble-core-run-cpu-torch2.10.0"
  ]
}

target "humble-base-run-torch-cpu" {
  inherits = ["_humble", "_torch-cpu-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "humble-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:humble-base-run-cpu",
    "${REGISTRY}/ros-torch:humble-base-run-cpu-torch2.10.0"
  ]
}

target "humble-core-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-core-cu128",
    "${REGISTRY}/ros-tf:humble-core-cu128-tf2.20.0"
  ]
}

target "humble-base-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-base-cu128",
    "${REGISTRY}/ros-tf:humble-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:humble"
  ]
}

target "humble-perception-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-perception-cu128",
    "${REGISTRY}/ros-tf:humble-perception-cu128-tf2.20.0"
  ]
}

target "humble-desktop-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-desktop-cu128",
    "${REGISTRY}/ros-tf:humble-desktop-cu128-tf2.20.0"
  ]
}

target "humble-desktop-full-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-desktop-full-cu128",
    "${REGISTRY}/ros-tf:humble-desktop-full-cu128-tf2.20.0"
  ]
}

target "humble-core-run-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-core-run-cu128",
    "${REGISTRY}/ros-tf:humble-core-run-cu128-tf2.20.0"
  ]
}

target "humble-base-run-tensorflow-cu128" {
  inherits = ["_humble", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-base-run-cu128",
    "${REGISTRY}/ros-tf:humble-base-run-cu128-tf2.20.0"
  ]
}

target "humble-core-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-core-cpu",
    "${REGISTRY}/ros-tf:humble-core-cpu-tf2.21.0"
  ]
}

target "humble-base-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-base-cpu",
    "${REGISTRY}/ros-tf:humble-base-cpu-tf2.21.0"
  ]
}

target "humble-perception-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-perception-cpu",
    "${REGISTRY}/ros-tf:humble-perception-cpu-tf2.21.0"
  ]
}

target "humble-desktop-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-desktop-cpu",
    "${REGISTRY}/ros-tf:humble-desktop-cpu-tf2.21.0"
  ]
}

target "humble-desktop-full-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-desktop-full-cpu",
    "${REGISTRY}/ros-tf:humble-desktop-full-cpu-tf2.21.0"
  ]
}

target "humble-core-run-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-core-run-cpu",
    "${REGISTRY}/ros-tf:humble-core-run-cpu-tf2.21.0"
  ]
}

target "humble-base-run-tensorflow-cpu" {
  inherits = ["_humble", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:humble-base-run-cpu",
    "${REGISTRY}/ros-tf:humble-base-run-cpu-tf2.21.0"
  ]
}

target "humble-core-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-core-cu128",
    "${REGISTRY}/ros-ml:humble-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-base-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-base-cu128",
    "${REGISTRY}/ros-ml:humble-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:humble"
  ]
}

target "humble-perception-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-perception-cu128",
    "${REGISTRY}/ros-ml:humble-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-desktop-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-cu128",
    "${REGISTRY}/ros-ml:humble-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-desktop-full-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-full-cu128",
    "${REGISTRY}/ros-ml:humble-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-core-run-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-core-run-cu128",
    "${REGISTRY}/ros-ml:humble-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-base-run-ml-cu128" {
  inherits = ["_humble", "_ml-cu128-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "humble-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-base-run-cu128",
    "${REGISTRY}/ros-ml:humble-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "humble-core-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-core", "ros", "humble-core") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-core-cpu",
    "${REGISTRY}/ros-ml:humble-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-base-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-base", "ros", "humble-base") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-base-cpu",
    "${REGISTRY}/ros-ml:humble-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-perception-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-perception", "ros", "humble-perception") }
  labels = {
    "org.opencontainers.image.title"       = "humble-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-perception-cpu",
    "${REGISTRY}/ros-ml:humble-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-desktop-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-desktop", "ros", "humble-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-cpu",
    "${REGISTRY}/ros-ml:humble-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-desktop-full-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "humble-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-desktop-full-cpu",
    "${REGISTRY}/ros-ml:humble-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-core-run-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-core-run", "ros", "humble-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-core-run-cpu",
    "${REGISTRY}/ros-ml:humble-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-base-run-ml-cpu" {
  inherits = ["_humble", "_ml-cpu-py310"]
  contexts = { ros = dependency("humble-base-run", "ros", "humble-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "humble-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (humble), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "humble-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:humble-base-run-cpu",
    "${REGISTRY}/ros-ml:humble-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "humble-core-triton-cu128" {
  inherits = ["_humble", "_none-triton-cu128-py310"]
}

target "humble-core-triton-cu130" {
  inherits = ["_humble", "_none-triton-cu130-py310"]
}

target "humble-core-triton-cu132" {
  inherits = ["_humble", "_none-triton-cu132-py310"]
}

target "humble-core-triton-cpu" {
  inherits = ["_humble", "_none-triton-cpu-py310"]
}

target "humble-core-tensorrt-rtx-cu130" {
  inherits = ["_humble", "_none-tensorrt-rtx-cu130-py310"]
}

target "humble-core-tensorrt-rtx-cu132" {
  inherits = ["_humble", "_none-tensorrt-rtx-cu132-py310"]
}

# ---- iron -----------------------------------------------------------------------------------------------------------

target "_iron" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_22_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_22_04)[1], null)
    "io.rosml.distribution"                = "iron"
    "io.rosml.os"                          = "ubuntu-22.04"
    "io.rosml.python"                      = "3.10"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["iron"], null)
  }
}

target "_iron-ros" {
  inherits  = ["_iron"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "iron"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "final" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "jammy"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/iron/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.jammy_all.deb@sha256:110b9a462d55252decb8b7c816f61c2ba0d9890ce5fb93ac504e97cae5860d76"
    ROS_SYNC_DATE        = try(sync_dates["iron"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "iron-core" {
  inherits = ["_iron-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-core"
  ]
}

target "iron-base" {
  inherits = ["_iron-ros"]
  contexts = { parent = dependency("iron-core", "ros", "iron-core") }
  args     = { ROS_PACKAGES = "ros-iron-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "iron-base"
    "org.opencontainers.image.description" = "ROS 2 base (iron)"
    "org.opencontainers.image.version"     = "iron-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-base",
    "${REGISTRY}/ros:iron"
  ]
}

target "iron-perception" {
  inherits = ["_iron-ros"]
  contexts = { parent = dependency("iron-base", "ros", "iron-base") }
  args     = { ROS_PACKAGES = "ros-iron-perception" }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (iron)"
    "org.opencontainers.image.version"     = "iron-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-perception"
  ]
}

target "iron-desktop" {
  inherits = ["_iron-ros"]
  contexts = { parent = dependency("iron-perception", "ros", "iron-perception") }
  args     = { ROS_PACKAGES = "ros-iron-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron)"
    "org.opencontainers.image.version"     = "iron-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-desktop"
  ]
}

target "iron-desktop-full" {
  inherits = ["_iron-ros"]
  contexts = { parent = dependency("iron-desktop", "ros", "iron-desktop") }
  args     = { ROS_PACKAGES = "ros-iron-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron)"
    "org.opencontainers.image.version"     = "iron-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-desktop-full"
  ]
}

target "iron-core-run" {
  inherits = ["_iron-ros"]
  contexts = { parent = "target:_os-ubuntu-22-04-run" }
  args = {
    ROS_PACKAGES = "ros-iron-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron)"
    "org.opencontainers.image.version"     = "iron-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-core-run"
  ]
}

target "iron-base-run" {
  inherits = ["_iron-ros"]
  contexts = { parent = dependency("iron-core-run", "ros", "iron-core-run") }
  args = {
    ROS_PACKAGES = "ros-iron-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron)"
    "org.opencontainers.image.version"     = "iron-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:iron-base-run"
  ]
}

target "iron-core-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-cu128",
    "${REGISTRY}/ros-cuda:iron-core-cu128-cuda12.8.90"
  ]
}

target "iron-base-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-cu128",
    "${REGISTRY}/ros-cuda:iron-base-cu128-cuda12.8.90"
  ]
}

target "iron-perception-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-perception-cu128",
    "${REGISTRY}/ros-cuda:iron-perception-cu128-cuda12.8.90"
  ]
}

target "iron-desktop-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-cu128",
    "${REGISTRY}/ros-cuda:iron-desktop-cu128-cuda12.8.90"
  ]
}

target "iron-desktop-full-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu128-cuda12.8.90"
  ]
}

target "iron-core-run-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-run-cu128",
    "${REGISTRY}/ros-cuda:iron-core-run-cu128-cuda12.8.90"
  ]
}

target "iron-base-run-cuda-cu128" {
  inherits = ["_iron", "_cuda-cu128-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-run-cu128",
    "${REGISTRY}/ros-cuda:iron-base-run-cu128-cuda12.8.90"
  ]
}

target "iron-core-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-cu130",
    "${REGISTRY}/ros-cuda:iron-core-cu130-cuda13.0.96"
  ]
}

target "iron-base-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-cu130",
    "${REGISTRY}/ros-cuda:iron-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:iron"
  ]
}

target "iron-perception-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-perception-cu130",
    "${REGISTRY}/ros-cuda:iron-perception-cu130-cuda13.0.96"
  ]
}

target "iron-desktop-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-cu130",
    "${REGISTRY}/ros-cuda:iron-desktop-cu130-cuda13.0.96"
  ]
}

target "iron-desktop-full-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu130-cuda13.0.96"
  ]
}

target "iron-core-run-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-run-cu130",
    "${REGISTRY}/ros-cuda:iron-core-run-cu130-cuda13.0.96"
  ]
}

target "iron-base-run-cuda-cu130" {
  inherits = ["_iron", "_cuda-cu130-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-run-cu130",
    "${REGISTRY}/ros-cuda:iron-base-run-cu130-cuda13.0.96"
  ]
}

target "iron-core-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-cu132",
    "${REGISTRY}/ros-cuda:iron-core-cu132-cuda13.2.86"
  ]
}

target "iron-base-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-cu132",
    "${REGISTRY}/ros-cuda:iron-base-cu132-cuda13.2.86"
  ]
}

target "iron-perception-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-perception-cu132",
    "${REGISTRY}/ros-cuda:iron-perception-cu132-cuda13.2.86"
  ]
}

target "iron-desktop-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-cu132",
    "${REGISTRY}/ros-cuda:iron-desktop-cu132-cuda13.2.86"
  ]
}

target "iron-desktop-full-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu132-cuda13.2.86"
  ]
}

target "iron-core-run-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-run-cu132",
    "${REGISTRY}/ros-cuda:iron-core-run-cu132-cuda13.2.86"
  ]
}

target "iron-base-run-cuda-cu132" {
  inherits = ["_iron", "_cuda-cu132-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "iron-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-run-cu132",
    "${REGISTRY}/ros-cuda:iron-base-run-cu132-cuda13.2.86"
  ]
}

target "iron-core-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-cu121",
    "${REGISTRY}/ros-cuda:iron-core-cu121-cuda12.1.105"
  ]
}

target "iron-base-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-cu121",
    "${REGISTRY}/ros-cuda:iron-base-cu121-cuda12.1.105"
  ]
}

target "iron-perception-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-perception-cu121",
    "${REGISTRY}/ros-cuda:iron-perception-cu121-cuda12.1.105"
  ]
}

target "iron-desktop-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-cu121",
    "${REGISTRY}/ros-cuda:iron-desktop-cu121-cuda12.1.105"
  ]
}

target "iron-desktop-full-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:iron-desktop-full-cu121-cuda12.1.105"
  ]
}

target "iron-core-run-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-core-run-cu121",
    "${REGISTRY}/ros-cuda:iron-core-run-cu121-cuda12.1.105"
  ]
}

target "iron-base-run-cuda-cu121" {
  inherits = ["_iron", "_cuda-cu121-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "iron-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:iron-base-run-cu121",
    "${REGISTRY}/ros-cuda:iron-base-run-cu121-cuda12.1.105"
  ]
}

target "iron-core-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-cu128",
    "${REGISTRY}/ros-torch:iron-core-cu128-torch2.10.0"
  ]
}

target "iron-base-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-cu128",
    "${REGISTRY}/ros-torch:iron-base-cu128-torch2.10.0"
  ]
}

target "iron-perception-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-perception-cu128",
    "${REGISTRY}/ros-torch:iron-perception-cu128-torch2.10.0"
  ]
}

target "iron-desktop-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-cu128",
    "${REGISTRY}/ros-torch:iron-desktop-cu128-torch2.10.0"
  ]
}

target "iron-desktop-full-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-full-cu128",
    "${REGISTRY}/ros-torch:iron-desktop-full-cu128-torch2.10.0"
  ]
}

target "iron-core-run-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-run-cu128",
    "${REGISTRY}/ros-torch:iron-core-run-cu128-torch2.10.0"
  ]
}

target "iron-base-run-torch-cu128" {
  inherits = ["_iron", "_torch-cu128-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-run-cu128",
    "${REGISTRY}/ros-torch:iron-base-run-cu128-torch2.10.0"
  ]
}

target "iron-core-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-cu130",
    "${REGISTRY}/ros-torch:iron-core-cu130-torch2.14.1"
  ]
}

target "iron-base-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-cu130",
    "${REGISTRY}/ros-torch:iron-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:iron"
  ]
}

target "iron-perception-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-perception-cu130",
    "${REGISTRY}/ros-torch:iron-perception-cu130-torch2.14.1"
  ]
}

target "iron-desktop-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-cu130",
    "${REGISTRY}/ros-torch:iron-desktop-cu130-torch2.14.1"
  ]
}

target "iron-desktop-full-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-full-cu130",
    "${REGISTRY}/ros-torch:iron-desktop-full-cu130-torch2.14.1"
  ]
}

target "iron-core-run-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-run-cu130",
    "${REGISTRY}/ros-torch:iron-core-run-cu130-torch2.14.1"
  ]
}

target "iron-base-run-torch-cu130" {
  inherits = ["_iron", "_torch-cu130-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "iron-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-run-cu130",
    "${REGISTRY}/ros-torch:iron-base-run-cu130-torch2.14.1"
  ]
}

target "iron-core-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-cpu",
    "${REGISTRY}/ros-torch:iron-core-cpu-torch2.10.0"
  ]
}

target "iron-base-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-cpu",
    "${REGISTRY}/ros-torch:iron-base-cpu-torch2.10.0"
  ]
}

target "iron-perception-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-perception-cpu",
    "${REGISTRY}/ros-torch:iron-perception-cpu-torch2.10.0"
  ]
}

target "iron-desktop-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-cpu",
    "${REGISTRY}/ros-torch:iron-desktop-cpu-torch2.10.0"
  ]
}

target "iron-desktop-full-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-desktop-full-cpu",
    "${REGISTRY}/ros-torch:iron-desktop-full-cpu-torch2.10.0"
  ]
}

target "iron-core-run-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-core-run-cpu",
    "${REGISTRY}/ros-torch:iron-core-run-cpu-torch2.10.0"
  ]
}

target "iron-base-run-torch-cpu" {
  inherits = ["_iron", "_torch-cpu-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "iron-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:iron-base-run-cpu",
    "${REGISTRY}/ros-torch:iron-base-run-cpu-torch2.10.0"
  ]
}

target "iron-core-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-core-cu128",
    "${REGISTRY}/ros-tf:iron-core-cu128-tf2.20.0"
  ]
}

target "iron-base-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-base-cu128",
    "${REGISTRY}/ros-tf:iron-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:iron"
  ]
}

target "iron-perception-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-perception-cu128",
    "${REGISTRY}/ros-tf:iron-perception-cu128-tf2.20.0"
  ]
}

target "iron-desktop-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-desktop-cu128",
    "${REGISTRY}/ros-tf:iron-desktop-cu128-tf2.20.0"
  ]
}

target "iron-desktop-full-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-desktop-full-cu128",
    "${REGISTRY}/ros-tf:iron-desktop-full-cu128-tf2.20.0"
  ]
}

target "iron-core-run-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-core-run-cu128",
    "${REGISTRY}/ros-tf:iron-core-run-cu128-tf2.20.0"
  ]
}

target "iron-base-run-tensorflow-cu128" {
  inherits = ["_iron", "_tensorflow-cu128-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-base-run-cu128",
    "${REGISTRY}/ros-tf:iron-base-run-cu128-tf2.20.0"
  ]
}

target "iron-core-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-core-cpu",
    "${REGISTRY}/ros-tf:iron-core-cpu-tf2.21.0"
  ]
}

target "iron-base-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-base-cpu",
    "${REGISTRY}/ros-tf:iron-base-cpu-tf2.21.0"
  ]
}

target "iron-perception-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-perception-cpu",
    "${REGISTRY}/ros-tf:iron-perception-cpu-tf2.21.0"
  ]
}

target "iron-desktop-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-desktop-cpu",
    "${REGISTRY}/ros-tf:iron-desktop-cpu-tf2.21.0"
  ]
}

target "iron-desktop-full-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-desktop-full-cpu",
    "${REGISTRY}/ros-tf:iron-desktop-full-cpu-tf2.21.0"
  ]
}

target "iron-core-run-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-core-run-cpu",
    "${REGISTRY}/ros-tf:iron-core-run-cpu-tf2.21.0"
  ]
}

target "iron-base-run-tensorflow-cpu" {
  inherits = ["_iron", "_tensorflow-cpu-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:iron-base-run-cpu",
    "${REGISTRY}/ros-tf:iron-base-run-cpu-tf2.21.0"
  ]
}

target "iron-core-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-core-cu128",
    "${REGISTRY}/ros-ml:iron-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-base-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-base-cu128",
    "${REGISTRY}/ros-ml:iron-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:iron"
  ]
}

target "iron-perception-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-perception-cu128",
    "${REGISTRY}/ros-ml:iron-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-desktop-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-desktop-cu128",
    "${REGISTRY}/ros-ml:iron-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-desktop-full-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-desktop-full-cu128",
    "${REGISTRY}/ros-ml:iron-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-core-run-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-core-run-cu128",
    "${REGISTRY}/ros-ml:iron-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-base-run-ml-cu128" {
  inherits = ["_iron", "_ml-cu128-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "iron-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-base-run-cu128",
    "${REGISTRY}/ros-ml:iron-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "iron-core-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-core", "ros", "iron-core") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-core-cpu",
    "${REGISTRY}/ros-ml:iron-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-base-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-base", "ros", "iron-base") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-base-cpu",
    "${REGISTRY}/ros-ml:iron-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-perception-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-perception", "ros", "iron-perception") }
  labels = {
    "org.opencontainers.image.title"       = "iron-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-perception-cpu",
    "${REGISTRY}/ros-ml:iron-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-desktop-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-desktop", "ros", "iron-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-desktop-cpu",
    "${REGISTRY}/ros-ml:iron-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-desktop-full-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "iron-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-desktop-full-cpu",
    "${REGISTRY}/ros-ml:iron-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-core-run-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-core-run", "ros", "iron-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-core-run-cpu",
    "${REGISTRY}/ros-ml:iron-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "iron-base-run-ml-cpu" {
  inherits = ["_iron", "_ml-cpu-py310"]
  contexts = { ros = dependency("iron-base-run", "ros", "iron-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "iron-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (iron), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "iron-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:iron-base-run-cpu",
    "${REGISTRY}/ros-ml:iron-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

# ---- jazzy ----------------------------------------------------------------------------------------------------------

target "_jazzy" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_24_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_24_04)[1], null)
    "io.rosml.distribution"                = "jazzy"
    "io.rosml.os"                          = "ubuntu-24.04"
    "io.rosml.python"                      = "3.12"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["jazzy"], null)
  }
}

target "_jazzy-ros" {
  inherits  = ["_jazzy"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "jazzy"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "live" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "noble"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/jazzy/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.noble_all.deb@sha256:f31d84adf5054c7d60ded0e82c0f776a77ea33af53d08f40b9ad7c94cca55296"
    ROS_SYNC_DATE        = try(sync_dates["jazzy"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "jazzy-core" {
  inherits = ["_jazzy-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-core"
  ]
}

target "jazzy-base" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = dependency("jazzy-core", "ros", "jazzy-core") }
  args     = { ROS_PACKAGES = "ros-jazzy-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-base",
    "${REGISTRY}/ros:jazzy",
    "${REGISTRY}/ros:latest"
  ]
}

target "jazzy-perception" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = dependency("jazzy-base", "ros", "jazzy-base") }
  args     = { ROS_PACKAGES = "ros-jazzy-perception" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-perception"
  ]
}

target "jazzy-desktop" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = dependency("jazzy-perception", "ros", "jazzy-perception") }
  args     = { ROS_PACKAGES = "ros-jazzy-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-desktop"
  ]
}

target "jazzy-desktop-full" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  args     = { ROS_PACKAGES = "ros-jazzy-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-desktop-full"
  ]
}

target "jazzy-core-run" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = "target:_os-ubuntu-24-04-run" }
  args = {
    ROS_PACKAGES = "ros-jazzy-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-core-run"
  ]
}

target "jazzy-base-run" {
  inherits = ["_jazzy-ros"]
  contexts = { parent = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  args = {
    ROS_PACKAGES = "ros-jazzy-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy)"
    "org.opencontainers.image.version"     = "jazzy-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-base-run"
  ]
}

target "jazzy-core-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-cu128",
    "${REGISTRY}/ros-cuda:jazzy-core-cu128-cuda12.8.90"
  ]
}

target "jazzy-base-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-cu128",
    "${REGISTRY}/ros-cuda:jazzy-base-cu128-cuda12.8.90"
  ]
}

target "jazzy-perception-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-perception-cu128",
    "${REGISTRY}/ros-cuda:jazzy-perception-cu128-cuda12.8.90"
  ]
}

target "jazzy-desktop-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu128",
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu128-cuda12.8.90"
  ]
}

target "jazzy-desktop-full-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu128-cuda12.8.90"
  ]
}

target "jazzy-core-run-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu128",
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu128-cuda12.8.90"
  ]
}

target "jazzy-base-run-cuda-cu128" {
  inherits = ["_jazzy", "_cuda-cu128-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu128",
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu128-cuda12.8.90"
  ]
}

target "jazzy-core-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-cu130",
    "${REGISTRY}/ros-cuda:jazzy-core-cu130-cuda13.0.96"
  ]
}

target "jazzy-base-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-cu130",
    "${REGISTRY}/ros-cuda:jazzy-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:jazzy",
    "${REGISTRY}/ros-cuda:latest"
  ]
}

target "jazzy-perception-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-perception-cu130",
    "${REGISTRY}/ros-cuda:jazzy-perception-cu130-cuda13.0.96"
  ]
}

target "jazzy-desktop-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu130",
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu130-cuda13.0.96"
  ]
}

target "jazzy-desktop-full-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu130-cuda13.0.96"
  ]
}

target "jazzy-core-run-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu130",
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu130-cuda13.0.96"
  ]
}

target "jazzy-base-run-cuda-cu130" {
  inherits = ["_jazzy", "_cuda-cu130-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu130",
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu130-cuda13.0.96"
  ]
}

target "jazzy-core-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-cu132",
    "${REGISTRY}/ros-cuda:jazzy-core-cu132-cuda13.2.86"
  ]
}

target "jazzy-base-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-cu132",
    "${REGISTRY}/ros-cuda:jazzy-base-cu132-cuda13.2.86"
  ]
}

target "jazzy-perception-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-perception-cu132",
    "${REGISTRY}/ros-cuda:jazzy-perception-cu132-cuda13.2.86"
  ]
}

target "jazzy-desktop-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu132",
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu132-cuda13.2.86"
  ]
}

target "jazzy-desktop-full-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu132-cuda13.2.86"
  ]
}

target "jazzy-core-run-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu132",
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu132-cuda13.2.86"
  ]
}

target "jazzy-base-run-cuda-cu132" {
  inherits = ["_jazzy", "_cuda-cu132-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu132",
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu132-cuda13.2.86"
  ]
}

target "jazzy-core-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-cu121",
    "${REGISTRY}/ros-cuda:jazzy-core-cu121-cuda12.1.105"
  ]
}

target "jazzy-base-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-cu121",
    "${REGISTRY}/ros-cuda:jazzy-base-cu121-cuda12.1.105"
  ]
}

target "jazzy-perception-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-perception-cu121",
    "${REGISTRY}/ros-cuda:jazzy-perception-cu121-cuda12.1.105"
  ]
}

target "jazzy-desktop-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu121",
    "${REGISTRY}/ros-cuda:jazzy-desktop-cu121-cuda12.1.105"
  ]
}

target "jazzy-desktop-full-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:jazzy-desktop-full-cu121-cuda12.1.105"
  ]
}

target "jazzy-core-run-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu121",
    "${REGISTRY}/ros-cuda:jazzy-core-run-cu121-cuda12.1.105"
  ]
}

target "jazzy-base-run-cuda-cu121" {
  inherits = ["_jazzy", "_cuda-cu121-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu121",
    "${REGISTRY}/ros-cuda:jazzy-base-run-cu121-cuda12.1.105"
  ]
}

target "jazzy-core-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-cu128",
    "${REGISTRY}/ros-torch:jazzy-core-cu128-torch2.10.0"
  ]
}

target "jazzy-base-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-cu128",
    "${REGISTRY}/ros-torch:jazzy-base-cu128-torch2.10.0"
  ]
}

target "jazzy-perception-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-perception-cu128",
    "${REGISTRY}/ros-torch:jazzy-perception-cu128-torch2.10.0"
  ]
}

target "jazzy-desktop-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-cu128",
    "${REGISTRY}/ros-torch:jazzy-desktop-cu128-torch2.10.0"
  ]
}

target "jazzy-desktop-full-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu128-torch2.10.0"
  ]
}

target "jazzy-core-run-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-run-cu128",
    "${REGISTRY}/ros-torch:jazzy-core-run-cu128-torch2.10.0"
  ]
}

target "jazzy-base-run-torch-cu128" {
  inherits = ["_jazzy", "_torch-cu128-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-run-cu128",
    "${REGISTRY}/ros-torch:jazzy-base-run-cu128-torch2.10.0"
  ]
}

target "jazzy-core-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-cu130",
    "${REGISTRY}/ros-torch:jazzy-core-cu130-torch2.14.1"
  ]
}

target "jazzy-base-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-cu130",
    "${REGISTRY}/ros-torch:jazzy-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:jazzy",
    "${REGISTRY}/ros-torch:latest"
  ]
}

target "jazzy-perception-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-perception-cu130",
    "${REGISTRY}/ros-torch:jazzy-perception-cu130-torch2.14.1"
  ]
}

target "jazzy-desktop-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-cu130",
    "${REGISTRY}/ros-torch:jazzy-desktop-cu130-torch2.14.1"
  ]
}

target "jazzy-desktop-full-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu130",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu130-torch2.14.1"
  ]
}

target "jazzy-core-run-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-run-cu130",
    "${REGISTRY}/ros-torch:jazzy-core-run-cu130-torch2.14.1"
  ]
}

target "jazzy-base-run-torch-cu130" {
  inherits = ["_jazzy", "_torch-cu130-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-run-cu130",
    "${REGISTRY}/ros-torch:jazzy-base-run-cu130-torch2.14.1"
  ]
}

target "jazzy-core-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-cu132",
    "${REGISTRY}/ros-torch:jazzy-core-cu132-torch2.15.0"
  ]
}

target "jazzy-base-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-cu132",
    "${REGISTRY}/ros-torch:jazzy-base-cu132-torch2.15.0"
  ]
}

target "jazzy-perception-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-perception-cu132",
    "${REGISTRY}/ros-torch:jazzy-perception-cu132-torch2.15.0"
  ]
}

target "jazzy-desktop-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-cu132",
    "${REGISTRY}/ros-torch:jazzy-desktop-cu132-torch2.15.0"
  ]
}

target "jazzy-desktop-full-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu132",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cu132-torch2.15.0"
  ]
}

target "jazzy-core-run-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-run-cu132",
    "${REGISTRY}/ros-torch:jazzy-core-run-cu132-torch2.15.0"
  ]
}

target "jazzy-base-run-torch-cu132" {
  inherits = ["_jazzy", "_torch-cu132-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-run-cu132",
    "${REGISTRY}/ros-torch:jazzy-base-run-cu132-torch2.15.0"
  ]
}

target "jazzy-core-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-cpu",
    "${REGISTRY}/ros-torch:jazzy-core-cpu-torch2.10.0"
  ]
}

target "jazzy-base-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-cpu",
    "${REGISTRY}/ros-torch:jazzy-base-cpu-torch2.10.0"
  ]
}

target "jazzy-perception-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-perception-cpu",
    "${REGISTRY}/ros-torch:jazzy-perception-cpu-torch2.10.0"
  ]
}

target "jazzy-desktop-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-cpu",
    "${REGISTRY}/ros-torch:jazzy-desktop-cpu-torch2.10.0"
  ]
}

target "jazzy-desktop-full-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cpu",
    "${REGISTRY}/ros-torch:jazzy-desktop-full-cpu-torch2.10.0"
  ]
}

target "jazzy-core-run-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-core-run-cpu",
    "${REGISTRY}/ros-torch:jazzy-core-run-cpu-torch2.10.0"
  ]
}

target "jazzy-base-run-torch-cpu" {
  inherits = ["_jazzy", "_torch-cpu-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-base-run-cpu",
    "${REGISTRY}/ros-torch:jazzy-base-run-cpu-torch2.10.0"
  ]
}

target "jazzy-core-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-core-cu128",
    "${REGISTRY}/ros-tf:jazzy-core-cu128-tf2.20.0"
  ]
}

target "jazzy-base-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-base-cu128",
    "${REGISTRY}/ros-tf:jazzy-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:jazzy",
    "${REGISTRY}/ros-tf:latest"
  ]
}

target "jazzy-perception-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-perception-cu128",
    "${REGISTRY}/ros-tf:jazzy-perception-cu128-tf2.20.0"
  ]
}

target "jazzy-desktop-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-desktop-cu128",
    "${REGISTRY}/ros-tf:jazzy-desktop-cu128-tf2.20.0"
  ]
}

target "jazzy-desktop-full-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-tf:jazzy-desktop-full-cu128-tf2.20.0"
  ]
}

target "jazzy-core-run-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-core-run-cu128",
    "${REGISTRY}/ros-tf:jazzy-core-run-cu128-tf2.20.0"
  ]
}

target "jazzy-base-run-tensorflow-cu128" {
  inherits = ["_jazzy", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-base-run-cu128",
    "${REGISTRY}/ros-tf:jazzy-base-run-cu128-tf2.20.0"
  ]
}

target "jazzy-core-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-core-cpu",
    "${REGISTRY}/ros-tf:jazzy-core-cpu-tf2.21.0"
  ]
}

target "jazzy-base-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-base-cpu",
    "${REGISTRY}/ros-tf:jazzy-base-cpu-tf2.21.0"
  ]
}

target "jazzy-perception-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-perception-cpu",
    "${REGISTRY}/ros-tf:jazzy-perception-cpu-tf2.21.0"
  ]
}

target "jazzy-desktop-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-desktop-cpu",
    "${REGISTRY}/ros-tf:jazzy-desktop-cpu-tf2.21.0"
  ]
}

target "jazzy-desktop-full-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-desktop-full-cpu",
    "${REGISTRY}/ros-tf:jazzy-desktop-full-cpu-tf2.21.0"
  ]
}

target "jazzy-core-run-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-core-run-cpu",
    "${REGISTRY}/ros-tf:jazzy-core-run-cpu-tf2.21.0"
  ]
}

target "jazzy-base-run-tensorflow-cpu" {
  inherits = ["_jazzy", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-base-run-cpu",
    "${REGISTRY}/ros-tf:jazzy-base-run-cpu-tf2.21.0"
  ]
}

target "jazzy-core-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-core-cu128",
    "${REGISTRY}/ros-ml:jazzy-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-base-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-base-cu128",
    "${REGISTRY}/ros-ml:jazzy-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:jazzy",
    "${REGISTRY}/ros-ml:latest"
  ]
}

target "jazzy-perception-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-perception-cu128",
    "${REGISTRY}/ros-ml:jazzy-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-desktop-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-desktop-cu128",
    "${REGISTRY}/ros-ml:jazzy-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-desktop-full-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cu128",
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-core-run-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-core-run-cu128",
    "${REGISTRY}/ros-ml:jazzy-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-base-run-ml-cu128" {
  inherits = ["_jazzy", "_ml-cu128-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-base-run-cu128",
    "${REGISTRY}/ros-ml:jazzy-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-core-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-core", "ros", "jazzy-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-core-cpu",
    "${REGISTRY}/ros-ml:jazzy-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-base-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-base", "ros", "jazzy-base") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-base-cpu",
    "${REGISTRY}/ros-ml:jazzy-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-perception-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-perception", "ros", "jazzy-perception") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-perception-cpu",
    "${REGISTRY}/ros-ml:jazzy-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-desktop-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-desktop-cpu",
    "${REGISTRY}/ros-ml:jazzy-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-desktop-full-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cpu",
    "${REGISTRY}/ros-ml:jazzy-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-core-run-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-core-run-cpu",
    "${REGISTRY}/ros-ml:jazzy-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-base-run-ml-cpu" {
  inherits = ["_jazzy", "_ml-cpu-py312"]
  contexts = { ros = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (jazzy), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-base-run-cpu",
    "${REGISTRY}/ros-ml:jazzy-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "jazzy-core-triton-cu128" {
  inherits = ["_jazzy", "_none-triton-cu128-py312"]
}

target "jazzy-core-triton-cu130" {
  inherits = ["_jazzy", "_none-triton-cu130-py312"]
}

target "jazzy-core-triton-cu132" {
  inherits = ["_jazzy", "_none-triton-cu132-py312"]
}

target "jazzy-core-triton-cpu" {
  inherits = ["_jazzy", "_none-triton-cpu-py312"]
}

target "jazzy-core-tensorrt-rtx-cu130" {
  inherits = ["_jazzy", "_none-tensorrt-rtx-cu130-py312"]
}

target "jazzy-core-tensorrt-rtx-cu132" {
  inherits = ["_jazzy", "_none-tensorrt-rtx-cu132-py312"]
}

# ---- kilted ---------------------------------------------------------------------------------------------------------

target "_kilted" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_24_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_24_04)[1], null)
    "io.rosml.distribution"                = "kilted"
    "io.rosml.os"                          = "ubuntu-24.04"
    "io.rosml.python"                      = "3.12"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["kilted"], null)
  }
}

target "_kilted-ros" {
  inherits  = ["_kilted"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "kilted"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "live" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "noble"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/kilted/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.noble_all.deb@sha256:f31d84adf5054c7d60ded0e82c0f776a77ea33af53d08f40b9ad7c94cca55296"
    ROS_SYNC_DATE        = try(sync_dates["kilted"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "kilted-core" {
  inherits = ["_kilted-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-core"
  ]
}

target "kilted-base" {
  inherits = ["_kilted-ros"]
  contexts = { parent = dependency("kilted-core", "ros", "kilted-core") }
  args     = { ROS_PACKAGES = "ros-kilted-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base"
    "org.opencontainers.image.description" = "ROS 2 base (kilted)"
    "org.opencontainers.image.version"     = "kilted-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-base",
    "${REGISTRY}/ros:kilted"
  ]
}

target "kilted-perception" {
  inherits = ["_kilted-ros"]
  contexts = { parent = dependency("kilted-base", "ros", "kilted-base") }
  args     = { ROS_PACKAGES = "ros-kilted-perception" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted)"
    "org.opencontainers.image.version"     = "kilted-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-perception"
  ]
}

target "kilted-desktop" {
  inherits = ["_kilted-ros"]
  contexts = { parent = dependency("kilted-perception", "ros", "kilted-perception") }
  args     = { ROS_PACKAGES = "ros-kilted-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted)"
    "org.opencontainers.image.version"     = "kilted-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-desktop"
  ]
}

target "kilted-desktop-full" {
  inherits = ["_kilted-ros"]
  contexts = { parent = dependency("kilted-desktop", "ros", "kilted-desktop") }
  args     = { ROS_PACKAGES = "ros-kilted-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted)"
    "org.opencontainers.image.version"     = "kilted-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-desktop-full"
  ]
}

target "kilted-core-run" {
  inherits = ["_kilted-ros"]
  contexts = { parent = "target:_os-ubuntu-24-04-run" }
  args = {
    ROS_PACKAGES = "ros-kilted-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted)"
    "org.opencontainers.image.version"     = "kilted-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-core-run"
  ]
}

target "kilted-base-run" {
  inherits = ["_kilted-ros"]
  contexts = { parent = dependency("kilted-core-run", "ros", "kilted-core-run") }
  args = {
    ROS_PACKAGES = "ros-kilted-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted)"
    "org.opencontainers.image.version"     = "kilted-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:kilted-base-run"
  ]
}

target "kilted-core-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-cu128",
    "${REGISTRY}/ros-cuda:kilted-core-cu128-cuda12.8.90"
  ]
}

target "kilted-base-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-cu128",
    "${REGISTRY}/ros-cuda:kilted-base-cu128-cuda12.8.90"
  ]
}

target "kilted-perception-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-perception-cu128",
    "${REGISTRY}/ros-cuda:kilted-perception-cu128-cuda12.8.90"
  ]
}

target "kilted-desktop-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-cu128",
    "${REGISTRY}/ros-cuda:kilted-desktop-cu128-cuda12.8.90"
  ]
}

target "kilted-desktop-full-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu128-cuda12.8.90"
  ]
}

target "kilted-core-run-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-run-cu128",
    "${REGISTRY}/ros-cuda:kilted-core-run-cu128-cuda12.8.90"
  ]
}

target "kilted-base-run-cuda-cu128" {
  inherits = ["_kilted", "_cuda-cu128-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-run-cu128",
    "${REGISTRY}/ros-cuda:kilted-base-run-cu128-cuda12.8.90"
  ]
}

target "kilted-core-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-cu130",
    "${REGISTRY}/ros-cuda:kilted-core-cu130-cuda13.0.96"
  ]
}

target "kilted-base-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-cu130",
    "${REGISTRY}/ros-cuda:kilted-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:kilted"
  ]
}

target "kilted-perception-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-perception-cu130",
    "${REGISTRY}/ros-cuda:kilted-perception-cu130-cuda13.0.96"
  ]
}

target "kilted-desktop-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-cu130",
    "${REGISTRY}/ros-cuda:kilted-desktop-cu130-cuda13.0.96"
  ]
}

target "kilted-desktop-full-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu130-cuda13.0.96"
  ]
}

target "kilted-core-run-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-run-cu130",
    "${REGISTRY}/ros-cuda:kilted-core-run-cu130-cuda13.0.96"
  ]
}

target "kilted-base-run-cuda-cu130" {
  inherits = ["_kilted", "_cuda-cu130-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-run-cu130",
    "${REGISTRY}/ros-cuda:kilted-base-run-cu130-cuda13.0.96"
  ]
}

target "kilted-core-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-cu132",
    "${REGISTRY}/ros-cuda:kilted-core-cu132-cuda13.2.86"
  ]
}

target "kilted-base-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-cu132",
    "${REGISTRY}/ros-cuda:kilted-base-cu132-cuda13.2.86"
  ]
}

target "kilted-perception-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-perception-cu132",
    "${REGISTRY}/ros-cuda:kilted-perception-cu132-cuda13.2.86"
  ]
}

target "kilted-desktop-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-cu132",
    "${REGISTRY}/ros-cuda:kilted-desktop-cu132-cuda13.2.86"
  ]
}

target "kilted-desktop-full-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu132-cuda13.2.86"
  ]
}

target "kilted-core-run-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-run-cu132",
    "${REGISTRY}/ros-cuda:kilted-core-run-cu132-cuda13.2.86"
  ]
}

target "kilted-base-run-cuda-cu132" {
  inherits = ["_kilted", "_cuda-cu132-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-run-cu132",
    "${REGISTRY}/ros-cuda:kilted-base-run-cu132-cuda13.2.86"
  ]
}

target "kilted-core-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-cu121",
    "${REGISTRY}/ros-cuda:kilted-core-cu121-cuda12.1.105"
  ]
}

target "kilted-base-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-cu121",
    "${REGISTRY}/ros-cuda:kilted-base-cu121-cuda12.1.105"
  ]
}

target "kilted-perception-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-perception-cu121",
    "${REGISTRY}/ros-cuda:kilted-perception-cu121-cuda12.1.105"
  ]
}

target "kilted-desktop-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-cu121",
    "${REGISTRY}/ros-cuda:kilted-desktop-cu121-cuda12.1.105"
  ]
}

target "kilted-desktop-full-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:kilted-desktop-full-cu121-cuda12.1.105"
  ]
}

target "kilted-core-run-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-core-run-cu121",
    "${REGISTRY}/ros-cuda:kilted-core-run-cu121-cuda12.1.105"
  ]
}

target "kilted-base-run-cuda-cu121" {
  inherits = ["_kilted", "_cuda-cu121-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "kilted-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:kilted-base-run-cu121",
    "${REGISTRY}/ros-cuda:kilted-base-run-cu121-cuda12.1.105"
  ]
}

target "kilted-core-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-cu128",
    "${REGISTRY}/ros-torch:kilted-core-cu128-torch2.10.0"
  ]
}

target "kilted-base-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-cu128",
    "${REGISTRY}/ros-torch:kilted-base-cu128-torch2.10.0"
  ]
}

target "kilted-perception-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-perception-cu128",
    "${REGISTRY}/ros-torch:kilted-perception-cu128-torch2.10.0"
  ]
}

target "kilted-desktop-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-cu128",
    "${REGISTRY}/ros-torch:kilted-desktop-cu128-torch2.10.0"
  ]
}

target "kilted-desktop-full-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu128-torch2.10.0"
  ]
}

target "kilted-core-run-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-run-cu128",
    "${REGISTRY}/ros-torch:kilted-core-run-cu128-torch2.10.0"
  ]
}

target "kilted-base-run-torch-cu128" {
  inherits = ["_kilted", "_torch-cu128-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-run-cu128",
    "${REGISTRY}/ros-torch:kilted-base-run-cu128-torch2.10.0"
  ]
}

target "kilted-core-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-cu130",
    "${REGISTRY}/ros-torch:kilted-core-cu130-torch2.14.1"
  ]
}

target "kilted-base-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-cu130",
    "${REGISTRY}/ros-torch:kilted-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:kilted"
  ]
}

target "kilted-perception-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-perception-cu130",
    "${REGISTRY}/ros-torch:kilted-perception-cu130-torch2.14.1"
  ]
}

target "kilted-desktop-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-cu130",
    "${REGISTRY}/ros-torch:kilted-desktop-cu130-torch2.14.1"
  ]
}

target "kilted-desktop-full-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu130",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu130-torch2.14.1"
  ]
}

target "kilted-core-run-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-run-cu130",
    "${REGISTRY}/ros-torch:kilted-core-run-cu130-torch2.14.1"
  ]
}

target "kilted-base-run-torch-cu130" {
  inherits = ["_kilted", "_torch-cu130-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "kilted-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-run-cu130",
    "${REGISTRY}/ros-torch:kilted-base-run-cu130-torch2.14.1"
  ]
}

target "kilted-core-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-cu132",
    "${REGISTRY}/ros-torch:kilted-core-cu132-torch2.15.0"
  ]
}

target "kilted-base-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-cu132",
    "${REGISTRY}/ros-torch:kilted-base-cu132-torch2.15.0"
  ]
}

target "kilted-perception-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-perception-cu132",
    "${REGISTRY}/ros-torch:kilted-perception-cu132-torch2.15.0"
  ]
}

target "kilted-desktop-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-cu132",
    "${REGISTRY}/ros-torch:kilted-desktop-cu132-torch2.15.0"
  ]
}

target "kilted-desktop-full-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu132",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cu132-torch2.15.0"
  ]
}

target "kilted-core-run-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-run-cu132",
    "${REGISTRY}/ros-torch:kilted-core-run-cu132-torch2.15.0"
  ]
}

target "kilted-base-run-torch-cu132" {
  inherits = ["_kilted", "_torch-cu132-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "kilted-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-run-cu132",
    "${REGISTRY}/ros-torch:kilted-base-run-cu132-torch2.15.0"
  ]
}

target "kilted-core-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-cpu",
    "${REGISTRY}/ros-torch:kilted-core-cpu-torch2.10.0"
  ]
}

target "kilted-base-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-cpu",
    "${REGISTRY}/ros-torch:kilted-base-cpu-torch2.10.0"
  ]
}

target "kilted-perception-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-perception-cpu",
    "${REGISTRY}/ros-torch:kilted-perception-cpu-torch2.10.0"
  ]
}

target "kilted-desktop-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-cpu",
    "${REGISTRY}/ros-torch:kilted-desktop-cpu-torch2.10.0"
  ]
}

target "kilted-desktop-full-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-desktop-full-cpu",
    "${REGISTRY}/ros-torch:kilted-desktop-full-cpu-torch2.10.0"
  ]
}

target "kilted-core-run-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-core-run-cpu",
    "${REGISTRY}/ros-torch:kilted-core-run-cpu-torch2.10.0"
  ]
}

target "kilted-base-run-torch-cpu" {
  inherits = ["_kilted", "_torch-cpu-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "kilted-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:kilted-base-run-cpu",
    "${REGISTRY}/ros-torch:kilted-base-run-cpu-torch2.10.0"
  ]
}

target "kilted-core-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-core-cu128",
    "${REGISTRY}/ros-tf:kilted-core-cu128-tf2.20.0"
  ]
}

target "kilted-base-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-base-cu128",
    "${REGISTRY}/ros-tf:kilted-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:kilted"
  ]
}

target "kilted-perception-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-perception-cu128",
    "${REGISTRY}/ros-tf:kilted-perception-cu128-tf2.20.0"
  ]
}

target "kilted-desktop-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-desktop-cu128",
    "${REGISTRY}/ros-tf:kilted-desktop-cu128-tf2.20.0"
  ]
}

target "kilted-desktop-full-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-tf:kilted-desktop-full-cu128-tf2.20.0"
  ]
}

target "kilted-core-run-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-core-run-cu128",
    "${REGISTRY}/ros-tf:kilted-core-run-cu128-tf2.20.0"
  ]
}

target "kilted-base-run-tensorflow-cu128" {
  inherits = ["_kilted", "_tensorflow-cu128-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-base-run-cu128",
    "${REGISTRY}/ros-tf:kilted-base-run-cu128-tf2.20.0"
  ]
}

target "kilted-core-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-core-cpu",
    "${REGISTRY}/ros-tf:kilted-core-cpu-tf2.21.0"
  ]
}

target "kilted-base-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-base-cpu",
    "${REGISTRY}/ros-tf:kilted-base-cpu-tf2.21.0"
  ]
}

target "kilted-perception-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-perception-cpu",
    "${REGISTRY}/ros-tf:kilted-perception-cpu-tf2.21.0"
  ]
}

target "kilted-desktop-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-desktop-cpu",
    "${REGISTRY}/ros-tf:kilted-desktop-cpu-tf2.21.0"
  ]
}

target "kilted-desktop-full-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-desktop-full-cpu",
    "${REGISTRY}/ros-tf:kilted-desktop-full-cpu-tf2.21.0"
  ]
}

target "kilted-core-run-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-core-run-cpu",
    "${REGISTRY}/ros-tf:kilted-core-run-cpu-tf2.21.0"
  ]
}

target "kilted-base-run-tensorflow-cpu" {
  inherits = ["_kilted", "_tensorflow-cpu-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:kilted-base-run-cpu",
    "${REGISTRY}/ros-tf:kilted-base-run-cpu-tf2.21.0"
  ]
}

target "kilted-core-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-core-cu128",
    "${REGISTRY}/ros-ml:kilted-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-base-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-base-cu128",
    "${REGISTRY}/ros-ml:kilted-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:kilted"
  ]
}

target "kilted-perception-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-perception-cu128",
    "${REGISTRY}/ros-ml:kilted-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-desktop-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-cu128",
    "${REGISTRY}/ros-ml:kilted-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-desktop-full-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-full-cu128",
    "${REGISTRY}/ros-ml:kilted-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-core-run-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-core-run-cu128",
    "${REGISTRY}/ros-ml:kilted-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-base-run-ml-cu128" {
  inherits = ["_kilted", "_ml-cu128-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "kilted-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-base-run-cu128",
    "${REGISTRY}/ros-ml:kilted-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "kilted-core-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-core", "ros", "kilted-core") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-core-cpu",
    "${REGISTRY}/ros-ml:kilted-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-base-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-base", "ros", "kilted-base") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-base-cpu",
    "${REGISTRY}/ros-ml:kilted-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-perception-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-perception", "ros", "kilted-perception") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-perception-cpu",
    "${REGISTRY}/ros-ml:kilted-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-desktop-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop", "ros", "kilted-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-cpu",
    "${REGISTRY}/ros-ml:kilted-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-desktop-full-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-desktop-full-cpu",
    "${REGISTRY}/ros-ml:kilted-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-core-run-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-core-run", "ros", "kilted-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-core-run-cpu",
    "${REGISTRY}/ros-ml:kilted-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "kilted-base-run-ml-cpu" {
  inherits = ["_kilted", "_ml-cpu-py312"]
  contexts = { ros = dependency("kilted-base-run", "ros", "kilted-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "kilted-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (kilted), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "kilted-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:kilted-base-run-cpu",
    "${REGISTRY}/ros-ml:kilted-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

# ---- lyrical --------------------------------------------------------------------------------------------------------

target "_lyrical" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_26_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_26_04)[1], null)
    "io.rosml.distribution"                = "lyrical"
    "io.rosml.os"                          = "ubuntu-26.04"
    "io.rosml.python"                      = "3.14"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["lyrical"], null)
  }
}

target "_lyrical-ros" {
  inherits  = ["_lyrical"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "lyrical"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "live" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "resolute"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/lyrical/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.resolute_all.deb@sha256:e70bc980395f4a3b366b9c5e7f8f9b4d63a4064fb115f6ff3bc52f7faa02ef69"
    ROS_SYNC_DATE        = try(sync_dates["lyrical"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "lyrical-core" {
  inherits = ["_lyrical-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-core"
  ]
}

target "lyrical-base" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = dependency("lyrical-core", "ros", "lyrical-core") }
  args     = { ROS_PACKAGES = "ros-lyrical-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-base",
    "${REGISTRY}/ros:lyrical"
  ]
}

target "lyrical-perception" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = dependency("lyrical-base", "ros", "lyrical-base") }
  args     = { ROS_PACKAGES = "ros-lyrical-perception" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-perception"
  ]
}

target "lyrical-desktop" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = dependency("lyrical-perception", "ros", "lyrical-perception") }
  args     = { ROS_PACKAGES = "ros-lyrical-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-desktop"
  ]
}

target "lyrical-desktop-full" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  args     = { ROS_PACKAGES = "ros-lyrical-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-desktop-full"
  ]
}

target "lyrical-core-run" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = "target:_os-ubuntu-26-04-run" }
  args = {
    ROS_PACKAGES = "ros-lyrical-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-core-run"
  ]
}

target "lyrical-base-run" {
  inherits = ["_lyrical-ros"]
  contexts = { parent = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  args = {
    ROS_PACKAGES = "ros-lyrical-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical)"
    "org.opencontainers.image.version"     = "lyrical-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:lyrical-base-run"
  ]
}

target "lyrical-core-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-cu128",
    "${REGISTRY}/ros-cuda:lyrical-core-cu128-cuda12.8.90"
  ]
}

target "lyrical-base-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-cu128",
    "${REGISTRY}/ros-cuda:lyrical-base-cu128-cuda12.8.90"
  ]
}

target "lyrical-perception-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-perception-cu128",
    "${REGISTRY}/ros-cuda:lyrical-perception-cu128-cuda12.8.90"
  ]
}

target "lyrical-desktop-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu128",
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu128-cuda12.8.90"
  ]
}

target "lyrical-desktop-full-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu128-cuda12.8.90"
  ]
}

target "lyrical-core-run-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu128",
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu128-cuda12.8.90"
  ]
}

target "lyrical-base-run-cuda-cu128" {
  inherits = ["_lyrical", "_cuda-cu128-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu128",
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu128-cuda12.8.90"
  ]
}

target "lyrical-core-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-cu130",
    "${REGISTRY}/ros-cuda:lyrical-core-cu130-cuda13.0.96"
  ]
}

target "lyrical-base-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-cu130",
    "${REGISTRY}/ros-cuda:lyrical-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:lyrical"
  ]
}

target "lyrical-perception-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-perception-cu130",
    "${REGISTRY}/ros-cuda:lyrical-perception-cu130-cuda13.0.96"
  ]
}

target "lyrical-desktop-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu130",
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu130-cuda13.0.96"
  ]
}

target "lyrical-desktop-full-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu130-cuda13.0.96"
  ]
}

target "lyrical-core-run-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu130",
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu130-cuda13.0.96"
  ]
}

target "lyrical-base-run-cuda-cu130" {
  inherits = ["_lyrical", "_cuda-cu130-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu130",
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu130-cuda13.0.96"
  ]
}

target "lyrical-core-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-cu132",
    "${REGISTRY}/ros-cuda:lyrical-core-cu132-cuda13.2.86"
  ]
}

target "lyrical-base-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-cu132",
    "${REGISTRY}/ros-cuda:lyrical-base-cu132-cuda13.2.86"
  ]
}

target "lyrical-perception-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-perception-cu132",
    "${REGISTRY}/ros-cuda:lyrical-perception-cu132-cuda13.2.86"
  ]
}

target "lyrical-desktop-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu132",
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu132-cuda13.2.86"
  ]
}

target "lyrical-desktop-full-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu132-cuda13.2.86"
  ]
}

target "lyrical-core-run-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu132",
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu132-cuda13.2.86"
  ]
}

target "lyrical-base-run-cuda-cu132" {
  inherits = ["_lyrical", "_cuda-cu132-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu132",
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu132-cuda13.2.86"
  ]
}

target "lyrical-core-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-cu121",
    "${REGISTRY}/ros-cuda:lyrical-core-cu121-cuda12.1.105"
  ]
}

target "lyrical-base-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-cu121",
    "${REGISTRY}/ros-cuda:lyrical-base-cu121-cuda12.1.105"
  ]
}

target "lyrical-perception-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-perception-cu121",
    "${REGISTRY}/ros-cuda:lyrical-perception-cu121-cuda12.1.105"
  ]
}

target "lyrical-desktop-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu121",
    "${REGISTRY}/ros-cuda:lyrical-desktop-cu121-cuda12.1.105"
  ]
}

target "lyrical-desktop-full-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:lyrical-desktop-full-cu121-cuda12.1.105"
  ]
}

target "lyrical-core-run-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu121",
    "${REGISTRY}/ros-cuda:lyrical-core-run-cu121-cuda12.1.105"
  ]
}

target "lyrical-base-run-cuda-cu121" {
  inherits = ["_lyrical", "_cuda-cu121-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu121",
    "${REGISTRY}/ros-cuda:lyrical-base-run-cu121-cuda12.1.105"
  ]
}

target "lyrical-core-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-cu128",
    "${REGISTRY}/ros-torch:lyrical-core-cu128-torch2.10.0"
  ]
}

target "lyrical-base-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-cu128",
    "${REGISTRY}/ros-torch:lyrical-base-cu128-torch2.10.0"
  ]
}

target "lyrical-perception-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cu128",
    "${REGISTRY}/ros-torch:lyrical-perception-cu128-torch2.10.0"
  ]
}

target "lyrical-desktop-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-cu128",
    "${REGISTRY}/ros-torch:lyrical-desktop-cu128-torch2.10.0"
  ]
}

target "lyrical-desktop-full-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu128",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu128-torch2.10.0"
  ]
}

target "lyrical-core-run-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-run-cu128",
    "${REGISTRY}/ros-torch:lyrical-core-run-cu128-torch2.10.0"
  ]
}

target "lyrical-base-run-torch-cu128" {
  inherits = ["_lyrical", "_torch-cu128-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-run-cu128",
    "${REGISTRY}/ros-torch:lyrical-base-run-cu128-torch2.10.0"
  ]
}

target "lyrical-core-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-cu130",
    "${REGISTRY}/ros-torch:lyrical-core-cu130-torch2.14.1"
  ]
}

target "lyrical-base-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-cu130",
    "${REGISTRY}/ros-torch:lyrical-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:lyrical"
  ]
}

target "lyrical-perception-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cu130",
    "${REGISTRY}/ros-torch:lyrical-perception-cu130-torch2.14.1"
  ]
}

target "lyrical-desktop-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-cu130",
    "${REGISTRY}/ros-torch:lyrical-desktop-cu130-torch2.14.1"
  ]
}

target "lyrical-desktop-full-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu130",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu130-torch2.14.1"
  ]
}

target "lyrical-core-run-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-run-cu130",
    "${REGISTRY}/ros-torch:lyrical-core-run-cu130-torch2.14.1"
  ]
}

target "lyrical-base-run-torch-cu130" {
  inherits = ["_lyrical", "_torch-cu130-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-run-cu130",
    "${REGISTRY}/ros-torch:lyrical-base-run-cu130-torch2.14.1"
  ]
}

target "lyrical-core-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-cu132",
    "${REGISTRY}/ros-torch:lyrical-core-cu132-torch2.15.0"
  ]
}

target "lyrical-base-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-cu132",
    "${REGISTRY}/ros-torch:lyrical-base-cu132-torch2.15.0"
  ]
}

target "lyrical-perception-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cu132",
    "${REGISTRY}/ros-torch:lyrical-perception-cu132-torch2.15.0"
  ]
}

target "lyrical-desktop-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-cu132",
    "${REGISTRY}/ros-torch:lyrical-desktop-cu132-torch2.15.0"
  ]
}

target "lyrical-desktop-full-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu132",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cu132-torch2.15.0"
  ]
}

target "lyrical-core-run-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-run-cu132",
    "${REGISTRY}/ros-torch:lyrical-core-run-cu132-torch2.15.0"
  ]
}

target "lyrical-base-run-torch-cu132" {
  inherits = ["_lyrical", "_torch-cu132-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "lyrical-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-run-cu132",
    "${REGISTRY}/ros-torch:lyrical-base-run-cu132-torch2.15.0"
  ]
}

target "lyrical-core-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-core", "ros", "lyrical-core") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-cpu",
    "${REGISTRY}/ros-torch:lyrical-core-cpu-torch2.10.0"
  ]
}

target "lyrical-base-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-base", "ros", "lyrical-base") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-cpu",
    "${REGISTRY}/ros-torch:lyrical-base-cpu-torch2.10.0"
  ]
}

target "lyrical-perception-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-perception", "ros", "lyrical-perception") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-perception-cpu",
    "${REGISTRY}/ros-torch:lyrical-perception-cpu-torch2.10.0"
  ]
}

target "lyrical-desktop-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-cpu",
    "${REGISTRY}/ros-torch:lyrical-desktop-cpu-torch2.10.0"
  ]
}

target "lyrical-desktop-full-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cpu",
    "${REGISTRY}/ros-torch:lyrical-desktop-full-cpu-torch2.10.0"
  ]
}

target "lyrical-core-run-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-core-run-cpu",
    "${REGISTRY}/ros-torch:lyrical-core-run-cpu-torch2.10.0"
  ]
}

target "lyrical-base-run-torch-cpu" {
  inherits = ["_lyrical", "_torch-cpu-py314"]
  contexts = { ros = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "lyrical-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (lyrical), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "lyrical-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:lyrical-base-run-cpu",
    "${REGISTRY}/ros-torch:lyrical-base-run-cpu-torch2.10.0"
  ]
}

target "lyrical-core-triton-cu128" {
  inherits = ["_lyrical", "_none-triton-cu128-py314"]
}

target "lyrical-core-triton-cu130" {
  inherits = ["_lyrical", "_none-triton-cu130-py314"]
}

target "lyrical-core-triton-cu132" {
  inherits = ["_lyrical", "_none-triton-cu132-py314"]
}

target "lyrical-core-triton-cpu" {
  inherits = ["_lyrical", "_none-triton-cpu-py314"]
}

target "lyrical-core-tensorrt-rtx-cu130" {
  inherits = ["_lyrical", "_none-tensorrt-rtx-cu130-py314"]
}

target "lyrical-core-tensorrt-rtx-cu132" {
  inherits = ["_lyrical", "_none-tensorrt-rtx-cu132-py314"]
}

# ---- rolling --------------------------------------------------------------------------------------------------------

target "_rolling" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_UBUNTU_26_04)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_UBUNTU_26_04)[1], null)
    "io.rosml.distribution"                = "rolling"
    "io.rosml.os"                          = "ubuntu-26.04"
    "io.rosml.python"                      = "3.14"
    "io.rosml.ros"                         = "2"
    "io.rosml.ros.sync"                    = try(sync_dates["rolling"], null)
  }
}

target "_rolling-ros" {
  inherits  = ["_rolling"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO           = "rolling"
    ROS_VERSION          = "2"
    ROS_CHANNEL          = ROS_CHANNEL == "" ? "live" : ROS_CHANNEL
    ROS_SNAPSHOT         = ROS_SNAPSHOT
    ROS_CODENAME         = "resolute"
    ROS_LIVE_ADDRESS     = "http://packages.ros.org/ros2/ubuntu"
    ROS_SNAPSHOT_ADDRESS = "http://snapshots.ros.org/rolling/{day}/ubuntu"
    ROS_TESTING_ADDRESS  = "http://packages.ros.org/ros2-testing/ubuntu"
    ROS_APT_SOURCE       = "https://github.com/ros-infrastructure/ros-apt-source/releases/download/1.3.0/ros2-apt-source_1.3.0.resolute_all.deb@sha256:e70bc980395f4a3b366b9c5e7f8f9b4d63a4064fb115f6ff3bc52f7faa02ef69"
    ROS_SYNC_DATE        = try(sync_dates["rolling"], "")
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "rolling-core" {
  inherits = ["_rolling-ros"]
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
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-core"
  ]
}

target "rolling-base" {
  inherits = ["_rolling-ros"]
  contexts = { parent = dependency("rolling-core", "ros", "rolling-core") }
  args     = { ROS_PACKAGES = "ros-rolling-ros-base" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base"
    "org.opencontainers.image.description" = "ROS 2 base (rolling)"
    "org.opencontainers.image.version"     = "rolling-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-base",
    "${REGISTRY}/ros:rolling"
  ]
}

target "rolling-perception" {
  inherits = ["_rolling-ros"]
  contexts = { parent = dependency("rolling-base", "ros", "rolling-base") }
  args     = { ROS_PACKAGES = "ros-rolling-perception" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling)"
    "org.opencontainers.image.version"     = "rolling-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-perception"
  ]
}

target "rolling-desktop" {
  inherits = ["_rolling-ros"]
  contexts = { parent = dependency("rolling-perception", "ros", "rolling-perception") }
  args     = { ROS_PACKAGES = "ros-rolling-desktop" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling)"
    "org.opencontainers.image.version"     = "rolling-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-desktop"
  ]
}

target "rolling-desktop-full" {
  inherits = ["_rolling-ros"]
  contexts = { parent = dependency("rolling-desktop", "ros", "rolling-desktop") }
  args     = { ROS_PACKAGES = "ros-rolling-desktop-full" }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling)"
    "org.opencontainers.image.version"     = "rolling-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-desktop-full"
  ]
}

target "rolling-core-run" {
  inherits = ["_rolling-ros"]
  contexts = { parent = "target:_os-ubuntu-26-04-run" }
  args = {
    ROS_PACKAGES = "ros-rolling-ros-core"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling)"
    "org.opencontainers.image.version"     = "rolling-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-core-run"
  ]
}

target "rolling-base-run" {
  inherits = ["_rolling-ros"]
  contexts = { parent = dependency("rolling-core-run", "ros", "rolling-core-run") }
  args = {
    ROS_PACKAGES = "ros-rolling-ros-base"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling)"
    "org.opencontainers.image.version"     = "rolling-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:rolling-base-run"
  ]
}

target "rolling-core-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-cu128",
    "${REGISTRY}/ros-cuda:rolling-core-cu128-cuda12.8.90"
  ]
}

target "rolling-base-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-cu128",
    "${REGISTRY}/ros-cuda:rolling-base-cu128-cuda12.8.90"
  ]
}

target "rolling-perception-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-perception-cu128",
    "${REGISTRY}/ros-cuda:rolling-perception-cu128-cuda12.8.90"
  ]
}

target "rolling-desktop-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-cu128",
    "${REGISTRY}/ros-cuda:rolling-desktop-cu128-cuda12.8.90"
  ]
}

target "rolling-desktop-full-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu128-cuda12.8.90"
  ]
}

target "rolling-core-run-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-run-cu128",
    "${REGISTRY}/ros-cuda:rolling-core-run-cu128-cuda12.8.90"
  ]
}

target "rolling-base-run-cuda-cu128" {
  inherits = ["_rolling", "_cuda-cu128-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-run-cu128",
    "${REGISTRY}/ros-cuda:rolling-base-run-cu128-cuda12.8.90"
  ]
}

target "rolling-core-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-cu130",
    "${REGISTRY}/ros-cuda:rolling-core-cu130-cuda13.0.96"
  ]
}

target "rolling-base-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-cu130",
    "${REGISTRY}/ros-cuda:rolling-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:rolling"
  ]
}

target "rolling-perception-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-perception-cu130",
    "${REGISTRY}/ros-cuda:rolling-perception-cu130-cuda13.0.96"
  ]
}

target "rolling-desktop-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-cu130",
    "${REGISTRY}/ros-cuda:rolling-desktop-cu130-cuda13.0.96"
  ]
}

target "rolling-desktop-full-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu130-cuda13.0.96"
  ]
}

target "rolling-core-run-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-run-cu130",
    "${REGISTRY}/ros-cuda:rolling-core-run-cu130-cuda13.0.96"
  ]
}

target "rolling-base-run-cuda-cu130" {
  inherits = ["_rolling", "_cuda-cu130-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-run-cu130",
    "${REGISTRY}/ros-cuda:rolling-base-run-cu130-cuda13.0.96"
  ]
}

target "rolling-core-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-cu132",
    "${REGISTRY}/ros-cuda:rolling-core-cu132-cuda13.2.86"
  ]
}

target "rolling-base-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-cu132",
    "${REGISTRY}/ros-cuda:rolling-base-cu132-cuda13.2.86"
  ]
}

target "rolling-perception-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-perception-cu132",
    "${REGISTRY}/ros-cuda:rolling-perception-cu132-cuda13.2.86"
  ]
}

target "rolling-desktop-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-cu132",
    "${REGISTRY}/ros-cuda:rolling-desktop-cu132-cuda13.2.86"
  ]
}

target "rolling-desktop-full-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu132-cuda13.2.86"
  ]
}

target "rolling-core-run-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-run-cu132",
    "${REGISTRY}/ros-cuda:rolling-core-run-cu132-cuda13.2.86"
  ]
}

target "rolling-base-run-cuda-cu132" {
  inherits = ["_rolling", "_cuda-cu132-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-run-cu132",
    "${REGISTRY}/ros-cuda:rolling-base-run-cu132-cuda13.2.86"
  ]
}

target "rolling-core-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-cu121",
    "${REGISTRY}/ros-cuda:rolling-core-cu121-cuda12.1.105"
  ]
}

target "rolling-base-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-cu121",
    "${REGISTRY}/ros-cuda:rolling-base-cu121-cuda12.1.105"
  ]
}

target "rolling-perception-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-perception-cu121",
    "${REGISTRY}/ros-cuda:rolling-perception-cu121-cuda12.1.105"
  ]
}

target "rolling-desktop-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-cu121",
    "${REGISTRY}/ros-cuda:rolling-desktop-cu121-cuda12.1.105"
  ]
}

target "rolling-desktop-full-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:rolling-desktop-full-cu121-cuda12.1.105"
  ]
}

target "rolling-core-run-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-core-run-cu121",
    "${REGISTRY}/ros-cuda:rolling-core-run-cu121-cuda12.1.105"
  ]
}

target "rolling-base-run-cuda-cu121" {
  inherits = ["_rolling", "_cuda-cu121-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "rolling-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:rolling-base-run-cu121",
    "${REGISTRY}/ros-cuda:rolling-base-run-cu121-cuda12.1.105"
  ]
}

target "rolling-core-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-cu128",
    "${REGISTRY}/ros-torch:rolling-core-cu128-torch2.10.0"
  ]
}

target "rolling-base-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-cu128",
    "${REGISTRY}/ros-torch:rolling-base-cu128-torch2.10.0"
  ]
}

target "rolling-perception-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cu128",
    "${REGISTRY}/ros-torch:rolling-perception-cu128-torch2.10.0"
  ]
}

target "rolling-desktop-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-cu128",
    "${REGISTRY}/ros-torch:rolling-desktop-cu128-torch2.10.0"
  ]
}

target "rolling-desktop-full-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu128",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu128-torch2.10.0"
  ]
}

target "rolling-core-run-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-run-cu128",
    "${REGISTRY}/ros-torch:rolling-core-run-cu128-torch2.10.0"
  ]
}

target "rolling-base-run-torch-cu128" {
  inherits = ["_rolling", "_torch-cu128-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "rolling-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-run-cu128",
    "${REGISTRY}/ros-torch:rolling-base-run-cu128-torch2.10.0"
  ]
}

target "rolling-core-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-cu130",
    "${REGISTRY}/ros-torch:rolling-core-cu130-torch2.14.1"
  ]
}

target "rolling-base-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-cu130",
    "${REGISTRY}/ros-torch:rolling-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:rolling"
  ]
}

target "rolling-perception-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cu130",
    "${REGISTRY}/ros-torch:rolling-perception-cu130-torch2.14.1"
  ]
}

target "rolling-desktop-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-cu130",
    "${REGISTRY}/ros-torch:rolling-desktop-cu130-torch2.14.1"
  ]
}

target "rolling-desktop-full-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu130",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu130-torch2.14.1"
  ]
}

target "rolling-core-run-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-run-cu130",
    "${REGISTRY}/ros-torch:rolling-core-run-cu130-torch2.14.1"
  ]
}

target "rolling-base-run-torch-cu130" {
  inherits = ["_rolling", "_torch-cu130-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "rolling-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-run-cu130",
    "${REGISTRY}/ros-torch:rolling-base-run-cu130-torch2.14.1"
  ]
}

target "rolling-core-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-cu132",
    "${REGISTRY}/ros-torch:rolling-core-cu132-torch2.15.0"
  ]
}

target "rolling-base-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-cu132",
    "${REGISTRY}/ros-torch:rolling-base-cu132-torch2.15.0"
  ]
}

target "rolling-perception-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cu132",
    "${REGISTRY}/ros-torch:rolling-perception-cu132-torch2.15.0"
  ]
}

target "rolling-desktop-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-cu132",
    "${REGISTRY}/ros-torch:rolling-desktop-cu132-torch2.15.0"
  ]
}

target "rolling-desktop-full-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu132",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cu132-torch2.15.0"
  ]
}

target "rolling-core-run-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-run-cu132",
    "${REGISTRY}/ros-torch:rolling-core-run-cu132-torch2.15.0"
  ]
}

target "rolling-base-run-torch-cu132" {
  inherits = ["_rolling", "_torch-cu132-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "rolling-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-run-cu132",
    "${REGISTRY}/ros-torch:rolling-base-run-cu132-torch2.15.0"
  ]
}

target "rolling-core-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-core", "ros", "rolling-core") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-cpu",
    "${REGISTRY}/ros-torch:rolling-core-cpu-torch2.10.0"
  ]
}

target "rolling-base-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-base", "ros", "rolling-base") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-cpu",
    "${REGISTRY}/ros-torch:rolling-base-cpu-torch2.10.0"
  ]
}

target "rolling-perception-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-perception", "ros", "rolling-perception") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 perception (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-perception-cpu",
    "${REGISTRY}/ros-torch:rolling-perception-cpu-torch2.10.0"
  ]
}

target "rolling-desktop-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-desktop", "ros", "rolling-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-cpu",
    "${REGISTRY}/ros-torch:rolling-desktop-cpu-torch2.10.0"
  ]
}

target "rolling-desktop-full-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 desktop-full (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-desktop-full-cpu",
    "${REGISTRY}/ros-torch:rolling-desktop-full-cpu-torch2.10.0"
  ]
}

target "rolling-core-run-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-core-run", "ros", "rolling-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core-run (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-core-run-cpu",
    "${REGISTRY}/ros-torch:rolling-core-run-cpu-torch2.10.0"
  ]
}

target "rolling-base-run-torch-cpu" {
  inherits = ["_rolling", "_torch-cpu-py314"]
  contexts = { ros = dependency("rolling-base-run", "ros", "rolling-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "rolling-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 base-run (rolling), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "rolling-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:rolling-base-run-cpu",
    "${REGISTRY}/ros-torch:rolling-base-run-cpu-torch2.10.0"
  ]
}

# ---- ros1-bookworm --------------------------------------------------------------------------------------------------

target "_ros1-bookworm" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_BOOKWORM)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_BOOKWORM)[1], null)
    "io.rosml.distribution"                = "ros1-bookworm"
    "io.rosml.os"                          = "bookworm"
    "io.rosml.python"                      = "3.11"
    "io.rosml.ros"                         = "1"
  }
}

target "_ros1-bookworm-ros" {
  inherits  = ["_ros1-bookworm"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO  = "Debian"
    ROS_VERSION = "1"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "ros1-bookworm-core" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = "target:_os-bookworm" }
  args = {
    ROS_PACKAGES = "rosbash ros-core ros-core-dev ros-core-python-dev"
    ROS_TOOLS    = "catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-core"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-core",
    "${REGISTRY}/ros:bookworm-core"
  ]
}

target "ros1-bookworm-base" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  args     = { ROS_PACKAGES = "rosbash ros-base ros-base-dev ros-base-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-base",
    "${REGISTRY}/ros:bookworm-base",
    "${REGISTRY}/ros:ros1-bookworm",
    "${REGISTRY}/ros:bookworm"
  ]
}

target "ros1-bookworm-robot" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  args     = { ROS_PACKAGES = "rosbash ros-robot ros-robot-dev ros-robot-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-robot",
    "${REGISTRY}/ros:bookworm-robot"
  ]
}

target "ros1-bookworm-perception" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  args     = { ROS_PACKAGES = "rosbash ros-perception ros-perception-dev ros-perception-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-perception",
    "${REGISTRY}/ros:bookworm-perception"
  ]
}

target "ros1-bookworm-desktop" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  args     = { ROS_PACKAGES = "rosbash ros-desktop ros-desktop-dev ros-desktop-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-desktop",
    "${REGISTRY}/ros:bookworm-desktop"
  ]
}

target "ros1-bookworm-desktop-full" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  args     = { ROS_PACKAGES = "rosbash ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-desktop-full",
    "${REGISTRY}/ros:bookworm-desktop-full"
  ]
}

target "ros1-bookworm-core-run" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = "target:_os-bookworm-run" }
  args = {
    ROS_PACKAGES = "rosbash ros-core ros-core-dev ros-core-python-dev"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-core-run",
    "${REGISTRY}/ros:bookworm-core-run"
  ]
}

target "ros1-bookworm-base-run" {
  inherits = ["_ros1-bookworm-ros"]
  contexts = { parent = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  args = {
    ROS_PACKAGES = "rosbash ros-base ros-base-dev ros-base-python-dev"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm)"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-bookworm-base-run",
    "${REGISTRY}/ros:bookworm-base-run"
  ]
}

target "ros1-bookworm-core-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-core-cu128",
    "${REGISTRY}/ros-cuda:bookworm-core-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-base-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-base-cu128",
    "${REGISTRY}/ros-cuda:bookworm-base-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-robot-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu128",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-perception-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu128",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-desktop-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu128",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-desktop-full-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-core-run-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu128",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-base-run-cuda-cu128" {
  inherits = ["_ros1-bookworm", "_cuda-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu128",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu128",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu128-cuda12.8.90"
  ]
}

target "ros1-bookworm-core-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-core-cu130",
    "${REGISTRY}/ros-cuda:bookworm-core-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-base-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-base-cu130",
    "${REGISTRY}/ros-cuda:bookworm-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:ros1-bookworm",
    "${REGISTRY}/ros-cuda:bookworm"
  ]
}

target "ros1-bookworm-robot-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu130",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-perception-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu130",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-desktop-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu130",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-desktop-full-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-core-run-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu130",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-base-run-cuda-cu130" {
  inherits  = ["_ros1-bookworm", "_cuda-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu130",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu130",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu130-cuda13.0.96"
  ]
}

target "ros1-bookworm-core-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-core-cu132",
    "${REGISTRY}/ros-cuda:bookworm-core-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-base-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-base-cu132",
    "${REGISTRY}/ros-cuda:bookworm-base-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-robot-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu132-cuda13.2.86"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu132",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-perception-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu132",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-desktop-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu132",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-desktop-full-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-core-run-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu132",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-base-run-cuda-cu132" {
  inherits  = ["_ros1-bookworm", "_cuda-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu132",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu132",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu132-cuda13.2.86"
  ]
}

target "ros1-bookworm-core-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-core-cu121",
    "${REGISTRY}/ros-cuda:bookworm-core-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-base-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-base-cu121",
    "${REGISTRY}/ros-cuda:bookworm-base-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-robot-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-robot-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu121",
    "${REGISTRY}/ros-cuda:bookworm-robot-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-perception-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-perception-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu121",
    "${REGISTRY}/ros-cuda:bookworm-perception-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-desktop-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu121",
    "${REGISTRY}/ros-cuda:bookworm-desktop-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-desktop-full-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-desktop-full-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:bookworm-desktop-full-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-core-run-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-core-run-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu121",
    "${REGISTRY}/ros-cuda:bookworm-core-run-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-base-run-cuda-cu121" {
  inherits = ["_ros1-bookworm", "_cuda-cu121-py311"]
  contexts = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu121",
    "${REGISTRY}/ros-cuda:ros1-bookworm-base-run-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu121",
    "${REGISTRY}/ros-cuda:bookworm-base-run-cu121-cuda12.1.105"
  ]
}

target "ros1-bookworm-core-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-core-cu128",
    "${REGISTRY}/ros-torch:bookworm-core-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-base-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-base-cu128",
    "${REGISTRY}/ros-torch:bookworm-base-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-robot-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu128-torch2.10.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-robot-cu128",
    "${REGISTRY}/ros-torch:bookworm-robot-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-perception-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-perception-cu128",
    "${REGISTRY}/ros-torch:bookworm-perception-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-desktop-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu128",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-desktop-full-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-core-run-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu128",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-base-run-torch-cu128" {
  inherits = ["_ros1-bookworm", "_torch-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu128",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu128",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu128-torch2.10.0"
  ]
}

target "ros1-bookworm-core-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-core-cu130",
    "${REGISTRY}/ros-torch:bookworm-core-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-base-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-base-cu130",
    "${REGISTRY}/ros-torch:bookworm-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:ros1-bookworm",
    "${REGISTRY}/ros-torch:bookworm"
  ]
}

target "ros1-bookworm-robot-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu130-torch2.14.1"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-robot-cu130",
    "${REGISTRY}/ros-torch:bookworm-robot-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-perception-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-perception-cu130",
    "${REGISTRY}/ros-torch:bookworm-perception-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-desktop-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu130",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-desktop-full-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu130",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-core-run-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu130",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-base-run-torch-cu130" {
  inherits  = ["_ros1-bookworm", "_torch-cu130-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu130",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu130",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu130-torch2.14.1"
  ]
}

target "ros1-bookworm-core-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-core-cu132",
    "${REGISTRY}/ros-torch:bookworm-core-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-base-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-base-cu132",
    "${REGISTRY}/ros-torch:bookworm-base-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-robot-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu132-torch2.15.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-robot-cu132",
    "${REGISTRY}/ros-torch:bookworm-robot-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-perception-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-perception-cu132",
    "${REGISTRY}/ros-torch:bookworm-perception-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-desktop-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu132",
    "${REGISTRY}/ros-torch:bookworm-desktop-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-desktop-full-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu132",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-core-run-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu132",
    "${REGISTRY}/ros-torch:bookworm-core-run-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-base-run-torch-cu132" {
  inherits  = ["_ros1-bookworm", "_torch-cu132-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu132",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu132",
    "${REGISTRY}/ros-torch:bookworm-base-run-cu132-torch2.15.0"
  ]
}

target "ros1-bookworm-core-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-core-cpu",
    "${REGISTRY}/ros-torch:bookworm-core-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-base-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-base-cpu",
    "${REGISTRY}/ros-torch:bookworm-base-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-robot-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cpu-torch2.10.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-robot-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-robot-cpu",
    "${REGISTRY}/ros-torch:bookworm-robot-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-perception-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-perception-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-perception-cpu",
    "${REGISTRY}/ros-torch:bookworm-perception-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-desktop-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-cpu",
    "${REGISTRY}/ros-torch:bookworm-desktop-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-desktop-full-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-desktop-full-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-torch:bookworm-desktop-full-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-core-run-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-core-run-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-core-run-cpu",
    "${REGISTRY}/ros-torch:bookworm-core-run-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-base-run-torch-cpu" {
  inherits  = ["_ros1-bookworm", "_torch-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cpu",
    "${REGISTRY}/ros-torch:ros1-bookworm-base-run-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:bookworm-base-run-cpu",
    "${REGISTRY}/ros-torch:bookworm-base-run-cpu-torch2.10.0"
  ]
}

target "ros1-bookworm-core-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-core-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-core-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-core-cu128",
    "${REGISTRY}/ros-tf:bookworm-core-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-base-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-base-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-base-cu128",
    "${REGISTRY}/ros-tf:bookworm-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:ros1-bookworm",
    "${REGISTRY}/ros-tf:bookworm"
  ]
}

target "ros1-bookworm-robot-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu128-tf2.20.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-robot-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-robot-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-robot-cu128",
    "${REGISTRY}/ros-tf:bookworm-robot-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-perception-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-perception-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-perception-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-perception-cu128",
    "${REGISTRY}/ros-tf:bookworm-perception-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-desktop-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-desktop-cu128",
    "${REGISTRY}/ros-tf:bookworm-desktop-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-desktop-full-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-full-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-tf:bookworm-desktop-full-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-core-run-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-core-run-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-core-run-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-core-run-cu128",
    "${REGISTRY}/ros-tf:bookworm-core-run-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-base-run-tensorflow-cu128" {
  inherits = ["_ros1-bookworm", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-base-run-cu128",
    "${REGISTRY}/ros-tf:ros1-bookworm-base-run-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:bookworm-base-run-cu128",
    "${REGISTRY}/ros-tf:bookworm-base-run-cu128-tf2.20.0"
  ]
}

target "ros1-bookworm-core-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-core-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-core-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-core-cpu",
    "${REGISTRY}/ros-tf:bookworm-core-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-base-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-base-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-base-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-base-cpu",
    "${REGISTRY}/ros-tf:bookworm-base-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-robot-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cpu-tf2.21.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-robot-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-robot-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-robot-cpu",
    "${REGISTRY}/ros-tf:bookworm-robot-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-perception-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-perception-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-perception-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-perception-cpu",
    "${REGISTRY}/ros-tf:bookworm-perception-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-desktop-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-desktop-cpu",
    "${REGISTRY}/ros-tf:bookworm-desktop-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-desktop-full-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-desktop-full-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-tf:bookworm-desktop-full-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-core-run-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-core-run-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-core-run-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-core-run-cpu",
    "${REGISTRY}/ros-tf:bookworm-core-run-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-base-run-tensorflow-cpu" {
  inherits  = ["_ros1-bookworm", "_tensorflow-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-bookworm-base-run-cpu",
    "${REGISTRY}/ros-tf:ros1-bookworm-base-run-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:bookworm-base-run-cpu",
    "${REGISTRY}/ros-tf:bookworm-base-run-cpu-tf2.21.0"
  ]
}

target "ros1-bookworm-core-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-core-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-core-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-core-cu128",
    "${REGISTRY}/ros-ml:bookworm-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-base-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-base-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-base-cu128",
    "${REGISTRY}/ros-ml:bookworm-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:ros1-bookworm",
    "${REGISTRY}/ros-ml:bookworm"
  ]
}

target "ros1-bookworm-robot-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-robot-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-robot-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-robot-cu128",
    "${REGISTRY}/ros-ml:bookworm-robot-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-perception-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-perception-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-perception-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-perception-cu128",
    "${REGISTRY}/ros-ml:bookworm-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-desktop-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-desktop-cu128",
    "${REGISTRY}/ros-ml:bookworm-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-desktop-full-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-full-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cu128",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-core-run-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-core-run-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-core-run-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-core-run-cu128",
    "${REGISTRY}/ros-ml:bookworm-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-base-run-ml-cu128" {
  inherits = ["_ros1-bookworm", "_ml-cu128-py311"]
  contexts = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-base-run-cu128",
    "${REGISTRY}/ros-ml:ros1-bookworm-base-run-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:bookworm-base-run-cu128",
    "${REGISTRY}/ros-ml:bookworm-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-bookworm-core-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-core-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-core-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-core-cpu",
    "${REGISTRY}/ros-ml:bookworm-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-base-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-base-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-base-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-base-cpu",
    "${REGISTRY}/ros-ml:bookworm-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-robot-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-robot-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-robot-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-robot-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-robot-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-robot-cpu",
    "${REGISTRY}/ros-ml:bookworm-robot-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-perception-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-perception-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-perception-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-perception-cpu",
    "${REGISTRY}/ros-ml:bookworm-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-desktop-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-desktop-cpu",
    "${REGISTRY}/ros-ml:bookworm-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-desktop-full-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-desktop-full-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cpu",
    "${REGISTRY}/ros-ml:bookworm-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-core-run-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-core-run-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-core-run-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-core-run-cpu",
    "${REGISTRY}/ros-ml:bookworm-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-base-run-ml-cpu" {
  inherits  = ["_ros1-bookworm", "_ml-cpu-py311"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { ros = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-bookworm-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-bookworm), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-bookworm-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-bookworm-base-run-cpu",
    "${REGISTRY}/ros-ml:ros1-bookworm-base-run-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:bookworm-base-run-cpu",
    "${REGISTRY}/ros-ml:bookworm-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-bookworm-core-triton-cu128" {
  inherits = ["_ros1-bookworm", "_none-triton-cu128-py311"]
}

target "ros1-bookworm-core-triton-cu130" {
  inherits = ["_ros1-bookworm", "_none-triton-cu130-py311"]
}

target "ros1-bookworm-core-triton-cu132" {
  inherits = ["_ros1-bookworm", "_none-triton-cu132-py311"]
}

target "ros1-bookworm-core-triton-cpu" {
  inherits = ["_ros1-bookworm", "_none-triton-cpu-py311"]
}

target "ros1-bookworm-core-tensorrt-rtx-cu130" {
  inherits = ["_ros1-bookworm", "_none-tensorrt-rtx-cu130-py311"]
}

target "ros1-bookworm-core-tensorrt-rtx-cu132" {
  inherits = ["_ros1-bookworm", "_none-tensorrt-rtx-cu132-py311"]
}

# ---- ros1-trixie ----------------------------------------------------------------------------------------------------

target "_ros1-trixie" {
  inherits = ["_image"]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_TRIXIE)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_TRIXIE)[1], null)
    "io.rosml.distribution"                = "ros1-trixie"
    "io.rosml.os"                          = "trixie"
    "io.rosml.python"                      = "3.13"
    "io.rosml.ros"                         = "1"
  }
}

target "_ros1-trixie-ros" {
  inherits  = ["_ros1-trixie"]
  target    = "ros"
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  args = {
    ROS_DISTRO  = "Debian"
    ROS_VERSION = "1"
  }
  labels = {
    "org.opencontainers.image.licenses" = "Apache-2.0"
    "io.rosml.framework"                = "none"
  }
}

target "ros1-trixie-core" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = "target:_os-trixie" }
  args = {
    ROS_PACKAGES = "rosbash ros-core ros-core-dev ros-core-python-dev"
    ROS_TOOLS    = "catkin python3-rosdep2 vcstool colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-core"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-core",
    "${REGISTRY}/ros:trixie-core"
  ]
}

target "ros1-trixie-base" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  args     = { ROS_PACKAGES = "rosbash ros-base ros-base-dev ros-base-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-base"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-base",
    "${REGISTRY}/ros:trixie-base",
    "${REGISTRY}/ros:ros1-trixie",
    "${REGISTRY}/ros:trixie"
  ]
}

target "ros1-trixie-robot" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  args     = { ROS_PACKAGES = "rosbash ros-robot ros-robot-dev ros-robot-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-robot"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-robot",
    "${REGISTRY}/ros:trixie-robot"
  ]
}

target "ros1-trixie-perception" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  args     = { ROS_PACKAGES = "rosbash ros-perception ros-perception-dev ros-perception-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-perception"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-perception",
    "${REGISTRY}/ros:trixie-perception"
  ]
}

target "ros1-trixie-desktop" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  args     = { ROS_PACKAGES = "rosbash ros-desktop ros-desktop-dev ros-desktop-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-desktop",
    "${REGISTRY}/ros:trixie-desktop"
  ]
}

target "ros1-trixie-desktop-full" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  args     = { ROS_PACKAGES = "rosbash ros-desktop-full ros-desktop-full-dev ros-desktop-full-python-dev" }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-desktop-full",
    "${REGISTRY}/ros:trixie-desktop-full"
  ]
}

target "ros1-trixie-core-run" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = "target:_os-trixie-run" }
  args = {
    ROS_PACKAGES = "rosbash ros-core ros-core-dev ros-core-python-dev"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-core-run",
    "${REGISTRY}/ros:trixie-core-run"
  ]
}

target "ros1-trixie-base-run" {
  inherits = ["_ros1-trixie-ros"]
  contexts = { parent = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  args = {
    ROS_PACKAGES = "rosbash ros-base ros-base-dev ros-base-python-dev"
    RUNTIME      = "true"
  }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie)"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros:ros1-trixie-base-run",
    "${REGISTRY}/ros:trixie-base-run"
  ]
}

target "ros1-trixie-core-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-core-cu128",
    "${REGISTRY}/ros-cuda:trixie-core-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-base-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-base-cu128",
    "${REGISTRY}/ros-cuda:trixie-base-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-robot-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu128-cuda12.8.90"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-robot-cu128",
    "${REGISTRY}/ros-cuda:trixie-robot-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-perception-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu128-cuda12.8.90"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-perception-cu128",
    "${REGISTRY}/ros-cuda:trixie-perception-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-desktop-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu128",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-desktop-full-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu128-cuda12.8.90"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-core-run-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu128",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-base-run-cuda-cu128" {
  inherits = ["_ros1-trixie", "_cuda-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu128-cuda12.8.90"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu128",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu128-cuda12.8.90",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu128",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu128-cuda12.8.90"
  ]
}

target "ros1-trixie-core-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-core-cu130",
    "${REGISTRY}/ros-cuda:trixie-core-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-base-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-base-cu130",
    "${REGISTRY}/ros-cuda:trixie-base-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:ros1-trixie",
    "${REGISTRY}/ros-cuda:trixie"
  ]
}

target "ros1-trixie-robot-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu130-cuda13.0.96"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-robot-cu130",
    "${REGISTRY}/ros-cuda:trixie-robot-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-perception-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu130-cuda13.0.96"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-perception-cu130",
    "${REGISTRY}/ros-cuda:trixie-perception-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-desktop-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu130",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-desktop-full-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu130-cuda13.0.96"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu130",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-core-run-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu130",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-base-run-cuda-cu130" {
  inherits = ["_ros1-trixie", "_cuda-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu130-cuda13.0.96"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu130",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu130-cuda13.0.96",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu130",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu130-cuda13.0.96"
  ]
}

target "ros1-trixie-core-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-core-cu132",
    "${REGISTRY}/ros-cuda:trixie-core-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-base-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-base-cu132",
    "${REGISTRY}/ros-cuda:trixie-base-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-robot-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu132-cuda13.2.86"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-robot-cu132",
    "${REGISTRY}/ros-cuda:trixie-robot-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-perception-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu132-cuda13.2.86"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-perception-cu132",
    "${REGISTRY}/ros-cuda:trixie-perception-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-desktop-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu132",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-desktop-full-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu132-cuda13.2.86"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu132",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-core-run-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu132",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-base-run-cuda-cu132" {
  inherits = ["_ros1-trixie", "_cuda-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu132-cuda13.2.86"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu132",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu132-cuda13.2.86",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu132",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu132-cuda13.2.86"
  ]
}

target "ros1-trixie-core-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-core-cu121",
    "${REGISTRY}/ros-cuda:trixie-core-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-base-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-base-cu121",
    "${REGISTRY}/ros-cuda:trixie-base-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-robot-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu121-cuda12.1.105"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-robot-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-robot-cu121",
    "${REGISTRY}/ros-cuda:trixie-robot-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-perception-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu121-cuda12.1.105"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-perception-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-perception-cu121",
    "${REGISTRY}/ros-cuda:trixie-perception-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-desktop-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu121",
    "${REGISTRY}/ros-cuda:trixie-desktop-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-desktop-full-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu121-cuda12.1.105"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-desktop-full-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu121",
    "${REGISTRY}/ros-cuda:trixie-desktop-full-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-core-run-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-core-run-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu121",
    "${REGISTRY}/ros-cuda:trixie-core-run-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-base-run-cuda-cu121" {
  inherits = ["_ros1-trixie", "_cuda-cu121-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu121-cuda12.1.105"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu121",
    "${REGISTRY}/ros-cuda:ros1-trixie-base-run-cu121-cuda12.1.105",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu121",
    "${REGISTRY}/ros-cuda:trixie-base-run-cu121-cuda12.1.105"
  ]
}

target "ros1-trixie-core-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu128-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-core-cu128",
    "${REGISTRY}/ros-torch:trixie-core-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-base-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu128-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-base-cu128",
    "${REGISTRY}/ros-torch:trixie-base-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-robot-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu128-torch2.10.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-robot-cu128",
    "${REGISTRY}/ros-torch:trixie-robot-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-perception-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu128-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-perception-cu128",
    "${REGISTRY}/ros-torch:trixie-perception-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-desktop-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-desktop-cu128",
    "${REGISTRY}/ros-torch:trixie-desktop-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-desktop-full-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu128-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-core-run-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-core-run-cu128",
    "${REGISTRY}/ros-torch:trixie-core-run-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-base-run-torch-cu128" {
  inherits = ["_ros1-trixie", "_torch-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-torch-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu128-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu128",
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu128-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-base-run-cu128",
    "${REGISTRY}/ros-torch:trixie-base-run-cu128-torch2.10.0"
  ]
}

target "ros1-trixie-core-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu130-torch2.14.1"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-core-cu130",
    "${REGISTRY}/ros-torch:trixie-core-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-base-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu130-torch2.14.1"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-base-cu130",
    "${REGISTRY}/ros-torch:trixie-base-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:ros1-trixie",
    "${REGISTRY}/ros-torch:trixie"
  ]
}

target "ros1-trixie-robot-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu130-torch2.14.1"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-robot-cu130",
    "${REGISTRY}/ros-torch:trixie-robot-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-perception-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu130-torch2.14.1"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-perception-cu130",
    "${REGISTRY}/ros-torch:trixie-perception-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-desktop-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-desktop-cu130",
    "${REGISTRY}/ros-torch:trixie-desktop-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-desktop-full-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu130-torch2.14.1"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu130",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-core-run-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-core-run-cu130",
    "${REGISTRY}/ros-torch:trixie-core-run-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-base-run-torch-cu130" {
  inherits = ["_ros1-trixie", "_torch-cu130-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-torch-cu130"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu130-torch2.14.1"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu130",
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu130-torch2.14.1",
    "${REGISTRY}/ros-torch:trixie-base-run-cu130",
    "${REGISTRY}/ros-torch:trixie-base-run-cu130-torch2.14.1"
  ]
}

target "ros1-trixie-core-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu132-torch2.15.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-core-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-core-cu132",
    "${REGISTRY}/ros-torch:trixie-core-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-base-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu132-torch2.15.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-base-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-base-cu132",
    "${REGISTRY}/ros-torch:trixie-base-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-robot-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu132-torch2.15.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-robot-cu132",
    "${REGISTRY}/ros-torch:trixie-robot-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-perception-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu132-torch2.15.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-perception-cu132",
    "${REGISTRY}/ros-torch:trixie-perception-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-desktop-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-desktop-cu132",
    "${REGISTRY}/ros-torch:trixie-desktop-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-desktop-full-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu132-torch2.15.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu132",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-core-run-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-core-run-cu132",
    "${REGISTRY}/ros-torch:trixie-core-run-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-base-run-torch-cu132" {
  inherits = ["_ros1-trixie", "_torch-cu132-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-torch-cu132"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu132-torch2.15.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu132",
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cu132-torch2.15.0",
    "${REGISTRY}/ros-torch:trixie-base-run-cu132",
    "${REGISTRY}/ros-torch:trixie-base-run-cu132-torch2.15.0"
  ]
}

target "ros1-trixie-core-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cpu-torch2.10.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-core-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-core-cpu",
    "${REGISTRY}/ros-torch:trixie-core-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-base-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cpu-torch2.10.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-base-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-base-cpu",
    "${REGISTRY}/ros-torch:trixie-base-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-robot-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cpu-torch2.10.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-robot-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-robot-cpu",
    "${REGISTRY}/ros-torch:trixie-robot-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-perception-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cpu-torch2.10.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-perception-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-perception-cpu",
    "${REGISTRY}/ros-torch:trixie-perception-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-desktop-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-desktop-cpu",
    "${REGISTRY}/ros-torch:trixie-desktop-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-desktop-full-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cpu-torch2.10.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-desktop-full-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cpu",
    "${REGISTRY}/ros-torch:trixie-desktop-full-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-core-run-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-core-run-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-core-run-cpu",
    "${REGISTRY}/ros-torch:trixie-core-run-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-base-run-torch-cpu" {
  inherits = ["_ros1-trixie", "_torch-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-torch-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cpu-torch2.10.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cpu",
    "${REGISTRY}/ros-torch:ros1-trixie-base-run-cpu-torch2.10.0",
    "${REGISTRY}/ros-torch:trixie-base-run-cpu",
    "${REGISTRY}/ros-torch:trixie-base-run-cpu-torch2.10.0"
  ]
}

target "ros1-trixie-core-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu128-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-core-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-core-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-core-cu128",
    "${REGISTRY}/ros-tf:trixie-core-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-base-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu128-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-base-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-base-cu128",
    "${REGISTRY}/ros-tf:trixie-base-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:ros1-trixie",
    "${REGISTRY}/ros-tf:trixie"
  ]
}

target "ros1-trixie-robot-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu128-tf2.20.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-robot-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-robot-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-robot-cu128",
    "${REGISTRY}/ros-tf:trixie-robot-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-perception-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu128-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-perception-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-perception-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-perception-cu128",
    "${REGISTRY}/ros-tf:trixie-perception-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-desktop-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-desktop-cu128",
    "${REGISTRY}/ros-tf:trixie-desktop-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-desktop-full-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu128-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-full-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-full-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-tf:trixie-desktop-full-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-core-run-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-core-run-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-core-run-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-core-run-cu128",
    "${REGISTRY}/ros-tf:trixie-core-run-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-base-run-tensorflow-cu128" {
  inherits = ["_ros1-trixie", "_tensorflow-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu128-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-base-run-cu128",
    "${REGISTRY}/ros-tf:ros1-trixie-base-run-cu128-tf2.20.0",
    "${REGISTRY}/ros-tf:trixie-base-run-cu128",
    "${REGISTRY}/ros-tf:trixie-base-run-cu128-tf2.20.0"
  ]
}

target "ros1-trixie-core-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cpu-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-core-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-core-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-core-cpu",
    "${REGISTRY}/ros-tf:trixie-core-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-base-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cpu-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-base-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-base-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-base-cpu",
    "${REGISTRY}/ros-tf:trixie-base-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-robot-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cpu-tf2.21.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-robot-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-robot-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-robot-cpu",
    "${REGISTRY}/ros-tf:trixie-robot-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-perception-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cpu-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-perception-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-perception-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-perception-cpu",
    "${REGISTRY}/ros-tf:trixie-perception-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-desktop-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-desktop-cpu",
    "${REGISTRY}/ros-tf:trixie-desktop-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-desktop-full-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cpu-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-full-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-desktop-full-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-desktop-full-cpu",
    "${REGISTRY}/ros-tf:trixie-desktop-full-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-core-run-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-core-run-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-core-run-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-core-run-cpu",
    "${REGISTRY}/ros-tf:trixie-core-run-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-base-run-tensorflow-cpu" {
  inherits = ["_ros1-trixie", "_tensorflow-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cpu-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-tf:ros1-trixie-base-run-cpu",
    "${REGISTRY}/ros-tf:ros1-trixie-base-run-cpu-tf2.21.0",
    "${REGISTRY}/ros-tf:trixie-base-run-cpu",
    "${REGISTRY}/ros-tf:trixie-base-run-cpu-tf2.21.0"
  ]
}

target "ros1-trixie-core-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-core-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-core-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-core-cu128",
    "${REGISTRY}/ros-ml:trixie-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-base-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-base-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-base-cu128",
    "${REGISTRY}/ros-ml:trixie-base-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:ros1-trixie",
    "${REGISTRY}/ros-ml:trixie"
  ]
}

target "ros1-trixie-robot-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-robot-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-robot-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-robot-cu128",
    "${REGISTRY}/ros-ml:trixie-robot-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-perception-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-perception-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-perception-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-perception-cu128",
    "${REGISTRY}/ros-ml:trixie-perception-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-desktop-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-desktop-cu128",
    "${REGISTRY}/ros-ml:trixie-desktop-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-desktop-full-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-full-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-full-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cu128",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-core-run-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-core-run-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-core-run-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-core-run-cu128",
    "${REGISTRY}/ros-ml:trixie-core-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-base-run-ml-cu128" {
  inherits = ["_ros1-trixie", "_ml-cu128-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-ml-cu128"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cu128-torch2.10.0-tf2.20.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-base-run-cu128",
    "${REGISTRY}/ros-ml:ros1-trixie-base-run-cu128-torch2.10.0-tf2.20.0",
    "${REGISTRY}/ros-ml:trixie-base-run-cu128",
    "${REGISTRY}/ros-ml:trixie-base-run-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "ros1-trixie-core-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core"
    "io.rosml.runtime"                     = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-core-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-core-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-core-cpu",
    "${REGISTRY}/ros-ml:trixie-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-base-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-base-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-base-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-base-cpu",
    "${REGISTRY}/ros-ml:trixie-base-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-robot-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-robot-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 robot (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-robot-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "robot"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-robot-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-robot-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-robot-cpu",
    "${REGISTRY}/ros-ml:trixie-robot-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-perception-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-perception-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 perception (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-perception-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "perception"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-perception-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-perception-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-perception-cpu",
    "${REGISTRY}/ros-ml:trixie-perception-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-desktop-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-desktop-cpu",
    "${REGISTRY}/ros-ml:trixie-desktop-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-desktop-full-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-desktop-full-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 desktop-full (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-desktop-full-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "desktop-full"
    "io.rosml.runtime"                     = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-full-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-desktop-full-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cpu",
    "${REGISTRY}/ros-ml:trixie-desktop-full-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-core-run-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-core-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 core-run (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-core-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "core-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-core-run-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-core-run-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-core-run-cpu",
    "${REGISTRY}/ros-ml:trixie-core-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-base-run-ml-cpu" {
  inherits = ["_ros1-trixie", "_ml-cpu-py313"]
  contexts = { ros = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  labels = {
    "org.opencontainers.image.title"       = "ros1-trixie-base-run-ml-cpu"
    "org.opencontainers.image.description" = "ROS 1 base-run (ros1-trixie), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "ros1-trixie-base-run-cpu-torch2.10.0-tf2.21.0"
    "io.rosml.component"                   = "base-run"
  }
  tags = [
    "${REGISTRY}/ros-ml:ros1-trixie-base-run-cpu",
    "${REGISTRY}/ros-ml:ros1-trixie-base-run-cpu-torch2.10.0-tf2.21.0",
    "${REGISTRY}/ros-ml:trixie-base-run-cpu",
    "${REGISTRY}/ros-ml:trixie-base-run-cpu-torch2.10.0-tf2.21.0"
  ]
}

target "ros1-trixie-core-triton-cu128" {
  inherits = ["_ros1-trixie", "_none-triton-cu128-py313"]
}

target "ros1-trixie-core-triton-cu130" {
  inherits = ["_ros1-trixie", "_none-triton-cu130-py313"]
}

target "ros1-trixie-core-triton-cu132" {
  inherits = ["_ros1-trixie", "_none-triton-cu132-py313"]
}

target "ros1-trixie-core-triton-cpu" {
  inherits = ["_ros1-trixie", "_none-triton-cpu-py313"]
}

target "ros1-trixie-core-tensorrt-rtx-cu130" {
  inherits = ["_ros1-trixie", "_none-tensorrt-rtx-cu130-py313"]
}

target "ros1-trixie-core-tensorrt-rtx-cu132" {
  inherits = ["_ros1-trixie", "_none-tensorrt-rtx-cu132-py313"]
}

# ---- jazzy-wheels ---------------------------------------------------------------------------------------------------

target "_jazzy-wheels" {
  inherits  = ["_image"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  labels = {
    "org.opencontainers.image.base.name"   = trimprefix(split("@", OS_BOOKWORM)[0], "docker-image://")
    "org.opencontainers.image.base.digest" = try(split("@", OS_BOOKWORM)[1], null)
    "io.rosml.distribution"                = "jazzy-wheels"
    "io.rosml.os"                          = "bookworm"
    "io.rosml.python"                      = "3.11"
    "io.rosml.ros"                         = "2"
    "io.rosml.component"                   = "core"
    "io.rosml.experimental"                = "true"
  }
}

target "_jazzy-wheels-ros" {
  inherits = ["_jazzy-wheels"]
  target   = "ros-wheels"
  contexts = {
    parent = "target:_os-bookworm"
    os     = OS_BOOKWORM
  }
  args = {
    ROS_DISTRO  = "jazzy"
    ROS_VERSION = "2"
    ROS_TOOLS   = "python3-rosdep2 vcstool python3-numpy python3-empy colcon python3-colcon-argcomplete python3-colcon-bash python3-colcon-cmake python3-colcon-defaults python3-colcon-metadata python3-colcon-output python3-colcon-package-information python3-colcon-package-selection python3-colcon-parallel-executor python3-colcon-ros"
    ROS_ROW     = "jazzy-wheels"
    PYTHON      = "3.11"
  }
  labels = {
    "org.opencontainers.image.licenses"    = "Apache-2.0"
    "io.rosml.framework"                   = "none"
    "org.opencontainers.image.title"       = "jazzy-wheels-core"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels)"
    "org.opencontainers.image.version"     = "jazzy-wheels-core"
  }
  tags = [
    "${REGISTRY}/ros:jazzy-wheels-core"
  ]
}

target "jazzy-wheels-core" {
  inherits = ["_jazzy-wheels-ros"]
}

target "jazzy-wheels-core-cuda-cu128" {
  inherits = ["_jazzy-wheels", "_cuda-cu128-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-cuda12.8.90"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu128",
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu128-cuda12.8.90"
  ]
}

target "jazzy-wheels-core-cuda-cu130" {
  inherits = ["_jazzy-wheels", "_cuda-cu130-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu130-cuda13.0.96"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu130",
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu130-cuda13.0.96"
  ]
}

target "jazzy-wheels-core-cuda-cu132" {
  inherits = ["_jazzy-wheels", "_cuda-cu132-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu132-cuda13.2.86"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu132",
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu132-cuda13.2.86"
  ]
}

target "jazzy-wheels-core-cuda-cu121" {
  inherits = ["_jazzy-wheels", "_cuda-cu121-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-cuda-cu121"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), CUDA 12.1.105"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu121-cuda12.1.105"
  }
  tags = [
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu121",
    "${REGISTRY}/ros-cuda:jazzy-wheels-core-cu121-cuda12.1.105"
  ]
}

target "jazzy-wheels-core-torch-cu128" {
  inherits = ["_jazzy-wheels", "_torch-cu128-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-torch2.10.0"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu128",
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu128-torch2.10.0"
  ]
}

target "jazzy-wheels-core-torch-cu130" {
  inherits = ["_jazzy-wheels", "_torch-cu130-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cu130"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.14.1, CUDA 13.0.96"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu130-torch2.14.1"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu130",
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu130-torch2.14.1"
  ]
}

target "jazzy-wheels-core-torch-cu132" {
  inherits = ["_jazzy-wheels", "_torch-cu132-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cu132"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.15.0, CUDA 13.2.86"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu132-torch2.15.0"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu132",
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cu132-torch2.15.0"
  ]
}

target "jazzy-wheels-core-torch-cpu" {
  inherits = ["_jazzy-wheels", "_torch-cpu-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-torch-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-torch2.10.0"
  }
  tags = [
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cpu",
    "${REGISTRY}/ros-torch:jazzy-wheels-core-cpu-torch2.10.0"
  ]
}

target "jazzy-wheels-core-tensorflow-cu128" {
  inherits = ["_jazzy-wheels", "_tensorflow-cu128-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-tensorflow-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-tf2.20.0"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-wheels-core-cu128",
    "${REGISTRY}/ros-tf:jazzy-wheels-core-cu128-tf2.20.0"
  ]
}

target "jazzy-wheels-core-tensorflow-cpu" {
  inherits = ["_jazzy-wheels", "_tensorflow-cpu-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-tensorflow-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-tf2.21.0"
  }
  tags = [
    "${REGISTRY}/ros-tf:jazzy-wheels-core-cpu",
    "${REGISTRY}/ros-tf:jazzy-wheels-core-cpu-tf2.21.0"
  ]
}

target "jazzy-wheels-core-ml-cu128" {
  inherits = ["_jazzy-wheels", "_ml-cu128-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-ml-cu128"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, TensorFlow 2.20.0, CUDA 12.8.90"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cu128-torch2.10.0-tf2.20.0"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cu128",
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cu128-torch2.10.0-tf2.20.0"
  ]
}

target "jazzy-wheels-core-ml-cpu" {
  inherits = ["_jazzy-wheels", "_ml-cpu-py311"]
  contexts = { ros = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  labels = {
    "org.opencontainers.image.title"       = "jazzy-wheels-core-ml-cpu"
    "org.opencontainers.image.description" = "ROS 2 core (jazzy-wheels), PyTorch 2.10.0, TensorFlow 2.21.0"
    "org.opencontainers.image.version"     = "jazzy-wheels-core-cpu-torch2.10.0-tf2.21.0"
  }
  tags = [
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cpu",
    "${REGISTRY}/ros-ml:jazzy-wheels-core-cpu-torch2.10.0-tf2.21.0"
  ]
}

# ---- Groups ---------------------------------------------------------------------------------------------------------

group "default" {
  targets = [
    "ros1-bookworm-core",
  ]
}

group "noetic" {
  targets = [
    "noetic-core", "noetic-base", "noetic-robot", "noetic-perception", "noetic-desktop", "noetic-desktop-full", "noetic-core-run", "noetic-base-run", "noetic-core-cuda-cu128", "noetic-base-cuda-cu128", "noetic-robot-cuda-cu128", "noetic-perception-cuda-cu128", "noetic-desktop-cuda-cu128", "noetic-desktop-full-cuda-cu128", "noetic-core-run-cuda-cu128", "noetic-base-run-cuda-cu128", "noetic-core-cuda-cu130", "noetic-base-cuda-cu130", "noetic-robot-cuda-cu130", "noetic-perception-cuda-cu130", "noetic-desktop-cuda-cu130", "noetic-desktop-full-cuda-cu130", "noetic-core-run-cuda-cu130", "noetic-base-run-cuda-cu130", "noetic-core-cuda-cu132", "noetic-base-cuda-cu132", "noetic-robot-cuda-cu132", "noetic-perception-cuda-cu132", "noetic-desktop-cuda-cu132", "noetic-desktop-full-cuda-cu132", "noetic-core-run-cuda-cu132", "noetic-base-run-cuda-cu132", "noetic-core-cuda-cu121", "noetic-base-cuda-cu121", "noetic-robot-cuda-cu121", "noetic-perception-cuda-cu121", "noetic-desktop-cuda-cu121", "noetic-desktop-full-cuda-cu121", "noetic-core-run-cuda-cu121", "noetic-base-run-cuda-cu121", "noetic-core-torch-cu121", "noetic-base-torch-cu121", "noetic-robot-torch-cu121", "noetic-perception-torch-cu121", "noetic-desktop-torch-cu121", "noetic-desktop-full-torch-cu121", "noetic-core-run-torch-cu121", "noetic-base-run-torch-cu121", "noetic-core-tensorflow-cpu38", "noetic-base-tensorflow-cpu38", "noetic-robot-tensorflow-cpu38", "noetic-perception-tensorflow-cpu38", "noetic-desktop-tensorflow-cpu38", "noetic-desktop-full-tensorflow-cpu38", "noetic-core-run-tensorflow-cpu38", "noetic-base-run-tensorflow-cpu38",
  ]
}

group "foxy" {
  targets = [
    "foxy-core", "foxy-base", "foxy-desktop", "foxy-core-run", "foxy-base-run", "foxy-core-cuda-cu128", "foxy-base-cuda-cu128", "foxy-desktop-cuda-cu128", "foxy-core-run-cuda-cu128", "foxy-base-run-cuda-cu128", "foxy-core-cuda-cu130", "foxy-base-cuda-cu130", "foxy-desktop-cuda-cu130", "foxy-core-run-cuda-cu130", "foxy-base-run-cuda-cu130", "foxy-core-cuda-cu132", "foxy-base-cuda-cu132", "foxy-desktop-cuda-cu132", "foxy-core-run-cuda-cu132", "foxy-base-run-cuda-cu132", "foxy-core-cuda-cu121", "foxy-base-cuda-cu121", "foxy-desktop-cuda-cu121", "foxy-core-run-cuda-cu121", "foxy-base-run-cuda-cu121", "foxy-core-torch-cu121", "foxy-base-torch-cu121", "foxy-desktop-torch-cu121", "foxy-core-run-torch-cu121", "foxy-base-run-torch-cu121", "foxy-core-tensorflow-cpu38", "foxy-base-tensorflow-cpu38", "foxy-desktop-tensorflow-cpu38", "foxy-core-run-tensorflow-cpu38", "foxy-base-run-tensorflow-cpu38",
  ]
}

group "humble" {
  targets = [
    "humble-core", "humble-base", "humble-perception", "humble-desktop", "humble-desktop-full", "humble-core-run", "humble-base-run", "humble-core-cuda-cu128", "humble-base-cuda-cu128", "humble-perception-cuda-cu128", "humble-desktop-cuda-cu128", "humble-desktop-full-cuda-cu128", "humble-core-run-cuda-cu128", "humble-base-run-cuda-cu128", "humble-core-cuda-cu130", "humble-base-cuda-cu130", "humble-perception-cuda-cu130", "humble-desktop-cuda-cu130", "humble-desktop-full-cuda-cu130", "humble-core-run-cuda-cu130", "humble-base-run-cuda-cu130", "humble-core-cuda-cu132", "humble-base-cuda-cu132", "humble-perception-cuda-cu132", "humble-desktop-cuda-cu132", "humble-desktop-full-cuda-cu132", "humble-core-run-cuda-cu132", "humble-base-run-cuda-cu132", "humble-core-cuda-cu121", "humble-base-cuda-cu121", "humble-perception-cuda-cu121", "humble-desktop-cuda-cu121", "humble-desktop-full-cuda-cu121", "humble-core-run-cuda-cu121", "humble-base-run-cuda-cu121", "humble-core-torch-cu128", "humble-base-torch-cu128", "humble-perception-torch-cu128", "humble-desktop-torch-cu128", "humble-desktop-full-torch-cu128", "humble-core-run-torch-cu128", "humble-base-run-torch-cu128", "humble-core-torch-cu130", "humble-base-torch-cu130", "humble-perception-torch-cu130", "humble-desktop-torch-cu130", "humble-desktop-full-torch-cu130", "humble-core-run-torch-cu130", "humble-base-run-torch-cu130", "humble-core-torch-cpu", "humble-base-torch-cpu", "humble-perception-torch-cpu", "humble-desktop-torch-cpu", "humble-desktop-full-torch-cpu", "humble-core-run-torch-cpu", "humble-base-run-torch-cpu", "humble-core-tensorflow-cu128", "humble-base-tensorflow-cu128", "humble-perception-tensorflow-cu128", "humble-desktop-tensorflow-cu128", "humble-desktop-full-tensorflow-cu128", "humble-core-run-tensorflow-cu128", "humble-base-run-tensorflow-cu128", "humble-core-tensorflow-cpu", "humble-base-tensorflow-cpu", "humble-perception-tensorflow-cpu", "humble-desktop-tensorflow-cpu", "humble-desktop-full-tensorflow-cpu", "humble-core-run-tensorflow-cpu", "humble-base-run-tensorflow-cpu", "humble-core-ml-cu128", "humble-base-ml-cu128", "humble-perception-ml-cu128", "humble-desktop-ml-cu128", "humble-desktop-full-ml-cu128", "humble-core-run-ml-cu128", "humble-base-run-ml-cu128", "humble-core-ml-cpu", "humble-base-ml-cpu", "humble-perception-ml-cpu", "humble-desktop-ml-cpu", "humble-desktop-full-ml-cpu", "humble-core-run-ml-cpu", "humble-base-run-ml-cpu",
  ]
}

group "iron" {
  targets = [
    "iron-core", "iron-base", "iron-perception", "iron-desktop", "iron-desktop-full", "iron-core-run", "iron-base-run", "iron-core-cuda-cu128", "iron-base-cuda-cu128", "iron-perception-cuda-cu128", "iron-desktop-cuda-cu128", "iron-desktop-full-cuda-cu128", "iron-core-run-cuda-cu128", "iron-base-run-cuda-cu128", "iron-core-cuda-cu130", "iron-base-cuda-cu130", "iron-perception-cuda-cu130", "iron-desktop-cuda-cu130", "iron-desktop-full-cuda-cu130", "iron-core-run-cuda-cu130", "iron-base-run-cuda-cu130", "iron-core-cuda-cu132", "iron-base-cuda-cu132", "iron-perception-cuda-cu132", "iron-desktop-cuda-cu132", "iron-desktop-full-cuda-cu132", "iron-core-run-cuda-cu132", "iron-base-run-cuda-cu132", "iron-core-cuda-cu121", "iron-base-cuda-cu121", "iron-perception-cuda-cu121", "iron-desktop-cuda-cu121", "iron-desktop-full-cuda-cu121", "iron-core-run-cuda-cu121", "iron-base-run-cuda-cu121", "iron-core-torch-cu128", "iron-base-torch-cu128", "iron-perception-torch-cu128", "iron-desktop-torch-cu128", "iron-desktop-full-torch-cu128", "iron-core-run-torch-cu128", "iron-base-run-torch-cu128", "iron-core-torch-cu130", "iron-base-torch-cu130", "iron-perception-torch-cu130", "iron-desktop-torch-cu130", "iron-desktop-full-torch-cu130", "iron-core-run-torch-cu130", "iron-base-run-torch-cu130", "iron-core-torch-cpu", "iron-base-torch-cpu", "iron-perception-torch-cpu", "iron-desktop-torch-cpu", "iron-desktop-full-torch-cpu", "iron-core-run-torch-cpu", "iron-base-run-torch-cpu", "iron-core-tensorflow-cu128", "iron-base-tensorflow-cu128", "iron-perception-tensorflow-cu128", "iron-desktop-tensorflow-cu128", "iron-desktop-full-tensorflow-cu128", "iron-core-run-tensorflow-cu128", "iron-base-run-tensorflow-cu128", "iron-core-tensorflow-cpu", "iron-base-tensorflow-cpu", "iron-perception-tensorflow-cpu", "iron-desktop-tensorflow-cpu", "iron-desktop-full-tensorflow-cpu", "iron-core-run-tensorflow-cpu", "iron-base-run-tensorflow-cpu", "iron-core-ml-cu128", "iron-base-ml-cu128", "iron-perception-ml-cu128", "iron-desktop-ml-cu128", "iron-desktop-full-ml-cu128", "iron-core-run-ml-cu128", "iron-base-run-ml-cu128", "iron-core-ml-cpu", "iron-base-ml-cpu", "iron-perception-ml-cpu", "iron-desktop-ml-cpu", "iron-desktop-full-ml-cpu", "iron-core-run-ml-cpu", "iron-base-run-ml-cpu",
  ]
}

group "jazzy" {
  targets = [
    "jazzy-core", "jazzy-base", "jazzy-perception", "jazzy-desktop", "jazzy-desktop-full", "jazzy-core-run", "jazzy-base-run", "jazzy-core-cuda-cu128", "jazzy-base-cuda-cu128", "jazzy-perception-cuda-cu128", "jazzy-desktop-cuda-cu128", "jazzy-desktop-full-cuda-cu128", "jazzy-core-run-cuda-cu128", "jazzy-base-run-cuda-cu128", "jazzy-core-cuda-cu130", "jazzy-base-cuda-cu130", "jazzy-perception-cuda-cu130", "jazzy-desktop-cuda-cu130", "jazzy-desktop-full-cuda-cu130", "jazzy-core-run-cuda-cu130", "jazzy-base-run-cuda-cu130", "jazzy-core-cuda-cu132", "jazzy-base-cuda-cu132", "jazzy-perception-cuda-cu132", "jazzy-desktop-cuda-cu132", "jazzy-desktop-full-cuda-cu132", "jazzy-core-run-cuda-cu132", "jazzy-base-run-cuda-cu132", "jazzy-core-cuda-cu121", "jazzy-base-cuda-cu121", "jazzy-perception-cuda-cu121", "jazzy-desktop-cuda-cu121", "jazzy-desktop-full-cuda-cu121", "jazzy-core-run-cuda-cu121", "jazzy-base-run-cuda-cu121", "jazzy-core-torch-cu128", "jazzy-base-torch-cu128", "jazzy-perception-torch-cu128", "jazzy-desktop-torch-cu128", "jazzy-desktop-full-torch-cu128", "jazzy-core-run-torch-cu128", "jazzy-base-run-torch-cu128", "jazzy-core-torch-cu130", "jazzy-base-torch-cu130", "jazzy-perception-torch-cu130", "jazzy-desktop-torch-cu130", "jazzy-desktop-full-torch-cu130", "jazzy-core-run-torch-cu130", "jazzy-base-run-torch-cu130", "jazzy-core-torch-cu132", "jazzy-base-torch-cu132", "jazzy-perception-torch-cu132", "jazzy-desktop-torch-cu132", "jazzy-desktop-full-torch-cu132", "jazzy-core-run-torch-cu132", "jazzy-base-run-torch-cu132", "jazzy-core-torch-cpu", "jazzy-base-torch-cpu", "jazzy-perception-torch-cpu", "jazzy-desktop-torch-cpu", "jazzy-desktop-full-torch-cpu", "jazzy-core-run-torch-cpu", "jazzy-base-run-torch-cpu", "jazzy-core-tensorflow-cu128", "jazzy-base-tensorflow-cu128", "jazzy-perception-tensorflow-cu128", "jazzy-desktop-tensorflow-cu128", "jazzy-desktop-full-tensorflow-cu128", "jazzy-core-run-tensorflow-cu128", "jazzy-base-run-tensorflow-cu128", "jazzy-core-tensorflow-cpu", "jazzy-base-tensorflow-cpu", "jazzy-perception-tensorflow-cpu", "jazzy-desktop-tensorflow-cpu", "jazzy-desktop-full-tensorflow-cpu", "jazzy-core-run-tensorflow-cpu", "jazzy-base-run-tensorflow-cpu", "jazzy-core-ml-cu128", "jazzy-base-ml-cu128", "jazzy-perception-ml-cu128", "jazzy-desktop-ml-cu128", "jazzy-desktop-full-ml-cu128", "jazzy-core-run-ml-cu128", "jazzy-base-run-ml-cu128", "jazzy-core-ml-cpu", "jazzy-base-ml-cpu", "jazzy-perception-ml-cpu", "jazzy-desktop-ml-cpu", "jazzy-desktop-full-ml-cpu", "jazzy-core-run-ml-cpu", "jazzy-base-run-ml-cpu",
  ]
}

group "kilted" {
  targets = [
    "kilted-core", "kilted-base", "kilted-perception", "kilted-desktop", "kilted-desktop-full", "kilted-core-run", "kilted-base-run", "kilted-core-cuda-cu128", "kilted-base-cuda-cu128", "kilted-perception-cuda-cu128", "kilted-desktop-cuda-cu128", "kilted-desktop-full-cuda-cu128", "kilted-core-run-cuda-cu128", "kilted-base-run-cuda-cu128", "kilted-core-cuda-cu130", "kilted-base-cuda-cu130", "kilted-perception-cuda-cu130", "kilted-desktop-cuda-cu130", "kilted-desktop-full-cuda-cu130", "kilted-core-run-cuda-cu130", "kilted-base-run-cuda-cu130", "kilted-core-cuda-cu132", "kilted-base-cuda-cu132", "kilted-perception-cuda-cu132", "kilted-desktop-cuda-cu132", "kilted-desktop-full-cuda-cu132", "kilted-core-run-cuda-cu132", "kilted-base-run-cuda-cu132", "kilted-core-cuda-cu121", "kilted-base-cuda-cu121", "kilted-perception-cuda-cu121", "kilted-desktop-cuda-cu121", "kilted-desktop-full-cuda-cu121", "kilted-core-run-cuda-cu121", "kilted-base-run-cuda-cu121", "kilted-core-torch-cu128", "kilted-base-torch-cu128", "kilted-perception-torch-cu128", "kilted-desktop-torch-cu128", "kilted-desktop-full-torch-cu128", "kilted-core-run-torch-cu128", "kilted-base-run-torch-cu128", "kilted-core-torch-cu130", "kilted-base-torch-cu130", "kilted-perception-torch-cu130", "kilted-desktop-torch-cu130", "kilted-desktop-full-torch-cu130", "kilted-core-run-torch-cu130", "kilted-base-run-torch-cu130", "kilted-core-torch-cu132", "kilted-base-torch-cu132", "kilted-perception-torch-cu132", "kilted-desktop-torch-cu132", "kilted-desktop-full-torch-cu132", "kilted-core-run-torch-cu132", "kilted-base-run-torch-cu132", "kilted-core-torch-cpu", "kilted-base-torch-cpu", "kilted-perception-torch-cpu", "kilted-desktop-torch-cpu", "kilted-desktop-full-torch-cpu", "kilted-core-run-torch-cpu", "kilted-base-run-torch-cpu", "kilted-core-tensorflow-cu128", "kilted-base-tensorflow-cu128", "kilted-perception-tensorflow-cu128", "kilted-desktop-tensorflow-cu128", "kilted-desktop-full-tensorflow-cu128", "kilted-core-run-tensorflow-cu128", "kilted-base-run-tensorflow-cu128", "kilted-core-tensorflow-cpu", "kilted-base-tensorflow-cpu", "kilted-perception-tensorflow-cpu", "kilted-desktop-tensorflow-cpu", "kilted-desktop-full-tensorflow-cpu", "kilted-core-run-tensorflow-cpu", "kilted-base-run-tensorflow-cpu", "kilted-core-ml-cu128", "kilted-base-ml-cu128", "kilted-perception-ml-cu128", "kilted-desktop-ml-cu128", "kilted-desktop-full-ml-cu128", "kilted-core-run-ml-cu128", "kilted-base-run-ml-cu128", "kilted-core-ml-cpu", "kilted-base-ml-cpu", "kilted-perception-ml-cpu", "kilted-desktop-ml-cpu", "kilted-desktop-full-ml-cpu", "kilted-core-run-ml-cpu", "kilted-base-run-ml-cpu",
  ]
}

group "lyrical" {
  targets = [
    "lyrical-core", "lyrical-base", "lyrical-perception", "lyrical-desktop", "lyrical-desktop-full", "lyrical-core-run", "lyrical-base-run", "lyrical-core-cuda-cu128", "lyrical-base-cuda-cu128", "lyrical-perception-cuda-cu128", "lyrical-desktop-cuda-cu128", "lyrical-desktop-full-cuda-cu128", "lyrical-core-run-cuda-cu128", "lyrical-base-run-cuda-cu128", "lyrical-core-cuda-cu130", "lyrical-base-cuda-cu130", "lyrical-perception-cuda-cu130", "lyrical-desktop-cuda-cu130", "lyrical-desktop-full-cuda-cu130", "lyrical-core-run-cuda-cu130", "lyrical-base-run-cuda-cu130", "lyrical-core-cuda-cu132", "lyrical-base-cuda-cu132", "lyrical-perception-cuda-cu132", "lyrical-desktop-cuda-cu132", "lyrical-desktop-full-cuda-cu132", "lyrical-core-run-cuda-cu132", "lyrical-base-run-cuda-cu132", "lyrical-core-cuda-cu121", "lyrical-base-cuda-cu121", "lyrical-perception-cuda-cu121", "lyrical-desktop-cuda-cu121", "lyrical-desktop-full-cuda-cu121", "lyrical-core-run-cuda-cu121", "lyrical-base-run-cuda-cu121", "lyrical-core-torch-cu128", "lyrical-base-torch-cu128", "lyrical-perception-torch-cu128", "lyrical-desktop-torch-cu128", "lyrical-desktop-full-torch-cu128", "lyrical-core-run-torch-cu128", "lyrical-base-run-torch-cu128", "lyrical-core-torch-cu130", "lyrical-base-torch-cu130", "lyrical-perception-torch-cu130", "lyrical-desktop-torch-cu130", "lyrical-desktop-full-torch-cu130", "lyrical-core-run-torch-cu130", "lyrical-base-run-torch-cu130", "lyrical-core-torch-cu132", "lyrical-base-torch-cu132", "lyrical-perception-torch-cu132", "lyrical-desktop-torch-cu132", "lyrical-desktop-full-torch-cu132", "lyrical-core-run-torch-cu132", "lyrical-base-run-torch-cu132",
  ]
}

group "rolling" {
  targets = [
    "rolling-core", "rolling-base", "rolling-perception", "rolling-desktop", "rolling-desktop-full", "rolling-core-run", "rolling-base-run", "rolling-core-cuda-cu128", "rolling-base-cuda-cu128", "rolling-perception-cuda-cu128", "rolling-desktop-cuda-cu128", "rolling-desktop-full-cuda-cu128", "rolling-core-run-cuda-cu128", "rolling-base-run-cuda-cu128", "rolling-core-cuda-cu130", "rolling-base-cuda-cu130", "rolling-perception-cuda-cu130", "rolling-desktop-cuda-cu130", "rolling-desktop-full-cuda-cu130", "rolling-core-run-cuda-cu130", "rolling-base-run-cuda-cu130", "rolling-core-cuda-cu132", "rolling-base-cuda-cu132", "rolling-perception-cuda-cu132", "rolling-desktop-cuda-cu132", "rolling-desktop-full-cuda-cu132", "rolling-core-run-cuda-cu132", "rolling-base-run-cuda-cu132", "rolling-core-cuda-cu121", "rolling-base-cuda-cu121", "rolling-perception-cuda-cu121", "rolling-desktop-cuda-cu121", "rolling-desktop-full-cuda-cu121", "rolling-core-run-cuda-cu121", "rolling-base-run-cuda-cu121", "rolling-core-torch-cu128", "rolling-base-torch-cu128", "rolling-perception-torch-cu128", "rolling-desktop-torch-cu128", "rolling-desktop-full-torch-cu128", "rolling-core-run-torch-cu128", "rolling-base-run-torch-cu128", "rolling-core-torch-cu130", "rolling-base-torch-cu130", "rolling-perception-torch-cu130", "rolling-desktop-torch-cu130", "rolling-desktop-full-torch-cu130", "rolling-core-run-torch-cu130", "rolling-base-run-torch-cu130", "rolling-core-torch-cu132", "rolling-base-torch-cu132", "rolling-perception-torch-cu132", "rolling-desktop-torch-cu132", "rolling-desktop-full-torch-cu132", "rolling-core-run-torch-cu132", "rolling-base-run-torch-cu132",
  ]
}

group "ros1-bookworm" {
  targets = [
    "ros1-bookworm-core", "ros1-bookworm-base", "ros1-bookworm-robot", "ros1-bookworm-perception", "ros1-bookworm-desktop", "ros1-bookworm-desktop-full", "ros1-bookworm-core-run", "ros1-bookworm-base-run", "ros1-bookworm-core-cuda-cu128", "ros1-bookworm-base-cuda-cu128", "ros1-bookworm-robot-cuda-cu128", "ros1-bookworm-perception-cuda-cu128", "ros1-bookworm-desktop-cuda-cu128", "ros1-bookworm-desktop-full-cuda-cu128", "ros1-bookworm-core-run-cuda-cu128", "ros1-bookworm-base-run-cuda-cu128", "ros1-bookworm-core-cuda-cu130", "ros1-bookworm-base-cuda-cu130", "ros1-bookworm-robot-cuda-cu130", "ros1-bookworm-perception-cuda-cu130", "ros1-bookworm-desktop-cuda-cu130", "ros1-bookworm-desktop-full-cuda-cu130", "ros1-bookworm-core-run-cuda-cu130", "ros1-bookworm-base-run-cuda-cu130", "ros1-bookworm-core-cuda-cu132", "ros1-bookworm-base-cuda-cu132", "ros1-bookworm-robot-cuda-cu132", "ros1-bookworm-perception-cuda-cu132", "ros1-bookworm-desktop-cuda-cu132", "ros1-bookworm-desktop-full-cuda-cu132", "ros1-bookworm-core-run-cuda-cu132", "ros1-bookworm-base-run-cuda-cu132", "ros1-bookworm-core-cuda-cu121", "ros1-bookworm-base-cuda-cu121", "ros1-bookworm-robot-cuda-cu121", "ros1-bookworm-perception-cuda-cu121", "ros1-bookworm-desktop-cuda-cu121", "ros1-bookworm-desktop-full-cuda-cu121", "ros1-bookworm-core-run-cuda-cu121", "ros1-bookworm-base-run-cuda-cu121", "ros1-bookworm-core-torch-cu128", "ros1-bookworm-base-torch-cu128", "ros1-bookworm-robot-torch-cu128", "ros1-bookworm-perception-torch-cu128", "ros1-bookworm-desktop-torch-cu128", "ros1-bookworm-desktop-full-torch-cu128", "ros1-bookworm-core-run-torch-cu128", "ros1-bookworm-base-run-torch-cu128", "ros1-bookworm-core-torch-cu130", "ros1-bookworm-base-torch-cu130", "ros1-bookworm-robot-torch-cu130", "ros1-bookworm-perception-torch-cu130", "ros1-bookworm-desktop-torch-cu130", "ros1-bookworm-desktop-full-torch-cu130", "ros1-bookworm-core-run-torch-cu130", "ros1-bookworm-base-run-torch-cu130", "ros1-bookworm-core-torch-cu132", "ros1-bookworm-base-torch-cu132", "ros1-bookworm-robot-torch-cu132", "ros1-bookworm-perception-torch-cu132", "ros1-bookworm-desktop-torch-cu132", "ros1-bookworm-desktop-full-torch-cu132", "ros1-bookworm-core-run-torch-cu132", "ros1-bookworm-base-run-torch-cu132", "ros1-bookworm-core-tensorflow-cu128", "ros1-bookworm-base-tensorflow-cu128", "ros1-bookworm-robot-tensorflow-cu128", "ros1-bookworm-perception-tensorflow-cu128", "ros1-bookworm-desktop-tensorflow-cu128", "ros1-bookworm-desktop-full-tensorflow-cu128", "ros1-bookworm-core-run-tensorflow-cu128", "ros1-bookworm-base-run-tensorflow-cu128", "ros1-bookworm-core-tensorflow-cpu", "ros1-bookworm-base-tensorflow-cpu", "ros1-bookworm-robot-tensorflow-cpu", "ros1-bookworm-perception-tensorflow-cpu", "ros1-bookworm-desktop-tensorflow-cpu", "ros1-bookworm-desktop-full-tensorflow-cpu", "ros1-bookworm-core-run-tensorflow-cpu", "ros1-bookworm-base-run-tensorflow-cpu", "ros1-bookworm-core-ml-cu128", "ros1-bookworm-base-ml-cu128", "ros1-bookworm-robot-ml-cu128", "ros1-bookworm-perception-ml-cu128", "ros1-bookworm-desktop-ml-cu128", "ros1-bookworm-desktop-full-ml-cu128", "ros1-bookworm-core-run-ml-cu128", "ros1-bookworm-base-run-ml-cu128",
  ]
}

group "ros1-trixie" {
  targets = [
    "ros1-trixie-core", "ros1-trixie-base", "ros1-trixie-robot", "ros1-trixie-perception", "ros1-trixie-desktop", "ros1-trixie-desktop-full", "ros1-trixie-core-run", "ros1-trixie-base-run", "ros1-trixie-core-cuda-cu128", "ros1-trixie-base-cuda-cu128", "ros1-trixie-robot-cuda-cu128", "ros1-trixie-perception-cuda-cu128", "ros1-trixie-desktop-cuda-cu128", "ros1-trixie-desktop-full-cuda-cu128", "ros1-trixie-core-run-cuda-cu128", "ros1-trixie-base-run-cuda-cu128", "ros1-trixie-core-cuda-cu130", "ros1-trixie-base-cuda-cu130", "ros1-trixie-robot-cuda-cu130", "ros1-trixie-perception-cuda-cu130", "ros1-trixie-desktop-cuda-cu130", "ros1-trixie-desktop-full-cuda-cu130", "ros1-trixie-core-run-cuda-cu130", "ros1-trixie-base-run-cuda-cu130", "ros1-trixie-core-cuda-cu132", "ros1-trixie-base-cuda-cu132", "ros1-trixie-robot-cuda-cu132", "ros1-trixie-perception-cuda-cu132", "ros1-trixie-desktop-cuda-cu132", "ros1-trixie-desktop-full-cuda-cu132", "ros1-trixie-core-run-cuda-cu132", "ros1-trixie-base-run-cuda-cu132", "ros1-trixie-core-cuda-cu121", "ros1-trixie-base-cuda-cu121", "ros1-trixie-robot-cuda-cu121", "ros1-trixie-perception-cuda-cu121", "ros1-trixie-desktop-cuda-cu121", "ros1-trixie-desktop-full-cuda-cu121", "ros1-trixie-core-run-cuda-cu121", "ros1-trixie-base-run-cuda-cu121", "ros1-trixie-core-torch-cu128", "ros1-trixie-base-torch-cu128", "ros1-trixie-robot-torch-cu128", "ros1-trixie-perception-torch-cu128", "ros1-trixie-desktop-torch-cu128", "ros1-trixie-desktop-full-torch-cu128", "ros1-trixie-core-run-torch-cu128", "ros1-trixie-base-run-torch-cu128", "ros1-trixie-core-torch-cu130", "ros1-trixie-base-torch-cu130", "ros1-trixie-robot-torch-cu130", "ros1-trixie-perception-torch-cu130", "ros1-trixie-desktop-torch-cu130", "ros1-trixie-desktop-full-torch-cu130", "ros1-trixie-core-run-torch-cu130", "ros1-trixie-base-run-torch-cu130", "ros1-trixie-core-torch-cu132", "ros1-trixie-base-torch-cu132", "ros1-trixie-robot-torch-cu132", "ros1-trixie-perception-torch-cu132", "ros1-trixie-desktop-torch-cu132", "ros1-trixie-desktop-full-torch-cu132", "ros1-trixie-core-run-torch-cu132", "ros1-trixie-base-run-torch-cu132", "ros1-trixie-core-torch-cpu", "ros1-trixie-base-torch-cpu", "ros1-trixie-robot-torch-cpu", "ros1-trixie-perception-torch-cpu", "ros1-trixie-desktop-torch-cpu", "ros1-trixie-desktop-full-torch-cpu", "ros1-trixie-core-run-torch-cpu", "ros1-trixie-base-run-torch-cpu", "ros1-trixie-core-tensorflow-cu128", "ros1-trixie-base-tensorflow-cu128", "ros1-trixie-robot-tensorflow-cu128", "ros1-trixie-perception-tensorflow-cu128", "ros1-trixie-desktop-tensorflow-cu128", "ros1-trixie-desktop-full-tensorflow-cu128", "ros1-trixie-core-run-tensorflow-cu128", "ros1-trixie-base-run-tensorflow-cu128", "ros1-trixie-core-tensorflow-cpu", "ros1-trixie-base-tensorflow-cpu", "ros1-trixie-robot-tensorflow-cpu", "ros1-trixie-perception-tensorflow-cpu", "ros1-trixie-desktop-tensorflow-cpu", "ros1-trixie-desktop-full-tensorflow-cpu", "ros1-trixie-core-run-tensorflow-cpu", "ros1-trixie-base-run-tensorflow-cpu", "ros1-trixie-core-ml-cu128", "ros1-trixie-base-ml-cu128", "ros1-trixie-robot-ml-cu128", "ros1-trixie-perception-ml-cu128", "ros1-trixie-desktop-ml-cu128", "ros1-trixie-desktop-full-ml-cu128", "ros1-trixie-core-run-ml-cu128", "ros1-trixie-base-run-ml-cu128", "ros1-trixie-core-ml-cpu", "ros1-trixie-base-ml-cpu", "ros1-trixie-robot-ml-cpu", "ros1-trixie-perception-ml-cpu", "ros1-trixie-desktop-ml-cpu", "ros1-trixie-desktop-full-ml-cpu", "ros1-trixie-core-run-ml-cpu", "ros1-trixie-base-run-ml-cpu",
  ]
}

group "jazzy-wheels" {
  targets = [
    "jazzy-wheels-core", "jazzy-wheels-core-cuda-cu128", "jazzy-wheels-core-cuda-cu130", "jazzy-wheels-core-cuda-cu132", "jazzy-wheels-core-cuda-cu121", "jazzy-wheels-core-torch-cu128", "jazzy-wheels-core-torch-cu130", "jazzy-wheels-core-torch-cu132", "jazzy-wheels-core-tensorflow-cu128", "jazzy-wheels-core-tensorflow-cpu", "jazzy-wheels-core-ml-cu128",
  ]
}

group "core" {
  targets = [
    "noetic-core", "noetic-core-cuda-cu128", "noetic-core-cuda-cu130", "noetic-core-cuda-cu132", "noetic-core-cuda-cu121", "noetic-core-torch-cu121", "noetic-core-tensorflow-cpu38",
    "foxy-core", "foxy-core-cuda-cu128", "foxy-core-cuda-cu130", "foxy-core-cuda-cu132", "foxy-core-cuda-cu121", "foxy-core-torch-cu121", "foxy-core-tensorflow-cpu38",
    "humble-core", "humble-core-cuda-cu128", "humble-core-cuda-cu130", "humble-core-cuda-cu132", "humble-core-cuda-cu121", "humble-core-torch-cu128", "humble-core-torch-cu130", "humble-core-torch-cpu", "humble-core-tensorflow-cu128", "humble-core-tensorflow-cpu", "humble-core-ml-cu128", "humble-core-ml-cpu",
    "iron-core", "iron-core-cuda-cu128", "iron-core-cuda-cu130", "iron-core-cuda-cu132", "iron-core-cuda-cu121", "iron-core-torch-cu128", "iron-core-torch-cu130", "iron-core-torch-cpu", "iron-core-tensorflow-cu128", "iron-core-tensorflow-cpu", "iron-core-ml-cu128", "iron-core-ml-cpu",
    "jazzy-core", "jazzy-core-cuda-cu128", "jazzy-core-cuda-cu130", "jazzy-core-cuda-cu132", "jazzy-core-cuda-cu121", "jazzy-core-torch-cu128", "jazzy-core-torch-cu130", "jazzy-core-torch-cu132", "jazzy-core-torch-cpu", "jazzy-core-tensorflow-cu128", "jazzy-core-tensorflow-cpu", "jazzy-core-ml-cu128", "jazzy-core-ml-cpu",
    "kilted-core", "kilted-core-cuda-cu128", "kilted-core-cuda-cu130", "kilted-core-cuda-cu132", "kilted-core-cuda-cu121", "kilted-core-torch-cu128", "kilted-core-torch-cu130", "kilted-core-torch-cu132", "kilted-core-torch-cpu", "kilted-core-tensorflow-cu128", "kilted-core-tensorflow-cpu", "kilted-core-ml-cu128", "kilted-core-ml-cpu",
    "lyrical-core", "lyrical-core-cuda-cu128", "lyrical-core-cuda-cu130", "lyrical-core-cuda-cu132", "lyrical-core-cuda-cu121", "lyrical-core-torch-cu128", "lyrical-core-torch-cu130", "lyrical-core-torch-cu132",
    "rolling-core", "rolling-core-cuda-cu128", "rolling-core-cuda-cu130", "rolling-core-cuda-cu132", "rolling-core-cuda-cu121", "rolling-core-torch-cu128", "rolling-core-torch-cu130", "rolling-core-torch-cu132",
    "ros1-bookworm-core", "ros1-bookworm-core-cuda-cu128", "ros1-bookworm-core-cuda-cu130", "ros1-bookworm-core-cuda-cu132", "ros1-bookworm-core-cuda-cu121", "ros1-bookworm-core-torch-cu128", "ros1-bookworm-core-torch-cu130", "ros1-bookworm-core-torch-cu132", "ros1-bookworm-core-tensorflow-cu128", "ros1-bookworm-core-tensorflow-cpu", "ros1-bookworm-core-ml-cu128",
    "ros1-trixie-core", "ros1-trixie-core-cuda-cu128", "ros1-trixie-core-cuda-cu130", "ros1-trixie-core-cuda-cu132", "ros1-trixie-core-cuda-cu121", "ros1-trixie-core-torch-cu128", "ros1-trixie-core-torch-cu130", "ros1-trixie-core-torch-cu132", "ros1-trixie-core-torch-cpu", "ros1-trixie-core-tensorflow-cu128", "ros1-trixie-core-tensorflow-cpu", "ros1-trixie-core-ml-cu128", "ros1-trixie-core-ml-cpu",
    "jazzy-wheels-core", "jazzy-wheels-core-cuda-cu128", "jazzy-wheels-core-cuda-cu130", "jazzy-wheels-core-cuda-cu132", "jazzy-wheels-core-cuda-cu121", "jazzy-wheels-core-torch-cu128", "jazzy-wheels-core-torch-cu130", "jazzy-wheels-core-torch-cu132", "jazzy-wheels-core-tensorflow-cu128", "jazzy-wheels-core-tensorflow-cpu", "jazzy-wheels-core-ml-cu128",
  ]
}

group "base" {
  targets = [
    "noetic-base", "noetic-base-cuda-cu128", "noetic-base-cuda-cu130", "noetic-base-cuda-cu132", "noetic-base-cuda-cu121", "noetic-base-torch-cu121", "noetic-base-tensorflow-cpu38",
    "foxy-base", "foxy-base-cuda-cu128", "foxy-base-cuda-cu130", "foxy-base-cuda-cu132", "foxy-base-cuda-cu121", "foxy-base-torch-cu121", "foxy-base-tensorflow-cpu38",
    "humble-base", "humble-base-cuda-cu128", "humble-base-cuda-cu130", "humble-base-cuda-cu132", "humble-base-cuda-cu121", "humble-base-torch-cu128", "humble-base-torch-cu130", "humble-base-torch-cpu", "humble-base-tensorflow-cu128", "humble-base-tensorflow-cpu", "humble-base-ml-cu128", "humble-base-ml-cpu",
    "iron-base", "iron-base-cuda-cu128", "iron-base-cuda-cu130", "iron-base-cuda-cu132", "iron-base-cuda-cu121", "iron-base-torch-cu128", "iron-base-torch-cu130", "iron-base-torch-cpu", "iron-base-tensorflow-cu128", "iron-base-tensorflow-cpu", "iron-base-ml-cu128", "iron-base-ml-cpu",
    "jazzy-base", "jazzy-base-cuda-cu128", "jazzy-base-cuda-cu130", "jazzy-base-cuda-cu132", "jazzy-base-cuda-cu121", "jazzy-base-torch-cu128", "jazzy-base-torch-cu130", "jazzy-base-torch-cu132", "jazzy-base-torch-cpu", "jazzy-base-tensorflow-cu128", "jazzy-base-tensorflow-cpu", "jazzy-base-ml-cu128", "jazzy-base-ml-cpu",
    "kilted-base", "kilted-base-cuda-cu128", "kilted-base-cuda-cu130", "kilted-base-cuda-cu132", "kilted-base-cuda-cu121", "kilted-base-torch-cu128", "kilted-base-torch-cu130", "kilted-base-torch-cu132", "kilted-base-torch-cpu", "kilted-base-tensorflow-cu128", "kilted-base-tensorflow-cpu", "kilted-base-ml-cu128", "kilted-base-ml-cpu",
    "lyrical-base", "lyrical-base-cuda-cu128", "lyrical-base-cuda-cu130", "lyrical-base-cuda-cu132", "lyrical-base-cuda-cu121", "lyrical-base-torch-cu128", "lyrical-base-torch-cu130", "lyrical-base-torch-cu132",
    "rolling-base", "rolling-base-cuda-cu128", "rolling-base-cuda-cu130", "rolling-base-cuda-cu132", "rolling-base-cuda-cu121", "rolling-base-torch-cu128", "rolling-base-torch-cu130", "rolling-base-torch-cu132",
    "ros1-bookworm-base", "ros1-bookworm-base-cuda-cu128", "ros1-bookworm-base-cuda-cu130", "ros1-bookworm-base-cuda-cu132", "ros1-bookworm-base-cuda-cu121", "ros1-bookworm-base-torch-cu128", "ros1-bookworm-base-torch-cu130", "ros1-bookworm-base-torch-cu132", "ros1-bookworm-base-tensorflow-cu128", "ros1-bookworm-base-tensorflow-cpu", "ros1-bookworm-base-ml-cu128",
    "ros1-trixie-base", "ros1-trixie-base-cuda-cu128", "ros1-trixie-base-cuda-cu130", "ros1-trixie-base-cuda-cu132", "ros1-trixie-base-cuda-cu121", "ros1-trixie-base-torch-cu128", "ros1-trixie-base-torch-cu130", "ros1-trixie-base-torch-cu132", "ros1-trixie-base-torch-cpu", "ros1-trixie-base-tensorflow-cu128", "ros1-trixie-base-tensorflow-cpu", "ros1-trixie-base-ml-cu128", "ros1-trixie-base-ml-cpu",
  ]
}

group "robot" {
  targets = [
    "noetic-robot", "noetic-robot-cuda-cu128", "noetic-robot-cuda-cu130", "noetic-robot-cuda-cu132", "noetic-robot-cuda-cu121", "noetic-robot-torch-cu121", "noetic-robot-tensorflow-cpu38",
    "ros1-bookworm-robot", "ros1-bookworm-robot-cuda-cu128", "ros1-bookworm-robot-cuda-cu130", "ros1-bookworm-robot-cuda-cu132", "ros1-bookworm-robot-cuda-cu121", "ros1-bookworm-robot-torch-cu128", "ros1-bookworm-robot-torch-cu130", "ros1-bookworm-robot-torch-cu132", "ros1-bookworm-robot-tensorflow-cu128", "ros1-bookworm-robot-tensorflow-cpu", "ros1-bookworm-robot-ml-cu128",
    "ros1-trixie-robot", "ros1-trixie-robot-cuda-cu128", "ros1-trixie-robot-cuda-cu130", "ros1-trixie-robot-cuda-cu132", "ros1-trixie-robot-cuda-cu121", "ros1-trixie-robot-torch-cu128", "ros1-trixie-robot-torch-cu130", "ros1-trixie-robot-torch-cu132", "ros1-trixie-robot-torch-cpu", "ros1-trixie-robot-tensorflow-cu128", "ros1-trixie-robot-tensorflow-cpu", "ros1-trixie-robot-ml-cu128", "ros1-trixie-robot-ml-cpu",
  ]
}

group "perception" {
  targets = [
    "noetic-perception", "noetic-perception-cuda-cu128", "noetic-perception-cuda-cu130", "noetic-perception-cuda-cu132", "noetic-perception-cuda-cu121", "noetic-perception-torch-cu121", "noetic-perception-tensorflow-cpu38",
    "humble-perception", "humble-perception-cuda-cu128", "humble-perception-cuda-cu130", "humble-perception-cuda-cu132", "humble-perception-cuda-cu121", "humble-perception-torch-cu128", "humble-perception-torch-cu130", "humble-perception-torch-cpu", "humble-perception-tensorflow-cu128", "humble-perception-tensorflow-cpu", "humble-perception-ml-cu128", "humble-perception-ml-cpu",
    "iron-perception", "iron-perception-cuda-cu128", "iron-perception-cuda-cu130", "iron-perception-cuda-cu132", "iron-perception-cuda-cu121", "iron-perception-torch-cu128", "iron-perception-torch-cu130", "iron-perception-torch-cpu", "iron-perception-tensorflow-cu128", "iron-perception-tensorflow-cpu", "iron-perception-ml-cu128", "iron-perception-ml-cpu",
    "jazzy-perception", "jazzy-perception-cuda-cu128", "jazzy-perception-cuda-cu130", "jazzy-perception-cuda-cu132", "jazzy-perception-cuda-cu121", "jazzy-perception-torch-cu128", "jazzy-perception-torch-cu130", "jazzy-perception-torch-cu132", "jazzy-perception-torch-cpu", "jazzy-perception-tensorflow-cu128", "jazzy-perception-tensorflow-cpu", "jazzy-perception-ml-cu128", "jazzy-perception-ml-cpu",
    "kilted-perception", "kilted-perception-cuda-cu128", "kilted-perception-cuda-cu130", "kilted-perception-cuda-cu132", "kilted-perception-cuda-cu121", "kilted-perception-torch-cu128", "kilted-perception-torch-cu130", "kilted-perception-torch-cu132", "kilted-perception-torch-cpu", "kilted-perception-tensorflow-cu128", "kilted-perception-tensorflow-cpu", "kilted-perception-ml-cu128", "kilted-perception-ml-cpu",
    "lyrical-perception", "lyrical-perception-cuda-cu128", "lyrical-perception-cuda-cu130", "lyrical-perception-cuda-cu132", "lyrical-perception-cuda-cu121", "lyrical-perception-torch-cu128", "lyrical-perception-torch-cu130", "lyrical-perception-torch-cu132",
    "rolling-perception", "rolling-perception-cuda-cu128", "rolling-perception-cuda-cu130", "rolling-perception-cuda-cu132", "rolling-perception-cuda-cu121", "rolling-perception-torch-cu128", "rolling-perception-torch-cu130", "rolling-perception-torch-cu132",
    "ros1-bookworm-perception", "ros1-bookworm-perception-cuda-cu128", "ros1-bookworm-perception-cuda-cu130", "ros1-bookworm-perception-cuda-cu132", "ros1-bookworm-perception-cuda-cu121", "ros1-bookworm-perception-torch-cu128", "ros1-bookworm-perception-torch-cu130", "ros1-bookworm-perception-torch-cu132", "ros1-bookworm-perception-tensorflow-cu128", "ros1-bookworm-perception-tensorflow-cpu", "ros1-bookworm-perception-ml-cu128",
    "ros1-trixie-perception", "ros1-trixie-perception-cuda-cu128", "ros1-trixie-perception-cuda-cu130", "ros1-trixie-perception-cuda-cu132", "ros1-trixie-perception-cuda-cu121", "ros1-trixie-perception-torch-cu128", "ros1-trixie-perception-torch-cu130", "ros1-trixie-perception-torch-cu132", "ros1-trixie-perception-torch-cpu", "ros1-trixie-perception-tensorflow-cu128", "ros1-trixie-perception-tensorflow-cpu", "ros1-trixie-perception-ml-cu128", "ros1-trixie-perception-ml-cpu",
  ]
}

group "desktop" {
  targets = [
    "noetic-desktop", "noetic-desktop-cuda-cu128", "noetic-desktop-cuda-cu130", "noetic-desktop-cuda-cu132", "noetic-desktop-cuda-cu121", "noetic-desktop-torch-cu121", "noetic-desktop-tensorflow-cpu38",
    "foxy-desktop", "foxy-desktop-cuda-cu128", "foxy-desktop-cuda-cu130", "foxy-desktop-cuda-cu132", "foxy-desktop-cuda-cu121", "foxy-desktop-torch-cu121", "foxy-desktop-tensorflow-cpu38",
    "humble-desktop", "humble-desktop-cuda-cu128", "humble-desktop-cuda-cu130", "humble-desktop-cuda-cu132", "humble-desktop-cuda-cu121", "humble-desktop-torch-cu128", "humble-desktop-torch-cu130", "humble-desktop-torch-cpu", "humble-desktop-tensorflow-cu128", "humble-desktop-tensorflow-cpu", "humble-desktop-ml-cu128", "humble-desktop-ml-cpu",
    "iron-desktop", "iron-desktop-cuda-cu128", "iron-desktop-cuda-cu130", "iron-desktop-cuda-cu132", "iron-desktop-cuda-cu121", "iron-desktop-torch-cu128", "iron-desktop-torch-cu130", "iron-desktop-torch-cpu", "iron-desktop-tensorflow-cu128", "iron-desktop-tensorflow-cpu", "iron-desktop-ml-cu128", "iron-desktop-ml-cpu",
    "jazzy-desktop", "jazzy-desktop-cuda-cu128", "jazzy-desktop-cuda-cu130", "jazzy-desktop-cuda-cu132", "jazzy-desktop-cuda-cu121", "jazzy-desktop-torch-cu128", "jazzy-desktop-torch-cu130", "jazzy-desktop-torch-cu132", "jazzy-desktop-torch-cpu", "jazzy-desktop-tensorflow-cu128", "jazzy-desktop-tensorflow-cpu", "jazzy-desktop-ml-cu128", "jazzy-desktop-ml-cpu",
    "kilted-desktop", "kilted-desktop-cuda-cu128", "kilted-desktop-cuda-cu130", "kilted-desktop-cuda-cu132", "kilted-desktop-cuda-cu121", "kilted-desktop-torch-cu128", "kilted-desktop-torch-cu130", "kilted-desktop-torch-cu132", "kilted-desktop-torch-cpu", "kilted-desktop-tensorflow-cu128", "kilted-desktop-tensorflow-cpu", "kilted-desktop-ml-cu128", "kilted-desktop-ml-cpu",
    "lyrical-desktop", "lyrical-desktop-cuda-cu128", "lyrical-desktop-cuda-cu130", "lyrical-desktop-cuda-cu132", "lyrical-desktop-cuda-cu121", "lyrical-desktop-torch-cu128", "lyrical-desktop-torch-cu130", "lyrical-desktop-torch-cu132",
    "rolling-desktop", "rolling-desktop-cuda-cu128", "rolling-desktop-cuda-cu130", "rolling-desktop-cuda-cu132", "rolling-desktop-cuda-cu121", "rolling-desktop-torch-cu128", "rolling-desktop-torch-cu130", "rolling-desktop-torch-cu132",
    "ros1-bookworm-desktop", "ros1-bookworm-desktop-cuda-cu128", "ros1-bookworm-desktop-cuda-cu130", "ros1-bookworm-desktop-cuda-cu132", "ros1-bookworm-desktop-cuda-cu121", "ros1-bookworm-desktop-torch-cu128", "ros1-bookworm-desktop-torch-cu130", "ros1-bookworm-desktop-torch-cu132", "ros1-bookworm-desktop-tensorflow-cu128", "ros1-bookworm-desktop-tensorflow-cpu", "ros1-bookworm-desktop-ml-cu128",
    "ros1-trixie-desktop", "ros1-trixie-desktop-cuda-cu128", "ros1-trixie-desktop-cuda-cu130", "ros1-trixie-desktop-cuda-cu132", "ros1-trixie-desktop-cuda-cu121", "ros1-trixie-desktop-torch-cu128", "ros1-trixie-desktop-torch-cu130", "ros1-trixie-desktop-torch-cu132", "ros1-trixie-desktop-torch-cpu", "ros1-trixie-desktop-tensorflow-cu128", "ros1-trixie-desktop-tensorflow-cpu", "ros1-trixie-desktop-ml-cu128", "ros1-trixie-desktop-ml-cpu",
  ]
}

group "desktop-full" {
  targets = [
    "noetic-desktop-full", "noetic-desktop-full-cuda-cu128", "noetic-desktop-full-cuda-cu130", "noetic-desktop-full-cuda-cu132", "noetic-desktop-full-cuda-cu121", "noetic-desktop-full-torch-cu121", "noetic-desktop-full-tensorflow-cpu38",
    "humble-desktop-full", "humble-desktop-full-cuda-cu128", "humble-desktop-full-cuda-cu130", "humble-desktop-full-cuda-cu132", "humble-desktop-full-cuda-cu121", "humble-desktop-full-torch-cu128", "humble-desktop-full-torch-cu130", "humble-desktop-full-torch-cpu", "humble-desktop-full-tensorflow-cu128", "humble-desktop-full-tensorflow-cpu", "humble-desktop-full-ml-cu128", "humble-desktop-full-ml-cpu",
    "iron-desktop-full", "iron-desktop-full-cuda-cu128", "iron-desktop-full-cuda-cu130", "iron-desktop-full-cuda-cu132", "iron-desktop-full-cuda-cu121", "iron-desktop-full-torch-cu128", "iron-desktop-full-torch-cu130", "iron-desktop-full-torch-cpu", "iron-desktop-full-tensorflow-cu128", "iron-desktop-full-tensorflow-cpu", "iron-desktop-full-ml-cu128", "iron-desktop-full-ml-cpu",
    "jazzy-desktop-full", "jazzy-desktop-full-cuda-cu128", "jazzy-desktop-full-cuda-cu130", "jazzy-desktop-full-cuda-cu132", "jazzy-desktop-full-cuda-cu121", "jazzy-desktop-full-torch-cu128", "jazzy-desktop-full-torch-cu130", "jazzy-desktop-full-torch-cu132", "jazzy-desktop-full-torch-cpu", "jazzy-desktop-full-tensorflow-cu128", "jazzy-desktop-full-tensorflow-cpu", "jazzy-desktop-full-ml-cu128", "jazzy-desktop-full-ml-cpu",
    "kilted-desktop-full", "kilted-desktop-full-cuda-cu128", "kilted-desktop-full-cuda-cu130", "kilted-desktop-full-cuda-cu132", "kilted-desktop-full-cuda-cu121", "kilted-desktop-full-torch-cu128", "kilted-desktop-full-torch-cu130", "kilted-desktop-full-torch-cu132", "kilted-desktop-full-torch-cpu", "kilted-desktop-full-tensorflow-cu128", "kilted-desktop-full-tensorflow-cpu", "kilted-desktop-full-ml-cu128", "kilted-desktop-full-ml-cpu",
    "lyrical-desktop-full", "lyrical-desktop-full-cuda-cu128", "lyrical-desktop-full-cuda-cu130", "lyrical-desktop-full-cuda-cu132", "lyrical-desktop-full-cuda-cu121", "lyrical-desktop-full-torch-cu128", "lyrical-desktop-full-torch-cu130", "lyrical-desktop-full-torch-cu132",
    "rolling-desktop-full", "rolling-desktop-full-cuda-cu128", "rolling-desktop-full-cuda-cu130", "rolling-desktop-full-cuda-cu132", "rolling-desktop-full-cuda-cu121", "rolling-desktop-full-torch-cu128", "rolling-desktop-full-torch-cu130", "rolling-desktop-full-torch-cu132",
    "ros1-bookworm-desktop-full", "ros1-bookworm-desktop-full-cuda-cu128", "ros1-bookworm-desktop-full-cuda-cu130", "ros1-bookworm-desktop-full-cuda-cu132", "ros1-bookworm-desktop-full-cuda-cu121", "ros1-bookworm-desktop-full-torch-cu128", "ros1-bookworm-desktop-full-torch-cu130", "ros1-bookworm-desktop-full-torch-cu132", "ros1-bookworm-desktop-full-tensorflow-cu128", "ros1-bookworm-desktop-full-tensorflow-cpu", "ros1-bookworm-desktop-full-ml-cu128",
    "ros1-trixie-desktop-full", "ros1-trixie-desktop-full-cuda-cu128", "ros1-trixie-desktop-full-cuda-cu130", "ros1-trixie-desktop-full-cuda-cu132", "ros1-trixie-desktop-full-cuda-cu121", "ros1-trixie-desktop-full-torch-cu128", "ros1-trixie-desktop-full-torch-cu130", "ros1-trixie-desktop-full-torch-cu132", "ros1-trixie-desktop-full-torch-cpu", "ros1-trixie-desktop-full-tensorflow-cu128", "ros1-trixie-desktop-full-tensorflow-cpu", "ros1-trixie-desktop-full-ml-cu128", "ros1-trixie-desktop-full-ml-cpu",
  ]
}

group "core-run" {
  targets = [
    "noetic-core-run", "noetic-core-run-cuda-cu128", "noetic-core-run-cuda-cu130", "noetic-core-run-cuda-cu132", "noetic-core-run-cuda-cu121", "noetic-core-run-torch-cu121", "noetic-core-run-tensorflow-cpu38",
    "foxy-core-run", "foxy-core-run-cuda-cu128", "foxy-core-run-cuda-cu130", "foxy-core-run-cuda-cu132", "foxy-core-run-cuda-cu121", "foxy-core-run-torch-cu121", "foxy-core-run-tensorflow-cpu38",
    "humble-core-run", "humble-core-run-cuda-cu128", "humble-core-run-cuda-cu130", "humble-core-run-cuda-cu132", "humble-core-run-cuda-cu121", "humble-core-run-torch-cu128", "humble-core-run-torch-cu130", "humble-core-run-torch-cpu", "humble-core-run-tensorflow-cu128", "humble-core-run-tensorflow-cpu", "humble-core-run-ml-cu128", "humble-core-run-ml-cpu",
    "iron-core-run", "iron-core-run-cuda-cu128", "iron-core-run-cuda-cu130", "iron-core-run-cuda-cu132", "iron-core-run-cuda-cu121", "iron-core-run-torch-cu128", "iron-core-run-torch-cu130", "iron-core-run-torch-cpu", "iron-core-run-tensorflow-cu128", "iron-core-run-tensorflow-cpu", "iron-core-run-ml-cu128", "iron-core-run-ml-cpu",
    "jazzy-core-run", "jazzy-core-run-cuda-cu128", "jazzy-core-run-cuda-cu130", "jazzy-core-run-cuda-cu132", "jazzy-core-run-cuda-cu121", "jazzy-core-run-torch-cu128", "jazzy-core-run-torch-cu130", "jazzy-core-run-torch-cu132", "jazzy-core-run-torch-cpu", "jazzy-core-run-tensorflow-cu128", "jazzy-core-run-tensorflow-cpu", "jazzy-core-run-ml-cu128", "jazzy-core-run-ml-cpu",
    "kilted-core-run", "kilted-core-run-cuda-cu128", "kilted-core-run-cuda-cu130", "kilted-core-run-cuda-cu132", "kilted-core-run-cuda-cu121", "kilted-core-run-torch-cu128", "kilted-core-run-torch-cu130", "kilted-core-run-torch-cu132", "kilted-core-run-torch-cpu", "kilted-core-run-tensorflow-cu128", "kilted-core-run-tensorflow-cpu", "kilted-core-run-ml-cu128", "kilted-core-run-ml-cpu",
    "lyrical-core-run", "lyrical-core-run-cuda-cu128", "lyrical-core-run-cuda-cu130", "lyrical-core-run-cuda-cu132", "lyrical-core-run-cuda-cu121", "lyrical-core-run-torch-cu128", "lyrical-core-run-torch-cu130", "lyrical-core-run-torch-cu132",
    "rolling-core-run", "rolling-core-run-cuda-cu128", "rolling-core-run-cuda-cu130", "rolling-core-run-cuda-cu132", "rolling-core-run-cuda-cu121", "rolling-core-run-torch-cu128", "rolling-core-run-torch-cu130", "rolling-core-run-torch-cu132",
    "ros1-bookworm-core-run", "ros1-bookworm-core-run-cuda-cu128", "ros1-bookworm-core-run-cuda-cu130", "ros1-bookworm-core-run-cuda-cu132", "ros1-bookworm-core-run-cuda-cu121", "ros1-bookworm-core-run-torch-cu128", "ros1-bookworm-core-run-torch-cu130", "ros1-bookworm-core-run-torch-cu132", "ros1-bookworm-core-run-tensorflow-cu128", "ros1-bookworm-core-run-tensorflow-cpu", "ros1-bookworm-core-run-ml-cu128",
    "ros1-trixie-core-run", "ros1-trixie-core-run-cuda-cu128", "ros1-trixie-core-run-cuda-cu130", "ros1-trixie-core-run-cuda-cu132", "ros1-trixie-core-run-cuda-cu121", "ros1-trixie-core-run-torch-cu128", "ros1-trixie-core-run-torch-cu130", "ros1-trixie-core-run-torch-cu132", "ros1-trixie-core-run-torch-cpu", "ros1-trixie-core-run-tensorflow-cu128", "ros1-trixie-core-run-tensorflow-cpu", "ros1-trixie-core-run-ml-cu128", "ros1-trixie-core-run-ml-cpu",
  ]
}

group "base-run" {
  targets = [
    "noetic-base-run", "noetic-base-run-cuda-cu128", "noetic-base-run-cuda-cu130", "noetic-base-run-cuda-cu132", "noetic-base-run-cuda-cu121", "noetic-base-run-torch-cu121", "noetic-base-run-tensorflow-cpu38",
    "foxy-base-run", "foxy-base-run-cuda-cu128", "foxy-base-run-cuda-cu130", "foxy-base-run-cuda-cu132", "foxy-base-run-cuda-cu121", "foxy-base-run-torch-cu121", "foxy-base-run-tensorflow-cpu38",
    "humble-base-run", "humble-base-run-cuda-cu128", "humble-base-run-cuda-cu130", "humble-base-run-cuda-cu132", "humble-base-run-cuda-cu121", "humble-base-run-torch-cu128", "humble-base-run-torch-cu130", "humble-base-run-torch-cpu", "humble-base-run-tensorflow-cu128", "humble-base-run-tensorflow-cpu", "humble-base-run-ml-cu128", "humble-base-run-ml-cpu",
    "iron-base-run", "iron-base-run-cuda-cu128", "iron-base-run-cuda-cu130", "iron-base-run-cuda-cu132", "iron-base-run-cuda-cu121", "iron-base-run-torch-cu128", "iron-base-run-torch-cu130", "iron-base-run-torch-cpu", "iron-base-run-tensorflow-cu128", "iron-base-run-tensorflow-cpu", "iron-base-run-ml-cu128", "iron-base-run-ml-cpu",
    "jazzy-base-run", "jazzy-base-run-cuda-cu128", "jazzy-base-run-cuda-cu130", "jazzy-base-run-cuda-cu132", "jazzy-base-run-cuda-cu121", "jazzy-base-run-torch-cu128", "jazzy-base-run-torch-cu130", "jazzy-base-run-torch-cu132", "jazzy-base-run-torch-cpu", "jazzy-base-run-tensorflow-cu128", "jazzy-base-run-tensorflow-cpu", "jazzy-base-run-ml-cu128", "jazzy-base-run-ml-cpu",
    "kilted-base-run", "kilted-base-run-cuda-cu128", "kilted-base-run-cuda-cu130", "kilted-base-run-cuda-cu132", "kilted-base-run-cuda-cu121", "kilted-base-run-torch-cu128", "kilted-base-run-torch-cu130", "kilted-base-run-torch-cu132", "kilted-base-run-torch-cpu", "kilted-base-run-tensorflow-cu128", "kilted-base-run-tensorflow-cpu", "kilted-base-run-ml-cu128", "kilted-base-run-ml-cpu",
    "lyrical-base-run", "lyrical-base-run-cuda-cu128", "lyrical-base-run-cuda-cu130", "lyrical-base-run-cuda-cu132", "lyrical-base-run-cuda-cu121", "lyrical-base-run-torch-cu128", "lyrical-base-run-torch-cu130", "lyrical-base-run-torch-cu132",
    "rolling-base-run", "rolling-base-run-cuda-cu128", "rolling-base-run-cuda-cu130", "rolling-base-run-cuda-cu132", "rolling-base-run-cuda-cu121", "rolling-base-run-torch-cu128", "rolling-base-run-torch-cu130", "rolling-base-run-torch-cu132",
    "ros1-bookworm-base-run", "ros1-bookworm-base-run-cuda-cu128", "ros1-bookworm-base-run-cuda-cu130", "ros1-bookworm-base-run-cuda-cu132", "ros1-bookworm-base-run-cuda-cu121", "ros1-bookworm-base-run-torch-cu128", "ros1-bookworm-base-run-torch-cu130", "ros1-bookworm-base-run-torch-cu132", "ros1-bookworm-base-run-tensorflow-cu128", "ros1-bookworm-base-run-tensorflow-cpu", "ros1-bookworm-base-run-ml-cu128",
    "ros1-trixie-base-run", "ros1-trixie-base-run-cuda-cu128", "ros1-trixie-base-run-cuda-cu130", "ros1-trixie-base-run-cuda-cu132", "ros1-trixie-base-run-cuda-cu121", "ros1-trixie-base-run-torch-cu128", "ros1-trixie-base-run-torch-cu130", "ros1-trixie-base-run-torch-cu132", "ros1-trixie-base-run-torch-cpu", "ros1-trixie-base-run-tensorflow-cu128", "ros1-trixie-base-run-tensorflow-cpu", "ros1-trixie-base-run-ml-cu128", "ros1-trixie-base-run-ml-cpu",
  ]
}

group "none" {
  targets = [
    "noetic-core", "noetic-base", "noetic-robot", "noetic-perception", "noetic-desktop", "noetic-desktop-full", "noetic-core-run", "noetic-base-run",
    "foxy-core", "foxy-base", "foxy-desktop", "foxy-core-run", "foxy-base-run",
    "humble-core", "humble-base", "humble-perception", "humble-desktop", "humble-desktop-full", "humble-core-run", "humble-base-run",
    "iron-core", "iron-base", "iron-perception", "iron-desktop", "iron-desktop-full", "iron-core-run", "iron-base-run",
    "jazzy-core", "jazzy-base", "jazzy-perception", "jazzy-desktop", "jazzy-desktop-full", "jazzy-core-run", "jazzy-base-run",
    "kilted-core", "kilted-base", "kilted-perception", "kilted-desktop", "kilted-desktop-full", "kilted-core-run", "kilted-base-run",
    "lyrical-core", "lyrical-base", "lyrical-perception", "lyrical-desktop", "lyrical-desktop-full", "lyrical-core-run", "lyrical-base-run",
    "rolling-core", "rolling-base", "rolling-perception", "rolling-desktop", "rolling-desktop-full", "rolling-core-run", "rolling-base-run",
    "ros1-bookworm-core", "ros1-bookworm-base", "ros1-bookworm-robot", "ros1-bookworm-perception", "ros1-bookworm-desktop", "ros1-bookworm-desktop-full", "ros1-bookworm-core-run", "ros1-bookworm-base-run",
    "ros1-trixie-core", "ros1-trixie-base", "ros1-trixie-robot", "ros1-trixie-perception", "ros1-trixie-desktop", "ros1-trixie-desktop-full", "ros1-trixie-core-run", "ros1-trixie-base-run",
    "jazzy-wheels-core",
  ]
}

group "cuda" {
  targets = [
    "noetic-core-cuda-cu128", "noetic-base-cuda-cu128", "noetic-robot-cuda-cu128", "noetic-perception-cuda-cu128", "noetic-desktop-cuda-cu128", "noetic-desktop-full-cuda-cu128", "noetic-core-run-cuda-cu128", "noetic-base-run-cuda-cu128", "noetic-core-cuda-cu130", "noetic-base-cuda-cu130", "noetic-robot-cuda-cu130", "noetic-perception-cuda-cu130", "noetic-desktop-cuda-cu130", "noetic-desktop-full-cuda-cu130", "noetic-core-run-cuda-cu130", "noetic-base-run-cuda-cu130", "noetic-core-cuda-cu132", "noetic-base-cuda-cu132", "noetic-robot-cuda-cu132", "noetic-perception-cuda-cu132", "noetic-desktop-cuda-cu132", "noetic-desktop-full-cuda-cu132", "noetic-core-run-cuda-cu132", "noetic-base-run-cuda-cu132", "noetic-core-cuda-cu121", "noetic-base-cuda-cu121", "noetic-robot-cuda-cu121", "noetic-perception-cuda-cu121", "noetic-desktop-cuda-cu121", "noetic-desktop-full-cuda-cu121", "noetic-core-run-cuda-cu121", "noetic-base-run-cuda-cu121",
    "foxy-core-cuda-cu128", "foxy-base-cuda-cu128", "foxy-desktop-cuda-cu128", "foxy-core-run-cuda-cu128", "foxy-base-run-cuda-cu128", "foxy-core-cuda-cu130", "foxy-base-cuda-cu130", "foxy-desktop-cuda-cu130", "foxy-core-run-cuda-cu130", "foxy-base-run-cuda-cu130", "foxy-core-cuda-cu132", "foxy-base-cuda-cu132", "foxy-desktop-cuda-cu132", "foxy-core-run-cuda-cu132", "foxy-base-run-cuda-cu132", "foxy-core-cuda-cu121", "foxy-base-cuda-cu121", "foxy-desktop-cuda-cu121", "foxy-core-run-cuda-cu121", "foxy-base-run-cuda-cu121",
    "humble-core-cuda-cu128", "humble-base-cuda-cu128", "humble-perception-cuda-cu128", "humble-desktop-cuda-cu128", "humble-desktop-full-cuda-cu128", "humble-core-run-cuda-cu128", "humble-base-run-cuda-cu128", "humble-core-cuda-cu130", "humble-base-cuda-cu130", "humble-perception-cuda-cu130", "humble-desktop-cuda-cu130", "humble-desktop-full-cuda-cu130", "humble-core-run-cuda-cu130", "humble-base-run-cuda-cu130", "humble-core-cuda-cu132", "humble-base-cuda-cu132", "humble-perception-cuda-cu132", "humble-desktop-cuda-cu132", "humble-desktop-full-cuda-cu132", "humble-core-run-cuda-cu132", "humble-base-run-cuda-cu132", "humble-core-cuda-cu121", "humble-base-cuda-cu121", "humble-perception-cuda-cu121", "humble-desktop-cuda-cu121", "humble-desktop-full-cuda-cu121", "humble-core-run-cuda-cu121", "humble-base-run-cuda-cu121",
    "iron-core-cuda-cu128", "iron-base-cuda-cu128", "iron-perception-cuda-cu128", "iron-desktop-cuda-cu128", "iron-desktop-full-cuda-cu128", "iron-core-run-cuda-cu128", "iron-base-run-cuda-cu128", "iron-core-cuda-cu130", "iron-base-cuda-cu130", "iron-perception-cuda-cu130", "iron-desktop-cuda-cu130", "iron-desktop-full-cuda-cu130", "iron-core-run-cuda-cu130", "iron-base-run-cuda-cu130", "iron-core-cuda-cu132", "iron-base-cuda-cu132", "iron-perception-cuda-cu132", "iron-desktop-cuda-cu132", "iron-desktop-full-cuda-cu132", "iron-core-run-cuda-cu132", "iron-base-run-cuda-cu132", "iron-core-cuda-cu121", "iron-base-cuda-cu121", "iron-perception-cuda-cu121", "iron-desktop-cuda-cu121", "iron-desktop-full-cuda-cu121", "iron-core-run-cuda-cu121", "iron-base-run-cuda-cu121",
    "jazzy-core-cuda-cu128", "jazzy-base-cuda-cu128", "jazzy-perception-cuda-cu128", "jazzy-desktop-cuda-cu128", "jazzy-desktop-full-cuda-cu128", "jazzy-core-run-cuda-cu128", "jazzy-base-run-cuda-cu128", "jazzy-core-cuda-cu130", "jazzy-base-cuda-cu130", "jazzy-perception-cuda-cu130", "jazzy-desktop-cuda-cu130", "jazzy-desktop-full-cuda-cu130", "jazzy-core-run-cuda-cu130", "jazzy-base-run-cuda-cu130", "jazzy-core-cuda-cu132", "jazzy-base-cuda-cu132", "jazzy-perception-cuda-cu132", "jazzy-desktop-cuda-cu132", "jazzy-desktop-full-cuda-cu132", "jazzy-core-run-cuda-cu132", "jazzy-base-run-cuda-cu132", "jazzy-core-cuda-cu121", "jazzy-base-cuda-cu121", "jazzy-perception-cuda-cu121", "jazzy-desktop-cuda-cu121", "jazzy-desktop-full-cuda-cu121", "jazzy-core-run-cuda-cu121", "jazzy-base-run-cuda-cu121",
    "kilted-core-cuda-cu128", "kilted-base-cuda-cu128", "kilted-perception-cuda-cu128", "kilted-desktop-cuda-cu128", "kilted-desktop-full-cuda-cu128", "kilted-core-run-cuda-cu128", "kilted-base-run-cuda-cu128", "kilted-core-cuda-cu130", "kilted-base-cuda-cu130", "kilted-perception-cuda-cu130", "kilted-desktop-cuda-cu130", "kilted-desktop-full-cuda-cu130", "kilted-core-run-cuda-cu130", "kilted-base-run-cuda-cu130", "kilted-core-cuda-cu132", "kilted-base-cuda-cu132", "kilted-perception-cuda-cu132", "kilted-desktop-cuda-cu132", "kilted-desktop-full-cuda-cu132", "kilted-core-run-cuda-cu132", "kilted-base-run-cuda-cu132", "kilted-core-cuda-cu121", "kilted-base-cuda-cu121", "kilted-perception-cuda-cu121", "kilted-desktop-cuda-cu121", "kilted-desktop-full-cuda-cu121", "kilted-core-run-cuda-cu121", "kilted-base-run-cuda-cu121",
    "lyrical-core-cuda-cu128", "lyrical-base-cuda-cu128", "lyrical-perception-cuda-cu128", "lyrical-desktop-cuda-cu128", "lyrical-desktop-full-cuda-cu128", "lyrical-core-run-cuda-cu128", "lyrical-base-run-cuda-cu128", "lyrical-core-cuda-cu130", "lyrical-base-cuda-cu130", "lyrical-perception-cuda-cu130", "lyrical-desktop-cuda-cu130", "lyrical-desktop-full-cuda-cu130", "lyrical-core-run-cuda-cu130", "lyrical-base-run-cuda-cu130", "lyrical-core-cuda-cu132", "lyrical-base-cuda-cu132", "lyrical-perception-cuda-cu132", "lyrical-desktop-cuda-cu132", "lyrical-desktop-full-cuda-cu132", "lyrical-core-run-cuda-cu132", "lyrical-base-run-cuda-cu132", "lyrical-core-cuda-cu121", "lyrical-base-cuda-cu121", "lyrical-perception-cuda-cu121", "lyrical-desktop-cuda-cu121", "lyrical-desktop-full-cuda-cu121", "lyrical-core-run-cuda-cu121", "lyrical-base-run-cuda-cu121",
    "rolling-core-cuda-cu128", "rolling-base-cuda-cu128", "rolling-perception-cuda-cu128", "rolling-desktop-cuda-cu128", "rolling-desktop-full-cuda-cu128", "rolling-core-run-cuda-cu128", "rolling-base-run-cuda-cu128", "rolling-core-cuda-cu130", "rolling-base-cuda-cu130", "rolling-perception-cuda-cu130", "rolling-desktop-cuda-cu130", "rolling-desktop-full-cuda-cu130", "rolling-core-run-cuda-cu130", "rolling-base-run-cuda-cu130", "rolling-core-cuda-cu132", "rolling-base-cuda-cu132", "rolling-perception-cuda-cu132", "rolling-desktop-cuda-cu132", "rolling-desktop-full-cuda-cu132", "rolling-core-run-cuda-cu132", "rolling-base-run-cuda-cu132", "rolling-core-cuda-cu121", "rolling-base-cuda-cu121", "rolling-perception-cuda-cu121", "rolling-desktop-cuda-cu121", "rolling-desktop-full-cuda-cu121", "rolling-core-run-cuda-cu121", "rolling-base-run-cuda-cu121",
    "ros1-bookworm-core-cuda-cu128", "ros1-bookworm-base-cuda-cu128", "ros1-bookworm-robot-cuda-cu128", "ros1-bookworm-perception-cuda-cu128", "ros1-bookworm-desktop-cuda-cu128", "ros1-bookworm-desktop-full-cuda-cu128", "ros1-bookworm-core-run-cuda-cu128", "ros1-bookworm-base-run-cuda-cu128", "ros1-bookworm-core-cuda-cu130", "ros1-bookworm-base-cuda-cu130", "ros1-bookworm-robot-cuda-cu130", "ros1-bookworm-perception-cuda-cu130", "ros1-bookworm-desktop-cuda-cu130", "ros1-bookworm-desktop-full-cuda-cu130", "ros1-bookworm-core-run-cuda-cu130", "ros1-bookworm-base-run-cuda-cu130", "ros1-bookworm-core-cuda-cu132", "ros1-bookworm-base-cuda-cu132", "ros1-bookworm-robot-cuda-cu132", "ros1-bookworm-perception-cuda-cu132", "ros1-bookworm-desktop-cuda-cu132", "ros1-bookworm-desktop-full-cuda-cu132", "ros1-bookworm-core-run-cuda-cu132", "ros1-bookworm-base-run-cuda-cu132", "ros1-bookworm-core-cuda-cu121", "ros1-bookworm-base-cuda-cu121", "ros1-bookworm-robot-cuda-cu121", "ros1-bookworm-perception-cuda-cu121", "ros1-bookworm-desktop-cuda-cu121", "ros1-bookworm-desktop-full-cuda-cu121", "ros1-bookworm-core-run-cuda-cu121", "ros1-bookworm-base-run-cuda-cu121",
    "ros1-trixie-core-cuda-cu128", "ros1-trixie-base-cuda-cu128", "ros1-trixie-robot-cuda-cu128", "ros1-trixie-perception-cuda-cu128", "ros1-trixie-desktop-cuda-cu128", "ros1-trixie-desktop-full-cuda-cu128", "ros1-trixie-core-run-cuda-cu128", "ros1-trixie-base-run-cuda-cu128", "ros1-trixie-core-cuda-cu130", "ros1-trixie-base-cuda-cu130", "ros1-trixie-robot-cuda-cu130", "ros1-trixie-perception-cuda-cu130", "ros1-trixie-desktop-cuda-cu130", "ros1-trixie-desktop-full-cuda-cu130", "ros1-trixie-core-run-cuda-cu130", "ros1-trixie-base-run-cuda-cu130", "ros1-trixie-core-cuda-cu132", "ros1-trixie-base-cuda-cu132", "ros1-trixie-robot-cuda-cu132", "ros1-trixie-perception-cuda-cu132", "ros1-trixie-desktop-cuda-cu132", "ros1-trixie-desktop-full-cuda-cu132", "ros1-trixie-core-run-cuda-cu132", "ros1-trixie-base-run-cuda-cu132", "ros1-trixie-core-cuda-cu121", "ros1-trixie-base-cuda-cu121", "ros1-trixie-robot-cuda-cu121", "ros1-trixie-perception-cuda-cu121", "ros1-trixie-desktop-cuda-cu121", "ros1-trixie-desktop-full-cuda-cu121", "ros1-trixie-core-run-cuda-cu121", "ros1-trixie-base-run-cuda-cu121",
    "jazzy-wheels-core-cuda-cu128", "jazzy-wheels-core-cuda-cu130", "jazzy-wheels-core-cuda-cu132", "jazzy-wheels-core-cuda-cu121",
  ]
}

group "torch" {
  targets = [
    "noetic-core-torch-cu121", "noetic-base-torch-cu121", "noetic-robot-torch-cu121", "noetic-perception-torch-cu121", "noetic-desktop-torch-cu121", "noetic-desktop-full-torch-cu121", "noetic-core-run-torch-cu121", "noetic-base-run-torch-cu121",
    "foxy-core-torch-cu121", "foxy-base-torch-cu121", "foxy-desktop-torch-cu121", "foxy-core-run-torch-cu121", "foxy-base-run-torch-cu121",
    "humble-core-torch-cu128", "humble-base-torch-cu128", "humble-perception-torch-cu128", "humble-desktop-torch-cu128", "humble-desktop-full-torch-cu128", "humble-core-run-torch-cu128", "humble-base-run-torch-cu128", "humble-core-torch-cu130", "humble-base-torch-cu130", "humble-perception-torch-cu130", "humble-desktop-torch-cu130", "humble-desktop-full-torch-cu130", "humble-core-run-torch-cu130", "humble-base-run-torch-cu130", "humble-core-torch-cpu", "humble-base-torch-cpu", "humble-perception-torch-cpu", "humble-desktop-torch-cpu", "humble-desktop-full-torch-cpu", "humble-core-run-torch-cpu", "humble-base-run-torch-cpu",
    "iron-core-torch-cu128", "iron-base-torch-cu128", "iron-perception-torch-cu128", "iron-desktop-torch-cu128", "iron-desktop-full-torch-cu128", "iron-core-run-torch-cu128", "iron-base-run-torch-cu128", "iron-core-torch-cu130", "iron-base-torch-cu130", "iron-perception-torch-cu130", "iron-desktop-torch-cu130", "iron-desktop-full-torch-cu130", "iron-core-run-torch-cu130", "iron-base-run-torch-cu130", "iron-core-torch-cpu", "iron-base-torch-cpu", "iron-perception-torch-cpu", "iron-desktop-torch-cpu", "iron-desktop-full-torch-cpu", "iron-core-run-torch-cpu", "iron-base-run-torch-cpu",
    "jazzy-core-torch-cu128", "jazzy-base-torch-cu128", "jazzy-perception-torch-cu128", "jazzy-desktop-torch-cu128", "jazzy-desktop-full-torch-cu128", "jazzy-core-run-torch-cu128", "jazzy-base-run-torch-cu128", "jazzy-core-torch-cu130", "jazzy-base-torch-cu130", "jazzy-perception-torch-cu130", "jazzy-desktop-torch-cu130", "jazzy-desktop-full-torch-cu130", "jazzy-core-run-torch-cu130", "jazzy-base-run-torch-cu130", "jazzy-core-torch-cu132", "jazzy-base-torch-cu132", "jazzy-perception-torch-cu132", "jazzy-desktop-torch-cu132", "jazzy-desktop-full-torch-cu132", "jazzy-core-run-torch-cu132", "jazzy-base-run-torch-cu132", "jazzy-core-torch-cpu", "jazzy-base-torch-cpu", "jazzy-perception-torch-cpu", "jazzy-desktop-torch-cpu", "jazzy-desktop-full-torch-cpu", "jazzy-core-run-torch-cpu", "jazzy-base-run-torch-cpu",
    "kilted-core-torch-cu128", "kilted-base-torch-cu128", "kilted-perception-torch-cu128", "kilted-desktop-torch-cu128", "kilted-desktop-full-torch-cu128", "kilted-core-run-torch-cu128", "kilted-base-run-torch-cu128", "kilted-core-torch-cu130", "kilted-base-torch-cu130", "kilted-perception-torch-cu130", "kilted-desktop-torch-cu130", "kilted-desktop-full-torch-cu130", "kilted-core-run-torch-cu130", "kilted-base-run-torch-cu130", "kilted-core-torch-cu132", "kilted-base-torch-cu132", "kilted-perception-torch-cu132", "kilted-desktop-torch-cu132", "kilted-desktop-full-torch-cu132", "kilted-core-run-torch-cu132", "kilted-base-run-torch-cu132", "kilted-core-torch-cpu", "kilted-base-torch-cpu", "kilted-perception-torch-cpu", "kilted-desktop-torch-cpu", "kilted-desktop-full-torch-cpu", "kilted-core-run-torch-cpu", "kilted-base-run-torch-cpu",
    "lyrical-core-torch-cu128", "lyrical-base-torch-cu128", "lyrical-perception-torch-cu128", "lyrical-desktop-torch-cu128", "lyrical-desktop-full-torch-cu128", "lyrical-core-run-torch-cu128", "lyrical-base-run-torch-cu128", "lyrical-core-torch-cu130", "lyrical-base-torch-cu130", "lyrical-perception-torch-cu130", "lyrical-desktop-torch-cu130", "lyrical-desktop-full-torch-cu130", "lyrical-core-run-torch-cu130", "lyrical-base-run-torch-cu130", "lyrical-core-torch-cu132", "lyrical-base-torch-cu132", "lyrical-perception-torch-cu132", "lyrical-desktop-torch-cu132", "lyrical-desktop-full-torch-cu132", "lyrical-core-run-torch-cu132", "lyrical-base-run-torch-cu132",
    "rolling-core-torch-cu128", "rolling-base-torch-cu128", "rolling-perception-torch-cu128", "rolling-desktop-torch-cu128", "rolling-desktop-full-torch-cu128", "rolling-core-run-torch-cu128", "rolling-base-run-torch-cu128", "rolling-core-torch-cu130", "rolling-base-torch-cu130", "rolling-perception-torch-cu130", "rolling-desktop-torch-cu130", "rolling-desktop-full-torch-cu130", "rolling-core-run-torch-cu130", "rolling-base-run-torch-cu130", "rolling-core-torch-cu132", "rolling-base-torch-cu132", "rolling-perception-torch-cu132", "rolling-desktop-torch-cu132", "rolling-desktop-full-torch-cu132", "rolling-core-run-torch-cu132", "rolling-base-run-torch-cu132",
    "ros1-bookworm-core-torch-cu128", "ros1-bookworm-base-torch-cu128", "ros1-bookworm-robot-torch-cu128", "ros1-bookworm-perception-torch-cu128", "ros1-bookworm-desktop-torch-cu128", "ros1-bookworm-desktop-full-torch-cu128", "ros1-bookworm-core-run-torch-cu128", "ros1-bookworm-base-run-torch-cu128", "ros1-bookworm-core-torch-cu130", "ros1-bookworm-base-torch-cu130", "ros1-bookworm-robot-torch-cu130", "ros1-bookworm-perception-torch-cu130", "ros1-bookworm-desktop-torch-cu130", "ros1-bookworm-desktop-full-torch-cu130", "ros1-bookworm-core-run-torch-cu130", "ros1-bookworm-base-run-torch-cu130", "ros1-bookworm-core-torch-cu132", "ros1-bookworm-base-torch-cu132", "ros1-bookworm-robot-torch-cu132", "ros1-bookworm-perception-torch-cu132", "ros1-bookworm-desktop-torch-cu132", "ros1-bookworm-desktop-full-torch-cu132", "ros1-bookworm-core-run-torch-cu132", "ros1-bookworm-base-run-torch-cu132",
    "ros1-trixie-core-torch-cu128", "ros1-trixie-base-torch-cu128", "ros1-trixie-robot-torch-cu128", "ros1-trixie-perception-torch-cu128", "ros1-trixie-desktop-torch-cu128", "ros1-trixie-desktop-full-torch-cu128", "ros1-trixie-core-run-torch-cu128", "ros1-trixie-base-run-torch-cu128", "ros1-trixie-core-torch-cu130", "ros1-trixie-base-torch-cu130", "ros1-trixie-robot-torch-cu130", "ros1-trixie-perception-torch-cu130", "ros1-trixie-desktop-torch-cu130", "ros1-trixie-desktop-full-torch-cu130", "ros1-trixie-core-run-torch-cu130", "ros1-trixie-base-run-torch-cu130", "ros1-trixie-core-torch-cu132", "ros1-trixie-base-torch-cu132", "ros1-trixie-robot-torch-cu132", "ros1-trixie-perception-torch-cu132", "ros1-trixie-desktop-torch-cu132", "ros1-trixie-desktop-full-torch-cu132", "ros1-trixie-core-run-torch-cu132", "ros1-trixie-base-run-torch-cu132", "ros1-trixie-core-torch-cpu", "ros1-trixie-base-torch-cpu", "ros1-trixie-robot-torch-cpu", "ros1-trixie-perception-torch-cpu", "ros1-trixie-desktop-torch-cpu", "ros1-trixie-desktop-full-torch-cpu", "ros1-trixie-core-run-torch-cpu", "ros1-trixie-base-run-torch-cpu",
    "jazzy-wheels-core-torch-cu128", "jazzy-wheels-core-torch-cu130", "jazzy-wheels-core-torch-cu132",
  ]
}

group "tensorflow" {
  targets = [
    "noetic-core-tensorflow-cpu38", "noetic-base-tensorflow-cpu38", "noetic-robot-tensorflow-cpu38", "noetic-perception-tensorflow-cpu38", "noetic-desktop-tensorflow-cpu38", "noetic-desktop-full-tensorflow-cpu38", "noetic-core-run-tensorflow-cpu38", "noetic-base-run-tensorflow-cpu38",
    "foxy-core-tensorflow-cpu38", "foxy-base-tensorflow-cpu38", "foxy-desktop-tensorflow-cpu38", "foxy-core-run-tensorflow-cpu38", "foxy-base-run-tensorflow-cpu38",
    "humble-core-tensorflow-cu128", "humble-base-tensorflow-cu128", "humble-perception-tensorflow-cu128", "humble-desktop-tensorflow-cu128", "humble-desktop-full-tensorflow-cu128", "humble-core-run-tensorflow-cu128", "humble-base-run-tensorflow-cu128", "humble-core-tensorflow-cpu", "humble-base-tensorflow-cpu", "humble-perception-tensorflow-cpu", "humble-desktop-tensorflow-cpu", "humble-desktop-full-tensorflow-cpu", "humble-core-run-tensorflow-cpu", "humble-base-run-tensorflow-cpu",
    "iron-core-tensorflow-cu128", "iron-base-tensorflow-cu128", "iron-perception-tensorflow-cu128", "iron-desktop-tensorflow-cu128", "iron-desktop-full-tensorflow-cu128", "iron-core-run-tensorflow-cu128", "iron-base-run-tensorflow-cu128", "iron-core-tensorflow-cpu", "iron-base-tensorflow-cpu", "iron-perception-tensorflow-cpu", "iron-desktop-tensorflow-cpu", "iron-desktop-full-tensorflow-cpu", "iron-core-run-tensorflow-cpu", "iron-base-run-tensorflow-cpu",
    "jazzy-core-tensorflow-cu128", "jazzy-base-tensorflow-cu128", "jazzy-perception-tensorflow-cu128", "jazzy-desktop-tensorflow-cu128", "jazzy-desktop-full-tensorflow-cu128", "jazzy-core-run-tensorflow-cu128", "jazzy-base-run-tensorflow-cu128", "jazzy-core-tensorflow-cpu", "jazzy-base-tensorflow-cpu", "jazzy-perception-tensorflow-cpu", "jazzy-desktop-tensorflow-cpu", "jazzy-desktop-full-tensorflow-cpu", "jazzy-core-run-tensorflow-cpu", "jazzy-base-run-tensorflow-cpu",
    "kilted-core-tensorflow-cu128", "kilted-base-tensorflow-cu128", "kilted-perception-tensorflow-cu128", "kilted-desktop-tensorflow-cu128", "kilted-desktop-full-tensorflow-cu128", "kilted-core-run-tensorflow-cu128", "kilted-base-run-tensorflow-cu128", "kilted-core-tensorflow-cpu", "kilted-base-tensorflow-cpu", "kilted-perception-tensorflow-cpu", "kilted-desktop-tensorflow-cpu", "kilted-desktop-full-tensorflow-cpu", "kilted-core-run-tensorflow-cpu", "kilted-base-run-tensorflow-cpu",
    "ros1-bookworm-core-tensorflow-cu128", "ros1-bookworm-base-tensorflow-cu128", "ros1-bookworm-robot-tensorflow-cu128", "ros1-bookworm-perception-tensorflow-cu128", "ros1-bookworm-desktop-tensorflow-cu128", "ros1-bookworm-desktop-full-tensorflow-cu128", "ros1-bookworm-core-run-tensorflow-cu128", "ros1-bookworm-base-run-tensorflow-cu128", "ros1-bookworm-core-tensorflow-cpu", "ros1-bookworm-base-tensorflow-cpu", "ros1-bookworm-robot-tensorflow-cpu", "ros1-bookworm-perception-tensorflow-cpu", "ros1-bookworm-desktop-tensorflow-cpu", "ros1-bookworm-desktop-full-tensorflow-cpu", "ros1-bookworm-core-run-tensorflow-cpu", "ros1-bookworm-base-run-tensorflow-cpu",
    "ros1-trixie-core-tensorflow-cu128", "ros1-trixie-base-tensorflow-cu128", "ros1-trixie-robot-tensorflow-cu128", "ros1-trixie-perception-tensorflow-cu128", "ros1-trixie-desktop-tensorflow-cu128", "ros1-trixie-desktop-full-tensorflow-cu128", "ros1-trixie-core-run-tensorflow-cu128", "ros1-trixie-base-run-tensorflow-cu128", "ros1-trixie-core-tensorflow-cpu", "ros1-trixie-base-tensorflow-cpu", "ros1-trixie-robot-tensorflow-cpu", "ros1-trixie-perception-tensorflow-cpu", "ros1-trixie-desktop-tensorflow-cpu", "ros1-trixie-desktop-full-tensorflow-cpu", "ros1-trixie-core-run-tensorflow-cpu", "ros1-trixie-base-run-tensorflow-cpu",
    "jazzy-wheels-core-tensorflow-cu128", "jazzy-wheels-core-tensorflow-cpu",
  ]
}

group "ml" {
  targets = [
    "humble-core-ml-cu128", "humble-base-ml-cu128", "humble-perception-ml-cu128", "humble-desktop-ml-cu128", "humble-desktop-full-ml-cu128", "humble-core-run-ml-cu128", "humble-base-run-ml-cu128", "humble-core-ml-cpu", "humble-base-ml-cpu", "humble-perception-ml-cpu", "humble-desktop-ml-cpu", "humble-desktop-full-ml-cpu", "humble-core-run-ml-cpu", "humble-base-run-ml-cpu",
    "iron-core-ml-cu128", "iron-base-ml-cu128", "iron-perception-ml-cu128", "iron-desktop-ml-cu128", "iron-desktop-full-ml-cu128", "iron-core-run-ml-cu128", "iron-base-run-ml-cu128", "iron-core-ml-cpu", "iron-base-ml-cpu", "iron-perception-ml-cpu", "iron-desktop-ml-cpu", "iron-desktop-full-ml-cpu", "iron-core-run-ml-cpu", "iron-base-run-ml-cpu",
    "jazzy-core-ml-cu128", "jazzy-base-ml-cu128", "jazzy-perception-ml-cu128", "jazzy-desktop-ml-cu128", "jazzy-desktop-full-ml-cu128", "jazzy-core-run-ml-cu128", "jazzy-base-run-ml-cu128", "jazzy-core-ml-cpu", "jazzy-base-ml-cpu", "jazzy-perception-ml-cpu", "jazzy-desktop-ml-cpu", "jazzy-desktop-full-ml-cpu", "jazzy-core-run-ml-cpu", "jazzy-base-run-ml-cpu",
    "kilted-core-ml-cu128", "kilted-base-ml-cu128", "kilted-perception-ml-cu128", "kilted-desktop-ml-cu128", "kilted-desktop-full-ml-cu128", "kilted-core-run-ml-cu128", "kilted-base-run-ml-cu128", "kilted-core-ml-cpu", "kilted-base-ml-cpu", "kilted-perception-ml-cpu", "kilted-desktop-ml-cpu", "kilted-desktop-full-ml-cpu", "kilted-core-run-ml-cpu", "kilted-base-run-ml-cpu",
    "ros1-bookworm-core-ml-cu128", "ros1-bookworm-base-ml-cu128", "ros1-bookworm-robot-ml-cu128", "ros1-bookworm-perception-ml-cu128", "ros1-bookworm-desktop-ml-cu128", "ros1-bookworm-desktop-full-ml-cu128", "ros1-bookworm-core-run-ml-cu128", "ros1-bookworm-base-run-ml-cu128",
    "ros1-trixie-core-ml-cu128", "ros1-trixie-base-ml-cu128", "ros1-trixie-robot-ml-cu128", "ros1-trixie-perception-ml-cu128", "ros1-trixie-desktop-ml-cu128", "ros1-trixie-desktop-full-ml-cu128", "ros1-trixie-core-run-ml-cu128", "ros1-trixie-base-run-ml-cu128", "ros1-trixie-core-ml-cpu", "ros1-trixie-base-ml-cpu", "ros1-trixie-robot-ml-cpu", "ros1-trixie-perception-ml-cpu", "ros1-trixie-desktop-ml-cpu", "ros1-trixie-desktop-full-ml-cpu", "ros1-trixie-core-run-ml-cpu", "ros1-trixie-base-run-ml-cpu",
    "jazzy-wheels-core-ml-cu128",
  ]
}

group "triton" {
  targets = [
    "humble-core-triton-cu128",
    "jazzy-core-triton-cu128",
    "lyrical-core-triton-cu128",
    "ros1-bookworm-core-triton-cu128",
    "ros1-trixie-core-triton-cu128",
    "humble-core-triton-cu130",
    "jazzy-core-triton-cu130",
    "lyrical-core-triton-cu130",
    "ros1-bookworm-core-triton-cu130",
    "ros1-trixie-core-triton-cu130",
    "humble-core-triton-cu132",
    "jazzy-core-triton-cu132",
    "lyrical-core-triton-cu132",
    "ros1-bookworm-core-triton-cu132",
    "ros1-trixie-core-triton-cu132",
    "humble-core-triton-cpu",
    "jazzy-core-triton-cpu",
    "lyrical-core-triton-cpu",
    "ros1-bookworm-core-triton-cpu",
    "ros1-trixie-core-triton-cpu",
  ]
}

group "tensorrt-rtx" {
  targets = [
    "humble-core-tensorrt-rtx-cu130",
    "jazzy-core-tensorrt-rtx-cu130",
    "lyrical-core-tensorrt-rtx-cu130",
    "ros1-bookworm-core-tensorrt-rtx-cu130",
    "ros1-trixie-core-tensorrt-rtx-cu130",
    "humble-core-tensorrt-rtx-cu132",
    "jazzy-core-tensorrt-rtx-cu132",
    "lyrical-core-tensorrt-rtx-cu132",
    "ros1-bookworm-core-tensorrt-rtx-cu132",
    "ros1-trixie-core-tensorrt-rtx-cu132",
  ]
}

group "cu128" {
  targets = [
    "noetic-core-cuda-cu128", "noetic-base-cuda-cu128", "noetic-robot-cuda-cu128", "noetic-perception-cuda-cu128", "noetic-desktop-cuda-cu128", "noetic-desktop-full-cuda-cu128", "noetic-core-run-cuda-cu128", "noetic-base-run-cuda-cu128",
    "foxy-core-cuda-cu128", "foxy-base-cuda-cu128", "foxy-desktop-cuda-cu128", "foxy-core-run-cuda-cu128", "foxy-base-run-cuda-cu128",
    "humble-core-cuda-cu128", "humble-base-cuda-cu128", "humble-perception-cuda-cu128", "humble-desktop-cuda-cu128", "humble-desktop-full-cuda-cu128", "humble-core-run-cuda-cu128", "humble-base-run-cuda-cu128", "humble-core-torch-cu128", "humble-base-torch-cu128", "humble-perception-torch-cu128", "humble-desktop-torch-cu128", "humble-desktop-full-torch-cu128", "humble-core-run-torch-cu128", "humble-base-run-torch-cu128", "humble-core-tensorflow-cu128", "humble-base-tensorflow-cu128", "humble-perception-tensorflow-cu128", "humble-desktop-tensorflow-cu128", "humble-desktop-full-tensorflow-cu128", "humble-core-run-tensorflow-cu128", "humble-base-run-tensorflow-cu128", "humble-core-ml-cu128", "humble-base-ml-cu128", "humble-perception-ml-cu128", "humble-desktop-ml-cu128", "humble-desktop-full-ml-cu128", "humble-core-run-ml-cu128", "humble-base-run-ml-cu128",
    "iron-core-cuda-cu128", "iron-base-cuda-cu128", "iron-perception-cuda-cu128", "iron-desktop-cuda-cu128", "iron-desktop-full-cuda-cu128", "iron-core-run-cuda-cu128", "iron-base-run-cuda-cu128", "iron-core-torch-cu128", "iron-base-torch-cu128", "iron-perception-torch-cu128", "iron-desktop-torch-cu128", "iron-desktop-full-torch-cu128", "iron-core-run-torch-cu128", "iron-base-run-torch-cu128", "iron-core-tensorflow-cu128", "iron-base-tensorflow-cu128", "iron-perception-tensorflow-cu128", "iron-desktop-tensorflow-cu128", "iron-desktop-full-tensorflow-cu128", "iron-core-run-tensorflow-cu128", "iron-base-run-tensorflow-cu128", "iron-core-ml-cu128", "iron-base-ml-cu128", "iron-perception-ml-cu128", "iron-desktop-ml-cu128", "iron-desktop-full-ml-cu128", "iron-core-run-ml-cu128", "iron-base-run-ml-cu128",
    "jazzy-core-cuda-cu128", "jazzy-base-cuda-cu128", "jazzy-perception-cuda-cu128", "jazzy-desktop-cuda-cu128", "jazzy-desktop-full-cuda-cu128", "jazzy-core-run-cuda-cu128", "jazzy-base-run-cuda-cu128", "jazzy-core-torch-cu128", "jazzy-base-torch-cu128", "jazzy-perception-torch-cu128", "jazzy-desktop-torch-cu128", "jazzy-desktop-full-torch-cu128", "jazzy-core-run-torch-cu128", "jazzy-base-run-torch-cu128", "jazzy-core-tensorflow-cu128", "jazzy-base-tensorflow-cu128", "jazzy-perception-tensorflow-cu128", "jazzy-desktop-tensorflow-cu128", "jazzy-desktop-full-tensorflow-cu128", "jazzy-core-run-tensorflow-cu128", "jazzy-base-run-tensorflow-cu128", "jazzy-core-ml-cu128", "jazzy-base-ml-cu128", "jazzy-perception-ml-cu128", "jazzy-desktop-ml-cu128", "jazzy-desktop-full-ml-cu128", "jazzy-core-run-ml-cu128", "jazzy-base-run-ml-cu128",
    "kilted-core-cuda-cu128", "kilted-base-cuda-cu128", "kilted-perception-cuda-cu128", "kilted-desktop-cuda-cu128", "kilted-desktop-full-cuda-cu128", "kilted-core-run-cuda-cu128", "kilted-base-run-cuda-cu128", "kilted-core-torch-cu128", "kilted-base-torch-cu128", "kilted-perception-torch-cu128", "kilted-desktop-torch-cu128", "kilted-desktop-full-torch-cu128", "kilted-core-run-torch-cu128", "kilted-base-run-torch-cu128", "kilted-core-tensorflow-cu128", "kilted-base-tensorflow-cu128", "kilted-perception-tensorflow-cu128", "kilted-desktop-tensorflow-cu128", "kilted-desktop-full-tensorflow-cu128", "kilted-core-run-tensorflow-cu128", "kilted-base-run-tensorflow-cu128", "kilted-core-ml-cu128", "kilted-base-ml-cu128", "kilted-perception-ml-cu128", "kilted-desktop-ml-cu128", "kilted-desktop-full-ml-cu128", "kilted-core-run-ml-cu128", "kilted-base-run-ml-cu128",
    "lyrical-core-cuda-cu128", "lyrical-base-cuda-cu128", "lyrical-perception-cuda-cu128", "lyrical-desktop-cuda-cu128", "lyrical-desktop-full-cuda-cu128", "lyrical-core-run-cuda-cu128", "lyrical-base-run-cuda-cu128", "lyrical-core-torch-cu128", "lyrical-base-torch-cu128", "lyrical-perception-torch-cu128", "lyrical-desktop-torch-cu128", "lyrical-desktop-full-torch-cu128", "lyrical-core-run-torch-cu128", "lyrical-base-run-torch-cu128",
    "rolling-core-cuda-cu128", "rolling-base-cuda-cu128", "rolling-perception-cuda-cu128", "rolling-desktop-cuda-cu128", "rolling-desktop-full-cuda-cu128", "rolling-core-run-cuda-cu128", "rolling-base-run-cuda-cu128", "rolling-core-torch-cu128", "rolling-base-torch-cu128", "rolling-perception-torch-cu128", "rolling-desktop-torch-cu128", "rolling-desktop-full-torch-cu128", "rolling-core-run-torch-cu128", "rolling-base-run-torch-cu128",
    "ros1-bookworm-core-cuda-cu128", "ros1-bookworm-base-cuda-cu128", "ros1-bookworm-robot-cuda-cu128", "ros1-bookworm-perception-cuda-cu128", "ros1-bookworm-desktop-cuda-cu128", "ros1-bookworm-desktop-full-cuda-cu128", "ros1-bookworm-core-run-cuda-cu128", "ros1-bookworm-base-run-cuda-cu128", "ros1-bookworm-core-torch-cu128", "ros1-bookworm-base-torch-cu128", "ros1-bookworm-robot-torch-cu128", "ros1-bookworm-perception-torch-cu128", "ros1-bookworm-desktop-torch-cu128", "ros1-bookworm-desktop-full-torch-cu128", "ros1-bookworm-core-run-torch-cu128", "ros1-bookworm-base-run-torch-cu128", "ros1-bookworm-core-tensorflow-cu128", "ros1-bookworm-base-tensorflow-cu128", "ros1-bookworm-robot-tensorflow-cu128", "ros1-bookworm-perception-tensorflow-cu128", "ros1-bookworm-desktop-tensorflow-cu128", "ros1-bookworm-desktop-full-tensorflow-cu128", "ros1-bookworm-core-run-tensorflow-cu128", "ros1-bookworm-base-run-tensorflow-cu128", "ros1-bookworm-core-ml-cu128", "ros1-bookworm-base-ml-cu128", "ros1-bookworm-robot-ml-cu128", "ros1-bookworm-perception-ml-cu128", "ros1-bookworm-desktop-ml-cu128", "ros1-bookworm-desktop-full-ml-cu128", "ros1-bookworm-core-run-ml-cu128", "ros1-bookworm-base-run-ml-cu128",
    "ros1-trixie-core-cuda-cu128", "ros1-trixie-base-cuda-cu128", "ros1-trixie-robot-cuda-cu128", "ros1-trixie-perception-cuda-cu128", "ros1-trixie-desktop-cuda-cu128", "ros1-trixie-desktop-full-cuda-cu128", "ros1-trixie-core-run-cuda-cu128", "ros1-trixie-base-run-cuda-cu128", "ros1-trixie-core-torch-cu128", "ros1-trixie-base-torch-cu128", "ros1-trixie-robot-torch-cu128", "ros1-trixie-perception-torch-cu128", "ros1-trixie-desktop-torch-cu128", "ros1-trixie-desktop-full-torch-cu128", "ros1-trixie-core-run-torch-cu128", "ros1-trixie-base-run-torch-cu128", "ros1-trixie-core-tensorflow-cu128", "ros1-trixie-base-tensorflow-cu128", "ros1-trixie-robot-tensorflow-cu128", "ros1-trixie-perception-tensorflow-cu128", "ros1-trixie-desktop-tensorflow-cu128", "ros1-trixie-desktop-full-tensorflow-cu128", "ros1-trixie-core-run-tensorflow-cu128", "ros1-trixie-base-run-tensorflow-cu128", "ros1-trixie-core-ml-cu128", "ros1-trixie-base-ml-cu128", "ros1-trixie-robot-ml-cu128", "ros1-trixie-perception-ml-cu128", "ros1-trixie-desktop-ml-cu128", "ros1-trixie-desktop-full-ml-cu128", "ros1-trixie-core-run-ml-cu128", "ros1-trixie-base-run-ml-cu128",
    "jazzy-wheels-core-cuda-cu128", "jazzy-wheels-core-torch-cu128", "jazzy-wheels-core-tensorflow-cu128", "jazzy-wheels-core-ml-cu128",
  ]
}

group "cu130" {
  targets = [
    "noetic-core-cuda-cu130", "noetic-base-cuda-cu130", "noetic-robot-cuda-cu130", "noetic-perception-cuda-cu130", "noetic-desktop-cuda-cu130", "noetic-desktop-full-cuda-cu130", "noetic-core-run-cuda-cu130", "noetic-base-run-cuda-cu130",
    "foxy-core-cuda-cu130", "foxy-base-cuda-cu130", "foxy-desktop-cuda-cu130", "foxy-core-run-cuda-cu130", "foxy-base-run-cuda-cu130",
    "humble-core-cuda-cu130", "humble-base-cuda-cu130", "humble-perception-cuda-cu130", "humble-desktop-cuda-cu130", "humble-desktop-full-cuda-cu130", "humble-core-run-cuda-cu130", "humble-base-run-cuda-cu130", "humble-core-torch-cu130", "humble-base-torch-cu130", "humble-perception-torch-cu130", "humble-desktop-torch-cu130", "humble-desktop-full-torch-cu130", "humble-core-run-torch-cu130", "humble-base-run-torch-cu130",
    "iron-core-cuda-cu130", "iron-base-cuda-cu130", "iron-perception-cuda-cu130", "iron-desktop-cuda-cu130", "iron-desktop-full-cuda-cu130", "iron-core-run-cuda-cu130", "iron-base-run-cuda-cu130", "iron-core-torch-cu130", "iron-base-torch-cu130", "iron-perception-torch-cu130", "iron-desktop-torch-cu130", "iron-desktop-full-torch-cu130", "iron-core-run-torch-cu130", "iron-base-run-torch-cu130",
    "jazzy-core-cuda-cu130", "jazzy-base-cuda-cu130", "jazzy-perception-cuda-cu130", "jazzy-desktop-cuda-cu130", "jazzy-desktop-full-cuda-cu130", "jazzy-core-run-cuda-cu130", "jazzy-base-run-cuda-cu130", "jazzy-core-torch-cu130", "jazzy-base-torch-cu130", "jazzy-perception-torch-cu130", "jazzy-desktop-torch-cu130", "jazzy-desktop-full-torch-cu130", "jazzy-core-run-torch-cu130", "jazzy-base-run-torch-cu130",
    "kilted-core-cuda-cu130", "kilted-base-cuda-cu130", "kilted-perception-cuda-cu130", "kilted-desktop-cuda-cu130", "kilted-desktop-full-cuda-cu130", "kilted-core-run-cuda-cu130", "kilted-base-run-cuda-cu130", "kilted-core-torch-cu130", "kilted-base-torch-cu130", "kilted-perception-torch-cu130", "kilted-desktop-torch-cu130", "kilted-desktop-full-torch-cu130", "kilted-core-run-torch-cu130", "kilted-base-run-torch-cu130",
    "lyrical-core-cuda-cu130", "lyrical-base-cuda-cu130", "lyrical-perception-cuda-cu130", "lyrical-desktop-cuda-cu130", "lyrical-desktop-full-cuda-cu130", "lyrical-core-run-cuda-cu130", "lyrical-base-run-cuda-cu130", "lyrical-core-torch-cu130", "lyrical-base-torch-cu130", "lyrical-perception-torch-cu130", "lyrical-desktop-torch-cu130", "lyrical-desktop-full-torch-cu130", "lyrical-core-run-torch-cu130", "lyrical-base-run-torch-cu130",
    "rolling-core-cuda-cu130", "rolling-base-cuda-cu130", "rolling-perception-cuda-cu130", "rolling-desktop-cuda-cu130", "rolling-desktop-full-cuda-cu130", "rolling-core-run-cuda-cu130", "rolling-base-run-cuda-cu130", "rolling-core-torch-cu130", "rolling-base-torch-cu130", "rolling-perception-torch-cu130", "rolling-desktop-torch-cu130", "rolling-desktop-full-torch-cu130", "rolling-core-run-torch-cu130", "rolling-base-run-torch-cu130",
    "ros1-bookworm-core-cuda-cu130", "ros1-bookworm-base-cuda-cu130", "ros1-bookworm-robot-cuda-cu130", "ros1-bookworm-perception-cuda-cu130", "ros1-bookworm-desktop-cuda-cu130", "ros1-bookworm-desktop-full-cuda-cu130", "ros1-bookworm-core-run-cuda-cu130", "ros1-bookworm-base-run-cuda-cu130", "ros1-bookworm-core-torch-cu130", "ros1-bookworm-base-torch-cu130", "ros1-bookworm-robot-torch-cu130", "ros1-bookworm-perception-torch-cu130", "ros1-bookworm-desktop-torch-cu130", "ros1-bookworm-desktop-full-torch-cu130", "ros1-bookworm-core-run-torch-cu130", "ros1-bookworm-base-run-torch-cu130",
    "ros1-trixie-core-cuda-cu130", "ros1-trixie-base-cuda-cu130", "ros1-trixie-robot-cuda-cu130", "ros1-trixie-perception-cuda-cu130", "ros1-trixie-desktop-cuda-cu130", "ros1-trixie-desktop-full-cuda-cu130", "ros1-trixie-core-run-cuda-cu130", "ros1-trixie-base-run-cuda-cu130", "ros1-trixie-core-torch-cu130", "ros1-trixie-base-torch-cu130", "ros1-trixie-robot-torch-cu130", "ros1-trixie-perception-torch-cu130", "ros1-trixie-desktop-torch-cu130", "ros1-trixie-desktop-full-torch-cu130", "ros1-trixie-core-run-torch-cu130", "ros1-trixie-base-run-torch-cu130",
    "jazzy-wheels-core-cuda-cu130", "jazzy-wheels-core-torch-cu130",
  ]
}

group "cu132" {
  targets = [
    "noetic-core-cuda-cu132", "noetic-base-cuda-cu132", "noetic-robot-cuda-cu132", "noetic-perception-cuda-cu132", "noetic-desktop-cuda-cu132", "noetic-desktop-full-cuda-cu132", "noetic-core-run-cuda-cu132", "noetic-base-run-cuda-cu132",
    "foxy-core-cuda-cu132", "foxy-base-cuda-cu132", "foxy-desktop-cuda-cu132", "foxy-core-run-cuda-cu132", "foxy-base-run-cuda-cu132",
    "humble-core-cuda-cu132", "humble-base-cuda-cu132", "humble-perception-cuda-cu132", "humble-desktop-cuda-cu132", "humble-desktop-full-cuda-cu132", "humble-core-run-cuda-cu132", "humble-base-run-cuda-cu132",
    "iron-core-cuda-cu132", "iron-base-cuda-cu132", "iron-perception-cuda-cu132", "iron-desktop-cuda-cu132", "iron-desktop-full-cuda-cu132", "iron-core-run-cuda-cu132", "iron-base-run-cuda-cu132",
    "jazzy-core-cuda-cu132", "jazzy-base-cuda-cu132", "jazzy-perception-cuda-cu132", "jazzy-desktop-cuda-cu132", "jazzy-desktop-full-cuda-cu132", "jazzy-core-run-cuda-cu132", "jazzy-base-run-cuda-cu132", "jazzy-core-torch-cu132", "jazzy-base-torch-cu132", "jazzy-perception-torch-cu132", "jazzy-desktop-torch-cu132", "jazzy-desktop-full-torch-cu132", "jazzy-core-run-torch-cu132", "jazzy-base-run-torch-cu132",
    "kilted-core-cuda-cu132", "kilted-base-cuda-cu132", "kilted-perception-cuda-cu132", "kilted-desktop-cuda-cu132", "kilted-desktop-full-cuda-cu132", "kilted-core-run-cuda-cu132", "kilted-base-run-cuda-cu132", "kilted-core-torch-cu132", "kilted-base-torch-cu132", "kilted-perception-torch-cu132", "kilted-desktop-torch-cu132", "kilted-desktop-full-torch-cu132", "kilted-core-run-torch-cu132", "kilted-base-run-torch-cu132",
    "lyrical-core-cuda-cu132", "lyrical-base-cuda-cu132", "lyrical-perception-cuda-cu132", "lyrical-desktop-cuda-cu132", "lyrical-desktop-full-cuda-cu132", "lyrical-core-run-cuda-cu132", "lyrical-base-run-cuda-cu132", "lyrical-core-torch-cu132", "lyrical-base-torch-cu132", "lyrical-perception-torch-cu132", "lyrical-desktop-torch-cu132", "lyrical-desktop-full-torch-cu132", "lyrical-core-run-torch-cu132", "lyrical-base-run-torch-cu132",
    "rolling-core-cuda-cu132", "rolling-base-cuda-cu132", "rolling-perception-cuda-cu132", "rolling-desktop-cuda-cu132", "rolling-desktop-full-cuda-cu132", "rolling-core-run-cuda-cu132", "rolling-base-run-cuda-cu132", "rolling-core-torch-cu132", "rolling-base-torch-cu132", "rolling-perception-torch-cu132", "rolling-desktop-torch-cu132", "rolling-desktop-full-torch-cu132", "rolling-core-run-torch-cu132", "rolling-base-run-torch-cu132",
    "ros1-bookworm-core-cuda-cu132", "ros1-bookworm-base-cuda-cu132", "ros1-bookworm-robot-cuda-cu132", "ros1-bookworm-perception-cuda-cu132", "ros1-bookworm-desktop-cuda-cu132", "ros1-bookworm-desktop-full-cuda-cu132", "ros1-bookworm-core-run-cuda-cu132", "ros1-bookworm-base-run-cuda-cu132", "ros1-bookworm-core-torch-cu132", "ros1-bookworm-base-torch-cu132", "ros1-bookworm-robot-torch-cu132", "ros1-bookworm-perception-torch-cu132", "ros1-bookworm-desktop-torch-cu132", "ros1-bookworm-desktop-full-torch-cu132", "ros1-bookworm-core-run-torch-cu132", "ros1-bookworm-base-run-torch-cu132",
    "ros1-trixie-core-cuda-cu132", "ros1-trixie-base-cuda-cu132", "ros1-trixie-robot-cuda-cu132", "ros1-trixie-perception-cuda-cu132", "ros1-trixie-desktop-cuda-cu132", "ros1-trixie-desktop-full-cuda-cu132", "ros1-trixie-core-run-cuda-cu132", "ros1-trixie-base-run-cuda-cu132", "ros1-trixie-core-torch-cu132", "ros1-trixie-base-torch-cu132", "ros1-trixie-robot-torch-cu132", "ros1-trixie-perception-torch-cu132", "ros1-trixie-desktop-torch-cu132", "ros1-trixie-desktop-full-torch-cu132", "ros1-trixie-core-run-torch-cu132", "ros1-trixie-base-run-torch-cu132",
    "jazzy-wheels-core-cuda-cu132", "jazzy-wheels-core-torch-cu132",
  ]
}

group "cu121" {
  targets = [
    "noetic-core-cuda-cu121", "noetic-base-cuda-cu121", "noetic-robot-cuda-cu121", "noetic-perception-cuda-cu121", "noetic-desktop-cuda-cu121", "noetic-desktop-full-cuda-cu121", "noetic-core-run-cuda-cu121", "noetic-base-run-cuda-cu121", "noetic-core-torch-cu121", "noetic-base-torch-cu121", "noetic-robot-torch-cu121", "noetic-perception-torch-cu121", "noetic-desktop-torch-cu121", "noetic-desktop-full-torch-cu121", "noetic-core-run-torch-cu121", "noetic-base-run-torch-cu121",
    "foxy-core-cuda-cu121", "foxy-base-cuda-cu121", "foxy-desktop-cuda-cu121", "foxy-core-run-cuda-cu121", "foxy-base-run-cuda-cu121", "foxy-core-torch-cu121", "foxy-base-torch-cu121", "foxy-desktop-torch-cu121", "foxy-core-run-torch-cu121", "foxy-base-run-torch-cu121",
    "humble-core-cuda-cu121", "humble-base-cuda-cu121", "humble-perception-cuda-cu121", "humble-desktop-cuda-cu121", "humble-desktop-full-cuda-cu121", "humble-core-run-cuda-cu121", "humble-base-run-cuda-cu121",
    "iron-core-cuda-cu121", "iron-base-cuda-cu121", "iron-perception-cuda-cu121", "iron-desktop-cuda-cu121", "iron-desktop-full-cuda-cu121", "iron-core-run-cuda-cu121", "iron-base-run-cuda-cu121",
    "jazzy-core-cuda-cu121", "jazzy-base-cuda-cu121", "jazzy-perception-cuda-cu121", "jazzy-desktop-cuda-cu121", "jazzy-desktop-full-cuda-cu121", "jazzy-core-run-cuda-cu121", "jazzy-base-run-cuda-cu121",
    "kilted-core-cuda-cu121", "kilted-base-cuda-cu121", "kilted-perception-cuda-cu121", "kilted-desktop-cuda-cu121", "kilted-desktop-full-cuda-cu121", "kilted-core-run-cuda-cu121", "kilted-base-run-cuda-cu121",
    "lyrical-core-cuda-cu121", "lyrical-base-cuda-cu121", "lyrical-perception-cuda-cu121", "lyrical-desktop-cuda-cu121", "lyrical-desktop-full-cuda-cu121", "lyrical-core-run-cuda-cu121", "lyrical-base-run-cuda-cu121",
    "rolling-core-cuda-cu121", "rolling-base-cuda-cu121", "rolling-perception-cuda-cu121", "rolling-desktop-cuda-cu121", "rolling-desktop-full-cuda-cu121", "rolling-core-run-cuda-cu121", "rolling-base-run-cuda-cu121",
    "ros1-bookworm-core-cuda-cu121", "ros1-bookworm-base-cuda-cu121", "ros1-bookworm-robot-cuda-cu121", "ros1-bookworm-perception-cuda-cu121", "ros1-bookworm-desktop-cuda-cu121", "ros1-bookworm-desktop-full-cuda-cu121", "ros1-bookworm-core-run-cuda-cu121", "ros1-bookworm-base-run-cuda-cu121",
    "ros1-trixie-core-cuda-cu121", "ros1-trixie-base-cuda-cu121", "ros1-trixie-robot-cuda-cu121", "ros1-trixie-perception-cuda-cu121", "ros1-trixie-desktop-cuda-cu121", "ros1-trixie-desktop-full-cuda-cu121", "ros1-trixie-core-run-cuda-cu121", "ros1-trixie-base-run-cuda-cu121",
    "jazzy-wheels-core-cuda-cu121",
  ]
}

group "cpu" {
  targets = [
    "humble-core-torch-cpu", "humble-base-torch-cpu", "humble-perception-torch-cpu", "humble-desktop-torch-cpu", "humble-desktop-full-torch-cpu", "humble-core-run-torch-cpu", "humble-base-run-torch-cpu", "humble-core-tensorflow-cpu", "humble-base-tensorflow-cpu", "humble-perception-tensorflow-cpu", "humble-desktop-tensorflow-cpu", "humble-desktop-full-tensorflow-cpu", "humble-core-run-tensorflow-cpu", "humble-base-run-tensorflow-cpu", "humble-core-ml-cpu", "humble-base-ml-cpu", "humble-perception-ml-cpu", "humble-desktop-ml-cpu", "humble-desktop-full-ml-cpu", "humble-core-run-ml-cpu", "humble-base-run-ml-cpu",
    "iron-core-torch-cpu", "iron-base-torch-cpu", "iron-perception-torch-cpu", "iron-desktop-torch-cpu", "iron-desktop-full-torch-cpu", "iron-core-run-torch-cpu", "iron-base-run-torch-cpu", "iron-core-tensorflow-cpu", "iron-base-tensorflow-cpu", "iron-perception-tensorflow-cpu", "iron-desktop-tensorflow-cpu", "iron-desktop-full-tensorflow-cpu", "iron-core-run-tensorflow-cpu", "iron-base-run-tensorflow-cpu", "iron-core-ml-cpu", "iron-base-ml-cpu", "iron-perception-ml-cpu", "iron-desktop-ml-cpu", "iron-desktop-full-ml-cpu", "iron-core-run-ml-cpu", "iron-base-run-ml-cpu",
    "jazzy-core-torch-cpu", "jazzy-base-torch-cpu", "jazzy-perception-torch-cpu", "jazzy-desktop-torch-cpu", "jazzy-desktop-full-torch-cpu", "jazzy-core-run-torch-cpu", "jazzy-base-run-torch-cpu", "jazzy-core-tensorflow-cpu", "jazzy-base-tensorflow-cpu", "jazzy-perception-tensorflow-cpu", "jazzy-desktop-tensorflow-cpu", "jazzy-desktop-full-tensorflow-cpu", "jazzy-core-run-tensorflow-cpu", "jazzy-base-run-tensorflow-cpu", "jazzy-core-ml-cpu", "jazzy-base-ml-cpu", "jazzy-perception-ml-cpu", "jazzy-desktop-ml-cpu", "jazzy-desktop-full-ml-cpu", "jazzy-core-run-ml-cpu", "jazzy-base-run-ml-cpu",
    "kilted-core-torch-cpu", "kilted-base-torch-cpu", "kilted-perception-torch-cpu", "kilted-desktop-torch-cpu", "kilted-desktop-full-torch-cpu", "kilted-core-run-torch-cpu", "kilted-base-run-torch-cpu", "kilted-core-tensorflow-cpu", "kilted-base-tensorflow-cpu", "kilted-perception-tensorflow-cpu", "kilted-desktop-tensorflow-cpu", "kilted-desktop-full-tensorflow-cpu", "kilted-core-run-tensorflow-cpu", "kilted-base-run-tensorflow-cpu", "kilted-core-ml-cpu", "kilted-base-ml-cpu", "kilted-perception-ml-cpu", "kilted-desktop-ml-cpu", "kilted-desktop-full-ml-cpu", "kilted-core-run-ml-cpu", "kilted-base-run-ml-cpu",
    "ros1-bookworm-core-tensorflow-cpu", "ros1-bookworm-base-tensorflow-cpu", "ros1-bookworm-robot-tensorflow-cpu", "ros1-bookworm-perception-tensorflow-cpu", "ros1-bookworm-desktop-tensorflow-cpu", "ros1-bookworm-desktop-full-tensorflow-cpu", "ros1-bookworm-core-run-tensorflow-cpu", "ros1-bookworm-base-run-tensorflow-cpu",
    "ros1-trixie-core-torch-cpu", "ros1-trixie-base-torch-cpu", "ros1-trixie-robot-torch-cpu", "ros1-trixie-perception-torch-cpu", "ros1-trixie-desktop-torch-cpu", "ros1-trixie-desktop-full-torch-cpu", "ros1-trixie-core-run-torch-cpu", "ros1-trixie-base-run-torch-cpu", "ros1-trixie-core-tensorflow-cpu", "ros1-trixie-base-tensorflow-cpu", "ros1-trixie-robot-tensorflow-cpu", "ros1-trixie-perception-tensorflow-cpu", "ros1-trixie-desktop-tensorflow-cpu", "ros1-trixie-desktop-full-tensorflow-cpu", "ros1-trixie-core-run-tensorflow-cpu", "ros1-trixie-base-run-tensorflow-cpu", "ros1-trixie-core-ml-cpu", "ros1-trixie-base-ml-cpu", "ros1-trixie-robot-ml-cpu", "ros1-trixie-perception-ml-cpu", "ros1-trixie-desktop-ml-cpu", "ros1-trixie-desktop-full-ml-cpu", "ros1-trixie-core-run-ml-cpu", "ros1-trixie-base-run-ml-cpu",
    "jazzy-wheels-core-tensorflow-cpu",
  ]
}

group "cpu38" {
  targets = [
    "noetic-core-tensorflow-cpu38", "noetic-base-tensorflow-cpu38", "noetic-robot-tensorflow-cpu38", "noetic-perception-tensorflow-cpu38", "noetic-desktop-tensorflow-cpu38", "noetic-desktop-full-tensorflow-cpu38", "noetic-core-run-tensorflow-cpu38", "noetic-base-run-tensorflow-cpu38",
    "foxy-core-tensorflow-cpu38", "foxy-base-tensorflow-cpu38", "foxy-desktop-tensorflow-cpu38", "foxy-core-run-tensorflow-cpu38", "foxy-base-run-tensorflow-cpu38",
  ]
}

group "all" {
  targets = [
    "noetic-core", "noetic-base", "noetic-robot", "noetic-perception", "noetic-desktop", "noetic-desktop-full", "noetic-core-run", "noetic-base-run", "noetic-core-cuda-cu128", "noetic-base-cuda-cu128", "noetic-robot-cuda-cu128", "noetic-perception-cuda-cu128", "noetic-desktop-cuda-cu128", "noetic-desktop-full-cuda-cu128", "noetic-core-run-cuda-cu128", "noetic-base-run-cuda-cu128", "noetic-core-cuda-cu130", "noetic-base-cuda-cu130", "noetic-robot-cuda-cu130", "noetic-perception-cuda-cu130", "noetic-desktop-cuda-cu130", "noetic-desktop-full-cuda-cu130", "noetic-core-run-cuda-cu130", "noetic-base-run-cuda-cu130", "noetic-core-cuda-cu132", "noetic-base-cuda-cu132", "noetic-robot-cuda-cu132", "noetic-perception-cuda-cu132", "noetic-desktop-cuda-cu132", "noetic-desktop-full-cuda-cu132", "noetic-core-run-cuda-cu132", "noetic-base-run-cuda-cu132", "noetic-core-cuda-cu121", "noetic-base-cuda-cu121", "noetic-robot-cuda-cu121", "noetic-perception-cuda-cu121", "noetic-desktop-cuda-cu121", "noetic-desktop-full-cuda-cu121", "noetic-core-run-cuda-cu121", "noetic-base-run-cuda-cu121", "noetic-core-torch-cu121", "noetic-base-torch-cu121", "noetic-robot-torch-cu121", "noetic-perception-torch-cu121", "noetic-desktop-torch-cu121", "noetic-desktop-full-torch-cu121", "noetic-core-run-torch-cu121", "noetic-base-run-torch-cu121", "noetic-core-tensorflow-cpu38", "noetic-base-tensorflow-cpu38", "noetic-robot-tensorflow-cpu38", "noetic-perception-tensorflow-cpu38", "noetic-desktop-tensorflow-cpu38", "noetic-desktop-full-tensorflow-cpu38", "noetic-core-run-tensorflow-cpu38", "noetic-base-run-tensorflow-cpu38",
    "foxy-core", "foxy-base", "foxy-desktop", "foxy-core-run", "foxy-base-run", "foxy-core-cuda-cu128", "foxy-base-cuda-cu128", "foxy-desktop-cuda-cu128", "foxy-core-run-cuda-cu128", "foxy-base-run-cuda-cu128", "foxy-core-cuda-cu130", "foxy-base-cuda-cu130", "foxy-desktop-cuda-cu130", "foxy-core-run-cuda-cu130", "foxy-base-run-cuda-cu130", "foxy-core-cuda-cu132", "foxy-base-cuda-cu132", "foxy-desktop-cuda-cu132", "foxy-core-run-cuda-cu132", "foxy-base-run-cuda-cu132", "foxy-core-cuda-cu121", "foxy-base-cuda-cu121", "foxy-desktop-cuda-cu121", "foxy-core-run-cuda-cu121", "foxy-base-run-cuda-cu121", "foxy-core-torch-cu121", "foxy-base-torch-cu121", "foxy-desktop-torch-cu121", "foxy-core-run-torch-cu121", "foxy-base-run-torch-cu121", "foxy-core-tensorflow-cpu38", "foxy-base-tensorflow-cpu38", "foxy-desktop-tensorflow-cpu38", "foxy-core-run-tensorflow-cpu38", "foxy-base-run-tensorflow-cpu38",
    "humble-core", "humble-base", "humble-perception", "humble-desktop", "humble-desktop-full", "humble-core-run", "humble-base-run", "humble-core-cuda-cu128", "humble-base-cuda-cu128", "humble-perception-cuda-cu128", "humble-desktop-cuda-cu128", "humble-desktop-full-cuda-cu128", "humble-core-run-cuda-cu128", "humble-base-run-cuda-cu128", "humble-core-cuda-cu130", "humble-base-cuda-cu130", "humble-perception-cuda-cu130", "humble-desktop-cuda-cu130", "humble-desktop-full-cuda-cu130", "humble-core-run-cuda-cu130", "humble-base-run-cuda-cu130", "humble-core-cuda-cu132", "humble-base-cuda-cu132", "humble-perception-cuda-cu132", "humble-desktop-cuda-cu132", "humble-desktop-full-cuda-cu132", "humble-core-run-cuda-cu132", "humble-base-run-cuda-cu132", "humble-core-cuda-cu121", "humble-base-cuda-cu121", "humble-perception-cuda-cu121", "humble-desktop-cuda-cu121", "humble-desktop-full-cuda-cu121", "humble-core-run-cuda-cu121", "humble-base-run-cuda-cu121", "humble-core-torch-cu128", "humble-base-torch-cu128", "humble-perception-torch-cu128", "humble-desktop-torch-cu128", "humble-desktop-full-torch-cu128", "humble-core-run-torch-cu128", "humble-base-run-torch-cu128", "humble-core-torch-cu130", "humble-base-torch-cu130", "humble-perception-torch-cu130", "humble-desktop-torch-cu130", "humble-desktop-full-torch-cu130", "humble-core-run-torch-cu130", "humble-base-run-torch-cu130", "humble-core-torch-cpu", "humble-base-torch-cpu", "humble-perception-torch-cpu", "humble-desktop-torch-cpu", "humble-desktop-full-torch-cpu", "humble-core-run-torch-cpu", "humble-base-run-torch-cpu", "humble-core-tensorflow-cu128", "humble-base-tensorflow-cu128", "humble-perception-tensorflow-cu128", "humble-desktop-tensorflow-cu128", "humble-desktop-full-tensorflow-cu128", "humble-core-run-tensorflow-cu128", "humble-base-run-tensorflow-cu128", "humble-core-tensorflow-cpu", "humble-base-tensorflow-cpu", "humble-perception-tensorflow-cpu", "humble-desktop-tensorflow-cpu", "humble-desktop-full-tensorflow-cpu", "humble-core-run-tensorflow-cpu", "humble-base-run-tensorflow-cpu", "humble-core-ml-cu128", "humble-base-ml-cu128", "humble-perception-ml-cu128", "humble-desktop-ml-cu128", "humble-desktop-full-ml-cu128", "humble-core-run-ml-cu128", "humble-base-run-ml-cu128", "humble-core-ml-cpu", "humble-base-ml-cpu", "humble-perception-ml-cpu", "humble-desktop-ml-cpu", "humble-desktop-full-ml-cpu", "humble-core-run-ml-cpu", "humble-base-run-ml-cpu",
    "iron-core", "iron-base", "iron-perception", "iron-desktop", "iron-desktop-full", "iron-core-run", "iron-base-run", "iron-core-cuda-cu128", "iron-base-cuda-cu128", "iron-perception-cuda-cu128", "iron-desktop-cuda-cu128", "iron-desktop-full-cuda-cu128", "iron-core-run-cuda-cu128", "iron-base-run-cuda-cu128", "iron-core-cuda-cu130", "iron-base-cuda-cu130", "iron-perception-cuda-cu130", "iron-desktop-cuda-cu130", "iron-desktop-full-cuda-cu130", "iron-core-run-cuda-cu130", "iron-base-run-cuda-cu130", "iron-core-cuda-cu132", "iron-base-cuda-cu132", "iron-perception-cuda-cu132", "iron-desktop-cuda-cu132", "iron-desktop-full-cuda-cu132", "iron-core-run-cuda-cu132", "iron-base-run-cuda-cu132", "iron-core-cuda-cu121", "iron-base-cuda-cu121", "iron-perception-cuda-cu121", "iron-desktop-cuda-cu121", "iron-desktop-full-cuda-cu121", "iron-core-run-cuda-cu121", "iron-base-run-cuda-cu121", "iron-core-torch-cu128", "iron-base-torch-cu128", "iron-perception-torch-cu128", "iron-desktop-torch-cu128", "iron-desktop-full-torch-cu128", "iron-core-run-torch-cu128", "iron-base-run-torch-cu128", "iron-core-torch-cu130", "iron-base-torch-cu130", "iron-perception-torch-cu130", "iron-desktop-torch-cu130", "iron-desktop-full-torch-cu130", "iron-core-run-torch-cu130", "iron-base-run-torch-cu130", "iron-core-torch-cpu", "iron-base-torch-cpu", "iron-perception-torch-cpu", "iron-desktop-torch-cpu", "iron-desktop-full-torch-cpu", "iron-core-run-torch-cpu", "iron-base-run-torch-cpu", "iron-core-tensorflow-cu128", "iron-base-tensorflow-cu128", "iron-perception-tensorflow-cu128", "iron-desktop-tensorflow-cu128", "iron-desktop-full-tensorflow-cu128", "iron-core-run-tensorflow-cu128", "iron-base-run-tensorflow-cu128", "iron-core-tensorflow-cpu", "iron-base-tensorflow-cpu", "iron-perception-tensorflow-cpu", "iron-desktop-tensorflow-cpu", "iron-desktop-full-tensorflow-cpu", "iron-core-run-tensorflow-cpu", "iron-base-run-tensorflow-cpu", "iron-core-ml-cu128", "iron-base-ml-cu128", "iron-perception-ml-cu128", "iron-desktop-ml-cu128", "iron-desktop-full-ml-cu128", "iron-core-run-ml-cu128", "iron-base-run-ml-cu128", "iron-core-ml-cpu", "iron-base-ml-cpu", "iron-perception-ml-cpu", "iron-desktop-ml-cpu", "iron-desktop-full-ml-cpu", "iron-core-run-ml-cpu", "iron-base-run-ml-cpu",
    "jazzy-core", "jazzy-base", "jazzy-perception", "jazzy-desktop", "jazzy-desktop-full", "jazzy-core-run", "jazzy-base-run", "jazzy-core-cuda-cu128", "jazzy-base-cuda-cu128", "jazzy-perception-cuda-cu128", "jazzy-desktop-cuda-cu128", "jazzy-desktop-full-cuda-cu128", "jazzy-core-run-cuda-cu128", "jazzy-base-run-cuda-cu128", "jazzy-core-cuda-cu130", "jazzy-base-cuda-cu130", "jazzy-perception-cuda-cu130", "jazzy-desktop-cuda-cu130", "jazzy-desktop-full-cuda-cu130", "jazzy-core-run-cuda-cu130", "jazzy-base-run-cuda-cu130", "jazzy-core-cuda-cu132", "jazzy-base-cuda-cu132", "jazzy-perception-cuda-cu132", "jazzy-desktop-cuda-cu132", "jazzy-desktop-full-cuda-cu132", "jazzy-core-run-cuda-cu132", "jazzy-base-run-cuda-cu132", "jazzy-core-cuda-cu121", "jazzy-base-cuda-cu121", "jazzy-perception-cuda-cu121", "jazzy-desktop-cuda-cu121", "jazzy-desktop-full-cuda-cu121", "jazzy-core-run-cuda-cu121", "jazzy-base-run-cuda-cu121", "jazzy-core-torch-cu128", "jazzy-base-torch-cu128", "jazzy-perception-torch-cu128", "jazzy-desktop-torch-cu128", "jazzy-desktop-full-torch-cu128", "jazzy-core-run-torch-cu128", "jazzy-base-run-torch-cu128", "jazzy-core-torch-cu130", "jazzy-base-torch-cu130", "jazzy-perception-torch-cu130", "jazzy-desktop-torch-cu130", "jazzy-desktop-full-torch-cu130", "jazzy-core-run-torch-cu130", "jazzy-base-run-torch-cu130", "jazzy-core-torch-cu132", "jazzy-base-torch-cu132", "jazzy-perception-torch-cu132", "jazzy-desktop-torch-cu132", "jazzy-desktop-full-torch-cu132", "jazzy-core-run-torch-cu132", "jazzy-base-run-torch-cu132", "jazzy-core-torch-cpu", "jazzy-base-torch-cpu", "jazzy-perception-torch-cpu", "jazzy-desktop-torch-cpu", "jazzy-desktop-full-torch-cpu", "jazzy-core-run-torch-cpu", "jazzy-base-run-torch-cpu", "jazzy-core-tensorflow-cu128", "jazzy-base-tensorflow-cu128", "jazzy-perception-tensorflow-cu128", "jazzy-desktop-tensorflow-cu128", "jazzy-desktop-full-tensorflow-cu128", "jazzy-core-run-tensorflow-cu128", "jazzy-base-run-tensorflow-cu128", "jazzy-core-tensorflow-cpu", "jazzy-base-tensorflow-cpu", "jazzy-perception-tensorflow-cpu", "jazzy-desktop-tensorflow-cpu", "jazzy-desktop-full-tensorflow-cpu", "jazzy-core-run-tensorflow-cpu", "jazzy-base-run-tensorflow-cpu", "jazzy-core-ml-cu128", "jazzy-base-ml-cu128", "jazzy-perception-ml-cu128", "jazzy-desktop-ml-cu128", "jazzy-desktop-full-ml-cu128", "jazzy-core-run-ml-cu128", "jazzy-base-run-ml-cu128", "jazzy-core-ml-cpu", "jazzy-base-ml-cpu", "jazzy-perception-ml-cpu", "jazzy-desktop-ml-cpu", "jazzy-desktop-full-ml-cpu", "jazzy-core-run-ml-cpu", "jazzy-base-run-ml-cpu",
    "kilted-core", "kilted-base", "kilted-perception", "kilted-desktop", "kilted-desktop-full", "kilted-core-run", "kilted-base-run", "kilted-core-cuda-cu128", "kilted-base-cuda-cu128", "kilted-perception-cuda-cu128", "kilted-desktop-cuda-cu128", "kilted-desktop-full-cuda-cu128", "kilted-core-run-cuda-cu128", "kilted-base-run-cuda-cu128", "kilted-core-cuda-cu130", "kilted-base-cuda-cu130", "kilted-perception-cuda-cu130", "kilted-desktop-cuda-cu130", "kilted-desktop-full-cuda-cu130", "kilted-core-run-cuda-cu130", "kilted-base-run-cuda-cu130", "kilted-core-cuda-cu132", "kilted-base-cuda-cu132", "kilted-perception-cuda-cu132", "kilted-desktop-cuda-cu132", "kilted-desktop-full-cuda-cu132", "kilted-core-run-cuda-cu132", "kilted-base-run-cuda-cu132", "kilted-core-cuda-cu121", "kilted-base-cuda-cu121", "kilted-perception-cuda-cu121", "kilted-desktop-cuda-cu121", "kilted-desktop-full-cuda-cu121", "kilted-core-run-cuda-cu121", "kilted-base-run-cuda-cu121", "kilted-core-torch-cu128", "kilted-base-torch-cu128", "kilted-perception-torch-cu128", "kilted-desktop-torch-cu128", "kilted-desktop-full-torch-cu128", "kilted-core-run-torch-cu128", "kilted-base-run-torch-cu128", "kilted-core-torch-cu130", "kilted-base-torch-cu130", "kilted-perception-torch-cu130", "kilted-desktop-torch-cu130", "kilted-desktop-full-torch-cu130", "kilted-core-run-torch-cu130", "kilted-base-run-torch-cu130", "kilted-core-torch-cu132", "kilted-base-torch-cu132", "kilted-perception-torch-cu132", "kilted-desktop-torch-cu132", "kilted-desktop-full-torch-cu132", "kilted-core-run-torch-cu132", "kilted-base-run-torch-cu132", "kilted-core-torch-cpu", "kilted-base-torch-cpu", "kilted-perception-torch-cpu", "kilted-desktop-torch-cpu", "kilted-desktop-full-torch-cpu", "kilted-core-run-torch-cpu", "kilted-base-run-torch-cpu", "kilted-core-tensorflow-cu128", "kilted-base-tensorflow-cu128", "kilted-perception-tensorflow-cu128", "kilted-desktop-tensorflow-cu128", "kilted-desktop-full-tensorflow-cu128", "kilted-core-run-tensorflow-cu128", "kilted-base-run-tensorflow-cu128", "kilted-core-tensorflow-cpu", "kilted-base-tensorflow-cpu", "kilted-perception-tensorflow-cpu", "kilted-desktop-tensorflow-cpu", "kilted-desktop-full-tensorflow-cpu", "kilted-core-run-tensorflow-cpu", "kilted-base-run-tensorflow-cpu", "kilted-core-ml-cu128", "kilted-base-ml-cu128", "kilted-perception-ml-cu128", "kilted-desktop-ml-cu128", "kilted-desktop-full-ml-cu128", "kilted-core-run-ml-cu128", "kilted-base-run-ml-cu128", "kilted-core-ml-cpu", "kilted-base-ml-cpu", "kilted-perception-ml-cpu", "kilted-desktop-ml-cpu", "kilted-desktop-full-ml-cpu", "kilted-core-run-ml-cpu", "kilted-base-run-ml-cpu",
    "lyrical-core", "lyrical-base", "lyrical-perception", "lyrical-desktop", "lyrical-desktop-full", "lyrical-core-run", "lyrical-base-run", "lyrical-core-cuda-cu128", "lyrical-base-cuda-cu128", "lyrical-perception-cuda-cu128", "lyrical-desktop-cuda-cu128", "lyrical-desktop-full-cuda-cu128", "lyrical-core-run-cuda-cu128", "lyrical-base-run-cuda-cu128", "lyrical-core-cuda-cu130", "lyrical-base-cuda-cu130", "lyrical-perception-cuda-cu130", "lyrical-desktop-cuda-cu130", "lyrical-desktop-full-cuda-cu130", "lyrical-core-run-cuda-cu130", "lyrical-base-run-cuda-cu130", "lyrical-core-cuda-cu132", "lyrical-base-cuda-cu132", "lyrical-perception-cuda-cu132", "lyrical-desktop-cuda-cu132", "lyrical-desktop-full-cuda-cu132", "lyrical-core-run-cuda-cu132", "lyrical-base-run-cuda-cu132", "lyrical-core-cuda-cu121", "lyrical-base-cuda-cu121", "lyrical-perception-cuda-cu121", "lyrical-desktop-cuda-cu121", "lyrical-desktop-full-cuda-cu121", "lyrical-core-run-cuda-cu121", "lyrical-base-run-cuda-cu121", "lyrical-core-torch-cu128", "lyrical-base-torch-cu128", "lyrical-perception-torch-cu128", "lyrical-desktop-torch-cu128", "lyrical-desktop-full-torch-cu128", "lyrical-core-run-torch-cu128", "lyrical-base-run-torch-cu128", "lyrical-core-torch-cu130", "lyrical-base-torch-cu130", "lyrical-perception-torch-cu130", "lyrical-desktop-torch-cu130", "lyrical-desktop-full-torch-cu130", "lyrical-core-run-torch-cu130", "lyrical-base-run-torch-cu130", "lyrical-core-torch-cu132", "lyrical-base-torch-cu132", "lyrical-perception-torch-cu132", "lyrical-desktop-torch-cu132", "lyrical-desktop-full-torch-cu132", "lyrical-core-run-torch-cu132", "lyrical-base-run-torch-cu132",
    "rolling-core", "rolling-base", "rolling-perception", "rolling-desktop", "rolling-desktop-full", "rolling-core-run", "rolling-base-run", "rolling-core-cuda-cu128", "rolling-base-cuda-cu128", "rolling-perception-cuda-cu128", "rolling-desktop-cuda-cu128", "rolling-desktop-full-cuda-cu128", "rolling-core-run-cuda-cu128", "rolling-base-run-cuda-cu128", "rolling-core-cuda-cu130", "rolling-base-cuda-cu130", "rolling-perception-cuda-cu130", "rolling-desktop-cuda-cu130", "rolling-desktop-full-cuda-cu130", "rolling-core-run-cuda-cu130", "rolling-base-run-cuda-cu130", "rolling-core-cuda-cu132", "rolling-base-cuda-cu132", "rolling-perception-cuda-cu132", "rolling-desktop-cuda-cu132", "rolling-desktop-full-cuda-cu132", "rolling-core-run-cuda-cu132", "rolling-base-run-cuda-cu132", "rolling-core-cuda-cu121", "rolling-base-cuda-cu121", "rolling-perception-cuda-cu121", "rolling-desktop-cuda-cu121", "rolling-desktop-full-cuda-cu121", "rolling-core-run-cuda-cu121", "rolling-base-run-cuda-cu121", "rolling-core-torch-cu128", "rolling-base-torch-cu128", "rolling-perception-torch-cu128", "rolling-desktop-torch-cu128", "rolling-desktop-full-torch-cu128", "rolling-core-run-torch-cu128", "rolling-base-run-torch-cu128", "rolling-core-torch-cu130", "rolling-base-torch-cu130", "rolling-perception-torch-cu130", "rolling-desktop-torch-cu130", "rolling-desktop-full-torch-cu130", "rolling-core-run-torch-cu130", "rolling-base-run-torch-cu130", "rolling-core-torch-cu132", "rolling-base-torch-cu132", "rolling-perception-torch-cu132", "rolling-desktop-torch-cu132", "rolling-desktop-full-torch-cu132", "rolling-core-run-torch-cu132", "rolling-base-run-torch-cu132",
    "ros1-bookworm-core", "ros1-bookworm-base", "ros1-bookworm-robot", "ros1-bookworm-perception", "ros1-bookworm-desktop", "ros1-bookworm-desktop-full", "ros1-bookworm-core-run", "ros1-bookworm-base-run", "ros1-bookworm-core-cuda-cu128", "ros1-bookworm-base-cuda-cu128", "ros1-bookworm-robot-cuda-cu128", "ros1-bookworm-perception-cuda-cu128", "ros1-bookworm-desktop-cuda-cu128", "ros1-bookworm-desktop-full-cuda-cu128", "ros1-bookworm-core-run-cuda-cu128", "ros1-bookworm-base-run-cuda-cu128", "ros1-bookworm-core-cuda-cu130", "ros1-bookworm-base-cuda-cu130", "ros1-bookworm-robot-cuda-cu130", "ros1-bookworm-perception-cuda-cu130", "ros1-bookworm-desktop-cuda-cu130", "ros1-bookworm-desktop-full-cuda-cu130", "ros1-bookworm-core-run-cuda-cu130", "ros1-bookworm-base-run-cuda-cu130", "ros1-bookworm-core-cuda-cu132", "ros1-bookworm-base-cuda-cu132", "ros1-bookworm-robot-cuda-cu132", "ros1-bookworm-perception-cuda-cu132", "ros1-bookworm-desktop-cuda-cu132", "ros1-bookworm-desktop-full-cuda-cu132", "ros1-bookworm-core-run-cuda-cu132", "ros1-bookworm-base-run-cuda-cu132", "ros1-bookworm-core-cuda-cu121", "ros1-bookworm-base-cuda-cu121", "ros1-bookworm-robot-cuda-cu121", "ros1-bookworm-perception-cuda-cu121", "ros1-bookworm-desktop-cuda-cu121", "ros1-bookworm-desktop-full-cuda-cu121", "ros1-bookworm-core-run-cuda-cu121", "ros1-bookworm-base-run-cuda-cu121", "ros1-bookworm-core-torch-cu128", "ros1-bookworm-base-torch-cu128", "ros1-bookworm-robot-torch-cu128", "ros1-bookworm-perception-torch-cu128", "ros1-bookworm-desktop-torch-cu128", "ros1-bookworm-desktop-full-torch-cu128", "ros1-bookworm-core-run-torch-cu128", "ros1-bookworm-base-run-torch-cu128", "ros1-bookworm-core-torch-cu130", "ros1-bookworm-base-torch-cu130", "ros1-bookworm-robot-torch-cu130", "ros1-bookworm-perception-torch-cu130", "ros1-bookworm-desktop-torch-cu130", "ros1-bookworm-desktop-full-torch-cu130", "ros1-bookworm-core-run-torch-cu130", "ros1-bookworm-base-run-torch-cu130", "ros1-bookworm-core-torch-cu132", "ros1-bookworm-base-torch-cu132", "ros1-bookworm-robot-torch-cu132", "ros1-bookworm-perception-torch-cu132", "ros1-bookworm-desktop-torch-cu132", "ros1-bookworm-desktop-full-torch-cu132", "ros1-bookworm-core-run-torch-cu132", "ros1-bookworm-base-run-torch-cu132", "ros1-bookworm-core-tensorflow-cu128", "ros1-bookworm-base-tensorflow-cu128", "ros1-bookworm-robot-tensorflow-cu128", "ros1-bookworm-perception-tensorflow-cu128", "ros1-bookworm-desktop-tensorflow-cu128", "ros1-bookworm-desktop-full-tensorflow-cu128", "ros1-bookworm-core-run-tensorflow-cu128", "ros1-bookworm-base-run-tensorflow-cu128", "ros1-bookworm-core-tensorflow-cpu", "ros1-bookworm-base-tensorflow-cpu", "ros1-bookworm-robot-tensorflow-cpu", "ros1-bookworm-perception-tensorflow-cpu", "ros1-bookworm-desktop-tensorflow-cpu", "ros1-bookworm-desktop-full-tensorflow-cpu", "ros1-bookworm-core-run-tensorflow-cpu", "ros1-bookworm-base-run-tensorflow-cpu", "ros1-bookworm-core-ml-cu128", "ros1-bookworm-base-ml-cu128", "ros1-bookworm-robot-ml-cu128", "ros1-bookworm-perception-ml-cu128", "ros1-bookworm-desktop-ml-cu128", "ros1-bookworm-desktop-full-ml-cu128", "ros1-bookworm-core-run-ml-cu128", "ros1-bookworm-base-run-ml-cu128",
    "ros1-trixie-core", "ros1-trixie-base", "ros1-trixie-robot", "ros1-trixie-perception", "ros1-trixie-desktop", "ros1-trixie-desktop-full", "ros1-trixie-core-run", "ros1-trixie-base-run", "ros1-trixie-core-cuda-cu128", "ros1-trixie-base-cuda-cu128", "ros1-trixie-robot-cuda-cu128", "ros1-trixie-perception-cuda-cu128", "ros1-trixie-desktop-cuda-cu128", "ros1-trixie-desktop-full-cuda-cu128", "ros1-trixie-core-run-cuda-cu128", "ros1-trixie-base-run-cuda-cu128", "ros1-trixie-core-cuda-cu130", "ros1-trixie-base-cuda-cu130", "ros1-trixie-robot-cuda-cu130", "ros1-trixie-perception-cuda-cu130", "ros1-trixie-desktop-cuda-cu130", "ros1-trixie-desktop-full-cuda-cu130", "ros1-trixie-core-run-cuda-cu130", "ros1-trixie-base-run-cuda-cu130", "ros1-trixie-core-cuda-cu132", "ros1-trixie-base-cuda-cu132", "ros1-trixie-robot-cuda-cu132", "ros1-trixie-perception-cuda-cu132", "ros1-trixie-desktop-cuda-cu132", "ros1-trixie-desktop-full-cuda-cu132", "ros1-trixie-core-run-cuda-cu132", "ros1-trixie-base-run-cuda-cu132", "ros1-trixie-core-cuda-cu121", "ros1-trixie-base-cuda-cu121", "ros1-trixie-robot-cuda-cu121", "ros1-trixie-perception-cuda-cu121", "ros1-trixie-desktop-cuda-cu121", "ros1-trixie-desktop-full-cuda-cu121", "ros1-trixie-core-run-cuda-cu121", "ros1-trixie-base-run-cuda-cu121", "ros1-trixie-core-torch-cu128", "ros1-trixie-base-torch-cu128", "ros1-trixie-robot-torch-cu128", "ros1-trixie-perception-torch-cu128", "ros1-trixie-desktop-torch-cu128", "ros1-trixie-desktop-full-torch-cu128", "ros1-trixie-core-run-torch-cu128", "ros1-trixie-base-run-torch-cu128", "ros1-trixie-core-torch-cu130", "ros1-trixie-base-torch-cu130", "ros1-trixie-robot-torch-cu130", "ros1-trixie-perception-torch-cu130", "ros1-trixie-desktop-torch-cu130", "ros1-trixie-desktop-full-torch-cu130", "ros1-trixie-core-run-torch-cu130", "ros1-trixie-base-run-torch-cu130", "ros1-trixie-core-torch-cu132", "ros1-trixie-base-torch-cu132", "ros1-trixie-robot-torch-cu132", "ros1-trixie-perception-torch-cu132", "ros1-trixie-desktop-torch-cu132", "ros1-trixie-desktop-full-torch-cu132", "ros1-trixie-core-run-torch-cu132", "ros1-trixie-base-run-torch-cu132", "ros1-trixie-core-torch-cpu", "ros1-trixie-base-torch-cpu", "ros1-trixie-robot-torch-cpu", "ros1-trixie-perception-torch-cpu", "ros1-trixie-desktop-torch-cpu", "ros1-trixie-desktop-full-torch-cpu", "ros1-trixie-core-run-torch-cpu", "ros1-trixie-base-run-torch-cpu", "ros1-trixie-core-tensorflow-cu128", "ros1-trixie-base-tensorflow-cu128", "ros1-trixie-robot-tensorflow-cu128", "ros1-trixie-perception-tensorflow-cu128", "ros1-trixie-desktop-tensorflow-cu128", "ros1-trixie-desktop-full-tensorflow-cu128", "ros1-trixie-core-run-tensorflow-cu128", "ros1-trixie-base-run-tensorflow-cu128", "ros1-trixie-core-tensorflow-cpu", "ros1-trixie-base-tensorflow-cpu", "ros1-trixie-robot-tensorflow-cpu", "ros1-trixie-perception-tensorflow-cpu", "ros1-trixie-desktop-tensorflow-cpu", "ros1-trixie-desktop-full-tensorflow-cpu", "ros1-trixie-core-run-tensorflow-cpu", "ros1-trixie-base-run-tensorflow-cpu", "ros1-trixie-core-ml-cu128", "ros1-trixie-base-ml-cu128", "ros1-trixie-robot-ml-cu128", "ros1-trixie-perception-ml-cu128", "ros1-trixie-desktop-ml-cu128", "ros1-trixie-desktop-full-ml-cu128", "ros1-trixie-core-run-ml-cu128", "ros1-trixie-base-run-ml-cu128", "ros1-trixie-core-ml-cpu", "ros1-trixie-base-ml-cpu", "ros1-trixie-robot-ml-cpu", "ros1-trixie-perception-ml-cpu", "ros1-trixie-desktop-ml-cpu", "ros1-trixie-desktop-full-ml-cpu", "ros1-trixie-core-run-ml-cpu", "ros1-trixie-base-run-ml-cpu",
    "jazzy-wheels-core", "jazzy-wheels-core-cuda-cu128", "jazzy-wheels-core-cuda-cu130", "jazzy-wheels-core-cuda-cu132", "jazzy-wheels-core-cuda-cu121", "jazzy-wheels-core-torch-cu128", "jazzy-wheels-core-torch-cu130", "jazzy-wheels-core-torch-cu132", "jazzy-wheels-core-tensorflow-cu128", "jazzy-wheels-core-tensorflow-cpu", "jazzy-wheels-core-ml-cu128",
  ]
}

group "parts" {
  targets = [
    "part-cuda-cu128", "part-cuda-cu130", "part-cuda-cu132", "part-cuda-cu121", "part-common-cu121-py38", "part-torch-cu121-py38", "part-common-cpu38-py38", "part-grpc-cpu38-py38", "part-tensorflow-cc-cpu38", "part-tensorflow-cpu38-py38", "part-common-cu128-py310", "part-torch-cu128-py310", "part-grpc-cu128-py310", "part-tensorflow-cc-cu128", "part-tensorflow-cu128-py310", "part-tritonclient-cu128-py310", "part-common-cu130-py310", "part-torch-cu130-py310", "part-grpc-cu130-py310", "part-tritonclient-cu130-py310", "part-tensorrt-rtx-cc-cu130", "part-tensorrt-rtx-cu130-py310", "part-common-cu132-py310", "part-grpc-cu132-py310", "part-tritonclient-cu132-py310", "part-tensorrt-rtx-cc-cu132", "part-tensorrt-rtx-cu132-py310", "part-common-cpu-py310", "part-torch-cpu-py310", "part-grpc-cpu-py310", "part-tensorflow-cc-cpu", "part-tensorflow-cpu-py310", "part-tritonclient-cpu-py310", "part-common-cu128-py312", "part-torch-cu128-py312", "part-grpc-cu128-py312", "part-tensorflow-cu128-py312", "part-tritonclient-cu128-py312", "part-common-cu130-py312", "part-torch-cu130-py312", "part-grpc-cu130-py312", "part-tritonclient-cu130-py312", "part-tensorrt-rtx-cu130-py312", "part-common-cu132-py312", "part-torch-cu132-py312", "part-grpc-cu132-py312", "part-tritonclient-cu132-py312", "part-tensorrt-rtx-cu132-py312", "part-common-cpu-py312", "part-torch-cpu-py312", "part-grpc-cpu-py312", "part-tensorflow-cpu-py312", "part-tritonclient-cpu-py312", "part-common-cu128-py314", "part-torch-cu128-py314", "part-grpc-cu128-py314", "part-tritonclient-cu128-py314", "part-common-cu130-py314", "part-torch-cu130-py314", "part-grpc-cu130-py314", "part-tritonclient-cu130-py314", "part-tensorrt-rtx-cu130-py314", "part-common-cu132-py314", "part-torch-cu132-py314", "part-grpc-cu132-py314", "part-tritonclient-cu132-py314", "part-tensorrt-rtx-cu132-py314", "part-common-cpu-py314", "part-grpc-cpu-py314", "part-tritonclient-cpu-py314", "part-common-cu128-py311", "part-torch-cu128-py311", "part-grpc-cu128-py311", "part-tensorflow-cu128-py311", "part-tritonclient-cu128-py311", "part-common-cu130-py311", "part-torch-cu130-py311", "part-grpc-cu130-py311", "part-tritonclient-cu130-py311", "part-tensorrt-rtx-cu130-py311", "part-common-cu132-py311", "part-torch-cu132-py311", "part-grpc-cu132-py311", "part-tritonclient-cu132-py311", "part-tensorrt-rtx-cu132-py311", "part-common-cpu-py311", "part-grpc-cpu-py311", "part-tensorflow-cpu-py311", "part-tritonclient-cpu-py311", "part-common-cu128-py313", "part-torch-cu128-py313", "part-grpc-cu128-py313", "part-tensorflow-cu128-py313", "part-tritonclient-cu128-py313", "part-common-cu130-py313", "part-torch-cu130-py313", "part-grpc-cu130-py313", "part-tritonclient-cu130-py313", "part-tensorrt-rtx-cu130-py313", "part-common-cu132-py313", "part-torch-cu132-py313", "part-grpc-cu132-py313", "part-tritonclient-cu132-py313", "part-tensorrt-rtx-cu132-py313", "part-common-cpu-py313", "part-torch-cpu-py313", "part-grpc-cpu-py313", "part-tensorflow-cpu-py313", "part-tritonclient-cpu-py313",
  ]
}
