# Generated from matrix.yaml: change that, then run
#   rosml generate
#
#   docker buildx bake -f docker-bake.hcl -f docker-bake.tests.hcl ros1-bookworm-core-test   runs an image's structure tests inside the build

# ---- What others inherit, and operating systems ---------------------------------------------------------------------

target "_test" {
  inherits = ["_every"]
  target   = "test"
  contexts = { os = OS_BOOKWORM }
  output   = ["type=cacheonly"]
}

# ---- noetic ---------------------------------------------------------------------------------------------------------

target "noetic-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core", "ros", "noetic-core") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-core ros1-components ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core"
  }
}

target "noetic-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base", "ros", "noetic-base") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-base ros1-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base"
  }
}

target "noetic-robot-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot", "ros", "noetic-robot") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-robot ros1-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot"
  }
}

target "noetic-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception", "ros", "noetic-perception") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-perception ros1-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception"
  }
}

target "noetic-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop", "ros", "noetic-desktop") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop ros1-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop"
  }
}

target "noetic-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full", "ros", "noetic-desktop-full") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop-full ros1-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full"
  }
}

target "noetic-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run", "ros", "noetic-core-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "noetic-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run", "ros", "noetic-base-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "noetic-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-cuda-cu128", "ros-cuda", "noetic-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda cuda-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-cuda-cu128", "ros-cuda", "noetic-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-cuda-cu128", "ros-cuda", "noetic-robot-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-cuda-cu128", "ros-cuda", "noetic-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-cuda-cu128", "ros-cuda", "noetic-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-cuda-cu128", "ros-cuda", "noetic-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-cuda-cu128", "ros-cuda", "noetic-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-cuda-cu128", "ros-cuda", "noetic-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "noetic-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-cuda-cu130", "ros-cuda", "noetic-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda cuda-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-cuda-cu130", "ros-cuda", "noetic-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-cuda-cu130", "ros-cuda", "noetic-robot-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-cuda-cu130", "ros-cuda", "noetic-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-cuda-cu130", "ros-cuda", "noetic-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-cuda-cu130", "ros-cuda", "noetic-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-cuda-cu130", "ros-cuda", "noetic-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-cuda-cu130", "ros-cuda", "noetic-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-cuda-cu132", "ros-cuda", "noetic-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda cuda-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-cuda-cu132", "ros-cuda", "noetic-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-robot-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-cuda-cu132", "ros-cuda", "noetic-robot-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-cuda-cu132", "ros-cuda", "noetic-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-cuda-cu132", "ros-cuda", "noetic-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-cuda-cu132", "ros-cuda", "noetic-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-cuda-cu132", "ros-cuda", "noetic-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-cuda-cu132", "ros-cuda", "noetic-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-cuda-cu121", "ros-cuda", "noetic-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-cuda-cu121", "ros-cuda", "noetic-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-cuda-cu121", "ros-cuda", "noetic-robot-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-cuda-cu121", "ros-cuda", "noetic-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-cuda-cu121", "ros-cuda", "noetic-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-cuda-cu121", "ros-cuda", "noetic-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-cuda-cu121", "ros-cuda", "noetic-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-cuda-cu121", "ros-cuda", "noetic-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "noetic-core-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-torch-cu121", "ros-torch", "noetic-core-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch cuda-build torch-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-base-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-torch-cu121", "ros-torch", "noetic-base-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-robot-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-torch-cu121", "ros-torch", "noetic-robot-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-perception-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-torch-cu121", "ros-torch", "noetic-perception-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-desktop-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-torch-cu121", "ros-torch", "noetic-desktop-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-desktop-full-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-torch-cu121", "ros-torch", "noetic-desktop-full-torch-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-core-run-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-torch-cu121", "ros-torch", "noetic-core-run-torch-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-base-run-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-torch-cu121", "ros-torch", "noetic-base-run-torch-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "noetic-core-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-torch-cpu38", "ros-torch", "noetic-core-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch torch-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core torch=2.4.1"
  }
}

target "noetic-base-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-torch-cpu38", "ros-torch", "noetic-base-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base torch=2.4.1"
  }
}

target "noetic-robot-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-torch-cpu38", "ros-torch", "noetic-robot-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot torch=2.4.1"
  }
}

target "noetic-perception-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-torch-cpu38", "ros-torch", "noetic-perception-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception torch=2.4.1"
  }
}

target "noetic-desktop-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-torch-cpu38", "ros-torch", "noetic-desktop-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop torch=2.4.1"
  }
}

target "noetic-desktop-full-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-torch-cpu38", "ros-torch", "noetic-desktop-full-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full torch=2.4.1"
  }
}

target "noetic-core-run-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-torch-cpu38", "ros-torch", "noetic-core-run-torch-cpu38") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1"
  }
}

target "noetic-base-run-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-torch-cpu38", "ros-torch", "noetic-base-run-torch-cpu38") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1"
  }
}

target "noetic-core-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-tensorflow-cpu38", "ros-tf", "noetic-core-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow tensorflow-build ros1-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core tensorflow=2.13.1"
  }
}

target "noetic-base-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-tensorflow-cpu38", "ros-tf", "noetic-base-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base tensorflow=2.13.1"
  }
}

target "noetic-robot-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-robot-tensorflow-cpu38", "ros-tf", "noetic-robot-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot tensorflow=2.13.1"
  }
}

target "noetic-perception-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-perception-tensorflow-cpu38", "ros-tf", "noetic-perception-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception tensorflow=2.13.1"
  }
}

target "noetic-desktop-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-tensorflow-cpu38", "ros-tf", "noetic-desktop-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop tensorflow=2.13.1"
  }
}

target "noetic-desktop-full-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-desktop-full-tensorflow-cpu38", "ros-tf", "noetic-desktop-full-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core packages_base=ros-noetic-ros-base packages_robot=ros-noetic-robot packages_perception=ros-noetic-perception packages_desktop=ros-noetic-desktop packages_desktop_full=ros-noetic-desktop-full tensorflow=2.13.1"
  }
}

target "noetic-core-run-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-run-tensorflow-cpu38", "ros-tf", "noetic-core-run-tensorflow-cpu38") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.13.1"
  }
}

target "noetic-base-run-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-base-run-tensorflow-cpu38", "ros-tf", "noetic-base-run-tensorflow-cpu38") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.13.1"
  }
}

target "noetic-core-onnx-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-onnx-cu121", "ros-onnx", "noetic-core-onnx-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core onnxruntime=1.19.2 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_52,sm_60,sm_61,sm_70,sm_75,sm_80,compute_52,compute_60,compute_61,compute_70,compute_75,compute_80"
  }
}

target "noetic-core-torch-onnx-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-torch-onnx-cu121", "ros-torch-onnx", "noetic-core-torch-onnx-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core torch=2.4.1 onnxruntime=1.19.2 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90 gpu_onnxruntime_amd64=sm_52,sm_60,sm_61,sm_70,sm_75,sm_80,compute_52,compute_60,compute_61,compute_70,compute_75,compute_80"
  }
}

target "noetic-core-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-devel-cu130", "ros-devel", "noetic-core-devel-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "noetic-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("noetic-core-devel-cu132", "ros-devel", "noetic-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=1 ros_distro=noetic releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-noetic-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

# ---- foxy -----------------------------------------------------------------------------------------------------------

target "foxy-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core", "ros", "foxy-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core"
  }
}

target "foxy-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base", "ros", "foxy-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base"
  }
}

target "foxy-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop", "ros", "foxy-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop"
  }
}

target "foxy-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run", "ros", "foxy-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "foxy-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run", "ros", "foxy-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "foxy-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-cuda-cu128", "ros-cuda", "foxy-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "foxy-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-cuda-cu128", "ros-cuda", "foxy-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "foxy-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-cuda-cu128", "ros-cuda", "foxy-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "foxy-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-cuda-cu128", "ros-cuda", "foxy-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "foxy-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-cuda-cu128", "ros-cuda", "foxy-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "foxy-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-cuda-cu130", "ros-cuda", "foxy-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-cuda-cu130", "ros-cuda", "foxy-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-cuda-cu130", "ros-cuda", "foxy-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-cuda-cu130", "ros-cuda", "foxy-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-cuda-cu130", "ros-cuda", "foxy-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-cuda-cu132", "ros-cuda", "foxy-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-cuda-cu132", "ros-cuda", "foxy-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-cuda-cu132", "ros-cuda", "foxy-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-cuda-cu132", "ros-cuda", "foxy-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-cuda-cu132", "ros-cuda", "foxy-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "foxy-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-cuda-cu121", "ros-cuda", "foxy-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "foxy-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-cuda-cu121", "ros-cuda", "foxy-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "foxy-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-cuda-cu121", "ros-cuda", "foxy-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "foxy-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-cuda-cu121", "ros-cuda", "foxy-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "foxy-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-cuda-cu121", "ros-cuda", "foxy-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "foxy-core-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-torch-cu121", "ros-torch", "foxy-core-torch-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "foxy-base-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-torch-cu121", "ros-torch", "foxy-base-torch-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "foxy-desktop-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-torch-cu121", "ros-torch", "foxy-desktop-torch-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "foxy-core-run-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-torch-cu121", "ros-torch", "foxy-core-run-torch-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "foxy-base-run-torch-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-torch-cu121", "ros-torch", "foxy-base-run-torch-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1 cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 torchaudio=2.4.1 torchvision=0.19.1 gpu_driver=525 gpu_torch_amd64=sm_50,sm_60,sm_70,sm_75,sm_80,sm_86,sm_90"
  }
}

target "foxy-core-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-torch-cpu38", "ros-torch", "foxy-core-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core torch=2.4.1"
  }
}

target "foxy-base-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-torch-cpu38", "ros-torch", "foxy-base-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base torch=2.4.1"
  }
}

target "foxy-desktop-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-torch-cpu38", "ros-torch", "foxy-desktop-torch-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop torch=2.4.1"
  }
}

target "foxy-core-run-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-torch-cpu38", "ros-torch", "foxy-core-run-torch-cpu38") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1"
  }
}

target "foxy-base-run-torch-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-torch-cpu38", "ros-torch", "foxy-base-run-torch-cpu38") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.4.1"
  }
}

target "foxy-core-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-tensorflow-cpu38", "ros-tf", "foxy-core-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core tensorflow=2.13.1"
  }
}

target "foxy-base-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-tensorflow-cpu38", "ros-tf", "foxy-base-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base tensorflow=2.13.1"
  }
}

target "foxy-desktop-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-desktop-tensorflow-cpu38", "ros-tf", "foxy-desktop-tensorflow-cpu38") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-foxy-ros-core packages_base=ros-foxy-ros-base packages_desktop=ros-foxy-desktop tensorflow=2.13.1"
  }
}

target "foxy-core-run-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-core-run-tensorflow-cpu38", "ros-tf", "foxy-core-run-tensorflow-cpu38") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.13.1"
  }
}

target "foxy-base-run-tensorflow-cpu38-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("foxy-base-run-tensorflow-cpu38", "ros-tf", "foxy-base-run-tensorflow-cpu38") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-20.04 python=3.8 ros=2 ros_distro=foxy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.13.1"
  }
}

# ---- humble ---------------------------------------------------------------------------------------------------------

target "humble-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core", "ros", "humble-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core"
  }
}

target "humble-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base", "ros", "humble-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base"
  }
}

target "humble-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception", "ros", "humble-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception"
  }
}

target "humble-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop", "ros", "humble-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop"
  }
}

target "humble-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full", "ros", "humble-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full"
  }
}

target "humble-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run", "ros", "humble-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "humble-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run", "ros", "humble-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "humble-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-cuda-cu128", "ros-cuda", "humble-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-cuda-cu128", "ros-cuda", "humble-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-cuda-cu128", "ros-cuda", "humble-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-cuda-cu128", "ros-cuda", "humble-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-cuda-cu128", "ros-cuda", "humble-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-cuda-cu128", "ros-cuda", "humble-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-cuda-cu128", "ros-cuda", "humble-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-cuda-cu130", "ros-cuda", "humble-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-cuda-cu130", "ros-cuda", "humble-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-cuda-cu130", "ros-cuda", "humble-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-cuda-cu130", "ros-cuda", "humble-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-cuda-cu130", "ros-cuda", "humble-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-cuda-cu130", "ros-cuda", "humble-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-cuda-cu130", "ros-cuda", "humble-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-cuda-cu132", "ros-cuda", "humble-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-cuda-cu132", "ros-cuda", "humble-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-cuda-cu132", "ros-cuda", "humble-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-cuda-cu132", "ros-cuda", "humble-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-cuda-cu132", "ros-cuda", "humble-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-cuda-cu132", "ros-cuda", "humble-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-cuda-cu132", "ros-cuda", "humble-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-cuda-cu121", "ros-cuda", "humble-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-cuda-cu121", "ros-cuda", "humble-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-cuda-cu121", "ros-cuda", "humble-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-cuda-cu121", "ros-cuda", "humble-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-cuda-cu121", "ros-cuda", "humble-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-cuda-cu121", "ros-cuda", "humble-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-cuda-cu121", "ros-cuda", "humble-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "humble-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-cu128", "ros-torch", "humble-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-torch-cu128", "ros-torch", "humble-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-torch-cu128", "ros-torch", "humble-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-torch-cu128", "ros-torch", "humble-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-torch-cu128", "ros-torch", "humble-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-torch-cu128", "ros-torch", "humble-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-torch-cu128", "ros-torch", "humble-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "humble-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-cu130", "ros-torch", "humble-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-torch-cu130", "ros-torch", "humble-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-torch-cu130", "ros-torch", "humble-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-torch-cu130", "ros-torch", "humble-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-torch-cu130", "ros-torch", "humble-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-torch-cu130", "ros-torch", "humble-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-torch-cu130", "ros-torch", "humble-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-cpu", "ros-torch", "humble-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0"
  }
}

target "humble-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-torch-cpu", "ros-torch", "humble-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0"
  }
}

target "humble-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-torch-cpu", "ros-torch", "humble-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0"
  }
}

target "humble-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-torch-cpu", "ros-torch", "humble-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0"
  }
}

target "humble-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-torch-cpu", "ros-torch", "humble-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0"
  }
}

target "humble-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-torch-cpu", "ros-torch", "humble-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "humble-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-torch-cpu", "ros-torch", "humble-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "humble-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorflow-cu128", "ros-tf", "humble-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-tensorflow-cu128", "ros-tf", "humble-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-tensorflow-cu128", "ros-tf", "humble-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-tensorflow-cu128", "ros-tf", "humble-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-tensorflow-cu128", "ros-tf", "humble-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-tensorflow-cu128", "ros-tf", "humble-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-tensorflow-cu128", "ros-tf", "humble-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorflow-cpu", "ros-tf", "humble-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorflow=2.21.0"
  }
}

target "humble-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-tensorflow-cpu", "ros-tf", "humble-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base tensorflow=2.21.0"
  }
}

target "humble-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-tensorflow-cpu", "ros-tf", "humble-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception tensorflow=2.21.0"
  }
}

