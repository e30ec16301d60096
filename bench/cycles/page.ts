/**
 * Page that renders a face with three.js and Furrow, and describes the scene so that Cycles can render it too. `?webgl` and `?webgpu` select the API
 * and disable shadows, because shadows differ between engines. By default, the page uses WebGL with shadows.
 */
import * as webgl from 'furrow/three'
import { frameFace, readWrinkleMaps, type WrinkleMode, type Wrinkles } from 'furrow/three'
import * as webgpu from 'furrow/webgpu'
import {
  Box3,
  Color,
  DirectionalLight,
  type Mesh,
  NoToneMapping,
  type Object3D,
  PCFSoftShadowMap,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { PMREMGenerator as NodePMREMGenerator, WebGPURenderer } from 'three/webgpu'
import { AMBIENT, LAMPS, type Shot, SIZE } from './shots.ts'

/** Description of the scene for Cycles, in metres with +Y up. */
export interface Description {
  /** `fov` is the vertical field of view, degrees. */
  camera: { position: number[]; target: number[]; fov: number }
  /** The mesh with wrinkles. */
  skin: {
    name: string
    /** Packed xyz of each vertex of the face at rest, world space. */
    rest: number[]
    /** Packed xyz of each vertex in the pose, world space. */
    positions: number[]
    /** Packed xyz of each normal of the face at rest, world space. */
    normals: number[]
    uvs: number[]
    triangles: number[]
  }
  activations: Record<string, number>
}

declare global {
  interface Window {
    /** Loads a face and poses it as the shot describes. */
    pose(address: string, shot: Shot): Promise<Description>
    /** Renders the posed face. Returns a PNG data URL with a transparent background. */
    draw(mode: WrinkleMode): string
  }
}

const FIELD_OF_VIEW = 22

const canvas = document.createElement('canvas')
const hasShadows = location.search === ''
const isWebGPU = location.search === '?webgpu'
const settings = { canvas, antialias: true, alpha: true, preserveDrawingBuffer: true }
const renderer = isWebGPU ? new WebGPURenderer(settings) : new WebGLRenderer(settings)
renderer.setSize(SIZE, SIZE)
renderer.toneMapping = NoToneMapping
renderer.shadowMap.enabled = hasShadows
renderer.shadowMap.type = PCFSoftShadowMap
renderer.setClearColor(0, 0)

const camera = new PerspectiveCamera(FIELD_OF_VIEW, 1)
let scene: Scene
let wrinkles: Wrinkles

window.pose = async (address, shot) => {
  const gltf = await new GLTFLoader().loadAsync(address)
  if ('init' in renderer) await renderer.init()
  const [{ meshes, set, drivers }] = await readWrinkleMaps(gltf)
  const { Wrinkles, addDrivers } = isWebGPU ? webgpu : webgl
  wrinkles = new Wrinkles(meshes[0], set, { relief: shot.relief ?? 'on' }) as Wrinkles
  for (const mesh of meshes.slice(1)) wrinkles.addMesh(mesh)
  // Without `time` drivers, activations have their final values at once.
  addDrivers(
    wrinkles,
    drivers.filter(({ type }) => type !== 'time'),
  )
  scene = new Scene()
  scene.add(gltf.scene)
  pose(gltf.scene, shot.targets)
  const target = frameFace(camera, gltf.scene, shot.view)
  light(gltf.scene)
  await wrinkles.reliefReady()
  wrinkles.update()
  const activations = wrinkles.areaNames.map((name) => [name, wrinkles.getActivation(name)])
  return {
    camera: { position: camera.position.toArray(), target: target.toArray(), fov: FIELD_OF_VIEW },
    skin: skinOf(wrinkles.mesh),
    activations: Object.fromEntries(activations),
  }
}

window.draw = (mode) => {
  wrinkles.mode = mode
  renderer.render(scene, camera)
  return canvas.toDataURL()
}

function pose(face: Object3D, targets: Record<string, number>): void {
  face.traverse((object) => {
    const { morphTargetDictionary, morphTargetInfluences } = object as Mesh
    for (const [name, index] of Object.entries(morphTargetDictionary ?? {})) {
      morphTargetInfluences![index] = targets[name] ?? 0
    }
  })
  face.updateMatrixWorld()
}

/** Adds lights. Transparent eyelash cards cast no shadows, because shadow maps would treat them as opaque. */
function light(face: Object3D): void {
  const ambient = new Scene()
  ambient.background = new Color(AMBIENT, AMBIENT, AMBIENT)
  const blurred = isWebGPU
    ? new NodePMREMGenerator(renderer as WebGPURenderer)
    : new PMREMGenerator(renderer as WebGLRenderer)
  scene.environment = blurred.fromScene(ambient).texture
  const bounds = new Box3().setFromObject(face)
  const centre = bounds.getCenter(new Vector3())
  const radius = bounds.getSize(new Vector3()).length() / 2
  face.traverse((object) => {
    const { material } = object as Mesh
    object.castShadow = !Array.isArray(material) && !material?.transparent
    object.receiveShadow = true
  })
  for (const { from, strength } of LAMPS) {
    const lamp = new DirectionalLight(0xffffff, strength)
    lamp.position
      .fromArray(from)
      .setLength(2 * radius)
      .add(centre)
    lamp.target.position.copy(centre)
    lamp.castShadow = hasShadows
    Object.assign(lamp.shadow.camera, {
      left: -radius,
      right: radius,
      top: radius,
      bottom: -radius,
      near: radius,
      far: 3 * radius,
    })
    lamp.shadow.mapSize.set(4096, 4096)
    lamp.shadow.normalBias = radius / 500
    scene.add(lamp, lamp.target)
  }
}

function skinOf(mesh: Mesh): Description['skin'] {
  const { position, normal, uv } = mesh.geometry.attributes
  const count = position.count
  const point = new Vector3()
  const each = (read: (i: number) => number[]) => Array.from({ length: count }, (_, i) => read(i)).flat()
  return {
    name: mesh.name,
    rest: each((i) => point.fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld).toArray()),
    positions: each((i) => mesh.getVertexPosition(i, point).applyMatrix4(mesh.matrixWorld).toArray()),
    normals: each((i) => point.fromBufferAttribute(normal, i).transformDirection(mesh.matrixWorld).toArray()),
    uvs: each((i) => [uv.getX(i), uv.getY(i)]),
    triangles: [...mesh.geometry.index!.array],
  }
}
