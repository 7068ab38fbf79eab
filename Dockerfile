# check=error=true;skip=InvalidDefaultArgInFrom
#
# One file for every image. docker-bake.hcl (generated from matrix.yaml) names the stage of each target and wires
# the named contexts:
#
#   os ─► base ─► ros (core) ─► ros (base) ─► …            each `ros` is FROM the component below it: context `parent`
#            └──► ros-wheels                               ROS 2 from Python wheels, in the place of Debian packages
#
#   os ─► assembler ─► part-assembler ─► part-files ─► part   one per part, stack, Python and architecture
#
#   ros + part-cuda + part-common + …                      joined with COPY --link: nothing runs after the join
#    └──► image ─► test                                    structure tests on top of the finished image
#
# The join has a line for each part that an image has, so the bake file has it (dockerfile-inline). No stage here
# knows what parts there are.
# Contexts: os, parent, upstream, described, image, metadata.

# ---- ROS ------------------------------------------------------------------------------------------------------------
# Of when the packages are, where the caller knows it: the builder's cache does not know when they move.
FROM scratch AS upstream

# Steps mount just the files they use: a change elsewhere does not run them again. They do it below a tmpfs, for the
# builder leaves the time of day on a folder where it made, and removed, the places of mounts.
FROM os AS base
ARG NUMPY RUNTIME ADOPTED SOURCE_DATE_EPOCH
RUN --mount=type=tmpfs,target=/run \
    --mount=type=bind,source=components/build,target=/run/components/build \
    --mount=type=bind,source=components/base/install.sh,target=/run/components/base/install.sh \
    --mount=type=bind,source=components/base/constraints.sh,target=/run/components/base/constraints.sh \
    --mount=type=bind,source=components/base/pip.sh,target=/run/components/base/pip.sh \
    --mount=type=bind,source=components/base/pip.txt,target=/run/components/base/pip.txt \
    --mount=type=bind,from=upstream,target=/run/upstream \
    --mount=type=secret,id=ca-bundle \
    --mount=type=secret,id=os-apt-mirror \
    /run/components/base/install.sh
# Not COPY, which keeps the time that a file has in the checkout.
RUN --mount=type=tmpfs,target=/run \
    --mount=type=bind,source=components/build,target=/run/components/build \
    --mount=type=bind,source=components/base,target=/run/components/base \
    /run/components/base/contract.sh
# The last folder on PATH is there with a CUDA toolkit, whether a part or apt brings it.
ENV LANG=C.UTF-8 \
    PATH=${PATH}:/usr/local/cuda/bin \
    PYTHONIOENCODING=utf-8 \
    WORKSPACE=/docker-ros/ws \
    DOCKER_USER=dockeruser \
    DOCKER_UID= \
    DOCKER_GID= \
    NVIDIA_VISIBLE_DEVICES=all \
    NVIDIA_DRIVER_CAPABILITIES=all \
    UV_CONSTRAINT=/usr/local/share/rosml/constraints.d/all.txt
WORKDIR /docker-ros/ws
ENTRYPOINT ["/tini", "--", "/entrypoint.sh"]
CMD ["bash"]

FROM parent AS ros
ARG ROS_PACKAGES ROS_TOOLS RUNTIME ROS_DISTRO ROS_VERSION ROS_CHANNEL ROS_SNAPSHOT ROS_CODENAME ROS_APT_SOURCE
ARG ROS_LIVE_ADDRESS ROS_TESTING_ADDRESS ROS_SNAPSHOT_ADDRESS ROS_ARCHIVE ROS_COMPONENTS ROS_SYNC_DATE SOURCE_DATE_EPOCH
ARG ROS_SIGNED_BY=none.asc
RUN --mount=type=tmpfs,target=/run \
    --mount=type=bind,source=components/build,target=/run/components/build \
    --mount=type=bind,source=components/ros,target=/run/components/ros \
    --mount=type=bind,source=components/archive-keys/${ROS_SIGNED_BY},target=/run/components/archive-keys/key.asc \
    --mount=type=bind,from=upstream,target=/run/upstream \
    --mount=type=secret,id=ca-bundle \
    --mount=type=secret,id=os-apt-mirror \
    --mount=type=secret,id=ros-apt-mirror \
    /run/components/ros/install.sh
ENV ROS_DISTRO=${ROS_DISTRO} \
    ROS_VERSION=${ROS_VERSION} \
    ROS_SYNC_DATE=${ROS_SYNC_DATE}

# ---- ML parts ----------------------------------------------------------------------------------------------------
# Runs on the builder's own architecture and assembles for any: no emulation.
FROM --platform=${BUILDPLATFORM} os AS assembler
RUN --mount=type=bind,source=components/build/network.sh,target=/run/components/build/network.sh \
    --mount=type=bind,source=components/part/install-assembler.sh,target=/run/components/part/install-assembler.sh \
    --mount=type=bind,source=tools/requirements.txt,target=/run/requirements.txt \
    --mount=type=secret,id=ca-bundle \
    --mount=type=secret,id=os-apt-mirror \
    /run/components/part/install-assembler.sh
ENV PATH=/opt/uv/bin:${PATH}

