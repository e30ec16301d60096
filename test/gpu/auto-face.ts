import type { WrinklesOptions } from 'furrow/three'
import {
  AmbientLight,
  DirectionalLight,
  type Material,
  type Mesh,
  MeshPhysicalMaterial,
  type MeshStandardMaterial,
  Scene,
  type WebGLRenderer,
} from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { afterAll, afterEach, beforeAll, expect } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { createHarness, type Harness, type RENDERERS, square, squareCamera } from './harness.ts'
import { normalMap } from './normal-map.ts'

/** Sides of the maps and pictures. */
export const MAP = 64

/** More frames than a face must be still for. */
export const FRAMES = 40

/** Frames that are drawn without waiting: fewer than a face must be still for, before which nothing is prepared. */
const AT_ONCE = 28

/** Milliseconds within which a map must be shown: a guard, which slow machines do not meet. */
export const SOON = 60_000

/** What nobody sees: two steps of 8 bits. */
export const UNSEEN = 2

/** What three.js keeps of a program. */
interface WebGLProgramOf {
  fragmentShader: WebGLShader
}

/** And what `WebGPURenderer` keeps of a mesh. */
interface RenderObject {
  object: Mesh
  material: Material
  getNodeBuilderState(): { fragmentShader: string }
}

/** A square with wrinkles, and whether its last draw showed a composed or a dual map, sampled the influence map, and had another map of occlusion. */
export function faceOf(
  harness: Harness,
  options: WrinklesOptions = {},
  material: Material = new MeshPhysicalMaterial({ normalMap: normalMap(2, MAP), roughness: 0.6 }),
  set: ConstructorParameters<Harness['Wrinkles']>[1] = randomSet(seeded(4), 6, 16, MAP),
) {
  const mesh = square(material)
  const shown = { isComposed: false, isDual: false, isSampled: false, isOcclusionReplaced: false }
  const wrinkles = new harness.Wrinkles(mesh, set, { mode: 'auto', areaSize: 16, ...options })
  const lit = material as MeshStandardMaterial
  const reach = wrinkles.editable('test').inputs.reach.value
  // Shaders do not where there is nothing to find.
  const samplesInfluence = () => reach.x < reach.z
  const { onBeforeRender } = mesh
  mesh.onBeforeRender = (...drawn) => {
    onBeforeRender.apply(mesh, drawn)
    shown.isSampled = samplesInfluence()
    const isReplaced = lit.normalMap?.isRenderTargetTexture ?? false
    // A composed map leaves nothing to mix in.
    shown.isComposed = isReplaced && !shown.isSampled
    shown.isDual = isReplaced && shown.isSampled
    shown.isOcclusionReplaced = lit.aoMap?.isRenderTargetTexture ?? false
  }
  for (const [i, area] of wrinkles.areaNames.entries()) wrinkles.setActivation(area, 0.3 + 0.1 * i)
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(1, 1, 1)
  // Occlusion darkens no light of lamps.
  const scene = new Scene().add(mesh, light, new AmbientLight(0xffffff, 1))
  const picture = async () => (await harness.renderBytes(scene, squareCamera(), MAP)).slice()
  /** Some frames; the last picture. */
  const frames = async (count = FRAMES) => {
    let last = await picture()
    for (let i = 1; i < count; i++) last = await picture()
    return last
  }
  /** At least one frame. What is compiled beside them takes some time, and a graphics card hardly any for a frame. */
  const drawUntil = async (what: 'isComposed' | 'isDual', before?: (frame: number) => void) => {
    harness.renderer.setSize(MAP, MAP, false)
    const end = performance.now() + SOON
    for (let i = 0; !(shown[what] && i > 0) && performance.now() < end; i++) {
      before?.(i)
      harness.renderer.render(scene, squareCamera())
      if (i > AT_ONCE) await drawn(harness)
    }
    expect(shown[what], what).toBe(true)
  }
  return {
    mesh,
    wrinkles,
    shown,
    samplesInfluence,
    scene,
    material: lit,
    picture,
    frames,
    /** Draws frames to the canvas until the composed map is shown. */
    composed: () => drawUntil('isComposed'),
    /** Draws frames to the canvas, each with other activations, until the dual map is shown. */
    moved: () =>
      drawUntil('isDual', (frame) => wrinkles.setActivation(wrinkles.areaNames[0], 0.3 + 0.1 * (frame % 2))),
    /** The picture in the default mode, of a face of its own. */
    async wanted() {
      const before = wrinkles.mode
      const { ...last } = shown
      wrinkles.mode = 'default'
      const pixels = await picture()
      wrinkles.mode = before
      Object.assign(shown, last)
      return pixels
    },
  }
}

/** A harness and faces that are disposed of with each test. */
export function useFaces(name: (typeof RENDERERS)[number]) {
  const disposers: (() => void)[] = []
  let harness: Harness
  beforeAll(async () => {
    harness = await createHarness(name)
  })
  afterEach(() => {
    for (const dispose of disposers.splice(0)) dispose()
  })
  afterAll(() => harness.dispose())
  return {
    get harness() {
      return harness
    },
    disposers,
    face(...own: Parameters<typeof faceOf> extends [Harness, ...infer Rest] ? Rest : never) {
      const made = faceOf(harness, ...own)
      disposers.push(() => made.wrinkles.dispose())
      return made
    },
  }
}

/** Fulfilled in a later task, when a frame is drawn: compiling beside frames waits for those before. */
export async function drawn({ renderer }: Harness): Promise<void> {
  const { device } =
    ((renderer as Partial<WebGPURenderer>).backend as unknown as { device?: GPUDevice }) ?? {}
  await device?.queue.onSubmittedWorkDone()
  await new Promise((resolve) => setTimeout(resolve, 5))
}

/** Returns a function that tells the fragment shader that a mesh was drawn by last. */
export function watchShaders({ renderer }: Harness): (mesh: Mesh) => string {
  if ('isWebGLRenderer' in renderer) {
    const gl = renderer as WebGLRenderer
    return ({ material }) => {
      const { currentProgram } = gl.properties.get(material) as { currentProgram: WebGLProgramOf }
      return gl.getContext().getShaderSource(currentProgram.fragmentShader)!
    }
  }
  const shaders = new Map<Mesh, string>()
  const backend = (renderer as WebGPURenderer).backend as unknown as {
    draw(drawn: RenderObject, info: unknown): void
  }
  const draw = backend.draw.bind(backend)
  backend.draw = (drawn, info) => {
    if (drawn.material === drawn.object.material) {
      shaders.set(drawn.object, drawn.getNodeBuilderState().fragmentShader)
    }
    draw(drawn, info)
  }
  return (mesh) => shaders.get(mesh) ?? ''
}
