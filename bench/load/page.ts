/** Page that measures the time from a file's bytes to the first frame with the face. Before the measurement, it draws an empty scene. */
import { Box3, DirectionalLight, type Mesh, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

/** Times in milliseconds. */
export interface FirstFrame {
  /** Time that `GLTFLoader` takes to parse the file's bytes. */
  parsed: number
  /** Time from the call that draws the face until the GPU has rendered it. Setting up the scene after parsing is not included. */
  drawn: number
  /** Upper bound of the longest main-thread task while parsing. It is measured as the longest gap between messages that are posted continuously. */
  longest: number
}

/** `plain` loads the face without Furrow's plugin, `furrow` with it. */
type Variant = 'plain' | 'furrow'

declare global {
  interface Window {
    firstFrame(renderer: 'webgl' | 'webgpu', variant: Variant): Promise<FirstFrame>
  }
}

window.firstFrame = async (kind, variant) => {
  const { draw, extendLoader } = await (kind === 'webgl' ? webgl() : webgpu())
  const file = await (await fetch('/human.glb')).arrayBuffer()
  const camera = new PerspectiveCamera(20, 4 / 3, 0.01, 10)
  await draw(new Scene(), camera)
  const pulse = new Pulse()
  await pulse.begin()
  const start = performance.now()
  const loader = new GLTFLoader()
  if (variant === 'furrow') extendLoader(loader)
  const gltf = await loader.parseAsync(file, '')
  const parsed = performance.now()
  const scene = litFace(gltf, camera)
  await yieldToTasks()
  const { longest } = pulse
  pulse.end()
  const ready = performance.now()
  await draw(scene, camera)
  return { parsed: parsed - start, drawn: performance.now() - ready, longest }
}

async function webgl() {
  const { extendLoader } = await import('furrow/three')
  const renderer = new WebGLRenderer()
  renderer.setSize(800, 600)
  document.body.append(renderer.domElement)
  const gl = renderer.getContext()
  const draw = async (scene: Scene, camera: PerspectiveCamera) => {
    renderer.render(scene, camera)
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4))
  }
  return { draw, extendLoader }
}

async function webgpu() {
  const [{ extendLoader }, { WebGPURenderer }] = await Promise.all([
    import('furrow/webgpu'),
    import('three/webgpu'),
  ])
  const renderer = new WebGPURenderer()
  renderer.setSize(800, 600)
  document.body.append(renderer.domElement)
  await renderer.init()
  const { device } = renderer.backend as unknown as { device: GPUDevice }
  const draw = async (scene: Scene, camera: PerspectiveCamera) => {
    renderer.render(scene, camera)
    await device.queue.onSubmittedWorkDone()
  }
  return { draw, extendLoader }
}

function litFace({ scene: face }: GLTF, camera: PerspectiveCamera): Scene {
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(-1, 1.35, 0.95)
  face.traverse((object) => {
    const { morphTargetInfluences, morphTargetDictionary } = object as Mesh
    for (const name of ['browInnerUp', 'browDownLeft', 'noseSneerLeft', 'mouthSmileLeft']) {
      const index = morphTargetDictionary?.[name]
      if (index !== undefined) morphTargetInfluences![index] = 1
    }
  })
  const centre = new Box3().setFromObject(face).getCenter(new Vector3())
  camera.position.copy(centre).z += 1
  return new Scene().add(face, light)
}

/** Resolves in a later task, so that pending tasks run first. */
function yieldToTasks(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve))
}

/** Posts messages continuously and measures the longest gap between two of them, milliseconds. */
class Pulse {
  longest = 0
  #last = 0
  readonly #channel = new MessageChannel()

  begin(): Promise<void> {
    return new Promise((resolve) => {
      this.#channel.port1.onmessage = () => {
        const now = performance.now()
        if (this.#last > 0) this.longest = Math.max(this.longest, now - this.#last)
        this.#last = now
        this.#channel.port2.postMessage(null)
        resolve()
      }
      this.#channel.port2.postMessage(null)
    })
  }

  end(): void {
    this.#channel.port1.close()
  }
}
