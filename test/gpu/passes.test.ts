import { wrinklesOf } from 'furrow/three'
import { DirectionalLight, Mesh, MeshStandardMaterial, PlaneGeometry, RenderTarget, Scene } from 'three'
import { mrt, normalView, output } from 'three/tsl'
import type { WebGPURenderer } from 'three/webgpu'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../cases.ts'
import { seeded } from '../random.ts'
import { largestDifference } from './difference.ts'
import { createHarness, type Harness, imagesOf, RENDERERS, square, squareCamera } from './harness.ts'
import { loadFile, pageMesh } from './loaded.ts'
import { faceMeshes, wrinkledFile } from './wrinkled-file.ts'

const SIDE = 32

/** Creates a square with wrinkles that casts a shadow. A smaller mesh in front of it receives shadows and is drawn first. */
function sceneOf(harness: Harness, mesh = square(new MeshStandardMaterial())) {
  const light = new DirectionalLight('white', 3)
  light.position.set(0.5, 0.5, 1)
  light.castShadow = true
  light.shadow.bias = -0.01
  light.shadow.mapSize.set(64, 64)
  Object.assign(light.shadow.camera, { left: -3, right: 3, top: 3, bottom: -3, near: 0.01, far: 10 })
  const front = new Mesh(new PlaneGeometry(0.2, 0.2), new MeshStandardMaterial())
  front.position.set(0.9, 0.9, 0.5)
  mesh.castShadow = mesh.receiveShadow = front.receiveShadow = true
  harness.renderer.shadowMap.enabled = true
  const wrinkles = new harness.Wrinkles(mesh, randomSet(seeded(4), 6, 8, 16), { areaSize: 8 })
  const scene = new Scene().add(mesh, front, light)
  return {
    scene,
    wrinkles,
    /** Activates all areas. */
    set(value: number) {
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, value)
    },
    picture: async () => (await harness.renderBytes(scene, squareCamera(), SIDE)).slice(),
  }
}

/** Expects that wrinkles change the picture, and that calling `update` before drawing makes no difference. */
async function expectWrinkles(harness: Harness, shoot: (scene: Scene) => Promise<Uint8Array>) {
  const { scene, wrinkles, set } = sceneOf(harness)
  set(0.4)
  const shown = await shoot(scene)
  for (const value of [0, 0.4]) {
    set(value)
    wrinkles.update(harness.renderer)
  }
  expect(largestDifference(await shoot(scene), shown)).toBe(0)
  wrinkles.mode = 'off'
  expect(largestDifference(await shoot(scene), shown)).toBeGreaterThan(8)
  wrinkles.dispose()
}

it.each(RENDERERS)('wrinkles show on a face that is drawn into a shadow map first, on %s', async (name) => {
  const harness = await createHarness(name)
  await expectWrinkles(harness, async (scene) =>
    (await harness.renderBytes(scene, squareCamera(), SIDE)).slice(),
  )
  harness.dispose()
})

it.each(RENDERERS.slice(1))(
  'wrinkles show in passes with several outputs and in opaque-only passes, on %s',
  async (name) => {
    const harness = await createHarness(name)
    const renderer = harness.renderer as WebGPURenderer
    const target = new RenderTarget(64, 64, { count: 2 })
    for (const [i, texture] of target.textures.entries()) texture.name = ['output', 'normal'][i]
    await expectWrinkles(harness, async (scene) => {
      renderer.setRenderTarget(target)
      renderer.setMRT(mrt({ output, normal: normalView }))
      renderer.transparent = false
      renderer.render(scene, squareCamera())
      expect(renderer.getMRT()).not.toBe(null)
      renderer.transparent = true
      renderer.setMRT(null)
      renderer.setRenderTarget(null)
      return ((await renderer.readRenderTargetPixelsAsync(target, 0, 0, 64, 64)) as Uint8Array).slice()
    })
    target.dispose()
    harness.dispose()
  },
)

