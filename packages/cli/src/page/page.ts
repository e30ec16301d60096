/**
 * Page that `furrow render` opens in a browser. Draws images of one face with the stage (the lit scene of all Furrow
 * tools) and posts the pixels to Node.
 */

import { EXPRESSIONS, type Expression, findTargets } from 'furrow'
import { ExpressionPlayer, type LoadedWrinkles, loadWrinkleSet } from 'furrow/three'
import { type Mesh, type Object3D, Quaternion } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import type { Face } from '../../../../stage/face.ts'
import { isWebGL } from '../../../../stage/light.ts'
import { createStage, type Renderer, type Stage, type Wrinkles } from '../../../../stage/stage.ts'
import type { ViewName } from '../../../../stage/views.ts'
import type { PageJob, PageReport, VIEW_NAMES } from '../render/picture.ts'
import { loadAvatar } from './load-avatar.ts'
import { readPicture } from './read-canvas.ts'

// Node cannot import the stage, so it has its own list of views. The type check fails if the lists differ.
type Same<A, B> = [A, B] extends [B, A] ? true : never
const sameViews: Same<ViewName, (typeof VIEW_NAMES)[number]> = true
void sameViews

const warnings: string[] = []
console.warn = (...parts: unknown[]) => void warnings.push(parts.map(String).join(' '))

window.drawPicture = async (job) => {
  try {
    return await draw(job)
  } catch (error) {
    return { error: error instanceof Error ? error.message : String(error) }
  }
}

/** Objects that all images of a page share. */
interface Scene {
  stage: Stage
  face: Face
  /**
   * Wrinkles of the face, or null if it has none. Drivers of type `time` are removed, because they delay activations,
   * and an image shows the activations after the delay.
   */
  loaded: Pick<LoadedWrinkles, 'set' | 'drivers'> | null
  /** Blendshape weights that the file sets. */
  initialWeights: Map<Mesh, readonly number[]>
  /** Rotations that the file sets. */
  restRotations: Map<Object3D, Quaternion>
}

let scene: Scene | undefined
/** Wrinkles of the previous image. */
let wrinkles: Wrinkles | undefined

async function draw(job: PageJob): Promise<PageReport> {
  const { width, height } = job
  warnings.length = 0
  // Creating lights, textures and shaders takes most of the time, so all images of a face share them.
  scene ??= await open(job)
  const { stage, face, loaded, initialWeights, restRotations } = scene
  for (const [mesh, weights] of initialWeights) mesh.morphTargetInfluences = [...weights]
  poseJoints(restRotations, {})
  wrinkles?.dispose()
  const isNamed = ({ name }: Expression) => name === job.expression
  const preset = EXPRESSIONS.find(isNamed)
  if (loaded) {
    wrinkles = stage.addWrinkles(face, loaded, { mode: job.mode, relief: job.relief })
    if (job.relief !== 'off') await wrinkles.reliefReady()
    applyExpression(face.root, wrinkles, wrinkles.expressions.find(isNamed) ?? preset, job)
  } else {
    setTargets(face.root, preset?.targets ?? {})
  }
  setTargets(face.root, job.targets)
  poseJoints(restRotations, job.joints)
  face.root.updateMatrixWorld(true)
  stage.camera.aspect = width / height
  stage.view(job.view)
  // The face's size on screen in one frame decides whether the next frame has relief. So the image is drawn twice.
  if (job.relief === 'near') await readPicture(stage, width, height)
  const pixels = await readPicture(stage, width, height)
  const response = await fetch(job.uploadTo, { method: 'POST', body: pixels as BodyInit })
  if (!response.ok) throw new Error(`the picture was not received (HTTP status ${response.status})`)
  return { renderer: stage.backend, adapter: adapterOf(stage), warnings }
}

