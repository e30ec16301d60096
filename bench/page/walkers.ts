import { extendLoader, type Wrinkles, wrinklesOf } from 'furrow/three'
import { extendLoader as extendForWebGPU } from 'furrow/webgpu'
import { MeshoptSimplifier } from 'meshoptimizer'
import {
  AnimationMixer,
  type BufferAttribute,
  Group,
  type Object3D,
  OrthographicCamera,
  type SkinnedMesh,
} from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone } from 'three/addons/utils/SkeletonUtils.js'
import type { Plan } from '../case.ts'
import type { Bench } from './bench.ts'
import { changedFraction } from './changed.ts'
import { CROWD_PICTURE } from './crowd.ts'

/** Number of walking characters. */
export const WALKERS = 1000
/** Meshes of `faces/body.glb` that each character has. Both have folds. */
const CLOTHES = ['shirt', 'trousers']
/** Width of a place and height of a character on screen, pixels. */
const [ACROSS, PIXELS] = [38, 78]
/** Height of the figure in metres, and height of its middle above the origin of its file. */
const [TALL, MIDDLE] = [1.75, -0.05]
/** Triangles of a mesh per square of the height in pixels. A visible triangle then covers about four pixels. */
const TRIANGLE_DENSITY = 0.2
/** Resolution of areas and influence maps, texels. */
const AREA_SIZE = 32
/** Time between two frames of the walk, seconds. */
const STEP = 1 / 60
/** Minimum fraction of pixels that the folds of the crowd must change. */
const MIN_CHANGED = 0.0005

/**
 * Measures a crowd of walking characters, with folds and without. Each character is a copy of the shirt and the trousers of a figure with
 * its own skeleton, because three.js cannot give instances their own poses. Drivers read the bones of each copy in each frame.
 *
 * @param url address of `faces/body.glb`.
 * @returns for each round, the time of a frame with folds divided by that of a frame without.
 * @throws Error if folds change too few pixels.
 */
export async function measureWalkers(
  { renderer, scene, timedRenderer }: Bench,
  url: string,
  count: number,
  { rounds }: Plan,
): Promise<number[]> {
  const { width, height } = CROWD_PICTURE
  const camera = new OrthographicCamera(0, width, 0, -height, -PIXELS, PIXELS)
  const extend = renderer === 'webgl' ? extendLoader : extendForWebGPU
  const options = { areaSize: AREA_SIZE, relief: 'off' } as const
  await MeshoptSimplifier.ready
  const figures = [
    await new GLTFLoader().loadAsync(url),
    await extend(new GLTFLoader(), options).loadAsync(url),
  ]
  const crowds = figures.map((gltf) => crowdOf(gltf, count))
  const drawFrame = ({ group, move }: Crowd) => {
    group.visible = true
    move()
    timedRenderer.draw(scene, camera)
    group.visible = false
  }
  const time = (crowd: Crowd) => timedRenderer.time(() => drawFrame(crowd))
  for (const { group } of crowds) {
    group.visible = false
    scene.add(group)
  }
  try {
    const pictures = []
    for (const crowd of crowds) {
      drawFrame(crowd)
      pictures.push(await timedRenderer.read())
    }
    const changed = changedFraction(pictures[0]!, pictures[1]!) * (WALKERS / count)
    if (changed < MIN_CHANGED)
      throw new Error(
        `bench: walkers show no folds, they change ${(100 * changed).toFixed(3)}% of the pixels, allowed: at least ${100 * MIN_CHANGED}%`,
      )
    const ratios: number[] = []
    for (let round = 0; round < rounds; round++) {
      const plain = await time(crowds[0]!)
      ratios.push((await time(crowds[1]!)) / plain)
    }
    return ratios
  } finally {
    for (const { group, wrinkles } of crowds) {
      for (const each of wrinkles) each.dispose()
      scene.remove(group)
    }
  }
}

interface Crowd {
  group: Group
  wrinkles: Wrinkles[]
  /** Moves all characters to the next frame of the walk. */
  move(): void
}

function crowdOf(gltf: GLTF, count: number): Crowd {
  prepare(gltf.scene)
  const group = new Group()
  const scale = PIXELS / TALL
  const columns = Math.floor(CROWD_PICTURE.width / ACROSS)
  const walk = gltf.animations.find(({ name }) => name === 'walk')!
  const mixers = Array.from({ length: count }, (_, i) => {
    const character = clone(gltf.scene)
    character.scale.setScalar(scale)
    character.position.set(
      ((i % columns) + 0.5) * ACROSS,
      -(Math.floor(i / columns) + 0.5) * PIXELS - MIDDLE * scale,
      0,
    )
    // Characters look in different directions, as in a street.
    character.rotation.y = 2.4 * i
    group.add(character)
    const mixer = new AnimationMixer(character)
    mixer.clipAction(walk).play()
    mixer.setTime((0.37 * i) % walk.duration)
    return mixer
  })
  const wrinkles: Wrinkles[] = []
  group.traverse((object) => {
    const found = (object as SkinnedMesh).isMesh && wrinklesOf(object as SkinnedMesh)
    if (found) wrinkles.push(found as Wrinkles)
  })
  return {
    group,
    wrinkles,
    move() {
      for (const mixer of mixers) mixer.update(STEP)
    },
  }
}

/** Removes meshes without folds, and simplifies the others. */
function prepare(root: Object3D): void {
  const meshes: SkinnedMesh[] = []
  root.traverse((object) => {
    if ((object as SkinnedMesh).isMesh) meshes.push(object as SkinnedMesh)
  })
  for (const mesh of meshes) {
    if (!CLOTHES.includes(mesh.name)) {
      mesh.removeFromParent()
      continue
    }
    const { geometry } = mesh
    const positions = geometry.getAttribute('position') as BufferAttribute
    const target = 3 * Math.floor(TRIANGLE_DENSITY * PIXELS ** 2)
    const index = Uint32Array.from(geometry.index!.array)
    geometry.setIndex([
      ...MeshoptSimplifier.simplify(index, positions.array as Float32Array, 3, target, 1)[0],
    ])
    // Bounds of a skinned mesh are computed per frame from all vertices.
    mesh.frustumCulled = false
  }
}