target "humble-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-tensorflow-cpu", "ros-tf", "humble-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop tensorflow=2.21.0"
  }
}

target "humble-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-tensorflow-cpu", "ros-tf", "humble-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full tensorflow=2.21.0"
  }
}

target "humble-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-tensorflow-cpu", "ros-tf", "humble-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "humble-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-tensorflow-cpu", "ros-tf", "humble-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "humble-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-ml-cu128", "ros-ml", "humble-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-ml-cu128", "ros-ml", "humble-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-ml-cu128", "ros-ml", "humble-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-ml-cu128", "ros-ml", "humble-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-ml-cu128", "ros-ml", "humble-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-ml-cu128", "ros-ml", "humble-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-ml-cu128", "ros-ml", "humble-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "humble-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-ml-cpu", "ros-ml", "humble-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-ml-cpu", "ros-ml", "humble-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-perception-ml-cpu", "ros-ml", "humble-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-ml-cpu", "ros-ml", "humble-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-desktop-full-ml-cpu", "ros-ml", "humble-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base packages_perception=ros-humble-perception packages_desktop=ros-humble-desktop packages_desktop_full=ros-humble-desktop-full torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-run-ml-cpu", "ros-ml", "humble-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-run-ml-cpu", "ros-ml", "humble-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "humble-core-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-onnx-cu128", "ros-onnx", "humble-core-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "humble-base-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-onnx-cu128", "ros-onnx", "humble-base-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "humble-core-torch-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-onnx-cu128", "ros-torch-onnx", "humble-core-torch-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "humble-core-tensorflow-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorflow-onnx-cu128", "ros-tf-onnx", "humble-core-tensorflow-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorflow=2.20.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "humble-core-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-onnx-cpu", "ros-onnx", "humble-core-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core onnxruntime=1.23.2"
  }
}

target "humble-base-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-base-onnx-cpu", "ros-onnx", "humble-base-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside onnxruntime"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core packages_base=ros-humble-ros-base onnxruntime=1.23.2"
  }
}

target "humble-core-torch-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-onnx-cpu", "ros-torch-onnx", "humble-core-torch-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.10.0 onnxruntime=1.23.2"
  }
}

target "humble-core-tensorflow-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorflow-onnx-cpu", "ros-tf-onnx", "humble-core-tensorflow-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorflow=2.21.0 onnxruntime=1.23.2"
  }
}

target "humble-core-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-devel-cu130", "ros-devel", "humble-core-devel-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-torch-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-torch-devel-cu130", "ros-torch-devel", "humble-core-torch-devel-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch devel devel-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "humble-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-devel-cu132", "ros-devel", "humble-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-triton-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-triton-cu128", "ros-triton", "humble-core-triton-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tritonclient=2.73.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "humble-core-triton-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-triton-cu130", "ros-triton", "humble-core-triton-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tritonclient=2.73.0 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-triton-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-triton-cu132", "ros-triton", "humble-core-triton-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tritonclient=2.73.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "humble-core-triton-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-triton-cpu", "ros-triton", "humble-core-triton-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tritonclient pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tritonclient=2.73.0"
  }
}

target "humble-core-tensorrt-rtx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorrt-rtx-cu130", "ros-tensorrt-rtx", "humble-core-tensorrt-rtx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorrt-rtx=1.7.1.116 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "humble-core-tensorrt-rtx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("humble-core-tensorrt-rtx-cu132", "ros-tensorrt-rtx", "humble-core-tensorrt-rtx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=humble releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-humble-ros-core tensorrt-rtx=1.7.1.116 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

# ---- iron -----------------------------------------------------------------------------------------------------------

target "iron-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core", "ros", "iron-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core"
  }
}

target "iron-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base", "ros", "iron-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base"
  }
}

target "iron-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception", "ros", "iron-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception"
  }
}

target "iron-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop", "ros", "iron-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop"
  }
}

target "iron-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full", "ros", "iron-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full"
  }
}

target "iron-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run", "ros", "iron-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "iron-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run", "ros", "iron-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "iron-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-cuda-cu128", "ros-cuda", "iron-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-cuda-cu128", "ros-cuda", "iron-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-cuda-cu128", "ros-cuda", "iron-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-cuda-cu128", "ros-cuda", "iron-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-cuda-cu128", "ros-cuda", "iron-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-cuda-cu128", "ros-cuda", "iron-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-cuda-cu128", "ros-cuda", "iron-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "iron-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-cuda-cu130", "ros-cuda", "iron-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-cuda-cu130", "ros-cuda", "iron-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-cuda-cu130", "ros-cuda", "iron-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-cuda-cu130", "ros-cuda", "iron-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-cuda-cu130", "ros-cuda", "iron-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-cuda-cu130", "ros-cuda", "iron-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-cuda-cu130", "ros-cuda", "iron-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-cuda-cu132", "ros-cuda", "iron-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-cuda-cu132", "ros-cuda", "iron-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-cuda-cu132", "ros-cuda", "iron-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-cuda-cu132", "ros-cuda", "iron-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-cuda-cu132", "ros-cuda", "iron-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-cuda-cu132", "ros-cuda", "iron-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-cuda-cu132", "ros-cuda", "iron-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "iron-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-cuda-cu121", "ros-cuda", "iron-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-cuda-cu121", "ros-cuda", "iron-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-cuda-cu121", "ros-cuda", "iron-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-cuda-cu121", "ros-cuda", "iron-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-cuda-cu121", "ros-cuda", "iron-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-cuda-cu121", "ros-cuda", "iron-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-cuda-cu121", "ros-cuda", "iron-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "iron-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-torch-cu128", "ros-torch", "iron-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-torch-cu128", "ros-torch", "iron-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-torch-cu128", "ros-torch", "iron-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-torch-cu128", "ros-torch", "iron-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-torch-cu128", "ros-torch", "iron-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-torch-cu128", "ros-torch", "iron-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-torch-cu128", "ros-torch", "iron-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "iron-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-torch-cu130", "ros-torch", "iron-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-torch-cu130", "ros-torch", "iron-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-torch-cu130", "ros-torch", "iron-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-torch-cu130", "ros-torch", "iron-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-torch-cu130", "ros-torch", "iron-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-torch-cu130", "ros-torch", "iron-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-torch-cu130", "ros-torch", "iron-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "iron-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-torch-cpu", "ros-torch", "iron-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core torch=2.10.0"
  }
}

target "iron-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-torch-cpu", "ros-torch", "iron-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0"
  }
}

target "iron-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-torch-cpu", "ros-torch", "iron-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0"
  }
}

target "iron-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-torch-cpu", "ros-torch", "iron-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0"
  }
}

target "iron-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-torch-cpu", "ros-torch", "iron-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0"
  }
}

target "iron-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-torch-cpu", "ros-torch", "iron-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "iron-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-torch-cpu", "ros-torch", "iron-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "iron-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-tensorflow-cu128", "ros-tf", "iron-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-tensorflow-cu128", "ros-tf", "iron-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-tensorflow-cu128", "ros-tf", "iron-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-tensorflow-cu128", "ros-tf", "iron-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-tensorflow-cu128", "ros-tf", "iron-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-tensorflow-cu128", "ros-tf", "iron-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-tensorflow-cu128", "ros-tf", "iron-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-tensorflow-cpu", "ros-tf", "iron-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core tensorflow=2.21.0"
  }
}

target "iron-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-tensorflow-cpu", "ros-tf", "iron-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base tensorflow=2.21.0"
  }
}

target "iron-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-tensorflow-cpu", "ros-tf", "iron-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception tensorflow=2.21.0"
  }
}

target "iron-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-tensorflow-cpu", "ros-tf", "iron-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop tensorflow=2.21.0"
  }
}

target "iron-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-tensorflow-cpu", "ros-tf", "iron-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full tensorflow=2.21.0"
  }
}

target "iron-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-tensorflow-cpu", "ros-tf", "iron-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "iron-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-tensorflow-cpu", "ros-tf", "iron-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "iron-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-ml-cu128", "ros-ml", "iron-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-ml-cu128", "ros-ml", "iron-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-ml-cu128", "ros-ml", "iron-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-ml-cu128", "ros-ml", "iron-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-ml-cu128", "ros-ml", "iron-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-ml-cu128", "ros-ml", "iron-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-ml-cu128", "ros-ml", "iron-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "iron-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-ml-cpu", "ros-ml", "iron-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-ml-cpu", "ros-ml", "iron-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-perception-ml-cpu", "ros-ml", "iron-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-ml-cpu", "ros-ml", "iron-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-desktop-full-ml-cpu", "ros-ml", "iron-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-iron-ros-core packages_base=ros-iron-ros-base packages_perception=ros-iron-perception packages_desktop=ros-iron-desktop packages_desktop_full=ros-iron-desktop-full torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-core-run-ml-cpu", "ros-ml", "iron-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "iron-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("iron-base-run-ml-cpu", "ros-ml", "iron-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-22.04 python=3.10 ros=2 ros_distro=iron releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

# ---- jazzy ----------------------------------------------------------------------------------------------------------

target "jazzy-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core", "ros", "jazzy-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core"
  }
}

target "jazzy-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base", "ros", "jazzy-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base"
  }
}

target "jazzy-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception", "ros", "jazzy-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception"
  }
}

target "jazzy-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop", "ros", "jazzy-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop"
  }
}

target "jazzy-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full", "ros", "jazzy-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full"
  }
}

target "jazzy-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run", "ros", "jazzy-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "jazzy-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run", "ros", "jazzy-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "jazzy-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-cuda-cu128", "ros-cuda", "jazzy-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-cuda-cu128", "ros-cuda", "jazzy-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-cuda-cu128", "ros-cuda", "jazzy-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-cuda-cu128", "ros-cuda", "jazzy-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-cuda-cu128", "ros-cuda", "jazzy-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-cuda-cu128", "ros-cuda", "jazzy-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-cuda-cu128", "ros-cuda", "jazzy-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-cuda-cu130", "ros-cuda", "jazzy-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-cuda-cu130", "ros-cuda", "jazzy-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-cuda-cu130", "ros-cuda", "jazzy-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-cuda-cu130", "ros-cuda", "jazzy-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-cuda-cu130", "ros-cuda", "jazzy-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-cuda-cu130", "ros-cuda", "jazzy-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-cuda-cu130", "ros-cuda", "jazzy-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-cuda-cu132", "ros-cuda", "jazzy-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-cuda-cu132", "ros-cuda", "jazzy-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-cuda-cu132", "ros-cuda", "jazzy-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-cuda-cu132", "ros-cuda", "jazzy-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-cuda-cu132", "ros-cuda", "jazzy-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-cuda-cu132", "ros-cuda", "jazzy-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-cuda-cu132", "ros-cuda", "jazzy-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-cuda-cu121", "ros-cuda", "jazzy-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-cuda-cu121", "ros-cuda", "jazzy-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-cuda-cu121", "ros-cuda", "jazzy-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-cuda-cu121", "ros-cuda", "jazzy-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-cuda-cu121", "ros-cuda", "jazzy-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-cuda-cu121", "ros-cuda", "jazzy-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-cuda-cu121", "ros-cuda", "jazzy-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-cu128", "ros-torch", "jazzy-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-torch-cu128", "ros-torch", "jazzy-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-torch-cu128", "ros-torch", "jazzy-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-torch-cu128", "ros-torch", "jazzy-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-torch-cu128", "ros-torch", "jazzy-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-torch-cu128", "ros-torch", "jazzy-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-torch-cu128", "ros-torch", "jazzy-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-cu130", "ros-torch", "jazzy-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-torch-cu130", "ros-torch", "jazzy-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-torch-cu130", "ros-torch", "jazzy-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-torch-cu130", "ros-torch", "jazzy-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-torch-cu130", "ros-torch", "jazzy-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-torch-cu130", "ros-torch", "jazzy-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-torch-cu130", "ros-torch", "jazzy-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-cu132", "ros-torch", "jazzy-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-torch-cu132", "ros-torch", "jazzy-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-torch-cu132", "ros-torch", "jazzy-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-torch-cu132", "ros-torch", "jazzy-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-torch-cu132", "ros-torch", "jazzy-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-torch-cu132", "ros-torch", "jazzy-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-torch-cu132", "ros-torch", "jazzy-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-cpu", "ros-torch", "jazzy-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0"
  }
}

target "jazzy-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-torch-cpu", "ros-torch", "jazzy-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0"
  }
}

target "jazzy-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-torch-cpu", "ros-torch", "jazzy-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0"
  }
}

target "jazzy-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-torch-cpu", "ros-torch", "jazzy-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0"
  }
}

target "jazzy-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-torch-cpu", "ros-torch", "jazzy-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0"
  }
}

target "jazzy-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-torch-cpu", "ros-torch", "jazzy-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "jazzy-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-torch-cpu", "ros-torch", "jazzy-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "jazzy-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorflow-cu128", "ros-tf", "jazzy-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-tensorflow-cu128", "ros-tf", "jazzy-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-tensorflow-cu128", "ros-tf", "jazzy-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-tensorflow-cu128", "ros-tf", "jazzy-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-tensorflow-cu128", "ros-tf", "jazzy-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-tensorflow-cu128", "ros-tf", "jazzy-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-tensorflow-cu128", "ros-tf", "jazzy-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorflow-cpu", "ros-tf", "jazzy-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorflow=2.21.0"
  }
}

target "jazzy-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-tensorflow-cpu", "ros-tf", "jazzy-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base tensorflow=2.21.0"
  }
}

target "jazzy-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-tensorflow-cpu", "ros-tf", "jazzy-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception tensorflow=2.21.0"
  }
}

target "jazzy-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-tensorflow-cpu", "ros-tf", "jazzy-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop tensorflow=2.21.0"
  }
}

target "jazzy-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-tensorflow-cpu", "ros-tf", "jazzy-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full tensorflow=2.21.0"
  }
}

target "jazzy-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-tensorflow-cpu", "ros-tf", "jazzy-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "jazzy-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-tensorflow-cpu", "ros-tf", "jazzy-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "jazzy-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-ml-cu128", "ros-ml", "jazzy-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-ml-cu128", "ros-ml", "jazzy-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-ml-cu128", "ros-ml", "jazzy-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-ml-cu128", "ros-ml", "jazzy-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-ml-cu128", "ros-ml", "jazzy-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-ml-cu128", "ros-ml", "jazzy-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-ml-cu128", "ros-ml", "jazzy-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-ml-cpu", "ros-ml", "jazzy-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-ml-cpu", "ros-ml", "jazzy-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-perception-ml-cpu", "ros-ml", "jazzy-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-ml-cpu", "ros-ml", "jazzy-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-desktop-full-ml-cpu", "ros-ml", "jazzy-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base packages_perception=ros-jazzy-perception packages_desktop=ros-jazzy-desktop packages_desktop_full=ros-jazzy-desktop-full torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-run-ml-cpu", "ros-ml", "jazzy-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-run-ml-cpu", "ros-ml", "jazzy-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "jazzy-core-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-onnx-cu128", "ros-onnx", "jazzy-core-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "jazzy-base-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-onnx-cu128", "ros-onnx", "jazzy-base-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "jazzy-core-torch-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-onnx-cu128", "ros-torch-onnx", "jazzy-core-torch-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "jazzy-core-tensorflow-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorflow-onnx-cu128", "ros-tf-onnx", "jazzy-core-tensorflow-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorflow=2.20.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "jazzy-core-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-onnx-cu130", "ros-onnx", "jazzy-core-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "jazzy-base-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-onnx-cu130", "ros-onnx", "jazzy-base-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "jazzy-core-torch-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-onnx-cu130", "ros-torch-onnx", "jazzy-core-torch-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.14.1 onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "jazzy-core-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-onnx-cu132", "ros-onnx", "jazzy-core-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "jazzy-core-torch-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-onnx-cu132", "ros-torch-onnx", "jazzy-core-torch-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.15.0 onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "jazzy-core-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-onnx-cpu", "ros-onnx", "jazzy-core-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core onnxruntime=1.23.2"
  }
}

