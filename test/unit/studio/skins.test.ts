import { expect, it } from 'vitest'
import { skinOfDocument } from '../../../studio/src/open/skins.ts'

const targets = [{ mesh: 'Eyes', material: 'Iris' }, { mesh: 'Head', material: 'Skin' }, {}]
const avatar = { skins: targets.map((target) => ({ target })) as never, skin: 0 }

it('a project opens with the skin that its document names', () => {
  expect(skinOfDocument(avatar, { mesh: 'Head', material: 'Skin' })).toBe(1)
})

it.each([
  ['names none', {}],
  ['names one that is gone', { mesh: 'Head', material: 'Old skin' }],
])('a project whose document %s opens with the skin chosen for every avatar', (_, names) => {
  expect(skinOfDocument(avatar, names)).toBe(0)
})
