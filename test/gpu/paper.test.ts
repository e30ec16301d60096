import { packAreas, packColours, reference } from 'furrow/internal'
import type { WrinkleMode } from 'furrow/three'
import {
  AmbientLight,
  DataTexture,
  DirectionalLight,
  LinearFilter,
  MeshLambertMaterial,
  Scene,
  SRGBColorSpace,
  Vector2,
  Vector3,
} from 'three'
import { describe, expect, it } from 'vitest'
import { randomImage, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { casesOn, type Harness, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'

const PIXELS = 32
const MAP = 16

/** Slices of the paper's texture array: base colour, base normals, and normals of wrinkled skin. */
const [DIFFUSE, SMOOTH, WRINKLED] = [0, 1, 2]

describe.each(RENDERERS)("the paper's mode on %s", (name) => {
  const cases = casesOn(name)
  const harness = harnessOn(name)

  it(`has colours within 2/255 of the reference on 99.9% of the pixels of ${cases} random cases`, async () => {
    const random = seeded(42)
    const errors: number[] = []
    // Disposes of each case after the next case is drawn. Otherwise, the renderer would free the program that all cases share.
    let release = () => {}
    for (let i = 0; i < cases; i++) {
      const result = await colourErrors(harness, random)
      errors.push(...result.errors)
      release()
      release = result.dispose
    }
    release()
    const over = errors.filter((error) => error > 2 / 255).length
    expect(errors).toHaveLength(cases * PIXELS * PIXELS)
    expect(over / errors.length).toBeLessThanOrEqual(0.001)
  })

  it("uses the material's own normals after a switch from any other mode", async () => {
    for (const mode of ['composed', 'default', 'off'] as const) {
      const { errors, dispose } = await colourErrors(harness, seeded(7), mode)
      expect(errors.filter((error) => error > 2 / 255).length / errors.length, mode).toBeLessThanOrEqual(0.01)
      dispose()
    }
  })
})

/** Draws a square in mode `first`, then in the paper's mode. Returns the largest error of each pixel against the float64 reference. */
async function colourErrors(harness: Harness, random: () => number, first: WrinkleMode = 'paper') {
  const set = randomSet(random, 1 + Math.floor(random() * 64), MAP, MAP)
  const [diffuse, smooth] = [randomImage(random, MAP), randomNormals(random, MAP)]
  const [normalScale, sun, ambient] = [0.5 + random(), 0.5 + random() * 2, random()]
  const from = new Vector3(random() - 0.5, random() - 0.5, 0.3 + random()).normalize()
  // Texture coordinates stay within one tile, because the GPU picks another mip level where a texture repeats.
  const scale = 0.2 + random() * 0.5
  const offset = [random() * 0.3, random() * 0.3]

  const material = new MeshLambertMaterial({
    map: colourMap(diffuse.data),
    normalMap: normalsMap(smooth.data),
    normalScale: new Vector2(normalScale, -normalScale),
  })
  const mesh = square(material, scale, offset)
  const scene = new Scene()
  const light = new DirectionalLight(0xffffff, sun)
  light.position.copy(from)
  scene.add(mesh, light, new AmbientLight(0xffffff, ambient))
  const wrinkles = new harness.Wrinkles(mesh, set, { mode: first, areaSize: MAP })
  wrinkles.mode = 'paper'
  // Limits activations, so that most sums are not clamped at 1.
  const strength = Math.min(1, 2 / set.areas.length)
  for (const { name, combine } of set.areas) {
    wrinkles.setActivation(name, random() * (combine === 'max' ? 1 : strength))
  }
  const pixels = await harness.render(scene, squareCamera(), PIXELS)

  const areas = packAreas(
    set.areas.map(({ weights }) => weights),
    MAP,
  )
  const colours = packColours([opaque(diffuse), smooth, set.layers[0].normal])
  const table = set.areas.map(({ name, combine }) => ({
    activation: wrinkles.getActivation(name),
    layer: 0,
    combine: combine ?? ('sum' as const),
  }))
  const errors: number[] = []
  for (let i = 0; i < PIXELS * PIXELS; i++) {
    const u = (((i % PIXELS) + 0.5) / PIXELS) * scale + offset[0]
    const v = (1 - (Math.floor(i / PIXELS) + 0.5) / PIXELS) * scale + offset[1]
    const texel = (layer: number) => [0, 1, 2].map((c) => reference.sampleArray(colours, u, v, layer, c))
    const albedo = texel(DIFFUSE).map(toLinear)
    const lit = [SMOOTH, WRINKLED].map((layer) => {
      // y points up in the scene, because in the material v points down and the scale of y is negative.
      const [x, y, z] = reference.unpackNormal(texel(layer))
      const normal = new Vector3(x * normalScale, y * normalScale, z).normalize()
      const irradiance = Math.max(0, normal.dot(from)) * sun + ambient
      return albedo.map((value) => (value / Math.PI) * irradiance)
    })
    const exact = reference.mixColours(lit[0], lit[1], reference.influence(areas, table, u, v))
    errors.push(Math.max(...exact.map((value, c) => Math.abs(value - pixels[i * 4 + c]))))
  }
  const dispose = () => {
    wrinkles.dispose()
    material.map!.dispose()
    material.normalMap!.dispose()
    material.dispose()
    mesh.geometry.dispose()
  }
  return { errors, dispose }
}

/** Decodes sRGB to linear (IEC 61966-2-1). */
function toLinear(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
}

function colourMap(data: Uint8Array): DataTexture {
  const texture = normalsMap(data)
  texture.colorSpace = SRGBColorSpace
  return texture
}

function normalsMap(data: Uint8Array): DataTexture {
  const texture = new DataTexture(data, MAP, MAP)
  texture.minFilter = LinearFilter
  texture.magFilter = LinearFilter
  texture.needsUpdate = true
  return texture
}

function opaque<T extends { data: Uint8Array }>(image: T): T {
  return { ...image, data: image.data.map((value, i) => (i % 4 === 3 ? 255 : value)) }
}
