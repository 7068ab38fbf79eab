// Search as people type. A word is the beginning of a name, a tag or a word of the matrix; a number belongs to the word before
// it; a pasted reference is a tag, with whatever registry; digests are found by their beginning alone.
"use strict";

(() => {
  const r = window.rosml;
  const NUMBER = /^\d[\d.]*$/;
  const JOINED = /^([a-z][a-z_]*)[-:=]*(\d[\d.]*)$/; // python3.12, ubuntu-24.04, torch==2.10.0
  const DIGEST = /^(?:sha256:[0-9a-f]*|(?=[0-9a-f]*\d)[0-9a-f]{7,64})$/;
  const BEFORE = /^\s*(?:from|image:|docker\s+(?:pull|run)|podman\s+(?:pull|run))\s+/i;

  const known = new Map();

  /** What is searched in: lines of text, tags and digests. */
  function entry(image) {
    if (!known.has(image)) {
      const now = r.present(image);
      const tags = [...image.promised_tags, ...image.tags.map((tag) => tag.name)].map((tag) => `${image.repository}:${tag}`);
      const versions = [image.promised, ...(now ? now.platforms : []).map((platform) => platform.versions)];
      const end = r.endOfLife(image).over ? ["eol", "end of life"] : [];
      const words = [image.target, image.repository, r.TITLES[image.framework] || "", ...image.search, ...end, ...tags];
      const facts = versions.flatMap((item) => Object.entries(item).map(([name, version]) => `${name} ${version}`));
      known.set(image, {
        lines: [...new Set([...words, ...facts])].join("\n").toLowerCase(),
        tags: new Set(tags.map((tag) => tag.toLowerCase())),
        digests: image.builds.flatMap((build) => [build, ...build.platforms]).map((item) => item.digest.replace("sha256:", "")),
      });
    }
    return known.get(image);
  }

  function plain(text) {
    return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  }

  /** Whether lines match a pattern. */
  function has(pattern) {
    const found = new RegExp(pattern);
    return (image) => found.test(entry(image).lines);
  }

  function startsWord(word) {
    return has(`(?<![a-z0-9])${plain(word)}`);
  }

  function allOf(...tests) {
    return (image) => tests.every((test) => test(image));
  }

  /** Whether a driver runs an image: a driver runs what older ones run. */
  function runsWith(driver) {
    return (image) => image.search.some((word) => word.startsWith("driver ") && parseInt(word.slice(7), 10) <= driver);
  }

  /** A name and its number: the number itself, then what begins with it. None of both where the name has no numbers at all. */
  function versioned(name, number) {
    if (name === "driver") return [runsWith(parseInt(number, 10))];
    const pattern = `(?<![a-z0-9])${plain(name)} ?${plain(number)}`;
    const always = r.catalogue.images.some(has(`(?<![a-z0-9])${plain(name)} ?\\d`));
    const apart = always ? [] : [allOf(startsWord(name), first(lone(number)))];
    return [has(`${pattern}(?!\\d)`), has(pattern), ...apart];
  }

  function lone(number) {
    return [has(`(?<![\\w.])${plain(number)}(?!\\d)`), has(`(?<![\\w.])${plain(number)}`)];
  }

  /** What a word may mean, the nearest first. */
  function meanings(word) {
    const tests = [];
    if (word.includes(":")) tests.push((image) => entry(image).tags.has(word));
    if (DIGEST.test(word)) {
      const beginning = word.replace("sha256:", "");
      tests.push((image) => entry(image).digests.some((digest) => digest.startsWith(beginning)));
      if (word.startsWith("sha256:")) return tests;
    }
    if (NUMBER.test(word)) return [...tests, ...lone(word)];
    const joined = JOINED.exec(word);
    return [...tests, ...(joined ? versioned(joined[1], joined[2]) : []), startsWord(word)];
  }

  /** The words of a search: a reference without its registry, a number with the word before it. */
  function terms(text) {
    const words = text
      .replace(BEFORE, "")
      .toLowerCase()
      .split(/\s+/)
      .flatMap((word) => (/[.:][^/]*\//.test(word) ? word.slice(word.lastIndexOf("/") + 1) : word).split("@"))
      .filter(Boolean);
    const found = [];
    for (const word of words) {
      const last = found[found.length - 1];
      if (NUMBER.test(word) && last && last.length === 1 && /^[a-z][a-z_-]*$/.test(last[0])) last.push(word);
      else found.push([word]);
    }
    return found;
  }

  /** The first of several meanings that any image has. */
  function first(tests) {
    return tests.find((test) => r.catalogue.images.some(test)) || (() => false);
  }

  /** Whether an image is meant by a text. */
  function search(text) {
    return allOf(...terms(text).map(([word, number]) => first(number ? versioned(word, number) : meanings(word))));
  }

  r.search = search;
})();
