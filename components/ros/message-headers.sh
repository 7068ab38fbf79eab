#!/bin/sh
# Headers of ROS 1 messages that an older generator wrote name what C++20 dropped from allocators. This writes them as
# the newer one does, which Debian has and uses for a workspace's own messages (gencpp 0.7.0), so that they compile as C++17
# and as C++20, which PyTorch's headers want from 2.14 on. apt runs it after each change: for packages that come later.
find /usr/include -mindepth 2 -maxdepth 2 -name '*.h' -exec grep -lZ 'ContainerAllocator::template rebind<' {} + |
  xargs -0 -r sed -i \
    -e 's/ContainerAllocator::template rebind</std::allocator_traits<ContainerAllocator>::template rebind_alloc</g' \
    -e 's/>::other/>/g'
