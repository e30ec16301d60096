import type { Plugin } from 'vite'

/**
 * three-vrm 3.5 imports `transformedNormalView`, which r187 of three.js has removed after ten releases in which it was another name of
 * `normalView` (https://github.com/mrdoob/three.js/pull/34517); docs/vrm.md says how pages do the same.
 */
export function mtoonNodes(): Plugin {
  return {
    name: 'mtoon-nodes',
    transform: {
      filter: { id: /three-vrm-materials-mtoon\/lib\/nodes/ },
      handler: (code) => ({ code: code.replaceAll('transformedNormalView', 'normalView'), map: null }),
    },
  }
}
