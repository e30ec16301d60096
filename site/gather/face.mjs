// The face of the first page: the shipped one, with only the blendshapes that the page or a driver names, quantised and compressed.

import { readFileSync } from 'node:fs'
import { meshopt, prune, textureCompress } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { TARGETS } from '../first-page/targets.mjs'

/** Largest side of a texture: the face fills half of a screen. */
const SIDE = 1024

/** Writes a face of about a third of the bytes. */
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

/** Every word in the wrinkles of a .glb, of which some are blendshapes. Its JSON is at byte 20 (glTF 2.0, section 4.4). */
function driverTargets(path) {
  const bytes = readFileSync(path)
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)))
  const wrinkles = json.materials.map(({ extensions }) => extensions?.FURROW_wrinkle_maps)
  return JSON.stringify(wrinkles).match(/\w+/g)
}

/** Removes all other blendshapes, which are the most of the file. */
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
