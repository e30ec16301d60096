// Makes the first page's face from faces/human.glb: removes blendshapes that neither the page nor a driver uses, quantises and compresses.

import { readFileSync } from 'node:fs'
import { meshopt, prune, textureCompress } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { TARGETS } from '../first-page/targets.mjs'

/** Largest texture side in texels: the face fills half of the screen. */
const SIDE = 1024

/** Writes a face of about a third of the input's size. */
export function gatherFace(input, output) {
  return transformFile(input, output, [
    keepTargets(new Set([...TARGETS, ...driverTargets(input)])),
    prune(),
    textureCompress({
      encoder: sharp,
      targetFormat: 'webp',
      resize: [SIDE, SIDE],
      lossless: true,
      slots: /normal/i,
    }),
    meshopt({ encoder: MeshoptEncoder }),
  ])
}

/**
 * Returns all words in the wrinkle extension of a .glb, which include the blendshapes that drivers read. A .glb's JSON starts at byte 20
 * (glTF 2.0, section 4.4).
 */
function driverTargets(path) {
  const bytes = readFileSync(path)
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)))
  const wrinkles = json.materials.map(({ extensions }) => extensions?.FURROW_wrinkle_maps)
  return JSON.stringify(wrinkles).match(/\w+/g)
}

/** Removes blendshapes that are not in `names`: they take most of the file. */
function keepTargets(names) {
  return (document) => {
    for (const mesh of document.getRoot().listMeshes()) {
      const all = mesh.getExtras().targetNames ?? []
      const kept = all.flatMap((name, i) => (names.has(name) ? [i] : []))
      mesh.setExtras({ ...mesh.getExtras(), targetNames: kept.map((i) => all[i]) })
      const weights = mesh.getWeights()
      mesh.setWeights(weights.length > 0 ? kept.map((i) => weights[i]) : [])
      for (const primitive of mesh.listPrimitives()) {
        const targets = primitive.listTargets()
        for (const [i, target] of targets.entries()) if (!kept.includes(i)) primitive.removeTarget(target)
      }
    }
  }
}
