import type { Layer, WrinkleSet } from 'furrow'
import { scaleLayer, updateLayer } from 'furrow/three'
import { ClampToEdgeWrapping, type DataTexture, type Material, Mesh, MeshPhysicalMaterial } from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomImage, randomNormals, randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { FRAMES, faceOf, MAP, UNSEEN, useFaces } from './auto-face.ts'
import { largestDifference } from './difference.ts'
import { createHarness, RENDERERS, squareCamera } from './harness.ts'
import { loseContext } from './lose-context.ts'
import { normalMap } from './normal-map.ts'

/** Of a dual map of that size with its mipmaps. */
const BYTES = (MAP * MAP * 4 * 4) / 3

function material(options: ConstructorParameters<typeof MeshPhysicalMaterial>[0] = {}) {
  return new MeshPhysicalMaterial({ normalMap: normalMap(2, MAP), roughness: 0.6, ...options })
}

function setWith(...layers: Layer[]): WrinkleSet {
  const set = randomSet(seeded(4), 6, 16, MAP)
  const areas = set.areas.map((area, i) => ({ ...area, layer: layers[i % layers.length].name }))
  return { ...set, areas, layers }
}

function gray(seed: number) {
  const random = seeded(seed)
  return { width: MAP, height: MAP, data: Uint8Array.from({ length: MAP * MAP }, () => 256 * random()) }
}

const normals = (seed: number) => randomNormals(seeded(seed), MAP)

/** Occlusion, roughness and metalness, which are not glossy. */
function roughMap(seed: number): DataTexture {
  const map = normalMap(seed, MAP)
  map.image.data = map.image.data!.map((value, i) => (i % 4 === 1 ? 230 + value / 10 : value))
  return map
}

function hasValues({ occlusion, blood }: WrinkleSet['layers'][number]): boolean {
  return (occlusion ?? blood) !== undefined
}

/** Every kind of map and layer that there is. */
const SETS: [string, WrinkleSet][] = [
  ['a layer that replaces', setWith(layer('skin', 'replace', normals(5)))],
  ['a layer of details', setWith(layer('skin', 'detail', normals(5)))],
  [
    'three layers',
    setWith(
      layer('up', 'detail', normals(5)),
      layer('down', 'replace', normals(6)),
      layer('in', 'detail', normals(7)),
    ),
  ],
  ['occlusion', setWith({ ...layer('skin', 'detail', normals(5)), occlusion: gray(8) })],
  [
    'occlusion and blood of two layers',
    setWith(
      { ...layer('up', 'detail', normals(5)), occlusion: gray(8), occlusionStrength: 0.7 },
      {
        ...layer('down', 'replace', normals(6)),
        occlusion: gray(9),
        blood: gray(10),
        bloodAmplitude: 0.8,
      },
    ),
  ],
  ['blood', setWith({ ...layer('skin', 'replace', normals(5)), blood: gray(10), bloodAmplitude: 1.5 })],
]

