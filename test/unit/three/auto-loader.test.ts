import { wrinklesOf, wrinklesReady } from 'furrow/three'
import { afterEach, expect, it, vi } from 'vitest'
import { loadAuto, plainModel } from './auto-character.ts'

afterEach(() => {
  vi.restoreAllMocks()
})

// biome-ignore lint/suspicious/noExplicitAny: JSON of a test file
type Json = any

const named = (name: string) => (json: Json) => {
  json.meshes[0].name = name
  json.materials[0].name = ''
}

it.each<[string, (json: Json) => unknown, RegExp]>([
  [
    'a hand of unknown kind',
    named('Thing'),
    /^WrinkleLoaderPlugin: no wrinkles can be made: .*\(mesh "Thing" may be skin, cloth or hard\); set the option kinds to \{ "Thing": 'skin' \} or \{ "Thing": 'cloth' \} \(the file is shown without wrinkles\)$/,
  ],
  ['a glove', named('Glove'), /cloth folds at elbows, knees and waists only, so it gets no folds: "Glove"/],
  [
    'meshes without skeleton and blendshapes',
    (json) => {
      for (const node of json.nodes) delete node.skin
    },
    /no mesh has blendshapes, and joints of a humanoid move no skin or cloth .*export the face with its blendshapes or the body/,
  ],
])('stays plain if the file has only %s, with one warning', async (_, edit, message) => {
  const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
  const gltf = await loadAuto(plainModel('hand', edit), {})
  expect(await wrinklesReady(gltf)).toEqual([])
  expect(wrinklesOf(gltf)).toEqual([])
  expect(warn.mock.calls).toEqual([[expect.stringMatching(message)]])
})
