import { activationTrack, removeArea, WrinkleLoaderPlugin, type WrinklesBase, wrinklesOf } from 'furrow/three'
import { AnimationClip, AnimationMixer, type Object3D } from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone } from 'three/addons/utils/SkeletonUtils.js'
import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest'
import { editGlb } from '../../glb.ts'

const NOSE = 3
const TIMES = [0, 0.5, 2]
const LINEAR = [0, 1, 0.25]
/** Values of a cubic spline: in-tangent, value and out-tangent for each key frame. */
const CUBIC = [0, 0.1, 2, 1, 0.8, -1, 0, 0.2, 0]

let file: Uint8Array

beforeAll(async () => {
  file = new Uint8Array(await (await fetch('/faces/human.glb')).arrayBuffer())
})
afterEach(() => vi.restoreAllMocks())

interface Channel {
  values: number[]
  interpolation?: string
  pointer?: string
}

/** Loads the shipped face with an animation of its areas, one per channel. */
async function load(...channels: Channel[]): Promise<GLTF> {
  const animated = editGlb(file, (json) => {
    const add = (values: number[]) => {
      const bytes = new Uint8Array(Float32Array.from(values).buffer)
      const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`
      const buffer = json.buffers.push({ uri, byteLength: bytes.length }) - 1
      const bufferView = json.bufferViews.push({ buffer, byteLength: bytes.length }) - 1
      return (
        json.accessors.push({ bufferView, componentType: 5126, type: 'SCALAR', count: values.length }) - 1
      )
    }
    const input = add(TIMES)
    json.extensionsUsed.push('KHR_animation_pointer')
    json.animations = [
      {
        name: 'frown',
        samplers: channels.map(({ values, interpolation }) => ({
          input,
          output: add(values),
          ...(interpolation && { interpolation }),
        })),
        channels: channels.map(({ pointer }, sampler) => ({
          sampler,
          target: { path: 'pointer', extensions: { KHR_animation_pointer: { pointer } } },
        })),
      },
    ]
  })
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder)
  loader.register((parser) => new WrinkleLoaderPlugin(parser))
  return loader.parseAsync(animated.buffer as ArrayBuffer, '')
}

const pointerTo = (area: number) => `/materials/0/extensions/FURROW_wrinkle_maps/areas/${area}/activation`

/** Plays a clip on an object, and returns the activation of an area at several times. */
function activationsDuring(
  root: Object3D,
  clip: AnimationClip,
  wrinkles: WrinklesBase,
  area: string,
  times: number[],
) {
  const mixer = new AnimationMixer(root)
  mixer.clipAction(clip).play()
  return times.map((time) => {
    mixer.setTime(time)
    return wrinkles.getActivation(area)
  })
}

const SAMPLE_TIMES = [0, 0.1, 0.4, 0.5, 1, 1.5, 1.9]

describe('key frames in a file', () => {
  it('animate an area like the same track made in code', async () => {
    const gltf = await load({ values: LINEAR, pointer: pointerTo(NOSE) })
    const [wrinkles]: WrinklesBase[] = gltf.userData.wrinkles
    const area = wrinkles.areaNames[NOSE]
    const [clip] = gltf.animations
    expect([clip.name, clip.duration]).toEqual(['frown', 2])
    const fromFile = activationsDuring(gltf.scene, clip, wrinkles, area, SAMPLE_TIMES)
    const expected = SAMPLE_TIMES.map((t) => (t < 0.5 ? t / 0.5 : 1 - ((t - 0.5) / 1.5) * 0.75))
    for (const [i, value] of fromFile.entries()) expect(value).toBeCloseTo(expected[i], 5)
    const clipFromCode = new AnimationClip('own', -1, [activationTrack(wrinkles.mesh, area, TIMES, LINEAR)])
    expect(activationsDuring(gltf.scene, clipFromCode, wrinkles, area, SAMPLE_TIMES)).toEqual(fromFile)
  })

  it('support step and cubic spline interpolation', async () => {
    const gltf = await load(
      { values: LINEAR, interpolation: 'STEP', pointer: pointerTo(0) },
      { values: CUBIC, interpolation: 'CUBICSPLINE', pointer: pointerTo(1) },
    )
    const [wrinkles]: WrinklesBase[] = gltf.userData.wrinkles
    const [clip] = gltf.animations
    const [stepped, curved] = [0, 1].map((i) =>
      activationsDuring(gltf.scene, clip, wrinkles, wrinkles.areaNames[i], SAMPLE_TIMES),
    )
    expect(stepped).toEqual([0, 0, 0, 1, 1, 1, 1])
    const spline = (t: number) => {
      const [k, t0, t1] = t < 0.5 ? [0, 0, 0.5] : [1, 0.5, 2]
      const s = (t - t0) / (t1 - t0)
      const [p0, m0, m1, p1] = [CUBIC[3 * k + 1], CUBIC[3 * k + 2], CUBIC[3 * k + 3], CUBIC[3 * k + 4]]
      return (
        p0 * (1 + 2 * s) * (1 - s) ** 2 +
        (t1 - t0) * m0 * s * (1 - s) ** 2 +
        p1 * s * s * (3 - 2 * s) +
        (t1 - t0) * m1 * s * s * (s - 1)
      )
    }
    for (const [i, t] of SAMPLE_TIMES.entries())
      expect(curved[i], `at ${t}`).toBeCloseTo(Math.min(1, spline(t)), 5)
  })

  it('play on one copy only, and set the activation at rest, to which drivers add', async () => {
    const gltf = await load({ values: LINEAR, pointer: pointerTo(NOSE) })
    const [wrinkles]: WrinklesBase[] = gltf.userData.wrinkles
    const area = wrinkles.areaNames[NOSE]
    const copy = clone(gltf.scene)
    const copied = wrinklesOf(copy.getObjectByName('skin') as typeof wrinkles.mesh)!
    expect(activationsDuring(copy, gltf.animations[0], copied, area, [0.25])).toEqual([0.5])
    expect(wrinkles.getActivation(area)).toBe(0)
    expect(copied.getRestingActivation(area)).toBe(0.5)
  })

  it('log one warning for a removed area, and ignore pointers to anything else', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const gltf = await load(
      { values: LINEAR, pointer: pointerTo(NOSE) },
      { values: LINEAR, pointer: pointerTo(99) },
      { values: LINEAR, pointer: '/nodes/0/translation' },
      { values: LINEAR },
    )
    const [wrinkles]: WrinklesBase[] = gltf.userData.wrinkles
    expect(gltf.animations[0].tracks).toHaveLength(1)
    const mixer = new AnimationMixer(gltf.scene)
    mixer.clipAction(gltf.animations[0]).play()
    mixer.setTime(0.1)
    removeArea(wrinkles, wrinkles.areaNames[NOSE])
    warn.mockClear()
    mixer.setTime(0.2)
    mixer.setTime(0.3)
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain('an animation moves an area that was removed')
  })
})