async function open(job: PageJob): Promise<Scene> {
  const stage = await createStage(document.createElement('canvas'), job.renderer)
  if (job.renderer === 'webgpu' && stage.backend !== 'WebGPU') {
    throw new Error('this browser has no WebGPU: use --renderer webgl')
  }
  const face = await loadAvatar(job.face, job.mesh, stage.renderer)
  const file = job.wrinkles ? await loadDocument(job.wrinkles) : face.wrinkles
  const loaded = file && { ...file, drivers: file.drivers.filter(({ type }) => type !== 'time') }
  stage.show(face)
  const initialWeights = new Map<Mesh, readonly number[]>()
  const restRotations = new Map<Object3D, Quaternion>()
  face.root.traverse((object) => {
    restRotations.set(object, object.quaternion.clone())
    const { morphTargetInfluences } = object as Mesh
    if (morphTargetInfluences) initialWeights.set(object as Mesh, [...morphTargetInfluences])
  })
  return { stage, face, loaded, initialWeights, restRotations }
}

/**
 * Loads a wrinkle set and returns its drivers separately, so that the caller can omit some. `Wrinkles` adds all drivers
 * that it finds in a set.
 */
async function loadDocument(url: string): Promise<Pick<LoadedWrinkles, 'set' | 'drivers'>> {
  const { drivers, ...set } = await loadWrinkleSet(url)
  return { set, drivers: (drivers ?? []) as LoadedWrinkles['drivers'] }
}

/** Applies an expression and activations. If activations are given, the drivers of the file are off. */
function applyExpression(
  root: Object3D,
  wrinkles: Wrinkles,
  named: Expression | undefined,
  { activations }: PageJob,
): void {
  wrinkles.driven = Object.keys(activations).length === 0
  if (named) {
    // The library's presets refer to areas of Furrow's own faces. The player would warn about missing areas, so unknown
    // names are removed.
    const known = Object.entries(named.activations).filter(
      ([area]) => wrinkles.drivers.length === 0 || wrinkles.hasArea(area),
    )
    const expression = { ...named, activations: Object.fromEntries(known) }
    new ExpressionPlayer(root, wrinkles, [expression]).play(named.name, 0)
  }
  for (const [area, activation] of Object.entries(activations)) wrinkles.setActivation(area, activation)
}

/** Turns joints from their rest pose. All other objects return to theirs. */
function poseJoints(rest: ReadonlyMap<Object3D, Quaternion>, joints: PageJob['joints']): void {
  for (const [object, rotation] of rest) {
    // The loader removes some characters from `name`.
    const turn = joints[object.userData.name ?? object.name]
    object.quaternion.copy(rotation)
    if (turn) object.quaternion.multiply(new Quaternion(...turn))
  }
}

function setTargets(root: Object3D, targets: Readonly<Record<string, number>>): void {
  root.traverse((object) => {
    const { morphTargetDictionary, morphTargetInfluences } = object as Mesh
    if (!morphTargetDictionary || !morphTargetInfluences) return
    const names = Object.keys(morphTargetDictionary)
    for (const [name, weight] of Object.entries(targets)) {
      for (const index of findTargets(name, names)) {
        morphTargetInfluences[morphTargetDictionary[names[index]]] = weight
      }
    }
  })
}

function adapterOf({ renderer, backend }: Stage): string {
  return backend === 'WebGPU' ? webgpuAdapter(renderer as WebGPURenderer) : webglAdapter(renderer)
}

function webgpuAdapter(renderer: WebGPURenderer): string {
  const { device } = renderer.backend as unknown as { device: GPUDevice }
  const { vendor, architecture, description } = device.adapterInfo
  return [vendor, architecture, description].filter(Boolean).join(' ')
}

function webglAdapter(renderer: Renderer): string {
  const gl = (
    isWebGL(renderer)
      ? renderer.getContext()
      : (renderer.backend as unknown as { gl: WebGLRenderingContext }).gl
  ) as WebGL2RenderingContext
  const debug = gl.getExtension('WEBGL_debug_renderer_info')
  return String(gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : gl.RENDERER))
}
