import { MeshoptSimplifier } from 'meshoptimizer'
import {
  Box3,
  type BufferAttribute,
  type BufferGeometry,
  InstancedMesh,
  type Material,
  Matrix4,
  type Mesh,
  OrthographicCamera,
  Vector3,
} from 'three'
import type { Plan } from '../case.ts'
import type { Bench } from './bench.ts'
import { applyFurrow } from './furrow.ts'
import { createSet, createSkin } from './scene.ts'

/** Number and sizes of the faces in a crowd. */
export interface CrowdKind {
  faces: number
  /** Height of a face on screen, pixels. */
  pixels: number
  /** Width and height of areas, texels. */
  areaSize: number
}

export const CROWD_KINDS: readonly CrowdKind[] = [
  { faces: 1000, pixels: 60, areaSize: 32 },
  { faces: 10_000, pixels: 20, areaSize: 16 },
]

/** Picture size in pixels. All faces of each crowd fit into it. */
export const CROWD_PICTURE = { width: 1920, height: 1600 }

/** Areas per face. The activations of all of them change every frame. */
const AREAS = 8
/** Blendshapes with a nonzero weight per face, about as many as an expression has. */
const ACTIVE_SHAPES = 6
/** Times the square of a face's height in pixels, this is its number of triangles. A visible triangle then covers about four pixels. */
const TRIANGLE_DENSITY = 0.42
/** Instances per mesh. three.js stores blendshape weights in a texture with one row per instance, and most devices allow 8192 rows. */
const MAX_INSTANCES = 5000
/** Number of influence map updates that are timed together, because one update is far shorter than a frame. */
const UPDATES = 8

/**
 * Measures how much of a crowd's frame time is spent on influence maps. The activations of all faces change before each update and each frame.
 *
 * @returns for each round, the time to update the influence maps of all faces, divided by the time of a full frame, 0..1.
 */
export async function measureCrowd(bench: Bench, kind: CrowdKind, plan: Plan): Promise<number[]> {
  const { timedRenderer } = bench
  const crowd = await createCrowd(bench, kind)
  const drawMaps = () => {
    for (let i = 0; i < UPDATES; i++) {
      crowd.move()
      for (const wrinkles of crowd.wrinkles) timedRenderer.update(wrinkles)
    }
  }
  const drawFrame = () => {
    crowd.move()
    crowd.draw()
  }
  await timedRenderer.time(drawMaps)
  await timedRenderer.time(drawFrame)
  const fractions = []
  for (let round = 0; round < plan.rounds; round++) {
    const maps = (await timedRenderer.time(drawMaps)) / UPDATES
    fractions.push(maps / (await timedRenderer.time(drawFrame)))
  }
  crowd.dispose()
  return fractions
}

async function createCrowd(
  { face, scene, timedRenderer, renderer }: Bench,
  { faces, pixels, areaSize }: CrowdKind,
) {
  const { width, height } = CROWD_PICTURE
  const camera = new OrthographicCamera(0, width, 0, -height, -pixels, pixels)
  const skin = createSkin(face)
  await MeshoptSimplifier.ready
  const geometry = simplified(skin.geometry, TRIANGLE_DENSITY * pixels ** 2)
  const places = placesOf(geometry, faces, pixels)
  const set = createSet(face, { areas: AREAS, layers: 1, maps: 'normals' })
  const parts = Array.from({ length: Math.ceil(faces / MAX_INSTANCES) }, (_, i) => {
    const mesh = instancesOf(skin, geometry, places.slice(i * MAX_INSTANCES, (i + 1) * MAX_INSTANCES))
    scene.add(mesh)
    return { mesh, wrinkles: applyFurrow(mesh, set, renderer, { areaSize }) }
  })
  const names = set.areas.map(({ name }) => name)
  const values = new Float32Array(AREAS)
  let frame = 0
  return {
    wrinkles: parts.map(({ wrinkles }) => wrinkles),
    move() {
      frame++
      for (const { wrinkles } of parts) {
        for (let i = 0; i < wrinkles.faceCount; i++) {
          for (let k = 0; k < AREAS; k++) values[k] = 0.55 + 0.45 * Math.sin(frame * 0.37 + k * 2.4 + i)
          wrinkles.setActivations(names, values, i)
        }
      }
    },
    draw: () => timedRenderer.draw(scene, camera),
    dispose() {
      geometry.dispose()
      for (const { mesh, wrinkles } of parts) {
        wrinkles.dispose()
        scene.remove(mesh)
        mesh.dispose()
        ;(mesh.material as Material).dispose()
      }
    },
  }
}

function simplified(full: BufferGeometry, triangles: number): BufferGeometry {
  const geometry = full.clone()
  const positions = geometry.getAttribute('position').array as Float32Array
  const index = Uint32Array.from(geometry.index!.array)
  geometry.setIndex([...MeshoptSimplifier.simplify(index, positions, 3, 3 * Math.floor(triangles), 1)[0]])
  return geometry
}

/** Returns a transform for each face: rows of faces from the picture's top left corner, in pixels. */
function placesOf(geometry: BufferGeometry, faces: number, pixels: number): Matrix4[] {
  const box = new Box3().setFromBufferAttribute(geometry.getAttribute('position') as BufferAttribute)
  const size = box.getSize(new Vector3())
  const scale = pixels / size.y
  const columns = Math.floor(CROWD_PICTURE.width / (size.x * scale))
  return Array.from({ length: faces }, (_, i) => {
    const x = (i % columns) * size.x - box.min.x
    const y = Math.floor(i / columns) * size.y + box.max.y
    const z = box.min.z + size.z / 2
    return new Matrix4().makeScale(scale, scale, scale).setPosition(scale * x, -scale * y, -scale * z)
  })
}

function instancesOf(skin: Mesh, geometry: BufferGeometry, places: readonly Matrix4[]): InstancedMesh {
  const mesh = new InstancedMesh(geometry, (skin.material as Material).clone(), places.length)
  mesh.frustumCulled = false
  const targets = skin.morphTargetInfluences!
  for (const [i, place] of places.entries()) {
    for (let k = 0; k < ACTIVE_SHAPES; k++) targets[k] = 0.5 + 0.5 * Math.sin(i + k)
    mesh.setMorphAt(i, skin)
    mesh.setMatrixAt(i, place)
  }
  mesh.morphTexture!.needsUpdate = true
  return mesh
}
