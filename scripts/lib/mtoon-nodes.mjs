// Adapts `@pixiv/three-vrm/nodes` to three.js r187, which removed `transformedNormalView`, an alias of `normalView`
// (https://github.com/mrdoob/three.js/pull/34517). docs/vrm.md explains the same for pages.

/** Names in three-vrm 3.5 and their replacements in three.js. */
const NAMES = [
  ['transformedNormalView', 'normalView'],
  // Extending TempNode warns.
  ['THREE2.TempNode', 'THREE2.Node'],
  // Only used before r168; bundlers warn that it is missing.
  ['THREE_WEBGPU.tslFn', 'THREE_TSL.Fn'],
]

/** Vite plugin that replaces these names. */
export function mtoonNodes() {
  return {
    name: 'mtoon-nodes',
    transform: {
      filter: { id: /three-vrm[^/]*\/lib\/nodes/ },
      handler: (code) => ({
        code: NAMES.reduce((text, [name, other]) => text.replaceAll(name, other), code),
        map: null,
      }),
    },
  }
}