describe.each(RENDERERS)('maps of the mode auto on %s', (name) => {
  const faces = useFaces(name)
  const { face, disposers } = faces

  it.each(SETS)('a face with %s looks the same while it moves and while it is still', async (_, set) => {
    const aoMap = normalMap(11, MAP)
    const occluded = material({ aoMap, aoMapIntensity: 0.8 })
    // As glTF has them.
    const orm = roughMap(11)
    const packed = material({
      aoMap: orm,
      roughnessMap: orm,
      metalnessMap: orm,
      metalness: 0.6,
      roughness: 1,
    })
    const owns = [material(), occluded]
    if (set.layers.some(({ occlusion }) => occlusion)) owns.push(packed)
    for (const own of owns) {
      const { aoMap: before } = own
      const { picture, moved, composed, wanted, shown } = face({}, own, set)
      await moved()
      expect(shown.isOcclusionReplaced).toBe(own.aoMap !== null && hasValues(set.layers[0]))
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      await composed()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      expect(own.aoMap).toBe(before)
    }
  })

  it('occlusion at other texture coordinates, base colours and roughness are mixed in while a face is still, too', async () => {
    const aoMap = normalMap(11, MAP)
    aoMap.repeat.set(2, 2)
    const occluded = setWith({ ...layer('skin', 'detail', normals(5)), occlusion: gray(8) })
    const rough = setWith({ ...layer('skin', 'detail', normals(5)), roughness: gray(8) })
    const every = setWith({
      ...layer('skin', 'detail', normals(5)),
      baseColor: randomImage(seeded(13), MAP),
      roughness: { ...gray(9), data: gray(9).data.map((value) => 200 + value / 5) },
      occlusion: gray(8),
      blood: gray(10),
      bloodAmplitude: 0.8,
    })
    for (const [own, set, isOcclusionReplaced] of [
      [material({ aoMap }), occluded, false],
      [material(), rough, false],
      [material({ aoMap: normalMap(11, MAP) }), every, true],
    ] as const) {
      const { wrinkles, shown, moved, picture, wanted, frames } = face({}, own, set)
      await moved()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      wrinkles.mode = 'auto'
      await moved()
      await frames()
      expect(shown).toMatchObject({ isComposed: false, isDual: true, isOcclusionReplaced })
    }
  })

  it('follows the scale of a layer, and is made anew for maps that change', async () => {
    const { wrinkles, shown, moved, picture, wanted, material } = face()
    await moved()
    material.normalScale.set(0.6, 1.2)
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    scaleLayer(wrinkles, 'skin', { normalScale: 0.5 })
    await moved()
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    await moved()
    updateLayer(wrinkles, 'skin', { normal: normals(12) })
    expect(largestDifference(await picture(), await wanted())).toBe(0)
    expect(shown.isDual).toBe(false)
    await moved()
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
  })

  it('is made anew when the map of occlusion changes, and not used when it is taken away', async () => {
    const set = setWith({
      ...layer('skin', 'detail', normals(5)),
      occlusion: gray(8),
      blood: gray(10),
      bloodAmplitude: 0.8,
    })
    const aoMap = normalMap(11, MAP)
    const { material: own, moved, composed, picture, wanted, shown } = face({}, material({ aoMap }), set)
    for (const shows of [moved, composed]) {
      await shows()
      aoMap.image.data!.reverse()
      aoMap.needsUpdate = true
      expect(largestDifference(await picture(), await wanted())).toBe(0)
      await shows()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      expect(shown.isOcclusionReplaced).toBe(true)
    }
    own.aoMap = null
    own.needsUpdate = true
    await moved()
    expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
    expect(own.aoMap).toBe(null)
  })

  it('faces with the same maps share one', async () => {
    const set = randomSet(seeded(4), 6, 16, MAP)
    const own = material()
    const budget = { textureBudget: 1.5 * BYTES }
    const first = face(budget, own, set)
    await first.moved()
    const clone = own.clone() as MeshPhysicalMaterial
    const second = faceOf(faces.harness, budget, clone, first.wrinkles)
    disposers.push(() => second.wrinkles.dispose())
    await second.moved()
    const third = face(budget, material({ normalMap: normalMap(3, MAP) }), set)
    await third.frames()
    expect(third.shown.isDual).toBe(false)
  })

  it.each(SETS.slice(0, 2))(
    'a mesh that the wrinkles are not told of shares them, or has none, with %s',
    async (_, set) => {
      const { mesh, wrinkles, scene, moved, picture } = face({}, material(), set)
      await moved()
      const wrinkled = await picture()
      // Drawn after the face, and unknown to it.
      const other = new Mesh(mesh.geometry, mesh.material as Material)
      other.renderOrder = 1
      scene.add(other)
      const shared = await picture()
      wrinkles.mode = 'off'
      const differences = [wrinkled, await picture()].map((known) => largestDifference(shared, known))
      expect(Math.min(...differences)).toBeLessThanOrEqual(UNSEEN)
      other.removeFromParent()
    },
  )

  it('normal maps that do not repeat, of faces that wrap, are left alone', async () => {
    const clamped = normalMap(2, MAP)
    clamped.wrapS = ClampToEdgeWrapping
    const { shown, frames, mesh } = face({}, material({ normalMap: clamped }))
    const uv = mesh.geometry.getAttribute('uv')
    for (let i = 0; i < uv.count; i++) uv.setXY(i, 1.5 * uv.getX(i), uv.getY(i))
    await frames()
    expect(shown.isDual).toBe(false)
  })

  if (name === 'webgl') {
    it('a page that reads the normal map in its own way keeps the default mode', async () => {
      const own = material()
      own.onBeforeCompile = (shader) => {
        const read = 'gl_FragColor.b *= texture2D( normalMap, vNormalMapUv ).b;'
        shader.fragmentShader = shader.fragmentShader.replace('#include <dithering_fragment>', read)
      }
      const set = setWith({ ...layer('skin', 'detail', normals(5)), occlusion: gray(8) })
      const { shown, frames, wanted } = face({}, own, set)
      expect(largestDifference(await frames(3 * FRAMES), await wanted())).toBe(0)
      expect(shown).toMatchObject({ isComposed: false, isDual: false })
    })

    it('is drawn again when a context is restored', async () => {
      const lost = await createHarness('webgl')
      const { moved, picture, wanted, wrinkles } = faceOf(lost)
      await moved()
      await loseContext(lost, () => {})
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      await moved()
      expect(largestDifference(await picture(), await wanted())).toBeLessThanOrEqual(UNSEEN)
      wrinkles.dispose()
      lost.dispose()
    })
  }

  it('a face that is disposed of while its map is made leaves nothing behind', async () => {
    const { memory } = faces.harness.renderer.info
    // The renderer keeps textures of its own.
    await face().picture()
    const before = memory.textures
    const occluded = setWith({ ...layer('skin', 'detail', normals(5)), occlusion: gray(8) })
    for (const own of [face(), face({}, material({ aoMap: normalMap(11, MAP) }), occluded)]) {
      const { wrinkles, scene, material } = own
      for (let i = 0; i < FRAMES; i++) faces.harness.renderer.render(scene, squareCamera())
      // In the middle of it.
      await Promise.resolve()
      wrinkles.dispose()
      await new Promise((resolve) => setTimeout(resolve, 100))
      material.normalMap!.dispose()
      material.aoMap?.dispose()
    }
    expect(memory.textures).toBeLessThanOrEqual(before + 1)
  })

  it('what a page sets during a draw stays', async () => {
    const set = setWith({ ...layer('skin', 'detail', normals(5)), occlusion: gray(8) })
    const {
      material: own,
      mesh,
      moved,
      composed,
      picture,
      shown,
    } = face({}, material({ aoMap: normalMap(11, MAP) }), set)
    for (const shows of [moved, composed]) {
      await shows()
      const other = normalMap(12, MAP)
      const { onAfterRender } = mesh
      let isReplaced = false
      mesh.onAfterRender = (...drawn) => {
        isReplaced = shown.isOcclusionReplaced
        own.aoMap = other
        onAfterRender.apply(mesh, drawn)
      }
      await picture()
      mesh.onAfterRender = onAfterRender
      expect(isReplaced).toBe(true)
      expect(own.aoMap).toBe(other)
    }
  })
})
