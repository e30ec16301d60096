import type { RgbaImage } from 'furrow'
import { beforeEach, describe, expect, it, test, vi } from 'vitest'
import type { Messages } from '../../../studio/src/messages.ts'
import type { FaceAreas } from '../../../studio/src/session/face-areas.ts'
import { ImageImport } from '../../../studio/src/session/image-import.ts'
import { guessKind } from '../../../studio/src/session/image-kind.ts'
import type { LayerEditor } from '../../../studio/src/session/layer-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { sampleDocument } from './sample-document.ts'

function imageOf(...texel: number[]): RgbaImage {
  return { width: 2, height: 2, data: Uint8Array.from([0, 1, 2, 3].flatMap(() => [...texel, 255])) }
}

test.each([
  ['brow.png', imageOf(90, 90, 90), 'mask'],
  ['brow.jpg', imageOf(90, 92, 91), 'mask'],
  ['brow.png', imageOf(128, 128, 255), 'normal'],
  ['brow.png', imageOf(200, 150, 130), 'baseColor'],
  ['brow_normal.png', imageOf(90, 90, 90), 'normal'],
  ['brow-height.png', imageOf(128, 128, 255), 'height'],
  ['browHeight2.png', imageOf(90, 90, 90), 'height'],
  ['brow_albedo.webp', imageOf(128, 128, 255), 'baseColor'],
  ['brow_Color.png', imageOf(90, 90, 90), 'baseColor'],
  ['normal_mask.png', imageOf(128, 128, 255), 'mask'],
  ['abnormal.png', imageOf(90, 90, 90), 'mask'],
])('%s is probably of the kind %3$s', (name, image, kind) => {
  expect(guessKind(name, image)).toBe(kind)
})

describe('dropped images', () => {
  let session: Session
  let selected: string | undefined
  const added = vi.fn()
  const errors: string[] = []
  let images: ImageImport

  beforeEach(() => {
    session = new Session()
    session.open(sampleDocument())
    selected = undefined
    added.mockClear()
    errors.length = 0
    images = new ImageImport({
      session,
      faceAreas: {
        add: async (files: File[]) => added(files.map(({ name }) => name)),
      } as unknown as FaceAreas,
      layers: {
        importMap: async (layer: string, map: string, file: File) => added(layer, map, file.name),
      } as unknown as LayerEditor,
      messages: {
        error: (error: Error) => errors.push(error.message),
        attempt: async (task: () => Promise<void>) => task().catch((error) => errors.push(error.message)),
      } as unknown as Messages,
      layer: () => selected,
      editWrinkles: async () => {},
      decode: async (_, name) => {
        if (name === 'bad.png') throw new Error('bad.png: not a readable image')
        return imageOf(90, 90, 90)
      },
    })
  })

  const ask = (...names: string[]) => images.ask(names.map((name) => new File([name], name)))

  it('are asked about before the document changes', async () => {
    await ask('brow.png', 'brow_normal.png')
    expect(images.isAsking.value).toBe(true)
    expect(images.asked.value.map(({ kind }) => kind)).toEqual(['mask', 'normal'])
    expect(added).not.toHaveBeenCalled()
    images.isAsking.value = false
    expect(images.asked.value).toEqual([])
    await images.add()
    expect(added).not.toHaveBeenCalled()
  })

  it('become regions, or maps of the layer of the selection', async () => {
    selected = 'down'
    await ask('brow.png', 'brow_normal.png')
    await images.add()
    expect(added.mock.calls).toEqual([[['brow.png']], ['down', 'normal', 'brow_normal.png']])
    expect(images.isAsking.value).toBe(false)
  })

  it('become what the user chooses, in the first layer if nothing is selected', async () => {
    await ask('brow.png')
    images.setKind(images.asked.value[0], 'height')
    await images.add()
    expect(added.mock.calls).toEqual([['up', 'height', 'brow.png']])
  })

  it('need wrinkles to become maps', async () => {
    session.open(null)
    await ask('brow_normal.png')
    await images.add()
    expect(errors).toEqual([expect.stringContaining('no wrinkles to which brow_normal.png could be added')])
  })

  it('that cannot be decoded are reported, and the others asked about', async () => {
    await ask('bad.png', 'brow.png')
    expect(errors).toEqual(['bad.png: not a readable image'])
    expect(images.asked.value.map(({ file }) => file.name)).toEqual(['brow.png'])
  })
})
