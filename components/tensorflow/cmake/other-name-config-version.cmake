# Of TensorFlow under another name: the same versions.
include("${CMAKE_CURRENT_LIST_DIR}/../TensorFlow/TensorFlowConfigVersion.cmake")
