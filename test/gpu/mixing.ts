import type { GrayImage, LayerKind } from 'furrow'
import { packColours, reference } from 'furrow/internal'
import type { WrinklesOptions } from 'furrow/three'
import { removeArea } from 'furrow/three'
import { type Camera, DataTexture, DirectionalLight, LinearFilter, MeshLambertMaterial, Scene } from 'three'
import { layer, randomAreas, randomNormals } from '../cases.ts'
import { type Harness, square } from './harness.ts'
import { influenceAt } from './influence-at.ts'

/** Width of the areas, and by default of the maps, texels. */
const AREA = 16

/** Creates a square with layers of these kinds, random maps and areas at rest, to compare with the float64 reference. */
export function mixingCase(
  harness: Harness,
  random: () => number,
  kinds: readonly LayerKind[],
  {
    scale = 1,
    offset = 0,
    map = AREA,
    ...options
  }: WrinklesOptions & {
    scale?: number
    offset?: number
    map?: number
  },
) {
  const base = randomNormals(random, map)
  const layers = kinds.map((kind, i) => layer(`layer${i}`, kind, randomNormals(random, map)))
  let areas = randomAreas(random, 12, AREA).map((area, i) => ({
    ...area,
    layer: `layer${i % kinds.length}`,
    weights: i % 2 ? area.weights : cropped(area.weights as GrayImage, i),
  }))
  const normalMap = new DataTexture(base.data, map, map)
  normalMap.minFilter = LinearFilter
  normalMap.magFilter = LinearFilter
  normalMap.needsUpdate = true
  const material = new MeshLambertMaterial({ normalMap })
  material.normalScale.set(1, -1)
  const mesh = square(material, scale, [offset, offset])
  const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: AREA, ...options })
  const maps = packColours([base, ...layers.map(({ normal }) => normal)])
  const scene = new Scene()
  const light = new DirectionalLight(0xffffff, Math.PI)
  scene.add(mesh, light)
  return {
    wrinkles,
    material,
    normalMap,
    remove(name: string) {
      removeArea(wrinkles, name)
      areas = areas.filter((area) => area.name !== name)
    },
    /**
     * Draws the square and returns the largest difference of its normals from the reference. Each component is read from
     * a picture with a light along that axis.
     */
    async largestError(camera: Camera, pixels: number): Promise<number> {
      const activations = areas.map(({ name }) => wrinkles.getActivation(name))
      const names = layers.map(({ name }) => name)
      const influence = influenceAt(areas, activations, AREA, names)
      const exactAt = (u: number, v: number) => {
        const normalOf = (map: number) =>
          reference.unpackNormal([0, 1, 2].map((c) => reference.sampleArray(maps, u, v, map, c)))
        const mixed = kinds.map((kind, k) => ({
          kind,
          normal: normalOf(k + 1),
          influence: influence(u, v, k),
        }))
        return reference.mixNormals(normalOf(0), mixed)
      }
      let worst = 0
      for (const axis of [0, 1, 2]) {
        light.position.set(0, 0, 0).setComponent(axis, 1)
        const shown = await harness.render(scene, camera, pixels)
        for (let i = 0; i < pixels * pixels; i++) {
          const u = (((i % pixels) + 0.5) / pixels) * scale + offset
          const v = (1 - (Math.floor(i / pixels) + 0.5) / pixels) * scale + offset
          worst = Math.max(worst, Math.abs(shown[i * 4] - Math.max(0, exactAt(u, v)[axis])))
        }
      }
      return worst
    },
    dispose() {
      wrinkles.dispose()
      normalMap.dispose()
      material.dispose()
      mesh.geometry.dispose()
    },
  }
}

/** Returns an area whose weights are 0 outside a small square. */
function cropped({ width, height, data }: GrayImage, from: number): GrayImage {
  const isInside = (x: number) => x >= from / 2 && x < from / 2 + 7
  const kept = data.map((weight, i) => (isInside(i % width) && isInside(Math.floor(i / width)) ? weight : 0))
  return { width, height, data: kept }
}
