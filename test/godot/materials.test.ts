import { describe, expect, it } from 'vitest'
import { bytesOf, withMaterial } from './files.ts'
import { type GodotScene, godot, type Json, type Picture } from './harness.ts'

const harness = godot()

/** Largest difference of two pictures, in steps of 8 bits. */
const difference = (a: Picture, b: Picture) =>
  a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0)

const LIGHTS: Json[] = [
  { from: [1, 1, 2], diffuse_mode: 0, specular: 0.5 },
  { from: [-3, 1, 0.5], diffuse_mode: 1, specular: 1 },
  { diffuse_mode: 0, specular: 0.5 },
]
const IMAGE = { index: 1 }

/** Properties of Godot's StandardMaterial3D, and of the material in the glTF file. */
const MATERIALS: Record<string, { properties?: Json; gltf?: object }> = {
  'as exported': {},
  textures: {
    gltf: {
      pbrMetallicRoughness: {
        baseColorTexture: IMAGE,
        metallicRoughnessTexture: IMAGE,
        baseColorFactor: [0.9, 0.6, 0.4, 1],
      },
      occlusionTexture: IMAGE,
      emissiveTexture: IMAGE,
      emissiveFactor: [0.2, 0.1, 0.3],
    },
  },
  transparency: {
    gltf: {
      alphaMode: 'BLEND',
      pbrMetallicRoughness: { metallicFactor: 0, baseColorFactor: [0.9, 0.6, 0.4, 0.5] },
    },
  },
  scissors: {
    gltf: {
      alphaMode: 'MASK',
      alphaCutoff: 0.4,
      pbrMetallicRoughness: { metallicFactor: 0, baseColorFactor: [1, 1, 1, 0.5] },
    },
  },
  unlit: { gltf: { extensions: { KHR_materials_unlit: {} } } },
  'both sides': { gltf: { doubleSided: true } },
  'smooth metal': { properties: { metallic: 1, roughness: 0.2 } },
  'smooth skin': { properties: { roughness: 0.35, metallic_specular: 0.5 } },
  clearcoat: { properties: { clearcoat_enabled: true, clearcoat: 0.8 } },
  rim: { properties: { rim_enabled: true, rim: 0.7, roughness: 0.4 } },
  backlight: { properties: { backlight_enabled: true, backlight: [0.4, 0.1, 0.1, 1] } },
  toon: { properties: { diffuse_mode: 3, specular_mode: 1 } },
  'vertex colours': { properties: { vertex_color_use_as_albedo: true } },
  'occlusion of direct light': { properties: { ao_enabled: true, ao_light_affect: 0.7 } },
  'scaled texture': {
    gltf: { pbrMetallicRoughness: { baseColorTexture: IMAGE } },
    properties: { uv1_scale: 2, normal_enabled: false },
  },
}

describe('a converted material without wrinkles looks like the original', () => {
  it.each(Object.entries(MATERIALS))('%s', async (_name, { gltf, properties }) => {
    const scene = (await harness.open(bytesOf(withMaterial(gltf)))) as GodotScene
    expect(scene.faces).toBe(1)
    let isLit = false
    for (const light of LIGHTS) {
      const draw = async (mode: number) => {
        await scene.call('set_mode', { mode })
        return scene.draw('draw_lit', { light, properties: properties ?? {} })
      }
      const plain = await draw(1)
      isLit ||= plain.some((value, i) => i % 4 < 3 && value > 0)
      expect(difference(await draw(0), plain)).toBeLessThanOrEqual(1)
    }
    expect(isLit).toBe(true)
    await scene.close()
  })
})

it('wrinkles shadow highlights where they are occluded', async () => {
  const scene = (await harness.open(bytesOf(withMaterial()))) as GodotScene
  const draw = async (up: number) => {
    await scene.call('pose', { weights: { up } })
    const properties = {
      roughness: 0.3,
      albedo_color: [0, 0, 0, 1],
      normal_enabled: false,
      metallic_specular: 1,
    }
    return scene.draw('draw_lit', { light: { from: [2, 0, 1] }, properties })
  }
  const sum = (picture: Picture) => picture.reduce((total, value, i) => total + (i % 4 < 3 ? value : 0), 0)
  expect(sum(await draw(1))).toBeLessThan(sum(await draw(0)))
  await scene.close()
})

it('a material that cannot be converted is shown without wrinkles, with one error', async () => {
  const scene = (await harness.open(bytesOf(withMaterial()))) as GodotScene
  await scene.call('set_mode', { mode: 1 })
  const plain = await scene.draw('draw_lit', { light: LIGHTS[0], properties: { grow: true } })
  await scene.call('set_mode', { mode: 0 })
  expect(difference(await scene.draw('picture'), plain)).toBe(0)
  const errors = harness.messages.filter((text) => text.includes('cannot show wrinkles'))
  expect(errors).toHaveLength(1)
  expect(errors[0]).toContain('grow')
  await scene.close()
})