/** Expects that activated wrinkles show in the next picture. */
async function expectAtOnce(picture: () => Promise<Uint8Array>, none: Uint8Array): Promise<void> {
  const some = await picture()
  expect(largestDifference(some, none)).toBeGreaterThan(8)
  expect(largestDifference(await picture(), some)).toBe(0)
}

/** Returns a function that calls `draw` and counts how often drawing switches to each render target. The function returns the largest count. */
function watchTargets(renderer: Harness['renderer']): (draw: () => void) => number {
  const gl = renderer.getContext() as WebGL2RenderingContext
  /** Render target of each draw call and clear, in order. */
  const targets: (WebGLFramebuffer | null)[] = []
  for (const method of ['clear', 'clearBufferfv', 'drawArrays', 'drawElements'] as const) {
    const draw = gl[method].bind(gl) as (...parameters: unknown[]) => void
    Object.assign(gl, {
      [method](...parameters: unknown[]) {
        targets.push(gl.getParameter(gl.FRAMEBUFFER_BINDING))
        draw(...parameters)
      },
    })
  }
  return (draw) => {
    targets.length = 0
    draw()
    const runs = targets.filter((target, i) => target !== targets[i - 1])
    return Math.max(...runs.map((target) => runs.filter((other) => other === target).length))
  }
}

/** Waits until Furrow has set its callback on a scene. Furrow does this after the frame. */
const frameEnd = () => Promise.resolve()