# ROS 2 from wheels, of a row without Debian packages. It takes uv from the assembler, so it comes after it.
FROM parent AS ros-wheels
ARG ROS_TOOLS ROS_DISTRO ROS_VERSION ROS_ROW PYTHON TARGETARCH SOURCE_DATE_EPOCH
ARG BYTECODE=checked-hash
RUN --mount=type=tmpfs,target=/run \
    --mount=type=bind,source=components/build,target=/run/components/build \
    --mount=type=bind,source=components/ros,target=/run/components/ros \
    --mount=type=bind,source=components/part/bytecode.sh,target=/run/components/part/bytecode.sh \
    --mount=type=bind,source=locks/${ROS_ROW}/${TARGETARCH}/${PYTHON}/ros.txt,target=/run/lock.txt \
    --mount=type=bind,from=assembler,source=/opt/uv,target=/run/uv \
    --mount=type=bind,from=upstream,target=/run/upstream \
    --mount=type=secret,id=ca-bundle \
    --mount=type=secret,id=os-apt-mirror \
    LOCK=/run/lock.txt UV=/run/uv/bin/uv /run/components/ros/wheels.sh
ENV ROS_DISTRO=${ROS_DISTRO} \
    ROS_VERSION=${ROS_VERSION}

# What a part needs besides, such as a compiler: install-assembler.sh in its folder, where it has one. The pattern may
# match nothing.
FROM assembler AS part-assembler
ARG PART TARGETARCH
COPY components/${PART}/install-assembler.s[h] /run/part/
RUN --mount=type=bind,source=components/build/network.sh,target=/run/components/build/network.sh \
    --mount=type=secret,id=ca-bundle \
    --mount=type=secret,id=os-apt-mirror \
    if [ -e /run/part/install-assembler.sh ]; then /run/part/install-assembler.sh; fi

FROM part-assembler AS part-files
ARG PART SLOT STACK PYTHON WHEEL_PYTHON ACCELERATOR TARGETARCH
ARG BYTECODE=checked-hash SHOWS=none INDEX GLIBC
COPY locks/${STACK}/${TARGETARCH}/${PYTHON}/${PART}.txt /lock.txt
COPY locks/${STACK}/${TARGETARCH}/an[y]/${SHOWS}.tx[t] /shown/
RUN --mount=type=bind,source=components/build/network.sh,target=/run/components/build/network.sh \
    --mount=type=bind,source=components/part,target=/run/components/part \
    --mount=type=bind,source=components/${PART},target=/run/components/${PART} \
    --mount=type=secret,id=ca-bundle \
    LOCK=/lock.txt /run/components/part/assemble.sh

# A part as an image of its own: add it to any image of the same Python with
# `COPY --link --from=<registry>/part:torch-cu128-py311 / /`.
FROM scratch AS part
COPY --link --from=part-files /out/ /

# ---- Environments: Python packages beside ROS, at a prefix of their own ----------------------------------------------
# Their locks: a file for each architecture. The caller names the folder.
FROM scratch AS environment-locks

FROM assembler AS environment-files
ARG ENVIRONMENT GLIBC PYTHON TARGETARCH
ARG BYTECODE=checked-hash
RUN --mount=type=bind,source=components/build/network.sh,target=/run/components/build/network.sh \
    --mount=type=bind,source=components/environment,target=/run/components/environment \
    --mount=type=bind,source=components/part/bytecode.sh,target=/run/components/part/bytecode.sh \
    --mount=type=bind,source=components/part/normalise.sh,target=/run/components/part/normalise.sh \
    --mount=type=bind,from=environment-locks,target=/run/locks \
    --mount=type=secret,id=ca-bundle \
    LOCK=/run/locks/${TARGETARCH}.txt /run/components/environment/assemble.sh

FROM scratch AS environment
COPY --link --from=environment-files /out/ /

# ---- Contents: the packages and files of an image or part, for scans, and for whoever joins it to others in a registry ----
# What is described: a published image, which the caller names. Nothing of it runs.
FROM scratch AS described

FROM assembler AS describe
RUN --mount=type=bind,from=described,target=/described \
    --mount=type=bind,source=components/containerize/contents.py,target=/run/contents.py \
    --mount=type=bind,source=components/containerize/elf.py,target=/run/elf.py \
    --mount=type=bind,source=components/containerize/facts.py,target=/run/facts.py \
    mkdir /out && python3 /run/contents.py /described /out && python3 /run/facts.py /described /out

FROM scratch AS contents
COPY --from=describe /out/ /

# ---- Structure tests, inside the build: no daemon, no export, no unpacking ------------------------------------------
FROM --platform=${BUILDPLATFORM} assembler AS structure-test
RUN --mount=type=bind,source=components/build/network.sh,target=/run/components/build/network.sh \
    --mount=type=bind,source=tools/structure-test.txt,target=/run/requirements.txt \
    --mount=type=secret,id=ca-bundle \
    bash -c 'source /run/components/build/network.sh && \
      uv pip install --no-deps --require-hashes --no-cache --target /out --requirement /run/requirements.txt'

# The image's config as the registry holds it, for the tests of labels and entrypoint. Empty unless the caller has it.
FROM scratch AS metadata

FROM image AS test-run
ARG TESTS EXPECT TEST_ATTEMPT=0
RUN --mount=type=bind,from=structure-test,source=/out,target=/run/structure-test \
    --mount=type=bind,from=metadata,target=/run/metadata \
    --mount=type=bind,source=tests/structure,target=/run/tests \
    /run/tests/run.sh /structure-report

# The report, whatever it says; `make image` reads it.
FROM scratch AS test-report
COPY --from=test-run /structure-report/ /

# Fails when a structure test failed: what `docker buildx bake <target>-test` builds.
FROM test-run AS test
RUN test ! -e /structure-report/failed || { cat /structure-report/failed; exit 1; }
