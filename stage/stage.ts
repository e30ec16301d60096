/** Creates a lit three.js scene for a face. The studio, `furrow render`, the figures and the tests use it. */

import {
  addDrivers,
  type FaceView,
  type LoadedWrinkles,
  Wrinkles as WebGLWrinkles,
  type WrinklesOptions,
} from 'furrow/three'
import type { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import {
  ACESFilmicToneMapping,
  type Material,
  MathUtils,
  type Mesh,
  PerspectiveCamera,
  Scene,
  SRGBColorSpace,
  type Vector3,
  WebGLRenderer,
} from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import type { Face } from './face.ts'
import { isWebGL, type Lighting, lightScene } from './light.ts'
import { type CloseUp, frameCloseUp, frameView, type ViewName } from './views.ts'

export type RendererKind = 'webgl' | 'webgpu'
export type Renderer = WebGLRenderer | WebGPURenderer
export type Wrinkles = WebGLWrinkles | WebGPUWrinkles

export interface Stage {
  renderer: Renderer
  /** Graphics API in use: WebGPURenderer falls back to WebGL 2 in browsers without WebGPU. */
  backend: 'WebGL 2' | 'WebGPU'
  scene: Scene
  camera: PerspectiveCamera
  /** Key light, see `Lighting.key`. */
  key: Lighting['key']
  /** Replaces the face in the scene. Does not add wrinkles. */
  show(face: Face): void
  /** Adds wrinkles to a face. Callers must dispose of them. */
  addWrinkles(
    face: Face,
    loaded: Pick<LoadedWrinkles, 'set' | 'drivers'>,
    options?: WrinklesOptions,
  ): Wrinkles
  /** Creates wrinkles for a mesh that shares the maps of other wrinkles. Callers must dispose of them. */
  mirror(mesh: Mesh, wrinkles: Wrinkles): Wrinkles
  /**
   * Moves the camera to a view of the face. Rotates the lights so that they light the front of the face; the `light` of a close-up adds to this
   * rotation. Returns the point that the camera looks at.
   */
  view(view: ViewName | Required<FaceView> | CloseUp): Vector3
  /** @param pixelRatio device pixels per CSS pixel. */
  resize(width: number, height: number, pixelRatio?: number): void
  render(): void
  dispose(): void
}

/**
 * Creates a stage that draws on a canvas.
 *
 * @throws Error if the browser has no WebGL 2. With kind `webgpu`, WebGPU suffices.
 */
export async function createStage(canvas: HTMLCanvasElement, kind: RendererKind): Promise<Stage> {
  // Most pages never use WebGPU, whose renderer is 220 kB (gzip).
  const webgpu = kind === 'webgpu' ? await import('./webgpu.ts') : null
  const renderer = webgpu
    ? new webgpu.WebGPURenderer({ canvas, antialias: true })
    : new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true })
  if (!isWebGL(renderer)) await renderer.init()
  renderer.toneMapping = ACESFilmicToneMapping
  renderer.outputColorSpace = SRGBColorSpace
  const scene = new Scene()
  const camera = new PerspectiveCamera()
  const environment = webgpu ? webgpu.environmentGenerator(renderer as WebGPURenderer) : undefined
  const lighting = lightScene(scene, renderer, environment)
  let shown: Face | null = null
  return {
    renderer,
    backend: backendName(renderer),
    scene,
    camera,
    key: lighting.key,
    show(face) {
      if (shown) scene.remove(shown.root)
      shown = face
      scene.add(face.root)
    },
    addWrinkles(face, { set, drivers }, options) {
      separateMaterial(face)
      const wrinkles = webgpu
        ? new webgpu.Wrinkles(face.skin, set, options)
        : new WebGLWrinkles(face.skin, set, options)
      for (const part of face.parts) wrinkles.addMesh(part)
      addDrivers(wrinkles, drivers)
      return wrinkles
    },
    view(view) {
      const face = shown?.root ?? scene
      const isCloseUp = typeof view === 'object' && 'point' in view
      const { target, front } = isCloseUp ? frameCloseUp(face, camera, view) : frameView(face, camera, view)
      lighting.turn(front + (isCloseUp ? MathUtils.degToRad(view.light) : 0))
      return target
    },
    resize(width, height, pixelRatio = 1) {
      renderer.setPixelRatio(pixelRatio)
      renderer.setSize(width, height, false)
      camera.aspect = width / height
      camera.updateProjectionMatrix()
    },
    mirror: (mesh, wrinkles) =>
      webgpu ? new webgpu.Wrinkles(mesh, wrinkles) : new WebGLWrinkles(mesh, wrinkles),
    render: () => void renderer.render(scene, camera),
    dispose() {
      lighting.remove()
      renderer.dispose()
    },
  }
}

/** Clones the material for other meshes that share it with the skin, e.g. eyes, so that they show no wrinkles. */
function separateMaterial({ root, skin, parts }: Face): void {
  const { material } = skin
  if (Array.isArray(material)) return
  let plain: Material | undefined
  root.traverse((object) => {
    const mesh = object as Mesh
    if (!mesh.isMesh || mesh.material !== material || mesh === skin || parts.includes(mesh)) return
    plain ??= material.clone()
    mesh.material = plain
  })
}

function backendName(renderer: Renderer): 'WebGL 2' | 'WebGPU' {
  const backend = (renderer as { backend?: { isWebGPUBackend?: boolean } }).backend
  return backend?.isWebGPUBackend ? 'WebGPU' : 'WebGL 2'
}