target "jazzy-base-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-onnx-cpu", "ros-onnx", "jazzy-base-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside onnxruntime"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base onnxruntime=1.23.2"
  }
}

target "jazzy-core-torch-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-onnx-cpu", "ros-torch-onnx", "jazzy-core-torch-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.10.0 onnxruntime=1.23.2"
  }
}

target "jazzy-core-tensorflow-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorflow-onnx-cpu", "ros-tf-onnx", "jazzy-core-tensorflow-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorflow=2.21.0 onnxruntime=1.23.2"
  }
}

target "jazzy-core-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-devel-cu130", "ros-devel", "jazzy-core-devel-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-torch-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-devel-cu130", "ros-torch-devel", "jazzy-core-torch-devel-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch devel devel-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-devel-cu132", "ros-devel", "jazzy-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-torch-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-torch-devel-cu132", "ros-torch-devel", "jazzy-core-torch-devel-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch devel devel-build pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-core-triton-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-triton-cu128", "ros-triton", "jazzy-core-triton-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tritonclient=2.73.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-core-triton-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-triton-cu130", "ros-triton", "jazzy-core-triton-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tritonclient=2.73.0 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-triton-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-triton-cu132", "ros-triton", "jazzy-core-triton-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tritonclient=2.73.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-core-triton-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-triton-cpu", "ros-triton", "jazzy-core-triton-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tritonclient pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tritonclient=2.73.0"
  }
}

target "jazzy-core-tensorrt-rtx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorrt-rtx-cu130", "ros-tensorrt-rtx", "jazzy-core-tensorrt-rtx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorrt-rtx=1.7.1.116 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "jazzy-core-tensorrt-rtx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-core-tensorrt-rtx-cu132", "ros-tensorrt-rtx", "jazzy-core-tensorrt-rtx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core tensorrt-rtx=1.7.1.116 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "jazzy-base-torch-cu128-env-lerobot-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-base-torch-cu128-env-lerobot", "ros-torch", "jazzy-base-torch-cu128-env-lerobot") }
  args = {
    TESTS  = "contract environment lerobot"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=jazzy environment=lerobot releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-jazzy-ros-core packages_base=ros-jazzy-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

# ---- kilted ---------------------------------------------------------------------------------------------------------

target "kilted-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core", "ros", "kilted-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core"
  }
}

target "kilted-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base", "ros", "kilted-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base"
  }
}

target "kilted-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception", "ros", "kilted-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception"
  }
}

target "kilted-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop", "ros", "kilted-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop"
  }
}

target "kilted-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full", "ros", "kilted-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full"
  }
}

target "kilted-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run", "ros", "kilted-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "kilted-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run", "ros", "kilted-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "kilted-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-cuda-cu128", "ros-cuda", "kilted-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-cuda-cu128", "ros-cuda", "kilted-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-cuda-cu128", "ros-cuda", "kilted-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-cuda-cu128", "ros-cuda", "kilted-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-cuda-cu128", "ros-cuda", "kilted-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-cuda-cu128", "ros-cuda", "kilted-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-cuda-cu128", "ros-cuda", "kilted-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "kilted-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-cuda-cu130", "ros-cuda", "kilted-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-cuda-cu130", "ros-cuda", "kilted-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-cuda-cu130", "ros-cuda", "kilted-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-cuda-cu130", "ros-cuda", "kilted-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-cuda-cu130", "ros-cuda", "kilted-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-cuda-cu130", "ros-cuda", "kilted-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-cuda-cu130", "ros-cuda", "kilted-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-cuda-cu132", "ros-cuda", "kilted-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-cuda-cu132", "ros-cuda", "kilted-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-cuda-cu132", "ros-cuda", "kilted-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-cuda-cu132", "ros-cuda", "kilted-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-cuda-cu132", "ros-cuda", "kilted-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-cuda-cu132", "ros-cuda", "kilted-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-cuda-cu132", "ros-cuda", "kilted-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "kilted-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-cuda-cu121", "ros-cuda", "kilted-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-cuda-cu121", "ros-cuda", "kilted-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-cuda-cu121", "ros-cuda", "kilted-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-cuda-cu121", "ros-cuda", "kilted-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-cuda-cu121", "ros-cuda", "kilted-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-cuda-cu121", "ros-cuda", "kilted-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-cuda-cu121", "ros-cuda", "kilted-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "kilted-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-torch-cu128", "ros-torch", "kilted-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-torch-cu128", "ros-torch", "kilted-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-torch-cu128", "ros-torch", "kilted-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-torch-cu128", "ros-torch", "kilted-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-torch-cu128", "ros-torch", "kilted-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-torch-cu128", "ros-torch", "kilted-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-torch-cu128", "ros-torch", "kilted-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "kilted-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-torch-cu130", "ros-torch", "kilted-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-torch-cu130", "ros-torch", "kilted-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-torch-cu130", "ros-torch", "kilted-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-torch-cu130", "ros-torch", "kilted-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-torch-cu130", "ros-torch", "kilted-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-torch-cu130", "ros-torch", "kilted-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-torch-cu130", "ros-torch", "kilted-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-torch-cu132", "ros-torch", "kilted-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-torch-cu132", "ros-torch", "kilted-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-torch-cu132", "ros-torch", "kilted-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-torch-cu132", "ros-torch", "kilted-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-torch-cu132", "ros-torch", "kilted-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-torch-cu132", "ros-torch", "kilted-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-torch-cu132", "ros-torch", "kilted-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "kilted-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-torch-cpu", "ros-torch", "kilted-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.10.0"
  }
}

target "kilted-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-torch-cpu", "ros-torch", "kilted-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0"
  }
}

target "kilted-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-torch-cpu", "ros-torch", "kilted-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0"
  }
}

target "kilted-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-torch-cpu", "ros-torch", "kilted-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0"
  }
}

target "kilted-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-torch-cpu", "ros-torch", "kilted-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0"
  }
}

target "kilted-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-torch-cpu", "ros-torch", "kilted-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "kilted-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-torch-cpu", "ros-torch", "kilted-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "kilted-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-tensorflow-cu128", "ros-tf", "kilted-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-tensorflow-cu128", "ros-tf", "kilted-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-tensorflow-cu128", "ros-tf", "kilted-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-tensorflow-cu128", "ros-tf", "kilted-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-tensorflow-cu128", "ros-tf", "kilted-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-tensorflow-cu128", "ros-tf", "kilted-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-tensorflow-cu128", "ros-tf", "kilted-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-tensorflow-cpu", "ros-tf", "kilted-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core tensorflow=2.21.0"
  }
}

target "kilted-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-tensorflow-cpu", "ros-tf", "kilted-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base tensorflow=2.21.0"
  }
}

target "kilted-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-tensorflow-cpu", "ros-tf", "kilted-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception tensorflow=2.21.0"
  }
}

target "kilted-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-tensorflow-cpu", "ros-tf", "kilted-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop tensorflow=2.21.0"
  }
}

target "kilted-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-tensorflow-cpu", "ros-tf", "kilted-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full tensorflow=2.21.0"
  }
}

target "kilted-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-tensorflow-cpu", "ros-tf", "kilted-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "kilted-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-tensorflow-cpu", "ros-tf", "kilted-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "kilted-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-ml-cu128", "ros-ml", "kilted-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-ml-cu128", "ros-ml", "kilted-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-ml-cu128", "ros-ml", "kilted-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-ml-cu128", "ros-ml", "kilted-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-ml-cu128", "ros-ml", "kilted-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-ml-cu128", "ros-ml", "kilted-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-ml-cu128", "ros-ml", "kilted-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "kilted-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-ml-cpu", "ros-ml", "kilted-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow torch-build tensorflow-build ros2-workspace pip"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-ml-cpu", "ros-ml", "kilted-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-perception-ml-cpu", "ros-ml", "kilted-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-ml-cpu", "ros-ml", "kilted-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-desktop-full-ml-cpu", "ros-ml", "kilted-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-kilted-ros-core packages_base=ros-kilted-ros-base packages_perception=ros-kilted-perception packages_desktop=ros-kilted-desktop packages_desktop_full=ros-kilted-desktop-full torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-core-run-ml-cpu", "ros-ml", "kilted-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "kilted-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("kilted-base-run-ml-cpu", "ros-ml", "kilted-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch tensorflow"
    EXPECT = "os=ubuntu-24.04 python=3.12 ros=2 ros_distro=kilted releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

# ---- lyrical --------------------------------------------------------------------------------------------------------

target "lyrical-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core", "ros", "lyrical-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core"
  }
}

target "lyrical-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base", "ros", "lyrical-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base"
  }
}

target "lyrical-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception", "ros", "lyrical-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception"
  }
}

target "lyrical-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop", "ros", "lyrical-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop"
  }
}

target "lyrical-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full", "ros", "lyrical-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full"
  }
}

target "lyrical-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run", "ros", "lyrical-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "lyrical-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run", "ros", "lyrical-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "lyrical-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-cuda-cu128", "ros-cuda", "lyrical-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-cuda-cu128", "ros-cuda", "lyrical-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-cuda-cu128", "ros-cuda", "lyrical-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-cuda-cu128", "ros-cuda", "lyrical-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-cuda-cu128", "ros-cuda", "lyrical-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-cuda-cu128", "ros-cuda", "lyrical-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-cuda-cu128", "ros-cuda", "lyrical-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-cuda-cu130", "ros-cuda", "lyrical-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-cuda-cu130", "ros-cuda", "lyrical-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-cuda-cu130", "ros-cuda", "lyrical-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-cuda-cu130", "ros-cuda", "lyrical-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-cuda-cu130", "ros-cuda", "lyrical-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-cuda-cu130", "ros-cuda", "lyrical-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-cuda-cu130", "ros-cuda", "lyrical-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-cuda-cu132", "ros-cuda", "lyrical-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-cuda-cu132", "ros-cuda", "lyrical-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-cuda-cu132", "ros-cuda", "lyrical-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-cuda-cu132", "ros-cuda", "lyrical-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-cuda-cu132", "ros-cuda", "lyrical-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-cuda-cu132", "ros-cuda", "lyrical-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-cuda-cu132", "ros-cuda", "lyrical-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-cuda-cu121", "ros-cuda", "lyrical-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-cuda-cu121", "ros-cuda", "lyrical-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-cuda-cu121", "ros-cuda", "lyrical-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-cuda-cu121", "ros-cuda", "lyrical-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-cuda-cu121", "ros-cuda", "lyrical-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-cuda-cu121", "ros-cuda", "lyrical-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-cuda-cu121", "ros-cuda", "lyrical-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "lyrical-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-cu128", "ros-torch", "lyrical-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-torch-cu128", "ros-torch", "lyrical-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-torch-cu128", "ros-torch", "lyrical-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-torch-cu128", "ros-torch", "lyrical-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-torch-cu128", "ros-torch", "lyrical-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-torch-cu128", "ros-torch", "lyrical-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-torch-cu128", "ros-torch", "lyrical-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "lyrical-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-cu130", "ros-torch", "lyrical-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-torch-cu130", "ros-torch", "lyrical-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-torch-cu130", "ros-torch", "lyrical-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-torch-cu130", "ros-torch", "lyrical-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-torch-cu130", "ros-torch", "lyrical-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-torch-cu130", "ros-torch", "lyrical-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-torch-cu130", "ros-torch", "lyrical-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-cu132", "ros-torch", "lyrical-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-torch-cu132", "ros-torch", "lyrical-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-torch-cu132", "ros-torch", "lyrical-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-torch-cu132", "ros-torch", "lyrical-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-torch-cu132", "ros-torch", "lyrical-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-torch-cu132", "ros-torch", "lyrical-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-torch-cu132", "ros-torch", "lyrical-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-cpu", "ros-torch", "lyrical-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.10.0"
  }
}

target "lyrical-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-torch-cpu", "ros-torch", "lyrical-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base torch=2.10.0"
  }
}

target "lyrical-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-perception-torch-cpu", "ros-torch", "lyrical-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception torch=2.10.0"
  }
}

target "lyrical-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-torch-cpu", "ros-torch", "lyrical-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop torch=2.10.0"
  }
}

target "lyrical-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-desktop-full-torch-cpu", "ros-torch", "lyrical-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base packages_perception=ros-lyrical-perception packages_desktop=ros-lyrical-desktop packages_desktop_full=ros-lyrical-desktop-full torch=2.10.0"
  }
}

target "lyrical-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-run-torch-cpu", "ros-torch", "lyrical-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "lyrical-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-run-torch-cpu", "ros-torch", "lyrical-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "lyrical-core-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-onnx-cu130", "ros-onnx", "lyrical-core-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "lyrical-base-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-base-onnx-cu130", "ros-onnx", "lyrical-base-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core packages_base=ros-lyrical-ros-base onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "lyrical-core-torch-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-onnx-cu130", "ros-torch-onnx", "lyrical-core-torch-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.14.1 onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "lyrical-core-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-onnx-cu132", "ros-onnx", "lyrical-core-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "lyrical-core-torch-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-onnx-cu132", "ros-torch-onnx", "lyrical-core-torch-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.15.0 onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "lyrical-core-onnx-cpu314-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-onnx-cpu314", "ros-onnx", "lyrical-core-onnx-cpu314") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside onnxruntime onnxruntime-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core onnxruntime=1.32.0"
  }
}

target "lyrical-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-devel-cu132", "ros-devel", "lyrical-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda devel devel-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-torch-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-torch-devel-cu132", "ros-torch-devel", "lyrical-core-torch-devel-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch devel devel-build pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "lyrical-core-triton-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-triton-cu128", "ros-triton", "lyrical-core-triton-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tritonclient=2.73.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "lyrical-core-triton-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-triton-cu130", "ros-triton", "lyrical-core-triton-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tritonclient=2.73.0 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-triton-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-triton-cu132", "ros-triton", "lyrical-core-triton-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tritonclient pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tritonclient=2.73.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "lyrical-core-triton-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-triton-cpu", "ros-triton", "lyrical-core-triton-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside tritonclient pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tritonclient=2.73.0"
  }
}

