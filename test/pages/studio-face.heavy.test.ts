/** What the studio does with a face, on WebGPU; on WebGL `studio.test.ts` does the same. */

import { beforeAll, test } from 'vitest'
import { openStudio } from './opened-studio.ts'
import { movesFace, showsLooks } from './studio-face.ts'
import { waitUntilReady } from './studio-page.ts'

const studio = openStudio({ width: 800, height: 400 })

beforeAll(async () => {
  const { page } = studio
  await page.getByText('WebGPU', { exact: true }).click()
  await waitUntilReady(page, 'WebGPU')
})

test('shows the face in every look', () => showsLooks(studio.page, 'WebGPU'))

test('moves the face by expressions and sliders', () => movesFace(studio.page))
