import { BoxGeometry, Group, Mesh, MeshStandardMaterial } from 'three'
import { expect, it } from 'vitest'
import { Looks } from '../../../../studio/src/viewer/looks/looks.ts'

it.each<Parameters<Looks['choose']>[0]>([
  { name: 'shaded' },
  { name: 'clay' },
  { name: 'normals' },
  { name: 'influence' },
  { name: 'strain' },
  { name: 'onset' },
  { name: 'wireframe' },
  { name: 'marked', area: ['brow'] },
])('after the look $name every mesh has its own material and is visible', (look) => {
  const [skin, eyes] = ['skin', 'eyes'].map(
    (own) => new Mesh(new BoxGeometry(), new MeshStandardMaterial({ name: own })),
  )
  const lashes = new Mesh(new BoxGeometry(), new MeshStandardMaterial({ transparent: true }))
  const root = new Group().add(skin, eyes, lashes)
  const own = [skin, eyes, lashes].map(({ material }) => material)
  const noMirror = () => {
    throw new Error('no wrinkles')
  }
  const onsets = new Map([['up', { width: 1, height: 1, data: Uint8Array.of(128) }]])
  const face = { root, skin, parts: [], wrinkles: null }
  const looks = new Looks(face, null, skin.material.clone(), noMirror, onsets)
  looks.choose(look)
  for (const side of ['without', 'with'] as const) looks.apply(side)
  if (look.name !== 'shaded') expect(skin.visible && skin.material === own[0]).toBe(false)
  looks.restore()
  const others = root.children.filter((child) => child !== skin && child !== eyes && child !== lashes)
  expect([skin, eyes, lashes].every(({ material }, i) => material === own[i])).toBe(true)
  expect([skin, eyes, lashes].every(({ visible }) => visible)).toBe(true)
  expect(others.some(({ visible }) => visible)).toBe(false)
  looks.dispose()
})
