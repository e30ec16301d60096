import { expect, it } from 'vitest'
import { bytesOf, FACE } from './files.ts'
import { type GodotScene, godot, type Picture } from './harness.ts'
import { command } from './start-godot.ts'

const harness = godot()
const open = async (copies: number) => (await harness.open(bytesOf(FACE), copies)) as GodotScene
const LIGHT = { from: [1, 0, 1] }
const isSame = (a: Picture, b: Picture) => a.every((value, i) => value === b[i])

it('copies of a face share textures, and keep their own activations', async () => {
  const scene = await open(3)
  expect(scene.faces).toBe(3)
  expect(await scene.call('count_textures')).toBe(1)
  for (const [face, up] of [0, 1, 0.5].entries()) await scene.call('pose', { face, weights: { up } })
  const pictures: Picture[] = []
  for (const face of [0, 1, 2]) {
    await scene.call('show_only', { face })
    pictures.push(await scene.draw('draw', LIGHT))
  }
  const alone = await open(1)
  for (const [face, up] of [0, 1, 0.5].entries()) {
    await alone.call('pose', { weights: { up } })
    expect(isSame(await alone.draw('draw', LIGHT), pictures[face])).toBe(true)
  }
  expect(isSame(pictures[0], pictures[1])).toBe(false)
  expect(isSame(pictures[1], pictures[2])).toBe(false)
  await scene.close()
  await alone.close()
})

it('sums influence only in frames in which an activation has changed', async () => {
  const scene = await open(2)
  await scene.draw('picture')
  const updates = async (weights: number[]) => scene.call<number>('count_updates', { weights })
  expect(await updates([0, 0, 0])).toBe(0)
  expect(await updates([0.1, 0.2, 0.2, 0.2])).toBe(2)
  await scene.close()
})

it('drivers run before each frame, in which wrinkles follow the blendshape', async () => {
  const scene = await open(1)
  await scene.call('pose', { weights: { up: 1 } })
  const wrinkled = await scene.draw('draw', LIGHT)
  await scene.call('pose', {})
  await scene.draw('draw', LIGHT)
  expect(isSame(await scene.draw('draw_next_frame', { up: 1 }), wrinkled)).toBe(true)
  await scene.close()
})

it('a resting activation replaces that of the file, and drivers add to it', async () => {
  const scene = await open(1)
  expect(await scene.call('pose', { activations: { a: 0.25 } })).toEqual([{ a: 0.25 }])
  expect(await scene.call('pose', { weights: { up: 0.5 } })).toEqual([{ a: 0.75 }])
  expect(await scene.call('pose', { activations: { a: 7 } })).toEqual([{ a: 1 }])
  await scene.close()
})

it('reports changed activations by a signal, and an unknown area by an error', async () => {
  const scene = await open(1)
  expect(await scene.call('count_signals', { weights: [0, 0.5, 0.5, 1] })).toBe(2)
  expect(await scene.call('get_activation', { area: 'b' })).toBe(0)
  expect(harness.messages.filter((text) => text.includes('unknown area, got "b", allowed: a'))).toHaveLength(
    1,
  )
  await scene.close()
})

it('plays an expression of the file', async () => {
  const scene = await open(1)
  expect(await scene.call('play', { expression: 'surprised', seconds: 0 })).toEqual({
    names: ['surprised'],
    activations: [{ a: 0.5 }],
  })
  expect(await scene.call('play', { expression: 'joyful', seconds: 0 })).toMatchObject({
    activations: [{ a: 0.5 }],
  })
  expect(harness.messages.filter((text) => text.includes('unknown expression, got "joyful"'))).toHaveLength(1)
  await scene.close()
})

it('frees everything with the scene', async () => {
  const count = async () => {
    const scene = await open(2)
    await scene.call('pose', { weights: { up: 1 } })
    await scene.draw('picture')
    await scene.close()
    return command<number>('count_resources', {})
  }
  await count()
  const first = await count()
  expect(await count()).toBe(first)
})

it('keeps a material that overrides that of the mesh', async () => {
  const scene = await open(1)
  await scene.call('pose', { weights: { up: 1 } })
  expect(await scene.call('override_material', { color: '#ff0000' })).toEqual({
    shown: ['ShaderMaterial', 'ff0000'],
    removed: ['StandardMaterial3D', 'ff0000'],
  })
  await scene.close()
})

it('mode OFF shows the original material, also after wrinkles', async () => {
  const scene = await open(1)
  const smooth = await scene.draw('draw', LIGHT)
  await scene.call('pose', { weights: { up: 1 } })
  await scene.call('set_mode', { mode: 1 })
  expect(await scene.call('count_shader_materials')).toBe(0)
  await scene.call('set_mode', { mode: 0 })
  await scene.call('pose', {})
  expect(isSame(await scene.draw('draw', LIGHT), smooth)).toBe(true)
  await scene.close()
})
