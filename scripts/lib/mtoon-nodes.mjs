// Adapts `@pixiv/three-vrm/nodes` to three.js r187, which removed `transformedNormalView`, an alias of `normalView`
// (https://github.com/mrdoob/three.js/pull/34517). docs/vrm.md describes the same change for users.

/** Names that three-vrm 3.5 uses, and their replacements in three.js. */
const NAMES = [
  ['transformedNormalView', 'normalView'],
  // three.js prints a warning if a class extends TempNode.
  ['THREE2.TempNode', 'THREE2.Node'],
  // three-vrm uses `tslFn` only with three.js before r168. Bundlers warn that later releases lack it.
  ['THREE_WEBGPU.tslFn', 'THREE_TSL.Fn'],
]

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
