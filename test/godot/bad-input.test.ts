import { expect, it } from 'vitest'
import { bytesOf, FACE } from './files.ts'
import { type GodotScene, godot, type Picture } from './harness.ts'

const harness = godot()

// biome-ignore lint/suspicious/noExplicitAny: tests break the JSON in ways that no type allows
type Edit = (wrinkles: any, json: any) => void

/** Returns an edit that replaces the image of the layer's normals. */
const withImage =
  (bytes: readonly number[], mimeType = 'image/png'): Edit =>
  ({ layers }, json) => {
    const { source } = json.textures[layers[0].normalTexture.index]
    const uri = `data:${mimeType};base64,${btoa(String.fromCharCode(...bytes))}`
    json.images[source] = { uri, mimeType }
  }

const PNG = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]
const HEADER = [0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52]

const FAULTS: Record<string, [edit: Edit, message: string]> = {
  'an extension that is not an object': [
    (_, json) => {
      json.materials[0].extensions.FURROW_wrinkle_maps = 7
    },
    'the extension must be an object',
  ],
  'an undeclared extension': [(_, json) => void json.extensionsUsed.shift(), 'extensionsUsed lacks'],
  'a layer that is not an object': [
    (wrinkles) => {
      wrinkles.layers[0] = []
    },
    'layers[0] must be an object',
  ],
  'areas that are not an array': [
    (wrinkles) => {
      wrinkles.areas = 'all'
    },
    'areas must be an array',
  ],
  'a fraction as an index': [
    (wrinkles) => {
      wrinkles.areas[0].texture.index = 0.5
    },
    'areas[0].texture.index must be a whole number',
  ],
  'an image outside the file': [
    ({ layers }, json) => {
      json.textures[layers[0].normalTexture.index].source = 99
    },
    'texture without an image',
  ],
  'an empty image': [withImage([]), 'not a readable image'],
  'a truncated PNG': [
    withImage([...PNG, ...HEADER, 0, 0, 0, 16, 0, 0, 0, 16, 8, 2]),
    'Godot cannot read the image',
  ],
  'a huge PNG': [withImage([...PNG, ...HEADER, 0, 1, 0, 0, 0, 1, 0, 0, 8, 2, 0, 0, 0]), 'image too large'],
  'an image of an unknown type': [
    withImage(
      Array.from({ length: 64 }, (_, i) => i),
      'image/avif',
    ),
    'Godot cannot read the image',
  ],
  'a slice of an image that is not KTX 2': [
    ({ layers }) => {
      layers[0].normalTexture.slice = 0
    },
    'no such slice',
  ],
}

it.each(Object.entries(FAULTS))('%s costs the wrinkles and one error', async (_name, [edit, message]) => {
  const shown = async (change: Edit): Promise<[GodotScene, Picture]> => {
    const file = bytesOf({
      ...FACE,
      edit: (json) => change(json.materials[0].extensions.FURROW_wrinkle_maps, json),
    })
    const scene = (await harness.open(file)) as GodotScene
    return [scene, await scene.draw('draw', { from: [1, 0, 1] })]
  }
  const [plain, expected] = await shown(
    (_, json) => void delete json.materials[0].extensions.FURROW_wrinkle_maps,
  )
  harness.messages.splice(0)
  const [scene, picture] = await shown(edit)
  expect(scene.faces).toBe(0)
  expect(picture).toEqual(expected)
  const own = harness.messages.filter((text) => text.includes('FURROW_wrinkle_maps'))
  expect(own).toHaveLength(1)
  expect(own[0]).toContain(message)
  await scene.close()
  await plain.close()
})

it('malformed drivers cost one warning, and other drivers work', async () => {
  const drivers = [7, { type: 'morph', area: 'b', targets: [] }, { type: 'weather' }, ...FACE.drivers!]
  const scene = (await harness.open(bytesOf({ ...FACE, drivers: drivers as object[] }))) as GodotScene
  expect(await scene.call('pose', { weights: { up: 0.5 } })).toEqual([{ a: 0.5 }])
  expect(harness.messages.filter((text) => text.includes('2 drivers are malformed'))).toHaveLength(1)
  expect(
    harness.messages.filter((text) => text.includes('drivers of unknown types, got "weather"')),
  ).toHaveLength(1)
  await scene.close()
})

it('drivers with missing inputs cost one warning, and other drivers work', async () => {
  const drivers = [
    {
      type: 'bone',
      area: 'a',
      joints: ['head', 'jaw'],
      measure: 'distance',
      curve: [
        [0, 1],
        [1, 1],
      ],
    },
    { type: 'morph', area: 'a', targets: [{ name: 'sneer' }] },
    ...FACE.drivers!,
  ]
  const scene = (await harness.open(bytesOf({ ...FACE, drivers }))) as GodotScene
  expect(await scene.call('pose', { weights: { up: 0.5 } })).toEqual([{ a: 0.5 }])
  const own = harness.messages.filter((text) => text.includes('missing inputs'))
  expect(own).toHaveLength(1)
  expect(own[0]).toContain('target \\"sneer\\"')
  await scene.close()
})

it('NaN as an input counts as 0', async () => {
  const drivers = [
    {
      type: 'input',
      name: 'stress',
      area: 'a',
      curve: [
        [-1, 0],
        [1, 1],
      ],
    },
  ]
  const scene = (await harness.open(bytesOf({ ...FACE, drivers }))) as GodotScene
  expect(await scene.call('pose_with_nan', { input: 'stress' })).toBe(0.5)
  await scene.close()
})
