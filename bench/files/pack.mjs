import { join } from 'node:path'
import sharp from 'sharp'
import { encodeGlb } from '../../packages/cli/dist/files/src/gltf/glb-file.js'
import { readGlbFile } from '../../packages/cli/dist/files/src/gltf/read-glb-file.js'
import { embedWrinkles } from '../../packages/cli/dist/files/src/pack/embed.js'
import { packSet } from '../../packages/cli/dist/files/src/pack/pack.js'
import { setOfFolder } from '../../packages/cli/dist/files/src/pack/set-to-pack.js'
import { stripWrinkles } from '../../packages/cli/dist/files/src/pack/strip.js'
import { readFolder, readReferenced } from '../../packages/cli/dist/files/src/wrinkles/folder.js'

const WHO = 'bench'

/** Packs the wrinkles of the folder `human` into `human.glb` in memory. Returns the total milliseconds, and the milliseconds of the image codecs. */
export async function packOnce(faces) {
  const folder = join(faces, 'human')
  const start = performance.now()
  const document = await readFolder(folder, false, WHO)
  const glb = await readGlbFile(join(faces, 'human.glb'), WHO)
  const set = setOfFolder(document, (uri) => readReferenced(folder, uri, WHO, {}), WHO)
  const wrinkles = await packSet(set, { areasPerImage: 3, ktx2: false }, WHO, () => {})
  stripWrinkles(glb, 0, WHO)
  embedWrinkles(glb, 0, wrinkles, WHO)
  encodeGlb(glb)
  const total = performance.now() - start
  return { total, codecs: await timeCodecs(folder, document, wrinkles) }
}

/** Measures the codec time that any packer needs: the milliseconds to decode every input image once and to encode every packed area image once. */
async function timeCodecs(folder, document, { areas }) {
  const inputs = [...document.layers.map(({ normal }) => normal), ...document.areas.map(({ image }) => image)]
  const outputs = [...new Set(areas.map(({ image }) => image.bytes))]
  const decoded = await Promise.all(
    outputs.map((bytes) => sharp(bytes).raw().toBuffer({ resolveWithObject: true })),
  )
  const start = performance.now()
  for (const input of inputs)
    await sharp(join(folder, decodeURI(input)))
      .raw()
      .toBuffer()
  for (const { data, info } of decoded)
    await sharp(data, { raw: info }).png({ compressionLevel: 9 }).toBuffer()
  return performance.now() - start
}
