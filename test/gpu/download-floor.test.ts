import { WrinkleLoaderPlugin } from 'furrow/three'
import { AmbientLight, Box3, DirectionalLight, type Mesh, PerspectiveCamera, Scene, Vector3 } from 'three'
import { GLTFLoader, type GLTFLoaderPlugin, type GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest'
import { floorPlugin } from '../../bench/download/floor.ts'
import { surfaceChannels } from '../../bench/download/surface.ts'
import { editGlb } from '../glb.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness } from './harness.ts'

type PluginMaker = (parser: GLTFParser) => GLTFLoaderPlugin

/** Blendshapes, as they move. */
const EXPRESSIONS = [
  { browInnerUp: 1, browDownLeft: 0.8, noseSneerLeft: 1 },
  { mouthSmileLeft: 1, mouthSmileRight: 0.7, cheekSquintLeft: 1, mouthPucker: 0.5 },
]

describe('the floor of the download', () => {
  let harness: Harness
  let file: Uint8Array
  beforeAll(async () => {
    file = new Uint8Array(await (await fetch('/faces/human.glb')).arrayBuffer())
  })
  // A renderer for each: three.js would take the two floors' programs for the same, which a page with one of them does not care about.
  beforeEach(async () => {
    harness = await createHarness('webgl')
  })
  afterEach(() => harness.dispose())

  /** Pictures of two faces, one after the other, each with all expressions. */
  const pictures = async (face: Uint8Array, plugin?: PluginMaker) => {
    const loader = new GLTFLoader()
    if (plugin) loader.register(plugin)
    const taken: Uint8Array[] = []
    for (let i = 0; i < 2; i++) {
      const { scene } = await loader.parseAsync(face.slice().buffer, '')
      const light = new DirectionalLight(0xffffff, 2)
      light.position.set(-1, 1.35, 0.95)
      const camera = new PerspectiveCamera(20, 1, 0.01, 10)
      camera.position.copy(new Box3().setFromObject(scene).getCenter(new Vector3())).z += 1
      const all = new Scene().add(scene, light, new AmbientLight(0xffffff, 0.5))
      const { morphTargetInfluences: weights, morphTargetDictionary: indices } = scene.getObjectByName(
        'skin',
      ) as Mesh
      for (const expression of EXPRESSIONS) {
        weights!.fill(0)
        for (const [name, weight] of Object.entries(expression)) weights![indices![name]] = weight
        taken.push(await harness.renderBytes(all, camera, 256))
      }
    }
    return taken
  }

  const furrow: PluginMaker = (parser) => new WrinkleLoaderPlugin(parser)
  const withoutSurface = () =>
    editGlb(file, ({ materials }) => {
      const [layer] = materials[0].extensions.FURROW_wrinkle_maps.layers
      for (const map of ['occlusionTexture', 'bloodTexture', 'heightTexture']) delete layer[map]
    })

  it.each([
    ['normals only', withoutSurface, floorPlugin()],
    ['all maps', () => file, floorPlugin(surfaceChannels)],
  ])("shows the library's picture with %s", async (_, face, floor) => {
    const plain = await pictures(face())
    const shown = await pictures(face(), floor)
    const expected = await pictures(face(), furrow)
    for (const [i, picture] of shown.entries()) {
      expect(largestDifference(picture, expected[i]), `picture ${i}`).toBeLessThanOrEqual(2)
      expect(largestDifference(plain[i], expected[i]), `picture ${i}, plain`).toBeGreaterThan(20)
    }
  })
})
