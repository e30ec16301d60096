// Makes a smaller copy of faces/human.glb for the first page of the site. Removes blendshapes that neither the page nor
// a driver uses, shrinks textures, and compresses meshes.

import { readFileSync } from 'node:fs'
import { meshopt, prune, textureCompress } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import { transformFile } from '../../scripts/lib/transform.mjs'
import { TARGETS } from '../first-page/targets.mjs'

/** Maximum width and height of textures, texels. The face fills only half of the screen. */
const SIDE = 1024

/** Writes the smaller file. It has about a third of the original size. */
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
 * Returns all words in the wrinkle extension of a .glb. These include the names of the blendshapes that drivers read.
 * The JSON of a .glb starts at byte 20 (glTF 2.0, section 4.4).
 */
function driverTargets(path) {
  const bytes = readFileSync(path)
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)))
  const wrinkles = json.materials.map(({ extensions }) => extensions?.FURROW_wrinkle_maps)
  return JSON.stringify(wrinkles).match(/\w+/g)
}

/**
 * Returns a transform that removes the blendshapes whose names are not in `names`. Blendshapes take most of the file.
 */
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