target "lyrical-core-tensorrt-rtx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-tensorrt-rtx-cu130", "ros-tensorrt-rtx", "lyrical-core-tensorrt-rtx-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tensorrt-rtx=1.7.1.116 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "lyrical-core-tensorrt-rtx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("lyrical-core-tensorrt-rtx-cu132", "ros-tensorrt-rtx", "lyrical-core-tensorrt-rtx-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda tensorrt-rtx pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=lyrical releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-lyrical-ros-core tensorrt-rtx=1.7.1.116 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

# ---- rolling --------------------------------------------------------------------------------------------------------

target "rolling-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core", "ros", "rolling-core") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-core ros2-components ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core"
  }
}

target "rolling-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base", "ros", "rolling-base") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-base ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base"
  }
}

target "rolling-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception", "ros", "rolling-perception") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-perception ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception"
  }
}

target "rolling-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop", "ros", "rolling-desktop") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop"
  }
}

target "rolling-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full", "ros", "rolling-desktop-full") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside ros2-desktop-full ros2-components"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full"
  }
}

target "rolling-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run", "ros", "rolling-core-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "rolling-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run", "ros", "rolling-base-run") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "rolling-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-cuda-cu128", "ros-cuda", "rolling-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-cuda-cu128", "ros-cuda", "rolling-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-cuda-cu128", "ros-cuda", "rolling-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-cuda-cu128", "ros-cuda", "rolling-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-cuda-cu128", "ros-cuda", "rolling-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-cuda-cu128", "ros-cuda", "rolling-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-cuda-cu128", "ros-cuda", "rolling-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "rolling-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-cuda-cu130", "ros-cuda", "rolling-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-cuda-cu130", "ros-cuda", "rolling-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-cuda-cu130", "ros-cuda", "rolling-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-cuda-cu130", "ros-cuda", "rolling-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-cuda-cu130", "ros-cuda", "rolling-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-cuda-cu130", "ros-cuda", "rolling-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-cuda-cu130", "ros-cuda", "rolling-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-cuda-cu132", "ros-cuda", "rolling-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-cuda-cu132", "ros-cuda", "rolling-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-cuda-cu132", "ros-cuda", "rolling-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-cuda-cu132", "ros-cuda", "rolling-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-cuda-cu132", "ros-cuda", "rolling-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-cuda-cu132", "ros-cuda", "rolling-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-cuda-cu132", "ros-cuda", "rolling-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "rolling-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-cuda-cu121", "ros-cuda", "rolling-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda cuda-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-cuda-cu121", "ros-cuda", "rolling-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-cuda-cu121", "ros-cuda", "rolling-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-cuda-cu121", "ros-cuda", "rolling-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-cuda-cu121", "ros-cuda", "rolling-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-cuda-cu121", "ros-cuda", "rolling-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-cuda-cu121", "ros-cuda", "rolling-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "rolling-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-torch-cu128", "ros-torch", "rolling-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-torch-cu128", "ros-torch", "rolling-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-torch-cu128", "ros-torch", "rolling-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-torch-cu128", "ros-torch", "rolling-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-torch-cu128", "ros-torch", "rolling-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-torch-cu128", "ros-torch", "rolling-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-torch-cu128", "ros-torch", "rolling-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "rolling-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-torch-cu130", "ros-torch", "rolling-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-torch-cu130", "ros-torch", "rolling-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-torch-cu130", "ros-torch", "rolling-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-torch-cu130", "ros-torch", "rolling-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-torch-cu130", "ros-torch", "rolling-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-torch-cu130", "ros-torch", "rolling-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-torch-cu130", "ros-torch", "rolling-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-torch-cu132", "ros-torch", "rolling-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch cuda-build torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-torch-cu132", "ros-torch", "rolling-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-torch-cu132", "ros-torch", "rolling-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-torch-cu132", "ros-torch", "rolling-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-torch-cu132", "ros-torch", "rolling-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-torch-cu132", "ros-torch", "rolling-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-torch-cu132", "ros-torch", "rolling-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside cuda torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "rolling-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-torch-cpu", "ros-torch", "rolling-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch torch-build ros2-workspace pip"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core torch=2.10.0"
  }
}

target "rolling-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-torch-cpu", "ros-torch", "rolling-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base torch=2.10.0"
  }
}

target "rolling-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-perception-torch-cpu", "ros-torch", "rolling-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception torch=2.10.0"
  }
}

target "rolling-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-torch-cpu", "ros-torch", "rolling-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop torch=2.10.0"
  }
}

target "rolling-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-desktop-full-torch-cpu", "ros-torch", "rolling-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=ros-rolling-ros-core packages_base=ros-rolling-ros-base packages_perception=ros-rolling-perception packages_desktop=ros-rolling-desktop packages_desktop_full=ros-rolling-desktop-full torch=2.10.0"
  }
}

target "rolling-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-core-run-torch-cpu", "ros-torch", "rolling-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "rolling-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("rolling-base-run-torch-cpu", "ros-torch", "rolling-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros2 ros2-beside torch"
    EXPECT = "os=ubuntu-26.04 python=3.14 ros=2 ros_distro=rolling releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

# ---- ros1-bookworm --------------------------------------------------------------------------------------------------

target "ros1-bookworm-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core", "ros", "ros1-bookworm-core") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-core ros1-components ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev"
  }
}

target "ros1-bookworm-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base", "ros", "ros1-bookworm-base") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-base ros1-components"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev"
  }
}

target "ros1-bookworm-robot-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot", "ros", "ros1-bookworm-robot") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-robot ros1-components"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev"
  }
}

target "ros1-bookworm-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception", "ros", "ros1-bookworm-perception") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-perception ros1-components"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev"
  }
}

target "ros1-bookworm-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop", "ros", "ros1-bookworm-desktop") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop ros1-components"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev"
  }
}

target "ros1-bookworm-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full", "ros", "ros1-bookworm-desktop-full") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop-full ros1-components"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev"
  }
}

target "ros1-bookworm-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run", "ros", "ros1-bookworm-core-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "ros1-bookworm-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run", "ros", "ros1-bookworm-base-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "ros1-bookworm-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-cuda-cu128", "ros-cuda", "ros1-bookworm-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-cuda-cu128", "ros-cuda", "ros1-bookworm-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-cuda-cu128", "ros-cuda", "ros1-bookworm-robot-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-cuda-cu128", "ros-cuda", "ros1-bookworm-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-cuda-cu128", "ros-cuda", "ros1-bookworm-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-cuda-cu128", "ros-cuda", "ros1-bookworm-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-cuda-cu128", "ros-cuda", "ros1-bookworm-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-cuda-cu128", "ros-cuda", "ros1-bookworm-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-cuda-cu130", "ros-cuda", "ros1-bookworm-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-cuda-cu130", "ros-cuda", "ros1-bookworm-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-cuda-cu130", "ros-cuda", "ros1-bookworm-robot-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-cuda-cu130", "ros-cuda", "ros1-bookworm-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-cuda-cu130", "ros-cuda", "ros1-bookworm-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-cuda-cu130", "ros-cuda", "ros1-bookworm-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-cuda-cu130", "ros-cuda", "ros1-bookworm-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-cuda-cu130", "ros-cuda", "ros1-bookworm-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-cuda-cu132", "ros-cuda", "ros1-bookworm-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-cuda-cu132", "ros-cuda", "ros1-bookworm-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-robot-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-cuda-cu132", "ros-cuda", "ros1-bookworm-robot-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-cuda-cu132", "ros-cuda", "ros1-bookworm-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-cuda-cu132", "ros-cuda", "ros1-bookworm-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-cuda-cu132", "ros-cuda", "ros1-bookworm-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-cuda-cu132", "ros-cuda", "ros1-bookworm-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-cuda-cu132", "ros-cuda", "ros1-bookworm-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-cuda-cu121", "ros-cuda", "ros1-bookworm-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda cuda-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-cuda-cu121", "ros-cuda", "ros1-bookworm-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-cuda-cu121", "ros-cuda", "ros1-bookworm-robot-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-cuda-cu121", "ros-cuda", "ros1-bookworm-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-cuda-cu121", "ros-cuda", "ros1-bookworm-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-cuda-cu121", "ros-cuda", "ros1-bookworm-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-cuda-cu121", "ros-cuda", "ros1-bookworm-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-cuda-cu121", "ros-cuda", "ros1-bookworm-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-bookworm-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-cu128", "ros-torch", "ros1-bookworm-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-torch-cu128", "ros-torch", "ros1-bookworm-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-torch-cu128", "ros-torch", "ros1-bookworm-robot-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-torch-cu128", "ros-torch", "ros1-bookworm-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-torch-cu128", "ros-torch", "ros1-bookworm-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-torch-cu128", "ros-torch", "ros1-bookworm-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-torch-cu128", "ros-torch", "ros1-bookworm-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-torch-cu128", "ros-torch", "ros1-bookworm-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-bookworm-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-cu130", "ros-torch", "ros1-bookworm-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch cuda-build torch-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-torch-cu130", "ros-torch", "ros1-bookworm-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-robot-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-torch-cu130", "ros-torch", "ros1-bookworm-robot-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-torch-cu130", "ros-torch", "ros1-bookworm-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-torch-cu130", "ros-torch", "ros1-bookworm-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-torch-cu130", "ros-torch", "ros1-bookworm-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-torch-cu130", "ros-torch", "ros1-bookworm-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-torch-cu130", "ros-torch", "ros1-bookworm-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-cu132", "ros-torch", "ros1-bookworm-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch cuda-build torch-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-torch-cu132", "ros-torch", "ros1-bookworm-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-robot-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-torch-cu132", "ros-torch", "ros1-bookworm-robot-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-torch-cu132", "ros-torch", "ros1-bookworm-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-torch-cu132", "ros-torch", "ros1-bookworm-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-torch-cu132", "ros-torch", "ros1-bookworm-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-torch-cu132", "ros-torch", "ros1-bookworm-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-torch-cu132", "ros-torch", "ros1-bookworm-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-cpu", "ros-torch", "ros1-bookworm-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-torch-cpu", "ros-torch", "ros1-bookworm-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-robot-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-torch-cpu", "ros-torch", "ros1-bookworm-robot-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-torch-cpu", "ros-torch", "ros1-bookworm-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-torch-cpu", "ros-torch", "ros1-bookworm-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-torch-cpu", "ros-torch", "ros1-bookworm-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0"
  }
}

target "ros1-bookworm-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-torch-cpu", "ros-torch", "ros1-bookworm-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "ros1-bookworm-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-torch-cpu", "ros-torch", "ros1-bookworm-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "ros1-bookworm-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorflow-cu128", "ros-tf", "ros1-bookworm-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-tensorflow-cu128", "ros-tf", "ros1-bookworm-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-tensorflow-cu128", "ros-tf", "ros1-bookworm-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-tensorflow-cu128", "ros-tf", "ros1-bookworm-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-tensorflow-cu128", "ros-tf", "ros1-bookworm-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-tensorflow-cu128", "ros-tf", "ros1-bookworm-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-tensorflow-cu128", "ros-tf", "ros1-bookworm-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-tensorflow-cu128", "ros-tf", "ros1-bookworm-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorflow-cpu", "ros-tf", "ros1-bookworm-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow tensorflow-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-tensorflow-cpu", "ros-tf", "ros1-bookworm-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-tensorflow-cpu", "ros-tf", "ros1-bookworm-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-tensorflow-cpu", "ros-tf", "ros1-bookworm-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-tensorflow-cpu", "ros-tf", "ros1-bookworm-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-tensorflow-cpu", "ros-tf", "ros1-bookworm-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.21.0"
  }
}

target "ros1-bookworm-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-tensorflow-cpu", "ros-tf", "ros1-bookworm-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "ros1-bookworm-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-tensorflow-cpu", "ros-tf", "ros1-bookworm-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "ros1-bookworm-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-ml-cu128", "ros-ml", "ros1-bookworm-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-ml-cu128", "ros-ml", "ros1-bookworm-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-ml-cu128", "ros-ml", "ros1-bookworm-robot-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-ml-cu128", "ros-ml", "ros1-bookworm-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-ml-cu128", "ros-ml", "ros1-bookworm-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-ml-cu128", "ros-ml", "ros1-bookworm-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-ml-cu128", "ros-ml", "ros1-bookworm-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-ml-cu128", "ros-ml", "ros1-bookworm-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-bookworm-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-ml-cpu", "ros-ml", "ros1-bookworm-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow torch-build tensorflow-build ros1-workspace pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-ml-cpu", "ros-ml", "ros1-bookworm-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-robot-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-robot-ml-cpu", "ros-ml", "ros1-bookworm-robot-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-perception-ml-cpu", "ros-ml", "ros1-bookworm-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-ml-cpu", "ros-ml", "ros1-bookworm-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-desktop-full-ml-cpu", "ros-ml", "ros1-bookworm-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-run-ml-cpu", "ros-ml", "ros1-bookworm-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-run-ml-cpu", "ros-ml", "ros1-bookworm-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-bookworm-core-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-onnx-cu128", "ros-onnx", "ros1-bookworm-core-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-bookworm-base-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-onnx-cu128", "ros-onnx", "ros1-bookworm-base-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-bookworm-core-torch-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-onnx-cu128", "ros-torch-onnx", "ros1-bookworm-core-torch-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-bookworm-core-tensorflow-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorflow-onnx-cu128", "ros-tf-onnx", "ros1-bookworm-core-tensorflow-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-bookworm-core-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-onnx-cu130", "ros-onnx", "ros1-bookworm-core-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-bookworm-base-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-onnx-cu130", "ros-onnx", "ros1-bookworm-base-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-bookworm-core-torch-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-onnx-cu130", "ros-torch-onnx", "ros1-bookworm-core-torch-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-bookworm-core-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-onnx-cu132", "ros-onnx", "ros1-bookworm-core-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-bookworm-core-torch-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-onnx-cu132", "ros-torch-onnx", "ros1-bookworm-core-torch-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-bookworm-core-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-onnx-cpu", "ros-onnx", "ros1-bookworm-core-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.23.2"
  }
}

target "ros1-bookworm-base-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-base-onnx-cpu", "ros-onnx", "ros1-bookworm-base-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside onnxruntime"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev onnxruntime=1.23.2"
  }
}

target "ros1-bookworm-core-torch-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-onnx-cpu", "ros-torch-onnx", "ros1-bookworm-core-torch-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 onnxruntime=1.23.2"
  }
}

target "ros1-bookworm-core-tensorflow-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorflow-onnx-cpu", "ros-tf-onnx", "ros1-bookworm-core-tensorflow-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.21.0 onnxruntime=1.23.2"
  }
}

