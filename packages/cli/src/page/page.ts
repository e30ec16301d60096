/** The page that `furrow render` opens: draws pictures of one face on the shared stage and posts their pixels. */

import { EXPRESSIONS, type Expression, findTargets } from 'furrow'
import { ExpressionPlayer, type LoadedWrinkles, loadWrinkleSet } from 'furrow/three'
import type { Mesh, Object3D } from 'three'
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import type { WebGPURenderer } from 'three/webgpu'
import { type Face, loadFace } from '../../../../stage/face.ts'
import { isWebGL } from '../../../../stage/light.ts'
import { createStage, type Renderer, type Stage, type Wrinkles } from '../../../../stage/stage.ts'
import type { ViewName } from '../../../../stage/views.ts'
import type { PageJob, PageReport, VIEW_NAMES } from '../render/picture.ts'
import { readPicture } from './read-canvas.ts'

// Node cannot import the stage, so it keeps the names of the views itself: they must be the same.
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

/** What all pictures of a page are drawn of. */
interface Scene {
  stage: Stage
  face: Face
  loaded: Pick<LoadedWrinkles, 'set' | 'drivers'>
  /** Blendshape weights as the file has them. */
  resting: Map<Mesh, readonly number[]>
}

let scene: Scene | undefined
let worn: Wrinkles | undefined

async function draw(job: PageJob): Promise<PageReport> {
  const { width, height } = job
  warnings.length = 0
  // Light, textures and programs are most of the work, and the same for each picture of a face.
  scene ??= await open(job)
  const { stage, face, loaded, resting } = scene
  for (const [mesh, weights] of resting) mesh.morphTargetInfluences = [...weights]
  worn?.dispose()
  const wrinkles = stage.show(face, loaded, { mode: job.mode })
  worn = wrinkles
  const named = EXPRESSIONS.find(({ name }) => name === job.expression)
  const isComplete = named && Object.keys(named.activations).every((area) => wrinkles.hasArea(area))
  const fits = isComplete || (named && loaded.drivers.length === 0)
  // An expression for these areas, and the areas named by hand, say what shows; blendshapes alone leave it to the file's drivers.
  wrinkles.driven = !fits && Object.keys(job.activations).length === 0
  pose(face.root, wrinkles, wrinkles.driven && named ? { ...named, activations: {} } : named, job)
  stage.camera.aspect = width / height
  stage.view(job.view)
  const pixels = await readPicture(stage, width, height)
  const delivered = await fetch(job.deliver, { method: 'POST', body: pixels as BodyInit })
  if (!delivered.ok) throw new Error(`the picture was not accepted (HTTP status ${delivered.status})`)
  return { renderer: stage.backend, adapter: adapterOf(stage), warnings }
}

async function open(job: PageJob): Promise<Scene> {
  const stage = await createStage(document.createElement('canvas'), job.renderer)
  if (job.renderer === 'webgpu' && stage.backend !== 'WebGPU') {
    throw new Error('this browser has no WebGPU: use --renderer webgl')
  }
  const face = await loadFace(job.face, job.mesh, loaderFor(stage.renderer))
  const loaded = job.wrinkles ? { set: await loadWrinkleSet(job.wrinkles), drivers: [] } : face.wrinkles!
  const resting = new Map<Mesh, readonly number[]>()
  face.root.traverse((object) => {
    const { morphTargetInfluences } = object as Mesh
    if (morphTargetInfluences) resting.set(object as Mesh, [...morphTargetInfluences])
  })
  return { stage, face, loaded, resting }
}

/** A loader for files in every compression that glTF knows. */
function loaderFor(renderer: Renderer): GLTFLoader {
  return new GLTFLoader()
    .setDRACOLoader(new DRACOLoader())
    .setKTX2Loader(new KTX2Loader().detectSupport(renderer))
}

function pose(
  root: Object3D,
  wrinkles: Wrinkles,
  chosen: Expression | undefined,
  { targets, activations }: PageJob,
): void {
  // One expression is given to the player, since it warns of what any of them lacks.
  if (chosen) new ExpressionPlayer(root, wrinkles, [chosen]).play(chosen.name, 0)
  root.traverse((object) => setTargets(object as Mesh, targets))
  for (const [area, activation] of Object.entries(activations)) wrinkles.setActivation(area, activation)
}

function setTargets(
  { morphTargetDictionary, morphTargetInfluences }: Mesh,
  targets: Record<string, number>,
): void {
  if (!morphTargetDictionary || !morphTargetInfluences) return
  const names = Object.keys(morphTargetDictionary)
  for (const [name, weight] of Object.entries(targets)) {
    for (const index of findTargets(name, names)) {
      morphTargetInfluences[morphTargetDictionary[names[index]]] = weight
    }
  }
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
