import { Wrinkles as BabylonWrinkles } from 'furrow/babylon'
import { expect, it } from 'vitest'
import { face } from './refused.ts'

const MEMBERS = [
  ...['addMesh', 'areaNames', 'clock', 'dispose', 'driven', 'drivers', 'explain', 'expressions'],
  ...['faceCount'],
  ...['getActivation', 'getArea', 'getRestingActivation', 'hasArea', 'inputs', 'isDisposed', 'isDriven'],
  ...['mesh', 'mode', 'onDispose', 'setActivation', 'setActivations', 'setRestingActivation', 'update'],
]
const OF_THREE = ['cloneMaterial', 'createInfluenceMaterial', 'meshes', 'relief', 'reliefReady', 'statistics']

/** Lists the names of all members of an object, also inherited ones, except those that all objects have. */
function membersOf(object: object): string[] {
  const names = new Set<string>()
  for (let own = object; own !== Object.prototype; own = Object.getPrototypeOf(own))
    for (const key of Reflect.ownKeys(own)) names.add(String(key))
  names.delete('constructor')
  return [...names].sort()
}

it.each([
  ['three.js', face().wrinkles, [...MEMBERS, ...OF_THREE]],
  // The prototype is enough, because wrinkles of Babylon.js need a GPU.
  ['Babylon.js', BabylonWrinkles.prototype, MEMBERS],
])('wrinkles of %s have only the documented members', (_, wrinkles, members) => {
  expect(membersOf(wrinkles)).toEqual([...members].sort())
})
