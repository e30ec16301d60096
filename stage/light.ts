import {
  Color,
  DirectionalLight,
  Group,
  PMREMGenerator,
  type Scene,
  type Texture,
  type WebGLRenderer,
} from 'three'
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js'
import type { WebGPURenderer } from 'three/webgpu'

/** Three-point lighting: a key light from the upper left, a weaker fill light, and a rim light from behind. `from` points to the light. */
const LIGHTS = [
  { name: 'key', colour: 0xfff1e4, intensity: 3, from: [-1, 1.35, 0.95] },
  { name: 'fill', colour: 0xdfe8ff, intensity: 0.5, from: [1.3, 0.1, 0.8] },
  { name: 'rim', colour: 0xe6eeff, intensity: 1.1, from: [1.2, 1, -1.6] },
] as const

/** Intensity of the environment map, which brightens shadows and is reflected in the eyes. */
const ENVIRONMENT = 0.28

const BACKGROUND = 0x24272c
/** Colour that appears as `BACKGROUND` with WebGPURenderer, which also tone-maps the background. */
const TONE_MAPPED_BACKGROUND = 0x34373b

export interface Lighting {
  /** Key light. Its `position` is the direction to the light if the face looks along +Z. `turn` rotates this direction. */
  readonly key: DirectionalLight
  /** Rotates lights and environment about +Y. @param yaw radians from +Z to the facing direction. */
  turn(yaw: number): void
  remove(): void
}

/** Makes environment maps: the `PMREMGenerator` of one of three.js's renderers. */
export interface EnvironmentGenerator {
  fromScene(scene: Scene, sigma?: number): { texture: Texture; dispose(): void }
  dispose(): void
}

/**
 * Adds lights, environment and background to a scene, for a face that looks along +Z.
 *
 * @param generator generator for the renderer. Default: one for `WebGLRenderer`.
 */
export function lightScene(
  scene: Scene,
  renderer: WebGLRenderer | WebGPURenderer,
  generator?: EnvironmentGenerator,
): Lighting {
  const pmrem = generator ?? new PMREMGenerator(renderer as WebGLRenderer)
  let environment: { texture: Texture; dispose(): void } | null = null
  const surround = () => {
    environment?.dispose()
    const room = new RoomEnvironment()
    environment = pmrem.fromScene(room as never, 0.04)
    room.dispose()
    scene.environment = environment.texture
  }
  surround()
  // The environment map exists only on the GPU. A context loss deletes it.
  const { domElement } = renderer
  if (isWebGL(renderer)) domElement.addEventListener('webglcontextrestored', surround)
  scene.environmentIntensity = ENVIRONMENT
  scene.background = new Color(isWebGL(renderer) ? BACKGROUND : TONE_MAPPED_BACKGROUND)
  const lights = new Group()
  const [key, ...others] = LIGHTS.map(({ name, colour, intensity, from }) => {
    const light = new DirectionalLight(colour, intensity)
    light.name = name
    light.position.fromArray(from)
    return light
  })
  lights.add(key, ...others)
  scene.add(lights)
  return {
    key,
    turn(yaw) {
      lights.rotation.y = yaw
      scene.environmentRotation.y = yaw
    },
    remove() {
      scene.remove(lights)
      domElement.removeEventListener('webglcontextrestored', surround)
      environment?.dispose()
      pmrem.dispose()
    },
  }
}

export function isWebGL(renderer: WebGLRenderer | WebGPURenderer): renderer is WebGLRenderer {
  return (renderer as { isWebGLRenderer?: boolean }).isWebGLRenderer === true
}
