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
