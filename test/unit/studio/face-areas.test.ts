import { describe, expect, it, vi } from 'vitest'
import type { Messages } from '../../../studio/src/messages.ts'
import type { AreaEditor } from '../../../studio/src/session/area-editor.ts'
import { FaceAreas } from '../../../studio/src/session/face-areas.ts'
import type { ShownFace } from '../../../studio/src/viewer/shown-face.ts'

async function added(count: number) {
  const error = vi.fn()
  const attempt = async (task: () => unknown) =>
    Promise.resolve(task()).catch((fault) => error(fault.message))
  const messages = { attempt, note: () => {} } as unknown as Messages
  const editor = { hasDocument: true, convention: 'paper', add: () => {} } as unknown as AreaEditor
  const files = Array.from({ length: count }, (_, i) => new File(['text'], `${i}.png`))
  await new FaceAreas({} as ShownFace, editor, messages).add(files)
  return error.mock.calls.flat()
}

describe('an image that cannot be an area', () => {
  it.each([
    [1, /^0\.png: not a readable image/],
    [256, /^256 of 256 images were not added; the first: 0\.png: not a readable image/],
    [60_000, /^Studio: too many images to add as areas, got 60000, allowed: 256/],
  ])('are reported in one message for %i of them', async (count, message) => {
    expect(await added(count)).toEqual([expect.stringMatching(message)])
  })
})