describe.each(['webgl', 'webgpu on webgl2'] as const)('the influence map on %s', (name) => {
  it('is drawn before the picture begins, except in the first frame of a scene', async () => {
    const harness = await createHarness(name)
    const { renderer } = harness
    const { scene, wrinkles, picture, set } = sceneOf(harness)
    // With shadows, `WebGPURenderer` switches to the shadow map in the middle of a picture, and the switch back would count.
    renderer.shadowMap.enabled = false
    const maxBegins = watchTargets(renderer)
    const begun = (value: number) => {
      set(value)
      return maxBegins(() => renderer.render(scene, squareCamera()))
    }
    expect(begun(0.1)).toBe(2)
    await frameEnd()
    expect([0.2, 0.3, 0.4].map(begun)).toEqual([1, 1, 1])
    const shown = await picture()
    // A page may replace the callback of the scene, with or without calling the previous one.
    for (const isCalled of [true, false]) {
      const { onBeforeRender } = scene
      let calls = 0
      scene.onBeforeRender = (...drawn) => {
        calls++
        if (isCalled) onBeforeRender(...drawn)
      }
      begun(0.5)
      await frameEnd()
      expect([0.6, 0.3, 0.4].map(begun)).toEqual([1, 1, 1])
      expect(calls).toBe(4)
      expect(largestDifference(await picture(), shown)).toBe(0)
    }
    wrinkles.dispose()
    harness.dispose()
  })

  it('is drawn before the picture begins for meshes that a page makes with the material of a loaded face', async () => {
    const harness = await createHarness(name)
    const { scene: loaded } = await loadFile(harness, await wrinkledFile())
    const meshes = faceMeshes(loaded).map((mesh) => pageMesh(mesh, mesh.morphTargetInfluences!))
    // Adds a mesh without wrinkles in front of the face.
    const front = new Mesh(new PlaneGeometry(0.2, 0.2), new MeshStandardMaterial())
    front.position.z = 0.5
    const scene = new Scene().add(front, ...meshes)
    const maxBegins = watchTargets(harness.renderer)
    const begun = (value: number) => {
      meshes[0].morphTargetInfluences![0] = value
      return maxBegins(() => harness.renderer.render(scene, squareCamera()))
    }
    expect(begun(0.5)).toBe(2)
    await frameEnd()
    expect([0.6, 0.7, 0.8].map(begun)).toEqual([1, 1, 1])
    wrinklesOf(meshes[0])!.dispose()
    harness.dispose()
  })

  it('restores onBeforeRender of the scene when no wrinkles are left', async () => {
    const harness = await createHarness(name)
    const { scene, wrinkles } = sceneOf(harness)
    const own = () => {}
    scene.onBeforeRender = own
    const draw = () => harness.renderer.render(scene, squareCamera())
    draw()
    await frameEnd()
    expect(scene.onBeforeRender).not.toBe(own)
    wrinkles.dispose()
    draw()
    expect(scene.onBeforeRender).toBe(own)
    harness.dispose()
  })

  it('is drawn after an onBeforeRender that the page set on the mesh', async () => {
    const harness = await createHarness(name)
    const mesh = square(new MeshStandardMaterial())
    let value = 0
    mesh.onBeforeRender = () => {
      set(value)
    }
    const { wrinkles, picture, set } = sceneOf(harness, mesh)
    const none = await picture()
    value = 0.4
    await expectAtOnce(picture, none)
    wrinkles.dispose()
    harness.dispose()
  })

  it('is drawn once per frame for all faces, even if the frame has shadows and several images', async () => {
    const harness = await createHarness(name)
    const { renderer } = harness
    const { scene, wrinkles } = sceneOf(harness)
    const other = new harness.Wrinkles(square(new MeshStandardMaterial()), wrinkles)
    scene.add(other.mesh)
    const away = squareCamera()
    away.position.x = 100
    const overridden = new MeshStandardMaterial()
    /** Draws the images of a frame, and returns the number of render calls, including calls for influence. */
    const frame = (value: number, images: (() => void)[]) => {
      for (const face of [wrinkles, other]) for (const area of face.areaNames) face.setActivation(area, value)
      const before = imagesOf(renderer)
      renderer.render(scene, squareCamera())
      for (const image of images) image()
      return imagesOf(renderer) - before
    }
    const aside = () => renderer.render(scene, away)
    const override = () => {
      scene.overrideMaterial = overridden
      renderer.render(scene, squareCamera())
      scene.overrideMaterial = null
    }
    frame(0, [])
    await frameEnd()
    for (const images of [[], [aside], [override], [override, aside], [aside, aside]]) {
      for (const value of [0.1, 0.2]) frame(value, images)
      const still = frame(0.2, images)
      expect([0.3, 0.4].map((value) => frame(value, images) - still)).toEqual([1, 1])
    }
    for (const face of [other, wrinkles]) face.dispose()
    harness.dispose()
  })

  it('sets onBeforeRender of a scene only a few times, even if the page replaces it in every frame', async () => {
    const harness = await createHarness(name)
    const { scene, wrinkles } = sceneOf(harness)
    harness.renderer.shadowMap.enabled = false
    let depth = 0
    for (let i = 0; i < 40; i++) {
      const { onBeforeRender } = scene
      scene.onBeforeRender = (...drawn) => {
        depth++
        onBeforeRender.apply(scene, drawn)
      }
      const own = scene.onBeforeRender
      harness.renderer.render(scene, squareCamera())
      await frameEnd()
      if (i > 20) expect(scene.onBeforeRender).toBe(own)
    }
    expect(depth).toBe((40 * 41) / 2)
    wrinkles.dispose()
    harness.dispose()
  })

  it('is drawn after an onBeforeRender that the page sets on the mesh later', async () => {
    const harness = await createHarness(name)
    const { wrinkles, picture, set } = sceneOf(harness)
    const { mesh } = wrinkles
    const none = await picture()
    await picture()
    const { onBeforeRender } = mesh
    let value = 0
    mesh.onBeforeRender = (...drawn) => {
      set(value)
      onBeforeRender.apply(mesh, drawn)
    }
    await picture()
    value = 0.4
    await expectAtOnce(picture, none)
    wrinkles.dispose()
    harness.dispose()
  })
})
