// `@pixiv/three-vrm/nodes` on r187 of three.js, which removed `transformedNormalView` after ten releases as another name of `normalView`
// (https://github.com/mrdoob/three.js/pull/34517). docs/vrm.md says how pages do the same.

/** Names in three-vrm 3.5, and names of three.js in their place. */
const NAMES = [
  ['transformedNormalView', 'normalView'],
  // Extending it warns.
  ['THREE2.TempNode', 'THREE2.Node'],
  // For releases before r168: bundlers warn that it does not exist.
  ['THREE_WEBGPU.tslFn', 'THREE_TSL.Fn'],
]

/** A plugin of Vite that replaces these names. */
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
