// The catalogue as data: what belongs to what, what differs, what is shared. Nothing here touches the page.
"use strict";

(() => {
  const { catalogue } = window;
  const TITLES = {
    none: "ROS alone",
    cuda: "CUDA",
    torch: "PyTorch",
    tensorflow: "TensorFlow",
    ml: "PyTorch and TensorFlow",
    ...Object.fromEntries(Object.entries(catalogue.addons).map(([name, addon]) => [name, addon.title])),
  };
  const CARRIED = { torch: "PyTorch", tensorflow: "TensorFlow", cuda: "CUDA", cudnn: "cuDNN", nccl: "NCCL" };

  const byTarget = new Map(catalogue.images.map((image) => [image.target, image]));
  const parts = new Map(catalogue.parts.map((part) => [part.name, part]));

  /** What the main tag points at; nothing where there is nothing. */
  function present(image) {
    return image.status === "built" || !("status" in image) ? image.builds[0] : undefined;
  }

  /** The platforms of an image: its own, which are those of its present build, and others that the matrix allows. All are its
   * own where nothing is published. */
  function platforms(image) {
    const build = present(image);
    const own = build ? build.platforms.map((item) => item.platform) : image.platforms;
    return { own, others: image.platforms.filter((name) => !own.includes(name)) };
  }

  /** Names of an image's platforms, and below them those that are not published. */
  function platformNames(image, name) {
    const { own, others } = platforms(image);
    const missing = others.length ? `not published: ${others.map(name).join(", ")}` : null;
    return [own.map(name).join(", "), missing && window.rosml.el("div", { class: "sub" }, missing)];
  }

  function architecture(platform) {
    return platform.split("/")[1];
  }

  /** A reference with the registry before it: by a tag, or by a digest. */
  function reference(image, name) {
    return `${catalogue.registry}/${image.repository}${name.startsWith("sha256:") ? "@" : ":"}${name}`;
  }

  function mainTag(image) {
    return image.tags.length ? image.tags[0].name : "";
  }

  /** How the page calls a build: by the tag that never moves, else by any, else by its digest. */
  function buildName(image, build) {
    const kinds = ["dated", "main", "versions", "floating"];
    const own = kinds.flatMap((tagKind) => image.tags.filter((tag) => tag.kind === tagKind && tag.digest === build.digest));
    return own.length ? `${image.repository}:${own[0].name}` : `${image.repository}@${build.digest}`;
  }

  /** Every name that a build can be asked for by; of a tag whose build could not be read, without one. */
  let names;
  function buildNames() {
    if (!names) {
      names = new Map();
      for (const image of catalogue.images) {
        for (const build of image.builds) names.set(`${image.repository}@${build.digest}`, { image, build });
        for (const tag of image.tags) {
          const build = image.builds.find((item) => item.digest === tag.digest);
          names.set(`${image.repository}:${tag.name}`, { image, build });
        }
      }
    }
    return names;
  }

  function withoutRegistry(text) {
    return text.trim().replace(`${catalogue.registry}/`, "");
  }

  /** The image and build that a text names: with or without the registry, by target too. */
  function find(text) {
    const wanted = withoutRegistry(text);
    const image = byTarget.get(wanted);
    const build = image && present(image);
    const found = build ? { image, build } : buildNames().get(wanted);
    return found && found.build ? found : undefined;
  }

  /** Why a text names nothing that can be compared. */
  function whyNot(text) {
    return buildNames().has(withoutRegistry(text))
      ? `${text} is published, but what it points at could not be read`
      : `No published tag or image is called ${text}`;
  }

  /** What kind of thing a part is: for its colour. */
  function kind(part) {
    const found = parts.get(part);
    return found ? found.kind : part ? "ros" : "other";
  }

  function layersOf(platform) {
    return platform.layers.map((position) => catalogue.layers[position]);
  }

  function bytes(layers) {
    return layers.reduce((sum, layer) => sum + layer.compressed, 0);
  }

  /** Two platforms' layers: in both, and in one alone. */
  function compareLayers(one, other) {
    const left = layersOf(one);
    const right = layersOf(other);
    const leftDigests = new Set(left.map((layer) => layer.digest));
    const rightDigests = new Set(right.map((layer) => layer.digest));
    return {
      shared: right.filter((layer) => leftDigests.has(layer.digest)),
      left: left.filter((layer) => !rightDigests.has(layer.digest)),
      right: right.filter((layer) => !leftDigests.has(layer.digest)),
    };
  }

  /** Versions by name that two platforms have, and whether they are the same. */
  function compareVersions(one, other) {
    // Labels name fewer things than were found inside: what only one of both could know is no difference.
    const both = one.found_inside === other.found_inside;
    const all = [...new Set([...Object.keys(one.versions), ...Object.keys(other.versions)])];
    const compared = both ? all : all.filter((name) => name in one.versions && name in other.versions);
    return compared
      .sort((a, b) => rank(a) - rank(b) || a.localeCompare(b))
      .map((name) => ({
        name,
        left: one.versions[name],
        right: other.versions[name],
        same: one.versions[name] === other.versions[name],
      }));
  }

  const FIRST = [
    "ros-distro",
    "ros-version",
    "ros-channel",
    "image-os",
    "image-python",
    "python",
    "cuda",
    "cudnn",
    "torch",
    "tensorflow",
    "numpy",
  ];
  function rank(name) {
    const place = FIRST.indexOf(name);
    return place < 0 ? FIRST.length : place;
  }

  function sortedVersions(platform) {
    return Object.entries(platform.versions).sort(([a], [b]) => rank(a) - rank(b) || a.localeCompare(b));
  }

  /** What changed from one build of an image to a later one, on a platform that both have. */
  function changes(older, newer) {
    const pairs = newer.platforms
      .map((platform) => ({
        newer: platform,
        older: older.platforms.find((item) => item.platform === platform.platform),
      }))
      .filter((pair) => pair.older);
    return pairs.map(({ newer: after, older: before }) => {
      const layers = compareLayers(before, after);
      return {
        platform: after.platform,
        parts: [...new Set([...layers.left, ...layers.right].map((layer) => layer.part))],
        pulled: bytes(layers.right),
        kept: layers.shared.length,
        all: after.layers.length,
        growth: after.size.compressed - before.size.compressed,
        versions: compareVersions(before, after).filter((item) => !item.same),
        sync:
          before.ros_sync && after.ros_sync && before.ros_sync !== after.ros_sync
            ? [before.ros_sync, after.ros_sync]
            : null,
      };
    });
  }

  /** The add-ons that a text may mean: one of its words is one of theirs, or the beginning of one. */
  function addonsMeant(text) {
    const said = text.toLowerCase().split(/[\s:/]+/).filter((word) => word.length > 2);
    return Object.entries(catalogue.addons)
      .filter(([, addon]) => said.some((word) => addon.words.some((known) => known.startsWith(word))))
      .map(([name]) => name);
  }

  /** An image that can take an add-on, published if there is one. */
  function taker(addon) {
    const able = catalogue.images.filter((image) => Object.values(image.takes).some((item) => item.addon === addon));
    return able.find(present) || able[0];
  }

  /** The present build of every published image on a platform. */
  function published(platform) {
    return catalogue.images
      .map((image) => ({
        image,
        found: (present(image) || { platforms: [] }).platforms.find((item) => item.platform === platform),
      }))
      .filter((item) => item.found);
  }

  const SOON = 180; // days

  /** Words for the end of life of an image's distribution, and whether it is over, or soon. */
  function endOfLife(image) {
    const { eol, instead } = catalogue.distributions[image.distribution];
    const left = eol ? (Date.parse(eol) - Date.parse(catalogue.created.slice(0, 10))) / 86_400_000 : Infinity;
    return { text: eol || "none: rolling", over: left < 0, soon: left >= 0 && left < SOON, instead };
  }

  /** What one has to know before one takes an image: {text, kind}. */
  function badges(image) {
    const { lts, experimental } = catalogue.distributions[image.distribution];
    const end = endOfLife(image);
    const until = lts ? { text: `LTS until ${end.text}`, kind: "good" } : null;
    return [
      end.over ? { text: `end of life since ${end.text}`, kind: "over" } : null,
      end.soon ? { text: `end of life on ${end.text}`, kind: "warn" } : null,
      end.over || end.soon ? null : until,
      experimental ? { text: "experimental", kind: "warn" } : null,
      image.gpu.driver ? { text: `NVIDIA driver ${image.gpu.driver} or newer`, kind: "need" } : null,
    ].filter(Boolean);
  }

  /** The same as elements. */
  function badgeNodes(image) {
    return badges(image).map(({ text, kind: name }) => window.rosml.el("span", { class: `badge ${name}` }, text));
  }

  /** A scan's outcome for people: clean means that the policy stops nothing, and not that nothing is known. */
  function scanOutcome(scan) {
    return scan.outcome === "clean" ? "scan passed" : `scan: ${scan.outcome}`;
  }

  Object.assign(window.rosml, {
    catalogue,
    scanOutcome,
    TITLES,
    STATUS: catalogue.words,
    CARRIED,
    byTarget,
    present,
    platforms,
    platformNames,
    architecture,
    reference,
    mainTag,
    buildName,
    find,
    whyNot,
    kind,
    bytes,
    compareLayers,
    compareVersions,
    sortedVersions,
    changes,
    published,
    addonsMeant,
    taker,
    endOfLife,
    badgeNodes,
  });
})();