target "ros1-bookworm-core-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-devel-cu130", "ros-devel", "ros1-bookworm-core-devel-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-torch-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-devel-cu130", "ros-torch-devel", "ros1-bookworm-core-torch-devel-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch devel devel-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-devel-cu132", "ros-devel", "ros1-bookworm-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-torch-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-devel-cu132", "ros-torch-devel", "ros1-bookworm-core-torch-devel-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch devel devel-build pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-bookworm-core-triton-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-triton-cu128", "ros-triton", "ros1-bookworm-core-triton-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-bookworm-core-triton-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-triton-cu130", "ros-triton", "ros1-bookworm-core-triton-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-triton-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-triton-cu132", "ros-triton", "ros1-bookworm-core-triton-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-bookworm-core-triton-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-triton-cpu", "ros-triton", "ros1-bookworm-core-triton-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tritonclient pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0"
  }
}

target "ros1-bookworm-core-tensorrt-rtx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorrt-rtx-cu130", "ros-tensorrt-rtx", "ros1-bookworm-core-tensorrt-rtx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorrt-rtx pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorrt-rtx=1.7.1.116 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "ros1-bookworm-core-tensorrt-rtx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-tensorrt-rtx-cu132", "ros-tensorrt-rtx", "ros1-bookworm-core-tensorrt-rtx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorrt-rtx pip"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorrt-rtx=1.7.1.116 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "ros1-bookworm-core-torch-cu128-env-lerobot-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-bookworm-core-torch-cu128-env-lerobot", "ros-torch", "ros1-bookworm-core-torch-cu128-env-lerobot") }
  args = {
    TESTS  = "contract environment lerobot"
    EXPECT = "os=bookworm python=3.11 ros=1 ros_distro=Debian environment=lerobot releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

# ---- ros1-trixie ----------------------------------------------------------------------------------------------------

target "ros1-trixie-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core", "ros", "ros1-trixie-core") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-core ros1-components ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev"
  }
}

target "ros1-trixie-base-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base", "ros", "ros1-trixie-base") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-base ros1-components"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev"
  }
}

target "ros1-trixie-robot-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot", "ros", "ros1-trixie-robot") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-robot ros1-components"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev"
  }
}

target "ros1-trixie-perception-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception", "ros", "ros1-trixie-perception") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-perception ros1-components"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev"
  }
}

target "ros1-trixie-desktop-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop", "ros", "ros1-trixie-desktop") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop ros1-components"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev"
  }
}

target "ros1-trixie-desktop-full-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full", "ros", "ros1-trixie-desktop-full") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside ros1-desktop-full ros1-components"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev"
  }
}

target "ros1-trixie-core-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run", "ros", "ros1-trixie-core-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "ros1-trixie-base-run-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run", "ros", "ros1-trixie-base-run") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "ros1-trixie-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-cuda-cu128", "ros-cuda", "ros1-trixie-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-base-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-cuda-cu128", "ros-cuda", "ros1-trixie-base-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-robot-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-cuda-cu128", "ros-cuda", "ros1-trixie-robot-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-perception-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-cuda-cu128", "ros-cuda", "ros1-trixie-perception-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-desktop-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-cuda-cu128", "ros-cuda", "ros1-trixie-desktop-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-desktop-full-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-cuda-cu128", "ros-cuda", "ros1-trixie-desktop-full-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-core-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-cuda-cu128", "ros-cuda", "ros1-trixie-core-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-base-run-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-cuda-cu128", "ros-cuda", "ros1-trixie-base-run-cuda-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-cuda-cu130", "ros-cuda", "ros1-trixie-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-base-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-cuda-cu130", "ros-cuda", "ros1-trixie-base-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-robot-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-cuda-cu130", "ros-cuda", "ros1-trixie-robot-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-perception-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-cuda-cu130", "ros-cuda", "ros1-trixie-perception-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-desktop-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-cuda-cu130", "ros-cuda", "ros1-trixie-desktop-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-desktop-full-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-cuda-cu130", "ros-cuda", "ros1-trixie-desktop-full-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-cuda-cu130", "ros-cuda", "ros1-trixie-core-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-base-run-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-cuda-cu130", "ros-cuda", "ros1-trixie-base-run-cuda-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-cuda-cu132", "ros-cuda", "ros1-trixie-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-base-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-cuda-cu132", "ros-cuda", "ros1-trixie-base-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-robot-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-cuda-cu132", "ros-cuda", "ros1-trixie-robot-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-perception-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-cuda-cu132", "ros-cuda", "ros1-trixie-perception-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-desktop-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-cuda-cu132", "ros-cuda", "ros1-trixie-desktop-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-desktop-full-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-cuda-cu132", "ros-cuda", "ros1-trixie-desktop-full-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-cuda-cu132", "ros-cuda", "ros1-trixie-core-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-base-run-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-cuda-cu132", "ros-cuda", "ros1-trixie-base-run-cuda-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-cuda-cu121", "ros-cuda", "ros1-trixie-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda cuda-build ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-base-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-cuda-cu121", "ros-cuda", "ros1-trixie-base-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-robot-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-cuda-cu121", "ros-cuda", "ros1-trixie-robot-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-perception-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-cuda-cu121", "ros-cuda", "ros1-trixie-perception-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-desktop-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-cuda-cu121", "ros-cuda", "ros1-trixie-desktop-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-desktop-full-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-cuda-cu121", "ros-cuda", "ros1-trixie-desktop-full-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-core-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-cuda-cu121", "ros-cuda", "ros1-trixie-core-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-base-run-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-cuda-cu121", "ros-cuda", "ros1-trixie-base-run-cuda-cu121") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "ros1-trixie-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-cu128", "ros-torch", "ros1-trixie-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-base-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-torch-cu128", "ros-torch", "ros1-trixie-base-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-robot-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-torch-cu128", "ros-torch", "ros1-trixie-robot-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-perception-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-torch-cu128", "ros-torch", "ros1-trixie-perception-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-desktop-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-torch-cu128", "ros-torch", "ros1-trixie-desktop-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-desktop-full-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-torch-cu128", "ros-torch", "ros1-trixie-desktop-full-torch-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-core-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-torch-cu128", "ros-torch", "ros1-trixie-core-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-base-run-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-torch-cu128", "ros-torch", "ros1-trixie-base-run-torch-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "ros1-trixie-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-cu130", "ros-torch", "ros1-trixie-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch cuda-build torch-build ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-base-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-torch-cu130", "ros-torch", "ros1-trixie-base-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-robot-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-torch-cu130", "ros-torch", "ros1-trixie-robot-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-perception-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-torch-cu130", "ros-torch", "ros1-trixie-perception-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-desktop-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-torch-cu130", "ros-torch", "ros1-trixie-desktop-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-desktop-full-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-torch-cu130", "ros-torch", "ros1-trixie-desktop-full-torch-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-torch-cu130", "ros-torch", "ros1-trixie-core-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-base-run-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-torch-cu130", "ros-torch", "ros1-trixie-base-run-torch-cu130") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-cu132", "ros-torch", "ros1-trixie-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch cuda-build torch-build ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-base-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-torch-cu132", "ros-torch", "ros1-trixie-base-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-robot-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-torch-cu132", "ros-torch", "ros1-trixie-robot-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-perception-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-torch-cu132", "ros-torch", "ros1-trixie-perception-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-desktop-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-torch-cu132", "ros-torch", "ros1-trixie-desktop-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-desktop-full-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-torch-cu132", "ros-torch", "ros1-trixie-desktop-full-torch-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-torch-cu132", "ros-torch", "ros1-trixie-core-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-base-run-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-torch-cu132", "ros-torch", "ros1-trixie-base-run-torch-cu132") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-cpu", "ros-torch", "ros1-trixie-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-base-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-torch-cpu", "ros-torch", "ros1-trixie-base-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-robot-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-torch-cpu", "ros-torch", "ros1-trixie-robot-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-perception-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-torch-cpu", "ros-torch", "ros1-trixie-perception-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-desktop-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-torch-cpu", "ros-torch", "ros1-trixie-desktop-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-desktop-full-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-torch-cpu", "ros-torch", "ros1-trixie-desktop-full-torch-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0"
  }
}

target "ros1-trixie-core-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-torch-cpu", "ros-torch", "ros1-trixie-core-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "ros1-trixie-base-run-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-torch-cpu", "ros-torch", "ros1-trixie-base-run-torch-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "ros1-trixie-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorflow-cu128", "ros-tf", "ros1-trixie-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-base-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-tensorflow-cu128", "ros-tf", "ros1-trixie-base-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-robot-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-tensorflow-cu128", "ros-tf", "ros1-trixie-robot-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-perception-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-tensorflow-cu128", "ros-tf", "ros1-trixie-perception-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-desktop-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-tensorflow-cu128", "ros-tf", "ros1-trixie-desktop-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-desktop-full-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-tensorflow-cu128", "ros-tf", "ros1-trixie-desktop-full-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-core-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-tensorflow-cu128", "ros-tf", "ros1-trixie-core-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-base-run-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-tensorflow-cu128", "ros-tf", "ros1-trixie-base-run-tensorflow-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorflow-cpu", "ros-tf", "ros1-trixie-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-base-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-tensorflow-cpu", "ros-tf", "ros1-trixie-base-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-robot-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-tensorflow-cpu", "ros-tf", "ros1-trixie-robot-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-perception-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-tensorflow-cpu", "ros-tf", "ros1-trixie-perception-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-desktop-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-tensorflow-cpu", "ros-tf", "ros1-trixie-desktop-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-desktop-full-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-tensorflow-cpu", "ros-tf", "ros1-trixie-desktop-full-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev tensorflow=2.21.0"
  }
}

target "ros1-trixie-core-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-tensorflow-cpu", "ros-tf", "ros1-trixie-core-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "ros1-trixie-base-run-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-tensorflow-cpu", "ros-tf", "ros1-trixie-base-run-tensorflow-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "ros1-trixie-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-ml-cu128", "ros-ml", "ros1-trixie-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow cuda-build torch-build tensorflow-build ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-base-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-ml-cu128", "ros-ml", "ros1-trixie-base-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-robot-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-ml-cu128", "ros-ml", "ros1-trixie-robot-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-perception-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-ml-cu128", "ros-ml", "ros1-trixie-perception-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-desktop-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-ml-cu128", "ros-ml", "ros1-trixie-desktop-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-desktop-full-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-ml-cu128", "ros-ml", "ros1-trixie-desktop-full-ml-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-core-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-ml-cu128", "ros-ml", "ros1-trixie-core-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-base-run-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-ml-cu128", "ros-ml", "ros1-trixie-base-run-ml-cu128") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside cuda torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "ros1-trixie-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-ml-cpu", "ros-ml", "ros1-trixie-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow torch-build tensorflow-build ros1-workspace pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-base-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-ml-cpu", "ros-ml", "ros1-trixie-base-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-robot-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-robot-ml-cpu", "ros-ml", "ros1-trixie-robot-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-perception-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-perception-ml-cpu", "ros-ml", "ros1-trixie-perception-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-desktop-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-ml-cpu", "ros-ml", "ros1-trixie-desktop-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-desktop-full-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-desktop-full-ml-cpu", "ros-ml", "ros1-trixie-desktop-full-ml-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev packages_base=rosbash,ros-base,ros-base-dev,ros-base-python-dev packages_robot=rosbash,ros-robot,ros-robot-dev,ros-robot-python-dev packages_perception=rosbash,ros-perception,ros-perception-dev,ros-perception-python-dev packages_desktop=rosbash,ros-desktop,ros-desktop-dev,ros-desktop-python-dev packages_desktop_full=rosbash,ros-desktop-full,ros-desktop-full-dev,ros-desktop-full-python-dev torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-core-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-run-ml-cpu", "ros-ml", "ros1-trixie-core-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-base-run-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-base-run-ml-cpu", "ros-ml", "ros1-trixie-base-run-ml-cpu") }
  args = {
    TESTS  = "contract runtime ros1 ros1-beside torch tensorflow"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

target "ros1-trixie-core-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-onnx-cu128", "ros-onnx", "ros1-trixie-core-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-trixie-core-torch-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-onnx-cu128", "ros-torch-onnx", "ros1-trixie-core-torch-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-trixie-core-tensorflow-onnx-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorflow-onnx-cu128", "ros-tf-onnx", "ros1-trixie-core-tensorflow-onnx-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.20.0 onnxruntime=1.23.2 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90 gpu_onnxruntime_amd64=sm_60,sm_70,sm_75,sm_80,sm_86,sm_90a,compute_90"
  }
}

target "ros1-trixie-core-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-onnx-cu130", "ros-onnx", "ros1-trixie-core-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-trixie-core-torch-onnx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-onnx-cu130", "ros-torch-onnx", "ros1-trixie-core-torch-onnx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 onnxruntime=1.31.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-trixie-core-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-onnx-cu132", "ros-onnx", "ros1-trixie-core-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-trixie-core-torch-onnx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-onnx-cu132", "ros-torch-onnx", "ros1-trixie-core-torch-onnx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 onnxruntime=1.31.1 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120 gpu_onnxruntime_amd64=sm_75,sm_80,sm_86,sm_89,sm_90a,sm_120a gpu_onnxruntime_arm64=sm_89,sm_90a,sm_120a,sm_121a"
  }
}

target "ros1-trixie-core-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-onnx-cpu", "ros-onnx", "ros1-trixie-core-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev onnxruntime=1.23.2"
  }
}

target "ros1-trixie-core-torch-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-onnx-cpu", "ros-torch-onnx", "ros1-trixie-core-torch-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside torch onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.10.0 onnxruntime=1.23.2"
  }
}

target "ros1-trixie-core-tensorflow-onnx-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorflow-onnx-cpu", "ros-tf-onnx", "ros1-trixie-core-tensorflow-onnx-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tensorflow onnxruntime onnxruntime-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorflow=2.21.0 onnxruntime=1.23.2"
  }
}

target "ros1-trixie-core-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-devel-cu130", "ros-devel", "ros1-trixie-core-devel-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-torch-devel-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-devel-cu130", "ros-torch-devel", "ros1-trixie-core-torch-devel-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch devel devel-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-devel-cu132", "ros-devel", "ros1-trixie-core-devel-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda devel devel-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-torch-devel-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-torch-devel-cu132", "ros-torch-devel", "ros1-trixie-core-torch-devel-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda torch devel devel-build pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "ros1-trixie-core-triton-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-triton-cu128", "ros-triton", "ros1-trixie-core-triton-cu128") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "ros1-trixie-core-triton-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-triton-cu130", "ros-triton", "ros1-trixie-core-triton-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-triton-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-triton-cu132", "ros-triton", "ros1-trixie-core-triton-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tritonclient pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "ros1-trixie-core-triton-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-triton-cpu", "ros-triton", "ros1-trixie-core-triton-cpu") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside tritonclient pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tritonclient=2.73.0"
  }
}

target "ros1-trixie-core-tensorrt-rtx-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorrt-rtx-cu130", "ros-tensorrt-rtx", "ros1-trixie-core-tensorrt-rtx-cu130") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorrt-rtx pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorrt-rtx=1.7.1.116 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

