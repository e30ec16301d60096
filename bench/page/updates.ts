import type { RgbaImage } from 'furrow'
import { updateLayer } from 'furrow/three'
import type { Material } from 'three'
import type { Plan } from '../case.ts'
import { median } from '../statistics.ts'
import type { Bench } from './bench.ts'
import { applyFurrow } from './furrow.ts'
import { createSet, createSkin } from './scene.ts'

/** Width and height of the layer's normal map, texels. */
export const MAP_SIZE = 1024
/** Width and height of the changed rectangle, texels. */
export const REGION_SIZE = 64
const AREAS = 8
/** Factor by which the face is drawn smaller, so that updating the map takes most of the frame's time. */
const SHRINK = 50

/** Milliseconds that `updateLayer` adds to a frame: for a rectangle of the normal map, and for the full map. */
export interface UpdateTimes {
  region: number
  full: number
}

/** Measures the time that changes of a layer's normal map add to a frame. */
export async function measureUpdates(
  { face, scene, camera, timedRenderer, renderer }: Bench,
  plan: Plan,
): Promise<UpdateTimes> {
  const skin = createSkin(face)
  scene.add(skin)
  const distant = camera.clone()
  distant.zoom /= SHRINK
  distant.updateProjectionMatrix()
  const set = createSet(face, { areas: AREAS, layers: 1, maps: 'normals' })
  const [layer] = set.layers
  const normal = enlarged(layer.normal)
  layer.normal = normal
  const wrinkles = applyFurrow(skin, set, renderer, {})
  for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0.5)
  const middle = (MAP_SIZE - REGION_SIZE) / 2
  const region = { x0: middle, y0: middle, x1: middle + REGION_SIZE, y1: middle + REGION_SIZE }
  const changes = {
    none: () => {},
    region: () => updateLayer(wrinkles, layer.name, { normal }, region),
    full: () => updateLayer(wrinkles, layer.name, { normal }),
  }
  const time = async (change: () => void) => {
    const start = performance.now()
    change()
    timedRenderer.draw(scene, distant)
    // Waits until the GPU has finished the frame.
    await timedRenderer.read()
    return performance.now() - start
  }
  const times = { none: [] as number[], region: [] as number[], full: [] as number[] }
  // The first round only warms up.
  for (let round = 0; round <= plan.rounds; round++) {
    for (const [name, change] of Object.entries(changes)) {
      const milliseconds = await time(change)
      if (round > 0) times[name as keyof typeof times].push(milliseconds)
    }
    // To update rectangles, `updateLayer` keeps mipmaps on the CPU. `full` discards them, and this untimed call creates them again.
    await time(changes.region)
  }
  wrinkles.dispose()
  scene.remove(skin)
  ;(skin.material as Material).dispose()
  const still = median(times.none)
  return { region: median(times.region) - still, full: median(times.full) - still }
}

/** Enlarges an image to `MAP_SIZE` texels in width and height by repeating texels. */
function enlarged({ width, height, data }: RgbaImage): RgbaImage {
  const texels = new Uint32Array(data.buffer, data.byteOffset, width * height)
  const larger = Uint32Array.from({ length: MAP_SIZE * MAP_SIZE }, (_, i) => {
    const [x, y] = [i % MAP_SIZE, Math.floor(i / MAP_SIZE)]
    return texels[Math.floor((y * height) / MAP_SIZE) * width + Math.floor((x * width) / MAP_SIZE)]
  })
  return { width: MAP_SIZE, height: MAP_SIZE, data: new Uint8Array(larger.buffer) }
}
