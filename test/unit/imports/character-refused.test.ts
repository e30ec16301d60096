import { beforeAll, describe, it } from 'vitest'
import { CharacterSource } from '../../imports/character-source.ts'
import { planeFace } from '../../imports/plane-face.ts'
import { bench } from '../cli/workshop.ts'

const tool = bench('import')
const source = new CharacterSource({ size: 16 })

/** Writes an export with some files replaced, or removed if undefined. */
async function exported(
  name: string,
  changes: Record<string, Uint8Array | string | undefined>,
): Promise<string> {
  for (const [path, bytes] of Object.entries({ ...(await source.files()), ...changes })) {
    if (bytes !== undefined) tool.shop.write(`${name}/${path}`, bytes)
  }
  return tool.file(name)
}

/** Returns the JSON file with the wrinkles changed. */
function jsonWith(change: (wrinkle: Record<string, unknown>) => void): string {
  const json = structuredClone(source.json()) as {
    Kevin: {
      Object: {
        Kevin: {
          Meshes: { CC_Base_Body: { Materials: { Std_Skin_Head: { Wrinkle: Record<string, unknown> } } } }
        }
      }
    }
  }
  change(json.Kevin.Object.Kevin.Meshes.CC_Base_Body.Materials.Std_Skin_Head.Wrinkle)
  return JSON.stringify(json)
}

beforeAll(async () => {
  tool.shop.write('face.glb', await planeFace(['Brow_Drop_L']))
})

describe('furrow import refuses an export of Character Creator', () => {
  const refuses = async (message: string | RegExp, folder: Promise<string>, ...more: string[]) =>
    tool.fails(message, await folder, '--face', tool.file('face.glb'), '-o', tool.file('no.glb'), ...more)

  it('without a mask, and names the remedy', async () => {
    const folder = exported('mask', { 'RL_WrinkleMask_Set2.png': undefined })
    await refuses(/the mask RL_WrinkleMask_Set2 is missing.*copy the masks from the folder textures/, folder)
  })

  it.each([
    [
      'short',
      (wrinkle) => (wrinkle.WrinkleRuleWeights = [1]),
      'WrinkleRuleWeights has the wrong number of items',
    ],
    ['text', (wrinkle) => (wrinkle.WrinkleOverallWeight = 'x'), 'WrinkleOverallWeight must be a number'],
    ['bare', (wrinkle) => (wrinkle.Textures = {}), 'no wrinkle normal map'],
    ['outside', (wrinkle) => (wrinkle.Textures = { Normal_1: '../../face.glb' }), 'outside'],
    ['missing', (wrinkle) => (wrinkle.Textures = { Normal_1: 'none.png' }), 'none.png'],
  ] as [string, (wrinkle: Record<string, unknown>) => void, string][])(
    'with %s data',
    async (name, change, message) => {
      await refuses(message, exported(name, { 'Kevin.json': jsonWith(change) }))
    },
  )

  it('if two files have wrinkles and none is named', async () => {
    await refuses('several JSON files with wrinkles', exported('two', { 'Other.json': jsonWith(() => {}) }))
  })

  it('with an unknown region', async () => {
    await refuses('It must be REGION=EXPONENT', exported('region', {}), '--power', 'ear=1')
  })
})