target "ros1-trixie-core-tensorrt-rtx-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64", "linux/arm64"] : [PLATFORM]
  contexts  = { image = dependency("ros1-trixie-core-tensorrt-rtx-cu132", "ros-tensorrt-rtx", "ros1-trixie-core-tensorrt-rtx-cu132") }
  args = {
    TESTS  = "contract tools ros1 ros1-beside cuda tensorrt-rtx pip"
    EXPECT = "os=trixie python=3.13 ros=1 ros_distro=Debian releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx packages_core=rosbash,ros-core,ros-core-dev,ros-core-python-dev tensorrt-rtx=1.7.1.116 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 tensorrt-rtx-cu13-libs=1.7.1.116 gpu_driver=580"
  }
}

# ---- jazzy-wheels ---------------------------------------------------------------------------------------------------

target "jazzy-wheels-core-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core", "ros", "jazzy-wheels-core") }
  args = {
    TESTS  = "contract tools ros2-wheels pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx"
  }
}

target "jazzy-wheels-core-cuda-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-cuda-cu128", "ros-cuda", "jazzy-wheels-core-cuda-cu128") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525"
  }
}

target "jazzy-wheels-core-cuda-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-cuda-cu130", "ros-cuda", "jazzy-wheels-core-cuda-cu130") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-wheels-core-cuda-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-cuda-cu132", "ros-cuda", "jazzy-wheels-core-cuda-cu132") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 gpu_driver=580"
  }
}

target "jazzy-wheels-core-cuda-cu121-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-cuda-cu121", "ros-cuda", "jazzy-wheels-core-cuda-cu121") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda cuda-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx cuda=12.1.105 cudnn=9.1.0.70 nccl=2.20.5 gpu_driver=525"
  }
}

target "jazzy-wheels-core-torch-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-torch-cu128", "ros-torch", "jazzy-wheels-core-torch-cu128") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda torch"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120"
  }
}

target "jazzy-wheels-core-torch-cu130-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-torch-cu130", "ros-torch", "jazzy-wheels-core-torch-cu130") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda torch cuda-build torch-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.14.1 cuda=13.0.96 cudnn=9.24.0.43 nccl=2.30.7 torchaudio=2.11.0 torchvision=0.29.1 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-wheels-core-torch-cu132-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-torch-cu132", "ros-torch", "jazzy-wheels-core-torch-cu132") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda torch cuda-build torch-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.15.0 cuda=13.2.86 cudnn=9.26.0.51 nccl=2.30.7 torchvision=0.29.2 gpu_driver=580 gpu_torch_amd64=sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_torch_arm64=sm_80,sm_90,sm_100,sm_110,sm_120"
  }
}

target "jazzy-wheels-core-torch-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-torch-cpu", "ros-torch", "jazzy-wheels-core-torch-cpu") }
  args = {
    TESTS  = "contract tools ros2-wheels torch"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0"
  }
}

target "jazzy-wheels-core-tensorflow-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-tensorflow-cu128", "ros-tf", "jazzy-wheels-core-tensorflow-cu128") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda tensorflow"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 gpu_driver=525 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-wheels-core-tensorflow-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-tensorflow-cpu", "ros-tf", "jazzy-wheels-core-tensorflow-cpu") }
  args = {
    TESTS  = "contract tools ros2-wheels tensorflow tensorflow-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx tensorflow=2.21.0"
  }
}

target "jazzy-wheels-core-ml-cu128-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-ml-cu128", "ros-ml", "jazzy-wheels-core-ml-cu128") }
  args = {
    TESTS  = "contract tools ros2-wheels cuda torch tensorflow cuda-build torch-build tensorflow-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.20.0 cuda=12.8.90 cudnn=9.10.2.21 nccl=2.27.5 torchaudio=2.10.0 torchvision=0.25.0 gpu_driver=525 gpu_torch_amd64=sm_70,sm_75,sm_80,sm_86,sm_90,sm_100,sm_120 gpu_tensorflow_amd64=sm_60,sm_70,sm_80,sm_89,compute_90"
  }
}

target "jazzy-wheels-core-ml-cpu-test" {
  inherits  = ["_test"]
  platforms = PLATFORM == "" ? ["linux/amd64"] : [PLATFORM]
  contexts  = { image = dependency("jazzy-wheels-core-ml-cpu", "ros-ml", "jazzy-wheels-core-ml-cpu") }
  args = {
    TESTS  = "contract tools ros2-wheels torch tensorflow torch-build tensorflow-build pip"
    EXPECT = "os=bookworm python=3.11 ros=2 ros_distro=jazzy wheels=ros-jazzy-rclpy==7.1.6,ros-sensor-msgs==5.3.6,ros-std-msgs==5.3.6 releases=torch,tensorflow,onnxruntime,tritonclient,tensorrt-rtx torch=2.10.0 tensorflow=2.21.0"
  }
}

# ---- Groups ---------------------------------------------------------------------------------------------------------

