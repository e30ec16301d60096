/** Page that measures how long `GLTFLoader` takes to load `faces/human.glb` with and without Furrow's plugin. */
import { WrinkleLoaderPlugin } from 'furrow/three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

/** Milliseconds to load the file without and with the plugin, and to decode the images of the wrinkles. */
export interface LoadTimes {
  without: number
  with: number
  images: number
}

declare global {
  interface Window {
    measure(rounds: number): Promise<LoadTimes[]>
  }
}

window.measure = async (rounds) => {
  const file = await (await fetch('/faces/human.glb')).arrayBuffer()
  const images = imagesOfWrinkles(file)
  const times: LoadTimes[] = []
  // The first round only warms up.
  for (let i = 0; i <= rounds; i++) {
    const round = {
      without: await time(() => new GLTFLoader().parseAsync(file, '')),
      with: await time(async () => {
        const loader = new GLTFLoader().register((parser) => new WrinkleLoaderPlugin(parser))
        const { userData } = await loader.parseAsync(file, '')
        for (const wrinkles of userData.wrinkles) wrinkles.dispose()
      }),
      images: await time(() =>
        Promise.all(images.map((image) => createImageBitmap(image, { colorSpaceConversion: 'none' }))),
      ),
    }
    if (i > 0) times.push(round)
  }
  return times
}

async function time(work: () => Promise<unknown>): Promise<number> {
  const start = performance.now()
  await work()
  return performance.now() - start
}

/** Returns the encoded images to which the glTF extension FURROW_wrinkle_maps refers. */
function imagesOfWrinkles(file: ArrayBuffer): Blob[] {
  const length = new DataView(file).getUint32(12, true)
  const json = JSON.parse(new TextDecoder().decode(new Uint8Array(file, 20, length)))
  const { layers, areas } = json.materials.find(
    (material: { extensions?: object }) =>
      material.extensions && 'FURROW_wrinkle_maps' in material.extensions,
  ).extensions.FURROW_wrinkle_maps
  const infos = [
    ...layers.map((layer: { normalTexture: object }) => layer.normalTexture),
    ...areas.map((area: { texture: object }) => area.texture),
  ]
  return [...new Set(infos.map(({ index }: { index: number }) => json.textures[index].source))].map(
    (source) => {
      const { bufferView, mimeType } = json.images[source]
      const { byteOffset = 0, byteLength } = json.bufferViews[bufferView]
      return new Blob([new Uint8Array(file, 28 + length + byteOffset, byteLength)], { type: mimeType })
    },
  )
}