group "tests" {
  targets = [
    "noetic-core-test", "noetic-base-test", "noetic-robot-test", "noetic-perception-test", "noetic-desktop-test", "noetic-desktop-full-test", "noetic-core-run-test", "noetic-base-run-test", "noetic-core-cuda-cu128-test", "noetic-base-cuda-cu128-test", "noetic-robot-cuda-cu128-test", "noetic-perception-cuda-cu128-test", "noetic-desktop-cuda-cu128-test", "noetic-desktop-full-cuda-cu128-test", "noetic-core-run-cuda-cu128-test", "noetic-base-run-cuda-cu128-test", "noetic-core-cuda-cu130-test", "noetic-base-cuda-cu130-test", "noetic-robot-cuda-cu130-test", "noetic-perception-cuda-cu130-test", "noetic-desktop-cuda-cu130-test", "noetic-desktop-full-cuda-cu130-test", "noetic-core-run-cuda-cu130-test", "noetic-base-run-cuda-cu130-test", "noetic-core-cuda-cu132-test", "noetic-base-cuda-cu132-test", "noetic-robot-cuda-cu132-test", "noetic-perception-cuda-cu132-test", "noetic-desktop-cuda-cu132-test", "noetic-desktop-full-cuda-cu132-test", "noetic-core-run-cuda-cu132-test", "noetic-base-run-cuda-cu132-test", "noetic-core-cuda-cu121-test", "noetic-base-cuda-cu121-test", "noetic-robot-cuda-cu121-test", "noetic-perception-cuda-cu121-test", "noetic-desktop-cuda-cu121-test", "noetic-desktop-full-cuda-cu121-test", "noetic-core-run-cuda-cu121-test", "noetic-base-run-cuda-cu121-test", "noetic-core-torch-cu121-test", "noetic-base-torch-cu121-test", "noetic-robot-torch-cu121-test", "noetic-perception-torch-cu121-test", "noetic-desktop-torch-cu121-test", "noetic-desktop-full-torch-cu121-test", "noetic-core-run-torch-cu121-test", "noetic-base-run-torch-cu121-test", "noetic-core-tensorflow-cpu38-test", "noetic-base-tensorflow-cpu38-test", "noetic-robot-tensorflow-cpu38-test", "noetic-perception-tensorflow-cpu38-test", "noetic-desktop-tensorflow-cpu38-test", "noetic-desktop-full-tensorflow-cpu38-test", "noetic-core-run-tensorflow-cpu38-test", "noetic-base-run-tensorflow-cpu38-test",
    "foxy-core-test", "foxy-base-test", "foxy-desktop-test", "foxy-core-run-test", "foxy-base-run-test", "foxy-core-cuda-cu128-test", "foxy-base-cuda-cu128-test", "foxy-desktop-cuda-cu128-test", "foxy-core-run-cuda-cu128-test", "foxy-base-run-cuda-cu128-test", "foxy-core-cuda-cu130-test", "foxy-base-cuda-cu130-test", "foxy-desktop-cuda-cu130-test", "foxy-core-run-cuda-cu130-test", "foxy-base-run-cuda-cu130-test", "foxy-core-cuda-cu132-test", "foxy-base-cuda-cu132-test", "foxy-desktop-cuda-cu132-test", "foxy-core-run-cuda-cu132-test", "foxy-base-run-cuda-cu132-test", "foxy-core-cuda-cu121-test", "foxy-base-cuda-cu121-test", "foxy-desktop-cuda-cu121-test", "foxy-core-run-cuda-cu121-test", "foxy-base-run-cuda-cu121-test", "foxy-core-torch-cu121-test", "foxy-base-torch-cu121-test", "foxy-desktop-torch-cu121-test", "foxy-core-run-torch-cu121-test", "foxy-base-run-torch-cu121-test", "foxy-core-tensorflow-cpu38-test", "foxy-base-tensorflow-cpu38-test", "foxy-desktop-tensorflow-cpu38-test", "foxy-core-run-tensorflow-cpu38-test", "foxy-base-run-tensorflow-cpu38-test",
    "humble-core-test", "humble-base-test", "humble-perception-test", "humble-desktop-test", "humble-desktop-full-test", "humble-core-run-test", "humble-base-run-test", "humble-core-cuda-cu128-test", "humble-base-cuda-cu128-test", "humble-perception-cuda-cu128-test", "humble-desktop-cuda-cu128-test", "humble-desktop-full-cuda-cu128-test", "humble-core-run-cuda-cu128-test", "humble-base-run-cuda-cu128-test", "humble-core-cuda-cu130-test", "humble-base-cuda-cu130-test", "humble-perception-cuda-cu130-test", "humble-desktop-cuda-cu130-test", "humble-desktop-full-cuda-cu130-test", "humble-core-run-cuda-cu130-test", "humble-base-run-cuda-cu130-test", "humble-core-cuda-cu132-test", "humble-base-cuda-cu132-test", "humble-perception-cuda-cu132-test", "humble-desktop-cuda-cu132-test", "humble-desktop-full-cuda-cu132-test", "humble-core-run-cuda-cu132-test", "humble-base-run-cuda-cu132-test", "humble-core-cuda-cu121-test", "humble-base-cuda-cu121-test", "humble-perception-cuda-cu121-test", "humble-desktop-cuda-cu121-test", "humble-desktop-full-cuda-cu121-test", "humble-core-run-cuda-cu121-test", "humble-base-run-cuda-cu121-test", "humble-core-torch-cu128-test", "humble-base-torch-cu128-test", "humble-perception-torch-cu128-test", "humble-desktop-torch-cu128-test", "humble-desktop-full-torch-cu128-test", "humble-core-run-torch-cu128-test", "humble-base-run-torch-cu128-test", "humble-core-torch-cu130-test", "humble-base-torch-cu130-test", "humble-perception-torch-cu130-test", "humble-desktop-torch-cu130-test", "humble-desktop-full-torch-cu130-test", "humble-core-run-torch-cu130-test", "humble-base-run-torch-cu130-test", "humble-core-torch-cpu-test", "humble-base-torch-cpu-test", "humble-perception-torch-cpu-test", "humble-desktop-torch-cpu-test", "humble-desktop-full-torch-cpu-test", "humble-core-run-torch-cpu-test", "humble-base-run-torch-cpu-test", "humble-core-tensorflow-cu128-test", "humble-base-tensorflow-cu128-test", "humble-perception-tensorflow-cu128-test", "humble-desktop-tensorflow-cu128-test", "humble-desktop-full-tensorflow-cu128-test", "humble-core-run-tensorflow-cu128-test", "humble-base-run-tensorflow-cu128-test", "humble-core-tensorflow-cpu-test", "humble-base-tensorflow-cpu-test", "humble-perception-tensorflow-cpu-test", "humble-desktop-tensorflow-cpu-test", "humble-desktop-full-tensorflow-cpu-test", "humble-core-run-tensorflow-cpu-test", "humble-base-run-tensorflow-cpu-test", "humble-core-ml-cu128-test", "humble-base-ml-cu128-test", "humble-perception-ml-cu128-test", "humble-desktop-ml-cu128-test", "humble-desktop-full-ml-cu128-test", "humble-core-run-ml-cu128-test", "humble-base-run-ml-cu128-test", "humble-core-ml-cpu-test", "humble-base-ml-cpu-test", "humble-perception-ml-cpu-test", "humble-desktop-ml-cpu-test", "humble-desktop-full-ml-cpu-test", "humble-core-run-ml-cpu-test", "humble-base-run-ml-cpu-test",
    "iron-core-test", "iron-base-test", "iron-perception-test", "iron-desktop-test", "iron-desktop-full-test", "iron-core-run-test", "iron-base-run-test", "iron-core-cuda-cu128-test", "iron-base-cuda-cu128-test", "iron-perception-cuda-cu128-test", "iron-desktop-cuda-cu128-test", "iron-desktop-full-cuda-cu128-test", "iron-core-run-cuda-cu128-test", "iron-base-run-cuda-cu128-test", "iron-core-cuda-cu130-test", "iron-base-cuda-cu130-test", "iron-perception-cuda-cu130-test", "iron-desktop-cuda-cu130-test", "iron-desktop-full-cuda-cu130-test", "iron-core-run-cuda-cu130-test", "iron-base-run-cuda-cu130-test", "iron-core-cuda-cu132-test", "iron-base-cuda-cu132-test", "iron-perception-cuda-cu132-test", "iron-desktop-cuda-cu132-test", "iron-desktop-full-cuda-cu132-test", "iron-core-run-cuda-cu132-test", "iron-base-run-cuda-cu132-test", "iron-core-cuda-cu121-test", "iron-base-cuda-cu121-test", "iron-perception-cuda-cu121-test", "iron-desktop-cuda-cu121-test", "iron-desktop-full-cuda-cu121-test", "iron-core-run-cuda-cu121-test", "iron-base-run-cuda-cu121-test", "iron-core-torch-cu128-test", "iron-base-torch-cu128-test", "iron-perception-torch-cu128-test", "iron-desktop-torch-cu128-test", "iron-desktop-full-torch-cu128-test", "iron-core-run-torch-cu128-test", "iron-base-run-torch-cu128-test", "iron-core-torch-cu130-test", "iron-base-torch-cu130-test", "iron-perception-torch-cu130-test", "iron-desktop-torch-cu130-test", "iron-desktop-full-torch-cu130-test", "iron-core-run-torch-cu130-test", "iron-base-run-torch-cu130-test", "iron-core-torch-cpu-test", "iron-base-torch-cpu-test", "iron-perception-torch-cpu-test", "iron-desktop-torch-cpu-test", "iron-desktop-full-torch-cpu-test", "iron-core-run-torch-cpu-test", "iron-base-run-torch-cpu-test", "iron-core-tensorflow-cu128-test", "iron-base-tensorflow-cu128-test", "iron-perception-tensorflow-cu128-test", "iron-desktop-tensorflow-cu128-test", "iron-desktop-full-tensorflow-cu128-test", "iron-core-run-tensorflow-cu128-test", "iron-base-run-tensorflow-cu128-test", "iron-core-tensorflow-cpu-test", "iron-base-tensorflow-cpu-test", "iron-perception-tensorflow-cpu-test", "iron-desktop-tensorflow-cpu-test", "iron-desktop-full-tensorflow-cpu-test", "iron-core-run-tensorflow-cpu-test", "iron-base-run-tensorflow-cpu-test", "iron-core-ml-cu128-test", "iron-base-ml-cu128-test", "iron-perception-ml-cu128-test", "iron-desktop-ml-cu128-test", "iron-desktop-full-ml-cu128-test", "iron-core-run-ml-cu128-test", "iron-base-run-ml-cu128-test", "iron-core-ml-cpu-test", "iron-base-ml-cpu-test", "iron-perception-ml-cpu-test", "iron-desktop-ml-cpu-test", "iron-desktop-full-ml-cpu-test", "iron-core-run-ml-cpu-test", "iron-base-run-ml-cpu-test",
    "jazzy-core-test", "jazzy-base-test", "jazzy-perception-test", "jazzy-desktop-test", "jazzy-desktop-full-test", "jazzy-core-run-test", "jazzy-base-run-test", "jazzy-core-cuda-cu128-test", "jazzy-base-cuda-cu128-test", "jazzy-perception-cuda-cu128-test", "jazzy-desktop-cuda-cu128-test", "jazzy-desktop-full-cuda-cu128-test", "jazzy-core-run-cuda-cu128-test", "jazzy-base-run-cuda-cu128-test", "jazzy-core-cuda-cu130-test", "jazzy-base-cuda-cu130-test", "jazzy-perception-cuda-cu130-test", "jazzy-desktop-cuda-cu130-test", "jazzy-desktop-full-cuda-cu130-test", "jazzy-core-run-cuda-cu130-test", "jazzy-base-run-cuda-cu130-test", "jazzy-core-cuda-cu132-test", "jazzy-base-cuda-cu132-test", "jazzy-perception-cuda-cu132-test", "jazzy-desktop-cuda-cu132-test", "jazzy-desktop-full-cuda-cu132-test", "jazzy-core-run-cuda-cu132-test", "jazzy-base-run-cuda-cu132-test", "jazzy-core-cuda-cu121-test", "jazzy-base-cuda-cu121-test", "jazzy-perception-cuda-cu121-test", "jazzy-desktop-cuda-cu121-test", "jazzy-desktop-full-cuda-cu121-test", "jazzy-core-run-cuda-cu121-test", "jazzy-base-run-cuda-cu121-test", "jazzy-core-torch-cu128-test", "jazzy-base-torch-cu128-test", "jazzy-perception-torch-cu128-test", "jazzy-desktop-torch-cu128-test", "jazzy-desktop-full-torch-cu128-test", "jazzy-core-run-torch-cu128-test", "jazzy-base-run-torch-cu128-test", "jazzy-core-torch-cu130-test", "jazzy-base-torch-cu130-test", "jazzy-perception-torch-cu130-test", "jazzy-desktop-torch-cu130-test", "jazzy-desktop-full-torch-cu130-test", "jazzy-core-run-torch-cu130-test", "jazzy-base-run-torch-cu130-test", "jazzy-core-torch-cu132-test", "jazzy-base-torch-cu132-test", "jazzy-perception-torch-cu132-test", "jazzy-desktop-torch-cu132-test", "jazzy-desktop-full-torch-cu132-test", "jazzy-core-run-torch-cu132-test", "jazzy-base-run-torch-cu132-test", "jazzy-core-torch-cpu-test", "jazzy-base-torch-cpu-test", "jazzy-perception-torch-cpu-test", "jazzy-desktop-torch-cpu-test", "jazzy-desktop-full-torch-cpu-test", "jazzy-core-run-torch-cpu-test", "jazzy-base-run-torch-cpu-test", "jazzy-core-tensorflow-cu128-test", "jazzy-base-tensorflow-cu128-test", "jazzy-perception-tensorflow-cu128-test", "jazzy-desktop-tensorflow-cu128-test", "jazzy-desktop-full-tensorflow-cu128-test", "jazzy-core-run-tensorflow-cu128-test", "jazzy-base-run-tensorflow-cu128-test", "jazzy-core-tensorflow-cpu-test", "jazzy-base-tensorflow-cpu-test", "jazzy-perception-tensorflow-cpu-test", "jazzy-desktop-tensorflow-cpu-test", "jazzy-desktop-full-tensorflow-cpu-test", "jazzy-core-run-tensorflow-cpu-test", "jazzy-base-run-tensorflow-cpu-test", "jazzy-core-ml-cu128-test", "jazzy-base-ml-cu128-test", "jazzy-perception-ml-cu128-test", "jazzy-desktop-ml-cu128-test", "jazzy-desktop-full-ml-cu128-test", "jazzy-core-run-ml-cu128-test", "jazzy-base-run-ml-cu128-test", "jazzy-core-ml-cpu-test", "jazzy-base-ml-cpu-test", "jazzy-perception-ml-cpu-test", "jazzy-desktop-ml-cpu-test", "jazzy-desktop-full-ml-cpu-test", "jazzy-core-run-ml-cpu-test", "jazzy-base-run-ml-cpu-test",
    "kilted-core-test", "kilted-base-test", "kilted-perception-test", "kilted-desktop-test", "kilted-desktop-full-test", "kilted-core-run-test", "kilted-base-run-test", "kilted-core-cuda-cu128-test", "kilted-base-cuda-cu128-test", "kilted-perception-cuda-cu128-test", "kilted-desktop-cuda-cu128-test", "kilted-desktop-full-cuda-cu128-test", "kilted-core-run-cuda-cu128-test", "kilted-base-run-cuda-cu128-test", "kilted-core-cuda-cu130-test", "kilted-base-cuda-cu130-test", "kilted-perception-cuda-cu130-test", "kilted-desktop-cuda-cu130-test", "kilted-desktop-full-cuda-cu130-test", "kilted-core-run-cuda-cu130-test", "kilted-base-run-cuda-cu130-test", "kilted-core-cuda-cu132-test", "kilted-base-cuda-cu132-test", "kilted-perception-cuda-cu132-test", "kilted-desktop-cuda-cu132-test", "kilted-desktop-full-cuda-cu132-test", "kilted-core-run-cuda-cu132-test", "kilted-base-run-cuda-cu132-test", "kilted-core-cuda-cu121-test", "kilted-base-cuda-cu121-test", "kilted-perception-cuda-cu121-test", "kilted-desktop-cuda-cu121-test", "kilted-desktop-full-cuda-cu121-test", "kilted-core-run-cuda-cu121-test", "kilted-base-run-cuda-cu121-test", "kilted-core-torch-cu128-test", "kilted-base-torch-cu128-test", "kilted-perception-torch-cu128-test", "kilted-desktop-torch-cu128-test", "kilted-desktop-full-torch-cu128-test", "kilted-core-run-torch-cu128-test", "kilted-base-run-torch-cu128-test", "kilted-core-torch-cu130-test", "kilted-base-torch-cu130-test", "kilted-perception-torch-cu130-test", "kilted-desktop-torch-cu130-test", "kilted-desktop-full-torch-cu130-test", "kilted-core-run-torch-cu130-test", "kilted-base-run-torch-cu130-test", "kilted-core-torch-cu132-test", "kilted-base-torch-cu132-test", "kilted-perception-torch-cu132-test", "kilted-desktop-torch-cu132-test", "kilted-desktop-full-torch-cu132-test", "kilted-core-run-torch-cu132-test", "kilted-base-run-torch-cu132-test", "kilted-core-torch-cpu-test", "kilted-base-torch-cpu-test", "kilted-perception-torch-cpu-test", "kilted-desktop-torch-cpu-test", "kilted-desktop-full-torch-cpu-test", "kilted-core-run-torch-cpu-test", "kilted-base-run-torch-cpu-test", "kilted-core-tensorflow-cu128-test", "kilted-base-tensorflow-cu128-test", "kilted-perception-tensorflow-cu128-test", "kilted-desktop-tensorflow-cu128-test", "kilted-desktop-full-tensorflow-cu128-test", "kilted-core-run-tensorflow-cu128-test", "kilted-base-run-tensorflow-cu128-test", "kilted-core-tensorflow-cpu-test", "kilted-base-tensorflow-cpu-test", "kilted-perception-tensorflow-cpu-test", "kilted-desktop-tensorflow-cpu-test", "kilted-desktop-full-tensorflow-cpu-test", "kilted-core-run-tensorflow-cpu-test", "kilted-base-run-tensorflow-cpu-test", "kilted-core-ml-cu128-test", "kilted-base-ml-cu128-test", "kilted-perception-ml-cu128-test", "kilted-desktop-ml-cu128-test", "kilted-desktop-full-ml-cu128-test", "kilted-core-run-ml-cu128-test", "kilted-base-run-ml-cu128-test", "kilted-core-ml-cpu-test", "kilted-base-ml-cpu-test", "kilted-perception-ml-cpu-test", "kilted-desktop-ml-cpu-test", "kilted-desktop-full-ml-cpu-test", "kilted-core-run-ml-cpu-test", "kilted-base-run-ml-cpu-test",
    "lyrical-core-test", "lyrical-base-test", "lyrical-perception-test", "lyrical-desktop-test", "lyrical-desktop-full-test", "lyrical-core-run-test", "lyrical-base-run-test", "lyrical-core-cuda-cu128-test", "lyrical-base-cuda-cu128-test", "lyrical-perception-cuda-cu128-test", "lyrical-desktop-cuda-cu128-test", "lyrical-desktop-full-cuda-cu128-test", "lyrical-core-run-cuda-cu128-test", "lyrical-base-run-cuda-cu128-test", "lyrical-core-cuda-cu130-test", "lyrical-base-cuda-cu130-test", "lyrical-perception-cuda-cu130-test", "lyrical-desktop-cuda-cu130-test", "lyrical-desktop-full-cuda-cu130-test", "lyrical-core-run-cuda-cu130-test", "lyrical-base-run-cuda-cu130-test", "lyrical-core-cuda-cu132-test", "lyrical-base-cuda-cu132-test", "lyrical-perception-cuda-cu132-test", "lyrical-desktop-cuda-cu132-test", "lyrical-desktop-full-cuda-cu132-test", "lyrical-core-run-cuda-cu132-test", "lyrical-base-run-cuda-cu132-test", "lyrical-core-cuda-cu121-test", "lyrical-base-cuda-cu121-test", "lyrical-perception-cuda-cu121-test", "lyrical-desktop-cuda-cu121-test", "lyrical-desktop-full-cuda-cu121-test", "lyrical-core-run-cuda-cu121-test", "lyrical-base-run-cuda-cu121-test", "lyrical-core-torch-cu128-test", "lyrical-base-torch-cu128-test", "lyrical-perception-torch-cu128-test", "lyrical-desktop-torch-cu128-test", "lyrical-desktop-full-torch-cu128-test", "lyrical-core-run-torch-cu128-test", "lyrical-base-run-torch-cu128-test", "lyrical-core-torch-cu130-test", "lyrical-base-torch-cu130-test", "lyrical-perception-torch-cu130-test", "lyrical-desktop-torch-cu130-test", "lyrical-desktop-full-torch-cu130-test", "lyrical-core-run-torch-cu130-test", "lyrical-base-run-torch-cu130-test", "lyrical-core-torch-cu132-test", "lyrical-base-torch-cu132-test", "lyrical-perception-torch-cu132-test", "lyrical-desktop-torch-cu132-test", "lyrical-desktop-full-torch-cu132-test", "lyrical-core-run-torch-cu132-test", "lyrical-base-run-torch-cu132-test",
    "rolling-core-test", "rolling-base-test", "rolling-perception-test", "rolling-desktop-test", "rolling-desktop-full-test", "rolling-core-run-test", "rolling-base-run-test", "rolling-core-cuda-cu128-test", "rolling-base-cuda-cu128-test", "rolling-perception-cuda-cu128-test", "rolling-desktop-cuda-cu128-test", "rolling-desktop-full-cuda-cu128-test", "rolling-core-run-cuda-cu128-test", "rolling-base-run-cuda-cu128-test", "rolling-core-cuda-cu130-test", "rolling-base-cuda-cu130-test", "rolling-perception-cuda-cu130-test", "rolling-desktop-cuda-cu130-test", "rolling-desktop-full-cuda-cu130-test", "rolling-core-run-cuda-cu130-test", "rolling-base-run-cuda-cu130-test", "rolling-core-cuda-cu132-test", "rolling-base-cuda-cu132-test", "rolling-perception-cuda-cu132-test", "rolling-desktop-cuda-cu132-test", "rolling-desktop-full-cuda-cu132-test", "rolling-core-run-cuda-cu132-test", "rolling-base-run-cuda-cu132-test", "rolling-core-cuda-cu121-test", "rolling-base-cuda-cu121-test", "rolling-perception-cuda-cu121-test", "rolling-desktop-cuda-cu121-test", "rolling-desktop-full-cuda-cu121-test", "rolling-core-run-cuda-cu121-test", "rolling-base-run-cuda-cu121-test", "rolling-core-torch-cu128-test", "rolling-base-torch-cu128-test", "rolling-perception-torch-cu128-test", "rolling-desktop-torch-cu128-test", "rolling-desktop-full-torch-cu128-test", "rolling-core-run-torch-cu128-test", "rolling-base-run-torch-cu128-test", "rolling-core-torch-cu130-test", "rolling-base-torch-cu130-test", "rolling-perception-torch-cu130-test", "rolling-desktop-torch-cu130-test", "rolling-desktop-full-torch-cu130-test", "rolling-core-run-torch-cu130-test", "rolling-base-run-torch-cu130-test", "rolling-core-torch-cu132-test", "rolling-base-torch-cu132-test", "rolling-perception-torch-cu132-test", "rolling-desktop-torch-cu132-test", "rolling-desktop-full-torch-cu132-test", "rolling-core-run-torch-cu132-test", "rolling-base-run-torch-cu132-test",
    "ros1-bookworm-core-test", "ros1-bookworm-base-test", "ros1-bookworm-robot-test", "ros1-bookworm-perception-test", "ros1-bookworm-desktop-test", "ros1-bookworm-desktop-full-test", "ros1-bookworm-core-run-test", "ros1-bookworm-base-run-test", "ros1-bookworm-core-cuda-cu128-test", "ros1-bookworm-base-cuda-cu128-test", "ros1-bookworm-robot-cuda-cu128-test", "ros1-bookworm-perception-cuda-cu128-test", "ros1-bookworm-desktop-cuda-cu128-test", "ros1-bookworm-desktop-full-cuda-cu128-test", "ros1-bookworm-core-run-cuda-cu128-test", "ros1-bookworm-base-run-cuda-cu128-test", "ros1-bookworm-core-cuda-cu130-test", "ros1-bookworm-base-cuda-cu130-test", "ros1-bookworm-robot-cuda-cu130-test", "ros1-bookworm-perception-cuda-cu130-test", "ros1-bookworm-desktop-cuda-cu130-test", "ros1-bookworm-desktop-full-cuda-cu130-test", "ros1-bookworm-core-run-cuda-cu130-test", "ros1-bookworm-base-run-cuda-cu130-test", "ros1-bookworm-core-cuda-cu132-test", "ros1-bookworm-base-cuda-cu132-test", "ros1-bookworm-robot-cuda-cu132-test", "ros1-bookworm-perception-cuda-cu132-test", "ros1-bookworm-desktop-cuda-cu132-test", "ros1-bookworm-desktop-full-cuda-cu132-test", "ros1-bookworm-core-run-cuda-cu132-test", "ros1-bookworm-base-run-cuda-cu132-test", "ros1-bookworm-core-cuda-cu121-test", "ros1-bookworm-base-cuda-cu121-test", "ros1-bookworm-robot-cuda-cu121-test", "ros1-bookworm-perception-cuda-cu121-test", "ros1-bookworm-desktop-cuda-cu121-test", "ros1-bookworm-desktop-full-cuda-cu121-test", "ros1-bookworm-core-run-cuda-cu121-test", "ros1-bookworm-base-run-cuda-cu121-test", "ros1-bookworm-core-torch-cu128-test", "ros1-bookworm-base-torch-cu128-test", "ros1-bookworm-robot-torch-cu128-test", "ros1-bookworm-perception-torch-cu128-test", "ros1-bookworm-desktop-torch-cu128-test", "ros1-bookworm-desktop-full-torch-cu128-test", "ros1-bookworm-core-run-torch-cu128-test", "ros1-bookworm-base-run-torch-cu128-test", "ros1-bookworm-core-torch-cu130-test", "ros1-bookworm-base-torch-cu130-test", "ros1-bookworm-robot-torch-cu130-test", "ros1-bookworm-perception-torch-cu130-test", "ros1-bookworm-desktop-torch-cu130-test", "ros1-bookworm-desktop-full-torch-cu130-test", "ros1-bookworm-core-run-torch-cu130-test", "ros1-bookworm-base-run-torch-cu130-test", "ros1-bookworm-core-torch-cu132-test", "ros1-bookworm-base-torch-cu132-test", "ros1-bookworm-robot-torch-cu132-test", "ros1-bookworm-perception-torch-cu132-test", "ros1-bookworm-desktop-torch-cu132-test", "ros1-bookworm-desktop-full-torch-cu132-test", "ros1-bookworm-core-run-torch-cu132-test", "ros1-bookworm-base-run-torch-cu132-test", "ros1-bookworm-core-tensorflow-cu128-test", "ros1-bookworm-base-tensorflow-cu128-test", "ros1-bookworm-robot-tensorflow-cu128-test", "ros1-bookworm-perception-tensorflow-cu128-test", "ros1-bookworm-desktop-tensorflow-cu128-test", "ros1-bookworm-desktop-full-tensorflow-cu128-test", "ros1-bookworm-core-run-tensorflow-cu128-test", "ros1-bookworm-base-run-tensorflow-cu128-test", "ros1-bookworm-core-tensorflow-cpu-test", "ros1-bookworm-base-tensorflow-cpu-test", "ros1-bookworm-robot-tensorflow-cpu-test", "ros1-bookworm-perception-tensorflow-cpu-test", "ros1-bookworm-desktop-tensorflow-cpu-test", "ros1-bookworm-desktop-full-tensorflow-cpu-test", "ros1-bookworm-core-run-tensorflow-cpu-test", "ros1-bookworm-base-run-tensorflow-cpu-test", "ros1-bookworm-core-ml-cu128-test", "ros1-bookworm-base-ml-cu128-test", "ros1-bookworm-robot-ml-cu128-test", "ros1-bookworm-perception-ml-cu128-test", "ros1-bookworm-desktop-ml-cu128-test", "ros1-bookworm-desktop-full-ml-cu128-test", "ros1-bookworm-core-run-ml-cu128-test", "ros1-bookworm-base-run-ml-cu128-test",
    "ros1-trixie-core-test", "ros1-trixie-base-test", "ros1-trixie-robot-test", "ros1-trixie-perception-test", "ros1-trixie-desktop-test", "ros1-trixie-desktop-full-test", "ros1-trixie-core-run-test", "ros1-trixie-base-run-test", "ros1-trixie-core-cuda-cu128-test", "ros1-trixie-base-cuda-cu128-test", "ros1-trixie-robot-cuda-cu128-test", "ros1-trixie-perception-cuda-cu128-test", "ros1-trixie-desktop-cuda-cu128-test", "ros1-trixie-desktop-full-cuda-cu128-test", "ros1-trixie-core-run-cuda-cu128-test", "ros1-trixie-base-run-cuda-cu128-test", "ros1-trixie-core-cuda-cu130-test", "ros1-trixie-base-cuda-cu130-test", "ros1-trixie-robot-cuda-cu130-test", "ros1-trixie-perception-cuda-cu130-test", "ros1-trixie-desktop-cuda-cu130-test", "ros1-trixie-desktop-full-cuda-cu130-test", "ros1-trixie-core-run-cuda-cu130-test", "ros1-trixie-base-run-cuda-cu130-test", "ros1-trixie-core-cuda-cu132-test", "ros1-trixie-base-cuda-cu132-test", "ros1-trixie-robot-cuda-cu132-test", "ros1-trixie-perception-cuda-cu132-test", "ros1-trixie-desktop-cuda-cu132-test", "ros1-trixie-desktop-full-cuda-cu132-test", "ros1-trixie-core-run-cuda-cu132-test", "ros1-trixie-base-run-cuda-cu132-test", "ros1-trixie-core-cuda-cu121-test", "ros1-trixie-base-cuda-cu121-test", "ros1-trixie-robot-cuda-cu121-test", "ros1-trixie-perception-cuda-cu121-test", "ros1-trixie-desktop-cuda-cu121-test", "ros1-trixie-desktop-full-cuda-cu121-test", "ros1-trixie-core-run-cuda-cu121-test", "ros1-trixie-base-run-cuda-cu121-test", "ros1-trixie-core-torch-cu128-test", "ros1-trixie-base-torch-cu128-test", "ros1-trixie-robot-torch-cu128-test", "ros1-trixie-perception-torch-cu128-test", "ros1-trixie-desktop-torch-cu128-test", "ros1-trixie-desktop-full-torch-cu128-test", "ros1-trixie-core-run-torch-cu128-test", "ros1-trixie-base-run-torch-cu128-test", "ros1-trixie-core-torch-cu130-test", "ros1-trixie-base-torch-cu130-test", "ros1-trixie-robot-torch-cu130-test", "ros1-trixie-perception-torch-cu130-test", "ros1-trixie-desktop-torch-cu130-test", "ros1-trixie-desktop-full-torch-cu130-test", "ros1-trixie-core-run-torch-cu130-test", "ros1-trixie-base-run-torch-cu130-test", "ros1-trixie-core-torch-cu132-test", "ros1-trixie-base-torch-cu132-test", "ros1-trixie-robot-torch-cu132-test", "ros1-trixie-perception-torch-cu132-test", "ros1-trixie-desktop-torch-cu132-test", "ros1-trixie-desktop-full-torch-cu132-test", "ros1-trixie-core-run-torch-cu132-test", "ros1-trixie-base-run-torch-cu132-test", "ros1-trixie-core-torch-cpu-test", "ros1-trixie-base-torch-cpu-test", "ros1-trixie-robot-torch-cpu-test", "ros1-trixie-perception-torch-cpu-test", "ros1-trixie-desktop-torch-cpu-test", "ros1-trixie-desktop-full-torch-cpu-test", "ros1-trixie-core-run-torch-cpu-test", "ros1-trixie-base-run-torch-cpu-test", "ros1-trixie-core-tensorflow-cu128-test", "ros1-trixie-base-tensorflow-cu128-test", "ros1-trixie-robot-tensorflow-cu128-test", "ros1-trixie-perception-tensorflow-cu128-test", "ros1-trixie-desktop-tensorflow-cu128-test", "ros1-trixie-desktop-full-tensorflow-cu128-test", "ros1-trixie-core-run-tensorflow-cu128-test", "ros1-trixie-base-run-tensorflow-cu128-test", "ros1-trixie-core-tensorflow-cpu-test", "ros1-trixie-base-tensorflow-cpu-test", "ros1-trixie-robot-tensorflow-cpu-test", "ros1-trixie-perception-tensorflow-cpu-test", "ros1-trixie-desktop-tensorflow-cpu-test", "ros1-trixie-desktop-full-tensorflow-cpu-test", "ros1-trixie-core-run-tensorflow-cpu-test", "ros1-trixie-base-run-tensorflow-cpu-test", "ros1-trixie-core-ml-cu128-test", "ros1-trixie-base-ml-cu128-test", "ros1-trixie-robot-ml-cu128-test", "ros1-trixie-perception-ml-cu128-test", "ros1-trixie-desktop-ml-cu128-test", "ros1-trixie-desktop-full-ml-cu128-test", "ros1-trixie-core-run-ml-cu128-test", "ros1-trixie-base-run-ml-cu128-test", "ros1-trixie-core-ml-cpu-test", "ros1-trixie-base-ml-cpu-test", "ros1-trixie-robot-ml-cpu-test", "ros1-trixie-perception-ml-cpu-test", "ros1-trixie-desktop-ml-cpu-test", "ros1-trixie-desktop-full-ml-cpu-test", "ros1-trixie-core-run-ml-cpu-test", "ros1-trixie-base-run-ml-cpu-test",
    "jazzy-wheels-core-test", "jazzy-wheels-core-cuda-cu128-test", "jazzy-wheels-core-cuda-cu130-test", "jazzy-wheels-core-cuda-cu132-test", "jazzy-wheels-core-cuda-cu121-test", "jazzy-wheels-core-torch-cu128-test", "jazzy-wheels-core-torch-cu130-test", "jazzy-wheels-core-torch-cu132-test", "jazzy-wheels-core-tensorflow-cu128-test", "jazzy-wheels-core-tensorflow-cpu-test", "jazzy-wheels-core-ml-cu128-test",
    "jazzy-core-onnx-cu128-test", "jazzy-base-onnx-cu128-test", "jazzy-core-torch-onnx-cu128-test", "jazzy-core-tensorflow-onnx-cu128-test",
    "humble-core-onnx-cu128-test", "humble-base-onnx-cu128-test", "humble-core-torch-onnx-cu128-test", "humble-core-tensorflow-onnx-cu128-test",
    "ros1-trixie-core-onnx-cu128-test", "ros1-trixie-core-torch-onnx-cu128-test", "ros1-trixie-core-tensorflow-onnx-cu128-test",
    "ros1-bookworm-core-onnx-cu128-test", "ros1-bookworm-base-onnx-cu128-test", "ros1-bookworm-core-torch-onnx-cu128-test", "ros1-bookworm-core-tensorflow-onnx-cu128-test",
    "lyrical-core-onnx-cu130-test", "lyrical-base-onnx-cu130-test", "lyrical-core-torch-onnx-cu130-test",
    "jazzy-core-onnx-cu130-test", "jazzy-base-onnx-cu130-test", "jazzy-core-torch-onnx-cu130-test",
    "ros1-trixie-core-onnx-cu130-test", "ros1-trixie-core-torch-onnx-cu130-test",
    "ros1-bookworm-core-onnx-cu130-test", "ros1-bookworm-base-onnx-cu130-test", "ros1-bookworm-core-torch-onnx-cu130-test",
    "lyrical-core-onnx-cu132-test", "lyrical-core-torch-onnx-cu132-test",
    "jazzy-core-onnx-cu132-test", "jazzy-core-torch-onnx-cu132-test",
    "ros1-trixie-core-onnx-cu132-test", "ros1-trixie-core-torch-onnx-cu132-test",
    "ros1-bookworm-core-onnx-cu132-test", "ros1-bookworm-core-torch-onnx-cu132-test",
    "noetic-core-onnx-cu121-test", "noetic-core-torch-onnx-cu121-test",
    "jazzy-core-onnx-cpu-test", "jazzy-base-onnx-cpu-test", "jazzy-core-torch-onnx-cpu-test", "jazzy-core-tensorflow-onnx-cpu-test",
    "humble-core-onnx-cpu-test", "humble-base-onnx-cpu-test", "humble-core-torch-onnx-cpu-test", "humble-core-tensorflow-onnx-cpu-test",
    "ros1-trixie-core-onnx-cpu-test", "ros1-trixie-core-torch-onnx-cpu-test", "ros1-trixie-core-tensorflow-onnx-cpu-test",
    "ros1-bookworm-core-onnx-cpu-test", "ros1-bookworm-base-onnx-cpu-test", "ros1-bookworm-core-tensorflow-onnx-cpu-test",
    "lyrical-core-onnx-cpu314-test",
    "jazzy-core-devel-cu130-test", "jazzy-core-torch-devel-cu130-test",
    "humble-core-devel-cu130-test", "humble-core-torch-devel-cu130-test",
    "noetic-core-devel-cu130-test",
    "ros1-trixie-core-devel-cu130-test", "ros1-trixie-core-torch-devel-cu130-test",
    "ros1-bookworm-core-devel-cu130-test", "ros1-bookworm-core-torch-devel-cu130-test",
    "lyrical-core-devel-cu132-test", "lyrical-core-torch-devel-cu132-test",
    "jazzy-core-devel-cu132-test", "jazzy-core-torch-devel-cu132-test",
    "humble-core-devel-cu132-test",
    "noetic-core-devel-cu132-test",
    "ros1-trixie-core-devel-cu132-test", "ros1-trixie-core-torch-devel-cu132-test",
    "ros1-bookworm-core-devel-cu132-test", "ros1-bookworm-core-torch-devel-cu132-test",
    "lyrical-core-triton-cu128-test",
    "jazzy-core-triton-cu128-test",
    "humble-core-triton-cu128-test",
    "ros1-trixie-core-triton-cu128-test",
    "ros1-bookworm-core-triton-cu128-test",
    "lyrical-core-triton-cu130-test",
    "jazzy-core-triton-cu130-test",
    "humble-core-triton-cu130-test",
    "ros1-trixie-core-triton-cu130-test",
    "ros1-bookworm-core-triton-cu130-test",
    "lyrical-core-triton-cu132-test",
    "jazzy-core-triton-cu132-test",
    "humble-core-triton-cu132-test",
    "ros1-trixie-core-triton-cu132-test",
    "ros1-bookworm-core-triton-cu132-test",
    "lyrical-core-triton-cpu-test",
    "jazzy-core-triton-cpu-test",
    "humble-core-triton-cpu-test",
    "ros1-trixie-core-triton-cpu-test",
    "ros1-bookworm-core-triton-cpu-test",
    "lyrical-core-tensorrt-rtx-cu130-test",
    "jazzy-core-tensorrt-rtx-cu130-test",
    "humble-core-tensorrt-rtx-cu130-test",
    "ros1-trixie-core-tensorrt-rtx-cu130-test",
    "ros1-bookworm-core-tensorrt-rtx-cu130-test",
    "lyrical-core-tensorrt-rtx-cu132-test",
    "jazzy-core-tensorrt-rtx-cu132-test",
    "humble-core-tensorrt-rtx-cu132-test",
    "ros1-trixie-core-tensorrt-rtx-cu132-test",
    "ros1-bookworm-core-tensorrt-rtx-cu132-test",
    "jazzy-base-torch-cu128-env-lerobot-test",
    "ros1-bookworm-core-torch-cu128-env-lerobot-test",
  ]
}
